/* Sites, cells and points of a body: who belongs to it, and numbers that are whole and without gaps. */
#include "base/par.h"
#include "solid/body/bricks.h"
#include "solid/body/sites.h"
#include "solid/geometry/shape.h"
#include "tests/check.h"
#include "tests/solid/contains.h"

#include <math.h>
#include <stdlib.h>

static const struct solid_material material = {1e8, 3000, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};

static struct solid_input input(const struct solid_body *body) {
    return (struct solid_input){.spacing = 0.1,
                                .origin = {0.03, -0.02, 0.01},
                                .bodies = 1,
                                .body = body,
                                .materials = 1,
                                .material = &material};
}

/* All sites of a box around the body: those that the shape contains have an id, each another, first .. first+count-1,
 * rising along a row of eight; all others have -1. */
static void check_ids(const struct solid_input *in, const struct solid_body *body, const struct solid_sites *t,
                      long first) {
    uint8_t *taken = calloc((size_t)t->count + 1, 1);
    long inside = 0;
    for (int k = -12; k < 12; k++)
        for (int j = -12; j < 12; j++) {
            long last = -1;
            for (int i = -12; i < 12; i++) {
                const int site[3] = {i, j, k};
                double x[3];
                for (int c = 0; c < 3; c++) x[c] = in->origin[c] + (site[c] + 0.5) * in->spacing;
                const int is_in = contains(body, x, in->spacing);
                const long id = solid_sites_id(t, site);
                check_equal(id >= 0, is_in);
                if (is_in) {
                    check_between(id, first - 1, first + t->count);
                    check_equal(taken[id - first], 0);
                    taken[id - first] = 1;
                    if (last >= 0 && (i - t->low[0]) % SOLID_ROW) check_equal(id, last + 1);
                    inside++;
                }
                last = is_in ? id : -1;
            }
        }
    check_equal(t->count, inside);
    free(taken);
}

static void lattices(void **state) {
    (void)state;
    const struct solid_body body[4] = {
        {.name = "box", .shape = SOLID_BOX, .low = {-0.5, -0.41, -0.33}, .high = {0.68, 0.2, 0.55}},
        {.name = "ball", .shape = SOLID_SPHERE, .centre = {0.1, 0.05, -0.07}, .radius = 0.72},
        {.name = "rod", .shape = SOLID_CYLINDER, .centre = {0.1, 0.05, -0.07}, .radius = 0.33, .axis = 1, .length = 1},
        {.name = "porous",
         .shape = SOLID_ELLIPSOID,
         .radii = {0.9, 0.7, 0.5},
         .cavity_period = 0.4,
         .cavity_radius = 0.13}};
    for (int k = 0; k < 4; k++) {
        const struct solid_input in = input(&body[k]);
        struct solid_sites *t = solid_sites_new(&in, &body[k], 1000 * k, 3);
        check_equal(t->is_lattice, 1);
        check_equal(t->first, 1000 * k);
        check_above(t->count, 100);
        check_ids(&in, &body[k], t, 1000 * k);
        solid_sites_free(t);
    }
}

/* The lower half of the numbers is the lower half of the body, also where its sides are not whole number of bricks and
 * its bricks do not begin at a site that eight divides. */
static void halves(void **state) {
    (void)state;
    for (int c = 1; c < 3; c++) {
        struct solid_body body = {
            .name = "box", .shape = SOLID_BOX, .low = {-0.5, -0.4, -0.6}, .high = {0.6, 0.7, 0.5}};
        body.high[c] += 0.8; /* the longest side, 22 sites; eleven of them are not whole layers of bricks */
        body.low[c] -= 0.3;
        const struct solid_input in = input(&body);
        struct solid_sites *t = solid_sites_new(&in, &body, 0, 3);
        const int sites = (int)lrint((body.high[c] - body.low[c]) / in.spacing), low = t->base[c];
        long below = 0;
        check_equal(sites % 2, 0);
        for (int k = -12; k < 24; k++)
            for (int j = -12; j < 24; j++)
                for (int i = -12; i < 24; i++) {
                    const int site[3] = {i, j, k};
                    const long id = solid_sites_id(t, site);
                    if (id < 0) continue;
                    check_equal(id < t->count / 2, site[c] < low + sites / 2);
                    below += id < t->count / 2;
                }
        check_equal(2 * below, t->count);
        solid_sites_free(t);
    }
}

