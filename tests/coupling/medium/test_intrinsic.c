/* The intrinsic permeability of media that change, against exact flows through slits and against solutions from
 * nothing. */
#include "coupling/medium/intrinsic.h"
#include "base/par.h"
#include "tests/check.h"

#include <stdlib.h>

#define STATED 3e-3 /* what is left of k by the iteration, at most (docs/permeability.md) */
enum { MOST = 24 };

/* The domain: cells of width 1. */
struct box {
    int n[3], periodic[3];
    double low[3], high[3]; /* of the medium */
};

typedef int is_solid(const int at[3], const void *with);

/* Everything that a test needs of one medium. */
struct made {
    struct fluid_grid *grid;
    struct medium *medium;
    struct fluid_input in;
    struct medium_intrinsic *intrinsic;
};

/* Sides that are not periodic are walls, but those along x, where the fluid comes in and leaves. */
static struct made make(const struct box *b) {
    struct made made = {0};
    double L[3];
    for (int c = 0; c < 3; c++) {
        L[c] = b->n[c];
        for (int e = 0; e < 2; e++)
            made.in.side[c][e].type = b->periodic[c] ? FLUID_PERIODIC : c == 0 ? FLUID_OUTFLOW : FLUID_WALL;
    }
    made.grid = fluid_grid_new(b->n, L, b->periodic, 1, NULL);
    made.medium = medium_new(made.grid, b->low, b->high);
    made.intrinsic = medium_intrinsic_new(made.medium, &made.in);
    return made;
}

static void end(struct made *made) {
    medium_intrinsic_free(made->intrinsic);
    medium_free(made->medium);
    fluid_grid_free(made->grid);
}

/* Lays a cube of a cell's size at each solid cell, moved by `shift`. */
static void lay(const struct made *made, is_solid *is, const void *with, const double shift[3]) {
    static double x[3][MOST * MOST * MOST], volume[MOST * MOST * MOST];
    const int *n = made->grid->n;
    int all = 0, mine = 0;
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++) {
                const int at[3] = {i, j, k};
                if (!is(at, with) || all++ % par_size() != par_rank()) continue;
                for (int c = 0; c < 3; c++) x[c][mine] = at[c] + 0.5 + shift[c];
                volume[mine++] = 1;
            }
    medium_deposit(made->medium, mine, (const double *const[3]){x[0], x[1], x[2]}, volume);
}

static const double still[3] = {0, 0, 0};

static struct medium_intrinsic_values measure(const struct made *made, is_solid *is, const void *with) {
    lay(made, is, with, still);
    return medium_intrinsic_measure(made->intrinsic);
}

/* Of a slit n cells wide: h^2/12, by a wall half a cell from the outermost velocities. */
static double slit(int n) { return (1 + 2.0 / (n * n)) * n * n / 12; }

static int plates(const int at[3], const void *open) { return at[1] >= *(const int *)open; }
static int nothing(const int at[3], const void *with) {
    (void)at;
    (void)with;
    return 0;
}
static int everything(const int at[3], const void *with) {
    (void)at;
    (void)with;
    return 1;
}

/* A slit between plates, as wide as `open`, of a periodic medium 12 cells high. It opens and shuts: each k is that of
 * its own width, and is found from the flow before. */
static void test_slit_opens(void **state) {
    (void)state;
    const struct box b = {{6, 12, 8}, {1, 1, 1}, {0, 0, 0}, {6, 12, 8}};
    struct made made = make(&b);
    static const int width[] = {1, 2, 3, 4, 6, 8, 7, 5};
    for (size_t k = 0; k < sizeof width / sizeof *width; k++) {
        const int open = width[k];
        const struct medium_intrinsic_values v = measure(&made, plates, &open);
        check_relative(v.K[0][0], slit(open) * open / 12, STATED);
        check_relative(v.K[2][2], slit(open) * open / 12, STATED);
        check_equal(v.K[1][1], 0);
        check_equal(v.percolates[1], 0);
        check_close(v.K[0][2], 0, STATED * v.K[0][0]);
        check_close(v.porosity, open / 12.0, 1e-15);
        check_equal(v.solved, 2);
        check_equal(v.carried, k > 0 ? 2 : 0);
        check_below(v.error, STATED);
    }
    end(&made);
}

/* Walls of the domain are the plates: along them the flow is that of the slit, from wall to wall nothing resists. */
static void test_walls_of_the_domain(void **state) {
    (void)state;
    const struct box b = {{10, 7, 5}, {0, 0, 1}, {2, 0, 0}, {8, 7, 5}};
    struct made made = make(&b);
    const struct medium_intrinsic_values v = measure(&made, nothing, NULL);
    check_relative(v.K[0][0], slit(7), STATED);
    check_relative(v.K[2][2], slit(7), STATED);
    check_equal(isinf(v.K[1][1]), 1);
    check_equal(isnan(v.K[0][1]) && isnan(v.K[0][2]) && isnan(v.K[1][2]), 1);
    check_equal(medium_intrinsic_cells(made.intrinsic), 6 * 7 * 5);
    end(&made);
}

