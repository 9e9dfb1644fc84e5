/* Tips, fronts, speed and length of made-up cracks. */
#include "base/memory.h"
#include "solid/measure/crack.h"
#include "solid/measure/crack_track.h"
#include "solid/solid.h"
#include "tests/check.h"
#include "tests/solid/make.h"

#include <stdlib.h>

/* Two rows of particles of size h on both sides of y = 0: a cut from x = 0. */
enum { CAPACITY = 40000 };
static double place[CAPACITY][2], edge[CAPACITY];
static const double X[2] = {1, 0};

static struct solid_crack_particles list_begin(void) {
    return (struct solid_crack_particles){.x = place, .size = edge};
}

static void put(struct solid_crack_particles *p, double x, double y, double h) {
    p->x[p->n][0] = x;
    p->x[p->n][1] = y;
    p->size[p->n++] = h;
}

/* The particles of a lattice of spacing h about y = 0 whose distance from a segment is at most h. */
static void put_line(struct solid_crack_particles *p, double h, double x0, double y0, double x1, double y1) {
    const double l = hypot(x1 - x0, y1 - y0), ex = (x1 - x0) / l, ey = (y1 - y0) / l;
    for (double i = floor(fmin(x0, x1) / h) - 2; i <= fmax(x0, x1) / h + 2; i++)
        for (double j = floor(fmin(y0, y1) / h) - 2; j <= fmax(y0, y1) / h + 2; j++) {
            const double x = (i + 0.5) * h - x0, y = (j + 0.5) * h - y0, s = ex * x + ey * y;
            if (s > 0 && s < l && fabs(ex * y - ey * x) < 0.95 * h) put(p, x + x0, y + y0, h);
        }
}

static void cut_is_one_front(void **state) {
    (void)state;
    struct solid_crack_particles p = list_begin(), none = {0};
    put_line(&p, 1, 0, 0, 20, 0);
    solid_crack_sort(&p, X);
    const struct solid_crack_tips t = solid_crack_tips_of(&p, &none, X, NULL);
    assert_true(t.found);
    assert_int_equal(t.fronts, 1);
    check_close(t.tip[0], 19.5, 0);
    check_close(t.tip[1], 0, 0); /* two rows, equally far: on the axis to the bit */
    check_close(t.side[SOLID_CRACK_LEFT][1], 0.5, 0);
    check_close(t.side[SOLID_CRACK_RIGHT][1], -0.5, 0);
    /* seen the other way its tip is its other end, and left is right */
    solid_crack_sort(&p, (double[]){-1, 0});
    const struct solid_crack_tips u = solid_crack_tips_of(&p, &none, (double[]){-1, 0}, NULL);
    check_close(u.tip[0], 0.5, 0);
    check_close(u.side[SOLID_CRACK_LEFT][1], -0.5, 0);
    p.n = 0;
    const struct solid_crack_tips nothing = solid_crack_tips_of(&p, &none, X, NULL);
    assert_false(nothing.found);
    assert_int_equal(nothing.fronts, 0);
    assert_true(isnan(nothing.tip[0]) && isnan(nothing.side[0][1]));
}

/* A stem of 20 and branches 40 long at 28 degrees up and 12 down. */
static void fork_has_two_fronts(void **state) {
    (void)state;
    const double up = 28 * M_PI / 180, down = 12 * M_PI / 180, none_yet = 1.0;
    for (int refined = 0; refined < 2; refined++) {
        const double h = refined ? 0.5 : 1;
        struct solid_crack_particles p = list_begin(), none = {0};
        put_line(&p, h, 0, 0, 20, 0);
        put_line(&p, h, 20, 0, 20 + 40 * cos(up), 40 * sin(up));
        put_line(&p, h, 20, 0, 20 + 40 * cos(down), -40 * sin(down));
        solid_crack_sort(&p, X);
        const struct solid_crack_tips t = solid_crack_tips_of(&p, &none, X, (double[]){0, 0});
        assert_int_equal(t.fronts, 2);
        check_close(t.side[SOLID_CRACK_LEFT][0], 20 + 40 * cos(up), 1.5 * h);
        check_close(t.side[SOLID_CRACK_LEFT][1], 40 * sin(up), 1.5 * h);
        check_close(t.side[SOLID_CRACK_RIGHT][0], 20 + 40 * cos(down), 1.5 * h);
        check_close(t.side[SOLID_CRACK_RIGHT][1], -40 * sin(down), 1.5 * h);
        check_close(t.tip[1], t.side[SOLID_CRACK_RIGHT][1], none_yet * h); /* the flatter one leads */
    }
}

