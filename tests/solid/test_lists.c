/* Bodies of several shapes as solids: bonds across periodic sides and contacts against brute force, contact between
 * shapes that are not bonded, and the wetted surface of unions and holes. */
#include "solid/contact/contact.h"
#include "solid/measure/fragments.h"
#include "solid/solid.h"
#include "solid/surface/surface.h"
#include "tests/check.h"
#include "tests/solid/test_surface_bodies.h"

enum { PERIOD = 24 }; /* spacings */

/* Three balls in a row through the period, each cutting into the next and the last into the first. */
static double row[3][6];

static struct solid_body row_body(int broken, double by) {
    for (int k = 0; k < 3; k++) {
        const double centre[3] = {fmod(4.2 + 8 * k + by, PERIOD), fmod(12.1 + by, PERIOD), fmod(11.9 + by, PERIOD)};
        for (int c = 0; c < 3; c++) {
            row[k][c] = centre[c] * SPACING;
            row[k][3 + c] = 5.13 * SPACING;
        }
    }
    return (struct solid_body){.name = "row",
                               .shape = SOLID_SPHERES,
                               .entries = 3,
                               .entry = (const double(*)[6])row,
                               .contacts_broken = broken};
}

static struct solid_input periodic_input(const struct solid_body *body) {
    struct solid_input in = bodies_input(1, body);
    in.contact = 1;
    for (int c = 0; c < 3; c++) {
        in.periodic[c] = 1;
        in.length[c] = PERIOD * SPACING;
    }
    return in;
}

static int wrapped(int i) { return (i % PERIOD + PERIOD) % PERIOD; }

/* The ball that a site is deepest in, by hand, -1: none. No site is as deep in two. */
static int ball_of(int i, int j, int k) {
    const double x[3] = {wrapped(i) + 0.5, wrapped(j) + 0.5, wrapped(k) + 0.5};
    double deepest = 0;
    int ball = -1;
    for (int b = 0; b < 3; b++) {
        double r2 = 0;
        for (int c = 0; c < 3; c++) {
            double d = x[c] - row[b][c] / SPACING;
            d -= PERIOD * rint(d / PERIOD);
            r2 += d * d;
        }
        const double depth = row[b][3] / SPACING - sqrt(r2);
        if (depth > deepest) deepest = depth, ball = b;
    }
    return ball;
}

struct counted {
    long particles[3], bonds, within; /* directed bonds; those within one ball */
};

static struct counted count(void) {
    static int ball[PERIOD][PERIOD][PERIOD];
    struct counted n = {0};
    for (int q = 0; q < PERIOD * PERIOD * PERIOD; q++)
        ball[q / PERIOD / PERIOD][q / PERIOD % PERIOD][q % PERIOD] =
            ball_of(q % PERIOD, q / PERIOD % PERIOD, q / PERIOD / PERIOD);
    for (int q = 0; q < PERIOD * PERIOD * PERIOD; q++) {
        const int i = q % PERIOD, j = q / PERIOD % PERIOD, k = q / PERIOD / PERIOD, own = ball[k][j][i];
        if (own < 0) continue;
        n.particles[own]++;
        for (int p = 0; p < 7 * 7 * 7; p++) {
            const int d[3] = {p % 7 - 3, p / 7 % 7 - 3, p / 49 - 3}, r2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
            if (r2 == 0 || r2 >= 3.5 * 3.5) continue;
            const int other = ball[wrapped(k + d[2])][wrapped(j + d[1])][wrapped(i + d[0])];
            n.bonds += other >= 0;
            n.within += other == own;
        }
    }
    return n;
}

