/* Profiles through a section: they hold the scheme's own momentum balance, have mean one, and come from files. */
#include "fluid/grid/profile.h"
#include "tests/fluid/fluid_case.h"

#include "tests/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { NA = 6, NB = 9 };

/* Along x: a = y, b = z. */
static struct fluid_input section(int walls_a, int walls_b) {
    struct fluid_input in = {.n = {4, NA, NB}, .length = {1, 0.5, 1.5}, .density = 1, .viscosity = 1};
    if (walls_a) all_sides(&in, 1, FLUID_WALL);
    if (walls_b) all_sides(&in, 2, FLUID_WALL);
    return in;
}

/* The second difference, with the opposite value beyond a wall, is the same at every cell. */
static void developed_flow_balances(void **state) {
    (void)state;
    const double da = 0.5 / NA, db = 1.5 / NB;
    for (int form = 0; form < 4; form++) {
        const int walls_a = form & 1, walls_b = form & 2;
        const struct fluid_input in = section(walls_a, walls_b);
        double q[NB][NA], sum = 0, first = 0;
        fluid_profile_developed(&in, 0, &q[0][0]);
        for (int b = 0; b < NB; b++)
            for (int a = 0; a < NA; a++) {
                const double here = q[b][a], wall_a = walls_a ? -here : q[b][(a + NA + (a ? 1 : -1)) % NA],
                             wall_b = walls_b ? -here : q[(b + NB + (b ? 1 : -1)) % NB][a];
                const double left = a > 0 ? q[b][a - 1] : wall_a, right = a < NA - 1 ? q[b][a + 1] : wall_a;
                const double down = b > 0 ? q[b - 1][a] : wall_b, up = b < NB - 1 ? q[b + 1][a] : wall_b;
                const double lap = (left - 2 * here + right) / (da * da) + (down - 2 * here + up) / (db * db);
                if (a + b == 0) first = lap;
                check_close(lap, first, 1e-10);
                sum += here;
            }
        if (form == 0) check_equal(first, 0);
        if (form > 0) check_below(first, -1);
        check_relative(sum, NA * NB, 1e-13);
    }
}

/* The parabola between walls, to its closed form at the cell centres: 6 (y (h - y) + dy^2/4)/(h^2 + dy^2/2). */
static void parabola_in_closed_form(void **state) {
    (void)state;
    const struct fluid_input in = section(1, 0);
    const double h = 0.5, d = h / NA;
    double q[NB][NA];
    fluid_profile_developed(&in, 0, &q[0][0]);
    for (int b = 0; b < NB; b++)
        for (int a = 0; a < NA; a++) {
            const double y = (a + 0.5) * d;
            check_relative(q[b][a], 6 * (y * (h - y) + 0.25 * d * d) / (h * h + 2 * d * d), 1e-13);
        }
}

static void inflow_by_kind(void **state) {
    (void)state;
    struct fluid_input in = section(1, 1);
    double developed[NA * NB], q[NA * NB];
    struct fluid_side *side = &in.side[0][1];
    side->bulk_velocity = 0.25;
    fluid_profile_developed(&in, 0, developed);
    fluid_profile_inflow(&in, 0, 1, q);
    for (int i = 0; i < NA * NB; i++) check_equal(q[i], 0.25);
    side->profile = FLUID_POISEUILLE;
    fluid_profile_inflow(&in, 0, 1, q);
    for (int i = 0; i < NA * NB; i++) check_relative(q[i], 0.25 * developed[i], 1e-15);
    /* a file has b fastest */
    char path[] = "/tmp/frana_test_profileXXXXXX";
    if (par_rank() == 0) {
        FILE *file = fdopen(mkstemp(path), "w");
        for (int a = 0; a < NA; a++)
            for (int b = 0; b < NB; b++) fprintf(file, "%d\n", 100 * a + b);
        fclose(file);
    }
    par_bcast(path, sizeof path, 0);
    side->profile = FLUID_PROFILE_FILE;
    snprintf(side->file, sizeof side->file, "%s", path);
    fluid_profile_inflow(&in, 0, 1, q);
    for (int b = 0; b < NB; b++)
        for (int a = 0; a < NA; a++) check_equal(q[b * NA + a], 100 * a + b);
    par_barrier();
    if (par_rank() == 0) unlink(path);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(developed_flow_balances),
                                       cmocka_unit_test(parabola_in_closed_form), cmocka_unit_test(inflow_by_kind)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