/* A side branch longer by two particles is not a front, one longer by five is; a crack with a bulge is still one crack.
 */
static void spur_is_no_front(void **state) {
    (void)state;
    static const struct { int beyond, fronts; } expected[] = {{2, 1}, {5, 2}};
    for (int k = 0; k < 2; k++) {
        struct solid_crack_particles p = list_begin(), none = {0};
        put_line(&p, 1, 0, 0, 30, 0);
        for (int j = 1; j < 5; j++) put(&p, 20.5, j + 0.5, 1);
        for (int i = 0; i < expected[k].beyond; i++) put(&p, 20.5 + i, 5.5, 1);
        solid_crack_sort(&p, X);
        assert_int_equal(solid_crack_tips_of(&p, &none, X, NULL).fronts, expected[k].fronts);
    }
}

/* Damage of its own farther on is not the tip, while there is an initial crack; a gap of two particles is passed. */
static void tip_hangs_on_the_cut(void **state) {
    (void)state;
    static double initial_place[64][2], initial_size[64];
    struct solid_crack_particles p = list_begin(), none = {0}, initial = {.x = initial_place, .size = initial_size};
    for (int i = 0; i < 10; i++)
        for (int side = -1; side <= 1; side += 2) put(&initial, i + 0.5, 0.5 * side, 1);
    put_line(&p, 1, 0, 0, 10, 0);
    put_line(&p, 1, 12, 0, 15, 0);
    for (int j = 0; j < 30; j++) put(&p, 59.5, j + 0.5, 1);
    solid_crack_sort(&p, X);
    solid_crack_sort(&initial, X);
    const struct solid_crack_tips t = solid_crack_tips_of(&p, &initial, X, NULL);
    check_close(t.tip[0], 14.5, 0);
    assert_int_equal(t.fronts, 1);
    check_close(solid_crack_tips_of(&p, &none, X, NULL).tip[0], 59.5, 0);
    /* initial particles that no longer exist (refined) still mark the start of the crack */
    p.n = 0;
    put_line(&p, 0.5, 3, 0, 12, 0);
    solid_crack_sort(&p, X);
    check_close(solid_crack_tips_of(&p, &initial, X, NULL).tip[0], 11.75, 0);
}

/* One front along y = 0 at 1500 until x = 30, then two at 30 degrees at 1200, quantised to a lattice; the lead changes
 * from one branch to the other now and then. */
