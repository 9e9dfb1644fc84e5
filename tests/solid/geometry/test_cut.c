/* Which bonds initial cracks cut, in a plate and in space, and the length of a crack inside a plate. */
#include "base/memory.h"
#include "base/par.h"
#include "tests/solid/outline_shapes.h"
#include "solid/geometry/cut.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>

static int cuts(const double (*point)[3], int points, const double a[2], const double b[2]) {
    const double origin[2] = {0, 0};
    const struct solid_cut cut = {points, point};
    struct solid_cut_line *line = solid_cut_line_new(&cut, origin, 1);
    const int one = solid_cut_line_crosses(line, a, b), other = solid_cut_line_crosses(line, b, a);
    solid_cut_line_free(line);
    assert_int_equal(one, other);
    return one;
}

static void test_bonds(void **state) {
    (void)state;
    const double along[2][3] = {{0, 2}, {4, 2}}, bent[3][3] = {{0, 2}, {2, 2}, {4, 3}};
    const struct {
        double a[2], b[2];
        int along, bent;
    } bond[] = {
        {{1.5, 1.5}, {1.5, 2.5}, 1, 1}, /* across */
        {{1.5, 1.5}, {2.5, 1.5}, 0, 0}, /* beside */
        {{3.5, 3.5}, {3.5, 2.5}, 0, 1},
        {{4, 1.5}, {4, 2.5}, 1, 0},       /* through the tip */
        {{4.25, 1.5}, {4.25, 3.5}, 0, 0}, /* past it */
        {{3.5, 2.5}, {4.5, 1.5}, 1, 0},   /* across the tip */
        {{3.5, 2.5 + 0x1p-32}, {4.5, 1.5 + 0x1p-32}, 0, 0},
        {{3.5, 2.5 - 0x1p-32}, {4.5, 1.5 - 0x1p-32}, 1, 0},
        {{1, 2}, {1, 3}, 1, 1}, /* ends on it */
        {{1, 2 + 0x1p-32}, {1, 3}, 0, 0},
        {{1, 2}, {2, 2}, 1, 1}, /* in it */
        {{4, 2}, {5, 2}, 1, 0}, /* begins at its end, in line */
        {{4 + 0x1p-32, 2}, {5, 2}, 0, 0},
        {{-2, 2}, {-1, 2}, 0, 0},
        {{1.5, 3}, {2.5, 1}, 1, 1}, /* through the kink */
    };
    const double nearly[2][3] = {{0, 2 + 1e-8}, {4, 2 + 1e-8}}, off[2][3] = {{0, 2 + 1e-6}, {4, 2 + 1e-6}};
    assert_true(cuts(nearly, 2, bond[10].a, (const double[2]){1, 1}));
    assert_true(!cuts(off, 2, bond[10].a, (const double[2]){1, 1}));
    for (size_t k = 0; k < sizeof bond / sizeof bond[0]; k++) {
        assert_int_equal(cuts(along, 2, bond[k].a, bond[k].b), bond[k].along);
        assert_int_equal(cuts(bent, 3, bond[k].a, bond[k].b), bond[k].bent);
    }
}

/* Between two rows a crack of ten particles' length cuts the bonds across; through a row, all of the row's too. A
 * lattice whose lines are at multiples of a tenth decides as one of whole numbers does. */
static void test_rows(void **state) {
    (void)state;
    const double origin[2] = {-0.3, 0.7}, spacing = 0.1, ten[2][3] = {{0, 1.2}, {1.0, 1.2}},
                 row[2][3] = {{0, 1.25}, {1.0, 1.25}};
    const struct solid_cut between = {2, ten}, through = {2, row};
    struct solid_cut_line *line[2] = {solid_cut_line_new(&between, origin, spacing),
                                      solid_cut_line_new(&through, origin, spacing)};
    int cut[2] = {0, 0}, flat[2] = {0, 0};
    for (int j = 0; j < 12; j++)
        for (int i = 0; i < 20; i++) {
            const double a[2] = {i + 0.5, j + 0.5}, up[2] = {i + 0.5, j + 1.5}, right[2] = {i + 1.5, j + 0.5};
            for (int k = 0; k < 2; k++) {
                cut[k] += solid_cut_line_crosses(line[k], a, up);
                flat[k] += solid_cut_line_crosses(line[k], a, right);
            }
        }
    assert_int_equal(cut[0], 10); /* i = 3 .. 12 are between x = 0 and 1 */
    assert_int_equal(flat[0], 0);
    assert_int_equal(cut[1], 20); /* above and below the row */
    assert_int_equal(flat[1], 11);
    for (int k = 0; k < 2; k++) solid_cut_line_free(line[k]);
    assert_int_equal(memory_bytes(MEMORY_SOLID), 0);
}

/* The mirror image of a bond meets the mirror image of the crack, to the last digit. */
static void test_mirror(void **state) {
    (void)state;
    int met = 0;
    for (int trial = 0; trial < 20000; trial++) {
        double point[4][3] = {{0}}, image[4][3] = {{0}}, a[2], b[2], c[2], d[2];
        for (int k = 0; k < 4; k++)
            for (int x = 0; x < 2; x++) {
                point[k][x] = rint(uniform(0, 8 << 20)) * 0x1p-20;
                image[k][x] = x ? 40 - point[k][x] : point[k][x];
            }
        for (int x = 0; x < 2; x++) {
            a[x] = trial % 3 ? rint(uniform(0, 8)) + 0.5 : point[1][x];
            b[x] = trial % 2 ? a[x] + (x ? 1 : 0) : rint(uniform(0, 8)) + 0.5;
            c[x] = x ? 40 - a[x] : a[x];
            d[x] = x ? 40 - b[x] : b[x];
        }
        const int one = cuts(point, 4, a, b);
        assert_int_equal(one, cuts(image, 4, c, d));
        assert_true(one || trial % 3); /* an end on the crack */
        met += one;
    }
    check_between(met, 5000, 19000);
}