/* Nothing solid, and nothing but solid. */
static void test_ends(void **state) {
    (void)state;
    const struct box b = {{8, 9, 12}, {1, 1, 1}, {0, 0, 0}, {8, 9, 12}};
    struct made made = make(&b);
    const struct medium_intrinsic_values none = measure(&made, nothing, NULL), all = measure(&made, everything, NULL);
    for (int c = 0; c < 3; c++) {
        check_equal(isinf(none.K[c][c]), 1);
        check_equal(none.percolates[c], 1);
        check_equal(all.K[c][c], 0);
        check_equal(all.percolates[c], 0);
    }
    check_equal(none.porosity, 1);
    check_equal(all.porosity, 0);
    check_equal(none.solved + all.solved, 0);
    end(&made);
}

/* A plate moved by half a cell: cells that are half solid are solid, at both of its faces. Moved by a little less they
 * are pore at one face. */
static void test_half_solid(void **state) {
    (void)state;
    const struct box b = {{6, 12, 8}, {1, 1, 1}, {0, 0, 0}, {6, 12, 8}};
    struct made made = make(&b);
    const int open = 6;
    static const double shift[] = {0.5, 0.5 - 1e-12, 0.5 + 1e-12, 0.49, 0.51, 0.1};
    for (size_t k = 0; k < sizeof shift / sizeof *shift; k++) {
        if (check_skips((int)k, 1)) continue; /* in a debug build one of each two */
        lay(&made, plates, &open, (const double[3]){0, shift[k], 0});
        const struct medium_intrinsic_values v = medium_intrinsic_measure(made.intrinsic);
        const int width = k < 3 ? open - 1 : open;
        check_relative(v.K[0][0], slit(width) * width / 12, STATED);
    }
    end(&made);
}

/* Blocks of 3 x 3 x 3 cells of rock. */
struct rock {
    int gone, turned; /* blocks with a lower number are gone; x, y, z of the rock are y, z, x of the cells, ... */
    int chips;        /* of a thousand of its cells are gone */
};
static unsigned noise(int x, int y, int z) {
    unsigned h = (unsigned)((z * 61 + y) * 67 + x) * 2654435761u;
    h = (h ^ h >> 15) * 2246822519u;
    return (h ^ h >> 13) % 1000;
}
static int is_rock(const int at[3], const void *with) {
    const struct rock *r = with;
    int q[3];
    for (int c = 0; c < 3; c++) q[c] = at[(c + r->turned) % 3];
    const unsigned h = noise(q[0] / 3, q[1] / 3, q[2] / 3);
    return h < 420 && (int)h >= r->gone && (int)noise(q[0] + 7, q[1], q[2]) >= r->chips;
}

/* Blocks of rock in a periodic box are lost one after another, and then chips of them. From the last flow k is what it
 * is from nothing, to what is stated. What has not changed is not solved, and what has changed little takes less. */
static void test_loses_pieces(void **state) {
    (void)state;
    const struct box b = {{18, 12, 24}, {1, 1, 1}, {0, 0, 0}, {18, 12, 24}};
    struct made made = make(&b);
    long products[2] = {0};
    double before = 0;
    for (int k = 0; k < 20; k++) {
        if (check_skips(k + 1, 1)) continue; /* in a debug build two at a time */
        const struct rock rock = {k < 10 ? 10 * k : 90, 0, k < 10 ? 0 : k - 10};
        const struct medium_intrinsic_values v = measure(&made, is_rock, &rock);
        struct made fresh = make(&b);
        const struct medium_intrinsic_values w = measure(&fresh, is_rock, &rock);
        for (int i = 0; i < 9; i++)
            check_close(v.K[i / 3][i % 3], w.K[i / 3][i % 3], STATED * sqrt(w.K[i / 3][i / 3] * w.K[i % 3][i % 3]));
        check_equal(v.K[0][1], v.K[1][0]);
        check_at_least(v.K[0][0], before * (1 - STATED));
        before = v.K[0][0];
        products[0] += k > 10 ? v.products : 0;
        products[1] += k > 10 ? w.products : 0;
        end(&fresh);
    }
    print_message("products from the last flow %ld, from nothing %ld\n", products[0], products[1]);
    check_below((double)products[0], 0.4 * (double)products[1]);
    const struct rock rock = {90, 0, 9};
    const struct medium_intrinsic_values same = measure(&made, is_rock, &rock);
    check_equal(same.solved, 0);
    check_equal(same.K[0][0], before);
    medium_intrinsic_reset(made.intrinsic);
    const struct medium_intrinsic_values again = measure(&made, is_rock, &rock);
    check_equal(again.solved, 3);
    check_equal(again.carried, 0);
    end(&made);
}

