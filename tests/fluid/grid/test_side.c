/* Each type of side sets the conditions of u, v, w and p that the thesis gives for it.  (001: sec. 3.4.2) */
#include "fluid/grid/side.h"
#include "tests/check.h"

#define D FLUID_DIRICHLET
#define N FLUID_NEUMANN

/* What each type stands for, on a side of any direction: the conditions of the normal and the tangential velocity and
 * of the pressure; whether it is a wall; 1: fluid comes in, -1: may leave. */
static const struct line {
    enum fluid_side_type type;
    const char *name;
    enum fluid_normal decides;
    enum fluid_condition normal, tangential, pressure;
    int is_wall, flow;
} table[] = {{FLUID_WALL, "wall", FLUID_NORMAL_GIVEN, D, D, N, 1, 0},
             {FLUID_SLIP, "slip", FLUID_NORMAL_GIVEN, D, N, N, 0, 0},
             {FLUID_INFLOW, "inflow", FLUID_NORMAL_GIVEN, D, D, N, 0, 1},
             {FLUID_OUTFLOW, "outflow", FLUID_NORMAL_CONVECTIVE, D, N, N, 0, -1},
             {FLUID_PRESSURE, "pressure", FLUID_NORMAL_FREE, N, N, D, 0, -1}};
enum { LINES = sizeof table / sizeof *table };

/* The velocity and pressure of the side: only a wall takes the velocity, in its plane, and only a side with a given
 * pressure the pressure. */
static void conditions_of_each_type(void **state) {
    (void)state;
    for (int l = 0; l < LINES; l++)
        for (int d = 0; d < 3; d++) {
            const struct line *is = &table[l];
            const struct fluid_side in = {.type = is->type, .velocity = {2, 3, 5}, .pressure = 7};
            struct fluid_boundary_side s = {0};
            fluid_side_conditions(&in, d, &s);
            assert_int_equal(s.normal, is->decides);
            for (int c = 0; c < 3; c++) {
                assert_int_equal(s.condition[c], c == d ? is->normal : is->tangential);
                check_equal(s.value[c], is->type == FLUID_WALL && c != d ? in.velocity[c] : 0);
                assert_int_equal(fluid_side_is_wall(&in, c), is->is_wall);
            }
            assert_int_equal(s.condition[3], is->pressure);
            check_equal(s.value[3], is->type == FLUID_PRESSURE ? 7 : 0);
            for (int high = 0; high < 2; high++) assert_int_equal(fluid_side_flow(&in, d, high), is->flow);
        }
}

static void every_type_has_its_name(void **state) {
    (void)state;
    for (int l = 0; l < LINES; l++) assert_string_equal(fluid_side_kind_of(table[l].type)->name, table[l].name);
    assert_string_equal(fluid_side_kind_of(FLUID_PERIODIC)->name, "periodic");
    assert_string_equal(fluid_side_kind_of(FLUID_GENERAL)->name, "general");
    assert_int_equal(LINES + 2, FLUID_SIDE_TYPES);
}

/* A general side has its own conditions and values; where its pressure is given the normal velocity is free. */
static void a_general_side_has_its_own(void **state) {
    (void)state;
    for (int d = 0; d < 3; d++)
        for (int set = 0; set < 16; set++) {
            struct fluid_side in = {.type = FLUID_GENERAL, .velocity = {2, 3, 5}, .pressure = 7};
            for (int c = 0; c < 4; c++) in.condition[c] = set >> c & 1 ? N : D;
            struct fluid_boundary_side s = {0};
            fluid_side_conditions(&in, d, &s);
            const int is_free = in.condition[3] == FLUID_DIRICHLET;
            assert_int_equal(s.normal, is_free ? FLUID_NORMAL_FREE : FLUID_NORMAL_GIVEN);
            for (int c = 0; c < 3; c++) {
                assert_int_equal(s.condition[c], c == d && is_free ? N : in.condition[c]);
                check_equal(s.value[c], in.velocity[c]);
                assert_int_equal(fluid_side_is_wall(&in, c), in.condition[c] == FLUID_DIRICHLET);
            }
            assert_int_equal(s.condition[3], in.condition[3]);
            check_equal(s.value[3], is_free ? 7 : 0);
        }
}

/* Fluid comes in where the given normal velocity points into the domain. */
static void a_general_side_flows_by_its_velocity(void **state) {
    (void)state;
    for (int d = 0; d < 3; d++)
        for (int high = 0; high < 2; high++) {
            struct fluid_side in = {.type = FLUID_GENERAL, .velocity = {-4, -4, -4}};
            for (int sign = -1; sign <= 1; sign++) {
                in.velocity[d] = high ? -sign : sign;
                in.condition[d] = FLUID_DIRICHLET;
                assert_int_equal(fluid_side_flow(&in, d, high), sign);
                in.condition[d] = FLUID_NEUMANN;
                assert_int_equal(fluid_side_flow(&in, d, high), -1);
            }
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(conditions_of_each_type), cmocka_unit_test(every_type_has_its_name),
        cmocka_unit_test(a_general_side_has_its_own), cmocka_unit_test(a_general_side_flows_by_its_velocity)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
