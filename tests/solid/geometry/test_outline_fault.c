/* Outlines that bound no plate are refused with a sentence, and no others. */
#include "base/par.h"
#include "tests/solid/outline_shapes.h"
#include "tests/check.h"

static void refuses(const struct shape *s, const char *sentence) {
    char text[200] = "";
    assert_int_not_equal(solid_outline_fault(s->outline, s->n, text, sizeof text), 0);
    assert_string_equal(text, sentence);
}

static void test_curve_faults(void **state) {
    (void)state;
    static struct shape s;
    refuses(&s, "there is no outline");
    shape_polygon(&s, 2, (const double[][2]){{0, 0}, {1, 0}});
    refuses(&s, "outline 1 has 2 corners, and needs at least 3 (2 with an arc)");
    shape_polygon(&s, 4, (const double[][2]){{0, 0}, {1, 0}, {1, 0}, {0, 1}});
    refuses(&s, "outline 1: corners 2 and 3 are the same");
    shape_polygon(&s, 4, (const double[][2]){{0, 0}, {1, 0}, {1, 1}, {0, 0}});
    refuses(&s, "outline 1: corners 4 and 1 are the same");
    shape_polygon(&s, 2, (const double[][2]){{0, 0}, {1, 0}});
    shape_arc(&s, 0.25, 0, 1);
    refuses(&s, "outline 1: the arc of edge 2 has its centre 0.75 m from corner 2, but 0.25 m from corner 1");
    shape_polygon(&s, 3, (const double[][2]){{0, 0}, {1, 1}, {3, 3}});
    refuses(&s, "outline 1 encloses no area");
    shape_polygon(&s, 4, (const double[][2]){{0, 0}, {1, 1}, {1, 0}, {0, 1}});
    refuses(&s, "outline 1 crosses or touches itself: edges 1 and 3");
    shape_polygon(&s, 5, (const double[][2]){{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}); /* a corner on an edge */
    refuses(&s, "outline 1 crosses or touches itself: edges 1 and 3");
    shape_polygon(&s, 4, (const double[][2]){{0, 0}, {2, 0}, {1, 0}, {1, 1}}); /* back on itself */
    refuses(&s, "outline 1 crosses or touches itself: edges 1 and 2");
    shape_polygon(&s, 5, (const double[][2]){{0, 0}, {2, 0}, {2, 2}, {0, 0.5}, {0, 2}});
    s.corner[0][3][0] = 1e-12; /* a slit no one can see */
    refuses(&s, "outline 1 crosses or touches itself: edges 3 and 5");
    shape_polygon(&s, 2, (const double[][2]){{0, 0}, {1, 0}}); /* there and back on one arc */
    shape_arc(&s, 0.5, 0, 1);
    s.turn[0][0] = -1;
    s.centre[0][0][0] = 0.5;
    refuses(&s, "outline 1 crosses or touches itself: edges 1 and 2");
    shape_polygon(&s, 4, (const double[][2]){{0, 0}, {2, 0}, {2, 0.9}, {0, 0.9}}); /* half a disc, too high */
    s.turn[0][0] = -1;
    s.centre[0][0][0] = 1;
    s.centre[0][0][1] = 0;
    refuses(&s, "outline 1 crosses or touches itself: edges 1 and 3");
    s.corner[0][2][1] = s.corner[0][3][1] = 1; /* that just touches */
    refuses(&s, "outline 1 crosses or touches itself: edges 1 and 3");
    s.corner[0][2][1] = s.corner[0][3][1] = 1.1;
    char text[200];
    assert_int_equal(solid_outline_fault(s.outline, 1, text, sizeof text), 0);
}

static void test_body_faults(void **state) {
    (void)state;
    static struct shape s;
    shape_box(&s, 0, 0, 0, 4, 4);
    shape_disc(&s, 1, 4, 2, 1, 1);
    refuses(&s, "outlines 1 and 2 cross or touch: edge 2 of the one, edge 1 of the other");
    s.n = 1;
    shape_disc(&s, 1, 3, 2, 1, 1); /* touches from inside */
    refuses(&s, "outlines 1 and 2 cross or touch: edge 2 of the one, edge 1 of the other");
    s.n = 1;
    shape_box(&s, 1, 5, 5, 6, 6);
    refuses(&s, "outline 2 is a hole outside every piece");
    s.n = 1;
    shape_box(&s, 1, 1, 1, 3, 3);
    shape_disc(&s, 1, 2, 2, 0.5, 1);
    refuses(&s, "outline 3 is a hole in the hole of outline 2");
    s.n = 1;
    shape_box(&s, 0, 1, 1, 3, 3);
    refuses(&s, "outlines 2 and 1 are pieces that overlap");
    s.n = 0;
    shape_box(&s, 1, 0, 0, 4, 4);
    refuses(&s, "outline 1 is a hole outside every piece");
    /* an island in a hole, and corners either way round, are fine */
    s.n = 0;
    shape_box(&s, 0, 0, 4, 4, 0);
    shape_box(&s, 1, 1, 1, 3, 3);
    shape_disc(&s, 0, 2, 2, 0.5, -1);
    char text[200];
    assert_int_equal(solid_outline_fault(s.outline, 3, text, sizeof text), 0);
    check_close(solid_outline_area(s.outline, 3), 12 + M_PI / 4, 1e-14);
}

/* Which side of the line a-b c is on, and whether closed segments meet, in whole numbers. */
static int side_of(const double a[2], const double b[2], const double c[2]) {
    const double cross = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return (cross > 0) - (cross < 0);
}

static int on_segment(const double a[2], const double b[2], const double c[2]) {
    return side_of(a, b, c) == 0 && (c[0] - a[0]) * (c[0] - b[0]) <= 0 && (c[1] - a[1]) * (c[1] - b[1]) <= 0;
}

static int is_simple(int n, double (*x)[2]) {
    for (int p = 0; p < n; p++)
        for (int q = p + 1; q < n; q++) {
            const double *a = x[p], *b = x[(p + 1) % n], *c = x[q], *d = x[(q + 1) % n];
            if (a[0] == b[0] && a[1] == b[1]) return 0;
            if (q == p + 1 ? on_segment(a, b, d) || on_segment(c, d, a)
                : p == 0 && q == n - 1
                    ? on_segment(a, b, c) || on_segment(c, d, b)
                    : on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b) ||
                          (side_of(a, b, c) != side_of(a, b, d) && side_of(c, d, a) != side_of(c, d, b)))
                return 0;
        }
    return x[0][0] != x[n - 1][0] || x[0][1] != x[n - 1][1];
}

/* Polygons with few places for their corners: half of them touch or cross themselves somehow. */
static void test_faults_exactly(void **state) {
    (void)state;
    int valid = 0;
    for (int trial = 0; trial < 20000; trial++) {
        struct shape s = {0};
        char text[200];
        const int n = 3 + rand() % 5;
        shape_outline(&s, 0);
        for (int k = 0; k < n; k++) shape_corner(&s, rand() % 7, rand() % 7);
        const int fault = solid_outline_fault(s.outline, 1, text, sizeof text);
        assert_int_equal(fault, !is_simple(n, s.corner[0]));
        valid += !fault;
    }
    check_between(valid, 2000, 18000);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    srand(1);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_curve_faults), cmocka_unit_test(test_body_faults),
                                       cmocka_unit_test(test_faults_exactly)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
