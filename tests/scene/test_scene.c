/* A scene's values are read, defaults are filled in, and --set changes them. */
#include "base/par.h"
#include "base/text.h"
#include "physics/retraction.h"
#include "tests/scene/scene_sample.h"
#include "tests/check.h"

#include <math.h>

static void test_values_are_read(void **state) {
    (void)state;
    struct scene *s = read_or_fail("coupled.yaml", 0, NULL);
    assert_string_equal(s->title, "A held block and a free sphere in a channel");
    assert_string_equal(s->path, SCENES "coupled.yaml");
    assert_vector(s->domain.size, 0.04, 0.02, 0.02);
    assert_int_equal(s->domain.cells[0], 40);
    check_equal(s->fluid->density, 1000);
    check_equal(s->fluid->viscosity, 1e-3);
    check_equal(s->fluid->initial_poiseuille, 1);
    assert_vector(s->fluid->initial_velocity, 0.1, 0, 0);
    assert_int_equal(s->fluid->side[0][0].type, FLUID_INFLOW);
    assert_int_equal(s->fluid->side[0][0].profile, FLUID_POISEUILLE);
    check_equal(s->fluid->side[0][0].bulk_velocity, 0.1);
    assert_int_equal(s->fluid->side[0][1].type, FLUID_OUTFLOW);
    assert_int_equal(s->fluid->side[1][1].type, FLUID_WALL);
    assert_vector(s->fluid->side[1][1].velocity, 0.01, 0, 0);
    assert_int_equal(s->fluid->driving, FLUID_DRIVING_GRADIENT);
    assert_int_equal(s->fluid->driving_direction, 2);
    assert_vector(s->fluid->body_force, 0, -9.81, 0);
    const struct scene_solid *solid = s->solid;
    assert_int_equal(solid->materials, 2);
    assert_int_equal(solid->bodies, 3);
    assert_string_equal(solid->material[1].name, "glass");
    check_equal(solid->material[0].fracture_energy, 0.05);
    check_equal(solid->material[1].horizon_ratio, 2);
    assert_true(solid->body[0].has_cavities);
    check_equal(solid->body[0].cavity_radius, 0.002);
    assert_false(solid->body[1].has_cavities);
    assert_int_equal(solid->body[1].own.shape, SOLID_SPHERE);
    assert_int_equal(solid->body[2].own.shape, SOLID_CYLINDER);
    assert_int_equal(solid->body[2].own.axis, 2);
    assert_int_equal(solid->body[0].material_index, 0);
    assert_int_equal(solid->body[2].material_index, 1);
    assert_vector(solid->load[0].force, 0, -100, 0);
    assert_int_equal(solid->unbreakables, 1);
    assert_vector(s->coupling->box_high, 0.02, 0.01, 0.02);
    assert_int_equal(s->stages, 3);
    assert_int_equal(s->stage[0].solid, SCENE_SOLID_RIGID);
    check_equal(s->stage[0].time_step, 0);
    check_equal(s->stage[0].cfl, 0.5);
    check_equal(s->stage[1].time_step, 1e-5);
    check_equal(s->stage[1].breakage, 0);
    check_equal(s->stage[1].damping_absolute, 2000);
    assert_int_equal(s->stage[2].integrator, SOLID_VERLET);
    assert_int_equal(s->stage[2].substeps, 4);
    scene_free(s);
}

static void test_vortices_and_places_of_a_fluid(void **state) {
    (void)state;
    const char *const set[] = {"fluid.initial.taylor_green={velocity: 2, axes: xz}", "fluid.sides.x_low={type: slip}",
                               "fluid.sides.x_high={type: slip}",
                               "fluid.driving={type: pressure_gradient, direction: z, value: 3, frequency: 0.25}",
                               "output.fluid_probes={lines: [{from: [0, 0, 0], to: [1, 2, 0.5], points: 3}]}"};
    struct scene *s = read_or_fail("fluid.yaml", 5, set);
    assert_true(s->fluid->has_taylor_green);
    check_equal(s->fluid->taylor_green_velocity, 2);
    assert_int_equal(s->fluid->taylor_green_axes, SCENE_XZ);
    check_equal(s->fluid->driving_value, 3);
    check_equal(s->fluid->driving_frequency, 0.25);
    const struct scene_fluid_probes *p = s->output.fluid_probes;
    check_equal(p->places, 0);
    check_equal(p->lines, 1);
    check_equal(p->every, 10);
    check_equal(p->line[0].points, 3);
    assert_vector(p->line[0].to, 1, 2, 0.5);
    assert_true(!strstr(s->resolved, "poiseuille"));
    scene_free(s);
    s = read_or_fail("fluid.yaml", 0, NULL);
    assert_false(s->fluid->has_taylor_green);
    check_equal(s->fluid->driving_frequency, 0);
    assert_false(s->output.fluid_probes);
    scene_free(s);
}

