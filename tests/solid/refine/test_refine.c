/* Refinement: positions, areas, loads and motion of new particles, and the unchanged rest. */
#include "tests/solid/make_plate.h"
#include "solid/body/cloud.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/store.h"
#include "solid/imposed/constraint.h"
#include "solid/refine/refine.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "tests/check.h"

static struct solid_refinement levels(int n) {
    return (struct solid_refinement){.levels = n, .low = {-1, -1}, .high = {1, 1}};
}

/* Particles whose centres are nearer to (x, y) spacings than r, of the level. */
static uint8_t *near(const struct solid *s, double x, double y, double r, int level) {
    uint8_t *mark = calloc((size_t)s->n + 1, 1);
    for (int h = 0; h < s->n; h++)
        mark[h] = solid_refine_level(s, h) == level && hypot(s->x0[0][h] / SPACING - x, s->x0[1][h] / SPACING - y) < r;
    return mark;
}

static long refine_near(struct solid *s, double x, double y, double r, int level) {
    uint8_t *mark = near(s, x, y, r, level);
    const long refined = solid_refine_marked(s, mark);
    free(mark);
    return refined;
}

/* Area in spacings^2 over the whole plate. */
static double area_of(const struct solid *s) {
    double sum = 0;
    for (int h = 0; h < s->n; h++) sum += s->volume[h] / (SPACING * SPACING * THICKNESS);
    return par_sum(sum);
}

/* One refined family: the coarse particles beside it have the areas of 000 (eq. 38), the fine ones a quarter. In 000 a
 * particle may have two or four fine neighbours; here that occurs only at an edge of the body. */
static void test_eq38(void **state) {
    (void)state;
    const struct solid_refinement refinement = levels(1);
    struct solid *s = make((struct make){.sites = {20, 20}, .refinement = &refinement});
    check_equal(refine_near(s, 9.5, 9.5, 0.1, 0), 29);
    static const double left[6] = {1, 1 - 1. / 16, 1 - 3. / 16, 1 - 1. / 4, 1 - 6. / 16, 1 - 7. / 16};
    long kinds[6] = {0};
    const struct solid_cloud *t = s->family->cloud[0];
    for (long i = 0; i < t->n; i++) {
        int n = 0;
        if (t->size[i] == 0.5) {
            check_close(t->volume[i], 0.25, 1e-15);
            continue;
        }
        for (long j = 0; j < t->n; j++)
            n += t->size[j] == 0.5 && fabs(t->place[0][j] - t->place[0][i]) < 0.6 &&
                 fabs(t->place[1][j] - t->place[1][i]) < 0.6;
        check_at_most(n, 5);
        kinds[n]++;
        check_close(t->volume[i], left[n], 1e-15);
    }
    for (int n = 1; n <= 5; n++) assert_int_equal(kinds[n] > 0, n % 2);
    check_close(area_of(s), 400, 400 * 1e-12);
    solid_free(s);
}

/* A disc with a hole off its middle, cells cut every way. */
static struct solid *disc(const struct solid_refinement *refinement) {
    static const double c = 12 * SPACING, r = 11.3 * SPACING, x = 14.2 * SPACING, y = 10.9 * SPACING,
                        q = 3.37 * SPACING;
    static const double corner[2][2] = {{c - r, c}, {c + r, c}}, centre[2][2] = {{c, c}, {c, c}};
    static const double hole[2][2] = {{x - q, y}, {x + q, y}}, middle[2][2] = {{x, y}, {x, y}};
    static const signed char turn[2] = {1, 1};
    const struct solid_outline outline[2] = {{0, 2, corner, centre, turn}, {1, 2, hole, middle, turn}};
    return make((struct make){.sites = {24, 24}, .outlines = 2, .outline = outline, .refinement = refinement});
}

static void test_total(void **state) {
    (void)state;
    const double area = M_PI * (11.3 * 11.3 - 3.37 * 3.37);
    for (int level = 1; level <= 3; level++) {
        const struct solid_refinement refinement = levels(level);
        struct solid *s = disc(&refinement);
        check_close(area_of(s) / area, 1, 1e-12);
        for (int k = 0; k < level; k++) {
            check_above(refine_near(s, 3, 8, 2.5, k), 0);
            check_close(area_of(s) / area, 1, 1e-12);
            check_above(refine_near(s, 17, 10.9, 2, k), 0);
            check_close(area_of(s) / area, 1, 1e-12);
        }
        assert_int_equal(solid_refine_finest(s), level);
        for (int h = 0; h < s->n; h++) check_above(s->volume[h], 0);
        solid_free(s);
    }
}

