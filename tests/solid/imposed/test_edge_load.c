/* A traction on a plate's edge by hand: on the outer layer, on a part of an edge, over a horizon's depth. */
#include "tests/solid/make_plate.h"
#include "tests/check.h"

static const double traction[2] = {3e5, -1e5};

/* A plate of 8 x 6 with a load from y0 to y1 (spacings) on its right edge. */
static struct solid *plate(double y0, double y1, int over_horizon, double shift) {
    const struct solid_load load = {.kind = SOLID_LOAD_EDGE,
                                    .edge = {{shift + 8 * SPACING, y0 * SPACING}, {shift + 8 * SPACING, y1 * SPACING}},
                                    .traction = {traction[0], traction[1]},
                                    .over_horizon = over_horizon};
    return make((struct make){.sites = {8, 6}, .shift = {shift, 0}, .loads = 1, .load = &load});
}

/* Whatever takes it up, the whole force is traction, length and thickness. */
static void check_total(const struct solid *s, double length) {
    for (int c = 0; c < 2; c++) {
        double sum = 0;
        for (int h = 0; h < s->n; h++) sum += s->load[c][h] * s->volume[h];
        check_relative(par_sum(sum), traction[c] * length * THICKNESS, 1e-12);
    }
}

/* A particle of the last column has one spacing of the edge: traction/spacing a volume; half of it where the load ends
 * in the middle of its cell. */
static void outer_layer(void **state) {
    (void)state;
    for (int part = 0; part < 2; part++) {
        struct solid *s = plate(part ? 1 : 0, part ? 3.5 : 6, 0, 0);
        for (int h = 0; h < s->n; h++) {
            const int i = (int)(s->x0[0][h] / SPACING), j = (int)(s->x0[1][h] / SPACING);
            const double share = i < 7 ? 0 : !part || j == 1 || j == 2 ? 1 : j == 3 ? 0.5 : 0;
            for (int c = 0; c < 2; c++) check_close(s->load[c][h], share * traction[c] / SPACING, 1e-9 * 3e5 / SPACING);
        }
        check_total(s, (part ? 2.5 : 6) * SPACING);
        solid_free(s);
    }
}

/* Evenly over the three columns within the horizon of 3, and the rows whose foot is on the edge. */
static void over_the_horizon(void **state) {
    (void)state;
    for (int part = 0; part < 2; part++) {
        struct solid *s = plate(part ? 1 : 0, part ? 4 : 6, 1, 0);
        for (int h = 0; h < s->n; h++) {
            const int i = (int)(s->x0[0][h] / SPACING), j = (int)(s->x0[1][h] / SPACING);
            const int takes = i >= 5 && (!part || (j >= 1 && j < 4));
            for (int c = 0; c < 2; c++)
                check_close(s->load[c][h], takes * traction[c] / (3 * SPACING), 1e-9 * 3e5 / SPACING);
        }
        check_total(s, (part ? 3 : 6) * SPACING);
        solid_free(s);
    }
}

/* A plate whose edge cuts its last cells: the force goes by their volumes, its sum stays. */
static void cut_cells(void **state) {
    (void)state;
    const double corner[4][2] = {{0, 0}, {7.8 * SPACING, 0}, {7.8 * SPACING, 6 * SPACING}, {0, 6 * SPACING}};
    const signed char turn[4] = {0};
    const struct solid_outline outline = {0, 4, corner, corner, turn};
    const struct solid_load load = {.kind = SOLID_LOAD_EDGE,
                                    .edge = {{7.8 * SPACING, 0}, {7.8 * SPACING, 6 * SPACING}},
                                    .traction = {traction[0], traction[1]}};
    struct solid *s =
        make((struct make){.sites = {8, 6}, .outlines = 1, .outline = &outline, .loads = 1, .load = &load});
    for (int h = 0; h < s->n; h++) {
        const int i = (int)(s->x0[0][h] / SPACING);
        check_close(s->load[0][h], i == 7 ? traction[0] / (0.8 * SPACING) : 0, 1e-9 * 3e5 / SPACING);
    }
    check_total(s, 6 * SPACING);
    solid_free(s);
}

/* Points inside an outline: the force goes evenly to those within the horizon of the edge, and its sum stays. */
static void points(void **state) {
    (void)state;
    const struct solid_load load = {.kind = SOLID_LOAD_EDGE,
                                    .edge = {{8 * SPACING, SPACING}, {8 * SPACING, 5 * SPACING}},
                                    .traction = {traction[0], traction[1]},
                                    .over_horizon = 1};
    struct solid *s = make((struct make){.sites = {8, 6}, .irregular = 0.2, .loads = 1, .load = &load});
    double most = 0;
    for (int h = 0; h < s->n; h++) most = fmax(most, s->load[0][h]);
    most = par_max(most);
    for (int h = 0; h < s->n; h++) {
        const double x = s->x0[0][h] / SPACING, y = s->x0[1][h] / SPACING;
        check_close(s->load[0][h], x >= 5 && y >= 1 && y <= 5 ? most : 0, 1e-12 * most);
    }
    check_total(s, 4 * SPACING);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(outer_layer), cmocka_unit_test(over_the_horizon),
                                       cmocka_unit_test(cut_cells), cmocka_unit_test(points)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
