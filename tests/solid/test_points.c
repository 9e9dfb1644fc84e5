/* Bodies of points on no lattice, and several bodies. */
#include "tests/solid/make.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/solid.h"
#include "solid/step/rates.h"
#include "tests/check.h"

#include <stdlib.h>

struct cloud {
    long n;
    double *x[3], *volume;
};

/* A block of points on the lattice, each moved by up to jitter spacings. */
static struct cloud cloud_new(const int sites[3], double jitter) {
    struct cloud cloud = {0};
    const long n = (long)sites[0] * sites[1] * sites[2];
    for (int c = 0; c < 3; c++) cloud.x[c] = malloc((size_t)n * sizeof(double));
    cloud.volume = malloc((size_t)n * sizeof(double));
    srand(5);
    for (int k = 0; k < sites[2]; k++)
        for (int j = 0; j < sites[1]; j++)
            for (int i = 0; i < sites[0]; i++, cloud.n++) {
                const int site[3] = {i, j, k};
                for (int c = 0; c < 3; c++)
                    cloud.x[c][cloud.n] = (site[c] + 0.5 + jitter * (2. * rand() / RAND_MAX - 1)) * SPACING;
                cloud.volume[cloud.n] = pow(SPACING, 3) * (1 + jitter * (2. * rand() / RAND_MAX - 1));
            }
    return cloud;
}

static struct solid *solid_of(const struct cloud *cloud, const int periodic[3], const int sites[3]) {
    const struct solid_body body = {.name = "cloud",
                                    .shape = SOLID_POINTS,
                                    .points = cloud->n,
                                    .point = {cloud->x[0], cloud->x[1], cloud->x[2]},
                                    .point_volume = cloud->volume};
    const struct solid_material material = {YOUNG, DENSITY, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
    struct solid_input in = {
        .spacing = SPACING, .bodies = 1, .body = &body, .materials = 1, .material = &material, .surface_correction = 1};
    for (int c = 0; c < 3; c++) {
        in.periodic[c] = periodic[c];
        in.length[c] = sites[c] * SPACING;
    }
    return solid_new(&in);
}

static void cloud_free(struct cloud *cloud) {
    for (int c = 0; c < 3; c++) free(cloud->x[c]);
    free(cloud->volume);
}

/* Points on a lattice have the same forces as the lattice's particles, to the quadrature of Gamma. */
static void test_points_on_lattice(void **state) {
    (void)state;
    const int sites[3] = {9, 8, 10}, periodic[3] = {1, 0, 0};
    struct cloud cloud = cloud_new(sites, 0);
    struct solid *points = solid_of(&cloud, periodic, sites);
    struct solid *lattice = make((struct make){.sites = {9, 8, 10}, .periodic = {1, 0, 0}});
    assert_int_equal(points->bonds_total, lattice->bonds_total);
    struct solid *const both[2] = {points, lattice};
    double sum[2][2] = {{0}};
    for (int i = 0; i < 2; i++) {
        struct solid *s = both[i];
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) s->d[c][h] = 1e-4 * SPACING * noise(s, h, c);
        solid_ghosts_update(s);
        solid_force(s, 0);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) {
                sum[i][0] += s->a[c][h] * s->a[c][h];
                sum[i][1] += s->a[c][h] * noise(s, h, 7);
            }
        par_sum_array(sum[i], 2);
    }
    check_close(sum[0][0] / sum[1][0], 1, 2e-4);
    check_close(sum[0][1] / sum[1][1], 1, 2e-3);
    solid_free(points);
    solid_free(lattice);
    cloud_free(&cloud);
}

