/* Arms of made-up cracks with known angles and speeds, turned on a fixed lattice. */
#include "base/par.h"
#include "postproc/data/crack_arms.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

/* Spacing 1; a crack damages the particles nearer than 0.95, as a cut does that passes between two rows. The tip passes
 * a point of a segment at its time. Speeds and times are in units in which a Rayleigh wave runs 1. */
enum { CAPACITY = 20000, SIDE = 90 };
static const double HALF = 0.95, WINDOW = 20, FIT = 12;
/* Degrees. A lattice's rows give the middle of a crack to half a spacing, over the length of a fit; perturbed particles
 * scatter over its width. */
static const double slack[2] = {2.4, 4};
struct segment {
    double from[2], to[2], t, speed; /* t: the tip is at `from`; speed 0: an initial crack */
};
struct sample {
    long n;
    double x[CAPACITY][2], t[CAPACITY];
    char initial[CAPACITY];
};

static const double degree = M_PI / 180;

/* Turns and moves the segments, damages the particles of the lattice, and finds the arms. jitter: of particles. */
static struct postproc_arms *arms_of(int n, const struct segment *segment, double angle, double jitter,
                                     struct sample *s) {
    const double c = cos(angle * degree), d = sin(angle * degree), every = 0.25;
    s->n = 0;
    srand(7);
    for (int j = -SIDE; j < SIDE; j++)
        for (int i = -SIDE; i < SIDE; i++) {
            double x[2] = {i + 0.5, j + 0.5}, t = INFINITY;
            for (int k = 0; k < 2; k++) x[k] += jitter * (2. * rand() / RAND_MAX - 1);
            int initial = 0;
            for (int k = 0; k < n; k++) {
                const struct segment *g = &segment[k];
                const double e[2] = {g->to[0] - g->from[0], g->to[1] - g->from[1]}, l = hypot(e[0], e[1]);
                const double at[2] = {c * x[0] + d * x[1] - g->from[0], c * x[1] - d * x[0] - g->from[1]};
                const double along = (e[0] * at[0] + e[1] * at[1]) / l, across = (e[0] * at[1] - e[1] * at[0]) / l;
                if (along < 0 || along > l || fabs(across) > HALF) continue;
                t = fmin(t, g->speed > 0 ? g->t + along / g->speed : 0);
                initial |= g->speed == 0;
            }
            if (isinf(t)) continue;
            assert_true(s->n < CAPACITY);
            memcpy(s->x[s->n], x, sizeof x);
            s->t[s->n] = every * ceil(t / every); /* sampled */
            s->initial[s->n++] = (char)initial;
        }
    const struct postproc_arms_input in = {.n = s->n,
                                           .x = (const double(*)[2])s->x,
                                           .t = s->t,
                                           .initial = s->initial,
                                           .spacing = 1,
                                           .fit = FIT,
                                           .window = WINDOW,
                                           .rayleigh = 1};
    return postproc_crack_arms_of(&in);
}

static const double turns[] = {0, 7, 15, 30, 45, 60, 77, 90, 113, 180, 251, 330};
enum { TURNS = sizeof turns / sizeof *turns };
static const double jitters[2] = {0, 0.2};

static double off(double a, double b) { return fabs(remainder(a - b, 360)); }

/* A place of the unturned crack, turned. */
static double away(const double x[2], double angle, double a, double b) {
    const double c = cos(angle * degree), s = sin(angle * degree);
    return hypot(x[0] - (c * a - s * b), x[1] - (s * a + c * b));
}

static struct sample sample;

