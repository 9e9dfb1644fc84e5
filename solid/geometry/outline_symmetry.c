/* Makes the areas and edge lengths of mirror-image particles equal to the bit. */
#include "solid/geometry/outline.h"

#include <math.h>

/* Areas and lengths that differ by less are made equal, in cells and spacings. */
static const double EQUAL = 1e-9;

/* The particle at the mirror image of k about the box's middle, along x (c = 0) or y; -1: none. */
static long image_of(const struct solid_outline_cells *cells, int c, long k) {
    const struct solid_outline_cell *at = &cells->cell[k];
    return solid_outline_cells_at(cells, c == 0 ? cells->low[0] + cells->high[0] - at->i : at->i,
                                  c == 1 ? cells->low[1] + cells->high[1] - at->j : at->j);
}

static int is_symmetric(const struct solid_outline_cells *cells, int c) {
    for (long k = 0; k < cells->n; k++) {
        const long image = image_of(cells, c, k);
        if (image < 0 || fabs(cells->cell[k].area - cells->cell[image].area) > EQUAL) return 0;
    }
    return 1;
}

/* The mean of two values, and the mean of two such means, do not depend on the order: four mirror images become equal
 * as well. */
void solid_outline_symmetry_cells(struct solid_outline_cells *cells) {
    for (int c = 0; c < 2; c++) {
        if (!is_symmetric(cells, c)) continue;
        for (long k = 0; k < cells->n; k++) {
            const long image = image_of(cells, c, k);
            if (image < k) continue;
            const double mean = 0.5 * (cells->cell[k].area + cells->cell[image].area);
            cells->cell[k].area = cells->cell[image].area = mean;
        }
    }
}

/* The length of a particle, or NULL. */
static struct solid_outline_share *share_of(const struct solid_outline_lengths *lengths, long cell) {
    long from = 0, to = lengths->n - 1;
    while (from <= to) {
        const long middle = (from + to) / 2;
        if (lengths->share[middle].cell == cell) return &lengths->share[middle];
        if (lengths->share[middle].cell < cell)
            from = middle + 1;
        else
            to = middle - 1;
    }
    return NULL;
}

static int are_images(const struct solid_outline_cells *cells, int c, double tolerance,
                      const struct solid_outline_lengths *a, const struct solid_outline_lengths *b) {
    if (a->n != b->n) return 0;
    for (long k = 0; k < a->n; k++) {
        const long image = image_of(cells, c, a->share[k].cell);
        const struct solid_outline_share *other = image < 0 ? NULL : share_of(b, image);
        if (!other || fabs(a->share[k].length - other->length) > tolerance) return 0;
    }
    return 1;
}

void solid_outline_symmetry_lengths(const struct solid_outline_cells *cells, double spacing,
                                    struct solid_outline_lengths *const *lengths, int count) {
    for (int c = 0; c < 2; c++) {
        if (!is_symmetric(cells, c)) continue;
        for (int l = 0; l < count; l++)
            for (int m = l; m < count; m++) {
                if (!are_images(cells, c, EQUAL * spacing, lengths[l], lengths[m])) continue;
                for (long k = 0; k < lengths[l]->n; k++) {
                    struct solid_outline_share *one = &lengths[l]->share[k],
                                               *other = share_of(lengths[m], image_of(cells, c, one->cell));
                    one->length = other->length = 0.5 * (one->length + other->length);
                }
            }
    }
}
