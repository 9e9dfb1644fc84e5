/* Strain, kinetic and contact energy; energy and largest stretch of each particle's bonds.  (001: eq. 3.23) */
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/kinds.h"
#include "solid/bonds/list.h"
#include "solid/bonds/row.h"
#include "solid/bonds/segments.h"
#include "solid/contact/contact.h"
#include "solid/force/segment_energy.h"
#include "solid/force/sweep_list.h"
#include "solid/force/sweep_soft.h"
#include "solid/measure/energy.h"

#include <math.h>

/* Stretch of the b-th bond of h:  s = eps/(1 + sqrt(1 + eps)),  eps = (2 xi.eta + eta.eta)/|xi|^2 */
static double stretch_of(const struct solid *s, int h, const struct solid_family_view *view, int b, double *length) {
    double xi2 = 0, q = 0;
    for (int c = 0; c < s->dim; c++) {
        const double xi = view->xi[b][c], eta = s->d[c][view->l[b]] - s->d[c][h];
        xi2 += xi * xi;
        q += eta * (xi + (xi + eta));
    }
    const double eps = q / xi2;
    *length = sqrt(xi2);
    return eps / (1 + sqrt(1 + eps));
}

/* Half of the energy in each of h's bonds, (1/2) alpha c s^2 |xi| Gamma V_l V_h, divided by V_h, J/m3.  (001: eq.
 * 3.23) */
static double of_view(const struct solid *s, int h, const struct solid_family_view *view) {
    double sum = 0;
    for (int b = 0; b < view->n; b++) {
        if (!view->intact[b]) continue;
        double length;
        const double stretch = stretch_of(s, h, view, b, &length);
        sum += view->alpha[b] * view->micro[b] * stretch * stretch * length * view->weight[b];
    }
    return 0.25 * sum;
}

/* The same for the i-th particle of a list, whose stiffness is alpha c Gamma V_l/(rho |xi|) with |xi| in spacings.
 * *most: the largest stretch, -1 without an intact bond. */
static double of_bonds(const struct solid *s, const struct solid_list *list, int i, double *most) {
    const double scale = 1 / list->spacing;
    double sum = 0;
    *most = -1;
    for (long j = list->start[i]; j < list->end[i]; j++) {
        if (!solid_list_is_intact(list, j)) continue;
        const int h = list->first + i, l = solid_list_other(list, j);
        double xi[3], q = 0;
        const double length = solid_list_steps(list, j, xi), xi2 = length * length;
        for (int c = 0; c < list->dim; c++) {
            const double eta = scale * (s->d[c][l] - s->d[c][h]);
            q += eta * (xi[c] + (xi[c] + eta));
        }
        const double eps = q / xi2, stretch = eps / (1 + sqrt(1 + eps));
        *most = fmax(*most, stretch);
        double stiffness = list->stiffness[j];
        if (solid_list_is_soft(list, j)) stiffness *= -solid_soft_share(s, h, (int)(j - list->start[i]));
        sum += stiffness * xi2 * stretch * stretch;
    }
    return 0.25 * list->law.density * list->spacing * sum;
}

static const double small_eps = 1. / 256; /* below it the series for s^2 is exact to 1e-15 */

/* s^2 = 2 + eps - 2 sqrt(1 + eps); for small eps the series eps^2/4 (1 - eps/2 + 5/16 eps^2 - ...). */
static inline vec square_of_stretch(vec e, int small) {
    if (!small) {
        const vec s = e / (1 + vec_sqrt(1 + e));
        return s * s;
    }
    vec series = 21. / 128 - e * (33. / 256);
    series = 5. / 16 - e * (7. / 32 - e * series);
    series = 1 - e * (0.5 - e * series);
    return 0.25 * (e * e) * series;
}

/* The energy density of the i-th particle of a list, eight bonds at a time, from its records. *largest: of |eps|. */
static inline __attribute__((always_inline)) double of_family(const struct solid_list *list, int i, int dim, int small,
                                                              vec *largest) {
    const double *here = list->record + (long)list->width * i;
    vec sum = vec_set(0);
    for (long j = list->start[i]; j < list->end[i]; j += SOLID_LIST_BLOCK) {
        vec there[4], q = vec_set(0), xi2 = vec_set(0);
        const vec stiffness = vec_load(list->stiffness + j);
        const unsigned intact = ~vec_signs(stiffness) & 0xffu;
        if (dim == 2)
            vec_gather2(list->record, list->at + j, there);
        else
            vec_gather4(list->record, 1, list->at + j, there);
        for (int c = 0; c < dim; c++) {
            const vec xi = vec_load_floats(solid_list_step(list, j, c)), eta = there[c] - here[c];
            q += eta * (xi + (xi + eta));
            xi2 += xi * xi;
        }
        const vec eps = vec_where(intact, q / xi2);
        *largest = vec_max(*largest, vec_max(eps, -eps));
        sum += vec_where(intact, stiffness * xi2) * square_of_stretch(eps, small);
    }
    return 0.25 * list->law.density * list->spacing * vec_sum(sum);
}

