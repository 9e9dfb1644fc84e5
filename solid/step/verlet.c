/* Velocity Verlet substep of the solid with one force sweep, and the reuse of its last acceleration. */
#include "base/par.h"
#include "base/vec.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/store.h"
#include "solid/contact/implicit.h"
#include "solid/force/drag.h"
#include "solid/force/force.h"
#include "solid/force/absorbed.h"
#include "solid/imposed/added_mass.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/indenter.h"
#include "solid/imposed/reactions.h"
#include "solid/imposed/walls.h"
#include "solid/step/absolute.h"
#include "solid/step/verlet.h"

#include <string.h>

static void swap(double *x[3], double *y[3]) {
    for (int c = 0; c < 3; c++) {
        double *const t = x[c];
        x[c] = y[c];
        y[c] = t;
    }
}

/* The part that depends on d and on differences of v alone goes to v_old, with its power; a is scratch until
 * solid_force_rest. */
static void sweep_pairs(struct solid *s) {
    solid_force_pairs(s, 1);
    swap(s->a, s->v_old);
    s->power_pairwise = s->power_damped;
}

/* d += dt v + dt^2/2 a, v += theta dt a. Returns the sum of (load + weight) volume times the change of d, J. [n] */
static double predict(int n, double dt, double theta, double weight, const double *restrict volume,
                      const double *restrict load, const double *restrict a, double *restrict d, double *restrict v) {
    vec work = vec_set(0);
    int h = 0;
    for (; h + VEC_LANES <= n; h += VEC_LANES) {
        const vec rate = vec_load(v + h), dv = dt * vec_load(a + h), step = dt * (rate + 0.5 * dv);
        work += vec_load(volume + h) * (vec_load(load + h) + weight) * step;
        vec_store(d + h, vec_load(d + h) + step);
        vec_store(v + h, rate + theta * dv);
    }
    double sum = vec_sum(work);
    for (; h < n; h++) {
        const double dv = dt * a[h], step = dt * (v[h] + 0.5 * dv);
        sum += volume[h] * (load[h] + weight) * step;
        d[h] += step;
        v[h] += theta * dv;
    }
    return sum;
}

/* v += (1 - theta) dt a_old. Returns the sum of volume (f + g) times the change of d in the substep, without contact's
 * part of it, m5/s2. [n] */
static double correct(int n, double dt, double theta, const double *restrict volume, const double *restrict f,
                      const double *restrict g, const double *restrict a_old, double *restrict v) {
    vec work = vec_set(0);
    int h = 0;
    for (; h + VEC_LANES <= n; h += VEC_LANES) {
        const vec rate = vec_load(v + h), a = vec_load(a_old + h);
        work += vec_load(volume + h) * (vec_load(f + h) + vec_load(g + h)) * (rate + (0.5 - theta) * dt * a);
        vec_store(v + h, rate + (1 - theta) * dt * a);
    }
    double sum = vec_sum(work);
    for (; h < n; h++) {
        sum += volume[h] * (f[h] + g[h]) * (v[h] + (0.5 - theta) * dt * a_old[h]);
        v[h] += (1 - theta) * dt * a_old[h];
    }
    return dt * sum;
}

/* After a damped sweep_pairs: brings v from v^ to v*, and takes the work of the pairs' forces over the substep from
 * e_damped (solid/step/balance.h). a has the forces of its beginning, v_old those of its end. */
static void leave_pairs(struct solid *s, double dt, double theta) {
    const int *first = s->family->first;
    double work = -0.5 * dt * dt * solid_contact_implicit_along(s, s->a, 1, s->v_old);
    for (int b = 0; b < s->in.bodies; b++)
        for (int from = first[b], n; from < first[b + 1]; from += n) {
            n = solid_density_end(s, from, first[b + 1]) - from;
            for (int c = 0; c < s->dim; c++)
                work += solid_density(s, from) * correct(n, dt, theta, s->volume + from, s->a[c] + from,
                                                         s->v_old[c] + from, s->a_old[c] + from, s->v[c] + from);
        }
    s->e_damped -= 0.5 * work;
}

/* v += dt/2 (a - a_old). Returns the sum of volume (a^2 - a_old^2), m5/s4. [n] */
static double finish(int n, double dt, const double *restrict volume, const double *restrict a,
                     const double *restrict a_old, double *restrict v) {
    vec grown = vec_set(0);
    int h = 0;
    for (; h + VEC_LANES <= n; h += VEC_LANES) {
        const vec now = vec_load(a + h), before = vec_load(a_old + h), change = now - before;
        vec_store(v + h, vec_load(v + h) + 0.5 * dt * change);
        grown += vec_load(volume + h) * change * (now + before);
    }
    double sum = vec_sum(grown);
    for (; h < n; h++) {
        const double change = a[h] - a_old[h];
        v[h] += 0.5 * dt * change;
        sum += volume[h] * change * (a[h] + a_old[h]);
    }
    return sum;
}