static void test_plane(void **state) {
    (void)state;
    /* a unit square, turned about the z axis by 30 degrees, in a plane x' = 1 */
    const double c = sqrt(3) / 2, s = 0.5;
    double corner[4][3];
    const double flat[4][3] = {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}};
    const struct {
        double a[3], b[3];
        int meets;
    } bond[] = {{{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}, 1},
                {{0.5, 0.5, 0.5}, {0.9, 0.5, 0.5}, 0},
                {{0.5, 0.5, 0.5}, {1, 0.5, 0.5}, 1},
                {{0.5, 1.5, 0.5}, {1.5, 1.5, 0.5}, 0},
                {{0.5, 1, 0.5}, {1.5, 1, 0.5}, 1},
                {{0.5, 1 + 1e-9, 0.5}, {1.5, 1 + 1e-9, 0.5}, 0},
                {{0, 0, 0}, {2, 2, 2}, 1},
                {{0, 0, -0.5}, {2, 1, 3.5}, 0},
                {{1, -1, 0.5}, {1, 2, 0.5}, 1},
                {{1, -1, 0.5}, {1, -0.1, 0.5}, 0},
                {{1, 0.2, 0.2}, {1, 0.3, 0.7}, 1},
                {{1, -0.5, 0.4}, {1, 0.5, -0.6}, 0},
                {{1.1, 0.5, 0.5}, {1.1, 0.6, 0.5}, 0},
                {{0.9, -0.05, 0.5}, {1.1, 0.04, 0.5}, 0},
                {{0.9, -0.05, 0.5}, {1.1, 0.06, 0.5}, 1}};
    for (int k = 0; k < 4; k++) {
        corner[k][0] = c * flat[k][0] - s * flat[k][1];
        corner[k][1] = s * flat[k][0] + c * flat[k][1];
        corner[k][2] = flat[k][2];
    }
    for (size_t k = 0; k < sizeof bond / sizeof bond[0]; k++) {
        const double *p = bond[k].a, *q = bond[k].b;
        const double a[3] = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]},
                     b[3] = {c * q[0] - s * q[1], s * q[0] + c * q[1], q[2]};
        assert_int_equal(solid_cut_plane_crosses(corner, a, b, 1e-3), bond[k].meets);
        assert_int_equal(solid_cut_plane_crosses(corner, b, a, 1e-3), bond[k].meets);
        assert_int_equal(solid_cut_plane_crosses(flat, p, q, 1e-3), bond[k].meets);
    }
}

static void refuses(int points, int dim, const double (*point)[3], const char *sentence) {
    const struct solid_cut cut = {points, point};
    char text[200] = "";
    assert_int_equal(solid_cut_fault(&cut, dim, text, sizeof text), sentence != NULL);
    assert_string_equal(text, sentence ? sentence : "");
}

static void test_faults(void **state) {
    (void)state;
    const double square[4][3] = {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}},
                 warped[4][3] = {{0}, {2, 0}, {2, 2, 1e-3}, {0, 2}}, swapped[4][3] = {{0}, {2, 0}, {0, 2}, {2, 2}},
                 dented[4][3] = {{0}, {2, 0}, {0.5, 0.5}, {0, 2}}, flat[4][3] = {{0}, {1, 0}, {2, 0}, {3, 0}},
                 twice[3][3] = {{0}, {1, 2, 3}, {1, 2, 4}};
    refuses(1, 2, square, "a crack needs at least 2 points");
    refuses(3, 2, twice, "points 2 and 3 of the crack are the same");
    refuses(2, 2, twice, NULL);
    refuses(3, 3, twice, "a crack in three dimensions has 4 corners, not 3");
    refuses(4, 3, square, NULL);
    refuses(4, 3, swapped, "the corners of the crack are not those of a convex quadrilateral, in order");
    refuses(4, 3, dented, "the corners of the crack are not those of a convex quadrilateral, in order");
    refuses(4, 3, flat, "the corners of the crack are not those of a convex quadrilateral, in order");
    refuses(4, 3, warped, "corner 2 of the crack is not in the plane of the others");
}

static void test_length_inside(void **state) {
    (void)state;
    struct shape s = {0};
    shape_box(&s, 0, 0, 0, 4, 4);
    shape_disc(&s, 1, 2, 2, 1, 1);
    const double through[2][3] = {{-1, 2}, {5, 2}}, bent[4][3] = {{1.5, 2}, {2.5, 2}, {2.5, 6}, {-1, 6}},
                 outside[3][3] = {{-1, -1}, {-1, 9}, {9, 9}}, rim[2][3] = {{0, -1}, {0, 5}},
                 tangent[2][3] = {{-1, 1}, {5, 1}}, in_hole[2][3] = {{1.5, 2}, {2.5, 2.5}};
    const struct {
        struct solid_cut cut;
        double length;
    } crack[] = {{{2, through}, 2}, {{4, bent}, 2 - sqrt(0.75)}, {{3, outside}, 0},
                 {{2, rim}, 4},     {{2, tangent}, 4},           {{2, in_hole}, 0}};
    for (size_t k = 0; k < sizeof crack / sizeof crack[0]; k++)
        check_close(solid_outline_length_inside(s.outline, s.n, &crack[k].cut, 0.1), crack[k].length, 1e-9);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    srand(1);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_bonds),  cmocka_unit_test(test_rows),
                                       cmocka_unit_test(test_mirror), cmocka_unit_test(test_plane),
                                       cmocka_unit_test(test_faults), cmocka_unit_test(test_length_inside)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
