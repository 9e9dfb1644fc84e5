/* Outlines of plates: areas in squares, cells and particles. */
#include "base/memory.h"
#include "base/par.h"
#include "tests/solid/outline_shapes.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>

enum { KINDS = 7 };

/* A valid plate of each kind, about a metre large, at a random place. */
static void random_shape(struct shape *s, int kind) {
    char text[200];
    const double x = uniform(-3, 3), y = uniform(-3, 3);
    do {
        s->n = 0;
        switch (kind) {
        case 0:
            shape_star(s, 0, x, y, 1, 3 + rand() % 40, 0);
            break;
        case 1:
            shape_star(s, 0, x, y, 1, 3 + rand() % 20, 1);
            break;
        case 2:
            shape_comb(s, 1 + rand() % 12, uniform(0.01, 0.2), uniform(0.002, 0.1), 1);
            break;
        case 3: /* a ring with an island that has a hole */
            shape_disc(s, 0, x, y, 1, 1);
            shape_disc(s, 1, x + 0.05, y, 0.8, -1);
            shape_star(s, 0, x, y, 0.5, 9, 1);
            shape_disc(s, 1, x, y, 0.05, 1);
            break;
        case 4: /* pieces near each other, and holes */
            shape_star(s, 0, x, y, 0.5, 12, 1);
            shape_star(s, 0, x + 0.9, y, 0.5, 12, 0);
            shape_box(s, 0, x - 1, y + 0.6, x + 1, y + 0.7);
            shape_disc(s, 1, x + 0.1, y + 0.65, 0.03, 1);
            break;
        case 5: /* a bar, a needle and a shallow arc */
            shape_box(s, 0, x, y, x + 1, y + 0.02);
            shape_outline(s, 0);
            shape_corner(s, x, y + 0.1);
            shape_corner(s, x + 1, y + 0.11);
            shape_corner(s, x, y + 0.12);
            shape_outline(s, 0);
            shape_corner(s, x, y + 0.5);
            shape_arc(s, x + 0.5, y - 2e3, -1);
            shape_corner(s, x + 1, y + 0.5);
            break;
        default: /* rounded corners, three quarters of a disc */
            shape_outline(s, 0);
            shape_corner(s, x, y);
            shape_corner(s, x + 0.9, y);
            shape_arc(s, x + 0.9, y + 0.1, 1);
            shape_corner(s, x + 1, y + 0.1);
            shape_corner(s, x + 1, y + 1);
            shape_corner(s, x, y + 1);
            shape_outline(s, 0);
            shape_corner(s, x + 3, y);
            shape_arc(s, x + 3, y + 0.5, 1);
            shape_corner(s, x + 2.5, y + 0.5);
            shape_corner(s, x + 3, y + 0.5);
        }
    } while (solid_outline_fault(s->outline, s->n, text, sizeof text));
}

/* No edge is near: all cells about are inside. */
static int is_deep(const struct solid_outline_cells *cells, const struct solid_outline_cell *cell) {
    for (int dj = -2; dj <= 2; dj++)
        for (int di = -2; di <= 2; di++) {
            const long k = solid_outline_cells_at(cells, cell->i + di, cell->j + dj);
            if (k < 0 || !cells->cell[k].is_inside) return 0;
        }
    return 1;
}

static void test_total_area(void **state) {
    (void)state;
    for (int trial = 0; trial < 300; trial++) {
        struct shape s = {0};
        random_shape(&s, trial % KINDS);
        const double spacing = exp(uniform(log(0.004), log(0.5))), area = shape_area(&s);
        const double origin[2] = {uniform(-1, 1), uniform(-1, 1)};
        struct solid_outline_cells *cells = solid_outline_cells(s.outline, s.n, origin, spacing);
        long double sum = 0;
        for (long k = 0; k < cells->n; k++) {
            const double of_cell = cells->cell[k].area;
            sum += of_cell;
            check_at_least(of_cell, 1e-12);
            assert_true(of_cell == 1 || fabs(of_cell - 1) > 1e-12 || !is_deep(cells, &cells->cell[k]));
        }
        const double cells_area = (double)sum * spacing * spacing;
        if (fabs(cells_area / area - 1) > 1e-12 || fabs(solid_outline_area(s.outline, s.n) / area - 1) > 1e-12)
            fail_msg("kind %d, spacing %g: %.3g in cells, %.3g as a whole", trial % KINDS, spacing,
                     cells_area / area - 1, solid_outline_area(s.outline, s.n) / area - 1);
        solid_outline_cells_free(cells);
    }
    assert_int_equal(memory_bytes(MEMORY_SOLID), 0);
}

