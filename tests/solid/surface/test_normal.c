/* Normals of single particles: by symmetry, turned with the body, of a thin wall, of a particle set free. */
#include "solid/bonds/ghosts.h"
#include "solid/solid.h"
#include "solid/surface/normal.h"
#include "solid/surface/surface.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

static struct solid *block(int x, int y, int z, int general) {
    const struct solid_body body = bodies_box(0, 0, 0, x, y, z);
    struct solid_input in = bodies_input(1, &body);
    in.general_bonds = general;
    return solid_new(&in);
}

static int at_site(const struct solid *s, int x, int y, int z) {
    for (int h = 0; h < s->n; h++) {
        int p[3];
        bodies_site(s, h, p);
        if (p[0] == x && p[1] == y && p[2] == z) return h;
    }
    return -1;
}

static struct solid_normal_data normal_of(const struct solid *s, int h, unsigned open) {
    static struct solid_family_view view;
    struct solid_normal_data out;
    solid_family_view(s, h, &view);
    solid_normal_compute(s, h, &view, open, &out);
    return out;
}

static void check_normal(const struct solid_normal_data *f, double x, double y, double z, double tolerance) {
    const double r = sqrt(x * x + y * y + z * z);
    check_close(f->n[0], x / r, tolerance);
    check_close(f->n[1], y / r, tolerance);
    check_close(f->n[2], z / r, tolerance);
}

/* The middle of a face, of an edge, a corner; the same from the undeformed body. */
static void by_symmetry(void **state) {
    (void)state;
    static struct solid_family_view view;
    const int site[3][3] = {{8, 4, 4}, {0, 4, 8}, {8, 0, 8}};
    const double n[3][3] = {{1, 0, 0}, {-1, 0, 1}, {1, -1, 1}};
    const unsigned open[3] = {1, 2 | 16, 1 | 8 | 16};
    for (int general = 0; general < 2; general++) {
        struct solid *s = block(9, 9, 9, general);
        for (int k = 0; k < 3; k++) {
            const int h = at_site(s, site[k][0], site[k][1], site[k][2]);
            const struct solid_normal_data now = normal_of(s, h, open[k]);
            struct solid_normal_data start;
            check_normal(&now, n[k][0], n[k][1], n[k][2], 1e-13);
            check_equal(now.two_sided, SOLID_ONE_FACE);
            check_equal(now.open, open[k]);
            solid_family_view(s, h, &view);
            solid_normal_compute_initial(s, h, &view, open[k], &start);
            for (int c = 0; c < 3; c++) check_close(start.n[c], now.n[c], 1e-14);
        }
        solid_free(s);
    }
}

static const double turn[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};

/* Turned and moved with the body; the undeformed body's normal stays. */
static void turns_with_the_body(void **state) {
    (void)state;
    static struct solid_family_view view;
    struct solid *s = block(7, 6, 5, 0);
    const int h = at_site(s, 6, 1, 2);
    const struct solid_normal_data before = normal_of(s, h, 1);
    for (int l = 0; l < s->n; l++)
        for (int c = 0; c < 3; c++) {
            double x = 0.02 * c;
            for (int k = 0; k < 3; k++) x += turn[c][k] * s->x0[k][l];
            s->d[c][l] = x - s->x0[c][l];
        }
    const struct solid_normal_data after = normal_of(s, h, 1);
    struct solid_normal_data start;
    for (int c = 0; c < 3; c++) {
        double n = 0;
        for (int k = 0; k < 3; k++) n += turn[c][k] * before.n[k];
        check_close(after.n[c], n, 1e-12);
    }
    solid_family_view(s, h, &view);
    solid_normal_compute_initial(s, h, &view, 1, &start);
    for (int c = 0; c < 3; c++) check_close(start.n[c], before.n[c], 1e-12);
    solid_free(s);
}

/* In a wall one particle thick: the axis across it, two faces. In one of two layers each has its own face. */
static void walls(void **state) {
    (void)state;
    struct solid *one = block(9, 1, 9, 0), *two = block(9, 2, 9, 0);
    const struct solid_normal_data axis = normal_of(one, at_site(one, 4, 0, 4), 4 | 8);
    check_equal(axis.two_sided, SOLID_TWO_FACES);
    check_normal(&axis, 0, axis.n[1] > 0 ? 1 : -1, 0, 1e-12);
    for (int layer = 0; layer < 2; layer++) {
        const struct solid_normal_data side = normal_of(two, at_site(two, 4, layer, 4), layer ? 4 : 8);
        check_equal(side.two_sided, SOLID_ONE_FACE);
        check_normal(&side, 0, layer ? 1 : -1, 0, 1e-12);
    }
    solid_free(two);
    solid_free(one);
}

/* A particle that has lost all its bonds keeps the normal of its family; one from inside the body has none: x. */
static void isolated(void **state) {
    (void)state;
    static struct solid_family_view view;
    struct solid *s = block(7, 7, 7, 0);
    const int h[2] = {at_site(s, 3, 3, 0), at_site(s, 3, 3, 3)};
    for (int k = 0; k < 2; k++) {
        solid_family_view(s, h[k], &view);
        for (int b = 0; b < view.n; b++) solid_family_break(s, h[k], b);
        const struct solid_normal_data out = normal_of(s, h[k], 63);
        check_equal(out.two_sided, SOLID_ISOLATED);
        check_normal(&out, k ? 1 : 0, 0, k ? 0 : -1, 1e-12);
        check_equal(out.l[0], -1);
        check_equal(out.l[1], -1);
        check_equal(solid_normal_has_turned(s, h[k], &out), 0);
    }
    solid_free(s);
}

/* A translation does not count, a turn by 1/1000 neither, one by 2/100 does, about any axis. */
static void when_to_look_again(void **state) {
    (void)state;
    for (int axis = 0; axis < 3; axis++) {
        struct solid *s = block(7, 7, 7, 0);
        const int h = at_site(s, 6, 3, 3), p = (axis + 1) % 3, q = (axis + 2) % 3;
        const struct solid_normal_data out = normal_of(s, h, 1);
        const double angle[4] = {0, 1e-3, 0.02, 0};
        for (int k = 0; k < 4; k++) {
            for (int l = 0; l < s->n; l++) {
                s->d[axis][l] = 3 * SPACING;
                s->d[p][l] = SPACING - angle[k] * s->x0[q][l];
                s->d[q][l] = angle[k] * s->x0[p][l];
            }
            check_equal(solid_normal_has_turned(s, h, &out), k == 2);
        }
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(by_symmetry), cmocka_unit_test(turns_with_the_body),
                                       cmocka_unit_test(walls), cmocka_unit_test(isolated),
                                       cmocka_unit_test(when_to_look_again)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
