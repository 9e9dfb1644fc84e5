/* The stable step's numbers from velocities by hand, and what is told of a field that is no longer sound. */
#include "base/step_status.h"
#include "tests/fluid/fluid_case.h"

#include "tests/check.h"

static struct fluid *box(int implicit) {
    const struct fluid_input in = {.n = {8, 16, 16},
                                   .length = {0.8, 3.2, 0.8},
                                   .density = 2,
                                   .viscosity = 0.01,
                                   .initial_velocity = {0.5, -0.25, 1},
                                   .implicit = implicit};
    return fluid_new(&in);
}

/* dx = 0.1, 0.2, 0.05: the sum of |u|/dx is 5 + 1.25 + 20; the viscous limit 1.65/(4 nu (100 + 25 + 400)). */
static void of_a_uniform_flow(void **state) {
    (void)state;
    struct fluid *f = box(0);
    const struct fluid_limits l = fluid_limits_stable_step(f);
    check_relative(par_max(fluid_limits_convection_rate(f, NULL)), 26.25, 1e-13);
    check_relative(l.convective, sqrt(3) / 26.25, 1e-13);
    check_relative(l.viscous, 1.65 / (4 * 0.01 * 525), 1e-13);
    check_relative(l.step, l.convective, 1e-15);
    check_relative(fluid_limits_explicit_step(f), l.viscous, 1e-15);
    check_relative(0.002 * fluid_measures_of(f).convection_rate, 0.0525, 1e-13);
    check_equal(fluid_limits_of(f, 0).convective, INFINITY);
    fluid_free(f);
}

/* A fluid at rest: the rate of a wall that moves along x and z, 3/0.1 + 1/0.05, and of a bulk velocity to be held,
 * 6/0.1. Neither has set the fluid in motion yet. */
static void of_what_the_scene_gives(void **state) {
    (void)state;
    struct fluid_input in = {.n = {8, 16, 16}, .length = {0.8, 3.2, 0.8}, .density = 2, .viscosity = 0.01};
    in.side[1][0].type = in.side[1][1].type = FLUID_WALL;
    in.side[1][1].velocity[0] = 3, in.side[1][1].velocity[2] = -1;
    for (int held = 0; held < 2; held++) {
        if (held) in.driving = (struct fluid_driving){.type = FLUID_DRIVING_BULK, .direction = 0, .value = -6};
        struct fluid *f = fluid_new(&in);
        const struct fluid_limits l = fluid_limits_foreseen(f);
        check_relative(l.convective, sqrt(3) / (held ? 60 : 50), 1e-13);
        check_relative(l.viscous, 1.65 / (4 * 0.01 * 525), 1e-13);
        check_equal(fluid_limits_stable_step(f).convective, INFINITY);
        fluid_free(f);
    }
}

/* One face with a larger velocity, on the rank that holds it: the two cells beside it have the rate, and the first
 * is named. */
static void where_it_is_largest(void **state) {
    (void)state;
    struct fluid *f = box(0);
    const struct fluid_grid *g = fluid_grid_of(f);
    const double at[3] = {0.45, 2.1, 0.525};
    const int mine = fluid_grid_rank_of(g, at) == par_rank(), cell[3] = {4, 10, 10};
    double x[3];
    if (mine) fluid_state_of(f)->v[fluid_grid_at(g, cell[0], cell[1] - g->lo[1], cell[2] - g->lo[2])] = -3;
    const double rate = fluid_limits_convection_rate(f, x);
    check_relative(par_max(rate), 5 + 15 + 20, 1e-13);
    if (mine)
        for (int d = 0; d < 3; d++) check_close(x[d], at[d], 1e-12);
    fluid_free(f);
}

/* A NaN makes the rate infinite and the field fail, with its name, place and rank. */
static void what_is_no_number_shows(void **state) {
    (void)state;
    static const char *const name[4] = {"u", "v", "w", "p"};
    for (int c = 0; c < 4; c++) {
        struct fluid *f = box(0);
        const struct fluid_grid *g = fluid_grid_of(f);
        struct step_status s = fluid_limits_check(f);
        assert_false(step_status_agree(&s));
        const double middle[3] = {0.15, 2.9, 0.725};
        const int owner = fluid_grid_rank_of(g, middle);
        if (owner == par_rank()) component(f, c)[fluid_grid_at(g, 1, 14 - g->lo[1], 14 - g->lo[2])] = NAN;
        if (c < 3) check_equal(par_max(fluid_limits_convection_rate(f, NULL)), INFINITY);
        s = fluid_limits_check(f);
        assert_true(step_status_agree(&s));
        assert_string_equal(s.field, name[c]);
        assert_int_equal(s.rank, owner);
        for (int d = 0; d < 3; d++) check_close(s.x[d], middle[d] + (d == c ? 0.5 * g->d[d] : 0), 1e-12);
        assert_true(isnan(s.value));
        fluid_free(f);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(of_a_uniform_flow), cmocka_unit_test(of_what_the_scene_gives),
                                       cmocka_unit_test(where_it_is_largest),
                                       cmocka_unit_test(what_is_no_number_shows)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