/* Points anywhere, of unequal volume, with a periodic side: forces are equal and opposite, rotation costs nothing. */
static void test_points_anywhere(void **state) {
    (void)state;
    const int sites[3] = {9, 8, 10}, periodic[3] = {0, 0, 1};
    struct cloud cloud = cloud_new(sites, 0.2);
    struct solid *s = solid_of(&cloud, periodic, sites);
    assert_int_equal(s->n_global, 720);
    double volume = 0, moment = 0, cloud_volume = 0, cloud_moment = 0;
    for (int h = 0; h < s->n; h++) volume += s->volume[h], moment += s->volume[h] * s->x0[0][h];
    for (long p = 0; p < cloud.n; p++) cloud_volume += cloud.volume[p], cloud_moment += cloud.volume[p] * cloud.x[0][p];
    check_close(par_sum(volume) / cloud_volume, 1, 1e-12);
    /* places are rounded to 2^-20 of the spacing */
    check_close((par_sum(moment) - cloud_moment) / (cloud_volume * SPACING), 0, 0x1p-21);
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) s->d[c][h] = 1e-3 * SPACING * noise(s, h, c);
    solid_ghosts_update(s);
    solid_force(s, 1);
    solid_family_count(s);
    check_between(s->bonds_broken, 0, s->bonds_total);
    double force[3] = {0}, size = 0;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            force[c] += s->volume[h] * s->a[c][h];
            size += fabs(s->volume[h] * s->a[c][h]);
        }
    par_sum_array(force, 3);
    size = par_sum(size);
    for (int c = 0; c < 3; c++) check_close(force[c] / size, 0, 1e-14);
    check_between(solid_rates_stable_step(s, SOLID_VERLET), step_of(1.4), step_of(2.2));
    solid_free(s);
    cloud_free(&cloud);
}

/* Spheres and cylinders of lattice, side by side, of two materials; bodies are not bonded to each other. */
static void test_bodies(void **state) {
    (void)state;
    static struct solid_family_view view;
    const double l = SPACING;
    const struct solid_body body[3] = {
        {.name = "ball", .shape = SOLID_SPHERE, .centre = {0, 0, 0}, .radius = 5.2 * l},
        {.name = "rod",
         .shape = SOLID_CYLINDER,
         .centre = {11 * l, 0, 0},
         .radius = 4.3 * l,
         .axis = 2,
         .length = 12 * l,
         .material = 1},
        {.name = "slab", .shape = SOLID_BOX, .low = {-8 * l, -8 * l, -8 * l}, .high = {8 * l, -5 * l, 8 * l}}};
    const struct solid_material material[2] = {{1e8, 3000, 0.05, 3, PHYSICS_CONSTANT, 0, 0},
                                               {2e8, 1500, 0.1, 2, PHYSICS_CONSTANT, 0, 0}};
    for (int list = 0; list < 2; list++) {
        const struct solid_input in = {.spacing = l,
                                       .bodies = 3,
                                       .body = body,
                                       .materials = 2,
                                       .material = material,
                                       .surface_correction = 1,
                                       .general_bonds = list};
        struct solid *s = solid_new(&in);
        long count[3] = {0}, expected[3] = {0, 0, 16 * 3 * 16};
        for (int k = -20; k < 20; k++)
            for (int j = -20; j < 20; j++)
                for (int i = -20; i < 20; i++) {
                    const double x = i + 0.5, y = j + 0.5, z = k + 0.5;
                    expected[0] += x * x + y * y + z * z < 5.2 * 5.2;
                    expected[1] += (x - 11) * (x - 11) + y * y < 4.3 * 4.3 && z > -6 && z < 6;
                }
        for (int h = 0; h < s->n; h++) {
            count[s->body[h]]++;
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) assert_int_equal(s->body[view.l[b]], s->body[h]);
        }
        par_sum_long_array(count, 3);
        for (int b = 0; b < 3; b++) assert_int_equal(count[b], expected[b]);
        /* one body is dilated: only it has forces; the stiffer material has twice the modulus and 16/81 of delta^4 */
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) s->d[c][h] = s->body[h] == 1 ? 1e-4 * s->x0[c][h] : 0;
        solid_ghosts_update(s);
        solid_force(s, 0);
        double most[3] = {0};
        for (int h = 0; h < s->n; h++) most[s->body[h]] = fmax(most[s->body[h]], fabs(s->a[0][h]));
        par_max_array(most, 3);
        check_above(most[1], 1);
        check_equal(most[0], 0);
        check_equal(most[2], 0);
        const double soft = step_of(1.569),
                     stiff = soft / sqrt(2 * 2); /* E/rho four times: half the step, at m = 2 less */
        const double step = solid_rates_stable_step(s, SOLID_RK3);
        check_between(step, 0.5 * stiff, 1.1 * stiff);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_points_on_lattice),
        cmocka_unit_test(test_points_anywhere),
        cmocka_unit_test(test_bodies),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
