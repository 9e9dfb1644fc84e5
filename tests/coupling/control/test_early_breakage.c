/* A stage that begins to break a solid that is not at rest says so; the largest stretch is that of a known strain. */
#include "coupling/control/early_breakage.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "solid/bonds/family.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A sine of 1e-5 m over 0.1 m has its largest strain of 2 pi 1e-4 at x = 0 and x = 0.1, in planes of particles. */
static const char *const bar =
    "title: test\n"
    "domain: {size: [0.1, 0.02]}\n"
    "solid:\n"
    "  spacing: 0.001\n"
    "  model: plane_stress\n"
    "  materials: [{name: m, youngs_modulus: 1.0e9, density: 1000, horizon_ratio: 2, fracture_energy: %s}]\n"
    "  bodies: [{shape: rectangle, low: [0, 0], high: [0.1, 0.02]}]\n"
    "  initial: [{shape: sine, along: x, centre: 0.05, width: 0.1, displacement: [%g, 0]}]\n"
    "stages:\n"
    "  - {name: free, steps: 10, breakage: false}\n"
    "  - {name: break, steps: 10}\n";

static struct run *after_the_first_stage(const char *energy, double displacement, struct scene **scene) {
    char text[1024];
    snprintf(text, sizeof text, bar, energy, displacement);
    *scene = scene_of(text, "", 0, NULL);
    struct run *r = run_new(*scene);
    step_begin_stage(r);
    step_advance(r);
    return r;
}

static void largest_stretch(void **state) {
    (void)state;
    struct scene *scene;
    struct run *r = after_the_first_stage("1.0e3", 1e-5, &scene);
    struct solid_reach reach = early_breakage_reach(r);
    const double part = reach.part;
    check_relative(part * reach.critical, 2e-4 * acos(-1), 0.02);
    check_equal(reach.modulus, 1e9);
    check_equal(reach.softens, 0);
    check_equal(reach.beyond, 0);
    run_free(r);
    scene_free(scene);
    r = after_the_first_stage("4.0e3", 1e-5, &scene); /* twice as strong */
    check_relative(early_breakage_reach(r).part, part / 2, 1e-3);
    run_free(r);
    scene_free(scene);
    r = after_the_first_stage("1.0e3, breakage: {law: bilinear, tensile_strength: 4.0e6}", 1e-5, &scene);
    /* peak(s_c/s_e) is 1 to 1.3: the first bonds soften at a stress somewhat below the strength */
    reach = early_breakage_reach(r);
    check_relative(reach.part * reach.critical, 2e-4 * acos(-1), 0.02);
    check_equal(reach.softens, 1);
    check_between(reach.critical * reach.modulus / 4.0e6, 0.7, 1);
    run_free(r);
    scene_free(scene);
    r = after_the_first_stage(".inf", 1e-5, &scene);
    check_equal(early_breakage_reach(r).part, 0);
    run_free(r);
    scene_free(scene);
}

static void begin_to_break(struct run *r) {
    r->stage = 1;
    r->stage_step = 0;
    step_begin_stage(r);
}

/* A run of the bar with `more` in its text before `where`, after twenty steps. */
static struct run *after_twenty_steps(double displacement, const char *where, const char *more, struct scene **scene) {
    char text[1024], rest[1024];
    snprintf(text, sizeof text, bar, "1.0e3", displacement);
    char *at = strstr(text, where);
    assert_non_null(at);
    snprintf(rest, sizeof rest, "%s", at);
    snprintf(at, sizeof text - (size_t)(at - text), "%s%s", more, rest);
    *scene = scene_of(text, "", 0, NULL);
    struct run *r = run_new(*scene);
    step_begin_stage(r);
    for (int k = 0; k < 20; k++) step_advance(r);
    return r;
}

static int said(double damping, int steps, char sentence[EARLY_BREAKAGE_SENTENCE]) {
    struct scene *scene;
    struct run *r = after_the_first_stage("1.0e3", 1e-5, &scene);
    r->solid->stage.damping_absolute = damping;
    for (int k = 0; k < steps; k++) step_advance(r);
    begin_to_break(r);
    const int is = early_breakage_of(r, sentence);
    run_free(r);
    scene_free(scene);
    return is;
}

static void not_at_rest(void **state) {
    (void)state;
    char sentence[EARLY_BREAKAGE_SENTENCE];
    check_equal(said(0, 20, sentence), 1);
    assert_non_null(strstr(sentence, "stage break: "));
    check_equal(said(5.0e5, 400, sentence), 0); /* creeps */
}

