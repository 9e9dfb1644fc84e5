/* Finds flows that are too fast for their cells, from the velocities of the scene and while the run goes on. */
#include "coupling/control/unresolved.h"
#include "base/files/log.h"
#include "base/par.h"
#include "base/step_status.h"
#include "coupling/run.h"

#include <math.h>
#include <stdio.h>

/* Reynolds numbers of a cell: from WARN on the log warns; RUIN ends the run, as scene/check/fluid.c refuses velocities
 * of the scene from there on. A warning is said again when the flow is AGAIN times as fast. */
static const double WARN = 1000, RUIN = 1e6, AGAIN = 4;

double unresolved_velocity(const struct scene_fluid *f) {
    double u = f->driving == FLUID_DRIVING_BULK ? fabs(f->driving_value) : 0;
    if (f->has_taylor_green) u = fabs(f->taylor_green_velocity);
    for (int c = 0; c < 3; c++) {
        u = fmax(u, fabs(f->initial_velocity[c]));
        for (int e = 0; e < 2; e++)
            u = fmax(u, fmax(fabs(f->side[c][e].bulk_velocity), fabs(f->side[c][e].velocity[c])));
    }
    return u;
}

static double finest(const struct run *r) {
    const double *d = fluid_grid_of(r->fluid)->d;
    return fmin(d[0], fmin(d[1], d[2]));
}

static double number_of(const struct run *r, double u) { return u * finest(r) / r->scene->fluid->viscosity; }

int unresolved_of(const struct run *r, double u, char sentence[UNRESOLVED_SENTENCE]) {
    if (!r->fluid || !(number_of(r, u) > WARN)) return 0;
    snprintf(
        sentence, UNRESOLVED_SENTENCE,
        "the Reynolds number of a cell, U d/nu, is %.3g: the run is hopeless, because viscosity acts only on lengths "
        "far below a cell and there is no model of turbulence. Make it less than %g by smaller cells, a larger "
        "viscosity or a lower velocity",
        number_of(r, u), WARN);
    return 1;
}

/* Whether pressures or forces on the fluid make a velocity that the scene does not know. */
static int is_driven(const struct scene_fluid *f) {
    int driven = f->driving == FLUID_DRIVING_GRADIENT;
    for (int c = 0; c < 3; c++) {
        driven |= f->body_force[c] != 0;
        for (int e = 0; e < 2; e++) driven |= f->side[c][e].type == FLUID_PRESSURE;
    }
    return driven;
}

int unresolved_check(struct run *r, int stage_ends, struct step_status *status) {
    double *logged = &r->watch.logged_unresolved;
    char sentence[UNRESOLVED_SENTENCE];
    if (!r->fluid) return 0;
    /* the fastest cell is at least as fast as that: the sum of |u|/d is at most sqrt(3) |u|/finest */
    const double u = par_max(fluid_limits_convection_rate(r->fluid, NULL)) * finest(r) / sqrt(3),
                 given = unresolved_velocity(r->scene->fluid), number = number_of(r, u);
    const int is_news = u > 2 * given; /* of velocities that the scene gives it is said at the start */
    if (is_news && is_driven(r->scene->fluid) && number > RUIN) {
        *status = (struct step_status){.failed = 1, .seen_in = STEP_STATUS_UNRESOLVED, .field = "U d/nu"};
        status->value = number;
        return 1;
    }
    if (!is_news && number_of(r, given) > WARN) return 0;
    if (!(number > AGAIN * *logged || (stage_ends && number > *logged)) || !unresolved_of(r, u, sentence)) return 0;
    *logged = number;
    log_line("warning: step %ld: %s", r->step, sentence);
    return 0;
}

void unresolved_explain(const struct run *r, double number, char *text, size_t size) {
    snprintf(text, size,
             "at most %g goes, which at this velocity takes a viscosity of %.3g m2/s or more. Take smaller cells, a "
             "larger viscosity, or less that drives the flow (pressures of sides, fluid.driving, fluid.body_force)",
             RUIN, number / RUIN * r->scene->fluid->viscosity);
}
