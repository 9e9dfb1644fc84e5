/* Azimuthal modes: the definition summed up directly, a known pattern, a uniform field, and directions across axes. */
#include "base/par.h"
#include "solid/measure/modes.h"
#include "tests/solid/measure/cubes.h"
#include "tests/check.h"

#include <math.h>

enum { SIDE = 24, HIGHEST = 6, RINGS = 3 };
static const double radius[RINGS + 1] = {3 * SPACING, 7 * SPACING, 11 * SPACING, 30 * SPACING};

static const double axes[][3] = {{0, 0, 1}, {0, -3, 0}, {1, 2, 0.5}};

static struct solid_rings rings_about(const double axis[3]) {
    struct solid_rings in = {.rings = RINGS - 1, .highest = HIGHEST, .radius = radius};
    for (int c = 0; c < 3; c++) in.centre[c] = (0.5 * SIDE + 0.1 * c) * SPACING;
    solid_modes_across(axis, in.across);
    return in;
}

/* Radius and angle of a particle. */
static void polar(const struct solid *s, const struct solid_rings *in, int h, double *r, double *theta) {
    double at[2] = {0};
    for (int d = 0; d < 2; d++)
        for (int c = 0; c < 3; c++) at[d] += in->across[d][c] * (s->x0[c][h] - in->centre[c]);
    *r = hypot(at[0], at[1]);
    *theta = atan2(at[1], at[0]);
}

static void the_definition(void **state) {
    (void)state;
    struct solid *s = cube_new(SIDE, 0, 0);
    double *field = malloc(((size_t)s->n + 1) * sizeof *field);
    long particles[RINGS];
    struct solid_mode mode[RINGS][HIGHEST + 1];
    for (int h = 0; h < s->n; h++) field[h] = bodies_random(bodies_id(s, h), 3);
    for (int a = 0; a < 3; a++) {
        const struct solid_rings in = rings_about(axes[a]);
        solid_modes_measure(s, &in, field, particles, mode[0]);
        for (int q = 0; q < in.rings; q++)
            for (int k = 0; k <= HIGHEST; k++) {
                double sum[4] = {0}, r, theta; /* number, field, cosine, sine; the volumes are equal */
                for (int h = 0; h < s->n; h++) {
                    polar(s, &in, h, &r, &theta);
                    if (r < radius[q] || r >= radius[q + 1]) continue;
                    sum[0] += 1;
                    sum[1] += field[h];
                    sum[2] += (field[h] - mode[q][0].amplitude) * cos(k * theta);
                    sum[3] += (field[h] - mode[q][0].amplitude) * sin(k * theta);
                }
                par_sum_array(sum, 4);
                check_equal(particles[q], sum[0]);
                if (k == 0) check_close(mode[q][0].amplitude, sum[1] / sum[0], 1e-13);
                if (k == 0) continue;
                const double a_k = 2 * hypot(sum[2], sum[3]) / sum[0];
                check_close(mode[q][k].amplitude, a_k, 1e-12);
                check_close(cos(k * mode[q][k].angle * M_PI / 180) * a_k, 2 * sum[2] / sum[0], 1e-12);
                check_close(sin(k * mode[q][k].angle * M_PI / 180) * a_k, 2 * sum[3] / sum[0], 1e-12);
            }
    }
    free(field);
    solid_free(s);
}

/* A pattern of five arms at 12 degrees; and a uniform field, which has no modes though the ring's particles have. */
static void known_patterns(void **state) {
    (void)state;
    struct solid *s = cube_new(SIDE, 0, 0);
    double *field = malloc(((size_t)s->n + 1) * sizeof *field), r, theta;
    long particles[RINGS];
    struct solid_mode mode[RINGS][HIGHEST + 1];
    const struct solid_rings in = rings_about(axes[0]);
    for (int h = 0; h < s->n; h++) {
        polar(s, &in, h, &r, &theta);
        field[h] = 0.3 + 0.2 * cos(5 * (theta - 12 * M_PI / 180));
    }
    solid_modes_measure(s, &in, field, particles, mode[0]);
    for (int k = 1; k <= HIGHEST; k++) check_close(mode[1][k].amplitude, k == 5 ? 0.2 : 0, 0.01);
    check_close(mode[1][0].amplitude, 0.3, 0.01);
    check_close(mode[1][5].angle, 12, 0.3);
    for (int h = 0; h < s->n; h++) field[h] = 0.7;
    solid_modes_measure(s, &in, field, particles, mode[0]);
    for (int q = 0; q < in.rings; q++)
        for (int k = 0; k <= HIGHEST; k++) check_close(mode[q][k].amplitude, k == 0 ? 0.7 : 0, 1e-13);
    free(field);
    solid_free(s);
}

/* Beyond the body there is nothing: NaN, no number. */
static void an_empty_ring(void **state) {
    (void)state;
    struct solid *s = cube_new(6, 0, 0);
    double *field = calloc((size_t)s->n + 1, sizeof *field);
    const double far[] = {50 * SPACING, 60 * SPACING};
    struct solid_rings in = rings_about(axes[0]);
    long particles[1];
    struct solid_mode mode[HIGHEST + 1];
    in.rings = 1;
    in.radius = far;
    solid_modes_measure(s, &in, field, particles, mode);
    check_equal(particles[0], 0);
    assert_true(isnan(mode[0].amplitude) && isnan(mode[4].amplitude));
    free(field);
    solid_free(s);
}

static void directions(void **state) {
    (void)state;
    double across[2][3];
    solid_modes_across(axes[0], across);
    for (int d = 0; d < 2; d++)
        for (int c = 0; c < 3; c++) check_equal(across[d][c], c == d);
    solid_modes_across((const double[3]){0, 2, 0}, across);
    for (int c = 0; c < 3; c++) {
        check_equal(across[0][c], c == 2);
        check_equal(across[1][c], c == 0);
    }
    solid_modes_across(axes[2], across);
    double length[2] = {0}, along[2] = {0}, between = 0;
    for (int c = 0; c < 3; c++) {
        between += across[0][c] * across[1][c];
        for (int d = 0; d < 2; d++) {
            length[d] += across[d][c] * across[d][c];
            along[d] += across[d][c] * axes[2][c];
        }
    }
    check_close(between, 0, 1e-15);
    for (int d = 0; d < 2; d++) {
        check_close(length[d], 1, 1e-15);
        check_close(along[d], 0, 1e-15);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_definition), cmocka_unit_test(known_patterns),
                                       cmocka_unit_test(an_empty_ring), cmocka_unit_test(directions)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