/* true and false were its words before it had kinds. */
static void test_surface_correction_has_words(void **state) {
    (void)state;
    static const char *const set[] = {"solid.surface_correction=none", "solid.surface_correction=volume",
                                      "solid.surface_correction=energy", "solid.surface_correction=false",
                                      "solid.surface_correction=true"};
    static const enum solid_correction expected[] = {SOLID_CORRECTION_NONE, SOLID_CORRECTION_VOLUME,
                                                     SOLID_CORRECTION_ENERGY, SOLID_CORRECTION_NONE,
                                                     SOLID_CORRECTION_VOLUME};
    for (int k = 0; k < 5; k++) {
        struct scene *s = read_or_fail("solid.yaml", 1, &set[k]);
        assert_int_equal(s->solid->surface_correction, expected[k]);
        scene_free(s);
    }
}

/* G0 = K_Ic^2/E', with the plane strain of a crack in space. */
static void test_toughness(void **state) {
    (void)state;
    const char *const space[] = {"solid.materials[1].toughness=1.0e6", "solid.materials[1].poisson_ratio=0.2"};
    const char *const plate[] = {"solid.materials[1].toughness=5.0e7"};
    struct scene *s = read_or_fail("coupled.yaml", 2, space);
    check_relative(s->solid->material[1].fracture_energy, 1e12 * 0.96 / s->solid->material[1].youngs_modulus, 1e-14);
    scene_free(s);
    s = read_or_fail("plate.yaml", 1, plate);
    check_relative(s->solid->material[1].fracture_energy, 2.5e15 / 2e11, 1e-14);
    scene_free(s);
}

/* Brittle bonds have the strength E' s0, which gives G0 at their horizon, with the nu of the material; of the bilinear
 * law it is the strength. */
static void test_strength(void **state) {
    (void)state;
    const char *const space[] = {"solid.materials[1].tensile_strength=7.0e+7"};
    const char *const soft[] = {"solid.materials[0].tensile_strength=1.0e+4",
                                "solid.materials[0].breakage={law: bilinear}"};
    struct scene *s = read_or_fail("coupled.yaml", 1, space);
    const struct scene_material *glass = &s->solid->material[1];
    /* s0 = 1e-3, G0 = 6/5 E delta s0^2, bonds alone */
    check_relative(glass->fracture_energy, 1.2 * 7e10 * 2 * s->solid->spacing * 1e-6, 1e-12);
    scene_free(s);
    s = read_or_fail("coupled.yaml", 2, soft);
    check_equal(s->solid->material[0].tensile_strength, 1e4);
    check_equal(s->solid->material[0].fracture_energy, 0.05);
    scene_free(s);
}

static void test_defaults_are_filled_in(void **state) {
    (void)state;
    struct scene *s = read_or_fail("coupled.yaml", 0, NULL);
    check_equal(s->solid->spacing, 0.04 / 40); /* the cell */
    assert_true(isinf(s->solid->material[1].fracture_energy));
    check_equal(s->solid->material[0].horizon_ratio, 3);
    check_equal(s->solid->material[0].poisson_ratio, 0.25);
    assert_true(s->solid->contact);
    check_equal(s->solid->contact_stiffness, 15);
    check_equal(s->solid->contact_radius, 1);
    assert_int_equal(s->solid->surface_correction, SOLID_CORRECTION_ENERGY);
    check_equal(s->solid->contact_exponent, 1);
    assert_true(s->solid->constraint[0].direction[0] && s->solid->constraint[0].direction[1]);
    assert_vector(s->solid->constraint[0].velocity, 0, 0, 0);
    check_equal(s->coupling->retraction, PHYSICS_RETRACTION);
    check_equal(s->coupling->probe_length, 2);
    assert_int_equal(s->coupling->surface, SOLID_DEPTH_COUNTED);
    assert_int_equal(s->coupling->load, SCENE_LOAD_REACTION);
    assert_true(s->coupling->has_box && s->domain.periodic[2] && !s->domain.periodic[0]);
    check_equal(s->stage[2].solid, SCENE_SOLID_ELASTIC);
    check_equal(s->stage[2].time_step, 0);
    check_equal(s->stage[2].cfl, 0.36); /* a solid moves */
    check_equal(s->stage[2].breakage, 1);
    check_equal(s->stage[1].substeps, 0);
    check_equal(s->stage[1].safety, 0.95);
    check_equal(s->output.checkpoint_every, 1000);
    check_equal(s->output.fields_every, 15); /* auto: a twentieth of 300 steps */
    check_equal(s->output.log_every, 100);
    check_equal(s->output.stress, 1);
    scene_free(s);
}

