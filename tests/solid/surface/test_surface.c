/* Interface, normals and areas of unbroken bodies. */
#include "solid/solid.h"
#include "solid/surface/surface.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

/* Whether a site is filled: the oracle, by hand for each body. */
typedef int filled(const int site[3]);

static int wrap[3]; /* the period in sites, 0: none */

static int is_filled(filled *f, const int site[3]) {
    int p[3];
    for (int c = 0; c < 3; c++) p[c] = wrap[c] ? (site[c] + wrap[c]) % wrap[c] : site[c];
    return f(p);
}

/* A particle of the outer layer: one of its six nearest sites is void. */
static int is_outer(filled *f, const int site[3]) {
    for (int k = 0; k < 6; k++) {
        int p[3] = {site[0], site[1], site[2]};
        p[k / 2] += k % 2 ? -1 : 1;
        if (!is_filled(f, p)) return 1;
    }
    return 0;
}

/* The interface is exactly the outer layer; returns its size. */
static long check_outer(const struct solid *s, const struct solid_surface *surface, filled *f) {
    long outer = 0;
    int next = 0;
    for (int h = 0; h < s->n; h++) {
        int site[3];
        bodies_site(s, h, site);
        assert_true(is_filled(f, site));
        const int on = is_outer(f, site);
        assert_int_equal(on, (s->flag[h] & SOLID_INTERFACE) != 0);
        assert_int_equal(on, (s->flag[h] & SOLID_FIRST) != 0);
        if (!on) continue;
        assert_int_equal(surface->h[next], h);
        next++;
        outer++;
    }
    assert_int_equal(surface->n, next);
    outer = par_sum_long(outer);
    assert_int_equal(surface->total, outer);
    return outer;
}

static double normal_error(const struct solid_surface *surface, int i, double x, double y, double z) {
    const double e[3] = {x, y, z};
    double r = 0;
    for (int c = 0; c < 3; c++) r = check_worst(r, surface->normal[c][i] - e[c]);
    return r;
}

static int cube(const int p[3]) { return p[0] >= 0 && p[0] < 9 && p[1] >= 0 && p[1] < 9 && p[2] >= 0 && p[2] < 9; }

static void faces_edges_and_corners(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++) {
        const struct solid_body body = bodies_box(0, 0, 0, 9, 9, 9);
        struct solid_input in = bodies_input(1, &body);
        in.general_bonds = general;
        struct solid *s = solid_new(&in);
        struct solid_surface *surface = solid_surface_new(s);
        assert_int_equal(check_outer(s, surface, cube), 729 - 343);
        for (int i = 0; i < surface->n; i++) {
            int p[3];
            bodies_site(s, surface->h[i], p);
            assert_false(surface->two_sided[i]);
            check_equal(surface->area[i], surface->initial_area);
            int ends = 0, middles = 0;
            double e[3];
            for (int c = 0; c < 3; c++) {
                e[c] = p[c] == 8 ? 1 : p[c] == 0 ? -1 : 0;
                ends += e[c] != 0;
                middles += p[c] >= 3 && p[c] <= 5;
            }
            /* where the family contains only this face, edge or corner; the corner's three faces are 9 apart */
            if (ends + middles == 3)
                check_below(normal_error(surface, i, e[0] / sqrt(ends), e[1] / sqrt(ends), e[2] / sqrt(ends)), 1e-13);
        }
        solid_surface_free(surface);
        solid_free(s);
    }
}

static int slab_axis, slab_thickness;
static int slab(const int p[3]) { return p[slab_axis] >= 4 && p[slab_axis] < 4 + slab_thickness; }

/* Plates 1, 2, 3 and 5 thick across each direction, endless in the other two. */
static void plates(void **state) {
    (void)state;
    const int thick[4] = {1, 2, 3, 5};
    for (slab_axis = 0; slab_axis < 3; slab_axis++)
        for (int t = 0; t < 4; t++) {
            slab_thickness = thick[t];
            int from[3] = {0, 0, 0}, n[3] = {8, 8, 8};
            from[slab_axis] = 4;
            n[slab_axis] = slab_thickness;
            const struct solid_body body = bodies_box(from[0], from[1], from[2], n[0], n[1], n[2]);
            struct solid_input in = bodies_input(1, &body);
            for (int c = 0; c < 3; c++) {
                in.periodic[c] = c != slab_axis;
                in.length[c] = c == slab_axis ? 1 : 8 * SPACING;
                wrap[c] = c == slab_axis ? 0 : 8;
            }
            struct solid *s = solid_new(&in);
            struct solid_surface *surface = solid_surface_new(s);
            assert_int_equal(check_outer(s, surface, slab), slab_thickness == 1 ? 64 : 128);
            check_relative(surface->immersed_area, 128 * SPACING * SPACING, 1e-12);
            for (int i = 0; i < surface->n; i++) {
                int p[3];
                bodies_site(s, surface->h[i], p);
                check_relative(surface->area[i], SPACING * SPACING, 1e-12);
                assert_int_equal(surface->two_sided[i], slab_thickness == 1);
                double e[3] = {0, 0, 0};
                e[slab_axis] = p[slab_axis] == 4 ? -1 : 1;
                if (surface->two_sided[i]) e[slab_axis] = surface->normal[slab_axis][i] > 0 ? 1 : -1;
                check_below(normal_error(surface, i, e[0], e[1], e[2]), 1e-12);
            }
            solid_surface_free(surface);
            solid_free(s);
        }
    wrap[0] = wrap[1] = wrap[2] = 0;
}

