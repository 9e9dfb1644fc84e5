/* Medians, and measured times of calls whose duration is known. */
#include "base/clock.h"
#include "base/par.h"
#include "bench/limits.h"
#include "bench/measure.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>
#include <cmocka.h>

static void medians(void **state) {
    (void)state;
    assert_float_equal(bench_measure_median(5, (double[]){9, 1, 5, 3, 7}), 5, 0);
    assert_float_equal(bench_measure_median(4, (double[]){4, 1, 3, 2}), 2.5, 0);
}

struct nap {
    double seconds; /* on the last rank; others do not wait */
    long calls;
};

static void sleep_in_forcing(void *with) {
    struct nap *nap = with;
    nap->calls++;
    clock_begin(CLOCK_FORCING);
    const struct timespec time = {.tv_nsec = (long)(1e9 * nap->seconds)};
    if (par_rank() == par_size() - 1) nanosleep(&time, NULL);
    clock_end(CLOCK_FORCING);
}

/* A call that sleeps takes at least that time, on the wall clock and on its part's clock, also if only one rank sleeps.
 * Two calls are distinguished. Repeats last as long as asked. Times that a busy machine adds are not limited here. */
static void sleeps(void **state) {
    (void)state;
    struct nap nap[2] = {{.seconds = 2e-3}, {.seconds = 8e-3}};
    struct bench_sample of[2][BENCH_CHANNELS];
    const struct bench_effort effort = {5, 0.03};
    bench_measure(&effort, sleep_in_forcing, 2, (void *[]){&nap[0], &nap[1]}, of);
    for (int k = 0; k < 2; k++) {
        const struct bench_sample *wall = &of[k][BENCH_WALL], *part = &of[k][BENCH_CLOCK + CLOCK_FORCING];
        assert_true(wall->low >= nap[k].seconds && part->low >= nap[k].seconds);
        assert_true(wall->low <= wall->median && wall->median <= wall->high && part->high <= wall->high);
        assert_int_equal(wall->repeats, 5);
        assert_true(wall->calls >= 3);
        assert_int_equal(nap[k].calls, 2 + 5 * wall->calls);
        assert_true(of[k][BENCH_CLOCK + CLOCK_PROBE].high == 0);
    }
    assert_true(of[1][BENCH_WALL].median > of[0][BENCH_WALL].low + 5e-3);
}

/* The roofline takes the longer of the two times; more ranks have at least the rates of one, unless the machine is
 * busy. */
static void limits(void **state) {
    (void)state;
    const struct bench_limits given = {.together = 10, .peak = 100};
    assert_float_equal(bench_limits_seconds(&given, 20, 100), 2, 0);
    assert_float_equal(bench_limits_seconds(&given, 20, 300), 3, 0);
    const struct bench_effort effort = {5, 1e-3};
    const struct bench_limits found = bench_limits_measure(&effort, 1 << 16);
    assert_true(found.alone > 1e8 && found.together > 1e8 && found.peak > 1e8); /* any machine has that */
    assert_true(found.alone < 1e13 && found.together < 1e13 && found.peak < 1e14 * par_size());
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(medians), cmocka_unit_test(sleeps), cmocka_unit_test(limits)};
    par_begin(&argc, &argv);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
