/* Grids, contours and crack shapes against known answers. */
#include "base/par.h"
#include "postproc/data/contour.h"
#include "postproc/data/crack_shape.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

/* Nodes of values f(x, y) on [0, 1]^2. */
static struct postproc_grid *square_of(int n, double (*f)(double x, double y)) {
    struct postproc_grid *g = postproc_grid_empty(n + 1, n + 1, (double[]){0, 0}, 1. / n);
    for (int j = 0; j <= n; j++)
        for (int i = 0; i <= n; i++) g->value[j * (n + 1) + i] = f((double)i / n, (double)j / n);
    return g;
}

static double bowl(double x, double y) { return 1 - hypot(x - 0.503, y - 0.491); }

/* The area inside closed lines, m2; holes count as negative. */
static double area_in(const struct postproc_contour *c) {
    double area = 0;
    for (int k = 0; k < c->lines; k++) {
        const long a = c->first[k], b = c->first[k + 1] - 1;
        const double *o = c->x[a];
        if (o[0] != c->x[b][0] || o[1] != c->x[b][1]) continue;
        for (long i = a; i < b; i++)
            area +=
                0.5 * ((c->x[i][0] - o[0]) * (c->x[i + 1][1] - o[1]) - (c->x[i + 1][0] - o[0]) * (c->x[i][1] - o[1]));
    }
    return area;
}

/* A circle's area, to second order: an error that falls by 16 in two halvings. */
static void circle(void **state) {
    (void)state;
    double off[3];
    for (int k = 0; k < 3; k++) {
        struct postproc_grid *g = square_of(20 << 2 * k, bowl);
        struct postproc_contour *c = postproc_contour_new(g, 0.7);
        assert_int_equal(c->lines, 1);
        assert_memory_equal(c->x[0], c->x[c->first[1] - 1], sizeof *c->x);
        for (long i = 0; i < c->first[1]; i++)
            check_close(hypot(c->x[i][0] - 0.503, c->x[i][1] - 0.491), 0.3, 0.2 * g->h * g->h / 0.3);
        off[k] = fabs(area_in(c) - M_PI * 0.09);
        check_below(off[k], 0.25 * M_PI * g->h * g->h); /* 2 pi R by the sagitta of chords as long as h */
        postproc_contour_free(c);
        postproc_grid_free(g);
    }
    check_close(log2(off[0] / off[2]) / 4, 2, 0.3);
}

static double ring(double x, double y) { return -fabs(hypot(x - 0.5, y - 0.5) - 0.3); }

/* A ring has an outer line and a hole, whose area counts backwards; a line that leaves the grid is open. */
static void holes_and_open_lines(void **state) {
    (void)state;
    struct postproc_grid *g = square_of(160, ring);
    struct postproc_contour *c = postproc_contour_new(g, -0.1);
    assert_int_equal(c->lines, 2);
    check_close(area_in(c), M_PI * (0.16 - 0.04), 2e-4);
    postproc_contour_free(c);
    c = postproc_contour_new(g, -0.3);
    assert_int_equal(c->lines, 4); /* the outer circle is cut by the four sides; the hole is a point at the middle */
    postproc_contour_free(c);
    g->value[80 * 161 + 80 + 64] = NAN; /* on the outer line: it opens */
    c = postproc_contour_new(g, -0.1);
    assert_int_equal(c->lines, 2);
    int open = 0;
    for (int k = 0; k < c->lines; k++) open += memcmp(c->x[c->first[k]], c->x[c->first[k + 1] - 1], sizeof *c->x) != 0;
    assert_int_equal(open, 1);
    postproc_contour_free(c);
    postproc_grid_free(g);
}

/* High corners 0 and 2. Their mean above the level: they are joined, and the lines go round the low corners; below:
 * apart. */