/* Within a particle's horizon all others are at most one level coarser; nothing is enclosed. */
static void test_levels(void **state) {
    (void)state;
    const struct solid_refinement refinement = levels(3);
    struct solid *s = make((struct make){.sites = {40, 30}, .refinement = &refinement});
    for (int k = 0; k < 3; k++) check_above(refine_near(s, 20, 15, 0.8, k), 0);
    check_above(refine_near(s, 27, 15, 0.8, 0), 0);
    const struct solid_cloud *t = s->family->cloud[0];
    long of_level[4] = {0};
    for (long i = 0; i < t->n; i++) {
        of_level[(int)rint(-log2(t->size[i]))]++;
        int about = 0;
        for (long j = 0; j < t->n; j++) {
            const double dx = fabs(t->place[0][j] - t->place[0][i]), dy = fabs(t->place[1][j] - t->place[1][i]);
            if (hypot(dx, dy) <= 3 * t->size[i] && t->size[j] < t->size[i])
                assert_true(hypot(dx, dy) > 3 * t->size[j] || t->size[j] == t->size[i] / 2);
            about += j != i && fmax(dx, dy) <= t->size[i] / 2;
        }
        check_at_most(about, 5);
    }
    for (int k = 0; k < 4; k++) check_above(of_level[k], 20);
    check_close(area_of(s), 1200, 1200 * 1e-12);
    solid_free(s);
}

/* Linear fields are met at every new particle, at edges and corners too. */
static void test_linear(void **state) {
    (void)state;
    const struct solid_refinement refinement = levels(2);
    struct solid *s = make((struct make){.sites = {14, 10}, .refinement = &refinement});
    for (int round = 0; round < 3; round++) {
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 2; c++) {
                const double x = s->x0[0][h] / SPACING, y = s->x0[1][h] / SPACING;
                const double d = 1e-6 * (1 + (c + 2) * x - 3 * y), v = 5 - x + (1 - 3 * c) * y;
                if (round) check_close(s->d[c][h], d, 1e-19);
                if (round) check_close(s->v[c][h], v, 1e-13);
                s->d[c][h] = d;
                s->v[c][h] = v;
            }
        solid_ghosts_update(s);
        if (round < 2) check_above(refine_near(s, 2, 2, 3, round), 0);
    }
    solid_free(s);
}

/* Momentum of a plate that flies and shakes, refined on its way. */
static void test_momentum(void **state) {
    (void)state;
    for (int verlet = 0; verlet < 2; verlet++) {
        const struct solid_refinement refinement = levels(2);
        struct solid *s = make((struct make){.sites = {20, 16}, .refinement = &refinement});
        s->stage = (struct solid_stage){.integrator = verlet ? SOLID_VERLET : SOLID_RK3, .damping_relative = 1e16};
        shake(s, 1e-3, 1);
        for (int level = 0; level < 2; level++) {
            check_above(refine_near(s, 9, 7, 1.2, level), 0);
            double before[2] = {0}, after[2] = {0}, size[1] = {0};
            for (int h = 0; h < s->n; h++) {
                for (int c = 0; c < 2; c++) before[c] += s->volume[h] * s->v[c][h];
                size[0] += s->volume[h] * (fabs(s->v[0][h]) + fabs(s->v[1][h]));
            }
            solid_integrate(s, step_of(0.1), 40);
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < 2; c++) after[c] += s->volume[h] * s->v[c][h];
            par_sum_array(before, 2);
            par_sum_array(after, 2);
            par_sum_array(size, 1);
            for (int c = 0; c < 2; c++) check_close((after[c] - before[c]) / size[0], 0, 1e-13);
        }
        solid_free(s);
    }
}

/* A traction acts in full, whatever particles are behind the edge; constraints apply to new particles. */
static void test_held(void **state) {
    (void)state;
    for (int over = 0; over < 2; over++) {
        struct solid_refinement refinement = levels(2);
        refinement.held_refine = 1;
        const struct solid_load load = {SOLID_LOAD_EDGE,
                                        .edge = {{3.3 * SPACING, 10 * SPACING}, {11.9 * SPACING, 10 * SPACING}},
                                        .traction = {2e6, 5e6}, .over_horizon = over};
        const struct solid_constraint constraint = {.high = {1, 3 * SPACING}, .direction = {1, 1}};
        struct solid *s = make((struct make){.sites = {16, 10},
                                             .loads = 1,
                                             .load = &load,
                                             .constraints = 1,
                                             .constraint = &constraint,
                                             .refinement = &refinement});
        for (int level = 0; level < 2; level++) {
            check_above(refine_near(s, 7, 9, 2, level), 0);
            check_above(refine_near(s, 7, 2, 2, level), 0);
            double sum[3] = {0};
            for (int h = 0; h < s->n; h++) {
                for (int c = 0; c < 2; c++) sum[c] += s->load[c][h] * s->volume[h];
                sum[2] += solid_refine_level(s, h) == level + 1 && s->load[1][h] != 0;
                assert_int_equal(s->flag[h] & SOLID_HELD_X ? 1 : 0, s->x0[1][h] < 3.0001 * SPACING);
            }
            par_sum_array(sum, 3);
            const double area = 8.6 * SPACING * THICKNESS;
            check_above(sum[2], 4);
            check_close(sum[0] / (2e6 * area), 1, 1e-12);
            check_close(sum[1] / (5e6 * area), 1, 1e-12);
        }
        solid_free(s);
    }
    /* kept: particles under constraints stay as they are */
    const struct solid_refinement refinement = levels(2);
    const struct solid_constraint constraint = {.high = {1, 3 * SPACING}, .direction = {1, 1}};
    struct solid *s =
        make((struct make){.sites = {16, 10}, .constraints = 1, .constraint = &constraint, .refinement = &refinement});
    assert_int_equal(refine_near(s, 8, 1, 0.8, 0), 0);
    check_above(refine_near(s, 8, 5, 1, 0), 0);
    for (int h = 0; h < s->n; h++)
        if (s->x0[1][h] < 2.4 * SPACING) assert_int_equal(solid_refine_level(s, h), 0);
    solid_free(s);
}

