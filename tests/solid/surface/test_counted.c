/* Depth of interface particles by the number of their neighbours: faces along the lattice, walls, edges, balls, sides
 * that are periodic, cracks. */
#include "solid/solid.h"
#include "solid/surface/counted.h"
#include "solid/surface/surface.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

static struct solid *make(struct solid_input in, struct solid_surface **f) {
    in.depth = SOLID_DEPTH_COUNTED;
    struct solid *s = solid_new(&in);
    *f = solid_surface_new(s);
    return s;
}

static void free_surface(struct solid *s, struct solid_surface *f) {
    solid_surface_free(f);
    solid_free(s);
}

/* How far a site is from the sides of a box of n particles along c. */
static int inward(int p, int n) { return p < n - 1 - p ? p : n - 1 - p; }

/* A face has exactly 1/2 three sites away from its edges; edges and corners are rounded. */
static void box(void **state) {
    (void)state;
    enum { N = 12 };
    const struct solid_body body = bodies_box(0, 0, 0, N, N, N);
    struct solid_surface *f;
    struct solid *s = make(bodies_input(1, &body), &f);
    long faces = 0, edges = 0, corners = 0;
    for (int i = 0; i < f->n; i++) {
        int p[3], on = 0, near = 0;
        bodies_site(s, f->h[i], p);
        for (int c = 0; c < 3; c++) on += inward(p[c], N) == 0, near += inward(p[c], N) < 2;
        const double depth = f->depth[i] / SPACING;
        if (near == 1) check_equal(f->depth[i], 0.5 * SPACING);
        if (on == 1) check_between(depth, 0.48, 0.5 + 1e-9);
        if (on == 2) check_between(depth, 0.07, 0.08);
        if (on == 3) check_equal(depth, 0);
        faces += near == 1, edges += on == 2, corners += on == 3;
    }
    assert_int_equal(par_sum_long(faces), 6 * (N - 4) * (N - 4));
    assert_int_equal(par_sum_long(edges), 12 * (N - 2));
    assert_int_equal(par_sum_long(corners), 8);
    free_surface(s, f);
}

/* Endless walls of 1, 2 and 3 particles, along each axis. */
static void walls(void **state) {
    (void)state;
    static const double expected[4] = {0, 0.5, 0.491, 0.5};
    enum { N = 8 };
    for (int axis = 0; axis < 3; axis++)
        for (int thick = 1; thick <= 3; thick++) {
            int n[3] = {N, N, N};
            n[axis] = thick;
            const struct solid_body body = bodies_box(0, 0, 0, n[0], n[1], n[2]);
            struct solid_input in = bodies_input(1, &body);
            for (int c = 0; c < 3; c++) {
                in.periodic[c] = c != axis;
                in.length[c] = N * SPACING;
            }
            struct solid_surface *f;
            struct solid *s = make(in, &f);
            assert_int_equal(f->total, (thick < 3 ? thick : 2) * N * N);
            for (int i = 0; i < f->n; i++) check_close(f->depth[i] / SPACING, expected[thick], thick == 2 ? 1e-3 : 0);
            free_surface(s, f);
        }
}

/* Balls at several places on the lattice have the mean error and the scatter that physics/depth.h states, relative to
 * the ball that has the volume of the sites. */
static void balls(void **state) {
    (void)state;
    static const double centre[3][3] = {{10.5, 10.5, 10.5}, {10.23, 10.61, 10.47}, {11, 11, 11}};
    for (int n = 0; n < 3; n++) {
        const double radius = 8.3;
        struct solid_body body = {.name = "ball", .shape = SOLID_SPHERE, .radius = radius * SPACING};
        for (int c = 0; c < 3; c++) body.centre[c] = centre[n][c] * SPACING;
        struct solid_surface *f;
        struct solid *s = make(bodies_input(1, &body), &f);
        const double same = cbrt(3 * (double)s->n_global / (4 * M_PI)); /* radius, spacings */
        double sum[3] = {0, 0, 0};
        for (int i = 0; i < f->n; i++) {
            double r2 = 0;
            for (int c = 0; c < 3; c++) r2 += pow(s->x0[c][f->h[i]] - body.centre[c], 2);
            const double e = (f->depth[i] + sqrt(r2)) / SPACING - same;
            sum[0] += 1, sum[1] += e, sum[2] += e * e;
        }
        par_sum_array(sum, 3);
        const double mean = sum[1] / sum[0], scatter = sqrt(sum[2] / sum[0] - mean * mean);
        print_message("ball %d: radius of the same volume %.3f, depth %+.3f, standard deviation %.3f\n", n, same, mean,
                      scatter);
        check_close(mean, -0.02 - 0.6 / radius, 0.02);
        check_below(scatter, 0.11);
        free_surface(s, f);
    }
}

/* A particle that has lost a neighbour, or joined the interface later, has half a spacing; a rotation changes
 * nothing. */
static void cracks(void **state) {
    (void)state;
    struct solid_body body = {.name = "ball", .shape = SOLID_SPHERE, .radius = 7.2 * SPACING};
    for (int c = 0; c < 3; c++) body.centre[c] = 8.2 * SPACING;
    struct solid_surface *f;
    struct solid *s = make(bodies_input(1, &body), &f);
    double *before = calloc((size_t)s->n + 1, sizeof *before);
    for (int i = 0; i < f->n; i++) before[f->h[i]] = f->depth[i];
    bodies_turn(s, 0.4, 2 * SPACING);
    solid_surface_update(s, f);
    for (int i = 0; i < f->n; i++) check_equal(f->depth[i], before[f->h[i]]);
    bodies_turn(s, 0, 0);
    bodies_cut(s, 0, 8);
    bodies_open(s, 0, 8, 4 * SPACING);
    solid_surface_update(s, f);
    long fresh = 0, kept = 0;
    for (int i = 0; i < f->n; i++) {
        int p[3];
        bodies_site(s, f->h[i], p);
        const int cut = p[0] == 7 || p[0] == 8;
        check_equal(f->depth[i], cut ? 0.5 * SPACING : before[f->h[i]]);
        fresh += cut, kept += !cut;
    }
    check_above(par_sum_long(fresh), 200);
    check_above(par_sum_long(kept), 200);
    free(before);
    free_surface(s, f);
}

/* Without a fluid nothing is counted; a family that does not reach two spacings is counted as far as it reaches. */
static void short_families(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 6, 6, 6);
    struct solid_input in = bodies_input(1, &body);
    struct solid *s = solid_new(&in);
    struct solid_surface *f = solid_surface_new(s);
    assert_null(f->counted);
    for (int i = 0; i < f->n; i++) check_equal(f->depth[i], 0.5 * SPACING);
    free_surface(s, f);
    for (int n = 0; n < 3; n++) {
        struct solid_material narrow = bodies_material;
        narrow.horizon_ratio = (const double[3]){1, 1.45, 1.5}[n];
        in.material = &narrow;
        s = make(in, &f);
        for (int i = 0; i < f->n; i++) {
            int p[3], on = 0;
            bodies_site(s, f->h[i], p);
            for (int c = 0; c < 3; c++) on += inward(p[c], 6) == 0;
            if (on == 1 && inward(p[0], 6) != 1 && inward(p[1], 6) != 1 && inward(p[2], 6) != 1)
                check_equal(f->depth[i], 0.5 * SPACING);
            if (on == 2) check_between(f->depth[i] / SPACING, 0.05, 0.25);
        }
        free_surface(s, f);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(box), cmocka_unit_test(walls), cmocka_unit_test(balls),
                                       cmocka_unit_test(cracks), cmocka_unit_test(short_families)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
