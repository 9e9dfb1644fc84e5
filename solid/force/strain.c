/* Strain energy of the bonds and of the families' dilatation, as the force sweeps see them.  (001: eq. 3.23) */
#include "solid/force/strain.h"
#include "base/vec_shuffle.h"
#include "solid/bonds/family.h"
#include "solid/bonds/materials.h"
#include "solid/bonds/list.h"
#include "solid/bonds/row.h"
#include "solid/bonds/segments.h"
#include "solid/force/dilatation.h"
#include "solid/force/segment_energy.h"
#include "solid/force/sweep_list.h"
#include "solid/force/sweep_soft.h"

#include <math.h>

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

/* The energy density of the i-th particle of a list, a vec of bonds at a time, from its records. *largest: of |eps|. */
static inline __attribute__((always_inline)) double of_family(const struct solid_list *list, int i, int dim, int small,
                                                              vec *largest) {
    const double *here = list->record + (long)list->width * i;
    vec sum = vec_set(0);
    for (long j = list->start[i]; j < list->end[i]; j += VEC_LANES) {
        vec there[4], q = vec_set(0), xi2 = vec_set(0);
        const vec stiffness = vec_load(list->stiffness + j);
        const unsigned intact = ~vec_signs(stiffness);
        if (dim == 2)
            vec_shuffle_gather2(list->record, list->at + j, there);
        else
            vec_shuffle_gather4(list->record, 1, list->at + j, there);
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
    const struct solid_materials *materials = lattice->materials;
    const double spacing = lattice->stencil->spacing;
    const struct solid_boxes box = {.d = {lattice->d[0], lattice->d[1], lattice->d[2]},
                                    .w = lattice->w,
                                    .half = materials ? materials->half : NULL,
                                    .offset = lattice->offset};
    double sum = 0;
    solid_row_begin(s, lattice);
    for (int g = 0; g < all->n; g++) {
        const int kind = materials ? materials->segment[g] : 0, several = kind == SOLID_MATERIALS_SEVERAL;
        const enum solid_kernel kernel = (several ? KERNEL_SEVERAL : 0) | (all->bulk[g] ? KERNEL_BULK : 0);
        if (all->stale[g]) solid_segments_pack(lattice, g);
        struct solid_segment_energy e = solid_segment_energy(&box, all, g, kernel);
        if (!(e.largest < small_eps)) e = solid_segment_energy(&box, all, g, kernel | KERNEL_EXACT);
        sum += (kind == 0 || several ? 1 : materials->stiffer[kind]) * (e.whole + 0.5 * e.half);
    }
    return 0.5 * lattice->law.density * spacing * spacing * spacing * sum;
}

double solid_strain_energy(const struct solid *s) {
    double sum = 0;
    for (int b = 0; b < s->family->bodies; b++) {
        struct solid_list *list = s->family->list[b];
        if (s->family->lattice[b]) sum += of_lattice(s, s->family->lattice[b]);
        if (list) solid_sweep_list_fill(s, list);
        for (int h = s->family->first[b]; list && h < s->family->first[b + 1]; h++)
            sum += s->volume[h] * of_list(list, h - list->first);
    }
    return sum + solid_sweep_soft_energy(s) + solid_dilatation_energy(s);
}