/* The rule of the header, cell by cell over a box, by other means. */
static void test_particles(void **state) {
    (void)state;
    enum { BOX = 40 };
    static double area[BOX][BOX];
    static char in[BOX][BOX];
    long alone = 0, halves = 0;
    for (int trial = 0; trial < 24; trial++) {
        struct shape s = {0};
        random_shape(&s, trial % KINDS);
        double low[2], high[2], given[BOX][BOX] = {{0}};
        solid_outline_bounds(s.outline, s.n, low, high);
        const double spacing = fmax(high[0] - low[0], high[1] - low[1]) / (BOX - 6) * uniform(1, 3);
        const double origin[2] = {low[0] - spacing * uniform(2, 3), low[1] - spacing * uniform(2, 3)};
        for (int j = 0; j < BOX; j++)
            for (int i = 0; i < BOX; i++) {
                const double x[2] = {origin[0] + (i + 0.5) * spacing, origin[1] + (j + 0.5) * spacing};
                area[j][i] = solid_outline_area_in(s.outline, s.n, x, spacing) / (spacing * spacing);
                in[j][i] = (char)solid_outline_contains(s.outline, s.n, x, spacing);
            }
        for (int j = 1; j < BOX - 1; j++)
            for (int i = 1; i < BOX - 1; i++) {
                const int side = in[j][i - 1] + in[j][i + 1] + in[j - 1][i] + in[j + 1][i];
                const int corner = in[j - 1][i - 1] + in[j - 1][i + 1] + in[j + 1][i - 1] + in[j + 1][i + 1];
                if (in[j][i] || side + corner == 0) given[j][i] += area[j][i];
                alone += !in[j][i] && side + corner == 0 && area[j][i] > 1e-12;
                if (in[j][i]) continue;
                halves += area[j][i] > 1e-12 && side > 1;
                for (int dj = -1; dj <= 1; dj++)
                    for (int di = -1; di <= 1; di++)
                        if (in[j + dj][i + di] && (side == 0 || di * dj == 0))
                            given[j + dj][i + di] += area[j][i] / (side ? side : corner);
            }
        struct solid_outline_cells *cells = solid_outline_cells(s.outline, s.n, origin, spacing);
        long particles = 0;
        for (int j = 0; j < BOX; j++)
            for (int i = 0; i < BOX; i++) {
                const long k = solid_outline_cells_at(cells, i, j);
                particles += k >= 0;
                check_close(k < 0 ? 0 : cells->cell[k].area, given[j][i], 2e-12);
                assert_true(k < 0 || (cells->cell[k].i == i && cells->cell[k].j == j));
            }
        assert_int_equal(particles, cells->n);
        for (long k = 1; k < cells->n; k++)
            assert_true(cells->cell[k].j > cells->cell[k - 1].j ||
                        (cells->cell[k].j == cells->cell[k - 1].j && cells->cell[k].i > cells->cell[k - 1].i));
        solid_outline_cells_free(cells);
    }
    check_above(alone, 20);
    check_above(halves, 20);
}

/* Small pieces away from the others, in no cell's middle: 1e-10 of a cell is a particle, 1e-14 is not. */
static void test_crumbs(void **state) {
    (void)state;
    struct shape s = {0};
    const double origin[2] = {0, 0};
    shape_box(&s, 0, 0, 0, 3, 3);
    shape_box(&s, 0, 6.1, 1.1, 6.10001, 1.10001);
    shape_box(&s, 0, 8.1, 1.1, 8.1000001, 1.1000001);
    struct solid_outline_cells *cells = solid_outline_cells(s.outline, s.n, origin, 1);
    assert_int_equal(cells->n, 10);
    const long crumb = solid_outline_cells_at(cells, 6, 1);
    check_at_least(crumb, 0);
    assert_false(cells->cell[crumb].is_inside);
    check_relative(cells->cell[crumb].area, 1e-10, 1e-9);
    for (long k = 0; k < cells->n; k++) assert_true(k == crumb || cells->cell[k].area == 1);
    solid_outline_cells_free(cells);
}