static void saddle(void **state) {
    (void)state;
    for (int joined = 0; joined < 2; joined++) {
        struct postproc_grid *g = postproc_grid_empty(2, 2, (double[]){0, 0}, 1);
        const double high = joined ? 1 : 0.6;
        g->value[0] = g->value[3] = high;
        g->value[1] = g->value[2] = 0.2;
        struct postproc_contour *c = postproc_contour_new(g, 0.5);
        assert_int_equal(c->lines, 2);
        for (int k = 0; k < 2; k++) {
            const double *a = c->x[c->first[k]], *b = c->x[c->first[k + 1] - 1];
            /* both ends are nearest to the corner that is cut off: (0,0) and (1,1) when apart, (1,0) and (0,1) when
             * joined */
            const double x = 0.5 * (a[0] + b[0]) > 0.5, y = 0.5 * (a[1] + b[1]) > 0.5;
            assert_true(joined ? x != y : x == y);
            /* higher values are to the left */
            const double left[2] = {0.5 * (a[0] + b[0]) - 0.01 * (b[1] - a[1]),
                                    0.5 * (a[1] + b[1]) + 0.01 * (b[0] - a[0])};
            const double off =
                hypot(left[0] - x, left[1] - y) - hypot(0.5 * (a[0] + b[0]) - x, 0.5 * (a[1] + b[1]) - y);
            check_above(joined ? off : -off, 0);
        }
        postproc_contour_free(c);
        postproc_grid_free(g);
    }
}

static double plane(const double x[2]) { return 3 + 2 * x[0] - x[1]; }

/* Two levels: a coarse lattice, refined in its middle. A linear field is met at every node and between. */
static void grid_of_two_levels(void **state) {
    (void)state;
    static double x[4000][2], value[4000];
    long n = 0;
    for (int j = 0; j < 41; j++)
        for (int i = 0; i < 61; i++) {
            const int fine = i >= 20 && i <= 40 && j >= 10 && j <= 30;
            if ((i % 2 || j % 2) && !fine) continue;
            x[n][0] = 0.25 + 0.25 * i;
            x[n][1] = -1.75 + 0.25 * j;
            value[n] = plane(x[n]);
            n++;
        }
    struct postproc_grid_input in = {
        .n = n, .x = (const double(*)[2])x, .value = value, .stride = 1, .spacing = 0.5, .first = {0.25, 0.25}};
    struct postproc_grid *g = postproc_grid_new(&in);
    check_close(g->h, 0.25, 1e-15);
    assert_int_equal(g->n[0], 63);
    for (double a = 0.3; a < 15.2; a += 0.377)
        for (double b = -1.7; b < 8.2; b += 0.311)
            check_close(postproc_grid_at(g, (double[]){a, b}), plane((double[]){a, b}), 1e-12);
    assert_true(isnan(postproc_grid_at(g, (double[]){-0.3, 0})));
    /* turned by 30 degrees it is the same field */
    const double d[2] = {cos(M_PI / 6), sin(M_PI / 6)};
    struct postproc_grid *t = postproc_grid_turn(g, d);
    const double at[2] = {7.1, 3.3}, q[2] = {d[0] * at[0] + d[1] * at[1], d[0] * at[1] - d[1] * at[0]};
    check_close(postproc_grid_at(t, q), plane(at), 1e-12);
    postproc_grid_free(t);
    postproc_grid_free(g);
    /* on no lattice: the nearest nodes' means */
    for (long i = 0; i < n; i++) x[i][0] += 0.05 * sin((double)i);
    g = postproc_grid_new(&in);
    check_close(g->h, 0.5, 1e-15);
    check_close(postproc_grid_at(g, (double[]){7.25, 3.25}), plane((double[]){7.25, 3.25}), 0.6);
    postproc_grid_free(g);
}

/* Damage as a crack leaves it in a lattice: 0.42 half a spacing from it, then less; 0 beyond three. */
struct segment {
    double from[2], to[2];
};
static double damage_at(const double x[2], int n, const struct segment *s, double h) {
    double nearest = INFINITY;
    for (int k = 0; k < n; k++) {
        const double ex = s[k].to[0] - s[k].from[0], ey = s[k].to[1] - s[k].from[1], ax = x[0] - s[k].from[0],
                     ay = x[1] - s[k].from[1];
        const double f = fmin(fmax((ax * ex + ay * ey) / (ex * ex + ey * ey), 0), 1);
        nearest = fmin(nearest, hypot(ax - f * ex, ay - f * ey));
    }
    return fmax(0, 0.504 * (1 - nearest / (3 * h)));
}

