/* Chooses the number of the solid's substeps in a step. */
#include "coupling/control/substeps.h"
#include "base/die.h"
#include "base/files/log.h"
#include "base/par.h"
#include "coupling/control/strained.h"
#include "coupling/control/time_step.h"
#include "coupling/run.h"
#include "fluid/scheme.h"
#include "solid/contact/contact.h"
#include "solid/contact/implicit.h"
#include "solid/contact/passing.h"
#include "solid/imposed/walls.h"

#include <math.h>

enum { CHECK_CONTACT_EVERY = 4, FEWER_SUBSTEPS_EVERY = 100 };

/* A step grows by a fifth at most, and speeds hardly within one. */
static const double FASTER = 1.3;

int substeps_may_skip(const struct run *r, double fastest) {
    return r->control.approach + 2 * FASTER * r->dt * fastest < r->control.gap;
}

int substeps_are_automatic(const struct run *r) { return r->substeps > 0 && run_stage(r)->substeps == 0; }

static double least_for(const struct run *r, double stable) {
    return ceil(r->dt / (run_stage(r)->safety * stable) * (1 - 1e-12));
}

double substeps_fastest(const struct solid *s) {
    const int plane = s->dim == 2; /* in a plate the third component is 0: the second array stands for it, times 0 */
    const double *restrict u = s->v[0], *restrict v = s->v[1], *restrict w = s->v[s->dim - 1];
    const double third = !plane;
    double most = 0;
    for (int h = 0; h < s->n; h++) {
        const double v2 = u[h] * u[h] + v[h] * v[h] + third * (w[h] * w[h]);
        most = v2 > most ? v2 : most;
    }
    return sqrt(most);
}

static int may_meet(const struct run *r) { return r->needs.contact && r->solid->in.bodies > 1; }

int substeps_need_speed(const struct run *r) {
    return substeps_are_automatic(r) && (may_meet(r) || solid_contact_rate_margin(r->solid) > 0);
}

/* The markers' drag acts at the end of a substep, so half a substep late. With one substep in each stage of the fluid
 * slow waves of thick bodies grow: with AB2 at any density, with RK3 below about this one over the fluid's
 * (cases/stability/added_mass). */
static const double LIGHT = 0.3;
enum { OF_AB2 = 2, OF_LIGHT = 6 };

/* For a load with a step of its own at least one in each stage of the fluid; without bonds the solid itself has no
 * limit. */
int substeps_fewest(const struct run *r) {
    if (!r->load_kind || !r->load_kind->step) return 1;
    const struct solid_input *in = &r->solid->in;
    const int stages = fluid_scheme_stages(r->fluid);
    double lightest = INFINITY;
    for (int m = 0; m < in->materials; m++) lightest = fmin(lightest, in->material[m].density);
    if (stages == 1) return OF_AB2;
    return lightest < LIGHT * fluid_input_of(r->fluid)->density ? OF_LIGHT : stages;
}

/* The longest substep, s, in which no pair of two bodies that are still apart is overlooked: any one, if the bodies
 * cannot have come near each other within the step. Collective. */
static double unseen_step(struct run *r, double fastest) {
    if (!may_meet(r) || !(fastest > 0) || solid_contact_rate_margin(r->solid) > 0) return INFINITY;
    r->control.gap = solid_contact_passing_gap(r->solid);
    return substeps_may_skip(r, fastest) ? INFINITY
                                         : 0.5 * solid_contact_passing_unseen() * r->solid->in.spacing / fastest;
}

int substeps_suffice(const void *run, double contact) {
    const struct run *r = run;
    const enum solid_integrator integrator = r->solid->stage.integrator;
    return least_for(r, strained_step(r, solid_stable_of(&r->solid_rates, integrator, contact, NULL))) <= r->substeps;
}

/* Whether the substeps are chosen in every step, not in every CHECK_CONTACT_EVERY-th. */
static int chooses_always(const struct run *r) { return time_step_is_automatic(r) || solid_walls_are_open(r->solid); }

/* Sets the stable step. Implicit contact has no limit of stability, but particles must not pass one another within a
 * substep. */
static double find_stable(struct run *r, double fastest, solid_contact_enough *enough) {
    const struct solid *s = r->solid;
    const int is_implicit = solid_contact_implicit_is(s);
    const double contact = is_implicit ? 0 : solid_contact_rate_bound(r->solid, enough, r),
                 passing = is_implicit ? solid_contact_implicit_step(s, fastest) : INFINITY;
    r->control.approach = 0;
    const double unseen = unseen_step(r, fastest);
    const double ahead = FASTER * r->dt * (chooses_always(r) ? 1 : CHECK_CONTACT_EVERY),
                 walls = solid_walls_rate_deep(r->solid, ahead);
    r->solid_stable = solid_stable_of(&r->solid_rates, s->stage.integrator, contact + walls, &r->solid_bound);
    const double strained = strained_step(r, r->solid_stable);
    if (strained < r->solid_stable) {
        r->solid_stable = strained;
        r->solid_bound = SOLID_BOUND_STRETCH;
    }
    if (fmin(passing, unseen) < r->solid_stable) {
        r->solid_stable = fmin(passing, unseen);
        r->solid_bound = SOLID_BOUND_CONTACT;
    }
    return contact;
}

int substeps_for(struct run *r, double fastest, solid_contact_enough *enough) {
    const double contact = find_stable(r, fastest, enough);
    const double least = least_for(r, r->solid_stable);
    if (least > SUBSTEPS_MAX && contact == 0) /* with contact, such a number may be needed for a while */
        die_all(EXIT_CODE_SCENE,
                "stage %s: a step of %g s would take %.3g solid substeps (stable up to %.3g s), at most %d",
                run_stage(r)->name, r->dt, least, r->solid_stable, SUBSTEPS_MAX);
    return (int)fmin(fmax(least, substeps_fewest(r)), SUBSTEPS_MAX);
}

/* Speed of the fastest particle of all ranks, m/s; 0 where no substep depends on it. */
static double fastest_now(const struct run *r) {
    const int counts = may_meet(r) || solid_contact_implicit_is(r->solid);
    return counts && substeps_need_speed(r) ? par_max(substeps_fastest(r->solid)) : 0;
}

int substeps_wanted(struct run *r) { return substeps_for(r, fastest_now(r), NULL); }

void substeps_set(struct run *r, int substeps) {
    if (r->substeps > 0 && !r->control.replays)
        log_line("step %ld: %d solid substeps, bound by %s (stable up to %.4g s)", r->step, substeps,
                 solid_stable_bound_name[r->solid_bound], r->solid_stable);
    r->substeps = substeps;
}

/* The contact's rate is computed every few steps, or at every step if chooses_always. The number of substeps
 * rises at once, but falls only every FEWER_SUBSTEPS_EVERY steps: it is part of a checkpoint, so the steps at which it
 * may fall are fixed. */
void substeps_choose(struct run *r) {
    const int least = r->control.substeps_min;
    strained_update(r);
    if (chooses_always(r) || r->substeps == 0 || r->stage_step % CHECK_CONTACT_EVERY == 0) {
        const int may_fall = r->stage_step % FEWER_SUBSTEPS_EVERY == 0;
        const int least_now = substeps_for(r, fastest_now(r), may_fall ? NULL : substeps_suffice);
        if (least_now > r->substeps || (least_now < r->substeps && may_fall)) substeps_set(r, least_now);
    }
    if (r->substeps < least) r->substeps = least;
}
