/* Depth and normal of interface particles against the shapes that bodies are cut from. */
#include "solid/geometry/shape.h"
#include "solid/solid.h"
#include "solid/surface/surface.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"
#include "tests/solid/shape_depth.h"

#include <stdlib.h>

static struct solid *make_with(enum solid_depth depth, const struct solid_body *body, int periodic, int sites,
                               struct solid_surface **f) {
    struct solid_input in = bodies_input(1, body);
    in.depth = depth;
    if (periodic >= 0) {
        in.periodic[periodic] = 1;
        in.length[periodic] = sites * SPACING;
    }
    struct solid *s = solid_new(&in);
    *f = solid_surface_new(s);
    return s;
}

static struct solid *make(const struct solid_body *body, int periodic, int sites, struct solid_surface **f) {
    return make_with(SOLID_DEPTH_SHAPE, body, periodic, sites, f);
}

static void free_surface(struct solid *s, struct solid_surface *f) {
    solid_surface_free(f);
    solid_free(s);
}

/* Its point of the surface, spacings. */
static void point(const struct solid *s, const struct solid_surface *f, int i, double x[3]) {
    solid_position(s, f->h[i], x);
    for (int c = 0; c < 3; c++) x[c] = (x[c] + f->depth[i] * f->normal[c][i]) / SPACING;
}

static double distance(const double x[3], const double centre[3]) {
    double r2 = 0;
    for (int c = 0; c < 3; c++) r2 += (x[c] - centre[c]) * (x[c] - centre[c]);
    return sqrt(r2);
}

static const double middle[3] = {8.23, 8.61, 8.47}; /* spacings */

static struct solid_body round_body(enum solid_shape shape, double radius) {
    struct solid_body b = {.name = "round", .shape = shape, .radius = radius * SPACING, .axis = 2};
    for (int c = 0; c < 3; c++) b.centre[c] = middle[c] * SPACING;
    return b;
}

static void ball(void **state) {
    (void)state;
    struct solid_surface *f;
    const struct solid_body body = round_body(SOLID_SPHERE, 6.3);
    struct solid *s = make(&body, -1, 0, &f);
    double least = INFINITY, most = 0;
    for (int i = 0; i < f->n; i++) {
        double x[3];
        point(s, f, i, x);
        const double r = distance(x, middle);
        check_close(r, 6.3, 1e-12);
        check_relative(f->curvature[i], 1 / (6.3 * SPACING), 1e-12);
        for (int c = 0; c < 3; c++) check_close(f->normal[c][i], (x[c] - middle[c]) / r, 1e-12);
        least = fmin(least, f->depth[i] / SPACING);
        most = fmax(most, f->depth[i] / SPACING);
    }
    least = par_min(least), most = par_max(most);
    print_message("ball: %ld particles %.3f to %.3f spacings deep\n", f->total, least, most);
    check_at_least(least, 0);
    check_below(least, 0.1);
    check_above(most, 0.9);
    check_at_most(most, 1);

    /* after a rotation and translation of the whole, the points are on the moved sphere */
    bodies_turn(s, 0.4, 2 * SPACING);
    solid_surface_update(s, f);
    double away = 0, now[3];
    for (int c = 0; c < 3; c++) now[c] = 0;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) now[c] += (s->x0[c][h] + s->d[c][h]) / SPACING;
    double mean[3] = {0, 0, 0};
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) mean[c] += s->x0[c][h] / SPACING;
    par_sum_array(now, 3);
    par_sum_array(mean, 3);
    /* the particles' mean is not the ball's centre: turned with them */
    const double w = sin(0.4) / sqrt(3), t = (1 - cos(0.4)) / 3, d = cos(0.4) + t;
    const double turn[3][3] = {{d, t - w, t + w}, {t + w, d, t - w}, {t - w, t + w, d}};
    for (int i = 0; i < 3; i++) {
        now[i] /= (double)s->n_global;
        for (int c = 0; c < 3; c++) now[i] += turn[i][c] * (middle[c] - mean[c] / (double)s->n_global);
    }
    for (int i = 0; i < f->n; i++) {
        double x[3];
        point(s, f, i, x);
        away = check_worst(away, distance(x, now) - 6.3);
    }
    away = par_max(away);
    print_message("turned by 0.4: %.4f spacings off at most\n", away);
    check_between(away, 0, 0.02);
    free_surface(s, f);
}

