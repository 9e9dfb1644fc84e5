/* Markers carried by their families: exact in rigid motion, force and couple given back in full, found again after a
 * break. */
#include "base/par_ghost.h"
#include "solid/solid.h"
#include "solid/surface/attach.h"
#include "tests/check.h"
#include "tests/solid/test_surface_bodies.h"

static const double SHIFT = 0.22 * SPACING;

struct body {
    struct solid *s;
    struct solid_surface *f;
    struct solid_attachment *a;
    double *shift, (*normal)[3]; /* normal: of the undeformed body */
};

static struct body body_new(const struct solid_body *shape, int general) {
    struct solid_input in = bodies_input(1, shape);
    in.general_bonds = general;
    struct body b = {.s = solid_new(&in)};
    b.f = solid_surface_new(b.s);
    b.a = solid_attach_new(b.s);
    b.shift = calloc((size_t)b.s->n + 1, sizeof *b.shift);
    b.normal = calloc((size_t)b.s->n + 1, sizeof *b.normal);
    for (int i = 0; i < b.f->n; i++) {
        b.shift[i] = SHIFT * (1 - 0.01 * (b.f->h[i] % 7));
        for (int c = 0; c < 3; c++) b.normal[i][c] = b.f->normal[c][i];
    }
    solid_attach_update(b.a, b.s, b.f, b.shift);
    return b;
}

static void body_free(struct body *b) {
    solid_attach_free(b->a);
    solid_surface_free(b->f);
    solid_free(b->s);
    free(b->shift);
    free(b->normal);
}

static struct solid_body ball(void) {
    return (struct solid_body){.name = "ball", .shape = SOLID_SPHERE, .centre = {0, 0, 0}, .radius = 4.2 * SPACING};
}

/* x <- R x, by 0.7 about z, then 0.4 about x. */
static void rotate(double x[3]) {
    const double a = 0.7, b = 0.4, y[3] = {cos(a) * x[0] - sin(a) * x[1], sin(a) * x[0] + cos(a) * x[1], x[2]};
    x[0] = y[0];
    x[1] = cos(b) * y[1] - sin(b) * y[2];
    x[2] = sin(b) * y[1] + cos(b) * y[2];
}

static void cross(const double a[3], const double b[3], double c[3]) {
    for (int d = 0; d < 3; d++) c[d] = a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
}

/* Turns the solid, and sets the velocities of a rigid motion. */
static void move(struct solid *s, const double omega[3], const double v[3]) {
    for (int h = 0; h < s->n; h++) {
        double x[3] = {s->x0[0][h], s->x0[1][h], s->x0[2][h]}, turning[3];
        rotate(x);
        cross(omega, x, turning);
        for (int c = 0; c < 3; c++) {
            s->d[c][h] = x[c] - s->x0[c][h];
            s->v[c][h] = v[c] + turning[c];
        }
    }
    par_ghost_update(s->ghost, 3, s->d, s->n);
    solid_attachment_refresh(s);
}

static void marker_moves_with_a_rigid_body(void **state) {
    (void)state;
    const double omega[3] = {2, -3, 5}, v[3] = {0.3, 0.1, -0.2};
    for (int general = 0; general < 2; general++) {
        const struct solid_body shape = ball();
        struct body b = body_new(&shape, general);
        move(b.s, omega, v);
        for (int i = 0; i < b.f->n; i++) {
            double arm[3], velocity[3], turned[3], x[3], turning[3];
            solid_attachment_arm(b.a, b.s, i, arm);
            solid_attachment_velocity(b.a, b.s, i, velocity);
            solid_position(b.s, b.f->h[i], x);
            for (int c = 0; c < 3; c++) turned[c] = b.shift[i] * b.normal[i][c];
            rotate(turned);
            for (int c = 0; c < 3; c++) {
                check_close(arm[c], turned[c], 1e-12 * SPACING);
                x[c] += arm[c];
            }
            cross(omega, x, turning);
            for (int c = 0; c < 3; c++) check_close(velocity[c], v[c] + turning[c], 1e-12);
        }
        body_free(&b);
    }
}

