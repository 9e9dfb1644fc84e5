/* Opening of random and simple images against its definition, box by box. */
#include "base/par.h"
#include "solid/voxels/opening.h"
#include "tests/check.h"

#include <stdlib.h>

static int is_of(const struct solid_voxels *v, int phase, const int low[3], const int edge[3]) {
    for (int k = low[2]; k < low[2] + edge[2]; k++)
        for (int j = low[1]; j < low[1] + edge[1]; j++)
            for (int i = low[0]; i < low[0] + edge[0]; i++)
                if (solid_voxels_is(v, v->bits, i, j, k) != phase) return 0;
    return 1;
}

static long thin_of(const struct solid_voxels *v, int phase, const int edge[3]) {
    const int *n = v->n;
    uint8_t *thick = calloc((size_t)n[0] * (size_t)n[1] * (size_t)n[2], 1);
    long thin = 0;
    for (int k = 0; k + edge[2] <= n[2]; k++)
        for (int j = 0; j + edge[1] <= n[1]; j++)
            for (int i = 0; i + edge[0] <= n[0]; i++) {
                if (!is_of(v, phase, (const int[3]){i, j, k}, edge)) continue;
                for (int q = 0; q < edge[0] * edge[1] * edge[2]; q++)
                    thick[((size_t)(k + q / edge[0] / edge[1]) * (size_t)n[1] + (size_t)(j + q / edge[0] % edge[1])) *
                              (size_t)n[0] +
                          (size_t)(i + q % edge[0])] = 1;
            }
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++)
                thin += solid_voxels_is(v, v->bits, i, j, k) == phase &&
                        !thick[((size_t)k * (size_t)n[1] + (size_t)j) * (size_t)n[0] + (size_t)i];
    free(thick);
    return thin;
}

static void random_images(void **state) {
    (void)state;
    static const int size[][3] = {{9, 8, 7}, {64, 5, 6}, {66, 6, 5}, {130, 4, 4},
                                  {2, 9, 9}, {9, 2, 9},  {9, 9, 2},  {1, 1, 1}};
    srand(3);
    for (size_t s = 0; s < sizeof size / sizeof *size; s++)
        for (int percent = 5; percent <= 95; percent += 15)
            for (int e = 0; e < 7; e++) {
                static const int box[][3] = {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4},
                                             {3, 1, 2}, {1, 4, 2}, {2, 3, 1}};
                const int *edge = box[e];
                struct solid_voxels *v = solid_voxels_new(size[s], NULL, (const int[3]){0, 0, 0});
                for (int k = 0; k < v->n[2]; k++)
                    for (int j = 0; j < v->n[1]; j++)
                        for (int i = 0; i < v->n[0]; i++)
                            if (rand() % 100 < percent) solid_voxels_set(v, v->bits, i, j, k);
                for (int phase = 0; phase < 2; phase++)
                    check_equal(solid_opening_thin(v, phase, edge), thin_of(v, phase, edge));
                solid_voxels_free(v);
            }
}

/* A slab two voxels thick is thin, one of three is not, wherever it lies and across words. */
static void slabs(void **state) {
    (void)state;
    for (int from = 0; from < 90; from += 7)
        for (int thick = 1; thick <= 4; thick++) {
            struct solid_voxels *v = solid_voxels_new((const int[3]){100, 4, 5}, NULL, (const int[3]){0, 0, 0});
            for (int q = 0; q < 20 * thick; q++)
                solid_voxels_set(v, v->bits, from + q % thick, q / thick % 4, q / thick / 4);
            check_equal(solid_opening_thin(v, 1, (const int[]){3, 3, 3}), thick < 3 ? 20 * thick : 0);
            solid_voxels_free(v);
        }
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_images), cmocka_unit_test(slabs)};
    par_begin(&argc, &argv);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
