/* Clusters of bonds that broke: which bonds are one event, and its place, normal and sums. */
#include "solid/measure/events.h"
#include "base/par.h"
#include "tests/check.h"

#include <stdlib.h>

static const int OPEN[3] = {0, 0, 0}, AROUND[3] = {1, 0, 0};
static const double BOX[3] = {10, 10, 10};
static const double REACH = 1.5;

static struct solid_break bond_of(long step, double x, double y, double z, double length) {
    return (struct solid_break){{x, y, z}, {length, 0, 0}, 2, 3, 0.25 * (double)step, step};
}

static void shuffle(struct solid_break *list, long n, uint64_t seed) {
    for (long i = n - 1; i > 0; i--) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        const long k = (long)((seed >> 33) % (uint64_t)(i + 1));
        const struct solid_break was = list[i];
        list[i] = list[k];
        list[k] = was;
    }
}

/* Two halves of a bond, whose energies differ in the last digit, a whole one, and one of the next step. */
static void halves(void **state) {
    (void)state;
    struct solid_break one = bond_of(1, 0, 0, 0, 1), other = bond_of(1, 0, 0, 0, 2), next = bond_of(2, 0, 0, 0, 1);
    for (int turn = 0; turn < 6; turn++) {
        struct solid_break list[4] = {next, one, other, one};
        list[1].energy = 2 * (1 + 1e-16);
        shuffle(list, 4, (uint64_t)turn);
        check_equal(solid_events_join(list, 4), 3);
        check_equal(list[0].energy, 4);
        check_equal(list[0].area, 6);
        check_equal(list[1].xi[0], 2);
        check_equal(list[1].energy, 2);
        check_equal(list[2].step, 2);
    }
}

/* A chain whose links are as far apart as the reach, a bond just out of its reach, and one of another step. */
static void chains(void **state) {
    (void)state;
    struct solid_break list[6] = {bond_of(7, 1, 1, 1, 1),       bond_of(7, 3.5, 1, 1, 1), bond_of(7, 6, 1, 1, 1),
                                  bond_of(7, 6, 2.5 + 1e-9, 1, 1), bond_of(8, 3, 1, 1, 1),   bond_of(9, 1, 1, 1, 2)};
    struct solid_event *event;
    for (uint64_t turn = 0; turn < 6; turn++) {
        shuffle(list, 6, turn);
        check_equal(solid_events_join(list, 6), 6);
        check_equal(solid_events_of(list, 6, REACH, OPEN, BOX, &event), 4);
        check_equal(event[0].bonds, 3);
        check_equal(event[0].step, 7);
        check_equal(event[0].t, 1.75);
        check_equal(event[0].area, 9);
        check_equal(event[0].energy, 6);
        check_close(event[0].centre[0], 4, 1e-14);
        check_close(event[0].normal[0], 1, 1e-14);
        check_close(event[0].alignment, 1, 1e-14);
        check_equal(event[1].bonds, 1);
        check_close(event[1].centre[1], 2.5, 1e-8);
        check_equal(event[2].step, 8);
        check_equal(event[3].step, 9);
        free(event);
    }
    check_equal(solid_events_of(list, 0, REACH, OPEN, BOX, &event), 0);
    free(event);
}

/* Across a periodic side: one event, with its centre in the period; without, two. */
static void periods(void **state) {
    (void)state;
    struct solid_break list[2] = {bond_of(1, 9.4, 5, 5, 1), bond_of(1, 0.9, 5, 5, 1)};
    struct solid_event *event;
    solid_events_join(list, 2);
    check_equal(solid_events_of(list, 2, REACH, OPEN, BOX, &event), 2);
    free(event);
    check_equal(solid_events_of(list, 2, REACH, AROUND, BOX, &event), 1);
    check_close(event[0].centre[0], 0.65, 1e-12); /* middles at 9.9 and 11.4 */
    check_equal(event[0].bonds, 2);
    free(event);
}

/* All bonds of a lattice, |xi| <= 3, that cross a plane through (5, 5, 5) about it, with the area |xi|. */
static long cross(const int plane[3], int dim, struct solid_break **list) {
    long n = 0;
    *list = calloc(200000, sizeof **list);
    for (int x = 0; x <= 10; x++)
        for (int y = 0; y <= 10; y++)
            for (int z = dim == 3 ? 0 : 5; z <= (dim == 3 ? 10 : 5); z++)
                for (int i = -3; i <= 3; i++)
                    for (int j = -3; j <= 3; j++)
                        for (int k = dim == 3 ? -3 : 0; k <= (dim == 3 ? 3 : 0); k++) {
                            const double length = sqrt(i * i + j * j + k * k);
                            const double at = plane[0] * (x - 5) + plane[1] * (y - 5) + plane[2] * (z - 5) - 0.25;
                            const double to = at + plane[0] * i + plane[1] * j + plane[2] * k;
                            const double off = hypot(hypot(x - 5, y - 5), z - 5);
                            if (length > 3 || !(at < 0 && to > 0) || off > 4) continue;
                            (*list)[n++] = (struct solid_break){.x = {x, y, z}, .xi = {i, j, k}, 1, length, 0, 1};
                        }
    return solid_events_join(*list, n);
}

/* The normal of a plane crack is found, and its alignment is near that of evenly spread directions. */
static void normals(void **state) {
    (void)state;
    const int plane[][3] = {{0, 0, 1}, {0, -1, 0}, {1, 1, 0}, {1, 1, 1}, {2, -1, 0}};
    for (int p = 0; p < 5; p++)
        for (int dim = plane[p][2] ? 3 : 2; dim <= 3; dim++) {
            struct solid_break *list;
            struct solid_event *event;
            const long n = cross(plane[p], dim, &list);
            check_above(n, dim == 3 ? 1000 : 60);
            check_equal(solid_events_of(list, n, 3, OPEN, BOX, &event), 1);
            check_equal(event[0].bonds, n);
            double length = 0, along = 0, most = 0;
            for (int c = 0; c < 3; c++) {
                length += plane[p][c] * plane[p][c];
                along += event[0].normal[c] * plane[p][c];
                most = fabs(event[0].normal[c]) > fabs(most) + 1e-9 ? event[0].normal[c] : most;
            }
            /* by symmetry exact along axes and diagonals; else the lattice has too few directions: 3.2 degrees */
            const double off = acos(fmin(1, fabs(along) / sqrt(length)));
            check_below(off, plane[p][0] == 2 ? 0.06 : 1e-6);
            check_above(most, 0);
            check_close(event[0].alignment, dim == 3 ? 1.0 / 2 : 2.0 / 3, 0.05);
            check_close(event[0].energy, (double)n, 1e-9 * (double)n);
            free(event);
            free(list);
        }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(halves), cmocka_unit_test(chains), cmocka_unit_test(periods),
                                       cmocka_unit_test(normals)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
