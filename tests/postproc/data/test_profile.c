/* Means over cross sections, by hand. */
#include "base/par.h"
#include "postproc/data/profile.h"
#include "tests/check.h"

static void profile_by_sections(void **state) {
    (void)state;
    /* two sections of four cells: pressure 1, 2, 3, 4 and solid 0, 0, 1, 0.5 */
    const int n[3] = {2, 2, 2};
    const double pressure[8] = {1, 7, 2, 7, 3, 7, 4, 7}, solid[8] = {0, 1, 0, 1, 1, 1, 0.5, 1};
    double mean[2], fluid[2], porosity[2];
    postproc_profile_means(n, 0, pressure, solid, mean, fluid, porosity);
    check_close(mean[0], 2.5, 1e-14);
    check_close(fluid[0], (1 + 2 + 0.5 * 4) / 2.5, 1e-14);
    check_close(porosity[0], 2.5 / 4, 1e-14);
    check_close(mean[1], 7, 1e-14);
    assert_true(isnan(fluid[1]));
    check_close(porosity[1], 0, 0);
}

/* The same cells in another order: a flow along each axis has the same sections. */
static void profile_along_each_axis(void **state) {
    (void)state;
    static const int n[3] = {2, 3, 4};
    for (int axis = 0; axis < 3; axis++) {
        double pressure[24], solid[24], mean[4], fluid[4], porosity[4];
        for (int i = 0; i < 24; i++) {
            const int at[3] = {i % 2, i / 2 % 3, i / 6};
            pressure[i] = 10 * at[axis] + at[(axis + 1) % 3];
            solid[i] = at[(axis + 1) % 3] > 0 ? 0.25 * at[axis] : 0;
        }
        postproc_profile_means(n, axis, pressure, solid, mean, fluid, porosity);
        const int across = n[(axis + 1) % 3];
        for (int k = 0; k < n[axis]; k++) {
            double weight = 0, sum = 0;
            for (int q = 0; q < across; q++) {
                const double w = q > 0 ? 1 - 0.25 * k : 1;
                weight += w;
                sum += w * (10 * k + q);
            }
            check_close(mean[k], 10 * k + 0.5 * (across - 1), 1e-13);
            check_close(fluid[k], sum / weight, 1e-13);
            check_close(porosity[k], weight / across, 1e-14);
        }
    }
}

/* Of the coupled scene, whose flow is along x; between walls in x, along y and along z. */
static void axis_of_the_stream(void **state) {
    (void)state;
    static const char *const along_y[] = {
        "fluid.initial={velocity: [0, 0.1, 0]}",
        "fluid.sides={x_low: {type: wall}, x_high: {type: wall}, y_low: {type: inflow, profile: uniform, "
        "bulk_velocity: 0.1}, y_high: {type: outflow}, z_low: {type: periodic}, z_high: {type: periodic}}"};
    static const char *const along_z[] = {
        "fluid.initial={velocity: [0, 0, 0.1]}",
        ("fluid.sides={x_low: {type: wall}, x_high: {type: wall}, y_low: {type: wall}, y_high: {type: wall}, "
         "z_low: {type: periodic}, z_high: {type: periodic}}"),
        "fluid.driving={type: bulk_velocity, direction: z, value: 0.1}"};
    static const struct {
        int n, axis;
        const char *const *set;
    } table[] = {{0, 0, NULL}, {2, 1, along_y}, {3, 2, along_z}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        const struct postproc_history h = {
            .scene = scene_new(FRANA_SOURCE_DIR "/tests/scene/scenes/coupled.yaml", table[i].n, table[i].set)};
        check_equal(postproc_history_axis(&h), table[i].axis);
        scene_free(h.scene);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(profile_by_sections), cmocka_unit_test(profile_along_each_axis),
                                       cmocka_unit_test(axis_of_the_stream)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