/* A plate of 100 by 40 mm from the origin. */
static struct postproc_grid *plate_of(double h, int n, const struct segment *s) {
    const int nx = (int)lround(0.1 / h), ny = (int)lround(0.04 / h);
    double(*x)[2] = malloc((size_t)(nx * ny) * sizeof *x), *value = malloc((size_t)(nx * ny) * sizeof *value);
    for (int j = 0, k = 0; j < ny; j++)
        for (int i = 0; i < nx; i++, k++) {
            x[k][0] = (i + 0.5) * h;
            x[k][1] = (j + 0.5) * h;
            value[k] = damage_at(x[k], n, s, h);
        }
    struct postproc_grid *g = postproc_grid_new(&(struct postproc_grid_input){.n = (long)nx * ny,
                                                                              .x = (const double(*)[2])x,
                                                                              .value = value,
                                                                              .stride = 1,
                                                                              .spacing = h,
                                                                              .first = {0.5 * h, 0.5 * h}});
    free(x);
    free(value);
    return g;
}

static double notch_points[2][3] = {{0, 0.02, 0}, {0.05, 0.02, 0}};
static const struct scene_crack notch = {.name = "notch", .points = 2, .point = notch_points};

/* The contour is as close as it can be: it runs round the particles beside the cut, and not on. */
static void level_of_the_initial_crack(void **state) {
    (void)state;
    const double h = 1e-3;
    const struct segment cut = {{0, 0.02}, {0.05, 0.02}};
    struct postproc_grid *g = plate_of(h, 1, &cut);
    struct postproc_tip tip[2];
    assert_int_equal(postproc_crack_shape_tips(g, 1, &notch, tip), 1); /* the other end is on the edge */
    check_close(tip[0].x[0], 0.05, 1e-15);
    check_close(tip[0].direction[0], 1, 1e-15);
    const double level = postproc_crack_shape_level(g, 1, &notch, 3 * h);
    check_close(level, 0.98 * 0.42, 1e-9);
    struct postproc_contour *c = postproc_contour_new(g, level);
    assert_int_equal(c->lines, 1); /* open at the plate's edge */
    for (long i = 0; i < c->first[1];
         i++) { /* beyond the two rows beside the cut by 2 % of 0.42 over the fall to the next */
        const double off = fabs(c->x[i][1] - 0.02) / h;
        check_below(off, 0.551);
        if (c->x[i][0] < 0.048) check_close(off, 0.55, 1e-9);
    }
    postproc_contour_free(c);
    postproc_grid_free(g);
    g = plate_of(h, 0, NULL);
    assert_true(isnan(postproc_crack_shape_level(g, 1, &notch, 3 * h)));
    postproc_grid_free(g);
}

/* A stem to x = 67 mm, then branches at 28 degrees up and 12 down; each bends to half its angle halfway. */
static int forked(double bend, struct segment s[5]) {
    const double x = 0.067, y = 0.02, l = 0.012, angle[2] = {28 * M_PI / 180, -12 * M_PI / 180};
    s[0] = (struct segment){{0, y}, {x, y}};
    for (int k = 0; k < 2; k++) {
        const double *a = &angle[k], m[2] = {x + l * cos(*a), y + l * sin(*a)};
        s[1 + 2 * k] = (struct segment){{x, y}, {m[0], m[1]}};
        s[2 + 2 * k] = (struct segment){{m[0], m[1]}, {m[0] + l * cos(bend * *a), m[1] + l * sin(bend * *a)}};
    }
    return 5;
}

