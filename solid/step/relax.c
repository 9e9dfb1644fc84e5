/* Adaptive dynamic relaxation to static equilibrium.  (Underwood 1983; Kilic and Madenci 2010) */
#include "base/clock.h"
#include "base/par.h"
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"
#include "solid/force/force.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/given.h"
#include "solid/imposed/reactions.h"
#include "solid/step/rates.h"
#include "solid/step/relax.h"

#include <math.h>

/* Central differences with the damping that is critical for the frequency of the present deformation, the Rayleigh
 * quotient of the displacement since the start.  (Underwood 1983; Kilic and Madenci 2010)
 *     v = ((2 - c dt) v + 2 dt a)/(2 + c dt)      d += dt v      c = 2 sqrt(-u.M a_bonds / u.M u) */

static const double OF_STABLE_STEP = 0.9;

struct sums {
    double residual2, load2, reaction2; /* N2 */
    double stiffness, mass;             /* u.K u, u.M u */
};

/* Computes a at the present d and v = 0, and the sums for the step and the stop criterion. Collective. */
static struct sums sweep(struct solid *s, double *const start[3]) {
    solid_ghosts_update(s);
    solid_force_bonds(s, 0, 0);
    if (s->in.contact && s->contact) solid_contact_force(s);
    double sum[5] = {0};
    for (int h = 0; h < s->n; h++) {
        const double density = solid_density(s, h), mass = density * s->volume[h];
        for (int c = 0; c < s->dim; c++) {
            const double force = s->volume[h] * (s->load[c][h] + density * s->in.body_force[c]);
            if (s->flag[h] & SOLID_HELD_X << c) continue;
            const double u = s->d[c][h] - start[c][h];
            sum[1] += force * force;
            sum[3] -= mass * u * s->a[c][h];
            sum[4] += mass * u * u;
        }
    }
    solid_force_loads(s, s->a, 0);
    solid_reactions_find(s);
    sum[2] = solid_constraint_apply(s);
    for (int h = 0; h < s->n; h++) {
        const double mass = solid_density(s, h) * s->volume[h];
        for (int c = 0; c < s->dim; c++) sum[0] += mass * s->a[c][h] * mass * s->a[c][h];
    }
    par_sum_array(sum, 5);
    return (struct sums){sum[0], sum[1], sum[2], sum[3], sum[4]};
}

static int relax(struct solid *s, double tolerance, int max_steps, double *const start[3]) {
    const double dt = OF_STABLE_STEP * solid_rates_stable_step(s, SOLID_VERLET);
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) {
            s->v[c][h] = 0;
            start[c][h] = s->d[c][h];
        }
    for (int i = 0; i <= max_steps; i++) {
        const struct sums sum = sweep(s, start);
        if (sum.residual2 <= tolerance * tolerance * fmax(sum.load2, sum.reaction2)) return i;
        if (!isfinite(sum.residual2)) return -1;
        const double c_dt = sum.mass > 0 ? fmin(2 * dt * sqrt(fmax(sum.stiffness / sum.mass, 0)), 1.9) : 0;
        const double keep = (2 - c_dt) / (2 + c_dt), gain = (i ? 2 : 1) * dt / (i ? 2 + c_dt : 2);
        for (int c = 0; c < s->dim; c++)
            for (int h = 0; h < s->n; h++) {
                s->v[c][h] = keep * s->v[c][h] + gain * s->a[c][h];
                s->d[c][h] += dt * s->v[c][h];
            }
    }
    return -1;
}

int solid_relax(struct solid *s, double tolerance, int max_steps) {
    clock_begin(CLOCK_SOLID);
    const double put_in = s->e_constraint;
    solid_constraint_displacement(s, s->t);
    solid_given_set(s, s->t, 0);
    const int steps = relax(s, tolerance, max_steps, s->v_old);
    solid_reactions_begin(s);
    solid_reactions_add(s, 1, 0); /* of the last sweep; the length of the step does not matter */
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) s->v[c][h] = 0;
    solid_constraint_velocity(s, s->t, 0);
    s->e_constraint = put_in;
    solid_ghosts_update(s);
    s->a_holds = 0;
    clock_end(CLOCK_SOLID);
    return steps;
}
