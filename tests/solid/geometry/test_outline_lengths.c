/* Boundary lengths shared out to particles: on and between lattice lines, along arcs. */
#include "base/memory.h"
#include "base/par.h"
#include "tests/solid/outline_shapes.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>

struct loaded {
    struct solid_outline_cells *cells;
    struct solid_outline_lengths *lengths;
    char text[200];
};

static void loaded_free(struct loaded *l) {
    solid_outline_cells_free(l->cells);
    solid_outline_lengths_free(l->lengths);
}

static struct loaded load(const struct shape *s, double x0, double y0, double spacing, const double from[2],
                          const double to[2]) {
    const double origin[2] = {x0, y0};
    struct loaded l = {.cells = solid_outline_cells(s->outline, s->n, origin, spacing)};
    l.lengths = solid_outline_lengths(s->outline, s->n, origin, spacing, l.cells, from, to, l.text, sizeof l.text);
    return l;
}

static double total(const struct solid_outline_lengths *l) {
    double sum = 0;
    assert_non_null(l);
    for (long k = 0; k < l->n; k++) {
        assert_true(k == 0 || l->share[k].cell > l->share[k - 1].cell);
        sum += l->share[k].length;
    }
    return sum;
}

static double at(const struct loaded *l, int i, int j) {
    for (long k = 0; k < l->lengths->n; k++) {
        const struct solid_outline_cell *cell = &l->cells->cell[l->lengths->share[k].cell];
        if (cell->i == i && cell->j == j) return l->lengths->share[k].length;
    }
    return 0;
}

/* A square of 4 x 4 cells of 1/2: the lattice's lines on its edges, and its points. */
static void test_square(void **state) {
    (void)state;
    struct shape s = {0};
    shape_box(&s, 0, 1, 1, 3, 3);
    const double corner[4][2] = {{1, 1}, {3, 1}, {3, 3}, {1, 3}};
    for (int side = 0; side < 8; side++) {
        const double *a = corner[side % 4], *b = corner[(side + 1) % 4];
        struct loaded l = load(&s, 0, 0, 0.5, side < 4 ? a : b, side < 4 ? b : a); /* either way */
        assert_int_equal(l.lengths->n, 4);
        const int i = side % 4 == 1 ? 5 : side % 4 == 3 ? 2 : -1, j = side % 4 == 0 ? 2 : side % 4 == 2 ? 5 : -1;
        for (int k = 2; k < 6; k++) check_equal(at(&l, i < 0 ? k : i, j < 0 ? k : j), 0.5);
        loaded_free(&l);
    }
    /* points on the edges: five, and those at the ends have half */
    struct loaded l = load(&s, 0.25, 0.25, 0.5, corner[1], corner[2]);
    assert_int_equal(l.lengths->n, 5);
    for (int k = 0; k < 5; k++) check_equal(at(&l, 5, k + 1), k % 4 ? 0.5 : 0.25);
    loaded_free(&l);
    /* a part, from the middle of one cell to the middle of another */
    const double from[2] = {1.25, 3}, to[2] = {2.25, 3};
    l = load(&s, 0, 0, 0.5, from, to);
    assert_int_equal(l.lengths->n, 3);
    for (int k = 2; k < 5; k++) check_equal(at(&l, k, 5), k == 3 ? 0.5 : 0.25);
    loaded_free(&l);
    /* a strip that reaches 0.1 into the next cells: their particles are the ones below */
    s.n = 0;
    memset(s.outline, 0, sizeof s.outline);
    shape_box(&s, 0, 0, 0, 3, 1.1);
    const double top[2][2] = {{0, 1.1}, {3, 1.1}};
    l = load(&s, 0, 0, 1, top[0], top[1]);
    assert_int_equal(l.lengths->n, 3);
    for (int i = 0; i < 3; i++) check_close(at(&l, i, 0), 1, 1e-15);
    loaded_free(&l);
}