static void test_retraction_of_shapes(void **state) {
    (void)state;
    const char *const set[] = {"coupling.surface=shape", "coupling.retraction=0.25"};
    for (int n = 1; n <= 2; n++) {
        struct scene *s = read_or_fail("coupled.yaml", n, set);
        assert_int_equal(s->coupling->surface, SOLID_DEPTH_SHAPE);
        check_equal(s->coupling->retraction, n == 1 ? PHYSICS_RETRACTION : 0.25);
        assert_non_null(strstr(s->resolved, n == 1 ? "retraction: 0.28" : "retraction: 0.25"));
        scene_free(s);
    }
}

/* Velocity Verlet where bonds may break, RK3 elsewhere; what a scene says is left. */
static void test_integrators(void **state) {
    (void)state;
    static const struct {
        const char *set;
        enum solid_integrator integrator;
    } table[] = {
        {"title=as it is", SOLID_VERLET},
        {"stages[0].breakage=false", SOLID_RK3},
        {"stages[0].integrator=rk3", SOLID_RK3},
        {"stages[0].relax=true", SOLID_RK3},
        {"solid.materials[0].fracture_energy=.inf", SOLID_RK3},
        {"solid.materials[0].breakage={law: brittle, s00: 0.01, alpha: 0.25}", SOLID_VERLET},
    };
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        const char *const set[] = {table[k].set, "solid.materials[0].fracture_energy=.inf"};
        struct scene *s = read_or_fail("block.yaml", strstr(table[k].set, "s00") ? 2 : 1, set);
        if (s->stage[0].integrator != table[k].integrator)
            fail_msg("with %s: %d", table[k].set, s->stage[0].integrator);
        assert_non_null(
            strstr(s->resolved, table[k].integrator == SOLID_RK3 ? "integrator: rk3" : "integrator: verlet"));
        scene_free(s);
    }
}

static void test_parts_that_are_left_out_are_null(void **state) {
    (void)state;
    struct scene *fluid = read_or_fail("fluid.yaml", 0, NULL), *solid = read_or_fail("solid.yaml", 0, NULL);
    assert_true(fluid->fluid && !fluid->solid && !fluid->coupling);
    assert_true(!solid->fluid && solid->solid && !solid->coupling);
    assert_string_equal(fluid->fluid->side[0][0].file, SCENES "profile.txt"); /* absolute */
    assert_int_equal(fluid->fluid->side[1][0].w, FLUID_NEUMANN);
    assert_string_equal(solid->solid->body[0].own.file, SCENES "points.txt");
    assert_string_equal(solid->solid->body[1].name, "body2");
    assert_string_equal(solid->solid->body[1].material, "ceramic"); /* the only one */
    assert_true(solid->domain.periodic[2]);
    assert_false(solid->domain.periodic[0]);
    check_equal(solid->domain.cells[0], 0);
    assert_true(solid->stage[0].relax && !solid->stage[1].relax);
    scene_free(fluid);
    scene_free(solid);
}

static void test_medium_is_the_bodies_within_the_domain(void **state) {
    (void)state;
    char *sample = sample_text(SCENES "coupled.yaml");
    char *text = sample_with(sample, "  medium: {low: [0.01, 0, 0], high: [0.02, 0.01, 0.02]}\n", "");
    struct scene_problems problems;
    struct scene *s = sample_read(text, 0, NULL, &problems);
    assert_non_null(s);
    assert_true(s->coupling->has_box);
    assert_vector(s->coupling->box_low, 0.005 - 0.002, 0, 0);               /* the rod's, the domain's, the domain's */
    assert_vector(s->coupling->box_high, 0.03 + 0.004, 0.01 + 0.004, 0.02); /* the ball's, the ball's, the block's */
    scene_free(s);
    free(text);
    free(sample);
}