/* Bonded: one piece, with all bonds of its sites. Broken: a fragment for each ball, with the bonds within it. */
static void bonds_and_contacts(void **state) {
    (void)state;
    for (int run = 0; run < 4; run++) {
        const int broken = run % 2, general = run / 2;
        const struct solid_body body = row_body(broken, 0);
        struct solid_input in = periodic_input(&body);
        in.general_bonds = general;
        struct solid *s = solid_new(&in);
        const struct counted n = count();
        solid_family_count(s);
        check_equal(s->n_global, n.particles[0] + n.particles[1] + n.particles[2]);
        check_equal(s->bonds_total, n.bonds / 2);
        check_equal(s->bonds_broken, broken ? (n.bonds - n.within) / 2 : 0);
        check_above(n.bonds - n.within, 1000);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) check_between(s->x0[c][h], 0, PERIOD * SPACING);
        struct solid_fragment *list;
        long *id = malloc(((size_t)s->n + 1) * sizeof *id);
        check_equal(solid_fragments_measure(s, id, &list), broken ? 3 : 1);
        for (int f = 0; broken && f < 3; f++) {
            int found = 0;
            for (int b = 0; b < 3; b++) found += list[f].particles == n.particles[b];
            check_above(found, 0);
        }
        free(list);
        free(id);
        solid_free(s);
    }
}

/* The middle ball moved towards the last is pushed back by contact, as hard as the others are pushed. */
static void contact_between_shapes(void **state) {
    (void)state;
    double force[3] = {0}, others = 0;
    for (int moved = 0; moved < 2; moved++) {
        const struct solid_body body = row_body(1, 0);
        const struct solid_input in = periodic_input(&body);
        struct solid *s = solid_new(&in);
        for (int h = 0; h < s->n; h++) {
            int site[3];
            bodies_site(s, h, site);
            s->d[0][h] = moved && ball_of(site[0], site[1], site[2]) == 1 ? 0.3 * SPACING : 0;
            for (int c = 0; c < 3; c++) s->a[c][h] = 0;
        }
        solid_contact_update(s);
        solid_contact_force(s);
        force[0] = force[1] = force[2] = others = 0;
        for (int h = 0; h < s->n; h++) {
            int site[3];
            bodies_site(s, h, site);
            const int middle = ball_of(site[0], site[1], site[2]) == 1;
            for (int c = 0; c < 3 && middle; c++) force[c] += s->a[c][h];
            if (!middle) others += s->a[0][h];
        }
        par_sum_array(force, 3);
        others = par_sum(others);
        if (!moved) check_equal(force[0], 0);
        solid_free(s);
    }
    check_below(force[0], 0);
    check_relative(others, -force[0], 1e-12);
}

/* A body that is moved by whole spacings across the sides has the same surface. */
static void surface_moves_along(void **state) {
    (void)state;
    double area[2][2], depth[2][2], first[2];
    for (int shape = 0; shape < 2; shape++)
        for (int run = 0; run < 2; run++) {
            const struct solid_body body = row_body(0, run ? 13 : 0);
            struct solid_input in = periodic_input(&body);
            in.depth = shape ? SOLID_DEPTH_SHAPE : SOLID_DEPTH_HALF;
            struct solid *s = solid_new(&in);
            struct solid_surface *f = solid_surface_new(s);
            double sum = 0;
            for (int i = 0; i < f->n; i++) sum += f->depth[i] / SPACING;
            area[shape][run] = f->immersed_area / (SPACING * SPACING);
            depth[shape][run] = par_sum(sum);
            first[run] = (double)f->total;
            solid_surface_free(f);
            solid_free(s);
        }
    check_equal(first[0], first[1]);
    for (int shape = 0; shape < 2; shape++) {
        check_relative(area[shape][0], area[shape][1], 1e-12);
        check_relative(depth[shape][0], depth[shape][1], 1e-10);
    }
    check_between(fabs(depth[1][0] - depth[0][0]), 1, 1e4); /* the surface is the spheres' */
}

/* With surfaces of shapes a marker's point is on a sphere and in no other, or on the wall of a hole; along the circles
 * where two spheres meet, and there alone, it is the lattice's. */