/* Sutherland and Hodgman (1974): a convex polygon cut off on one side after another. */
static double clipped(const double (*corner)[2], int n, const double low[2], const double high[2]) {
    double p[2][40][2];
    int now = 0;
    memcpy(p[0], corner, (size_t)n * sizeof *corner);
    for (int side = 0; side < 4; side++) {
        const int c = side / 2, keep_above = side % 2;
        const double line = keep_above ? low[c] : high[c];
        int kept = 0;
        for (int k = 0; k < n; k++) {
            const double *a = p[now][k], *b = p[now][(k + 1) % n];
            const int a_in = keep_above ? a[c] >= line : a[c] <= line, b_in = keep_above ? b[c] >= line : b[c] <= line;
            if (a_in) memcpy(p[!now][kept++], a, sizeof p[0][0]);
            if (a_in != b_in) {
                p[!now][kept][c] = line;
                p[!now][kept++][!c] = a[!c] + (line - a[c]) / (b[c] - a[c]) * (b[!c] - a[!c]);
            }
        }
        n = kept;
        now = !now;
    }
    double area = 0;
    for (int k = 0; k < n; k++) {
        const double *a = p[now][k], *b = p[now][(k + 1) % n];
        area += ((a[0] - low[0]) * (b[1] - low[1]) - (b[0] - low[0]) * (a[1] - low[1])) / 2;
    }
    return fabs(area);
}

static void test_area_in_square(void **state) {
    (void)state;
    for (int trial = 0; trial < 3000; trial++) {
        struct shape s = {0};
        shape_outline(&s, 0);
        const int n = 3 + rand() % 9;
        for (int k = 0; k < n; k++) {
            const double a = 2 * M_PI * (k + uniform(0, 0.9)) / n * (trial % 2 ? 1 : -1);
            shape_corner(&s, 2 * cos(a), 2 * sin(a)); /* on a circle: convex */
        }
        const double side = uniform(0.05, 3), centre[2] = {uniform(-2, 2), uniform(-2, 2)};
        const double low[2] = {centre[0] - side / 2, centre[1] - side / 2},
                     high[2] = {centre[0] + side / 2, centre[1] + side / 2};
        const double area = solid_outline_area_in(s.outline, 1, centre, side);
        check_close(area, clipped(s.outline[0].corner, n, low, high), 1e-13);
    }
    /* a disc of radius 1: a quarter; a square within; one that the rim cuts in x = sqrt(1 - 1/4); one that it only
     * bulges into */
    struct shape disc = {0};
    shape_disc(&disc, 0, 5, 7, 1, -1);
    const double quarter[2] = {6, 8}, within[2] = {5, 7}, right[2] = {6, 7}, bulge[2] = {6.4, 7};
    check_close(solid_outline_area_in(disc.outline, 1, quarter, 2), M_PI / 4, 1e-14);
    check_close(solid_outline_area_in(disc.outline, 1, within, 1.4), 1.96, 1e-14);
    check_close(solid_outline_area_in(disc.outline, 1, right, 1), sqrt(3) / 4 + M_PI / 6 - 0.5, 1e-14);
    const double phi = 2 * acos(0.9);
    check_close(solid_outline_area_in(disc.outline, 1, bulge, 1), (phi - sin(phi)) / 2, 1e-14);
    /* an L about its inner corner, whose boundary runs through the middle of the square: three quarters */
    struct shape l = {0};
    shape_outline(&l, 0);
    const double corner[6][2] = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, inner[2] = {1, 1};
    for (int k = 0; k < 6; k++) shape_corner(&l, corner[k][0], corner[k][1]);
    check_equal(solid_outline_area_in(l.outline, 1, inner, 1), 0.75);
}

