/* Outward normal of an interface particle from its intact bonds.  (001: eq. 3.46) */
#include "solid/surface/normal.h"
#include "solid/surface/surface.h"

#include "solid/surface/sector.h"
#include "solid/measure/tensors.h"

#include <math.h>

static const double short_normal = 0.15, no_normal = 1e-3, turned = 0.02; /* spacings */

struct sums {
    double m[3], t[6], weight; /* sums of w zeta, w zeta zeta^T, w */
};

static void add(struct sums *sum, const double z[3], double w) {
    for (int c = 0; c < 3; c++) {
        sum->m[c] += w * z[c];
        sum->t[c] += w * z[c] * z[c];
        sum->t[3 + c] += w * z[c] * z[(c + 1) % 3];
    }
    sum->weight += w;
}

static double length(const double x[3]) { return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); }

static int unit(const double x[3], double factor, double n[3]) {
    const double r = length(x);
    for (int c = 0; c < 3; c++) n[c] = r > 0 ? factor * x[c] / r : 0;
    return r > 0;
}

static int has_opposite(unsigned open) { return (open & open >> 1 & 21u) != 0; }

static void face(const struct sums *sum, double spacing, unsigned open, struct solid_normal_data *out) {
    const double r = length(sum->m) / sum->weight;
    out->two_sided = r < short_normal * spacing && has_opposite(open);
    if (out->two_sided) {
        double value[3], vector[3][3];
        solid_tensors_eigen(sum->t, value, vector);
        for (int c = 0; c < 3; c++) out->n[c] = vector[2][c];
    } else if (r > no_normal * spacing) {
        unit(sum->m, -1, out->n);
    } else { /* a pore whose position balances the rest: towards the void cones */
        double towards[3] = {0, 0, 0};
        for (int f = 0; f < SOLID_FACES; f++)
            if (open >> f & 1) towards[f / 2] += f % 2 ? -1 : 1;
        if (!unit(towards, 1, out->n)) out->n[0] = 1;
    }
}

/* Chooses the two reference bonds, both intact: the longest, and the one farthest from its line. */
static void feel(const struct solid *s, int h, const struct solid_family_view *view, struct solid_normal_data *out) {
    double best[2] = {0, 0};
    const double *first = view->xi[0];
    out->l[0] = out->l[1] = -1;
    for (int b = 0; b < view->n; b++) {
        const double r = length(view->xi[b]);
        if (!view->intact[b] || r <= best[0]) continue;
        best[0] = r;
        first = view->xi[b];
        out->l[0] = view->l[b];
    }
    for (int b = 0; b < view->n; b++) {
        const double *x = view->xi[b];
        const double cross[3] = {x[1] * first[2] - x[2] * first[1], x[2] * first[0] - x[0] * first[2],
                                 x[0] * first[1] - x[1] * first[0]};
        const double r = length(cross);
        if (!view->intact[b] || r <= best[1]) continue;
        best[1] = r;
        out->l[1] = view->l[b];
    }
    for (int k = 0; k < 2; k++)
        for (int c = 0; c < 3; c++) out->moved[k][c] = out->l[k] < 0 ? 0 : s->d[c][out->l[k]] - s->d[c][h];
}

/* Of the undeformed solid: with all bonds, or with those that are intact now. */
static void undeformed(const struct solid *s, int h, const struct solid_family_view *view, int with_all, unsigned open,
                       struct solid_normal_data *out) {
    struct sums sum = {0};
    for (int b = 0; b < view->n; b++)
        if (with_all || view->intact[b]) add(&sum, view->xi[b], view->weight[b]);
    *out = (struct solid_normal_data){.n = {1, 0, 0}, .two_sided = 1, .l = {-1, -1}, .open = (uint8_t)open};
    if (sum.weight > 0) face(&sum, solid_sector_spacing(s, h), open, out);
}

void solid_normal_compute_initial(const struct solid *s, int h, const struct solid_family_view *view, unsigned open,
                                  struct solid_normal_data *out) {
    undeformed(s, h, view, 1, open, out);
}

void solid_normal_compute_undeformed(const struct solid *s, int h, const struct solid_family_view *view, unsigned open,
                                     struct solid_normal_data *out) {
    undeformed(s, h, view, 0, open, out);
}

void solid_normal_compute(const struct solid *s, int h, const struct solid_family_view *view, unsigned open,
                          struct solid_normal_data *out) {
    const double spacing = solid_sector_spacing(s, h);
    struct sums sum = {0}, start = {0};
    for (int b = 0; b < view->n; b++) {
        double z[3];
        for (int c = 0; c < 3; c++) z[c] = view->xi[b][c] + (s->d[c][view->l[b]] - s->d[c][h]);
        if (view->intact[b]) add(&sum, z, view->weight[b]);
        add(&start, view->xi[b], view->weight[b]);
    }
    *out = (struct solid_normal_data){.n = {1, 0, 0}, .two_sided = 1, .l = {-1, -1}, .open = (uint8_t)open};
    if (!(sum.weight > 0)) out->two_sided = SOLID_ISOLATED;
    if (sum.weight > 0)
        face(&sum, spacing, open, out);
    else if (length(start.m) > short_normal * spacing * start.weight)
        unit(start.m, -1, out->n);
    feel(s, h, view, out);
}

int solid_normal_has_turned(const struct solid *s, int h, const struct solid_normal_data *data) {
    const double limit = turned * s->in.spacing;
    for (int k = 0; k < 2; k++) {
        const int l = data->l[k];
        if (l < 0) continue;
        double r2 = 0;
        for (int c = 0; c < 3; c++) {
            const double by = (s->d[c][l] - s->d[c][h]) - data->moved[k][c];
            r2 += by * by;
        }
        if (r2 > limit * limit) return 1;
    }
    return 0;
}