static void cylinder(void **state) {
    (void)state;
    struct solid_surface *f, *counted;
    struct solid_body body = round_body(SOLID_CYLINDER, 5.7);
    for (int endless = 0; endless < 2; endless++) {
        body.length = 12 * SPACING;
        body.centre[2] = 6 * SPACING;
        struct solid *s = make(&body, endless ? 2 : -1, 12, &f);
        struct solid *other = make_with(SOLID_DEPTH_COUNTED, &body, endless ? 2 : -1, 12, &counted);
        for (int i = 0; i < f->n; i++) {
            double x[3], position[3] = {0}, axis[3] = {middle[0], middle[1], 0};
            point(s, f, i, x);
            solid_position(s, f->h[i], position);
            for (int c = 0; c < 3; c++) position[c] /= SPACING;
            axis[2] = position[2];
            int on_side = 0, at_end = !endless && (position[2] < 1 || position[2] > 11);
            for (int k = 0; k < 4; k++) {
                double beyond[3] = {position[0], position[1], position[2]};
                beyond[k / 2] += k % 2 ? 1 : -1;
                on_side |= distance(beyond, axis) >= 5.7;
            }
            axis[2] = x[2];
            if (!at_end) {
                check_close(distance(x, axis), 5.7, 1e-12);
                check_relative(f->curvature[i], 1 / (2 * 5.7 * SPACING), 1e-12);
                check_equal(f->normal[2][i], 0);
            }
            if (at_end && !on_side) {
                check_close(fabs(f->normal[2][i]), 1, 1e-12);
                check_close(f->depth[i] / SPACING, 0.5, 1e-9);
                check_equal(f->curvature[i], 0);
            }
            if (at_end && on_side) {
                check_equal(f->curvature[i], 0);
                check_equal(f->depth[i], counted->depth[i]);
                check_below(f->depth[i], 0.4 * SPACING);
                check_close(f->normal[2][i], 0, 0.99);
            }
        }
        free_surface(other, counted);
        free_surface(s, f);
    }
}

/* Faces anywhere between the sites; edges as on the lattice. */
static void box(void **state) {
    (void)state;
    struct solid_surface *f, *counted;
    const struct solid_body body = {.name = "box",
                                    .shape = SOLID_BOX,
                                    .low = {0.3 * SPACING, 0, 0},
                                    .high = {8.8 * SPACING, 8 * SPACING, 8 * SPACING}};
    struct solid *s = make(&body, 1, 8, &f), *other = make_with(SOLID_DEPTH_COUNTED, &body, 1, 8, &counted);
    int low = 0, high = 0, edges = 0;
    for (int i = 0; i < f->n; i++) {
        int p[3];
        bodies_site(s, f->h[i], p);
        if (p[2] == 0 || p[2] == 7) {
            if (p[0] != 0 && p[0] != 8) continue;
            check_equal(f->depth[i], counted->depth[i]);
            check_between(f->depth[i], 0.07 * SPACING, 0.08 * SPACING); /* physics/depth.h */
            edges++;
            continue;
        }
        check_close(f->normal[0][i], p[0] == 0 ? -1 : 1, 1e-12);
        check_close(f->depth[i] / SPACING, p[0] == 0 ? 0.2 : 0.3, 1e-9);
        low += p[0] == 0, high += p[0] == 8;
    }
    assert_int_equal(par_sum_long(low), 48);
    assert_int_equal(par_sum_long(high), 48);
    assert_int_equal(par_sum_long(edges), 32);
    free_surface(other, counted);
    free_surface(s, f);
}

