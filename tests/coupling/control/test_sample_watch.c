/* The watch of what a row of series.csv has measured: what is off is kept as logged, round-off and NaN are not, and
 * again only what is four times as much. */
#include "coupling/control/sample_watch.h"
#include "coupling/run.h"
#include "tests/coupling/scene_of.h"

#include <math.h>

static double logged(const struct run *r, int kind) { return r->watch.sample.logged[kind]; }

static void says_once(void **state) {
    (void)state;
    struct run r = {.step = 3, .dt = 0.1};
    sample_watch_momentum(&r, 0.0099, 1);
    sample_watch_momentum(&r, NAN, 1);
    check_equal(logged(&r, SAMPLE_WATCH_MOMENTUM), 0);
    sample_watch_momentum(&r, 0.02, 1);
    check_relative(logged(&r, SAMPLE_WATCH_MOMENTUM), 0.02, 1e-12);
    sample_watch_momentum(&r, 0.079, 1);
    check_relative(logged(&r, SAMPLE_WATCH_MOMENTUM), 0.02, 1e-12);
    sample_watch_momentum(&r, 0.081, 1);
    check_relative(logged(&r, SAMPLE_WATCH_MOMENTUM), 0.081, 1e-12);
    check_equal(logged(&r, SAMPLE_WATCH_ANGULAR), 0);
    sample_watch_angular(&r, 0.3, 10);
    check_relative(logged(&r, SAMPLE_WATCH_ANGULAR), 0.03, 1e-12);
}

/* A flow that rests but for round-off has a divergence as large as its velocity. */
static void a_flow_at_rest_is_none(void **state) {
    (void)state;
    struct run r = {.step = 3, .dt = 0.1};
    sample_watch_divergence(&r, 1e-13, 1e-13);
    sample_watch_divergence(&r, 0.9e-5, 1);
    check_equal(logged(&r, SAMPLE_WATCH_DIVERGENCE), 0);
    sample_watch_divergence(&r, 1.1e-5, 1);
    check_relative(logged(&r, SAMPLE_WATCH_DIVERGENCE), 1.1e-5, 1e-12);
}

static void volume_of_cracks(void **state) {
    (void)state;
    struct run r = {.step = 3, .dt = 0.1};
    sample_watch_cracks(&r, 0, 0);
    sample_watch_cracks(&r, 0.9e-14, 1e-10);
    check_equal(logged(&r, SAMPLE_WATCH_CRACKS), 0);
    sample_watch_cracks(&r, 1.1e-14, 1e-10);
    check_relative(logged(&r, SAMPLE_WATCH_CRACKS), 1.1e-4, 1e-12);
}

static void work_in_cracks(void **state) {
    (void)state;
    struct run r = {.step = 3, .dt = 0.1};
    sample_watch_push(&r, 0, 0, 0);
    sample_watch_push(&r, 1, 1 + 0.9e-5, 1);
    check_equal(logged(&r, SAMPLE_WATCH_PUSH), 0);
    sample_watch_push(&r, 1, 1 + 1.1e-5, 1);
    check_relative(logged(&r, SAMPLE_WATCH_PUSH), 1.1e-5, 1e-9);
}

static void leak_off_only_takes(void **state) {
    (void)state;
    struct run r = {.step = 3, .dt = 0.1};
    sample_watch_leak(&r, 0, 0);
    sample_watch_leak(&r, 1e-10, 1e-10);
    sample_watch_leak(&r, 3e-10, 3e-10);
    check_equal(logged(&r, SAMPLE_WATCH_LEAK), 0);
    sample_watch_leak(&r, 2.4e-10, 3e-10);
    check_relative(logged(&r, SAMPLE_WATCH_LEAK), 0.2, 1e-9);
}

static void energy_of_a_flow(void **state) {
    (void)state;
    struct run r = {.step = 3, .dt = 0.1};
    sample_watch_energy(&r, -0.9e-2, 1);
    check_equal(logged(&r, SAMPLE_WATCH_ENERGY), 0);
    sample_watch_energy(&r, -1.1e-2, 1);
    check_relative(logged(&r, SAMPLE_WATCH_ENERGY), 1.1e-2, 1e-9);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(says_once),           cmocka_unit_test(a_flow_at_rest_is_none),
                                       cmocka_unit_test(volume_of_cracks),    cmocka_unit_test(work_in_cracks),
                                       cmocka_unit_test(leak_off_only_takes), cmocka_unit_test(energy_of_a_flow)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
