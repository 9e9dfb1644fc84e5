/* Voxels of each kind and faces between two kinds, against counts voxel by voxel; the planes of bits. */
#include "base/par.h"
#include "solid/voxels/borders.h"
#include "tests/check.h"

static int kind_at(int i, int j, int k, int kinds) { /* -1: pore */
    const unsigned q = (unsigned)((k * 31 + j) * 37 + i + 7) * 2654435761u >> 8;
    return q % 5 == 0 ? -1 : (int)(q / 5 % (unsigned)kinds);
}

static void counts(void **state) {
    (void)state;
    static const int size[][3] = {{130, 5, 6}, {64, 7, 3}, {63, 4, 4}, {1, 9, 9}, {65, 1, 8}};
    for (size_t t = 0; t < sizeof size / sizeof *size; t++)
        for (int kinds = 1; kinds <= 1 << SOLID_VOXELS_PLANES; kinds++) {
            const int *n = size[t];
            struct solid_voxels *v = solid_voxels_new(n, NULL, (const int[]){0, 0, 0});
            long count[1 << SOLID_VOXELS_PLANES], expected[1 << SOLID_VOXELS_PLANES] = {0}, faces[3] = {0}, counted[3];
            solid_voxels_kinds(v, kinds);
            check_equal(1 << v->planes >= kinds && 1 << v->planes < 2 * kinds, 1);
            for (int k = 0; k < n[2]; k++)
                for (int j = 0; j < n[1]; j++)
                    for (int i = 0; i < n[0]; i++) {
                        const int here = kind_at(i, j, k, kinds),
                                  near[3] = {i + 1 < n[0] ? kind_at(i + 1, j, k, kinds) : -1,
                                             j + 1 < n[1] ? kind_at(i, j + 1, k, kinds) : -1,
                                             k + 1 < n[2] ? kind_at(i, j, k + 1, kinds) : -1};
                        if (here < 0) continue;
                        solid_voxels_set(v, v->bits, i, j, k);
                        solid_voxels_set_kind(v, here, i, j, k);
                        expected[here]++;
                        for (int c = 0; c < 3; c++) faces[c] += near[c] >= 0 && near[c] != here;
                    }
            solid_borders_count(v, count, counted);
            for (int c = 0; c < 3; c++) check_equal(counted[c], faces[c]);
            for (int q = 0; q < 1 << v->planes; q++) check_equal(count[q], expected[q]);
            for (int k = 0; k < n[2]; k++)
                for (int j = 0; j < n[1]; j++)
                    for (int i = 0; i < n[0]; i++)
                        if (kind_at(i, j, k, kinds) >= 0)
                            check_equal(solid_voxels_kind(v, i, j, k), kind_at(i, j, k, kinds));
            solid_voxels_free(v);
        }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(counts)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
