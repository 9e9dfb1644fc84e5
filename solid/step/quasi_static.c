/* One increment of quasi-static loading: raise, relax, break and soften the bonds beyond their limits, relax, until
 * none is. */
#include "solid/step/quasi_static.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"
#include "solid/force/force.h"
#include "solid/force/strain.h"
#include "solid/law/material.h"
#include "solid/step/relax.h"

#include <math.h>
#include <string.h>

/* A state of equilibrium, from which work is measured. [n] */
struct rest {
    double *d[3];     /* displacement, m */
    double *force[3]; /* what constraints give the held particles, N; 0 elsewhere */
    double *load[3];  /* N/m3 */
};

static void rest_new(const struct solid *s, struct rest *r) {
    for (int c = 0; c < s->dim; c++) {
        r->d[c] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof(double));
        r->force[c] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof(double));
        r->load[c] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof(double));
    }
}

static void rest_free(const struct solid *s, struct rest *r) {
    for (int c = 0; c < s->dim; c++) MEMORY_FREE(r->d[c], r->force[c], r->load[c]);
}

/* Stores the present state, at which v is 0. Collective. */
static void measure(struct solid *s, struct rest *r) {
    solid_ghosts_update(s);
    solid_force_bonds(s, 0, 0);
    if (s->in.contact && s->contact) solid_contact_force(s);
    solid_force_loads(s, s->a, 0);
    for (int c = 0; c < s->dim; c++) {
        memcpy(r->d[c], s->d[c], (size_t)s->n * sizeof(double));
        memcpy(r->load[c], s->load[c], (size_t)s->n * sizeof(double));
        for (int h = 0; h < s->n; h++)
            r->force[c][h] = s->flag[h] & SOLID_HELD_X << c ? -solid_density(s, h) * s->volume[h] * s->a[c][h] : 0;
    }
}

/* Adds the works on the way between two states. Returns by how much they may be too large, J, of this rank's particles:
 * a force that grows or falls steadily on the way does at least the work of the smaller of its values at the ends. */
static double add_works(struct solid *s, const struct rest *from, const struct rest *to) {
    double doubt = 0;
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) {
            const double moved = to->d[c][h] - from->d[c][h];
            const double load = 0.5 * (from->load[c][h] + to->load[c][h]) + solid_density(s, h) * s->in.body_force[c];
            s->work_load += s->volume[h] * load * moved;
            s->e_constraint += 0.5 * (from->force[c][h] + to->force[c][h]) * moved;
            doubt +=
                0.5 * fabs(moved) *
                (fabs(to->force[c][h] - from->force[c][h]) + s->volume[h] * fabs(to->load[c][h] - from->load[c][h]));
        }
    return doubt;
}

/* The force that stretches a cross-section of one particle to the critical stretch, N; 0 if nothing can break. At a
 * smaller residual a solid in two pieces, which bears no load any more, is at rest. */
static double breaking_force(const struct solid *s) {
    double least = INFINITY;
    for (int m = 0; m < s->in.materials; m++) {
        const struct solid_material *material = &s->in.material[m];
        const double s0 =
            solid_material_constants(s->in.model, s->in.thickness, material, material->horizon_ratio * s->in.spacing)
                .s0;
        least = fmin(least, material->youngs_modulus * s0);
    }
    return isfinite(least) ? least * pow(s->in.spacing, s->dim - 1) * solid_depth(&s->in) : 0;
}

/* Breaks and softens the bonds beyond their limits. Returns how many have broken, in the whole solid; *softened:
 * whether some have softened. Collective. */
static long break_bonds(struct solid *s, int *softened) {
    const long before = s->bonds_broken;
    const double released = s->e_fracture;
    solid_ghosts_update(s);
    s->is_quasi_static = 1;
    solid_force_bonds(s, 1, 0);
    s->is_quasi_static = 0;
    solid_family_count(s);
    *softened = s->soft && par_max(s->e_fracture - released) > 0;
    return s->bonds_broken - before;
}

/* Of a state of rest, J, whole solid. */
struct account {
    double taken;  /* the work up to now less the energies: what relaxations have taken but for a constant */
    double strain; /* strain energy */
};

/* Collective. */
static struct account account_of(struct solid *s) {
    solid_ghosts_update(s);
    const double contact = s->in.contact ? solid_contact_force_energy(s) : 0;
    const double strain = solid_strain_energy(s);
    double sum[2] = {s->work_load + s->e_constraint - strain - s->e_fracture, strain};
    par_sum_array(sum, 2);
    return (struct account){sum[0] - contact, sum[1]};
}

/* What relaxations have taken although no bond broke, J; 0 if the trapezoidal rule explains it. An unstable equilibrium
 * was left for one of less energy. `doubt`: by how much the works may be too large, J, whole solid. */
static double snapped(const struct account *before, const struct account *now, double doubt, double tolerance) {
    static const double LEAST = 1e-3; /* over the strain energy */
    const double lost = now->taken - before->taken, energy = fmax(before->strain, now->strain);
    return lost - doubt > fmax(LEAST, 10 * tolerance) * energy ? lost : 0;
}

/* What the relaxations of an increment took, J, whole solid. Collective. */
static double taken_of(struct solid *s, const struct account *before, long broken, double doubt, double tolerance) {
    const struct account after = account_of(s);
    return broken > 0 ? after.taken - before->taken : snapped(before, &after, doubt, tolerance);
}

/* Of the residual that softening leaves: a relaxation ends there if bonds will soften again. */
static const double PART = 0.1;

int solid_quasi_static_step(struct solid *s, double t, double tolerance, int max_steps,
                            struct solid_quasi_static *found) {
    struct rest rest[2] = {{{0}, {0}, {0}}, {{0}, {0}, {0}}};
    const double least = breaking_force(s);
    int now = 0, steps;
    *found = (struct solid_quasi_static){.broken = 0};
    for (int k = 0; k < 2; k++) rest_new(s, &rest[k]);
    solid_family_count(s);
    solid_contact_update(s);
    measure(s, &rest[now]);
    const struct account before = account_of(s);
    double doubt = 0;
    s->t = t;
    for (int softened = 0;;) {
        const int rests = !softened;
        steps = solid_relax_strained(s, tolerance, least, softened ? PART : 0, max_steps);
        if (steps < 0) break;
        found->relaxations += steps;
        measure(s, &rest[1 - now]);
        const long broken = s->stage.breakage ? break_bonds(s, &softened) : 0;
        if (broken == 0 && (softened || !rests)) continue;
        doubt += add_works(s, &rest[now], &rest[1 - now]);
        now = 1 - now;
        if (broken == 0) break;
        found->broken += broken;
        found->rounds++;
        solid_contact_update(s);
    }
    if (steps >= 0 || found->broken > 0)
        found->dissipated = taken_of(s, &before, found->broken, par_sum(doubt), tolerance);
    if (par_rank() == 0) s->e_damped += found->dissipated;
    for (int k = 0; k < 2; k++) rest_free(s, &rest[k]);
    s->a_holds = 0;
    found->moves_away = steps == SOLID_RELAX_AWAY;
    return steps >= 0;
}
