/* frana post on a made-up run of a plate. */
#include "base/die.h"
#include "base/par.h"
#include "postproc/data/plate.h"
#include "postproc/post.h"
#include "tests/check.h"
#include "tests/postproc/made.h"
#include "tests/postproc/make_plate.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <sys/stat.h>

static const char base[] = FRANA_BINARY_DIR "/tests/postproc/plates";
static char folder[FOLDER_PATH];

static long size_of(const char *file) { return made_size(folder, file); }

/* Of post/crack-summary.csv. */
static double summary(const char *quantity) { return made_value(folder, "post/crack-summary.csv", quantity); }

static const char *const files[] = {"post/report.md",
                                    "post/crack-summary.csv",
                                    "post/contour.csv",
                                    "post/contour.vtk",
                                    "post/plots/crack_speed.png",
                                    "post/plots/crack_x.svg",
                                    "post/plots/crack_y.png",
                                    "post/plots/crack_path.png",
                                    "post/plots/crack_length.png",
                                    "post/plots/energy.png",
                                    "post/pictures/damage.png",
                                    "post/pictures/stretch.png",
                                    "post/pictures/energy.png",
                                    "post/pictures/displacement_x.png",
                                    "post/pictures/displacement_y.png",
                                    "post/film/damage_0001.png",
                                    "post/film/damage_0008.png"};

static void whole_plate(void **state) {
    (void)state;
    const char *spacing = getenv("FRANA_TEST_SPACING"); /* 0.00025 to look at the pictures */
    const double h = spacing ? atof(spacing) : 1e-3;
    make_plate(folder_path(folder, base, "whole"), h);
    assert_int_equal(postproc_post(folder, &(struct postproc_options){.film = 1, .width = spacing ? 1400 : 280}),
                     EXIT_CODE_DONE);
    for (size_t k = 0; k < sizeof files / sizeof *files; k++)
        if (size_of(files[k]) < 100) fail_msg("%s is missing or empty", files[k]);
    assert_int_equal(size_of("post/film/damage_0009.png"), -1);
    assert_int_equal(size_of("post/pictures/damage_back.png"), -1);
    check_close(summary("level of the damage contour"), 0.98 * 0.504 * (1 - 0.5 / 3), 1e-6);
    check_close(summary("Rayleigh speed"), 3058, 0.5);
    check_close(summary("start of growth: first broken bond, t"), plate_start - 0.3e-6, 0.06e-6);
    const double moved = plate_start + h / plate_speed[0];
    check_above(summary("start of growth: tip moved by more than a spacing, t") - moved, -1e-12);
    check_close(summary("start of growth: tip moved by more than a spacing, t"), moved, 0.1e-6);
    check_close(summary("top speed of the tip"), 1500, 1e-9);
    check_close(summary("top speed over the Rayleigh speed"), 1500 / 3058.4, 1e-4);
    check_close(summary("energy released over the new area, over G0"), 300 / 135., 1e-9);
    const double x = summary("branching, x"), branch = plate_start + 0.017 / 1500;
    check_between(x, plate_branch - h, plate_branch + 6 * h);
    check_close(summary("branching, y"), plate_middle, 1.5 * h);
    check_close(summary("branching: tip passes the place, t"), branch + (x - plate_branch) / 1200, 2 * h / 1200);
    check_close(summary("branching: fronts apart from then on, t"), branch + 0.004 / 1200, 0.3e-6);
    check_close(summary("angle of the branch to the left, at first"), 28, 2.5);
    check_close(summary("angle of the branch to the right, at last"), 12, 2.5);
}

static void options_are_kept(void **state) {
    (void)state;
    make_plate(folder_path(folder, base, "asked"), 1e-3);
    const struct postproc_options o = {
        .film = 1, .film_quantity = POSTPROC_DISPLACEMENT_Y, .level = 0.2, .magnify = 5, .width = 280};
    assert_int_equal(postproc_post(folder, &o), EXIT_CODE_DONE);
    check_close(summary("level of the damage contour"), 0.2, 1e-12);
    check_above(size_of("post/film/displacement_y_0003.png"), 100);
    assert_int_equal(size_of("post/film/damage_0003.png"), -1);
    assert_int_equal(postproc_options_quantity("stretch"), POSTPROC_STRETCH);
    assert_int_equal(postproc_options_quantity("nothing"), -1);
}

/* Without crack.csv and without tracked cracks the results come from the fields only. */
static void fields_alone(void **state) {
    (void)state;
    char path[FOLDER_PATH];
    make_plate(folder_path(folder, base, "fields"), 1e-3);
    assert_int_equal(remove(folder_path(path, folder, "crack.csv")), 0);
    assert_int_equal(postproc_post(folder, &(struct postproc_options){.width = 280}), EXIT_CODE_DONE);
    assert_true(isnan(summary("top speed of the tip")));
    check_close(summary("angle of the branch to the left, at first"), 28, 2.5);
    assert_int_equal(size_of("post/plots/crack_speed.png"), -1);
    assert_int_equal(size_of("post/film/damage_0001.png"), -1);
}

static void compared(void **state) {
    (void)state;
    char a[FOLDER_PATH], b[FOLDER_PATH];
    make_plate(folder_path(a, base, "coarse"), 2e-3);
    make_plate(folder_path(b, base, "fine"), 1e-3);
    const char *const both[2] = {a, b};
    assert_int_equal(postproc_compare(2, both, folder_path(folder, base, "compared")), EXIT_CODE_DONE);
    check_above(size_of("plots/crack_speed.png"), 1000);
    check_above(size_of("summary.csv"), 500);
    assert_int_equal(size_of("contour.csv"), -1);
}

/* A file's squares: places before displacement, sizes of the volumes. */
static void plate_as_it_was_written(void **state) {
    (void)state;
    char error[512];
    make_plate(folder_path(folder, base, "read"), 1e-3);
    struct postproc_history *h = postproc_history_new(folder, error, sizeof error);
    assert_non_null(h);
    struct postproc_plate *p = postproc_plate_new(h, h->solid.n - 1);
    assert_int_equal(p->n, 4000);
    for (long k = 0; k < p->n; k++) {
        check_close(p->x[k][0], ((double)(k % 100) + 0.5) * 1e-3, 1e-8);
        check_close(p->size[k], 1e-3, 1e-9);
    }
    check_close(p->high[0], 0.1, 1e-8);
    check_close(h->s0, sqrt(4 * M_PI * 135 / (9 * 7.2e10 * 3e-3)), 1e-12); /* 003: eq. 2.10, its integral in 2D */
    postproc_plate_free(p);
    postproc_history_free(h);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_plate), cmocka_unit_test(options_are_kept),        cmocka_unit_test(fields_alone),
        cmocka_unit_test(compared),    cmocka_unit_test(plate_as_it_was_written),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