/* A cavity's points are on its surface; where a crack has opened, the faces are the lattice's. */
static void cavity_and_crack(void **state) {
    (void)state;
    struct solid_surface *f;
    struct solid_body body = bodies_box(0, 0, 0, 16, 16, 16);
    body.cavity_period = 16 * SPACING;
    body.cavity_radius = 4.4 * SPACING;
    for (int c = 0; c < 3; c++) body.cavity_centre[c] = middle[c] * SPACING;
    struct solid *s = make(&body, -1, 0, &f);
    long inner = 0;
    for (int i = 0; i < f->n; i++) {
        double x[3], position[3] = {0};
        solid_position(s, f->h[i], position);
        for (int c = 0; c < 3; c++) position[c] /= SPACING;
        if (distance(position, middle) > 6) continue;
        point(s, f, i, x);
        check_close(distance(x, middle), 4.4, 1e-12);
        check_relative(f->curvature[i], -1 / (4.4 * SPACING), 1e-12);
        check_above(f->depth[i], 0);
        inner++;
    }
    check_above(par_sum_long(inner), 100);
    bodies_cut(s, 0, 2);
    bodies_open(s, 0, 2, 4 * SPACING);
    solid_surface_update(s, f);
    long fresh = 0;
    for (int i = 0; i < f->n; i++) {
        int p[3];
        bodies_site(s, f->h[i], p);
        if ((p[0] != 1 && p[0] != 2) || p[1] < 1 || p[1] > 14 || p[2] < 1 || p[2] > 14) continue;
        check_equal(f->depth[i], 0.5 * SPACING);
        fresh++;
    }
    assert_int_equal(par_sum_long(fresh), 2 * 14 * 14);
    free_surface(s, f);
}

static double depth_of(const struct solid_body *b, const double x[3], double normal[3]) {
    struct solid_piece piece[SOLID_PIECES_MAX];
    assert_int_equal(solid_shape_of(b)->pieces(b, piece), 1);
    return piece[0].depth(&piece[0], x, normal);
}

/* Half the divergence of the normal, by differences, where the depth is 0. */
static void ellipsoid_curvature(void **state) {
    (void)state;
    const struct solid_body egg = {.shape = SOLID_ELLIPSOID, .centre = {0.3, -0.2, 0.1}, .radii = {3, 2, 1.2}};
    struct solid_piece piece[SOLID_PIECES_MAX];
    solid_shape_of(&egg)->pieces(&egg, piece);
    srand(8);
    for (int trial = 0; trial < 50; trial++) {
        double x[3], n[3], divergence = 0;
        for (int c = 0; c < 3; c++) x[c] = egg.centre[c] + egg.radii[c] * (2. * rand() / RAND_MAX - 1);
        const double depth = piece->depth(piece, x, n), step = 1e-4;
        for (int c = 0; c < 3; c++) x[c] += depth * n[c];
        for (int c = 0; c < 3; c++) {
            double ahead[3] = {x[0], x[1], x[2]}, behind[3] = {x[0], x[1], x[2]}, to[3], from[3];
            ahead[c] += step, behind[c] -= step;
            piece->depth(piece, ahead, to);
            piece->depth(piece, behind, from);
            divergence += (to[c] - from[c]) / (2 * step);
        }
        check_relative(piece->curvature(piece, n), divergence / 2, 1e-5);
    }
}

/* The ellipsoid of a body with points all over it: the least distance of x from any of them. */
static double sampled(const struct solid_body *b, const double x[3]) {
    enum { N = 500 };
    double least = INFINITY;
    for (int j = 0; j <= N; j++)
        for (int i = 0; i < 2 * N; i++) {
            const double a = M_PI * j / N, o = M_PI * i / N;
            const double p[3] = {b->centre[0] + b->radii[0] * sin(a) * cos(o),
                                 b->centre[1] + b->radii[1] * sin(a) * sin(o), b->centre[2] + b->radii[2] * cos(a)};
            least = fmin(least, distance(x, p));
        }
    return least;
}

/* Depth and normal: of equal radii a sphere's; else the distance from a dense sampling; the point that they lead to is
 * on the surface, with that normal; on the planes and axes of symmetry too, and at the centre. */
