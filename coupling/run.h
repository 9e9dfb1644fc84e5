/* A run: the parts that a scene needs, its time and step, and the list of the parts of a step. */
#pragma once
#include "base/clock.h"
#include "coupling/control/step_control.h"
#include "coupling/control/settle.h"
#include "coupling/control/steady.h"
#include "coupling/control/watch.h"
#include "coupling/interface/markers.h"
#include "coupling/interface/wall_probes.h"
#include "coupling/load/load.h"
#include "coupling/medium/medium.h"
#include "coupling/setup/setup.h"
#include "coupling/setup/beginning.h"
#include "fluid/fluid.h"
#include "ibm/ibm.h"
#include "scene/medium.h"
#include "scene/scene.h"
#include "solid/state.h"
#include "solid/step/rates.h"
#include "solid/step/stable.h"
#include "solid/surface/surface.h"

struct run;
struct cracks; /* cracks/cracks.h */
struct crack_outlets;
struct solid_strained; /* solid/step/strained.h */
struct reaction;
typedef void run_part(struct run *r);
enum { RUN_PARTS_MAX = 20 }; /* of all stages together (coupling/step.c) */

/* What the rates of a refined plate were found from. */
struct run_refined {
    long level;   /* finest level then, -1: not yet in this stage */
    double rate2; /* solid_refine_rate_bound then, 1/s2 */
};

/* What is known of stretched bonds (coupling/control/strained.h). */
struct run_strained {
    double factor;  /* of the largest rate of stiffness, to that of the solid at rest; 1: unstrained */
    double stretch; /* the largest one when it was found; 0: small */
    double recent;  /* the largest one since then, in the last hundred steps */
};

struct run {
    /* Parameters: read-only once the run is made. The parts have parameters, state and work of their own. */
    const struct scene *scene; /* borrowed */
    struct setup_needs needs;
    struct fluid *fluid;           /* NULL: no fluid */
    struct solid *solid;           /* NULL: no solid */
    struct solid_surface *surface; /* NULL unless immersed */
    struct ibm *ibm;               /* NULL unless immersed */
    struct medium *medium;         /* NULL unless immersed */
    struct scene_medium measured;  /* the medium's direction, and why a permeability would mean nothing */
    double cut_share[3];   /* of a sample that is cut at periodic sides (coupling/setup/image_cut.h); NaN: not */
    struct cracks *cracks; /* NULL: cracks carry no fluid */
    struct crack_outlets
        *crack_outlets; /* NULL unless cracks are open to the fluid (coupling/interface/crack_outlets.h) */
    const struct load_kind *load_kind; /* NULL unless immersed */
    struct beginning beginning;        /* how the run began, which a checkpoint holds */
    struct reaction *reaction;         /* NULL unless the load is the forcing's reaction (coupling/load/reaction.h) */
    int follows_inner_mean;            /* 1: the reaction needs inner_mean (coupling/load/inner_fluid.c) */

    /* State: exactly what the table in coupling/run_state.c lists, with control.approach; tests/coupling/test_state.c
     * checks that it has every member from t to solid_bound. */
    double t;          /* s */
    double dt;         /* s */
    double dt_last;    /* length of the last step in which the solid moved in a fluid, over which v - v_last was
                        * gathered, s; 0: no such step yet */
    long step;         /* over all stages */
    long stage_step;   /* steps done of the present stage */
    int stage;         /* index into scene->stage */
    int substeps;      /* of the solid in a step */
    long moved;        /* step after which the solid last moved; 0: it has not moved */
    double load[3];    /* force of the fluid on the solid at the last probe, whole solid, N */
    double *v_last[3]; /* [n] the solid's velocity one fluid step ago, m/s; NULL unless elastic and immersed, or if the
                        * load is the reaction */
    struct run_inner {
        double *velocity[3]; /* [n] of the fluid at each particle when the stage began in the last step, m/s; NULL
                              * unless the load is the reaction (coupling/load/reaction.c) */
        double *excess[3];   /* [n] impulse per mass that the stage then gave too much, m/s */
        double time;         /* s, of that beginning; -1: none */
    } inner[3];              /* for each stage of the fluid's step */
    struct run_inner_mean {
        double velocity[3];        /* of the domain's fluid when the stage began in the last step, m/s */
        double excess[3];          /* as of struct run_inner */
    } inner_mean[3];               /* for each stage of the fluid's step */
    double (*marker_force)[3];     /* [n] of the next markers, m/s2: waits until they are set
                                      (coupling/interface/marker_force.h); NULL: none */
    struct steady steady;          /* of the present stage (coupling/control/steady.h) */
    double began[SCENE_TIMED_MAX]; /* s, the times at which the first stages began; 0: not yet */
    struct settle settle;          /* of the present stage (coupling/control/settle.h) */
    struct solid_rates solid_rates;
    struct run_refined refined;
    struct run_strained strained;
    double solid_stable;          /* s, stable step of the present integrator with the present contact */
    enum solid_bound solid_bound; /* what limits it */

    /* Parts of a step, put together when a stage begins. */
    int parts;
    run_part *part[RUN_PARTS_MAX];
    const char *part_name[RUN_PARTS_MAX];
    enum clock_part part_clock[RUN_PARTS_MAX];
    struct step_control control; /* how its steps are chosen */
    struct watch watch;          /* of the solid's balances; no step depends on it */

    /* Work: found again from the state. */
    struct solid_strained *stretched;     /* NULL: bonds are never stretched far */
    struct solid_rates_found rates_found; /* by the last iteration: stages of the same damping share it */
    struct markers markers;
    struct wall_probes probes;
    double *position[3]; /* [n] of the deposit, m; NULL: the solid is rigid in every stage */
    long deposited;      /* step of the last deposit, -1: none */

    /* Counters and clocks: no step depends on them. */
    long fluid_cell_steps, solid_sweeps; /* for ns per cell-step and per bond */
    long resumed;                        /* step of the checkpoint that the run started from, 0: none */
    double wall_start;
    double setup_seconds; /* from wall_start to the first step; 0: no step yet */
    double wall_earlier;  /* s of the steps before the checkpoint that the run goes on from, in its own folder; NAN: not
                           * known */
};

/* The present stage. */
static inline const struct scene_stage *run_stage(const struct run *r) { return &r->scene->stage[r->stage]; }

struct run *run_new(const struct scene *scene); /* Dies (exit 2) on mistakes that are found only here. Collective. */
void run_free(struct run *r);

/* Directed bonds of all ranks, intact and broken; 0 in a run without bonds. Collective. */
long run_directed_bonds(const struct run *r);
