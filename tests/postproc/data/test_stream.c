/* Streamlines of known flows: uniform, rigid rotation, a stop at the solid; and their order of accuracy. */
#include "postproc/data/stream.h"
#include "tests/check.h"

#include <math.h>

static int uniform(const void *field, const double x[3], double u[3]) {
    (void)field;
    (void)x;
    u[0] = 3;
    u[1] = 4;
    u[2] = 12;
    return 1;
}

/* Round the z axis at 2 rad/s, with a drift along z. Nothing flows beyond x = *field. */
static int screw(const void *field, const double x[3], double u[3]) {
    const double *edge = field;
    if (edge && x[0] > *edge) return 0;
    u[0] = -2 * x[1];
    u[1] = 2 * x[0];
    u[2] = 0.5;
    return 1;
}

static void straight_line(void **state) {
    (void)state;
    struct postproc_stream s = {0};
    const struct postproc_stream_input in = {.at = uniform, .step = 0.1, .longest = 13};
    const double seed[3] = {1, 2, 3};
    check_equal(postproc_stream_add(&s, &in, seed, 1), 261);
    check_equal(s.lines, 1);
    for (long i = s.first[0]; i < s.first[1]; i++) {
        const double arc = 0.1 * (double)(i - 130);
        check_close(s.x[i][0], 1 + arc * 3 / 13, 1e-12);
        check_close(s.x[i][1], 2 + arc * 4 / 13, 1e-12);
        check_close(s.x[i][2], 3 + arc * 12 / 13, 1e-12);
        check_close(s.speed[i], 13, 1e-12);
    }
    postproc_stream_free(&s);
}

/* The distance from the exact screw line after a length of 6, from radius 1. */
static double screw_error(double step) {
    struct postproc_stream s = {0};
    const struct postproc_stream_input in = {.at = screw, .step = step, .longest = 6};
    const double seed[3] = {1, 0, 0}, speed = sqrt(4.25);
    postproc_stream_add(&s, &in, seed, 0);
    const long n = s.first[1];
    double worst = 0;
    for (long i = 0; i < n; i++) {
        const double t = (double)i * step / speed;
        worst = fmax(worst, hypot(hypot(s.x[i][0] - cos(2 * t), s.x[i][1] - sin(2 * t)), s.x[i][2] - 0.5 * t));
        check_close(s.speed[i], speed, 1e-5);
    }
    check_close((double)(n - 1) * step, 6, 1.01 * step);
    postproc_stream_free(&s);
    return worst;
}

/* To 1e-6 of the radius with steps of 1/40; fourth order. */
static void screw_line(void **state) {
    (void)state;
    const double coarse = screw_error(0.05), fine = screw_error(0.025);
    check_below(fine, 1e-6);
    check_between(log2(coarse / fine), 3.8, 4.3);
}

static int beyond(void *with, const double x[3]) { return x[1] > *(const double *)with; }

/* A line ends before the solid, in slow fluid and where it is told to; without flow at the seed there is none. */
static void ends(void **state) {
    (void)state;
    struct postproc_stream s = {0};
    double edge = 0.5, limit = 0.7;
    struct postproc_stream_input in = {.at = screw, .field = &edge, .step = 0.01, .longest = 100};
    const double outside[3] = {1, 0, 0}, inside[3] = {0, -1, 0}, axis[3] = {0, 0, 0};
    check_equal(postproc_stream_add(&s, &in, outside, 1), 0);
    check_equal(s.lines, 0);
    check_above((double)postproc_stream_add(&s, &in, inside, 0), 10);
    const double *last = s.x[s.first[1] - 1];
    check_between(last[0], 0.48, 0.5);
    check_close(hypot(last[0], last[1]), 1, 1e-6);
    in.slowest = 0.6;
    check_equal(postproc_stream_add(&s, &in, axis, 0), 0); /* only the drift */
    in.field = NULL;
    in.enough = beyond;
    in.with = &limit;
    check_above((double)postproc_stream_add(&s, &in, outside, 0), 10);
    check_between(s.x[s.first[2] - 1][1], 0.7, 0.71);
    check_equal(s.lines, 2);
    postproc_stream_drop(&s);
    check_equal(s.lines, 1);
    postproc_stream_free(&s);
}

/* At x < 0 along z at speed 1; beyond aslant at speed 5, of which 3 along z. */
static int halves(const void *field, const double x[3], double u[3]) {
    (void)field;
    u[0] = 0;
    u[1] = x[0] > 0 ? 4 : 0;
    u[2] = x[0] > 0 ? 3 : 1;
    return 1;
}

/* A straight line has the length of its slope. Of two lines, at speeds 1 and 5, times 1 and 1/3, the mean is that of
 * the velocities, (1 + 5)/(1 + 3) (001: eq. 2.7). A line that stops within does not count. */
static void tortuosity(void **state) {
    (void)state;
    struct postproc_stream s = {0};
    struct postproc_stream_input in = {.at = uniform, .step = 0.07, .longest = 13};
    const double seed[3] = {0, 0, 0}, left[3] = {-1, 0, 0}, right[3] = {1, 0, 0};
    assert_true(isnan(postproc_stream_tortuosity(&s, 2, 0.5, 1.5)));
    postproc_stream_add(&s, &in, seed, 1);
    check_close(postproc_stream_tortuosity(&s, 2, 0.5, 1.5), 13. / 12, 1e-12);
    check_close(postproc_stream_tortuosity(&s, 0, -1, 0.3), 13. / 3, 1e-12);
    assert_true(isnan(postproc_stream_tortuosity(&s, 0, -1, 30)));
    postproc_stream_drop(&s);
    in.at = halves;
    postproc_stream_add(&s, &in, left, 1);
    postproc_stream_add(&s, &in, right, 1);
    check_close(postproc_stream_tortuosity(&s, 2, 0.5, 1.5), 1.5, 1e-12);
    in.longest = 1;
    postproc_stream_add(&s, &in, left, 0);
    check_close(postproc_stream_tortuosity(&s, 2, 0.5, 1.5), 1.5, 1e-12);
    postproc_stream_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(straight_line), cmocka_unit_test(screw_line),
                                       cmocka_unit_test(ends), cmocka_unit_test(tortuosity)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
