/* Given loads: where they stand, how they go with time, and that what somebody else adds to s->load stays. */
#include "tests/solid/make.h"
#include "solid/imposed/external_loads.h"

#include "tests/check.h"
#include "solid/solid.h"

static const double moment[3] = {0, 1, 2}, factor[3] = {0, 1, -1};

/* A bar of 6 sites under two loads. */
static struct solid *bar_under(const struct solid_load load[2]) {
    const struct solid_material material = {YOUNG, DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};
    const struct solid_body body = {.name = "bar", .shape = SOLID_BOX, .high = {6 * SPACING, SPACING, SPACING}};
    return solid_new(&(struct solid_input){.spacing = SPACING,
                                           .bodies = 1,
                                           .body = &body,
                                           .materials = 1,
                                           .material = &material,
                                           .loads = 2,
                                           .load = load});
}

/* A constant load on the first four sites, one that varies on the last four. */
static struct solid *bar(void) {
    struct solid_load load[2] = {{.low = {-1, -1, -1}, .high = {4 * SPACING, 1, 1}, .force = {5, 0, -2}},
                                 {.low = {2 * SPACING, -1, -1}, .high = {1, 1, 1}, .force = {0, 8, 0}}};
    load[1].time = (struct solid_time){3, moment, factor, 0};
    return bar_under(load);
}

static void check_load(const struct solid *s, double varying, const double other[3]) {
    for (int h = 0; h < s->n; h++) {
        const int site = (int)(s->x0[0][h] / SPACING);
        const double given[3] = {site < 4 ? 5 : 0, site < 2 ? 0 : 8 * varying, site < 4 ? -2 : 0};
        for (int c = 0; c < 3; c++) {
            check_close(solid_external_loads_on(s, h, c), given[c], 1e-14);
            check_close(s->load[c][h], given[c] + other[c], 1e-14);
        }
    }
}

/* At a time; as the mean over a step; and nothing to do where no factor has changed. */
static void by_time(void **state) {
    (void)state;
    struct solid *s = bar();
    const double none[3] = {0}, other[3] = {0.5, 100, -7};
    check_load(s, 0, none);
    assert_true(solid_external_loads_update(s, 0.25, 0));
    check_load(s, 0.25, none);
    assert_false(solid_external_loads_update(s, 0.25, 0));
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < s->n; h++) s->load[c][h] += other[c];
    assert_true(solid_external_loads_update(s, 0.5, 1)); /* from 1/2 by 1 to 0: triangles of 3/8 and 1/4 */
    check_load(s, (0.5 * (0.5 + 1) * 0.5 + 0.5 * (1 + 0) * 0.5) / 1, other);
    assert_true(solid_external_loads_update(s, 2, 5));
    check_load(s, -1, other);
    solid_free(s);
}

/* Code that sets s->load again says so; factors that were kept are put back. */
static void forgotten_and_kept(void **state) {
    (void)state;
    struct solid *s = bar();
    const double none[3] = {0};
    double kept[2];
    uint8_t mark[6] = {0};
    solid_external_loads_update(s, 0.5, 0);
    solid_external_loads_save(s, kept);
    check_equal(kept[0], 1);
    check_equal(kept[1], 0.5);
    solid_external_loads_invalidate(s);
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            check_equal(solid_external_loads_on(s, h, c), 0);
            s->load[c][h] = 0;
        }
    solid_external_loads_update(s, 1, 0);
    check_load(s, 1, none);
    solid_external_loads_restore(s, kept);
    for (int h = 0; h < s->n; h++)
        check_close(solid_external_loads_on(s, h, 1), s->x0[0][h] < 2 * SPACING ? 0 : 4, 1e-14);
    solid_external_loads_mark(s, mark);
    for (int h = 0; h < s->n; h++) assert_int_equal(mark[h], 1);
    solid_free(s);
}

/* A load of zero has its particles, as the first level of a study may be 0. */
static void of_zero(void **state) {
    (void)state;
    struct solid *s = bar_under((struct solid_load[2]){{.low = {-1, -1, -1}, .high = {4 * SPACING, 1, 1}},
                                                       {.low = {2 * SPACING, -1, -1}, .high = {1, 1, 1}}});
    const struct solid_external_loads_sum sum = solid_external_loads_sum_of(s, 0);
    check_equal(par_sum(sum.particles), 4);
    for (int c = 0; c < 3; c++) check_equal(sum.force[c], 0);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(by_time), cmocka_unit_test(forgotten_and_kept),
                                       cmocka_unit_test(of_zero)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