/* A crack stays one: every new bond across it is broken, none elsewhere, and nothing is released. */
static void test_crack(void **state) {
    (void)state;
    const double point[2][3] = {{-SPACING, 8 * SPACING}, {9.99 * SPACING, 8 * SPACING}};
    const struct solid_cut cut = {2, point};
    const struct solid_refinement refinement = levels(2);
    struct solid *s =
        make((struct make){.sites = {20, 16}, .brittle = 1, .cuts = 1, .cut = &cut, .refinement = &refinement});
    struct solid_family_view view;
    for (int level = 0; level < 2; level++) {
        check_above(refine_near(s, 9.5, 7.5, 0.8, level), 0);
        long crossing = 0, other = 0;
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                const double y = s->x0[1][h] / SPACING - 8, y2 = y + view.xi[b][1] / SPACING, f = y / (y - y2);
                const double x = (s->x0[0][h] + f * view.xi[b][0]) / SPACING;
                if ((y < -1e-9 && y2 > 1e-9) || (y > 1e-9 && y2 < -1e-9)) {
                    if (x < 9.98) assert_int_equal(view.intact[b], 0);
                    crossing += x < 9.98;
                } else if (fabs(y) > 0.6 && fabs(y2) > 0.6) {
                    other += !view.intact[b];
                }
            }
        }
        check_above(par_sum_long(crossing), 300);
        assert_int_equal(par_sum_long(other), 0);
        check_equal(par_sum(s->e_fracture), 0);
    }
    solid_free(s);
}

/* Refined from the start, with the horizon kept or scaled: the displacement given is that of each place. Periodic sides
 * are none. */
static void test_start(void **state) {
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        const struct solid_refined start = {.low = {-1, 0}, .high = {7.1 * SPACING, 1}, .level = 1};
        struct solid_refinement refinement = levels(1);
        refinement.horizon_kept = kind == 0;
        refinement.interface_corrected = kind == 2;
        refinement.starts = 1;
        refinement.start = &start;
        const struct solid_initial initial = {
            .along = 0, .centre = 7.2 * SPACING, .width = 3 * SPACING, .displacement = {1e-5, -2e-5}};
        struct solid *s = make((struct make){
            .sites = {16, 10}, .periodic = {0, 1}, .initials = 1, .initial = &initial, .refinement = &refinement});
        const struct solid_cloud *t = s->family->cloud[0];
        /* columns 0 to 6, the positions between them and those beside: 15 columns, 20 rows and not 21 */
        assert_int_equal(s->n_global, 160 - 70 + 15 * 20);
        check_close(area_of(s), 160, 160 * 1e-12);
        for (long i = 0; i < t->n; i++) {
            const int fine = t->place[0][i]<7.1, last = t->place[0][i]> 6.9;
            check_equal(t->size[i], fine ? 0.5 : 1);
            check_close(t->horizon[i], !fine || kind == 0 ? 3 : 1.5 * (kind == 2 && last ? M_SQRT2 : 1), 1e-15);
            check_close(t->volume[i],
                        fine                    ? (t->place[0][i] == 0 ? 0.125 : 0.25)
                        : t->place[0][i] == 7.5 ? 0.75
                                                : 1,
                        1e-12);
        }
        for (int h = 0; h < s->n; h++) {
            const double bell = exp(-pow((s->x0[0][h] - 7.2 * SPACING) / (3 * SPACING), 2));
            check_close(s->d[0][h], 1e-5 * bell, 1e-14);
            check_close(s->d[1][h], -2e-5 * bell, 2e-14);
        }
        assert_int_equal(solid_refine_events(s), 0);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_eq38),   cmocka_unit_test(test_total),    cmocka_unit_test(test_levels),
        cmocka_unit_test(test_linear), cmocka_unit_test(test_momentum), cmocka_unit_test(test_held),
        cmocka_unit_test(test_crack),  cmocka_unit_test(test_start),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
