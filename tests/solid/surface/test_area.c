/* Shares of the wetted area by hand: on a face, on a thin wall, of a point; and the area of a part of the body. */
#include "solid/solid.h"
#include "solid/surface/area.h"
#include "solid/surface/surface.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

/* A slab of n layers across z, endless along x and y. */
static struct solid *slab(int layers) {
    const struct solid_body body = bodies_box(0, 0, 0, 8, 8, layers);
    struct solid_input in = bodies_input(1, &body);
    in.periodic[0] = in.periodic[1] = 1;
    in.length[0] = in.length[1] = 8 * SPACING;
    in.length[2] = 1;
    return solid_new(&in);
}

static double share(const struct solid *s, int h, unsigned open) {
    static struct solid_family_view view;
    struct solid_normal_data start;
    solid_family_view(s, h, &view);
    solid_normal_compute_initial(s, h, &view, open, &start);
    return solid_surface_area_share(s, h, &view, &start);
}

/* One square for each bare face; none inside. */
static void squares(void **state) {
    (void)state;
    const double square = SPACING * SPACING;
    for (int layers = 1; layers <= 4; layers += 3) {
        struct solid *s = slab(layers);
        for (int h = 0; h < s->n; h++) {
            int p[3];
            bodies_site(s, h, p);
            const unsigned open = (p[2] == layers - 1 ? 16u : 0) | (p[2] == 0 ? 32u : 0);
            check_close(share(s, h, open), square * ((p[2] == layers - 1) + (p[2] == 0)), 1e-12 * square);
            check_relative(solid_surface_area_fresh(s, h), square, 1e-14);
        }
        solid_free(s);
    }
}

/* On an edge of 90 degrees both faces take part with |n.e|: equal by symmetry, less than a square each, more than
 * cos 45 degrees of it. */
static void edge(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 8, 8, 8);
    struct solid_input in = bodies_input(1, &body);
    in.periodic[0] = 1;
    in.length[0] = 8 * SPACING;
    in.length[1] = in.length[2] = 1;
    struct solid *s = solid_new(&in);
    for (int h = 0; h < s->n; h++) {
        int p[3];
        bodies_site(s, h, p);
        if (p[1] != 7 || p[2] != 0) continue;
        const double one = share(s, h, 4), other = share(s, h, 32), both = share(s, h, 4 | 32);
        check_relative(one, other, 1e-12);
        check_relative(both, one + other, 1e-12);
        check_between(one / (SPACING * SPACING), sqrt(0.5), 1);
    }
    solid_free(s);
}

/* A particle on no lattice has volume^(2/3), twice where both sides are wetted. */
static void points(void **state) {
    (void)state;
    static struct solid_family_view view;
    double x[2] = {0.2 * SPACING, 1.1 * SPACING}, y[2] = {0, 0}, z[2] = {0, 0}, volume[2];
    for (int p = 0; p < 2; p++) volume[p] = (p + 1) * 0.5 * SPACING * SPACING * SPACING;
    const struct solid_body body = {
        .name = "points", .shape = SOLID_POINTS, .points = 2, .point = {x, y, z}, .point_volume = volume};
    const struct solid_input in = bodies_input(1, &body);
    struct solid *s = solid_new(&in);
    for (int h = 0; h < s->n; h++)
        for (int two = 0; two < 2; two++) {
            struct solid_normal_data start = {.n = {1, 0, 0}, .two_sided = (uint8_t)two, .open = 63};
            solid_family_view(s, h, &view);
            check_relative(solid_surface_area_share(s, h, &view, &start), (1 + two) * pow(s->volume[h], 2. / 3), 1e-13);
        }
    solid_free(s);
}

/* Restricted to a part of the body: its particles' shares and faces alone; nothing there: 0. */
static void restricted(void **state) {
    (void)state;
    const double square = SPACING * SPACING;
    const double low[3][3] = {{-1, -1, -1}, {0, 0, 2 * SPACING}, {0, 0, 1}},
                 high[3][3] = {{1, 1, 1}, {4 * SPACING, 1, 1}, {1, 1, 2}};
    const double expected[3] = {128, 32, 0};
    struct solid *s = slab(4);
    struct solid_surface *surface = solid_surface_new(s);
    for (int k = 0; k < 3; k++) {
        solid_surface_area_restrict(s, surface, low[k], high[k]);
        check_close(surface->immersed_area, expected[k] * square, 1e-11 * square);
        check_close(surface->initial_area, expected[k] > 0 ? square : 0, 1e-12 * square);
        for (int i = 0; i < surface->n; i++) check_equal(surface->area[i], surface->initial_area);
    }
    solid_surface_free(surface);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(squares), cmocka_unit_test(edge), cmocka_unit_test(points),
                                       cmocka_unit_test(restricted)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