/* Corners on the lattice's lines, nodes and points, so that edges run along all of them. */
static void test_aligned(void **state) {
    (void)state;
    int valid = 0;
    for (int trial = 0; trial < 600; trial++) {
        struct shape s = {0};
        char text[200];
        shape_star(&s, 0, 0, 0, uniform(3, 12), 3 + rand() % 14, 0);
        const double step = trial % 3 ? 0.5 : 1, off = trial % 2 ? 3e-10 : 0, origin[2] = {off - 3, -7 - off};
        for (int k = 0; k < s.outline[0].corners; k++)
            for (int c = 0; c < 2; c++) s.corner[0][k][c] = step * rint(s.corner[0][k][c] / step);
        if (solid_outline_fault(s.outline, 1, text, sizeof text)) continue;
        valid++;
        struct solid_outline_cells *cells = solid_outline_cells(s.outline, 1, origin, 1);
        double sum = 0;
        for (long k = 0; k < cells->n; k++) sum += cells->cell[k].area;
        check_relative(sum, shape_area(&s), 1e-14);
        for (int j = -8; j < 22; j++)
            for (int i = -12; i < 18; i++) {
                const double x[2] = {origin[0] + i + 0.5, origin[1] + j + 0.5};
                const long k = solid_outline_cells_at(cells, i, j);
                assert_int_equal(k >= 0 && cells->cell[k].is_inside, solid_outline_contains(s.outline, 1, x, 1));
            }
        solid_outline_cells_free(cells);
    }
    check_above(valid, 200);
}

/* Three discs that touch leave a triangle of arcs with cusps, and two large ones a thorn: no faults. */
static void test_cusps(void **state) {
    (void)state;
    char text[200] = "";
    for (int trial = 0; trial < 200; trial++) {
        struct shape s = {0};
        double at[3][2];
        const double turned = uniform(0, 7), r = uniform(0.1, 10);
        shape_outline(&s, 0);
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 2; c++)
                at[k][c] = 2 / sqrt(3) * r * (c ? sin(turned + 2 * M_PI * k / 3) : cos(turned + 2 * M_PI * k / 3));
        for (int k = 0; k < 3; k++) {
            const double *a = at[k], *b = at[(k + 1) % 3];
            shape_corner(&s, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
            shape_arc(&s, b[0], b[1], -1);
        }
        if (solid_outline_fault(s.outline, 1, text, sizeof text)) fail_msg("%s", text);
        check_relative(solid_outline_area(s.outline, 1), r * r * (sqrt(3) - M_PI / 2), 1e-12);
        const double large = exp(uniform(0, 7)), rise = 0.5 / (large + sqrt(large * large - 0.25)) / 2;
        const double c = cos(turned), d = sin(turned);
        shape_polygon(
            &s, 3,
            (const double[][2]){{0, 0}, {c / 2 + d * rise, d / 2 - c * rise}, {c / 2 - d * rise, d / 2 + c * rise}});
        s.turn[0][0] = s.turn[0][2] = -1;
        for (int k = 0; k < 3; k++) {
            s.centre[0][k][0] = (k ? -large : large) * d;
            s.centre[0][k][1] = (k ? large : -large) * c;
        }
        if (solid_outline_fault(s.outline, 1, text, sizeof text)) fail_msg("radius %g: %s", large, text);
    }
}

static void test_bounds_and_contains(void **state) {
    (void)state;
    struct shape s = {0};
    double low[2], high[2];
    shape_outline(&s, 0); /* three quarters of a disc about (1, 2) */
    shape_corner(&s, 1, 1.5);
    shape_arc(&s, 1, 2, 1);
    shape_corner(&s, 0.5, 2);
    shape_corner(&s, 1, 2);
    solid_outline_bounds(s.outline, 1, low, high);
    check_below(fabs(low[0] - 0.5) + fabs(high[0] - 1.5) + fabs(low[1] - 1.5) + fabs(high[1] - 2.5), 1e-15);
    const struct {
        double x[2];
        int in;
    } point[] = {{{1.2, 2.2}, 1},  {{0.8, 1.8}, 0},      {{1, 1.75}, 1},        {{1 - 1e-7, 1.75}, 0},
                 {{1.5, 2}, 1},    {{1.5 + 1e-7, 2}, 0}, {{1.5 + 5e-11, 2}, 1}, {{0.4, 2.5}, 0},
                 {{1, 2.4999}, 1}, {{0.5, 2}, 1},        {{3, 2}, 0},           {{0, 2}, 0}};
    for (size_t k = 0; k < sizeof point / sizeof point[0]; k++)
        assert_int_equal(solid_outline_contains(s.outline, 1, point[k].x, 0.1), point[k].in);
}