/* The rim of a plate one particle thick has normals in the plate's plane; particles farther inside have two faces. */
static void rim(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 12, 8, 1);
    struct solid_input in = bodies_input(1, &body);
    in.periodic[1] = 1;
    in.length[1] = 8 * SPACING;
    struct solid *s = solid_new(&in);
    struct solid_surface *surface = solid_surface_new(s);
    assert_int_equal(surface->total, 96);
    for (int i = 0; i < surface->n; i++) {
        int p[3];
        bodies_site(s, surface->h[i], p);
        const int depth = p[0] < 6 ? p[0] : 11 - p[0];
        if (depth == 0) check_below(normal_error(surface, i, p[0] == 0 ? -1 : 1, 0, 0), 1e-12);
        if (depth == 0) assert_false(surface->two_sided[i]);
        if (depth >= 3) {
            assert_true(surface->two_sided[i]);
            check_close(fabs(surface->normal[2][i]), 1, 1e-12);
        }
    }
    solid_surface_free(surface);
    solid_free(s);
}

static double ball_radius;
static int ball_is_void; /* 1: a cavity in a periodic block of 24; 0: a ball */
static int ball(const int p[3]) {
    double r2 = 0;
    for (int c = 0; c < 3; c++) r2 += (p[c] + 0.5 - 12) * (p[c] + 0.5 - 12);
    return ball_is_void ? r2 > ball_radius * ball_radius : r2 < ball_radius * ball_radius;
}

static struct solid *ball_new(double centre) {
    struct solid_body body = bodies_box(0, 0, 0, 24, 24, 24);
    if (ball_is_void) {
        body.cavity_period = 24 * SPACING;
        body.cavity_radius = ball_radius * SPACING;
    } else {
        body.shape = SOLID_SPHERE;
        body.radius = ball_radius * SPACING;
    }
    for (int c = 0; c < 3; c++) body.centre[c] = body.cavity_centre[c] = centre * SPACING;
    struct solid_input in = bodies_input(1, &body);
    for (int c = 0; c < 3; c++) {
        in.periodic[c] = ball_is_void;
        in.length[c] = 24 * SPACING;
        wrap[c] = ball_is_void ? 24 : 0;
    }
    return solid_new(&in);
}

/* A cavity's and a ball's outer layer, its area and its normals along the radius: a lattice's family is a cut of the
 * true one, which tilts normals by a few degrees. */
static void cavity_and_ball(void **state) {
    (void)state;
    for (ball_is_void = 0; ball_is_void < 2; ball_is_void++) {
        ball_radius = 7.3;
        struct solid *s = ball_new(12);
        struct solid_surface *surface = solid_surface_new(s);
        check_above(check_outer(s, surface, ball), 0);
        double sum[2] = {0, 0}, least = 1;
        for (int i = 0; i < surface->n; i++) {
            double x[3], r = 0, cosine = 0;
            for (int c = 0; c < 3; c++) {
                x[c] = s->x0[c][surface->h[i]] - 12 * SPACING;
                r += x[c] * x[c];
                cosine += x[c] * surface->normal[c][i] * (ball_is_void ? -1 : 1);
            }
            cosine /= sqrt(r);
            assert_false(surface->two_sided[i]);
            sum[0] += 1 - cosine;
            sum[1]++;
            least = fmin(least, cosine);
        }
        par_sum_array(sum, 2);
        least = par_min(least);
        const double area = surface->immersed_area / (4 * M_PI * ball_radius * ball_radius * SPACING * SPACING);
        print_message("%s: area %.4f of the sphere's, normals: least cosine %.4f, mean %.5f\n",
                      ball_is_void ? "cavity" : "ball", area, least, 1 - sum[0] / sum[1]);
        check_close(area, 1, 0.015);
        check_above(least, cos(6 * M_PI / 180));
        check_below(sum[0] / sum[1], 1 - cos(3 * M_PI / 180));
        solid_surface_free(surface);
        solid_free(s);
    }
    wrap[0] = wrap[1] = wrap[2] = 0;
}

