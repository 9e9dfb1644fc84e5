/* Loads and constraints that change in time outside the steps of the solid. */
#include "coupling/control/ramp.h"
#include "coupling/run.h"
#include "tests/coupling/scene_of.h"

#include <stdio.h>
#include <string.h>

static const char *const bar =
    "title: test\n"
    "domain: {size: [0.02, 0.01, 0.01]}\n"
    "solid:\n"
    "  spacing: 0.002\n"
    "  materials: [{name: m, youngs_modulus: 1.0e7, density: 1000}]\n"
    "  bodies: [{name: bar, shape: box, low: [0, 0, 0], high: [0.02, 0.01, 0.01]}]\n"
    "  constraints: [{low: [0, 0, 0], high: [0.002, 0.01, 0.01], velocity: [1, 0, 0], time: [[0, 1], [0.5, 1]]}]\n"
    "  loads: [{low: [0.018, 0, 0], high: [0.02, 0.01, 0.01], force: [1, 0, 0], time: [[0.1, 0], [0.2, 2]]}]\n"
    "stages: [{name: pull, steps: 10, time_step: 1.0e-6}]\n";

/* What is said of a scene at time t of this stage, at its beginning or at the end. moved: steps in
 * which the solid has moved. */
static int said_by(const char *text, int stage, double t, int ends, long moved, char sentence[RAMP_SENTENCE]) {
    struct scene *scene = scene_of(text, "", 0, NULL);
    struct run *r = run_new(scene);
    r->stage = stage;
    r->t = t;
    r->moved = moved;
    const int is = ramp_of(r, ends, sentence);
    run_free(r);
    scene_free(scene);
    return is;
}

static int said(double t, int ends, long moved, char sentence[RAMP_SENTENCE]) {
    return said_by(bar, 0, t, ends, moved, sentence);
}

/* The load's factor begins to change at 0.1 s and is 2 from 0.2 s on; the constraint's is constant. */
static void begins(void **state) {
    (void)state;
    char sentence[RAMP_SENTENCE];
    check_equal(said(0, 0, 0, sentence), 0);
    check_equal(said(0.1, 0, 0, sentence), 0);
    check_equal(said(0.15, 0, 0, sentence), 1);
    assert_non_null(strstr(sentence, "solid.loads[0].time: "));
    assert_non_null(strstr(sentence, "the factor then is 1 at once."));
    check_equal(said(7, 0, 0, sentence), 1);
    check_equal(said(7, 0, 3, sentence), 0); /* the solid has moved before */
}

static void ends(void **state) {
    (void)state;
    char sentence[RAMP_SENTENCE];
    check_equal(said(0.2, 1, 9, sentence), 0);
    check_equal(said(7, 1, 9, sentence), 0);
    check_equal(said(0.15, 1, 9, sentence), 1);
    assert_non_null(strstr(sentence, "is 0.5 of its largest value, 2: it would change until 0.2 s"));
    check_equal(said(1e-5, 1, 9, sentence), 1);
}

/* What is said at time t of a load with these times, in a stage with these keys. */
static int said_of(const char *time, const char *stage, double t, int ends, char sentence[RAMP_SENTENCE]) {
    char text[1024];
    snprintf(text, sizeof text,
             "title: test\ndomain: {size: [0.02, 0.01, 0.01]}\nsolid:\n  spacing: 0.002\n"
             "  materials: [{name: m, youngs_modulus: 1.0e7, density: 1000}]\n"
             "  bodies: [{name: bar, shape: box, low: [0, 0, 0], high: [0.02, 0.01, 0.01]}]\n"
             "  constraints: [{low: [0, 0, 0], high: [0.002, 0.01, 0.01]}]\n"
             "  loads: [{low: [0.018, 0, 0], high: [0.02, 0.01, 0.01], force: [1, 0, 0], time: %s}]\n"
             "stages: [{name: pull, steps: 10, %s}]\n",
             time, stage);
    return said_by(text, 0, t, ends, ends, sentence);
}

static void falls(void **state) {
    (void)state;
    char sentence[RAMP_SENTENCE];
    check_equal(said_of("[[1, 1], [2, 0]]", "time_step: 1.0e-6", 0.5, 1, sentence), 1); /* has not begun */
    check_equal(said_of("[[1, 1], [2, 0]]", "time_step: 1.0e-6", 1.5, 1, sentence), 1);
    check_equal(said_of("[[1, 1], [2, 0]]", "time_step: 1.0e-6", 1.97, 1, sentence), 0);
    check_equal(said_of("[[0, 0], [1, 1], [2, 0]]", "time_step: 1.0e-6", 1.5, 1, sentence), 0); /* a pulse */
}

static void relaxes(void **state) {
    (void)state;
    char sentence[RAMP_SENTENCE];
    check_equal(said_of("[[0, 0], [1, 1]]", "relax: true", 0, 1, sentence), 1);
    assert_non_null(strstr(sentence, "A relaxation takes no time"));
    check_equal(said_of("[[0, 0], [1, 1]]", "relax: true, increment: 0.05", 0.5, 1, sentence), 1);
    assert_null(strstr(sentence, "A relaxation takes no time"));
    check_equal(said_of("[[0, 0], [1, 1]]", "relax: true, increment: 0.1", 1, 1, sentence), 0);
}

/* Fluid flows in the crack of a plate from the second stage on, which begins at 0.1 s. */
static int said_of_an_injection(const char *time, int stage, double t, int ends, char sentence[RAMP_SENTENCE]) {
    char text[1024];
    snprintf(text, sizeof text,
             "title: test\ndomain: {size: [0.04, 0.04]}\nsolid:\n  spacing: 0.001\n  model: plane_strain\n"
             "  materials: [{name: m, youngs_modulus: 1.0e9, density: 1000, fracture_energy: 1}]\n"
             "  bodies: [{shape: rectangle, low: [0, 0], high: [0.04, 0.04]}]\n"
             "  cracks: [{points: [[0.015, 0.02], [0.025, 0.02]]}]\n"
             "crack_fluid:\n  viscosity: 1.0e-3\n"
             "  injections: [{low: [0.019, 0.018], high: [0.021, 0.022], rate: 1.0e-6, time: %s}]\n"
             "stages:\n  - {name: settle, steps: 10}\n  - {name: pump, steps: 10, crack_fluid: true}\n",
             time);
    return said_by(text, stage, t, ends, 1, sentence);
}

static void injections(void **state) {
    (void)state;
    char sentence[RAMP_SENTENCE];
    check_equal(said_of_an_injection("[[0, 0], [0.01, 1]]", 0, 0, 0, sentence), 0);
    check_equal(said_of_an_injection("[[0, 0], [0.01, 1]]", 1, 0.1, 0, sentence), 1);
    assert_non_null(strstr(sentence, "crack_fluid.injections[0].time: "));
    assert_non_null(strstr(sentence, "in which fluid first flows in the cracks"));
    check_equal(said_of_an_injection("[[0.1, 0], [0.11, 1]]", 1, 0.1, 0, sentence), 0);
    check_equal(said_of_an_injection("[[0, 0], [0.3, 1]]", 1, 0.2, 1, sentence), 1);
    check_equal(said_of_an_injection("[[0, 0], [0.3, 1]]", 1, 0.3, 1, sentence), 0);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(begins), cmocka_unit_test(ends), cmocka_unit_test(falls),
                                       cmocka_unit_test(relaxes), cmocka_unit_test(injections)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
