/* Damps a settling solid critically for the slowest motion that its load excites.  (Underwood 1983) */
#include "coupling/control/settle.h"
#include "base/par.h"
#include "coupling/run.h"
#include "solid/measure/energy.h"

#include <math.h>

/* Steps between two estimates of the frequency. */
enum { CHECK_EVERY = 10 };
/* The largest damping over the fastest rate of the bonds: Verlet's stable step falls by a tenth with it. */
static const double MOST = 0.1;

/* The damping of the present stage is automatic (stages[].damping_absolute: auto). */
static int is_damped(const struct run *r) { return r->solid && run_stage(r)->damping_absolute < 0; }

static double most(const struct run *r) { return MOST * sqrt(r->solid_rates.stiffness); }

void settle_begin(struct run *r) {
    if (r->stage_step == 0) r->settle = (struct settle){0};
    if (!is_damped(r)) return;
    /* RK3 is stable with any such damping where it is without it; its limit for the largest one would be too long */
    r->solid_rates.absolute = r->solid->stage.integrator == SOLID_VERLET ? most(r) : 0;
    r->solid->stage.damping_absolute = r->settle.damping;
}

/* Of component c: [0] mass, [1] mass times displacement, [2] mass times displacement squared; [3], [4] the first two of
 * the particles that are held in this direction. */
static void moments(const struct solid *s, int c, double sum[5]) {
    for (int k = 0; k < 5; k++) sum[k] = 0;
    for (int h = 0; h < s->n; h++) {
        const double mass = solid_density(s, h) * s->volume[h], d = s->d[c][h];
        const int held = (s->flag[h] & SOLID_HELD_X << c) != 0;
        sum[0] += mass;
        sum[1] += mass * d;
        sum[2] += mass * d * d;
        sum[3] += held ? mass : 0;
        sum[4] += held ? mass * d : 0;
    }
    par_sum_array(sum, 5);
}

/* The Rayleigh quotient of the displacement u, rad/s: omega^2 = u.K u/u.M u with u.K u = 2 strain, J. Each component of
 * u is taken from the mean u0 of the particles that are held in its direction, or, if there are none, of all:
 * |u - u0|^2 = |u|^2 - 2 u.u0 + u0^2.  (Underwood 1983) */
static double frequency_of(const struct run *r, double strain) {
    static const double ROUND_OFF = 1e-14;
    double square = 0, largest = 0;
    for (int c = 0; c < r->solid->dim; c++) {
        double sum[5];
        moments(r->solid, c, sum);
        const double mean = sum[3] > 0 ? sum[4] / sum[3] : sum[1] / sum[0];
        square += sum[2] + mean * (mean * sum[0] - 2 * sum[1]);
        largest += sum[2];
    }
    return square > ROUND_OFF * largest && strain > 0 ? sqrt(2 * strain / square) : 0;
}

void settle_damp(struct run *r) {
    if (r->stage_step % CHECK_EVERY == 0) {
        r->settle.frequency = frequency_of(r, solid_energy_measure(r->solid).strain);
        r->settle.damping = fmin(2 * r->settle.frequency, most(r));
    }
    if (is_damped(r)) r->solid->stage.damping_absolute = r->settle.damping;
}
