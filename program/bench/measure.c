/* Times a call by repeated runs: median and extremes, by clock and slowest rank. */
#include "program/bench/measure.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/sort.h"

#include <math.h>

static void read_clocks(double now[BENCH_CHANNELS]) {
    now[BENCH_WALL] = par_seconds();
    for (int p = 0; p < CLOCK_ALL; p++) now[BENCH_CLOCK + p] = clock_seconds((enum clock_part)p);
}

/* One repeat: seconds a call for each channel, on the slowest rank. */
static void repeat(bench_call *call, void *with, long calls, double seconds[BENCH_CHANNELS]) {
    double before[BENCH_CHANNELS], after[BENCH_CHANNELS];
    par_barrier();
    read_clocks(before);
    for (long k = 0; k < calls; k++) call(with);
    read_clocks(after);
    for (int c = 0; c < BENCH_CHANNELS; c++) seconds[c] = (after[c] - before[c]) / (double)calls;
    par_max_array(seconds, BENCH_CHANNELS);
}

/* Number of calls for a repeat that lasts long enough, at least three. The first call warms up, the second is timed. */
static long calls_for(const struct bench_repetition *repetition, bench_call *call, void *with) {
    double seconds[BENCH_CHANNELS];
    repeat(call, with, 1, seconds);
    repeat(call, with, 1, seconds);
    const double wanted = ceil(repetition->seconds / fmax(seconds[BENCH_WALL], 1e-9));
    return wanted < 3 ? 3 : wanted > 1e6 ? 1000000 : (long)wanted;
}

void bench_measure(const struct bench_repetition *repetition, bench_call *call, int n, void *const *with,
                   struct bench_sample (*sample)[BENCH_CHANNELS]) {
    static double seconds[BENCH_ARGUMENTS][BENCH_CHANNELS][BENCH_REPEATS_MAX];
    long calls[BENCH_ARGUMENTS];
    double now[BENCH_CHANNELS];
    ENSURE(n <= BENCH_ARGUMENTS && repetition->repeats <= BENCH_REPEATS_MAX, "%d arguments, %d repeats", n,
           repetition->repeats);
    for (int k = 0; k < n; k++) calls[k] = calls_for(repetition, call, with[k]);
    for (int r = 0; r < repetition->repeats; r++)
        for (int k = 0; k < n; k++) {
            repeat(call, with[k], calls[k], now);
            for (int c = 0; c < BENCH_CHANNELS; c++) seconds[k][c][r] = now[c];
        }
    for (int k = 0; k < n; k++)
        for (int c = 0; c < BENCH_CHANNELS; c++) {
            double *s = seconds[k][c];
            const double median = sort_median(s, (size_t)repetition->repeats);
            sample[k][c] =
                (struct bench_sample){calls[k], repetition->repeats, median, s[0], s[repetition->repeats - 1]};
        }
}

struct bench_sample bench_measure_one(const struct bench_repetition *repetition, bench_call *call, void *with) {
    struct bench_sample sample[1][BENCH_CHANNELS];
    bench_measure(repetition, call, 1, &with, sample);
    return sample[0][BENCH_WALL];
}