/* Of cuts with about as many ghosts that across z is the first, then y. */
static void across_z_first(void **state) {
    (void)state;
    const struct {
        long ghosts[3];
        int across;
    } row[] = {{{300, 300, 300}, 2}, {{300, 300, 340}, 2}, {{300, 300, 341}, 1}, {{300, 341, 341}, 0},
               {{40, 20, 40}, 2},    {{40, 20, 41}, 1},    {{-1, 20, 30}, 2},    {{20, 30, -1}, 1},
               {{-1, -1, 2000}, 2},  {{2000, -1, -1}, 0},  {{-1, -1, -1}, -1}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        check_equal(solid_bricks_first_cut(row[k].ghosts, 1000), row[k].across);
}

/* The main case's block is cut across z, through its cavities, in spite of the second border that a ring has there; a
 * block without cavities, or with ones that leave most of the border, is cut across y. */
static void cut_through_cavities(void **state) {
    (void)state;
    for (int k = 0; k < 3; k++) {
        const struct solid_body body = {.name = "block",
                                        .shape = SOLID_BOX,
                                        .low = {1.6, -0.3, 0},
                                        .high = {6.4, 6.7, 6.4},
                                        .cavity_period = k > 0 ? 1.6 : 0,
                                        .cavity_radius = k == 1 ? 0.53 : 0.9168,
                                        .cavity_centre = {1.615}};
        struct solid_input in = input(&body);
        for (int c = 0; c < 3; c++) in.origin[c] = 0;
        in.periodic[2] = 1;
        in.length[2] = 6.4;
        struct solid_sites *t = solid_sites_new(&in, &body, 0, 3);
        for (int z = 0; z < 64; z++)
            for (int y = -3; y < 67; y++)
                for (int x = 16; x < 64; x++) {
                    const long id = solid_sites_id(t, (int[]){x, y, z});
                    if (id >= 0) check_equal(id < t->count / 2, k == 2 ? z < 32 : y < 32);
                }
        solid_sites_free(t);
    }
}

/* Cavities are balls on a cubic array around a centre, taken from the shape. */
static void cavities(void **state) {
    (void)state;
    const struct solid_body body = {.shape = SOLID_BOX,
                                    .low = {-2, -2, -2},
                                    .high = {2, 2, 2},
                                    .cavity_period = 0.5,
                                    .cavity_radius = 0.2,
                                    .cavity_centre = {0.1, 0, 0}};
    check_equal(contains(&body, (double[]){0.1, 0, 0.19}, 0.1), 0);
    check_equal(contains(&body, (double[]){0.1, 0, 0.21}, 0.1), 1);
    check_equal(contains(&body, (double[]){-0.9, 1.5, -0.69}, 0.1), 0);
    check_equal(contains(&body, (double[]){-0.65, 1.5, -0.5}, 0.1), 1);
    check_equal(contains(&body, (double[]){2.1, 0, 0.25}, 0.1), 0);
}

/* Across a periodic side a site is its own image. */
static void periodic(void **state) {
    (void)state;
    const struct solid_body body = {.name = "box", .shape = SOLID_BOX, .low = {0, 0, 0}, .high = {1, 0.5, 0.4}};
    struct solid_input in = input(&body);
    in.periodic[0] = in.periodic[2] = 1;
    in.length[0] = 1;
    in.length[2] = 0.7;
    struct solid_sites *t = solid_sites_new(&in, &body, 0, 3);
    check_equal(t->count, 10 * 5 * 4);
    for (int i = -15; i < 25; i++)
        for (int k = -9; k < 9; k++) {
            const int site[3] = {i, 2, k}, image[3] = {i + 10, 2, k - 7}, beside[3] = {i, 12, k};
            check_equal(solid_sites_id(t, site), solid_sites_id(t, image));
            check_equal(solid_sites_id(t, beside), -1);
        }
    solid_sites_free(t);
}

/* Points are numbered each once; cells of a polygon make up its area. */
static void points_and_cells(void **state) {
    (void)state;
    enum { N = 200 };
    double x[N], y[N], volume[N], area = 0;
    uint8_t taken[N] = {0};
    srand(2);
    for (int p = 0; p < N; p++) {
        x[p] = (double)rand() / RAND_MAX;
        y[p] = (double)rand() / RAND_MAX;
        volume[p] = 0.01;
    }
    const struct solid_body points = {
        .name = "points", .shape = SOLID_POINTS, .points = N, .point = {x, y, NULL}, .point_volume = volume};
    struct solid_input in = input(&points);
    in.model = PHYSICS_PLANE_STRESS;
    in.thickness = 0.2;
    struct solid_sites *t = solid_sites_new(&in, &points, 7, 3);
    check_equal(t->is_lattice, 0);
    check_equal(t->count, N);
    for (long i = 0; i < N; i++) taken[t->point[i]]++;
    for (int p = 0; p < N; p++) check_equal(taken[p], 1);
    solid_sites_free(t);
    const double corner[3][2] = {{0, 0}, {1.17, 0.1}, {0.2, 0.93}};
    const signed char turn[3] = {0};
    const struct solid_outline outline = {0, 3, corner, corner, turn};
    const struct solid_body plate = {.name = "plate", .shape = SOLID_POLYGON, .outlines = 1, .outline = &outline};
    in.body = &plate;
    t = solid_sites_new(&in, &plate, 0, 3);
    for (long i = 0; i < t->count; i++) {
        area += t->area[i] * 0.01;
        for (long j = 0; j < i; j++) check_equal(t->cell[i][0] == t->cell[j][0] && t->cell[i][1] == t->cell[j][1], 0);
    }
    check_relative(area, 0.5 * (1.17 * 0.93 - 0.2 * 0.1), 1e-12);
    solid_sites_free(t);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(lattices),        cmocka_unit_test(halves),
                                       cmocka_unit_test(across_z_first),  cmocka_unit_test(cut_through_cavities),
                                       cmocka_unit_test(cavities),        cmocka_unit_test(periodic),
                                       cmocka_unit_test(points_and_cells)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
