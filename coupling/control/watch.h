/* Watches the balances of a solid that moves: of its energy, and of the forces between its particles.
 *
 * All energies with the integrator's part, less the works, are constant (docs/design/solid-motion.md). What has been
 * exchanged is the largest range of one of them since the stage began, or since the run was resumed. Forces between
 * particles add up to 0. */
#pragma once
#include "coupling/control/momentum.h"
#include "coupling/control/sample_watch.h"
#include "coupling/control/probe_energy.h"
#include "coupling/control/probe_watch.h"

struct run;
struct step_status;

/* Energies of the whole solid, J. Where a body is strained and the sum is off by more than it may be, what waves that
 * have become shorter hold is added, if the sum closes better with it (solid/step/shadow.h). */
enum { WATCH_KINETIC, WATCH_STRAIN, WATCH_CONTACT, WATCH_DISSIPATED, WATCH_WORK, WATCH_PARTS };

struct watch {
    int begun;                                         /* 1: the members below are set */
    double first, low[WATCH_PARTS], high[WATCH_PARTS]; /* the sum at the start; ranges of the parts, J */
    double off, exchanged, integrator, contact; /* at the last check: sum less the first one; largest range; what the
                                                 * integrator has taken since the start; contact's potential, J */
    double least;            /* that counts as exchanged: by a sudden load with waves of a substep, at most so far, J */
    double integrator_first; /* J */
    double dissipated, dissipated_first; /* by damping and fracture since the start; and by then, J */
    double substep;                      /* of velocity Verlet at the start, s */
    double waves, waves_first;           /* strained_waves: since the start; and then, J. 0: not asked for */
    double walls, walls_first;           /* what walls have given beyond their potential since the start; and by
                                          * then, J */
    double highest[2], fallen[2]; /* what damping, and fracture, had taken at most; and by which they are below it, J */
    double unbalanced;            /* of the forces between particles, their sum over their size */
    int beyond;                   /* 1: a substep has been longer than the bonds' limit */
    struct momentum_watch momentum;
    struct run_inner_watch {
        int begun, changed;     /* 1: the members below are set; 1: other particles carry fluid since then */
        unsigned long carrying; /* which ones do, as in coupling/load/inner_fluid.h */
        double first[3];        /* at the start, of all ranks, N s (inner_fluid_momentum) */
        double impulse[3], largest_impulse; /* since then, this rank's share; the largest at a check so far, N s */
        double load;        /* impulse of the fluid on the whole solid since then, sum of the components' sizes, N s */
        double off, logged; /* over what was exchanged: at the last check; the last one that the log has */
    } inner;                /* of the inner fluid (coupling/load/inner_watch.c) */
    double logged_reaction; /* as below, of the forces on solid and fluid (coupling/load/reaction.c) */
    struct sample_watch sample;                   /* of every run with a fluid */
    struct probe_watch probes;                    /* of the load by probes */
    double logged_unresolved;                     /* Reynolds number of a cell (coupling/control/unresolved.c) */
    struct probe_energy made;                     /* by the load by probes */
    double logged_adjoint;                        /* as below, of the markers' work */
    double logged_walls;                          /* as below, of walls */
    double logged, logged_back[2], logged_forces; /* the last off over exchanged, and unbalanced, that the log has */
};

/* At the start of a stage, and of a resumed run: takes the present energies. Nothing where no solid moves, or where it
 * is relaxed or refined. Collective. */
void watch_begin(struct run *r);
/* After each step: notes a substep beyond the limit. Not collective. */
void watch_note(struct run *r);
/* Looks at the balances after an accepted step. Returns 1 if so much energy has come from nothing that the run is to
 * end; status then says so. Warns in the log. Collective. */
int watch_check(struct run *r, struct step_status *status);
/* At the end of a stage: says in the log how well its balance has closed. Not collective. */
void watch_report(const struct run *r);
/* What has probably broken the balance: "contact", "the integrator", "the coupling". Not collective. */
const char *watch_cause(const struct run *r);