/* The end of a substep, and what it has taken from the energies by velocities at its ends. With W for the works of all
 * forces but contact, the mean of their values at both ends times the displacement, the kinetic energy and contact's
 * potential change by exactly
 *     W + dt^2/8 sum of rho V (a(n+1)^2 - a(n)^2) + dt^2/4 sum of rho V C/rho.(a(n+1) - a(n)) */
static void finish_all(struct solid *s, double dt, int touches) {
    const int *first = s->family->first;
    double grown = 0;
    for (int b = 0; b < s->in.bodies; b++)
        for (int from = first[b], n; from < first[b + 1]; from += n) {
            n = solid_density_end(s, from, first[b + 1]) - from;
            for (int c = 0; c < s->dim; c++)
                grown += solid_density(s, from) *
                         finish(n, dt, s->volume + from, s->a[c] + from, s->a_old[c] + from, s->v[c] + from);
        }
    if (touches) grown += 2 * solid_contact_implicit_along(s, s->a, -1, s->a_old);
    solid_walls_correct(s, dt);
    s->e_integrator -= 0.125 * dt * dt * grown + solid_walls_excess(s);
}

void solid_verlet_again(struct solid *s) {
    s->power_damped = s->power_pairwise;
    solid_indenter_place(s, s->t);
    solid_force_rest(s, s->v_old);
    solid_absolute_begin(s);
}

void solid_verlet_begin(struct solid *s) {
    const int same = s->a_holds && memcmp(&s->stage, &s->stage_of_a, sizeof s->stage) == 0;
    if (par_min(same) > 0) { /* only the load has changed, on all ranks */
        solid_verlet_again(s);
    } else {
        solid_ghosts_begin(s);
        sweep_pairs(s);
        solid_indenter_place(s, s->t);
        solid_force_rest(s, s->v_old);
        solid_absolute_begin(s);
    }
}

/* Velocity Verlet with one sweep a step. Pairwise damping uses the velocity at the fraction theta =
 * SOLID_VERLET_PAIRWISE of the step, all other forces that depend on velocity use the velocity predicted for its end:
 *     v^ = v + theta dt a      v* = v + dt a      d += dt v + dt^2/2 a
 *     a' = a(d, v^, v*)        v = v* + dt/2 (a' - a)
 * After the first line contact moves the particles that touch, and adds to v* (solid/contact/implicit.h).
 * The works of the load, the added mass and the damped pairs are computed from the displacement, the other energies by
 * the trapezoidal rule. */
void solid_verlet_step(struct solid *s, double dt) {
    const double damped = s->power_damped - s->power_pairwise, constraint = s->power_constraint,
                 indented = s->power_indented;
    const int *first = s->family->first;
    const double theta = s->stage.damping_relative > 0 ? SOLID_VERLET_PAIRWISE : 1;
    const int touches = s->contact && solid_contact_implicit_is(s);
    if (touches) solid_contact_implicit_begin(s);
    solid_absorbed_save(s);
    if (s->added) solid_added_mass_leave(s);
    for (int b = 0; b < s->in.bodies; b++)
        for (int from = first[b], n; from < first[b + 1]; from += n) {
            n = solid_density_end(s, from, first[b + 1]) - from;
            const double density = solid_density(s, from);
            for (int c = 0; c < s->dim; c++)
                s->work_load += predict(n, dt, theta, density * s->in.body_force[c], s->volume + from,
                                        s->load[c] + from, s->a[c] + from, s->d[c] + from, s->v[c] + from);
        }
    solid_constraint_displacement(s, s->t + dt);
    if (touches) solid_contact_implicit_end(s, dt);
    swap(s->a, s->a_old);
    solid_ghosts_begin(s);
    solid_absorbed_begin(s, dt, theta);
    sweep_pairs(s);
    solid_absorbed_end(s);
    if (theta < 1) leave_pairs(s, dt, theta);
    solid_indenter_place(s, s->t + dt);
    solid_force_rest(s, s->v_old);
    solid_absolute_end(s, dt);
    finish_all(s, dt, touches);
    s->e_damped += 0.5 * dt * (damped + (s->power_damped - s->power_pairwise));
    s->work_load += 0.5 * dt * (indented + s->power_indented);
    if (s->added) s->work_load += solid_added_mass_arrive(s);
    s->e_constraint += 0.5 * dt * (constraint + s->power_constraint);
    solid_reactions_add(s, 0.5 * dt, 0.5 * dt);
    if (s->drag) solid_drag_kick(s, dt);
}

void solid_verlet_end(struct solid *s) {
    s->a_holds = 1;
    s->stage_of_a = s->stage;
}