/* A notch, and a crack that runs straight ahead at 0.5 for a length of 40. */
static void straight(void **state) {
    (void)state;
    const struct segment s[2] = {{{-30, 0.03}, {-10, 0.03}, 0, 0}, {{-10, 0.03}, {30, 0.03}, 5, 0.5}};
    for (int j = 0; j < 2; j++)
        for (int k = 0; k < TURNS; k++) {
            struct postproc_arms *a = arms_of(2, s, turns[k], jitters[j], &sample);
            assert_int_equal(a->arms, 1);
            assert_int_equal(a->forks, 0);
            check_below(off(a->arm[0].first.value, turns[k]), slack[j]);
            check_below(off(a->arm[0].last.value, turns[k]), slack[j]);
            check_below(off(a->arm[0].last.value, turns[k]), a->arm[0].last.error);
            check_between(a->arm[0].last.error, 2, 5);
            check_below(away(a->arm[0].end, turns[k], 30, 0), 1.5);
            check_below(away(a->arm[0].begin, turns[k], -10, 0), 2);
            check_close(a->arm[0].length, 40, 2);
            check_close(a->arm[0].speed, 0.5, 0.03);
            check_close(a->arm[0].top, 0.5, 2. / WINDOW);
            assert_int_equal(a->arm[0].above, 0);
            assert_int_equal(a->arm[0].jumps, 0);
            check_close(a->arm[0].t_begin, 5, 3);
            check_close(a->arm[0].t_end, 85, 3);
            assert_false(a->arm[0].alone);
            postproc_crack_arms_free(a);
        }
}

/* A stem, and arms at 25 degrees to the left and 15 to the right, at 0.5 and 0.35; the left one forks again at 40. */
static void forked_twice(void **state) {
    (void)state;
    const double l = 25 * degree, r = -15 * degree, m[2] = {34 * cos(l), 34 * sin(l)}, u = 60 * degree, v = 5 * degree;
    const struct segment s[6] = {{{-40, 0}, {-25, 0}, 0, 0},
                                 {{-25, 0}, {0, 0}, 0, 0.5},
                                 {{0, 0}, {m[0], m[1]}, 50, 0.5},
                                 {{0, 0}, {50 * cos(r), 50 * sin(r)}, 50, 0.35},
                                 {{m[0], m[1]}, {m[0] + 20 * cos(u), m[1] + 20 * sin(u)}, 118, 0.5},
                                 {{m[0], m[1]}, {m[0] + 20 * cos(v), m[1] + 20 * sin(v)}, 118, 0.5}};
    for (int j = 0; j < 2; j++)
        for (int k = 0; k < TURNS; k++) {
            struct postproc_arms *a = arms_of(6, s, turns[k], jitters[j], &sample);
            assert_int_equal(a->arms, 5);
            assert_int_equal(a->forks, 2);
            assert_int_equal(a->fork[0].arm, 0);
            assert_int_equal(a->fork[0].arms, 2);
            check_close(a->fork[0].angle, 40, 6);
            check_close(a->fork[1].angle, 55, 6);
            check_below(away(a->fork[0].place, turns[k], 0, 0), 2.5);
            check_below(away(a->fork[1].place, turns[k], m[0], m[1]), 2.5);
            check_close(a->fork[0].t, 50, 2 * 2.5); /* 2.5 spacings at 0.5 */
            double speed[2] = {0, 0};
            for (int i = 1; i < a->arms; i++) {
                const struct postproc_arm *b = &a->arm[i];
                if (b->parent != 0) continue;
                const int left = remainder(b->first.value - turns[k], 360) > 5;
                check_below(off(b->first.value, turns[k] + (left ? 25 : -15)), 4.5);
                speed[left] = b->speed;
            }
            check_close(speed[1], 0.5, 0.04);
            check_close(speed[0], 0.35, 0.03);
            for (int i = 0; i < a->arms; i++) assert_int_equal(a->arm[i].above + a->arm[i].jumps, 0);
            postproc_crack_arms_free(a);
        }
}

