/* A stage that waits for a steady permeability ends when it is steady, whatever the window, and not before. */
#include "coupling/interface/deposit.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <math.h>
#include <stdio.h>

static const char *const array =
    "title: test\n"
    "domain: {size: [1, 1, 1], cells: [8, 8, 8]}\n"
    "fluid:\n"
    "  density: 1\n"
    "  viscosity: 1\n"
    "  driving: {type: pressure_gradient, direction: y, value: 1.0e-3}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
    "  materials:\n    - {name: rigid, youngs_modulus: 1, density: 1, horizon_ratio: 2}\n"
    "  bodies:\n    - {name: a, shape: sphere, centre: [0.5, 0.5, 0.5], radius: 0.3}\n"
    "coupling:\n  surface: shape\n  medium: {low: [0, 0, 0], high: [1, 1, 1]}\n";

struct end {
    long step;
    double k, settled; /* at the end of the stage, and much later */
    struct steady_found found;
};

static struct end run_until(double change, int window, const char *diffusion) {
    char stages[256];
    const char *const set[] = {diffusion};
    snprintf(stages, sizeof stages,
             "stages: [{name: flow, steps: 4000, cfl: 1, solid: rigid, until: {change: %g, window: %d}}]\n", change,
             window);
    struct scene *scene = scene_of(array, stages, 1, set);
    struct run *r = run_new(scene);
    struct end end = {0};
    step_begin_stage(r);
    while (!steady_has_ended(r) && r->stage_step < 4000) {
        step_advance(r);
        if (steady_is_due(r, r->stage_step)) steady_sample(r, &end.found);
    }
    end.step = r->stage_step;
    end.k = deposit_measure(r).permeability;
    for (int k = 0; k < 400; k++) step_advance(r);
    end.settled = deposit_measure(r).permeability;
    assert_int_equal(steady_has_ended(r), 1);
    step_begin_stage(r); /* in the middle of the stage it is kept */
    assert_int_equal(steady_has_ended(r), 1);
    r->stage_step = 0;
    step_begin_stage(r);
    assert_int_equal(steady_has_ended(r), 0);
    run_free(r);
    scene_free(scene);
    return end;
}

static void steady_within_the_change(void **state) {
    (void)state;
    const int window[] = {2, 10, 20, 50};
    const double change[] = {1e-2, 1e-4, 1e-6};
    for (int c = 0; c < 3; c++)
        for (int w = 0; w < 4; w++) {
            if (check_skips(4 * c + w, 5)) continue;
            const struct end e = run_until(change[c], window[w], "fluid.diffusion=explicit");
            check_below(e.step, 620); /* 1e-6 are left after 380; an eighth more, and three windows */
            assert_int_equal(e.step % window[w], 0);
            check_below(e.found.spread[0], change[c]);
            check_below(e.found.left[0], change[c]);
            check_below(fabs(e.k / e.settled - 1), 1.5 * change[c]); /* what is left is an estimate */
        }
    /* the last values can be had no better than to round-off, and that is found steady too */
    const struct end e = run_until(1e-11, 20, "fluid.diffusion=explicit");
    check_below(e.step, 1000);
    check_relative(e.k, e.settled, 1e-10);
}

static void implicit_steps(void **state) {
    (void)state;
    const struct end e = run_until(5e-4, 10, "fluid.diffusion=implicit"); /* k varies by 2e-4 */
    check_below(e.step, 80);
    check_relative(e.k, e.settled, 1e-3);
}

/* Values that come to 1 at last, by time in windows. */
typedef double signal(double t);
static double decays(double t) { return 1 - 0.5 * exp(-t / 3); }
static double decays_slowly(double t) { return 1 - 0.04 * exp(-t / 40); }
static double swings_first(double t) { return 1 + 0.5 * exp(-t / 0.7) * cos(3 * t) + 0.04 * exp(-t / 15); }
static double swings_slowly(double t) { return 1 + 0.3 * exp(-t / 6) * cos(1.3 * t) - 0.02 * exp(-t / 25); }
static double overshoots(double t) { return 1 - exp(-t / 2) + 0.3 * exp(-t / 10); }
static double creeps_in_noise(double t) {
    return 1 + 0.04 * exp(-t / 20) + 2e-4 * sin(1e4 * t * t); /* as of implicit diffusion */
}
static double stands(double t) { return 1 + 0 * t; }
static double varies(double t) { return 1 + 4e-4 * sin(1e4 * t * t); }
static double grows(double t) { return 1 + 1e-3 * t; }

/* Windows until it is found steady; -1: not within 2000. */
static long windows_until(signal *signal_at, int samples, double change, double *left) {
    struct trend s = {0};
    for (long w = 1; w <= 2000; w++) {
        int is_period = 0;
        for (int k = 1; k <= samples; k++)
            is_period = trend_add(&s, signal_at((double)(w - 1) + (double)k / samples), k == samples);
        const struct trend_found found = trend_estimate(&s, s.each > 2 ? 1 : 2 / s.each);
        if (!is_period || !trend_count(&s, &found, change)) continue;
        *left = fabs(signal_at((double)w) - 1);
        return w;
    }
    return -1;
}

/* What is found steady is within the change, or nearly: whatever swung at first, with few and many samples a window. A
 * value that varies by no more than the change is steady, one that grows is not. */
static void signals(void **state) {
    (void)state;
    signal *const end[] = {decays, decays_slowly, swings_first, swings_slowly, overshoots, creeps_in_noise, stands};
    static const double change[] = {3e-2, 1e-2, 1e-3};
    static const int samples[] = {2, 5, 20};
    double left = NAN;
    for (size_t q = 0; q < sizeof end / sizeof *end; q++)
        for (int c = 0; c < 3; c++)
            for (int n = 0; n < 3; n++) {
                const long w = windows_until(end[q], samples[n], change[c], &left);
                check_above(w, 0);
                check_below(w, 600);
                check_below(left, 1.5 * change[c]);
            }
    check_between(windows_until(varies, 20, 1e-3, &left), 0, 40);
    check_equal(windows_until(varies, 20, 1e-4, &left), -1);
    check_equal(windows_until(grows, 20, 1e-3, &left), -1);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(steady_within_the_change), cmocka_unit_test(implicit_steps),
                                       cmocka_unit_test(signals)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