static void ellipsoid_depth(void **state) {
    (void)state;
    struct solid_body egg = {.shape = SOLID_ELLIPSOID, .centre = {0.3, -0.2, 0.1}, .radii = {2, 2, 2}},
                      ball = {.shape = SOLID_SPHERE, .centre = {0.3, -0.2, 0.1}, .radius = 2};
    static const double radii[][3] = {{2, 2, 2}, {3, 2, 1}, {1, 1, 2.5}, {1.5, 0.1, 1.5}, {1, 40, 3}};
    srand(5);
    for (size_t k = 0; k < sizeof radii / sizeof *radii; k++)
        for (int trial = 0; trial < 400; trial++) {
            double x[3], normal[3], expected[3], at[3], sum = 0, steep = 0, align = 0;
            memcpy(egg.radii, radii[k], sizeof egg.radii);
            const double size = fmin(radii[k][0], fmin(radii[k][1], radii[k][2]));
            for (int c = 0; c < 3; c++) {
                const double part = trial & 1 << c && trial & 8 ? 0 : 2. * rand() / RAND_MAX - 1;
                x[c] = egg.centre[c] + 1.3 * radii[k][c] * part * (trial % 5 ? 1 : 1e-9);
            }
            const struct solid_shape_surface surface = solid_shape_surface(&egg);
            const double depth = depth_of(&egg, x, normal);
            for (int c = 0; c < 3; c++) at[c] = x[c] + depth * normal[c];
            for (int c = 0; c < 3; c++) {
                const double q = (at[c] - egg.centre[c]) / radii[k][c];
                sum += q * q;
                steep += q * q / (radii[k][c] * radii[k][c]);
                align += q / radii[k][c] * normal[c];
            }
            assert_true(fabs(sum - 1) < 1e-11);
            assert_true(fabs(align / sqrt(steep) - 1) < 1e-11); /* normal out of the surface there */
            assert_true((depth > 0) == (shape_depth(&surface, x, 0) > 0) || fabs(depth) < 1e-12);
            if (k == 0) {
                assert_true(fabs(depth - depth_of(&ball, x, expected)) < 1e-14);
                for (int c = 0; c < 3 && depth < 1.999; c++) assert_true(fabs(normal[c] - expected[c]) < 1e-14);
            } else if (trial < 12) {
                const double least = sampled(&egg, x); /* a sample is within some 1e-2 radii of the nearest point */
                assert_true(fabs(depth) <= least + 1e-12);
                assert_true(least - fabs(depth) < 0.02 * size + 1e-3 * radii[k][k == 4]);
            }
        }
}

/* Its particles fill 4/3 pi a b c, and their points of the surface are on it. */
static void ellipsoid(void **state) {
    (void)state;
    struct solid_surface *f;
    struct solid_body body = round_body(SOLID_ELLIPSOID, 0);
    double error[2];
    for (int k = 0; k < 2; k++) {
        const double radii[3] = {6.3, 4.2, 5.1};
        for (int c = 0; c < 3; c++) {
            body.radii[c] = (k + 1) * radii[c] * SPACING;
            body.centre[c] = (k + 1) * middle[c] * SPACING;
        }
        struct solid *s = make(&body, -1, 0, &f);
        const double volume = 4 / 3. * M_PI * body.radii[0] * body.radii[1] * body.radii[2];
        error[k] = fabs((double)s->n_global * SPACING * SPACING * SPACING / volume - 1);
        for (int i = 0; i < f->n; i++) {
            double x[3], sum = 0;
            point(s, f, i, x);
            for (int c = 0; c < 3; c++) {
                const double q = (x[c] * SPACING - body.centre[c]) / body.radii[c];
                sum += q * q;
            }
            assert_true(fabs(sum - 1) < 1e-12);
            assert_true(f->depth[i] >= 0 && f->depth[i] <= SPACING);
        }
        free_surface(s, f);
    }
    print_message("ellipsoid: volume within %.4f, of twice the size %.4f\n", error[0], error[1]);
    assert_true(error[0] < 0.02 && error[1] < 0.005);
}

