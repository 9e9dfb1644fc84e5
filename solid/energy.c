#include "base/par.h"
#include "base/vec.h"
#include "solid/family.h"
#include "solid/lattice.h"
#include "solid/measures.h"

#include <math.h>

/* Bonds' energies, sum of (1/2) alpha c0 s^2 |xi| Gamma V V, half of each from either end (001: eq. 3.23). Without the
 * factor c0 V_h/4:
 *
 *     sum over bonds of alpha s^2 |xi| Gamma V_l,    s = eps/(1 + sqrt(1 + eps)),  eps = (2 xi.eta + eta.eta)/|xi|^2  */
static double of_view(const struct solid *s, int h, const struct solid_family_view *view) {
    double sum = 0;
    for (int b = 0; b < view->n; b++) {
        if (!view->intact[b]) continue;
        double xi2 = 0, q = 0;
        for (int c = 0; c < 3; c++) {
            const double xi = view->xi[b][c], eta = s->d[c][view->l[b]] - s->d[c][h];
            xi2 += xi * xi;
            q += eta * (xi + (xi + eta));
        }
        const double eps = q / xi2, stretch = eps / (1 + sqrt(1 + eps));
        sum += view->alpha[b] * stretch * stretch * sqrt(xi2) * view->weight[b];
    }
    return sum;
}

/* The same for a row of eight sites of a lattice, whose displacements stand in its dense box. */
static double of_row(const struct solid_lattice *t, int r) {
    const int cell = t->row_cell[r];
    const uint8_t *lambda = t->lambda + (size_t)r * (size_t)t->stencil->n;
    const vec x = vec_load(t->d[0] + cell), y = vec_load(t->d[1] + cell), z = vec_load(t->d[2] + cell);
    const vec w = vec_load(t->w + cell);
    vec sum = vec_set(0);
    for (long i = t->row_active[r]; i < t->row_active[r + 1]; i++) {
        const int o = t->active[i];
        const struct solid_lattice_offset *bond = &t->offset[o];
        const struct solid_offset *from = &t->stencil->offset[o];
        const long at = cell + bond->shift;
        const vec ex = vec_load(t->d[0] + at) - x, ey = vec_load(t->d[1] + at) - y,
                  ez = vec_load(t->d[2] + at) - z;
        const vec q = ex * (ex + 2 * bond->xi[0]) + ey * (ey + 2 * bond->xi[1]) + ez * (ez + 2 * bond->xi[2]);
        const vec eps = vec_where(lambda[o], q * bond->inv_length2);
        const vec stretch = eps / (1 + vec_sqrt(1 + eps));
        const vec alpha = 2 / (w + vec_load(t->w + at));
        sum += vec_where(lambda[o], alpha * (from->length * from->weight) * stretch * stretch);
    }
    return vec_sum(sum);
}

static double of_lattice(const struct solid *s, struct solid_lattice *t) {
    const double spacing = t->stencil->spacing;
    double sum = 0;
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < t->copies; i++) t->d[c][t->copy_cell[i]] = s->d[c][t->copy_local[i]];
    for (int r = 0; r < t->rows; r++) sum += of_row(t, r);
    return 0.25 * t->law.c0 * spacing * spacing * spacing * sum;
}

struct solid_energy solid_measure_energy(struct solid *s) {
    struct solid_family_view view;
    double sum[2] = {0, 0};
    solid_ghosts_update(s);
    for (int b = 0; b < s->family->bodies; b++) {
        const struct solid_material *material = &s->in.material[s->in.body[b].material];
        const double c0 = solid_micromodulus(material, s->in.spacing);
        if (s->family->lattice[b]) sum[1] += of_lattice(s, s->family->lattice[b]);
        for (int h = s->family->first[b]; h < s->family->first[b + 1]; h++) {
            double v2 = 0;
            for (int c = 0; c < 3; c++) v2 += s->v[c][h] * s->v[c][h];
            sum[0] += 0.5 * material->density * s->volume[h] * v2;
            if (s->family->lattice[b]) continue;
            solid_family_view(s, h, &view);
            sum[1] += 0.25 * c0 * s->volume[h] * of_view(s, h, &view);
        }
    }
    par_sum_array(sum, 2);
    return (struct solid_energy){sum[0], sum[1]};
}