/* The whole period where a body extends beyond a periodic side, and reaches a region at the other, and the whole domain
 * where all sides are periodic. */
static void test_medium_of_an_array(void **state) {
    (void)state;
    char *sample = sample_text(SCENES "coupled.yaml");
    char *text = sample_with(sample, "  medium: {low: [0.01, 0, 0], high: [0.02, 0.01, 0.02]}\n", "");
    const char *const only =
        "solid={materials: [{name: glass, youngs_modulus: 1, density: 1}], bodies: [{name: ball, shape: sphere, "
        "centre: "
        "[0.03, 0.01, 0.018], radius: 0.004}], unbreakable: [{low: [0, 0, 0], high: [0.04, 0.02, 0.001]}]}";
    struct scene_problems problems;
    struct scene *s = sample_read(text, 1, &only, &problems);
    assert_non_null(s);
    assert_vector(s->coupling->box_low, 0.03 - 0.004, 0.01 - 0.004, 0);
    assert_vector(s->coupling->box_high, 0.03 + 0.004, 0.01 + 0.004, 0.02);
    scene_free(s);
    const char *const array[] = {only,
                                 "fluid.sides.x_low={type: periodic}",
                                 "fluid.sides.x_high={type: periodic}",
                                 "fluid.sides.y_low={type: periodic}",
                                 "fluid.sides.y_high={type: periodic}",
                                 "fluid.initial={velocity: [0.1, 0, 0]}"};
    s = sample_read(text, 6, array, &problems);
    assert_non_null(s);
    assert_vector(s->coupling->box_low, 0, 0, 0);
    assert_vector(s->coupling->box_high, 0.04, 0.02, 0.02);
    scene_free(s);
    const char *const list[] = {"solid={materials: [{name: glass, youngs_modulus: 1, density: 1}], bodies: [{shape: "
                                "spheres, file: points.txt}]}",
                                array[1],
                                array[2],
                                array[3],
                                array[4],
                                array[5]};
    s = sample_read(text, 6, list, &problems);
    assert_non_null(s);
    assert_true(s->coupling->has_box); /* whatever is in the list */
    assert_vector(s->coupling->box_high, 0.04, 0.02, 0.02);
    scene_free(s);
    free(text);
    free(sample);
}

static void test_settings_override(void **state) {
    (void)state;
    const char *const set[] = {"stages[0].steps=7",
                               "stages.1.steps=8",
                               "stages.fracture.steps=9",
                               "domain.size=[0.08, 0.04, 0.04]",
                               "coupling.retraction=-0.5",
                               "coupling.load=probe",
                               "output={series_every: 3, fields_every: 4}",
                               "solid.materials.glass.density=2600.5",
                               "solid.bodies[1].centre[0]=0.031",
                               "stages.flow.time_step=2e-4"};
    const char *const kept[] = {"title=\"a: b, c=d\"", "fluid.driving={type: none}"};
    const int n = (int)(sizeof set / sizeof *set);
    struct scene *s = read_or_fail("coupled.yaml", 2, kept);
    assert_string_equal(s->title, "a: b, c=d");
    assert_int_equal(s->fluid->driving, FLUID_DRIVING_NONE);
    scene_free(s);
    s = read_or_fail("coupled.yaml", n, set);
    assert_int_equal(s->stage[0].steps, 7);
    assert_int_equal(s->stage[1].steps, 8);
    assert_int_equal(s->stage[2].steps, 9);
    assert_vector(s->domain.size, 0.08, 0.04, 0.04);
    check_equal(s->solid->spacing, 0.08 / 40);
    check_equal(s->coupling->retraction, -0.5);
    check_equal(s->coupling->forcing_iterations, 2);
    assert_int_equal(s->coupling->load, SCENE_LOAD_PROBE);
    check_equal(s->output.series_every, 3);
    check_equal(s->output.fields_every, 4);
    check_equal(s->output.log_every, 100);
    check_equal(s->solid->material[1].density, 2600.5);
    check_equal(s->solid->body[1].own.centre[0], 0.031);
    check_equal(s->stage[0].time_step, 2e-4);
    scene_free(s);
}

