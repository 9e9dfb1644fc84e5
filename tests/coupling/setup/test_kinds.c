/* A kind of the scene becomes the kind of the same name. */
#include "coupling/setup/kinds.h"
#include "fluid/grid/side.h"
#include "physics/micromodulus.h"
#include "physics/model.h"
#include "tests/check.h"

static void sides_keep_their_names(void **state) {
    (void)state;
    static const char *const name[] = {
        [SCENE_PERIODIC] = "periodic", [SCENE_WALL] = "wall",       [SCENE_SLIP] = "slip",
        [SCENE_INFLOW] = "inflow",     [SCENE_OUTFLOW] = "outflow", [SCENE_PRESSURE] = "pressure",
        [SCENE_GENERAL] = "general"};
    enum { N = sizeof name / sizeof *name };
    for (int k = 0; k < N; k++)
        assert_string_equal(fluid_side_kind_of(setup_kinds_side((enum scene_side_type)k))->name, name[k]);
    assert_int_equal(N, FLUID_SIDE_TYPES);
}

static void micromoduli_keep_their_names(void **state) {
    (void)state;
    static const char *const name[] = {
        [SCENE_CONSTANT] = "constant", [SCENE_CONICAL] = "conical", [SCENE_EXPONENTIAL] = "exponential"};
    for (int k = 0; k < (int)(sizeof name / sizeof *name); k++) {
        const int kind = (int)setup_kinds_micromodulus((enum scene_micromodulus)k);
        assert_string_equal(physics_micromodulus_of((enum physics_micromodulus)kind)->name, name[k]);
    }
}

/* Poisson's ratio tells plane stress from the others, and a solid in 3D stays one. */
static void models_keep_their_meaning(void **state) {
    (void)state;
    assert_int_equal(setup_kinds_model(SCENE_3D), SOLID_3D);
    check_close(physics_model_poisson_ratio((enum physics_model)setup_kinds_model(SCENE_PLANE_STRESS)), 1. / 3, 1e-15);
    check_close(physics_model_poisson_ratio((enum physics_model)setup_kinds_model(SCENE_PLANE_STRAIN)), 0.25, 1e-15);
    assert_int_not_equal(setup_kinds_model(SCENE_PLANE_STRAIN), SOLID_3D);
}

/* Each plane shape is an outline; the shapes in 3D stay apart. */
static void shapes_keep_their_meaning(void **state) {
    (void)state;
    assert_int_equal(setup_kinds_shape(SCENE_RECTANGLE), SOLID_POLYGON);
    assert_int_equal(setup_kinds_shape(SCENE_DISC), SOLID_POLYGON);
    assert_int_equal(setup_kinds_shape(SCENE_POLYGON), SOLID_POLYGON);
    assert_int_equal(setup_kinds_shape(SCENE_BOX), SOLID_BOX);
    assert_int_equal(setup_kinds_shape(SCENE_SPHERE), SOLID_SPHERE);
    assert_int_equal(setup_kinds_shape(SCENE_CYLINDER), SOLID_CYLINDER);
    assert_int_equal(setup_kinds_shape(SCENE_ELLIPSOID), SOLID_ELLIPSOID);
    assert_int_equal(setup_kinds_shape(SCENE_POINTS), SOLID_POINTS);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sides_keep_their_names), cmocka_unit_test(micromoduli_keep_their_names),
        cmocka_unit_test(models_keep_their_meaning), cmocka_unit_test(shapes_keep_their_meaning)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
