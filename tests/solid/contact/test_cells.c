/* Points in cells: whoever is within reach is found, each once, also across periodic sides. */
#include "base/par.h"
#include "solid/contact/cells.h"
#include "tests/check.h"

#include <stdlib.h>

enum { MOST = 600 };

static double uniform(double low, double high) { return low + (high - low) * rand() / RAND_MAX; }

/* Against all distances; from thousands of points a few tens of cells' worth are found. */
static void check_near(const struct solid_cells *cells, const double (*at)[3], int rings, double reach,
                       const int periodic[3], const double length[3]) {
    static int found[MOST], times[MOST];
    long near = 0;
    for (int trial = 0; trial < 100; trial++) {
        double x[3];
        for (int c = 0; c < 3; c++) x[c] = uniform(-0.3 * length[c], 1.3 * length[c]);
        memset(times, 0, sizeof times);
        const int n = solid_contact_cells_near(cells, x, rings, found);
        check_at_most(n, cells->n);
        for (int k = 0; k < n; k++) times[found[k]]++;
        for (int i = 0; i < cells->n; i++) {
            double r2 = 0;
            int is_around = 1;
            for (int c = 0; c < 3; c++) {
                double r = x[c] - at[i][c];
                if (periodic[c]) r -= length[c] * rint(r / length[c]);
                r2 += r * r;
                is_around = is_around && fabs(r) < (rings + 1.0001) * cells->size[c];
            }
            check_at_most(times[i], is_around);
            if (r2 >= reach * reach) continue;
            check_equal(times[i], 1);
            near++;
        }
    }
    check_above(near, 50);
}

/* Filled again and again: with more points, other periods, and a period of few cells. */
static void all_within_reach(void **state) {
    (void)state;
    static double x[MOST][3];
    struct solid_cells cells = {0};
    const int n[5] = {MOST, 40, 300, MOST, 300};
    const double reach[5] = {0.1, 0.3, 0.2, 0.45, 0.9};
    srand(11);
    for (int k = 0; k < 5; k++) {
        const int periodic[3] = {k > 0, k > 1, k > 3};
        const double length[3] = {1, 1.3, 0.95};
        for (int i = 0; i < n[k]; i++)
            for (int c = 0; c < 3; c++) x[i][c] = uniform(-0.2, 1.2);
        solid_contact_cells_fill(&cells, n[k], x, reach[k], periodic, length);
        for (int c = 0; c < 3; c++) check_at_least(cells.size[c], reach[k]);
        for (int rings = 1; rings <= 2; rings++) check_near(&cells, x, rings, rings * reach[k], periodic, length);
    }
    solid_contact_cells_free(&cells);
    assert_null(cells.first);
}

/* A few points far away make neither many cells nor large ones, and are found. */
static void far_away(void **state) {
    (void)state;
    static double x[MOST][3];
    struct solid_cells cells = {0};
    const int open[3] = {0, 0, 0}, n = MOST;
    srand(12);
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) x[i][c] = uniform(-0.2, 1.2) + (i < 3 ? 1e6 * (c - 0.7) : 0);
    solid_contact_cells_fill(&cells, n, x, 0.1, open, (double[]){1, 1, 1});
    check_below((double)cells.count[0] * cells.count[1] * cells.count[2], 5.0 * n);
    for (int c = 0; c < 3; c++) check_below(cells.size[c], 0.3);
    check_near(&cells, x, 1, 0.1, open, (double[]){1, 1, 1});
    for (int i = 0; i < 3; i++) {
        int found[MOST], has = 0;
        const int near = solid_contact_cells_near(&cells, x[i], 1, found);
        check_at_most(near, 3);
        for (int k = 0; k < near; k++) has += found[k] == i;
        check_equal(has, 1);
    }
    solid_contact_cells_free(&cells);
}

/* Places of a solid that is lost make no cells larger, and the others are found. */
static void not_finite(void **state) {
    (void)state;
    static double x[MOST][3];
    const double lost[4] = {INFINITY, -INFINITY, NAN, 1e9};
    int found[MOST];
    for (int periodic = 0; periodic < 2; periodic++)
        for (int all = 0; all < 2; all++) {
            struct solid_cells cells = {0};
            srand(13);
            for (int i = 0; i < MOST; i++)
                for (int c = 0; c < 3; c++) x[i][c] = all || i % 7 == 0 ? lost[(i + c) % 4] : uniform(0, 1);
            solid_contact_cells_fill(&cells, MOST, x, 0.1, (const int[]){periodic, periodic, 0}, (double[]){1, 1, 1});
            for (int c = 0; c < 3 && !all; c++) check_below(cells.size[c], 0.3);
            for (int i = 0; i < MOST; i++) {
                int has = 0;
                const int near = solid_contact_cells_near(&cells, x[i], 1, found);
                for (int k = 0; k < near; k++) has += found[k] == i;
                if (!all && i % 7 != 0) check_equal(has, 1);
            }
            solid_contact_cells_free(&cells);
        }
}

/* No points: nothing is near. */
static void empty(void **state) {
    (void)state;
    struct solid_cells cells = {0};
    int found[1];
    solid_contact_cells_fill(&cells, 0, NULL, 0.1, (int[]){1, 0, 0}, (double[]){1, 1, 1});
    check_equal(solid_contact_cells_near(&cells, (double[]){0.5, 0.5, 0.5}, 1, found), 0);
    solid_contact_cells_free(&cells);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_within_reach), cmocka_unit_test(far_away),
                                       cmocka_unit_test(not_finite), cmocka_unit_test(empty)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