/* A rotation about the direction [1, 2, 3] by 0.7, with the centre fixed. */
static struct solid_turn oblique(const double centre[3]) {
    const double l = sqrt(14), a[3] = {1 / l, 2 / l, 3 / l}, s = sin(0.7), c = cos(0.7);
    struct solid_turn turn = {.is_turned = 1};
    for (int k = 0; k < 3; k++) {
        turn.about[k] = centre[k];
        for (int d = 0; d < 3; d++) turn.edge[k][d] = (1 - c) * a[k] * a[d] + (k == d ? c : 0);
        turn.edge[k][(k + 1) % 3] += s * a[(k + 2) % 3];
        turn.edge[k][(k + 2) % 3] -= s * a[(k + 1) % 3];
    }
    return turn;
}

/* Turned bodies hold the volume of the shape; each particle that one piece bounds knows its own face, with the face's
 * normal and the point on it. */
static void turned(void **state) {
    (void)state;
    static const double half[3] = {7.3, 5.4, 6.1}; /* spacings */
    const double centre[3] = {middle[0] * SPACING, middle[1] * SPACING, middle[2] * SPACING};
    for (int kind = 0; kind < 3; kind++) {
        struct solid_body body = round_body(kind == 0   ? SOLID_BOX
                                            : kind == 1 ? SOLID_CYLINDER
                                                        : SOLID_ELLIPSOID,
                                            half[1]);
        struct solid_surface *f;
        body.length = 2 * half[2] * SPACING;
        for (int c = 0; c < 3; c++) {
            body.low[c] = centre[c] - half[c] * SPACING;
            body.high[c] = centre[c] + half[c] * SPACING;
            body.radii[c] = half[c] * SPACING;
        }
        body.turn = oblique(centre);
        struct solid *s = make(&body, -1, 0, &f);
        const double volume = kind == 0   ? 8 * half[0] * half[1] * half[2]
                              : kind == 1 ? 2 * M_PI * half[1] * half[1] * half[2]
                                          : 4 / 3. * M_PI * half[0] * half[1] * half[2];
        check_relative(s->n_global, volume, 0.02);
        long on = 0;
        for (int i = 0; i < f->n; i++) {
            double x[3], own[3], n[3], level = 0;
            const double normal[3] = {f->normal[0][i], f->normal[1][i], f->normal[2][i]};
            point(s, f, i, x);
            for (int k = 0; k < 3; k++) {
                own[k] = n[k] = 0;
                for (int c = 0; c < 3; c++) {
                    own[k] += (x[c] - middle[c]) * body.turn.edge[k][c];
                    n[k] += normal[c] * body.turn.edge[k][c];
                }
                level += own[k] * own[k] / (half[k] * half[k]);
            }
            if (kind == 2) { /* every one */
                check_close(level, 1, 1e-11);
                on++;
                continue;
            }
            for (int k = 0; k < 3; k++) {
                const int is_round = kind == 1 && k < 2,
                          is_mine = is_round ? fabs(n[2]) < 1e-9 : fabs(n[k]) > 1 - 1e-12;
                if (!is_mine) continue;
                check_close(is_round ? hypot(own[0], own[1]) : fabs(own[k]), is_round ? half[1] : half[k], 1e-11);
                if (!is_round) check_above(n[k] * own[k], 0);
                on++;
                break;
            }
        }
        on = par_sum_long(on);
        print_message("turned shape %d: %ld of %ld interface particles on a face\n", kind, on, f->total);
        check_above((double)on / (double)f->total, kind == 2 ? 0.999 : 0.5);
        free_surface(s, f);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(ball),
                                       cmocka_unit_test(cylinder),
                                       cmocka_unit_test(box),
                                       cmocka_unit_test(cavity_and_crack),
                                       cmocka_unit_test(ellipsoid_depth),
                                       cmocka_unit_test(ellipsoid_curvature),
                                       cmocka_unit_test(ellipsoid),
                                       cmocka_unit_test(turned)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