static void branches_of_a_fork(void **state) {
    (void)state;
    static const double spacing[2] = {1e-3, 0.5e-3}, within[2] = {2.5, 1.5};
    for (int k = 0; k < 2; k++) {
        const double h = spacing[k];
        struct segment s[5];
        struct postproc_grid *g = plate_of(h, forked(1, s), s);
        struct postproc_grid *crack = postproc_crack_shape_connected(g, 0.35, (double[]){0.05, 0.02});
        const struct postproc_branching b = postproc_crack_branch_of(crack, fmax(10 * h, 5e-3));
        assert_true(b.found);
        /* undamaged nodes part branches once these are some particles apart */
        check_between(b.place[0], 0.067 - h, 0.067 + 6 * h);
        check_close(b.place[1], 0.02, 1.5 * h);
        check_close(b.side[0].first.value, 28, within[k]);
        check_close(b.side[0].last.value, 28, within[k]);
        check_close(b.side[1].first.value, 12, within[k]);
        check_close(b.side[1].last.value, 12, within[k]);
        check_close(b.side[0].first.value, 28, 1.5 * b.side[0].first.error + 0.5);
        check_between(b.side[0].first.error, 0.05, 3);
        check_close(b.side[0].end[0], 0.067 + 0.024 * cos(28 * M_PI / 180), 2 * h);
        postproc_grid_free(crack);
        postproc_grid_free(g);
    }
    struct segment s[5]; /* bent: the angle at the end is half of that at first */
    struct postproc_grid *g = plate_of(0.25e-3, forked(0.5, s), s);
    struct postproc_grid *crack = postproc_crack_shape_connected(g, 0.35, (double[]){0.05, 0.02});
    const struct postproc_branching b = postproc_crack_branch_of(crack, 5e-3);
    check_close(b.side[0].first.value, 28, 1);
    check_close(b.side[0].last.value, 14, 1);
    check_close(b.side[1].first.value, 12, 1);
    check_close(b.side[1].last.value, 6, 1);
    postproc_grid_free(crack);
    postproc_grid_free(g);
}

/* A straight crack does not branch, two parallel ones are not a fork, nor is a damaged spot apart from the crack. */
static void no_branches(void **state) {
    (void)state;
    const double h = 0.5e-3;
    const struct segment s[3] = {{{0, 0.02}, {0.08, 0.02}}, {{0, 0.03}, {0.08, 0.03}}, {{0.07, 0.005}, {0.09, 0.005}}};
    struct postproc_grid *g = plate_of(h, 3, s);
    struct postproc_grid *one = postproc_crack_shape_connected(g, 0.35, (double[]){0.05, 0.02});
    assert_false(postproc_crack_branch_of(one, 5e-3).found);
    assert_false(postproc_crack_branch_of(g, 5e-3).found); /* all of the plate: no node is without a value */
    for (int i = 0; i < g->n[0] * g->n[1]; i++)
        if (!(g->value[i] > 0.35)) g->value[i] = NAN;
    assert_false(postproc_crack_branch_of(g, 5e-3).found); /* two cracks, no stem */
    postproc_grid_free(one);
    postproc_grid_free(g);
}

/* A crack that leaves its notch at 68 degrees, as Kalthoff's do. */
static void chord_of_a_kinked_crack(void **state) {
    (void)state;
    const double h = 0.5e-3, a = 68 * M_PI / 180, l = 0.015;
    const struct segment s[2] = {{{0, 0.02}, {0.05, 0.02}}, {{0.05, 0.02}, {0.05 + l * cos(a), 0.02 + l * sin(a)}}};
    struct postproc_grid *g = plate_of(h, 2, s);
    struct postproc_grid *crack = postproc_crack_shape_connected(g, 0.35, (double[]){0.05, 0.02});
    struct postproc_tip tip[2];
    assert_int_equal(postproc_crack_shape_tips(g, 1, &notch, tip), 1);
    const struct postproc_chord c = postproc_crack_shape_chord(crack, tip);
    assert_true(c.found);
    check_close(c.length, l, 2 * h);
    check_close(c.angle.value, 68, 1.5 * c.angle.error);
    check_close(c.angle.error, 1.9, 0.3);
    postproc_grid_free(crack);
    postproc_grid_free(g);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(circle),
        cmocka_unit_test(holes_and_open_lines),
        cmocka_unit_test(saddle),
        cmocka_unit_test(grid_of_two_levels),
        cmocka_unit_test(level_of_the_initial_crack),
        cmocka_unit_test(branches_of_a_fork),
        cmocka_unit_test(no_branches),
        cmocka_unit_test(chord_of_a_kinked_crack),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