/* The image turned: the tensor is turned. */
static void test_turned(void **state) {
    (void)state;
    struct medium_intrinsic_values v[3];
    for (int turned = 0; turned < 3; turned++) {
        struct box b = {{0}, {1, 1, 1}, {0, 0, 0}, {0}};
        static const int n[3] = {18, 12, 15};
        for (int c = 0; c < 3; c++) {
            b.n[(c + turned) % 3] = n[c];
            b.high[(c + turned) % 3] = n[c];
        }
        struct made made = make(&b);
        const struct rock rock = {0, turned, 0};
        v[turned] = measure(&made, is_rock, &rock);
        end(&made);
    }
    for (int turned = 1; turned < 3; turned++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                check_close(v[turned].K[(i + turned) % 3][(j + turned) % 3], v[0].K[i][j],
                            STATED * sqrt(v[0].K[i][i] * v[0].K[j][j]));
}

/* A sample whose ends are open is continued by its mirror images: along x it has the k of twice the sample, mirrored
 * and periodic, but for the velocity along its ends, which is free there. One that is symmetric has that of its period.
 */
static int layers(const int at[3], const void *with) {
    (void)with;
    const int q = at[0] % 8, r = (at[1] + 12) % 12;
    return (q == 3 || q == 4) && r >= 3 && r < 9; /* bars across the flow, in the middle of each period */
}
static void test_open_ends(void **state) {
    (void)state;
    const struct box open = {{20, 12, 8}, {0, 1, 1}, {2, 0, 0}, {18, 12, 8}},
                     whole = {{16, 12, 8}, {1, 1, 1}, {0, 0, 0}, {16, 12, 8}};
    struct made a = make(&open), b = make(&whole);
    lay(&b, layers, NULL, still);
    const struct medium_intrinsic_values w = medium_intrinsic_measure(b.intrinsic);
    lay(&a, layers, NULL, (const double[3]){2, 0, 0});
    const struct medium_intrinsic_values v = medium_intrinsic_measure(a.intrinsic);
    print_message("k of the sample over that of the medium: %.6f along x, %.6f along y\n", v.K[0][0] / w.K[0][0],
                  v.K[1][1] / w.K[1][1]);
    check_relative(v.K[1][1], w.K[1][1], STATED);
    check_relative(v.K[2][2], w.K[2][2], STATED);
    check_relative(v.K[0][0], w.K[0][0], 0.02);
    check_equal(isnan(v.K[0][1]), 1);
    check_close(v.K[1][2], 0, STATED * v.K[1][1]);
    end(&a);
    end(&b);
}

/* A box whose faces cut cells, one thinner than a cell, and a domain one cell thick. */
static int bars(const int at[3], const void *with) {
    (void)with;
    return at[1] == 0;
}
static void test_odd_boxes(void **state) {
    (void)state;
    const struct box cut = {{12, 7, 6}, {1, 1, 1}, {3.4, 0, 0}, {8.6, 7, 6}},
                     thin = {{12, 7, 6}, {1, 1, 1}, {3.6, 0, 0}, {4.4, 7, 6}},
                     flat = {{12, 7, 1}, {1, 1, 1}, {0, 0, 0}, {12, 7, 1}};
    const long cells[] = {6 * 7 * 6, 7 * 6, 12 * 7};
    const struct box *const box[] = {&cut, &thin, &flat};
    for (int k = 0; k < 3; k++) {
        if (k == 2 && par_size() > 2) continue; /* a domain one cell thick has no more pieces */
        struct made made = make(box[k]);
        const struct medium_intrinsic_values v = measure(&made, bars, NULL);
        check_equal(medium_intrinsic_cells(made.intrinsic), cells[k]);
        check_relative(v.K[0][0], slit(6) * 6 / 7, STATED);
        check_relative(v.K[2][2], slit(6) * 6 / 7, STATED);
        check_equal(v.K[1][1], 0);
        end(&made);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_slit_opens), cmocka_unit_test(test_walls_of_the_domain), cmocka_unit_test(test_ends),
        cmocka_unit_test(test_half_solid), cmocka_unit_test(test_loses_pieces),        cmocka_unit_test(test_turned),
        cmocka_unit_test(test_open_ends),  cmocka_unit_test(test_odd_boxes),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
