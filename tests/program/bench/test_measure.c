/* Measured times of calls whose duration is known. */
#include "base/clock.h"
#include "base/par.h"
#include "base/vec.h"
#include "program/bench/limits.h"
#include "program/bench/measure.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>
#include <cmocka.h>

/* The clock that measures: par_seconds is this test's, and each look at it takes `tick`. */
static double now = 1000, tick;

double __wrap_par_seconds(void);
double __wrap_par_seconds(void) { return now += tick; }

double __real_par_seconds(void);

struct nap {
    double seconds; /* on the last rank; others do not wait */
    long calls;
};

static void nap_in_forcing(void *with) {
    struct nap *nap = with;
    nap->calls++;
    clock_begin(CLOCK_FORCING);
    if (par_rank() == par_size() - 1) now += nap->seconds;
    clock_end(CLOCK_FORCING);
}

/* A call's time is on the wall clock and on its part's, though one rank alone takes it; two calls are told apart;
 * repeats last as long as asked, and have three calls at the least. */
static void naps(void **state) {
    (void)state;
    struct nap nap[2] = {{.seconds = 2e-3}, {.seconds = 0.25}};
    const long calls[2] = {15, 3};
    struct bench_sample sample[2][BENCH_CHANNELS];
    const struct bench_repetition repetition = {5, 0.0299};
    bench_measure(&repetition, nap_in_forcing, 2, (void *[]){&nap[0], &nap[1]}, sample);
    for (int k = 0; k < 2; k++) {
        const struct bench_sample *wall = &sample[k][BENCH_WALL], *part = &sample[k][BENCH_CLOCK + CLOCK_FORCING];
        const double seconds = nap[k].seconds, rounding = 1e-12; /* s, of a clock that stands at 1000 s */
        check_close(wall->low, seconds, rounding);
        check_close(wall->median, seconds, rounding);
        check_close(wall->high, seconds, rounding);
        check_close(part->low, seconds, rounding);
        check_close(part->high, seconds, rounding);
        assert_int_equal(wall->repeats, 5);
        assert_int_equal(wall->calls, calls[k]);
        assert_int_equal(nap[k].calls, 2 + 5 * wall->calls);
        check_equal(sample[k][BENCH_CLOCK + CLOCK_PROBE].high, 0);
    }
}

/* The machine's clock counts seconds: asleep for 10 ms, it has gone on by them at the least. */
static void clock_counts_seconds(void **state) {
    (void)state;
    const double before = __real_par_seconds();
    nanosleep(&(struct timespec){.tv_nsec = 10000000}, NULL);
    check_at_least(__real_par_seconds() - before, 0.01 - 1e-5);
}

/* The roofline takes the slower of the two. Of the machine: 24 B an element of the triad, 2 flops a multiply-add, of
 * all ranks. */
static void limits(void **state) {
    (void)state;
    const struct bench_limits given = {.together = 10, .peak = 100};
    check_close(bench_limits_seconds(&given, 20, 100), 2, 0);
    check_close(bench_limits_seconds(&given, 20, 300), 3, 0);
    enum { LENGTH = 1 << 12 };
    const struct bench_repetition repetition = {5, 1e-3};
    tick = 1e-3; /* which is what the three calls of a repeat take */
    const struct bench_limits found = bench_limits_measure(&repetition, LENGTH);
    tick = 0;
    check_relative(found.alone, 24 * LENGTH * 3 / 1e-3, 1e-9);
    check_relative(found.together, par_size() * found.alone, 1e-9);
    check_relative(found.peak, par_size() * found.fma_length * 3 / 1e-3, 1e-9);
    assert_int_equal((long)found.fma_length % (2 * VEC_LANES), 0);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(naps), cmocka_unit_test(clock_counts_seconds),
                                       cmocka_unit_test(limits)};
    par_begin(&argc, &argv);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
