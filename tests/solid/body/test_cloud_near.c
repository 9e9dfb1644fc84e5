/* Families of a cloud against all pairs and their periodic images. */
#include "base/par.h"
#include "solid/body/cloud.h"
#include "tests/check.h"

#include <stdlib.h>

enum { MOST = 160 };

static const struct solid_material material = {1e8, 3000, INFINITY, 2, PHYSICS_CONSTANT, 0, 0};

static double uniform(double low, double high) { return low + (high - low) * rand() / RAND_MAX; }

/* n points in a box of six spacings, of different volumes and horizons; periodic along x and, in space, along z. */
static struct solid_cloud *cloud_of(int dim, int n, enum solid_horizons horizons) {
    static double x[3][MOST], volume[MOST], horizon[MOST];
    const struct solid_input in = {
        .model = dim == 2 ? PHYSICS_PLANE_STRESS : PHYSICS_3D, .thickness = 0.3, .spacing = 0.5, .horizons = horizons};
    for (int i = 0; i < n; i++) {
        for (int c = 0; c < dim; c++) x[c][i] = uniform(0, 6);
        volume[i] = uniform(0.3, 1);
        horizon[i] = uniform(1, 2);
    }
    return solid_cloud_new(&(struct solid_cloud_input){.name = "cloud",
                                                       .n = n,
                                                       .first = 50,
                                                       .spacing = 0.5,
                                                       .thickness = 0.3,
                                                       .origin = {7, -3, 1},
                                                       .period = {3, 0, dim == 3 ? 3 : 0},
                                                       .place = {x[0], x[1], dim == 3 ? x[2] : NULL},
                                                       .volume = volume,
                                                       .horizon = horizon,
                                                       .law = solid_pair_law(&in, &material)});
}

/* Number of bonds of particle i by all pairs; each of them must be in the family, with its image and xi. */
static int all_pairs(const struct solid_cloud *t, long i, const struct solid_cloud_near *near) {
    const struct solid_end here = solid_cloud_end(t, i);
    int bonds = 0;
    for (long l = 0; l < t->n; l++)
        for (int code = 0; code < SOLID_IMAGES; code++) {
            double xi[3] = {0};
            int exists = l != i || code != SOLID_NO_IMAGE, found = 0;
            for (int c = 0; c < 3; c++) {
                const int image = solid_cloud_image_of(code, c);
                if (image && !(t->period[c] > 0)) exists = 0;
                if (c < t->dim) xi[c] = t->place[c][l] - t->place[c][i] + image * t->period[c];
            }
            const struct solid_end there = solid_cloud_end(t, l);
            if (!exists || !solid_pair_exists(&t->law, xi, &here, &there)) continue;
            for (int b = 0; b < near->n; b++) {
                if (near->number[b] != l || near->image[b] != code) continue;
                for (int c = 0; c < 3; c++) check_equal(near->xi[b][c], xi[c]);
                found++;
            }
            check_equal(found, 1);
            bonds++;
        }
    return bonds;
}

/* The family is complete and in the order of xi: z, then y, then x; counting it gives its length. */
static void families(void **state) {
    (void)state;
    static struct solid_cloud_near near;
    srand(12);
    for (int k = 0; k < 4; k++) {
        struct solid_cloud *t =
            cloud_of(2 + k % 2, k % 2 ? MOST : MOST / 3, k / 2 ? SOLID_ONE_SIDED : SOLID_DUAL_HORIZON);
        long bonds = 0;
        for (long i = 0; i < t->n; i++) {
            solid_cloud_near_find(t, i, &near);
            check_equal(near.n, all_pairs(t, i, &near));
            check_equal(near.n, solid_cloud_near_count(t, i));
            bonds += near.n;
            for (int b = 1; b < near.n; b++) {
                const double *x = near.xi[b - 1], *y = near.xi[b];
                const int c = x[2] != y[2] ? 2 : x[1] != y[1] ? 1 : 0;
                check_below(x[c], y[c]);
            }
        }
        check_above(bonds, 5 * t->n);
        solid_cloud_free(t);
    }
}

struct seen {
    const struct solid_cloud *cloud;
    const double *place;
    double reach;
    int n;
};

static void see(void *with, long number, int image, const double xi[3]) {
    struct seen *seen = with;
    double r2 = 0;
    for (int c = 0; c < seen->cloud->dim; c++) {
        const double x = seen->cloud->place[c][number] + solid_cloud_image_of(image, c) * seen->cloud->period[c];
        check_close(xi[c], x - seen->place[c], 1e-12);
        r2 += xi[c] * xi[c];
    }
    seen->n += r2 <= seen->reach * seen->reach;
}

/* A visit about any place meets all particles within reach, at the nearest image and the others. */
static void visits(void **state) {
    (void)state;
    struct solid_cloud *t = cloud_of(2, MOST, SOLID_DUAL_HORIZON);
    for (int trial = 0; trial < 50; trial++) {
        const double place[3] = {uniform(0, 6), uniform(-1, 7), 0};
        struct seen seen = {t, place, uniform(0.5, 2), 0};
        int expected = 0;
        solid_cloud_near_visit(t, place, seen.reach, see, &seen);
        for (long l = 0; l < t->n; l++)
            for (int image = -1; image <= 1; image++)
                expected +=
                    hypot(t->place[0][l] + image * t->period[0] - place[0], t->place[1][l] - place[1]) <= seen.reach;
        check_equal(seen.n, expected);
    }
    const double x[3] = {solid_cloud_x(t, 0, 3) + 3, solid_cloud_x(t, 1, 3), 0}, off[3] = {x[0] + 1e-4, x[1], 0};
    check_equal(solid_cloud_near_holds(t, x), 1);
    check_equal(solid_cloud_near_holds(t, off), 0);
    solid_cloud_free(t);
}

/* Two pairs, 2^29 spacings apart in each direction: each has its bond, and there are not as many cells as fit between
 * them. */
static void pairs_far_apart(void **state) {
    (void)state;
    static struct solid_cloud_near near;
    const double far = 0x1p29, x[4] = {0, 1, far, far + 1}, y[4] = {0, 0, far, far}, volume[4] = {1, 1, 1, 1};
    const struct solid_input in = {.model = PHYSICS_3D, .spacing = 0.5};
    struct solid_cloud *t = solid_cloud_new(&(struct solid_cloud_input){.name = "pairs",
                                                                        .n = 4,
                                                                        .spacing = 0.5,
                                                                        .place = {x, y, y},
                                                                        .volume = volume,
                                                                        .law = solid_pair_law(&in, &material)});
    check_below((double)t->cells.cells[0] * t->cells.cells[1] * t->cells.cells[2], 0x1p21);
    for (long i = 0; i < 4; i++) {
        solid_cloud_near_find(t, i, &near);
        check_equal(near.n, 1);
        check_equal(near.number[0], i ^ 1);
    }
    solid_cloud_free(t);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(families), cmocka_unit_test(visits),
                                       cmocka_unit_test(pairs_far_apart)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