static void test_settings_make_missing_sections(void **state) {
    (void)state;
    const char *const set[] = {"fluid.driving.type=pressure_gradient", "fluid.driving.value=3",
                               "fluid.driving.direction=z", "output.log_every=5"};
    struct scene *s = read_or_fail("fluid.yaml", 4, set);
    check_equal(s->fluid->driving, FLUID_DRIVING_GRADIENT);
    check_equal(s->fluid->driving_value, 3);
    check_equal(s->fluid->driving_direction, 2);
    check_equal(s->output.log_every, 5);
    scene_free(s);
}

static void test_wrong_settings_are_refused(void **state) {
    (void)state;
    const char *const said[][2] = {
        {"stages.flow.stepz=10", "--set stages.flow.stepz: unknown key; did you mean steps?"},
        {"stages.flwo.steps=10", "--set stages.flwo.steps: there is no entry named flwo; did you mean flow?"},
        {"stages.pull.steps=10",
         "--set stages.pull.steps: there is no entry named pull in stages; named here: flow, settle, fracture"},
        {"stages[3].steps=10", "--set stages[3].steps: there is no entry 3: stages has 0 to 2"},
        {"stages..steps=10", "--set stages..steps: not a path: write it as stages[0].steps or stages.flow.steps"},
        {"stages[0.steps=10", "--set stages[0.steps: not a path: write it as stages[0].steps or stages.flow.steps"},
        {"=10", "--set : not a path: write it as stages[0].steps or stages.flow.steps"},
        {"fluid.density", "--set fluid.density: needs a value: --set key.path=value"},
        {"fluid.density=", "--set fluid.density: must be a number, greater than 0 (kg/m3)"},
        {"fluid.density=-1", "--set fluid.density = -1: must be greater than 0"},
        {"fluid.density.low=1", "--set fluid.density.low: density is a value: nothing is in it"},
        {"domain.cells=[40, 20", "--set domain.cells: not valid YAML: while parsing a flow sequence: did not find "
                                 "expected ',' or ']'"},
        {"domain.cells=[40, 20, 0]", "--set domain.cells: domain.cells[2] = 0: must be between 1 and 1000000"},
        {"fluyd.density=1", "--set fluyd.density: unknown key; did you mean fluid?"},
        {"coupling.medium={low: [0, 0, 0]}", "--set coupling.medium: coupling.medium.high: missing (m)"}};
    sample_check_settings(SCENES "coupled.yaml", sizeof said / sizeof *said, said);
}

static void test_ranks_hold_the_same(void **state) {
    (void)state;
    const char *const set[] = {"stages.flow.steps=33", "fluid.viscosity=1.1e-3"};
    struct scene *s = read_or_fail("coupled.yaml", 2, set);
    struct scene_fluid fluid = *s->fluid;
    struct scene_stage stage = s->stage[0];
    struct scene_body body = s->solid->body[2];
    char resolved[8192] = "";
    check_below(strlen(s->resolved), sizeof resolved);
    strcpy(resolved, s->resolved);
    par_bcast(&fluid, sizeof fluid, 0);
    par_bcast(&stage, sizeof stage, 0);
    par_bcast(&body, sizeof body, 0);
    par_bcast(resolved, sizeof resolved, 0);
    assert_memory_equal(&fluid, s->fluid, sizeof fluid);
    assert_memory_equal(&stage, &s->stage[0], sizeof stage);
    assert_memory_equal(&body, &s->solid->body[2], sizeof body);
    assert_string_equal(resolved, s->resolved);
    check_equal(s->stage[0].steps, 33);
    check_equal(s->fluid->viscosity, 1.1e-3);
    scene_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_values_are_read),
                                       cmocka_unit_test(test_vortices_and_places_of_a_fluid),
                                       cmocka_unit_test(test_toughness),
                                       cmocka_unit_test(test_strength),
                                       cmocka_unit_test(test_defaults_are_filled_in),
                                       cmocka_unit_test(test_surface_correction_has_words),
                                       cmocka_unit_test(test_retraction_of_shapes),
                                       cmocka_unit_test(test_integrators),
                                       cmocka_unit_test(test_parts_that_are_left_out_are_null),
                                       cmocka_unit_test(test_medium_is_the_bodies_within_the_domain),
                                       cmocka_unit_test(test_medium_of_an_array),
                                       cmocka_unit_test(test_settings_override),
                                       cmocka_unit_test(test_settings_make_missing_sections),
                                       cmocka_unit_test(test_wrong_settings_are_refused),
                                       cmocka_unit_test(test_ranks_hold_the_same)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