/* The particles of the turned or mirrored body, cell by cell. */
static void test_turned_and_mirrored(void **state) {
    (void)state;
    for (int trial = 0; trial < 60; trial++) {
        static struct shape s, t;
        memset(&t, 0, sizeof t);
        random_shape(&s, trial % KINDS);
        const int mirror = trial % 2;
        for (int l = 0; l < s.n; l++) {
            shape_outline(&t, s.outline[l].is_hole);
            for (int k = 0; k < s.outline[l].corners; k++) {
                const double *x = s.corner[l][k], *c = s.centre[l][k];
                shape_corner(&t, mirror ? -x[0] : -x[1], mirror ? x[1] : x[0]);
                shape_arc(&t, mirror ? -c[0] : -c[1], mirror ? c[1] : c[0], mirror ? -s.turn[l][k] : s.turn[l][k]);
            }
        }
        const double origin[2] = {0, 0}, spacing = 1. / 32;
        struct solid_outline_cells *one = solid_outline_cells(s.outline, s.n, origin, spacing);
        struct solid_outline_cells *other = solid_outline_cells(t.outline, t.n, origin, spacing);
        assert_int_equal(one->n, other->n);
        for (long k = 0; k < one->n; k++) {
            const int i = one->cell[k].i, j = one->cell[k].j;
            const long image = solid_outline_cells_at(other, mirror ? -i - 1 : -j - 1, mirror ? j : i);
            check_at_least(image, 0);
            check_close(one->cell[k].area, other->cell[image].area, 1e-12);
        }
        solid_outline_cells_free(one);
        solid_outline_cells_free(other);
    }
}

/* A plate with two round holes, symmetric but for rounding; and one that is not. */
static void test_symmetrise(void **state) {
    (void)state;
    for (int trial = 0; trial < 40; trial++) {
        struct shape s = {0};
        const double x = uniform(-9, 9), y = uniform(-9, 9), r = uniform(0.1, 0.3), off = trial % 4 == 3 ? 1e-3 : 0;
        const double spacing = 2. / (trial % 2 ? 41 : 40);
        shape_box(&s, 0, x - 1, y - 0.7, x + 1, y + 0.7);
        shape_disc(&s, 1, x - 0.4, y, r, 1);
        shape_disc(&s, 1, x + 0.4 + off, y, r, -1);
        const double origin[2] = {x - 1, y - 1};
        struct solid_outline_cells *cells = solid_outline_cells(s.outline, s.n, origin, spacing);
        solid_outline_symmetry_cells(cells);
        long double sum = 0;
        long unequal[2] = {0, 0};
        for (long k = 0; k < cells->n; k++) {
            const int i = cells->cell[k].i, j = cells->cell[k].j;
            const long in_x = solid_outline_cells_at(cells, cells->low[0] + cells->high[0] - i, j),
                       in_y = solid_outline_cells_at(cells, i, cells->low[1] + cells->high[1] - j);
            sum += cells->cell[k].area;
            unequal[0] += in_x < 0 || cells->cell[in_x].area != cells->cell[k].area;
            unequal[1] += in_y < 0 || cells->cell[in_y].area != cells->cell[k].area;
        }
        if (off > 0)
            check_above(unequal[0], 0);
        else
            check_equal(unequal[0], 0);
        assert_int_equal(unequal[1], 0);
        check_relative((double)sum * spacing * spacing, shape_area(&s), 1e-12);
        solid_outline_cells_free(cells);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    srand(1);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_total_area),
        cmocka_unit_test(test_particles),
        cmocka_unit_test(test_crumbs),
        cmocka_unit_test(test_area_in_square),
        cmocka_unit_test(test_aligned),
        cmocka_unit_test(test_cusps),
        cmocka_unit_test(test_bounds_and_contains),
        cmocka_unit_test(test_turned_and_mirrored),
        cmocka_unit_test(test_symmetrise),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
