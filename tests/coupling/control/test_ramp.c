/* Loads and constraints that change in time outside the steps of the solid. */
#include "coupling/control/ramp.h"
#include "coupling/run.h"
#include "tests/coupling/scene_of.h"

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

/* What is said at time t. */
static int said(double t, int ends, long moved, char sentence[RAMP_SENTENCE]) {
    struct scene *scene = scene_of(bar, "", 0, NULL);
    struct run *r = run_new(scene);
    r->t = t;
    r->moved = moved;
    const int is = ramp_of(r, ends, sentence);
    run_free(r);
    scene_free(scene);
    return is;
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

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(begins), cmocka_unit_test(ends)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