/* An L whose inner corner is in a cell without particle: its two arms have halves of it. */
static void test_halves(void **state) {
    (void)state;
    struct shape s = {0};
    shape_outline(&s, 0);
    const double corner[6][2] = {{0, 0}, {3, 0}, {3, 1.2}, {1.2, 1.2}, {1.2, 3}, {0, 3}};
    for (int k = 0; k < 6; k++) shape_corner(&s, corner[k][0], corner[k][1]);
    struct loaded l = load(&s, 0, 0, 1, corner[3], corner[4]);
    /* cell 1, 1 has 0.8 of the edge, and 0.36 of the area; its neighbours are 0, 1 and 1, 0 */
    assert_int_equal(l.lengths->n, 3);
    check_close(at(&l, 0, 1), 0.4, 1e-15);
    check_close(at(&l, 1, 0), 0.4, 1e-15);
    check_close(at(&l, 0, 2), 1, 1e-15);
    const struct solid_outline_cell *arm = &l.cells->cell[solid_outline_cells_at(l.cells, 1, 0)];
    check_close(arm->area, 1 + 0.18, 1e-15);
    loaded_free(&l);
}

/* Totals, on any lattice: straight edges in several parts, arcs, the arc with the body on the left. */
static void test_totals(void **state) {
    (void)state;
    for (int trial = 0; trial < 200; trial++) {
        struct shape s = {0};
        const double x = uniform(-2, 2), y = uniform(-2, 2), a = uniform(0, 7), c = cos(a), d = sin(a);
        const double spacing = uniform(0.01, 0.3), r = uniform(0.1, 1);
        shape_outline(&s, 0); /* a triangle with a corner in the middle of an edge */
        const double corner[4][2] = {{x, y}, {x + c / 3, y + d / 3}, {x + c, y + d}, {x - d, y + c}};
        for (int k = 0; k < 4; k++) shape_corner(&s, corner[k][0], corner[k][1]);
        const double part[2] = {x + c * 0.8, y + d * 0.8};
        struct loaded l = load(&s, uniform(-1, 1), uniform(-1, 1), spacing, corner[0], part);
        check_relative(total(l.lengths), 0.8, 1e-12);
        loaded_free(&l);
        l = load(&s, uniform(-1, 1), uniform(-1, 1), spacing, corner[2], corner[3]);
        check_relative(total(l.lengths), sqrt(2), 1e-12);
        loaded_free(&l);

        shape_disc(&s, 0, x + 9, y, r, trial % 2 ? 1 : -1);
        shape_disc(&s, 1, x + 9, y, r / 2, 1);
        const double phi = uniform(-1.5, 1.5), half = uniform(0.01, 1.5);
        const double one[2] = {x + 9 + r * cos(M_PI / 2 + phi), y + r * sin(M_PI / 2 + phi)},
                     other[2] = {x + 9 + r * cos(M_PI / 2 + phi * half / 1.5),
                                 y + r * sin(M_PI / 2 + phi * half / 1.5)};
        l = load(&s, uniform(-1, 1), uniform(-1, 1), spacing, one, other);
        check_relative(total(l.lengths), r * fabs(phi - phi * half / 1.5), 1e-9); /* of the points given */
        loaded_free(&l);
        /* a diameter: upper half and lower half of the disc, by the sense; the hole's the other way */
        const double left[2] = {x + 9 - r, y}, right[2] = {x + 9 + r, y};
        l = load(&s, 0, 0, spacing, trial % 4 < 2 ? left : right, trial % 4 < 2 ? right : left);
        check_relative(total(l.lengths), M_PI * r, 1e-12);
        double moment = 0;
        for (long k = 0; k < l.lengths->n; k++)
            moment += l.lengths->share[k].length * ((l.cells->cell[l.lengths->share[k].cell].j + 0.5) * spacing - y);
        if (spacing < r / 3) check_below(trial % 4 < 2 ? moment : -moment, 0);
        loaded_free(&l);
    }
    assert_int_equal(memory_bytes(MEMORY_SOLID), 0);
}

