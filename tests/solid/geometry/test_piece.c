/* Depths and normals at places by hand: a ball, a cavity, the side of a cylinder, two planes. */
#include "base/par.h"
#include "solid/geometry/piece.h"
#include "tests/check.h"

static const double centre[3] = {1, 2, 3};

static void check_at(int mask, int inside, const double from_centre[3], double depth, const double normal[3]) {
    const struct solid_piece p = solid_piece_round(mask, inside, centre, 0.7);
    const double x[3] = {1 + from_centre[0], 2 + from_centre[1], 3 + from_centre[2]};
    double n[3];
    check_close(p.depth(&p, x, n), depth, 1e-14);
    for (int c = 0; c < 3; c++) check_close(n[c], normal[c], 1e-14);
}

/* A place at (2, 3, 6)/10 from the centre, which is 0.7 away, and at half of this. */
static void balls_and_cavities(void **state) {
    (void)state;
    const double out[3] = {2. / 7, 3. / 7, 6. / 7}, in[3] = {-2. / 7, -3. / 7, -6. / 7};
    check_at(SOLID_PIECE_ALL, 1, (double[]){0.2, 0.3, 0.6}, 0, out);
    check_at(SOLID_PIECE_ALL, 1, (double[]){0.1, 0.15, 0.3}, 0.35, out);
    check_at(SOLID_PIECE_ALL, 1, (double[]){0.4, 0.6, 1.2}, -0.7, out);
    check_at(SOLID_PIECE_ALL, -1, (double[]){0.4, 0.6, 1.2}, 0.7, in);
    check_at(SOLID_PIECE_ALL, -1, (double[]){0.1, 0.15, 0.3}, -0.35, in);
}

/* Two directions: what lies along the axis does not count. One: two planes, the nearer one counts. */
static void cylinders_and_planes(void **state) {
    (void)state;
    check_at(1 | 4, 1, (double[]){0.3, 55, -0.4}, 0.2, (double[]){0.6, 0, -0.8});
    check_at(1 | 2, -1, (double[]){0.6, 0.8, 55}, 0.3, (double[]){-0.6, -0.8, 0});
    check_at(2, 1, (double[]){9, -0.6, 9}, 0.1, (double[]){0, -1, 0});
    check_at(2, 1, (double[]){9, 0.2, 9}, 0.5, (double[]){0, 1, 0});
    check_at(4, 1, (double[]){9, 9, 0.9}, -0.2, (double[]){0, 0, 1});
}

/* At the centre no direction is out: the depth is the radius, and the normal is zero, not NaN. */
static void at_the_centre(void **state) {
    (void)state;
    check_at(SOLID_PIECE_ALL, 1, (double[]){0, 0, 0}, 0.7, (double[]){0, 0, 0});
    check_at(1 | 2, 1, (double[]){0, 0, 4}, 0.7, (double[]){0, 0, 0});
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(balls_and_cavities), cmocka_unit_test(cylinders_and_planes),
                                       cmocka_unit_test(at_the_centre)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