/* A pore one particle wide: its six neighbours, whose normals point into it. */
static void pore(void **state) {
    (void)state;
    ball_is_void = 1;
    ball_radius = 0.9;
    for (int general = 0; general < 2; general++) {
        struct solid_body body = bodies_box(0, 0, 0, 9, 9, 9);
        body.cavity_period = 9 * SPACING;
        body.cavity_radius = 0.9 * SPACING;
        for (int c = 0; c < 3; c++) body.cavity_centre[c] = 4.5 * SPACING;
        struct solid_input in = bodies_input(1, &body);
        in.general_bonds = general;
        for (int c = 0; c < 3; c++) {
            in.periodic[c] = 1;
            in.length[c] = 9 * SPACING;
        }
        struct solid *s = solid_new(&in);
        assert_int_equal(s->n_global, 728);
        struct solid_surface *surface = solid_surface_new(s);
        assert_int_equal(surface->total, 6);
        check_relative(surface->immersed_area, 6 * SPACING * SPACING, 1e-12);
        for (int i = 0; i < surface->n; i++) {
            double e[3];
            int away = 0;
            for (int c = 0; c < 3; c++) {
                e[c] = 4.5 - s->x0[c][surface->h[i]] / SPACING;
                away += fabs(e[c]) > 1e-9;
            }
            assert_int_equal(away, 1);
            assert_false(surface->two_sided[i]);
            check_below(normal_error(surface, i, e[0], e[1], e[2]), 1e-9);
        }
        solid_surface_free(surface);
        solid_free(s);
    }
}

/* Particles on no lattice: the same ones moved a little at random, the same outer layer. */
static void points(void **state) {
    (void)state;
    enum { N = 9 * 9 * 9 };
    double *x[3], *volume = malloc(N * sizeof(double));
    for (int c = 0; c < 3; c++) x[c] = malloc(N * sizeof(double));
    for (int i = 0; i < N; i++) {
        const int p[3] = {i % 9, i / 9 % 9, i / 81};
        for (int c = 0; c < 3; c++) x[c][i] = (p[c] + 0.5 + 0.2 * (bodies_random(i, c) - 0.5)) * SPACING;
        volume[i] = SPACING * SPACING * SPACING;
    }
    const struct solid_body body = {
        .name = "points", .shape = SOLID_POINTS, .points = N, .point = {x[0], x[1], x[2]}, .point_volume = volume};
    const struct solid_input in = bodies_input(1, &body);
    struct solid *s = solid_new(&in);
    struct solid_surface *surface = solid_surface_new(s);
    assert_int_equal(check_outer(s, surface, cube), 729 - 343);
    check_relative(surface->initial_area, SPACING * SPACING, 1e-12);
    solid_surface_free(surface);
    solid_free(s);
    for (int c = 0; c < 3; c++) free(x[c]);
    free(volume);
}

/* A held layer below a channel's wall is material for the body above it; the area can be restricted to the channel. */
static void held_layer(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, -3, 0, 6, 9, 6);
    const struct solid_constraint hold = {.low = {-1, -1, -1}, .high = {1, 0, 1}, .direction = {1, 1, 1}};
    struct solid_input in = bodies_input(1, &body);
    in.constraints = 1;
    in.constraint = &hold;
    in.periodic[0] = in.periodic[2] = 1;
    in.length[0] = in.length[2] = 6 * SPACING;
    in.length[1] = 1;
    struct solid *s = solid_new(&in);
    struct solid_surface *surface = solid_surface_new(s);
    for (int i = 0; i < surface->n; i++) {
        int p[3];
        bodies_site(s, surface->h[i], p);
        assert_true(p[1] == -3 || p[1] == 5);
    }
    assert_int_equal(surface->total, 72);
    solid_surface_area_restrict(s, surface, (double[]){0, 0, 0}, (double[]){1, 1, 1});
    check_relative(surface->immersed_area, 36 * SPACING * SPACING, 1e-12);
    check_relative(surface->initial_area, SPACING * SPACING, 1e-12);
    solid_surface_free(surface);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faces_edges_and_corners),
        cmocka_unit_test(plates),
        cmocka_unit_test(rim),
        cmocka_unit_test(cavity_and_ball),
        cmocka_unit_test(pore),
        cmocka_unit_test(points),
        cmocka_unit_test(held_layer),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