static void surface_of_union(void **state) {
    (void)state;
    static const double hole[2][6] = {{12.3e-3, 12.1e-3, 12.2e-3, 3.3e-3, 3.3e-3, 3.3e-3},
                                      {12.3e-3, 12.1e-3, 0.4e-3, 2.7e-3, 2.7e-3, 2.7e-3}};
    const struct solid_body part = {.shape = SOLID_SPHERES, .entries = 2, .entry = hole, .is_hole = 1};
    struct solid_body body = row_body(0, 0);
    for (int with_hole = 0; with_hole < 2; with_hole++) {
        body.parts = with_hole;
        body.part = &part;
        struct solid_input in = periodic_input(&body);
        in.depth = SOLID_DEPTH_SHAPE;
        struct solid *s = solid_new(&in);
        struct solid_surface *f = solid_surface_new(s);
        double shaped = 0, hollow = 0;
        for (int i = 0; i < f->n; i++) {
            double x[3], in_any = -INFINITY, in_hole = -INFINITY;
            solid_position(s, f->h[i], x);
            if (f->curvature[i] == 0) continue;
            for (int c = 0; c < 3; c++) x[c] += f->depth[i] * f->normal[c][i];
            for (int b = 0; b < 3 + 2 * with_hole; b++) {
                const double *sphere = b < 3 ? row[b] : hole[b - 3];
                double r2 = 0;
                for (int c = 0; c < 3; c++) {
                    const double d = x[c] - sphere[c], period = PERIOD * SPACING,
                                 nearest = d - period * rint(d / period);
                    r2 += nearest * nearest;
                }
                if (b < 3)
                    in_any = fmax(in_any, sphere[3] - sqrt(r2));
                else
                    in_hole = fmax(in_hole, sphere[3] - sqrt(r2));
            }
            shaped++;
            check_at_least(f->depth[i], -1e-12 * SPACING);
            check_at_most(f->depth[i], 1.01 * SPACING);
            if (f->curvature[i] > 0) {
                check_relative(f->curvature[i], 1 / (5.13 * SPACING), 1e-12);
                check_close(in_any, 0, 1e-12 * SPACING);
            } else {
                hollow++;
                check_close(in_hole, 0, 1e-12 * SPACING);
            }
        }
        double sum[2] = {shaped, hollow};
        par_sum_array(sum, 2);
        print_message("%ld markers, %g on shapes, %g of them in holes\n", f->total, sum[0], sum[1]);
        check_between(sum[0], 0.85 * (double)f->total, f->total);
        check_between(sum[1], with_hole ? 30 : -1, with_hole ? 1000 : 1);
        solid_surface_free(f);
        solid_free(s);
    }
}

/* The wall of a hole across the corner of a block that fills the period is the ball's, also next to the domain's sides,
 * which are not a surface. */
static void hole_across_sides(void **state) {
    (void)state;
    const double ball[4] = {5.5e-3, 2.1e-3, 23.3e-3, 5.3e-3}; /* some 0.2 spacings from a side */
    const struct solid_body part = {
        .shape = SOLID_SPHERE, .centre = {ball[0], ball[1], ball[2]}, .radius = ball[3], .is_hole = 1};
    struct solid_body body = bodies_box(0, 0, 0, PERIOD, PERIOD, PERIOD);
    body.parts = 1;
    body.part = &part;
    struct solid_input in = periodic_input(&body);
    in.depth = SOLID_DEPTH_SHAPE;
    struct solid *s = solid_new(&in);
    struct solid_surface *f = solid_surface_new(s);
    for (int i = 0; i < f->n; i++) {
        double x[3], r2 = 0;
        solid_position(s, f->h[i], x);
        for (int c = 0; c < 3; c++) {
            const double d = x[c] + f->depth[i] * f->normal[c][i] - ball[c];
            r2 += pow(d - PERIOD * SPACING * rint(d / (PERIOD * SPACING)), 2);
        }
        check_close(sqrt(r2), ball[3], 1e-12 * SPACING);
        check_relative(f->curvature[i], -1 / ball[3], 1e-12);
    }
    check_above(f->total, 300);
    solid_surface_free(f);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(bonds_and_contacts), cmocka_unit_test(contact_between_shapes),
                                       cmocka_unit_test(surface_moves_along), cmocka_unit_test(surface_of_union),
                                       cmocka_unit_test(hole_across_sides)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