/* Two parallel cracks six spacings apart are two; the second stops halfway. */
static void parallel(void **state) {
    (void)state;
    const struct segment s[4] = {{{-30, 3}, {-20, 3}, 0, 0},
                                 {{-20, 3}, {25, 3}, 0, 0.5},
                                 {{-30, -3}, {-20, -3}, 0, 0},
                                 {{-20, -3}, {5, -3}, 0, 0.5}};
    for (int j = 0; j < 2; j++)
        for (int k = 0; k < TURNS; k++) {
            struct postproc_arms *a = arms_of(4, s, turns[k], jitters[j], &sample);
            assert_int_equal(a->arms, 2);
            assert_int_equal(a->forks, 0);
            const int whole = a->arm[1].length > a->arm[0].length;
            check_close(a->arm[whole].t_end, 90, 4);
            check_close(a->arm[1 - whole].t_end, 50, 4); /* it stops, and its speed is not that of a longer time */
            check_close(a->arm[1 - whole].speed, 0.5, 0.04);
            check_below(away(a->arm[1 - whole].end, turns[k], 5, -3), 1.5);
            postproc_crack_arms_free(a);
        }
}

/* A front that forms eight spacings ahead while the tip stands: a jump, and no window spans it. The gap breaks
 * later. */
static void jump(void **state) {
    (void)state;
    const struct segment s[4] = {
        {{-30, 0}, {-20, 0}, 0, 0}, {{-20, 0}, {0, 0}, 0, 0.5}, {{0, 0}, {8, 0}, 80, 0.5}, {{8, 0}, {30, 0}, 41, 0.5}};
    for (int k = 0; k < TURNS; k++) {
        struct postproc_arms *a = arms_of(4, s, turns[k], 0, &sample);
        assert_int_equal(a->arms, 1);
        assert_int_equal(a->arm[0].jumps, 1);
        assert_int_equal(a->arm[0].above, 0);
        check_close(a->arm[0].top, 0.5, 2. / WINDOW);
        check_close(a->arm[0].speed, 0.5, 0.04);
        postproc_crack_arms_free(a);
    }
}

/* A crack that creeps by half a spacing in a window has no speed that a window could tell; its mean is still right. */
static void below_the_grain(void **state) {
    (void)state;
    const struct segment s[2] = {{{-30, 0}, {-10, 0}, 0, 0}, {{-10, 0}, {20, 0}, 0, 0.025}};
    for (int k = 0; k < TURNS; k++) {
        struct postproc_arms *a = arms_of(2, s, turns[k], 0, &sample);
        assert_int_equal(a->arms, 1);
        if (!isnan(a->arm[0].top)) check_below(a->arm[0].top, 3. / WINDOW);
        check_close(a->arm[0].speed, 0.025, 0.002);
        check_close(postproc_crack_arms_grain(&(struct postproc_arms_input){.spacing = 1, .window = WINDOW}),
                    1. / WINDOW, 1e-15);
        postproc_crack_arms_free(a);
    }
}

/* A crack that begins alone in the middle of a plate has an arm to each side; spots of three particles are none. */
static void alone(void **state) {
    (void)state;
    const struct segment s[4] = {{{2, 0}, {30, 0}, 10, 0.4},
                                 {{2, 0}, {-20, 0}, 10, 0.4},
                                 {{0, 20}, {2.5, 20}, 10, 1},
                                 {{10, -20}, {11, -20}, 10, 1}};
    for (int k = 0; k < TURNS; k++) {
        struct postproc_arms *a = arms_of(4, s, turns[k], 0, &sample);
        assert_int_equal(a->arms, 2);
        assert_true(a->arm[0].alone && a->arm[1].alone);
        check_close(off(a->arm[0].last.value, a->arm[1].last.value), 180, 4);
        check_close(a->arm[0].length + a->arm[1].length, 50 - 4, 2); /* they begin a band from where it began */
        postproc_crack_arms_free(a);
    }
    struct postproc_arms *none = postproc_crack_arms_of(&(struct postproc_arms_input){.spacing = 1, .window = 1});
    assert_int_equal(none->arms, 0);
    postproc_crack_arms_free(none);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(straight),        cmocka_unit_test(forked_twice),
                                       cmocka_unit_test(parallel),        cmocka_unit_test(jump),
                                       cmocka_unit_test(below_the_grain), cmocka_unit_test(alone)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