static double of_list(const struct solid_list *list, int i) {
    vec largest = vec_set(0);
    const double small = list->dim == 2 ? of_family(list, i, 2, 1, &largest) : of_family(list, i, 3, 1, &largest);
    if (vec_highest(largest) < small_eps) return small;
    return list->dim == 2 ? of_family(list, i, 2, 0, &largest) : of_family(list, i, 3, 0, &largest);
}

/* J. The energy of a segment of one kind follows from constants of kind 0; one of several kinds has its own kernel. */
static double of_lattice(const struct solid *s, const struct solid_lattice *lattice) {
    const struct solid_segments *all = lattice->segments;
    const struct solid_kinds *kinds = lattice->kinds;
    const double spacing = lattice->stencil->spacing;
    const struct solid_boxes box = {.d = {lattice->d[0], lattice->d[1], lattice->d[2]},
                                    .w = lattice->w,
                                    .half = kinds ? kinds->half : NULL,
                                    .offset = lattice->offset};
    double sum = 0;
    solid_row_begin(s, lattice);
    for (int g = 0; g < all->n; g++) {
        const int kind = kinds ? kinds->segment[g] : 0, several = kind == SOLID_KINDS_SEVERAL;
        const enum solid_kernel kernel = (several ? KERNEL_SEVERAL : 0) | (all->bulk[g] ? KERNEL_BULK : 0);
        if (all->stale[g]) solid_segments_pack(lattice, g);
        struct solid_segment_energy e = solid_segment_energy(&box, all, g, kernel);
        if (!(e.largest < small_eps)) e = solid_segment_energy(&box, all, g, kernel | KERNEL_EXACT);
        sum += (kind == 0 || several ? 1 : kinds->stiffer[kind]) * (e.whole + 0.5 * e.half);
    }
    return 0.5 * lattice->law.density * spacing * spacing * spacing * sum;
}

/* J, of the particles from .. to - 1. */
static double kinetic_of(const struct solid *s, int from, int to) {
    const double *restrict volume = s->volume;
    double sum = 0;
    for (int h = from, end; h < to; h = end) {
        double part = 0;
        end = solid_density_end(s, h, to);
        for (int i = h; i < end; i++) {
            double v2 = 0;
            for (int c = 0; c < s->dim; c++) v2 += s->v[c][i] * s->v[c][i];
            part += volume[i] * v2;
        }
        sum += 0.5 * solid_density(s, h) * part;
    }
    return sum;
}

struct solid_energy solid_energy_measure(struct solid *s) {
    double sum[2] = {0, 0};
    solid_ghosts_update(s);
    for (int b = 0; b < s->family->bodies; b++) {
        const struct solid_list *list = s->family->list[b];
        if (s->family->lattice[b]) sum[1] += of_lattice(s, s->family->lattice[b]);
        if (list) solid_sweep_list_fill(s, list);
        sum[0] += kinetic_of(s, s->family->first[b], s->family->first[b + 1]);
        for (int h = s->family->first[b]; list && h < s->family->first[b + 1]; h++)
            sum[1] += s->volume[h] * of_list(list, h - list->first);
    }
    sum[1] += solid_sweep_soft_energy(s);
    par_sum_array(sum, 2);
    return (struct solid_energy){sum[0], sum[1], s->in.contact ? solid_contact_force_energy(s) : 0};
}

void solid_energy_bonds_of(const struct solid *s, int h, double *energy, double *stretch) {
    struct solid_family_view view;
    double length;
    const struct solid_list *list = s->family->list[s->body[h]];
    if (list) {
        *energy = of_bonds(s, list, h - list->first, stretch);
        return;
    }
    solid_family_view(s, h, &view);
    *energy = of_view(s, h, &view);
    *stretch = -1;
    for (int b = 0; b < view.n; b++)
        if (view.intact[b]) *stretch = fmax(*stretch, stretch_of(s, h, &view, b, &length));
}

void solid_energy_bonds(const struct solid *s, double *energy, double *stretch) {
    for (int h = 0; h < s->n; h++) solid_energy_bonds_of(s, h, &energy[h], &stretch[h]);
}
