/* How much of the fluid on a straight line through the domain is deep in bodies. */
/* The lines of a direction are bundled by squares of a whole number of spacings, at least two cells wide, so that each
 * bundle holds the same number of rows of a lattice. */
#include "coupling/load/inner_lines.h"
#include "base/memory.h"
#include "base/par.h"
#include "fluid/grid/side.h"

#include <math.h>

/* The bundles of the lines along a direction c. */
struct bundles {
    int c, a, b;                       /* the direction, and those across */
    int n[2];                          /* number of bundles along a and b */
    double width[2], length, cross[2]; /* of a bundle, m; of the domain along c, and along a and b, m */
};

static int is_free(const struct run *r, int c) {
    const struct fluid_side *side = fluid_input_of(r->fluid)->side[c];
    return fluid_grid_of(r->fluid)->periodic[c] ||
           (fluid_side_flow(&side[0], c, 0) < 0 && fluid_side_flow(&side[1], c, 1) < 0);
}

static struct bundles bundles_along(const struct run *r, int c) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    struct bundles l = {.c = c, .a = (c + 1) % 3, .b = (c + 2) % 3, .length = g->length[c]};
    const int across[2] = {l.a, l.b};
    const double spacing = r->solid->in.spacing;
    for (int k = 0; k < 2; k++) {
        l.cross[k] = g->length[across[k]];
        l.width[k] = spacing * ceil(2 * g->d[across[k]] / spacing * (1 - 1e-9));
        l.n[k] = (int)ceil(l.cross[k] / l.width[k] * (1 - 1e-9));
    }
    return l;
}

/* The bundle in which a particle stands at the start; -1: outside the domain. */
static int bundle_of(const struct bundles *l, const struct run *r, int h) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const int across[2] = {l->a, l->b};
    const double along = r->solid->x0[l->c][h];
    int at[2];
    if (!g->periodic[l->c] && (along < 0 || along > l->length)) return -1;
    for (int k = 0; k < 2; k++) {
        double x = r->solid->x0[across[k]][h];
        if (g->periodic[across[k]]) x -= floor(x / l->cross[k]) * l->cross[k];
        if (x < 0 || x > l->cross[k]) return -1;
        at[k] = (int)fmin(x / l->width[k], l->n[k] - 1);
    }
    return at[1] * l->n[0] + at[0];
}

/* The volume of a bundle's part of the domain, m3: the last ones may be narrower. */
static double volume_of(const struct bundles *l, int i) {
    const int at[2] = {i % l->n[0], i / l->n[0]};
    double volume = l->length;
    for (int k = 0; k < 2; k++) volume *= fmin(l->width[k], l->cross[k] - at[k] * l->width[k]);
    return volume;
}

static void measure_along(const struct run *r, int c, const uint8_t *is_deep, float *part) {
    const struct bundles l = bundles_along(r, c);
    const int n = l.n[0] * l.n[1];
    double *deep = memory_new(MEMORY_COUPLING, (size_t)n, sizeof *deep),
           *shallow = memory_new(MEMORY_COUPLING, (size_t)n, sizeof *shallow);
    for (int h = 0; h < r->solid->n; h++) {
        const int i = bundle_of(&l, r, h);
        if (i >= 0) (is_deep[h] ? deep : shallow)[i] += r->solid->volume[h];
    }
    par_sum_array(deep, n);
    par_sum_array(shallow, n);
    for (int h = 0; h < r->solid->n; h++) {
        const int i = bundle_of(&l, r, h);
        if (i < 0 || shallow[i] == 0) continue;
        part[h] = fmaxf(part[h], (float)fmin(1, deep[i] / volume_of(&l, i)));
    }
    MEMORY_FREE(deep, shallow);
}

void inner_lines_measure(const struct run *r, const uint8_t *is_deep, float *part) {
    for (int h = 0; h < r->solid->n; h++) part[h] = 0;
    for (int c = 0; c < 3; c++)
        if (is_free(r, c)) measure_along(r, c, is_deep, part);
}