/* Sums over the solid of force, couple and power, against those of the markers. */
static void force_couple_and_power_are_the_same(void **state) {
    (void)state;
    const double omega[3] = {2, -3, 5}, v[3] = {0.3, 0.1, -0.2};
    const struct solid_body shape = ball();
    struct body b = body_new(&shape, 0);
    double(*force)[3] = calloc((size_t)b.s->n + 1, sizeof *force), ours[7] = {0}, theirs[7] = {0}, size = 0;
    move(b.s, omega, v);
    for (int h = 0; h < b.s->n; h++) b.s->v[0][h] += 0.1 * sin(1e4 * b.s->x0[1][h]); /* and no rigid motion */
    solid_attachment_refresh(b.s);
    for (int i = 0; i < b.f->n; i++) {
        double arm[3], velocity[3], x[3], couple[3];
        solid_attachment_arm(b.a, b.s, i, arm);
        solid_attachment_velocity(b.a, b.s, i, velocity);
        solid_position(b.s, b.f->h[i], x);
        for (int c = 0; c < 3; c++) {
            x[c] += arm[c];
            force[i][c] = sin(1 + 3e3 * x[(c + 1) % 3]);
        }
        cross(x, force[i], couple);
        for (int c = 0; c < 3; c++) {
            theirs[c] += force[i][c];
            theirs[3 + c] += couple[c];
            theirs[6] += force[i][c] * velocity[c];
        }
        size += 1;
    }
    solid_attachment_spread(b.a, b.s, (const double(*)[3])force);
    for (int h = 0; h < b.s->n; h++) {
        const double given[3] = {b.a->given[0][h], b.a->given[1][h], b.a->given[2][h]};
        double x[3], couple[3];
        solid_position(b.s, h, x);
        cross(x, given, couple);
        for (int c = 0; c < 3; c++) {
            ours[c] += given[c];
            ours[3 + c] += couple[c];
            ours[6] += given[c] * b.s->v[c][h];
        }
    }
    par_sum_array(ours, 7);
    par_sum_array(theirs, 7);
    size = par_sum(size);
    for (int c = 0; c < 3; c++) check_close(ours[c], theirs[c], 1e-13 * size);
    for (int c = 3; c < 6; c++) check_close(ours[c], theirs[c], 1e-13 * size * 5 * SPACING);
    check_close(ours[6], theirs[6], 1e-13 * size);
    free(force);
    body_free(&b);
}

/* D is at least the largest eigenvalue of N M^-1 N^T, row by row: x.(D - N M^-1 N^T) x >= 0. */
static void inverse_mass_bounds_the_markers(void **state) {
    (void)state;
    const struct solid_body shape = ball();
    struct body b = body_new(&shape, 0);
    double(*x)[3] = calloc((size_t)b.s->n + 1, sizeof *x);
    for (int turn = 0; turn < 6; turn++) {
        double bound = 0, square = 0;
        for (int i = 0; i < b.f->n; i++)
            for (int c = 0; c < 3; c++) {
                x[i][c] = turn == 0 ? 1 : sin(37.0 * turn * (double)bodies_id(b.s, b.f->h[i]) + c);
                bound += b.a->inverse_mass[i] * x[i][c] * x[i][c];
            }
        solid_attachment_spread(b.a, b.s, (const double(*)[3])x);
        for (int h = 0; h < b.s->n; h++)
            for (int c = 0; c < 3; c++) square += b.a->given[c][h] * b.a->given[c][h] / (DENSITY * b.s->volume[h]);
        check_at_most(par_sum(square), par_sum(bound) * (1 + 1e-13));
    }
    free(x);
    body_free(&b);
}

/* After a cut the new weights are those that are found from the start. */
static void weights_follow_from_the_present_bonds(void **state) {
    (void)state;
    const struct solid_body shape = bodies_box(0, 0, 0, 10, 7, 7);
    struct body b = body_new(&shape, 0);
    bodies_cut(b.s, 0, 5);
    bodies_open(b.s, 0, 5, 1.1 * DELTA - SPACING);
    solid_surface_update(b.s, b.f);
    for (int i = 0; i < b.f->n; i++) b.shift[i] = SHIFT;
    solid_attach_update(b.a, b.s, b.f, b.shift);
    struct solid_attachment *again = solid_attach_new(b.s);
    solid_attach_update(again, b.s, b.f, b.shift);
    long inner = 0;
    for (int i = 0; i < b.f->n; i++) {
        const struct solid_attachment_weights *w = b.a->weights[i], *v = again->weights[i];
        int p[3];
        double arm[3];
        assert_int_equal(w->n, v->n);
        check_equal(w->own, v->own);
        check_equal(b.a->inverse_mass[i], again->inverse_mass[i]);
        for (int k = 0; k < w->n; k++) {
            assert_int_equal(w->other[k], v->other[k]);
            check_equal(w->share[k], v->share[k]);
        }
        bodies_site(b.s, b.f->h[i], p);
        if ((p[0] != 4 && p[0] != 5) || p[1] != 3 || p[2] != 3) continue;
        inner++;
        solid_attachment_arm(b.a, b.s, i, arm); /* into the open crack */
        check_close(arm[0], p[0] == 4 ? SHIFT : -SHIFT, 1e-12 * SPACING);
    }
    check_equal(par_sum((double)inner), 2);
    solid_attach_free(again);
    body_free(&b);
}

/* A row of particles: nothing beside them can turn a marker, which stays on the row. */
static void row_has_its_markers_on_its_line(void **state) {
    (void)state;
    const struct solid_body shape = bodies_box(0, 0, 0, 8, 1, 1);
    struct body b = body_new(&shape, 0);
    for (int i = 0; i < b.f->n; i++) {
        double arm[3];
        solid_attachment_arm(b.a, b.s, i, arm);
        for (int c = 1; c < 3; c++) check_close(arm[c], 0, 1e-12 * SPACING);
    }
    body_free(&b);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(marker_moves_with_a_rigid_body), cmocka_unit_test(force_couple_and_power_are_the_same),
        cmocka_unit_test(inverse_mass_bounds_the_markers), cmocka_unit_test(weights_follow_from_the_present_bonds),
        cmocka_unit_test(row_has_its_markers_on_its_line)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
