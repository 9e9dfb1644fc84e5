/* A straight crack in a plate or a penny in a block, with a uniform pressure on all struts, at rest. */
#pragma once
#include "cracks/aperture.h"
#include "cracks/solve.h"
#include "cracks/struts.h"
#include "cracks/sums.h"
#include "solid/law/material.h"
#include "solid/step/relax.h"
#include "tests/cracks/make.h"

/* Breaks the bonds through the circle, in a plate the line, of a radius about the middle of the body, between layers.
 */
static inline void cut_about_middle(struct solid *s, const int sites[3], double radius) {
    static struct solid_family_view view;
    const int normal = s->dim - 1;
    double mid[3];
    for (int c = 0; c < 3; c++) mid[c] = 0.5 * sites[c] * SPACING;
    for (int h = 0; h < s->n; h++) {
        const double above = s->x0[normal][h] - mid[normal];
        if (fabs(above) > 4 * SPACING) continue;
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            const double step = view.xi[b][normal];
            if (above * (above + step) >= 0) continue;
            double r2 = 0;
            for (int c = 0; c < normal; c++) {
                const double x = s->x0[c][h] - mid[c] - above / step * view.xi[b][c];
                r2 += x * x;
            }
            if (r2 < radius * radius && view.intact[b]) solid_family_break(s, h, b);
        }
    }
}

struct found {
    double volume, opening; /* over those of linear elasticity */
    double critical;        /* pressure at which the first bond reaches s0, over sqrt(E G0/a) */
};

/* A crack of radius a (half length in a plate) in spacings, in a body of these sites. */
static inline struct found at_rest(const int sites[3], double a) {
    struct solid *s = make((struct make){.sites = {sites[0], sites[1], sites[2]}});
    const int plate = sites[2] == 0, normal = s->dim - 1;
    const double radius = a * SPACING, p = 1e4;
    cut_about_middle(s, sites, radius);
    const struct cracks_input in = {.viscosity = 1e-3, .least_aperture = 1e-9};
    struct cracks *c = cracks_new(&in, s);
    const struct cracks_struts *t = &c->struts;
    for (int i = 0; i < t->n + t->ghosts; i++) c->p[i] = p;
    cracks_sums_force(c, c->p, c->work->force);
    for (int i = 0; i < t->n; i++)
        for (int k = 0; k < s->dim; k++) s->load[k][t->h[i]] = c->work->force[i][k] / s->volume[t->h[i]];
    assert_true(solid_relax(s, 1e-5, 20000) > 0);
    cracks_aperture_volume(c, c->volume);
    double sum[3] = {0}, most = 0;
    for (int i = 0; i < t->n; i++) {
        double r2 = 0;
        for (int k = 0; k < normal; k++) {
            const double x = s->x0[k][t->h[i]] - 0.5 * sites[k] * SPACING;
            r2 += x * x;
        }
        sum[0] += c->volume[i];
        if (r2 < 1.01 * normal * 0.25 * SPACING * SPACING) sum[1] += c->volume[i]; /* the middle columns */
    }
    par_sum_array(sum, 3);
    static struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        if (fabs(s->x0[normal][h] - 0.5 * sites[normal] * SPACING) > 4 * SPACING) continue;
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            double length2 = 0, along = 0;
            for (int k = 0; k < s->dim; k++) {
                length2 += view.xi[b][k] * view.xi[b][k];
                along += view.xi[b][k] * (s->d[k][view.l[b]] - s->d[k][h]);
            }
            if (view.intact[b]) most = fmax(most, along / length2);
        }
    }
    par_max_array(&most, 1);
    struct solid_material material = s->in.material[0];
    material.fracture_energy = 1;
    const double s0 = solid_material_constants(s->in.model, s->in.thickness, &material, 3 * SPACING).s0;
    const double columns = plate ? 2 : 4, area = columns * SPACING * (plate ? THICKNESS : SPACING);
    const double of_volume =
        plate ? 5.8905 * p * radius * radius / YOUNG * THICKNESS : 5.0 * p * radius * radius * radius / YOUNG;
    struct found found = {sum[0] / of_volume, sum[1] / area / ((plate ? 3.75 : 2.3873) * p * radius / YOUNG),
                          p * s0 / most / sqrt(YOUNG * 1 / radius)};
    cracks_free(c);
    solid_free(s);
    return found;
}
