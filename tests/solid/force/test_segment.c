/* Every kernel of a segment against the sum over the bonds, in a lattice with broken bonds. */
#include "solid/bonds/lattice.h"
#include "solid/bonds/row.h"
#include "solid/bonds/segments.h"
#include "solid/force/segment.h"
#include "tests/solid/make.h"
#include "tests/check.h"

#include <stdlib.h>

/* k_d, about a tenth of the elastic forces at the speeds below. */
static double k_d(void) { return 0.1 * YOUNG / (SPACING * SPACING * SPACING * SPACING); }

/* Bond forces on h over the density by eq. 3.20 and the pairwise damping, its power, and the largest and least eps. */
static void by_hand(const struct solid *s, int h, int damped, double a[3], double *power, struct solid_range *range) {
    static struct solid_family_view view;
    solid_family_view(s, h, &view);
    a[0] = a[1] = a[2] = 0;
    for (int b = 0; b < view.n; b++) {
        double zeta[3], xi2 = 0, zeta2 = 0, closing = 0;
        if (!view.intact[b]) continue;
        for (int c = 0; c < 3; c++) {
            zeta[c] = view.xi[b][c] + s->d[c][view.l[b]] - s->d[c][h];
            xi2 += view.xi[b][c] * view.xi[b][c];
            zeta2 += zeta[c] * zeta[c];
            closing += (s->v[c][view.l[b]] - s->v[c][h]) * zeta[c];
        }
        const double stretch = sqrt(zeta2 / xi2) - 1, eps = zeta2 / xi2 - 1;
        const double elastic = view.alpha[b] * view.micro[b] * stretch / sqrt(zeta2),
                     viscous = damped ? k_d() * closing / (xi2 * (1 + eps)) : 0;
        for (int c = 0; c < 3; c++) a[c] += (elastic + viscous) * view.weight[b] * zeta[c] / DENSITY;
        *power += viscous * view.weight[b] * closing / DENSITY;
        range->high = fmax(range->high, eps);
        range->low = fmin(range->low, eps);
    }
}

/* A kernel over all segments: a [3][n], power, and the range of eps. */
static struct solid_range by_kernel(const struct solid *s, enum solid_kernel kernel, double *a, double *power) {
    const struct solid_lattice *t = s->family->lattice[0];
    const size_t length = (size_t)t->places + 8;
    struct solid_lattice_offset *offset = malloc((size_t)t->stencil->n * sizeof *offset);
    struct solid_boxes boxes = {.w = t->w, .offset = offset};
    struct solid_range range = {0, 0};
    for (int o = 0; o < t->stencil->n; o++) {
        offset[o] = t->offset[o];
        offset[o].viscous *= k_d();
    }
    solid_row_begin(s, t);
    for (int c = 0; c < 3; c++) {
        for (int i = 0; i < t->copies; i++) t->v[c][t->copy_at[i]] = s->v[c][t->copy_local[i]];
        memset(t->f[c], 0, length * sizeof(double));
        boxes.d[c] = t->d[c];
        boxes.v[c] = t->v[c];
        boxes.a[c] = t->f[c];
    }
    for (int g = 0; g < t->segments->n; g++) {
        if (t->segments->stale[g]) solid_segments_pack(t, g);
        const struct solid_range here = solid_segment_force(&boxes, t->segments, g, kernel, power);
        range.high = fmax(range.high, here.high);
        range.low = fmin(range.low, here.low);
    }
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < s->n; h++) a[c * s->n + h] = t->f[c][solid_lattice_place(t, t->cell[h])];
    free(offset);
    return range;
}

/* Without surface correction all kernels hold, with it those that are not for the bulk; with the short series if the
 * strains are small, exact ones at any: at those of the long series, of square roots, and of both in one segment. */
static void against_the_sum(void **state) {
    (void)state;
    const double size[] = {1e-4, 2e-3, 0.01, 0.1}; /* of the displacements, in spacings */
    for (int large = 0; large < 4; large++)
        for (int corrected = 0; corrected < 2; corrected++) {
            struct solid *s =
                make((struct make){.sites = {11, 6, 5}, .periodic = {0, 1, 0}, .uncorrected = !corrected});
            double *a = malloc(3 * (size_t)s->n * sizeof *a);
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < 3; c++) {
                    s->d[c][h] = size[large] * SPACING * noise(s, h, c);
                    s->v[c][h] = (large ? 1e-3 : 1e-6) * noise(s, h, c + 3);
                }
            for (int h = 0; h < s->n; h += 5) solid_family_break(s, h, h % 40);
            for (int kernel = 0; kernel < KERNEL_STRETCH_ONLY; kernel++) {
                if ((large && !(kernel & KERNEL_EXACT)) || (corrected && kernel & KERNEL_BULK)) continue;
                double power = 0, expected = 0, most = 0;
                struct solid_range range = {0, 0};
                const struct solid_range found = by_kernel(s, (enum solid_kernel)kernel, a, &power);
                for (int k = 0; k < 3 * s->n; k++) most = check_worst(most, a[k]);
                for (int h = 0; h < s->n; h++) {
                    double force[3];
                    by_hand(s, h, kernel & KERNEL_DAMPED, force, &expected, &range);
                    for (int c = 0; c < 3; c++) check_close(a[c * s->n + h], force[c], (large ? 1e-12 : 1e-10) * most);
                }
                check_relative(found.high, range.high, 1e-9);
                check_relative(found.low, range.low, 1e-9);
                if (kernel & KERNEL_DAMPED) check_relative(power, expected, 1e-9);
                if (!(kernel & KERNEL_DAMPED)) check_equal(power, 0);
            }
            free(a);
            solid_free(s);
        }
}

/* The kernel that judges finds the range of eps, and adds nothing to the accelerations or the power. In several states,
 * so that the extremes lie in wide and in narrow strips. */
static void judges(void **state) {
    (void)state;
    struct solid *s = make((struct make){.sites = {9, 5, 4}});
    double *a = malloc(3 * (size_t)s->n * sizeof *a), power = 0, none = 0, force[3];
    for (int trial = 0; trial < 16; trial++) {
        struct solid_range range = {0, 0};
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) s->d[c][h] = 0.02 * SPACING * noise(s, h, c + 3 * trial);
        const struct solid_range found = by_kernel(s, KERNEL_STRETCH_ONLY, a, &power);
        for (int h = 0; h < s->n; h++) by_hand(s, h, 0, force, &none, &range);
        check_relative(found.high, range.high, 1e-11);
        check_relative(found.low, range.low, 1e-11);
        for (int k = 0; k < 3 * s->n; k++) check_equal(a[k], 0);
        check_equal(power, 0);
    }
    free(a);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(against_the_sum), cmocka_unit_test(judges)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
