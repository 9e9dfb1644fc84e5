/* Solids for tests: a box of sites in the main case's material. */
#pragma once
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/law/material.h"
#include "solid/solid.h"
#include "solid/state.h"
#include "tests/solid/noise.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

static const double SPACING = 1.5625e-3, YOUNG = 1e8, DENSITY = 3000;

struct make {
    int sites[3];
    int periodic[3];
    int list;        /* general bonds */
    int mixed;       /* in mixed precision */
    int uncorrected; /* no surface correction; else by volume, or */
    int by_energy;
    double fracture_energy;  /* 0: never breaks */
    double tensile_strength; /* 0: brittle */
    int constraints;
    const struct solid_constraint *constraint;
    int unbreakables;
    const struct solid_region *unbreakable;
    double body_force[3];
    double ratio_excess; /* Poisson's ratio less 1/4 */
    int cuts;
    const struct solid_cut *cut;
};

static inline struct solid *make(struct make m) {
    struct solid_body body = {.name = "block", .shape = SOLID_BOX};
    const struct solid_material material = {YOUNG,
                                            DENSITY,
                                            m.fracture_energy > 0 ? m.fracture_energy : INFINITY,
                                            3,
                                            PHYSICS_CONSTANT,
                                            m.tensile_strength,
                                            m.ratio_excess};
    struct solid_input in = {.spacing = SPACING,
                             .bodies = 1,
                             .body = &body,
                             .materials = 1,
                             .material = &material,
                             .constraints = m.constraints,
                             .constraint = m.constraint,
                             .unbreakables = m.unbreakables,
                             .unbreakable = m.unbreakable,
                             .cuts = m.cuts,
                             .cut = m.cut,
                             .surface_correction = m.by_energy     ? SOLID_CORRECTION_ENERGY
                                                   : m.uncorrected ? SOLID_CORRECTION_NONE
                                                                   : SOLID_CORRECTION_VOLUME,
                             .precision = m.mixed ? SOLID_MIXED : SOLID_DOUBLE,
                             .general_bonds = m.list};
    for (int c = 0; c < 3; c++) {
        body.high[c] = m.sites[c] * SPACING;
        in.periodic[c] = m.periodic[c];
        in.length[c] = body.high[c];
        in.body_force[c] = m.body_force[c];
    }
    return solid_new(&in);
}

/* The step in units of spacing/sqrt(E/rho). */
static inline double step_of(double number) { return number * SPACING / sqrt(YOUNG / DENSITY); }

/* Total energy now: kinetic and strain of the whole solid, J. Ghosts must be current. Collective. */
static inline double energy_of(const struct solid *s, double *kinetic) {
    struct solid_family_view view;
    double sum[2] = {0};
    const double c0 = solid_material_micromodulus(s->in.material, s->in.spacing);
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            if (!view.intact[b]) continue;
            double length2 = 0, q = 0;
            for (int c = 0; c < 3; c++) {
                const double eta = s->d[c][view.l[b]] - s->d[c][h];
                length2 += view.xi[b][c] * view.xi[b][c];
                q += eta * (2 * view.xi[b][c] + eta);
            }
            const double eps = q / length2, stretch = eps / (1 + sqrt(1 + eps));
            sum[0] += 0.25 * c0 * view.alpha[b] * stretch * stretch * sqrt(length2) * view.weight[b] * s->volume[h];
        }
        for (int c = 0; c < 3; c++) sum[1] += 0.5 * DENSITY * s->volume[h] * s->v[c][h] * s->v[c][h];
    }
    par_sum_array(sum, 2);
    if (kinetic) *kinetic = sum[1];
    return sum[0] + sum[1];
}
