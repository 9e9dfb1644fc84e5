/* Areas and edge lengths of particles of different levels: hand-computed ones, and sums. */
#include "solid/bonds/store.h"
#include "solid/refine/parts.h"
#include "solid/refine/places.h"
#include "tests/solid/make_plate.h"
#include "tests/check.h"

enum { NX = 12, NY = 9 };

/* A plan with the particle in cell i, j refined `rounds` times with its family. */
static struct solid_refine_plan *plan_of(const struct solid *s, int i, int j, int rounds) {
    struct solid_refine_plan *p = solid_refine_plan_of(s, 0, NULL);
    int at[2] = {i, j};
    for (int c = 0; c < 2; c++)
        at[c] = (int)lrint((at[c] + 0.5 - p->cloud->origin[c] / p->cloud->spacing) * SOLID_REFINE_UNIT);
    const long k = solid_refine_places_at(p, at[0], at[1]);
    check_at_least(k, 0);
    for (int round = 0; round < rounds; round++) solid_refine_plan_close(p, &k, 1, rounds > 1);
    return p;
}

static struct solid *plate(int levels) {
    const struct solid_refinement refinement = {.levels = levels, .low = {-1, -1}, .high = {1, 1}};
    return make((struct make){.sites = {NX, NY}, .refinement = &refinement});
}

/* Areas of the plan's particles, from those of the cloud. Owned by the caller. */
static double *areas(const struct solid_refine_plan *p, const struct solid *s) {
    struct solid_refine_cells cells = {0};
    double *volume = calloc((size_t)p->n + 1, sizeof *volume);
    memcpy(volume, s->family->cloud[0]->volume, (size_t)p->before * sizeof *volume);
    solid_refine_area_new(&cells, s->family->cloud[0]);
    solid_refine_area(p, &cells, volume);
    solid_refine_area_free(&cells);
    return volume;
}

/* One refined particle and the eight new ones around it have 1/4 each; of a coarse one beside them 3/4 is left at a
 * side, 15/16 at a corner.  (000: eq. 38) */
static void one_particle(void **state) {
    (void)state;
    struct solid *s = plate(1);
    struct solid_refine_plan *p = plan_of(s, 5, 4, 1);
    double *volume = areas(p, s), sum = 0;
    const int *middle = NULL;
    for (long i = 0; i < p->before; i++)
        if (p->level[i] == 1) middle = p->at[i];
    assert_non_null(middle);
    for (long i = 0; i < p->n; i++) {
        const int dx = abs(p->at[i][0] - middle[0]), dy = abs(p->at[i][1] - middle[1]);
        const int near = (dx <= SOLID_REFINE_UNIT) + (dy <= SOLID_REFINE_UNIT), in_line = dx == 0 || dy == 0;
        const double expected = p->level[i] ? 0.25 : near < 2 ? 1 : in_line ? 3. / 4 : 15. / 16;
        check_close(volume[i], i < p->before || p->level[i] == 1 ? expected : NAN, 1e-11);
        sum += volume[i];
    }
    check_close(sum, NX * NY, 1e-9);
    free(volume);
    solid_refine_plan_free(p);
    solid_free(s);
}

/* At a side, at a corner and inside, to three levels: positive areas that make up the plate, and the rest to the bit.
 */
static void whole_plate(void **state) {
    (void)state;
    const int cell[3][2] = {{0, 0}, {6, 8}, {5, 4}};
    for (int levels = 1; levels <= 3; levels++)
        for (int k = 0; k < 3; k++) {
            struct solid *s = plate(levels);
            struct solid_refine_plan *p = plan_of(s, cell[k][0], cell[k][1], levels);
            double *volume = areas(p, s), sum = 0;
            int finest = 0;
            for (long i = 0; i < p->n; i++) {
                check_above(volume[i], 0);
                check_at_most(volume[i], 1);
                sum += volume[i];
                if (p->level[i] > finest) finest = p->level[i];
            }
            check_equal(finest, levels);
            check_close(sum, NX * NY, 1e-9);
            free(volume);
            solid_refine_plan_free(p);
            solid_free(s);
        }
}

/* The boundary between two points is divided without rest; only particles at the edge take a part of it; a line that is
 * no boundary is refused with a reason. */
static void edges(void **state) {
    (void)state;
    for (int levels = 1; levels <= 2; levels++) {
        struct solid *s = plate(levels);
        struct solid_refine_plan *p = plan_of(s, 5, 0, levels);
        const double from[3][2] = {{0, 0}, {2.25 * SPACING, 0}, {0, 1 * SPACING}},
                     to[3][2] = {{NX * SPACING, 0}, {7.5 * SPACING, 0}, {0, NY * SPACING}}, length[3] = {NX, 5.25, 8};
        char text[256] = "";
        for (int k = 0; k < 3; k++) {
            double *lengths = calloc((size_t)p->n + 1, sizeof *lengths), sum = 0;
            check_equal(solid_refine_area_length(p, from[k], to[k], lengths, text, sizeof text), 1);
            for (long i = 0; i < p->n; i++) {
                const double y = solid_cloud_x(p->cloud, 1, 0) +
                                 (p->at[i][1] / (double)SOLID_REFINE_UNIT - p->cloud->place[1][0]) * SPACING;
                check_at_least(lengths[i], 0);
                if (k < 2 && y > 0.6 * SPACING) check_equal(lengths[i], 0);
                if (p->level[i] == levels) check_at_most(lengths[i], 1.1 * SPACING * ldexp(1, -levels));
                sum += lengths[i];
            }
            check_relative(sum, length[k] * SPACING, 1e-11);
            free(lengths);
        }
        check_equal(solid_refine_area_length(p, (double[]){0, 2 * SPACING}, (double[]){NX * SPACING, 2 * SPACING}, NULL,
                                             text, sizeof text),
                    0);
        check_above(strlen(text), 10);
        solid_refine_plan_free(p);
        solid_free(s);
    }
}

/* A disc, whose edge cuts cells every way: parts of cells without a particle go to several ones in equal parts, and the
 * areas and the lengths of the upper half of its edge still add up. */
static void cut_cells(void **state) {
    (void)state;
    static const double c = 6.1 * SPACING, r = 5.37 * SPACING;
    static const double corner[2][2] = {{c - r, c}, {c + r, c}}, centre[2][2] = {{c, c}, {c, c}};
    static const signed char turn[2] = {1, 1};
    const struct solid_outline outline = {0, 2, corner, centre, turn};
    const struct solid_refinement refinement = {.levels = 2, .low = {-1, -1}, .high = {1, 1}};
    struct solid *s =
        make((struct make){.sites = {NX, NX}, .outlines = 1, .outline = &outline, .refinement = &refinement});
    for (int k = 0; k < 2; k++) {
        struct solid_refine_plan *p = k ? plan_of(s, 2, 2, 2) : plan_of(s, 6, 10, 2);
        double *volume = areas(p, s), *length = calloc((size_t)p->n + 1, sizeof *length), sum = 0, along = 0;
        char text[256] = "";
        check_equal(solid_refine_area_length(p, corner[1], corner[0], length, text, sizeof text), 1);
        for (long i = 0; i < p->n; i++) {
            check_above(volume[i], 0);
            sum += volume[i];
            along += length[i];
        }
        check_relative(sum, M_PI * 5.37 * 5.37, 1e-10);
        check_relative(along, M_PI * r, 1e-10);
        free(length);
        free(volume);
        solid_refine_plan_free(p);
    }
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_particle), cmocka_unit_test(whole_plate),
                                       cmocka_unit_test(edges), cmocka_unit_test(cut_cells)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