static void speed_and_length_of_a_moving_tip(void **state) {
    (void)state;
    const double h = 0.5e-3, window = 2e-6, dt = 1e-7, c = cos(M_PI / 6), s = sin(M_PI / 6), turn = 20e-6;
    struct solid_crack_track *k = solid_crack_track_new(window, h);
    double top = 0, straight = 0, branch = 0, leap = 0, length = 0;
    for (int step = 0; step <= 400; step++) {
        const double t = step * dt, after = fmax(t - turn, 0), x = 1500 * fmin(t, turn);
        struct solid_crack_tips tips = {.found = 1, .fronts = after > 0 ? 2 : 1};
        for (int side = 0; side < 2; side++) {
            const double lag = 1 + 0.01 * ((side + step / 40) % 2), sign = side ? -1 : 1;
            tips.side[side][0] = h * floor((x + 1200 * after * lag * c) / h);
            tips.side[side][1] = sign * h * (0.5 + floor(1200 * after * lag * s / h));
        }
        const int lead = tips.side[1][0] > tips.side[0][0];
        memcpy(tips.tip, tips.side[lead], sizeof tips.tip);
        const struct solid_crack_motion m = solid_crack_track_add(k, t, &tips, X);
        if (step == 0) assert_true(isnan(m.speed));
        if (step == 1) assert_false(isnan(m.speed));
        if (t > 5e-6 && t < turn) {
            straight = check_worst(straight, m.speed - 1500);
            check_close(m.length, x, h);
        }
        if (t > turn + 5e-6) branch = check_worst(branch, m.speed - 1200), leap = fmax(leap, m.speed);
        if (t > window) top = fmax(top, m.speed);
        length = m.length;
    }
    solid_crack_track_free(k);
    const double grain = 2 * h / window; /* both ends of the window are rounded to the lattice */
    check_close(straight, 0, grain);
    check_close(branch, 0, 1.5 * grain);
    check_below(leap, 1200 + 1.5 * grain);
    check_between(top, 1500 - grain, 1500 + 1.5 * grain);
    check_close(length, 30e-3 + 2 * 24e-3, 0.03 * 78e-3);
}

/* If no sample is a window old, the first one is used; a window longer than the step finds exactly the right sample. */
static void window_is_kept(void **state) {
    (void)state;
    struct solid_crack_track *k = solid_crack_track_new(1, 1);
    double speed[6];
    for (int i = 0; i < 6; i++) {
        struct solid_crack_tips tips = {.found = 1, .fronts = 1};
        tips.side[0][0] = tips.side[1][0] = tips.tip[0] = i * i; /* x = 4 t^2 at t = i/2 */
        speed[i] = solid_crack_track_add(k, 0.5 * i, &tips, X).speed;
    }
    solid_crack_track_free(k);
    check_close(speed[1], 2, 1e-14); /* (1 - 0)/0.5 */
    check_close(speed[2], 4, 1e-14);
    for (int i = 2; i < 6; i++) check_close(speed[i], i * i - (i - 2) * (i - 2), 1e-12);
}

/* Ranks' particles together make the list that one rank has. */
static void gathered_from_ranks(void **state) {
    (void)state;
    struct solid *s = make((struct make){.sites = {24, 10, 6}});
    double *damage = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *damage);
    const double h = SPACING;
    for (int i = 0; i < s->n; i++)
        damage[i] = fabs(s->x0[1][i] - 5 * h) < h && s->x0[0][i] < 15 * h && s->x0[2][i] < h ? 0.4 : 0.3;
    struct solid_crack_particles p = solid_crack_gather(s, damage, 0.35, X), none = {0};
    assert_int_equal(p.n, 30);
    for (long i = 0; i < p.n; i++) {
        check_close(p.x[i][0], (14.5 - (double)(i / 2)) * h, 1e-12);
        check_close(p.x[i][1], (i % 2 ? 5.5 : 4.5) * h, 1e-12);
        check_close(p.size[i], h, 1e-12);
    }
    const struct solid_crack_tips t = solid_crack_tips_of(&p, &none, X, NULL);
    check_close(t.tip[0], 14.5 * h, 1e-12);
    check_close(t.tip[1], 5 * h, 1e-12);
    solid_crack_particles_free(&p);
    memory_free(damage);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cut_is_one_front),
        cmocka_unit_test(fork_has_two_fronts),
        cmocka_unit_test(spur_is_no_front),
        cmocka_unit_test(tip_hangs_on_the_cut),
        cmocka_unit_test(speed_and_length_of_a_moving_tip),
        cmocka_unit_test(window_is_kept),
        cmocka_unit_test(gathered_from_ranks),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
