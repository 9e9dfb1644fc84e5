#include "solid/constraint.h"
#include "solid/force.h"
#include "solid/integrate.h"

#include <string.h>

/* Bits of d and v, so that a sweep's acceleration is used again only for the state that it was made for. */
static uint64_t fingerprint(const struct solid *s) {
    uint64_t sum = 1;
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < s->n; h++) {
            uint64_t d, v;
            memcpy(&d, &s->d[c][h], sizeof d);
            memcpy(&v, &s->v[c][h], sizeof v);
            sum += (d + 3 * v) * (2 * (uint64_t)h + 1) * (uint64_t)(c + 1);
        }
    return sum ? sum : 1;
}

void solid_verlet_keep(struct solid *s) {
    for (int c = 0; c < 3; c++) memcpy(s->v_old[c], s->a[c], (size_t)s->n * sizeof(double));
    s->power_pairwise = s->power_damped;
}

/* Work of load and body force over the displacement v dt + a dt^2/2, J. */
static double work_of_load(const struct solid *s, double dt) {
    double work = 0;
    for (int h = 0; h < s->n; h++) {
        const double density = solid_density(s, h);
        for (int c = 0; c < 3; c++)
            work += s->volume[h] * (s->load[c][h] + density * s->in.body_force[c]) *
                    (dt * (s->v[c][h] + 0.5 * dt * s->a[c][h]));
    }
    return work;
}

void solid_verlet_begin(struct solid *s) {
    const int same = s->fingerprint && memcmp(&s->stage, &s->stage_of_a, sizeof s->stage) == 0 &&
                     s->fingerprint == fingerprint(s);
    if (same) { /* the load may have changed, nothing else */
        for (int c = 0; c < 3; c++) memcpy(s->a[c], s->v_old[c], (size_t)s->n * sizeof(double));
        s->power_damped = s->power_pairwise;
        solid_force_rest(s);
    } else {
        solid_ghosts_update(s);
        solid_force(s, 1);
    }
}

/* Velocity Verlet with one sweep a step; velocity-dependent forces see the velocity predicted for the end of the step:
 *     v* = v + dt a      d += dt v + dt^2/2 a      a' = a(d, v*)      v = v* + dt/2 (a' - a)
 * Work of the load over the displacement, the other energies by the trapezoidal rule. */
void solid_verlet_step(struct solid *s, double dt) {
    const double damped = s->power_damped, constraint = s->power_constraint, added = s->power_added;
    s->work_load += work_of_load(s, dt);
    for (int c = 0; c < 3; c++) {
        double *restrict d = s->d[c], *restrict v = s->v[c], *restrict a = s->a[c],
                         *restrict a_old = s->a_old[c];
        for (int h = 0; h < s->n; h++) {
            d[h] += dt * (v[h] + 0.5 * dt * a[h]);
            v[h] += dt * a[h];
            a_old[h] = a[h];
        }
    }
    solid_ghosts_update(s);
    solid_force(s, 1);
    for (int c = 0; c < 3; c++) {
        double *restrict v = s->v[c], *restrict a = s->a[c], *restrict a_old = s->a_old[c];
        for (int h = 0; h < s->n; h++) v[h] += 0.5 * dt * (a[h] - a_old[h]);
    }
    s->e_damped += 0.5 * dt * (damped + s->power_damped);
    s->work_load += 0.5 * dt * (added + s->power_added);
    s->e_constraint += 0.5 * dt * (constraint + s->power_constraint);
}

void solid_verlet_resume(struct solid *s) {
    if (s->stage.integrator == SOLID_VERLET) solid_verlet_end(s);
}

void solid_verlet_end(struct solid *s) {
    s->fingerprint = fingerprint(s);
    s->stage_of_a = s->stage;
}
