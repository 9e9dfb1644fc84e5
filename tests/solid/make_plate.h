/* Plates for tests: a rectangle of cells, or of points moved about, in soda-lime glass with a little of everything. */
#pragma once
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/measure/energy.h"
#include "solid/solid.h"
#include "solid/state.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

static const double SPACING = 1e-3, YOUNG = 72e9, DENSITY = 2440, G0 = 135, THICKNESS = 2e-3;

struct make {
    int sites[2];
    enum physics_model model; /* default plane stress */
    double shift[2];          /* of the plate and its lattice, m */
    double ratio;             /* m, default 3 */
    double irregular;         /* points up to this many spacings from the lattice, with unequal volumes */
    double perturbation;      /* of the cells' particles, spacings */
    int seed;                 /* of the perturbation */
    int brittle;              /* breaks at G0 */
    enum solid_partial partial;
    enum physics_micromodulus micromodulus;
    double tensile_strength; /* 0: brittle */
    double ratio_excess;     /* Poisson's ratio less that of the model */
    int periodic[2];
    int uncorrected, contact;
    enum solid_correction correction; /* none: volume, or none at all if uncorrected */
    int cuts, constraints, unbreakables, loads, initials;
    const struct solid_cut *cut;
    const struct solid_constraint *constraint;
    const struct solid_region *unbreakable;
    const struct solid_load *load;
    const struct solid_initial *initial;
    enum solid_horizons horizons;
    const struct solid_refinement *refinement;
    int outlines; /* instead of the rectangle; sites still gives its size */
    const struct solid_outline *outline;
};

/* A number in [-1, 1). */
static inline double noise_of(uint64_t a, uint64_t b) {
    uint64_t z = a * 0x9e3779b97f4a7c15u + (b + 1) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (double)(z >> 11) * 0x1p-52 - 1;
}

static inline struct solid *make(struct make m) {
    const double w = m.sites[0] * SPACING, h = m.sites[1] * SPACING;
    const double corner[4][2] = {{m.shift[0], m.shift[1]},
                                 {m.shift[0] + w, m.shift[1]},
                                 {m.shift[0] + w, m.shift[1] + h},
                                 {m.shift[0], m.shift[1] + h}};
    const signed char turn[4] = {0};
    const struct solid_outline outline = {0, 4, corner, corner, turn};
    struct solid_body body = {.name = "plate", .shape = SOLID_POLYGON, .outlines = 1, .outline = &outline};
    body.perturbation = m.perturbation;
    body.perturbation_seed = m.seed;
    if (m.outlines) {
        body.outlines = m.outlines;
        body.outline = m.outline;
    }
    const struct solid_material material = {YOUNG,
                                            DENSITY,
                                            m.brittle ? G0 : INFINITY,
                                            m.ratio > 0 ? m.ratio : 3,
                                            m.micromodulus,
                                            m.tensile_strength,
                                            m.ratio_excess};
    struct solid_input in = {.model = m.model == PHYSICS_3D ? PHYSICS_PLANE_STRESS : m.model,
                             .thickness = THICKNESS,
                             .partial = m.partial,
                             .spacing = SPACING,
                             .origin = {m.shift[0], m.shift[1]},
                             .periodic = {m.periodic[0], m.periodic[1]},
                             .length = {w, h},
                             .bodies = 1,
                             .body = &body,
                             .materials = 1,
                             .material = &material,
                             .cuts = m.cuts,
                             .cut = m.cut,
                             .constraints = m.constraints,
                             .constraint = m.constraint,
                             .unbreakables = m.unbreakables,
                             .unbreakable = m.unbreakable,
                             .loads = m.loads,
                             .load = m.load,
                             .initials = m.initials,
                             .initial = m.initial,
                             .horizons = m.horizons,
                             .refinement = m.refinement,
                             .contact = m.contact,
                             .contact_stiffness = 15,
                             .contact_exponent = 1,
                             .contact_radius = 1,
                             .surface_correction =
                                 m.correction ? m.correction : (enum solid_correction) !m.uncorrected};
    const long points = m.irregular > 0 ? (long)m.sites[0] * m.sites[1] : 0;
    double *x = malloc(((size_t)points * 3 + 1) * sizeof *x);
    for (long p = 0; p < points; p++) {
        const uint64_t key = (uint64_t)p;
        x[p] = m.shift[0] + SPACING * ((double)(p % m.sites[0]) + 0.5 + m.irregular * noise_of(key, 0));
        x[points + p] = m.shift[1] + SPACING * ((double)(p / m.sites[0]) + 0.5 + m.irregular * noise_of(key, 1));
        x[2 * points + p] = SPACING * SPACING * (1 + m.irregular * noise_of(key, 2));
    }
    if (points) {
        body.shape = SOLID_POINTS;
        body.points = points;
        body.point[0] = x;
        body.point[1] = x + points;
        body.point_volume = x + 2 * points;
    }
    struct solid *s = solid_new(&in);
    free(x);
    return s;
}

/* A number in [-1, 1) that depends on the particle alone, not on ranks. */
static inline double noise(const struct solid *s, int h, int c) {
    return noise_of((uint64_t)(s->first[par_rank()] + h), (uint64_t)(c + 10));
}

static inline void shake(struct solid *s, double strain, double speed) {
    for (int c = 0; c < 2; c++)
        for (int h = 0; h < s->n; h++) {
            s->d[c][h] += strain * SPACING * noise(s, h, c);
            s->v[c][h] += speed * noise(s, h, c + 2);
        }
    solid_ghosts_update(s);
}

/* The step in units of spacing/sqrt(E/rho). */
static inline double step_of(double number) { return number * SPACING / sqrt(YOUNG / DENSITY); }

/* Kinetic + strain energy, and dissipated minus supplied energy; J, whole solid. Collective. */
static inline double balance_of(struct solid *s, double *size) {
    const struct solid_energy e = solid_energy_measure(s);
    double sum[4] = {0, 0, s->work_load, s->e_constraint};
    par_sum_array(sum, 4);
    sum[0] = e.damped;
    sum[1] = e.fracture;
    if (size)
        *size =
            fmax(fmax(e.kinetic, e.strain), fmax(fmax(fabs(sum[0]), fabs(sum[1])), fmax(fabs(sum[2]), fabs(sum[3]))));
    return e.kinetic + e.strain + sum[0] + sum[1] - sum[2] - sum[3];
}
