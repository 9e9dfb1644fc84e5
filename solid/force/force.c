/* Assembles the accelerations: bonds, contact, loads, damping, added mass, constraints. */
#include "solid/force/force.h"
#include "base/par_ghost.h"
#include "base/vec.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/segments.h"
#include "solid/contact/contact.h"
#include "solid/contact/implicit.h"
#include "solid/imposed/added_mass.h"
#include "solid/force/dilatation.h"
#include "solid/force/sweep_lattice.h"
#include "solid/force/sweep_list.h"
#include "solid/force/sweep_limit.h"
#include "solid/force/sweep_soft.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/damping.h"
#include "solid/imposed/indenter.h"
#include "solid/imposed/reactions.h"
#include "solid/imposed/walls.h"

#include <string.h>

void solid_force_bonds(struct solid *s, int may_break, double damping_relative) {
    const struct solid_sweep sweep = {.may_break = may_break, .damping = damping_relative};
    const struct solid_family *f = s->family;
    double power = s->dilatation ? solid_dilatation_force(s, sweep) : 0;
    const int bodies = s->dilatation ? 0 : f->bodies;
    for (int b = 0; b < bodies; b++)
        if (f->lattice[b]) power += solid_sweep_lattice_begin(s, f->lattice[b], &sweep);
    par_ghost_end(s->ghost);
    for (int b = 0; b < bodies; b++)
        power +=
            f->lattice[b] ? solid_sweep_lattice_end(s, f->lattice[b], &sweep) : solid_sweep_list(s, f->list[b], &sweep);
    if (s->soft) power += solid_sweep_soft(s, &sweep);
    if (s->stretch_limit && may_break) solid_sweep_limit(s);
    s->power_damped = power;
    s->sweeps++;
}

void solid_force_reset(struct solid *s) {
    const struct solid_family *f = s->family;
    for (int b = 0; b < f->bodies; b++)
        if (f->lattice[b])
            solid_segments_reset(f->lattice[b]);
        else {
            memset(f->list[b]->large, 0, (size_t)f->list[b]->n);
            memset(f->list[b]->power, 0, (size_t)f->list[b]->n * sizeof(double));
            if (f->list[b]->extension_power)
                memset(f->list[b]->extension_power, 0, (size_t)f->list[b]->n * sizeof(double));
        }
}

struct powers {
    double load, damping; /* W */
};

/* a = bonds + load/rho + gravity - damping v of particles of one density, and the powers of load and damping. [n]; a
 * and bonds may be the same array. */
static struct powers add_loads(int n, double density, double gravity, double damping, const double *volume,
                               const double *load, const double *v, const double *bonds, double *a) {
    const double inv_density = 1 / density;
    vec load_power = vec_set(0), v2 = vec_set(0);
    int h = 0;
    for (; h + VEC_LANES <= n; h += VEC_LANES) {
        const vec of_load = vec_load(load + h), speed = vec_load(v + h), flow = vec_load(volume + h) * speed;
        load_power += (of_load + density * gravity) * flow;
        v2 += speed * flow;
        vec_store(a + h, vec_load(bonds + h) + (of_load * inv_density + gravity - damping * speed));
    }
    struct powers power = {vec_sum(load_power), vec_sum(v2)};
    for (; h < n; h++) {
        const double flow = volume[h] * v[h];
        power.load += (load[h] + density * gravity) * flow;
        power.damping += v[h] * flow;
        a[h] = bonds[h] + (load[h] * inv_density + gravity - damping * v[h]);
    }
    power.damping *= density * damping;
    return power;
}

void solid_force_loads(struct solid *s, double *const bonds[3], double damping_absolute) {
    const struct solid_family *f = s->family;
    s->power_load = 0;
    for (int b = 0; b < f->bodies; b++)
        for (int from = f->first[b], n; from < f->first[b + 1]; from += n) {
            n = solid_density_end(s, from, f->first[b + 1]) - from;
            const double density = solid_density(s, from);
            for (int c = 0; c < s->dim; c++) {
                const struct powers power =
                    add_loads(n, density, s->in.body_force[c], damping_absolute, s->volume + from, s->load[c] + from,
                              s->v[c] + from, bonds[c] + from, s->a[c] + from);
                s->power_load += power.load;
                s->power_damped += power.damping;
            }
        }
}

void solid_force_rest(struct solid *s, double *const pairs[3]) {
    solid_force_loads(s, pairs, s->stage.damping_absolute);
    solid_damping_find(s);
    const double of_load = s->power_load;
    if (s->indent) solid_indenter_push(s);
    s->power_indented = s->power_load - of_load;
    if (s->walls) solid_walls_push(s);
    solid_reactions_find(s);
    if (s->added) solid_added_mass_apply(s);
    solid_constraint_apply(s);
}

void solid_force_pairs(struct solid *s, int may_break) {
    solid_force_bonds(s, may_break && s->stage.breakage, s->stage.damping_relative);
    if (s->in.contact && s->contact && !solid_contact_implicit_is(s)) solid_contact_force(s);
}

void solid_force(struct solid *s, int may_break) {
    solid_force_pairs(s, may_break);
    solid_force_rest(s, s->a);
}