static void test_no_boundary(void **state) {
    (void)state;
    struct shape s = {0};
    shape_outline(&s, 0); /* a square with a notch in its lower edge, and a half disc on the right */
    const double corner[8][2] = {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 0}, {4, 0}, {4, 3}, {0, 3}};
    for (int k = 0; k < 8; k++) {
        shape_corner(&s, corner[k][0], corner[k][1]);
        if (k == 5) shape_arc(&s, 4, 1.5, 1);
    }
    const struct {
        double from[2], to[2];
        const char *text;
    } wrong[] = {
        {{0, 0}, {4, 0}, "the boundary does not run straight, or in one arc, from (0, 0) to (4, 0)"},
        {{0, 0}, {1, 0.01}, "the boundary does not run straight, or in one arc, from (0, 0) to (1, 0.01)"},
        {{0, -1}, {0, 3}, "the boundary does not run straight, or in one arc, from (0, -1) to (0, 3)"},
        {{0, 0}, {0.5, 3}, "the boundary does not run straight, or in one arc, from (0, 0) to (0.5, 3)"},
        {{4, 0}, {5.5, 1.6}, "the boundary does not run straight, or in one arc, from (4, 0) to (5.5, 1.6)"},
        {{1, 0}, {1, 0}, "from (1, 0) to (1, 0) is not a part of the boundary"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++) {
        struct loaded l = load(&s, 0, 0, 0.1, wrong[k].from, wrong[k].to);
        assert_null(l.lengths);
        assert_string_equal(l.text, wrong[k].text);
        loaded_free(&l);
    }
    const double arc[2][2] = {{4, 3}, {5.5, 1.5}}, almost[2][2] = {{0, 5e-8}, {1 + 5e-8, 0}};
    struct loaded l = load(&s, 0, 0, 0.1, arc[0], arc[1]);
    check_close(total(l.lengths), M_PI * 0.75, 1e-12);
    loaded_free(&l);
    l = load(&s, 0, 0, 0.1, almost[0], almost[1]);
    check_close(total(l.lengths), 1, 1e-12);
    loaded_free(&l);
}

/* Loads on opposite edges of a plate that rounding has put askew: mirror images to the bit. */
static void test_symmetrise(void **state) {
    (void)state;
    for (int trial = 0; trial < 40; trial++) {
        struct shape s = {0};
        const double x = uniform(-9, 9), y = uniform(-9, 9), spacing = 2. / (trial % 2 ? 41 : 40);
        shape_box(&s, 0, x - 1, y - 0.7, x + 1, y + 0.7);
        const double origin[2] = {x - 1, y - 1};
        const double corner[4][2] = {{x - 1, y - 0.7}, {x + 1, y - 0.7}, {x + 1, y + 0.7}, {x - 1, y + 0.7}};
        struct solid_outline_cells *cells = solid_outline_cells(s.outline, s.n, origin, spacing);
        struct solid_outline_lengths *l[4];
        char text[200];
        for (int k = 0; k < 4; k++)
            l[k] = solid_outline_lengths(s.outline, s.n, origin, spacing, cells, corner[k], corner[(k + 1) % 4], text,
                                         sizeof text);
        solid_outline_symmetry_lengths(cells, spacing, l, 4);
        for (int k = 0; k < 4; k++) {
            check_relative(total(l[k]), k % 2 ? 1.4 : 2, 1e-12);
            assert_int_equal(l[k]->n, l[(k + 2) % 4]->n);
            for (long m = 0; m < l[k]->n; m++) {
                const long half = l[k]->n - 1 - m;
                check_equal(l[k]->share[m].length, l[(k + 2) % 4]->share[m].length);
                check_equal(l[k]->share[m].length, l[k]->share[half].length);
            }
        }
        for (int k = 0; k < 4; k++) solid_outline_lengths_free(l[k]);
        solid_outline_cells_free(cells);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    srand(1);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_square), cmocka_unit_test(test_halves),
                                       cmocka_unit_test(test_totals), cmocka_unit_test(test_no_boundary),
                                       cmocka_unit_test(test_symmetrise)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