/* A notch whose bonds are cut from the start is no breakage in the run: both is said of a notched bar too. */
static void with_a_notch(void **state) {
    (void)state;
    char sentence[EARLY_BREAKAGE_SENTENCE];
    struct scene *scene;
    struct run *r =
        after_twenty_steps(1e-5, "  initial:", "  cracks: [{points: [[0.03, -0.001], [0.03, 0.01]]}]\n", &scene);
    solid_family_count(r->solid);
    assert_true(r->solid->bonds_broken > 0);
    assert_true(early_breakage_reach(r).part > 0);
    begin_to_break(r);
    check_equal(early_breakage_of(r, sentence), 1);
    r->solid->crack_area = 1e-6;
    assert_true(early_breakage_reach(r).part == 0);
    run_free(r);
    scene_free(scene);
}

/* A free bar flies, with and without a wave in it. */
static int said_of_a_flight(double wave, char sentence[EARLY_BREAKAGE_SENTENCE]) {
    struct scene *scene;
    struct run *r = after_twenty_steps(wave, "high: [0.1, 0.02]", "velocity: [3, 4], ", &scene);
    begin_to_break(r);
    const int is = early_breakage_of(r, sentence);
    run_free(r);
    scene_free(scene);
    return is;
}

static void flies(void **state) {
    (void)state;
    char sentence[EARLY_BREAKAGE_SENTENCE];
    check_equal(said_of_a_flight(1e-30, sentence), 0);
    check_equal(said_of_a_flight(1e-5, sentence), 1);
}

/* A wall in a stream whose load grows by 1 N/s at 10 N: in 0.4 s by 4 %, in 0.8 s by 8 %. */
static const char *const wall =
    "title: test\n"
    "domain: {size: [0.08, 0.04, 0.04], cells: [16, 8, 8]}\n"
    "fluid:\n"
    "  density: 1000\n  viscosity: 1.0e-3\n"
    "  sides:\n"
    "    x_low: {type: inflow, bulk_velocity: 0.1}\n    x_high: {type: outflow}\n"
    "    y_low: {type: slip}\n    y_high: {type: slip}\n    z_low: {type: slip}\n    z_high: {type: slip}\n"
    "solid:\n"
    "  materials: [{name: m, youngs_modulus: 1.0e6, density: 1000, horizon_ratio: 2, fracture_energy: 1}]\n"
    "  bodies: [{shape: box, low: [0.03, 0, 0], high: [0.05, 0.02, 0.04]}]\n"
    "stages:\n"
    "  - {name: settle, steps: 10, time_step: 1.0e-3, breakage: %s}\n"
    "  - {name: break, steps: %d, time_step: 1.0e-3}\n";

static int said_of_a_load(const char *breakage, int steps, int samples, char sentence[EARLY_BREAKAGE_SENTENCE]) {
    char text[2048];
    snprintf(text, sizeof text, wall, breakage, steps);
    struct scene *scene = scene_of(text, "", 0, NULL);
    const struct run r = {.scene = scene, .needs = setup_needs_of(scene), .stage = 1, .dt = 1e-3};
    struct early_breakage_load load = {.samples = 0};
    for (int k = 0; k < samples; k++)
        early_breakage_load_add(&load, 0.01 * k, (const double[3]){0, -9.98 - 0.01 * k, 0});
    const int said = early_breakage_flow_of(&r, &load, 10, sentence);
    scene_free(scene);
    return said;
}

static void a_load_that_still_changes(void **state) {
    (void)state;
    char sentence[EARLY_BREAKAGE_SENTENCE];
    assert_true(said_of_a_load("false", 800, 3, sentence));
    assert_non_null(strstr(sentence, "its load of 10 N changes by 1 N/s, which would be 0.08 of it"));
    assert_false(said_of_a_load("false", 400, 3, sentence));
    assert_false(said_of_a_load("false", 800, 1, sentence)); /* one sample tells no change */
    assert_false(said_of_a_load("true", 800, 3, sentence));  /* bonds broke before */
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(largest_stretch), cmocka_unit_test(a_load_that_still_changes),
                                       cmocka_unit_test(not_at_rest), cmocka_unit_test(flies),
                                       cmocka_unit_test(with_a_notch)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
