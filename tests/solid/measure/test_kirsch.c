/* Stress at the edge of a hole in a plate under tension, against Kirsch. */
#include "solid/measure/stress.h"
#include "solid/step/relax.h"
#include "tests/check.h"
#include "tests/solid/make_plate.h"

/* The tangential stress across the line through the hole's centre across the tension, over the tension, at r = R/q
 * (Kirsch 1898). */
static double kirsch(double q) { return 0.5 * (2 + q * q + 3 * q * q * q * q); }

/* Howland 1930: a strip ten radii wide has 3.14 at the hole's edge in place of 3. */
static const double strip = 3.14 / 3;

struct reading {
    double least, most; /* of stress over Kirsch's at the particle's own place */
    double edge;        /* the largest stress over 3.14 */
};

/* A plate ten radii wide and twice as long, pulled by its first and last layers, at rest. Read are the particles
 * nearest to the line through the hole's centre, from the edge to half a radius from it. */
static struct reading at_hole(int radius, enum solid_correction correction) {
    const double r = radius * SPACING, width = 10 * r, length = 2 * width, tension = 1e-6 * YOUNG;
    const double box[4][2] = {{0, 0}, {length, 0}, {length, width}, {0, width}},
                 arc[2][2] = {{width - r, width / 2}, {width + r, width / 2}},
                 centre[2][2] = {{width, width / 2}, {width, width / 2}};
    const signed char straight[4] = {0}, round[2] = {1, 1};
    const struct solid_outline outline[2] = {{0, 4, box, box, straight}, {1, 2, arc, centre, round}};
    const struct solid_load load[2] = {
        {.low = {-1, -1, -1}, .high = {SPACING, 1e3, 1}, .force = {-tension / SPACING, 0, 0}},
        {.low = {length - SPACING, -1, -1}, .high = {1e3, 1e3, 1}, .force = {tension / SPACING, 0, 0}}};
    struct solid *s = make((struct make){.sites = {20 * radius, 10 * radius},
                                         .outlines = 2,
                                         .outline = outline,
                                         .loads = 2,
                                         .load = load,
                                         .correction = correction});
    struct reading reading = {10, 0, 0};
    double(*stress)[6] = malloc(((size_t)s->n + 1) * sizeof *stress);
    check_above(solid_relax(s, 1e-4, 100000), 10);
    solid_stress_measure(s, stress);
    for (int h = 0; h < s->n; h++) {
        const double x = s->x0[0][h] - width, y = s->x0[1][h] - width / 2, d = hypot(x, y);
        if (fabs(x) > 0.6 * SPACING || d > 1.5 * r) continue;
        const double ratio = stress[h][0] / (tension * strip * kirsch(r / d));
        reading.least = fmin(reading.least, ratio);
        reading.most = fmax(reading.most, ratio);
        reading.edge = fmax(reading.edge, stress[h][0] / (3 * tension * strip));
    }
    free(stress);
    solid_free(s);
    return (struct reading){par_min(reading.least), par_max(reading.most), par_max(reading.edge)};
}

/* Half a spacing from the edge the stress is 13 % below Kirsch's at that place, and 10 and 8 % at R = 16 and 24
 * spacings: a flux is a mean over the family, which lies on one side. From the second particle on it is within 2 %.
 * Over 3.14, the stress at the edge itself, it is 0.75, 0.84, 0.88. */
static void test_hole(void **state) {
    (void)state;
    const struct reading reading = at_hole(8, SOLID_CORRECTION_ENERGY);
    check_between(reading.least, 0.86, 0.88);
    check_between(reading.most, 0.98, 1.03);
    check_between(reading.edge, 0.74, 0.77);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_hole)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
