/* How much of the lines through a body is deep in it: by hand, and wherever the body stands. */
#include "coupling/load/inner_lines.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <stdio.h>

enum { BOX = 16, LOW = 4, SIDE = 8 };

static const char *const cube = "title: a cube\n"
                                "domain: {size: [16, 16, 16], cells: [16, 16, 16]}\n"
                                "fluid:\n"
                                "  density: 1\n"
                                "  viscosity: 1\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
                                "  materials: [{name: s, youngs_modulus: 1, density: 1}]\n"
                                "  bodies: [{name: cube, shape: box, low: [4, 4, 4], high: [12, 12, 12]}]\n";
static const char *const stages = "stages: [{name: rest, steps: 1, time_step: 1.0e-3}]\n";

/* Of a bundle two rows wide that holds the row at y, m within the cube, the part that is deep: its inner four rows are.
 */
static double deep_at(double y) { return y > 2 && y < 6 ? 1 : y > 1 && y < 7 ? 0.5 : 0; }

/* Four of the sixteen cells along a line through the middle are deep. */
static double by_hand(const double x[3]) {
    double most = 0;
    for (int c = 0; c < 3; c++) most = fmax(most, 0.25 * deep_at(x[(c + 1) % 3]) * deep_at(x[(c + 2) % 3]));
    return most;
}

/* The cube moves by cells along all axes; with 9 of them it crosses the sides. */
static void wherever_it_stands(void **state) {
    (void)state;
    static const int moves[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 2}, {1, 3, 2}, {9, 10, 11}};
    for (size_t k = 0; k < sizeof moves / sizeof *moves; k++) {
        char at[256];
        const int *m = moves[k];
        snprintf(at, sizeof at, "solid.bodies=[{name: cube, shape: box, low: [%d, %d, %d], high: [%d, %d, %d]}]",
                 LOW + m[0], LOW + m[1], LOW + m[2], LOW + SIDE + m[0], LOW + SIDE + m[1], LOW + SIDE + m[2]);
        struct scene *scene = scene_of(cube, stages, 1, (const char *const[]){at});
        struct run *r = run_new(scene);
        const struct solid *s = r->solid;
        uint8_t *is_deep = calloc((size_t)s->n + 1, 1);
        float *part = calloc((size_t)s->n + 1, sizeof *part);
        double *x = calloc(3 * (size_t)s->n + 3, sizeof *x);
        for (int h = 0; h < s->n; h++) {
            is_deep[h] = 1;
            for (int c = 0; c < 3; c++) {
                x[3 * h + c] = fmod(s->x0[c][h] - LOW - m[c] + 2 * BOX, BOX);
                is_deep[h] &= deep_at(x[3 * h + c]) == 1;
            }
        }
        inner_lines_measure(r, is_deep, part);
        for (int h = 0; h < s->n; h++) check_close(part[h], by_hand(x + 3 * h), 1e-6);
        check_equal(par_sum_long(s->n), SIDE * SIDE * SIDE);
        free(is_deep);
        free(part);
        free(x);
        run_free(r);
        scene_free(scene);
    }
}

/* A block at one side across, of which the row at the side is deep but for its ends: half of the bundle of two rows is
 * so. The same at the other side. */
static void at_either_side(void **state) {
    (void)state;
    for (int high = 0; high < 2; high++) {
        const char *const set[] = {"fluid.sides={x_low: {type: pressure}, x_high: {type: pressure}, y_low: {type: "
                                   "slip}, y_high: {type: slip}, "
                                   "z_low: {type: slip}, z_high: {type: slip}}",
                                   high ? "solid.bodies=[{name: cube, shape: box, low: [4, 8, 0], high: [12, 16, 16]}]"
                                        : "solid.bodies=[{name: cube, shape: box, low: [4, 0, 0], high: [12, 8, 16]}]"};
        struct scene *scene = scene_of(cube, stages, 2, set);
        struct run *r = run_new(scene);
        const struct solid *s = r->solid;
        uint8_t *is_deep = calloc((size_t)s->n + 1, 1);
        float *part = calloc((size_t)s->n + 1, sizeof *part);
        for (int h = 0; h < s->n; h++) {
            const double beside = high ? BOX - s->x0[1][h] : s->x0[1][h];
            is_deep[h] = beside < 1 && fabs(s->x0[0][h] - 8) < 2;
        }
        inner_lines_measure(r, is_deep, part);
        for (int h = 0; h < s->n; h++) {
            const double beside = high ? BOX - s->x0[1][h] : s->x0[1][h];
            check_close(part[h], beside < 2 ? 0.125 : 0, 1e-6);
        }
        free(is_deep);
        free(part);
        run_free(r);
        scene_free(scene);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(wherever_it_stands), cmocka_unit_test(at_either_side)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
