/* Cones about a particle: which sites they contain, both ways to look, and when a cone is void. */
#include "solid/bonds/ghosts.h"
#include "solid/bonds/lattice.h"
#include "solid/solid.h"
#include "solid/surface/sector.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

static struct solid *block(int n, int general) {
    const struct solid_body body = bodies_box(0, 0, 0, n, n, n);
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

/* Directions at random: the cone of the largest component, if it is longer than cos 45 degrees of the whole. */
static void cones(void **state) {
    (void)state;
    const double tiny = 1e-6;
    int none = 0;
    for (int f = 0; f < SOLID_FACES; f++) {
        double e[3], xi[3];
        solid_sector_axis(f, e);
        check_equal(e[f / 2], f % 2 ? -1 : 1);
        check_equal(fabs(e[0]) + fabs(e[1]) + fabs(e[2]), 1);
        for (int c = 0; c < 3; c++) xi[c] = (1.5 - tiny) * e[c];
        check_equal(solid_sector_of(xi, 1), f);
        for (int c = 0; c < 3; c++) xi[c] = (1.5 + tiny) * e[c];
        check_equal(solid_sector_of(xi, 1), -1);
        for (int c = 0; c < 3; c++) xi[c] = e[c];
        xi[(f / 2 + 1) % 3] = 1 - tiny; /* just within 45 degrees; on the rim */
        check_equal(solid_sector_of(xi, 1), f);
        xi[(f / 2 + 1) % 3] = 1;
        check_equal(solid_sector_of(xi, 1), -1);
    }
    for (int k = 0; k < 500; k++) {
        double xi[3], r2 = 0;
        int most = 0;
        for (int c = 0; c < 3; c++) {
            xi[c] = 1.6 * (bodies_random(k, c) - 0.5);
            r2 += xi[c] * xi[c];
            if (fabs(xi[c]) > fabs(xi[most])) most = c;
        }
        const int is_in = xi[most] * xi[most] > 0.5 * r2;
        check_equal(solid_sector_of(xi, 1), is_in ? 2 * most + (xi[most] < 0) : -1);
        none += !is_in;
    }
    check_between(none, 50, 450);
}

/* On a lattice a cone contains one site, the nearest: the look over the view and the look at six sites agree, at faces,
 * edges and corners, with bonds broken at random. */
static void both_ways(void **state) {
    (void)state;
    struct solid *s = block(6, 0);
    static struct solid_family_view view;
    int near[SOLID_FACES], broken = 0;
    solid_sector_near(s->family->lattice[0]->stencil, near);
    for (int f = 0; f < SOLID_FACES; f++) {
        double e[3];
        solid_sector_axis(f, e);
        for (int c = 0; c < 3; c++) check_equal(s->family->lattice[0]->stencil->offset[near[f]].step[c], e[c]);
    }
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++)
            if (h == 100 || bodies_random(h, b) < 0.1) solid_family_break(s, h, b);
    }
    for (int h = 0; h < s->n; h++) {
        struct solid_cones one, other;
        int intact = 0, p[3];
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) intact += view.intact[b];
        solid_sector_classify(s, h, &view, &one);
        solid_sector_classify_lattice(s, h, near, intact, &other);
        assert_memory_equal(&one, &other, sizeof one);
        check_equal(one.isolated, h == 100);
        bodies_site(s, h, p);
        for (int c = 0; c < 3; c++) {
            check_equal(one.bare >> 2 * c & 1, p[c] == 5);
            check_equal(one.bare >> (2 * c + 1) & 1, p[c] == 0);
        }
        broken += one.broken != 0;
    }
    check_above(broken, 20);
    solid_free(s);
}

/* A cone without sites is void; one whose bond is broken is void once the two are more than the horizon apart. */
static void opens_and_closes(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++) {
        struct solid *s = block(5, general);
        static struct solid_family_view view;
        struct solid_cones watch;
        const int h = at_site(s, 2, 2, 0), l = at_site(s, 3, 2, 0);
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++)
            if (view.l[b] == l) solid_family_break(s, h, b);
        solid_family_view(s, h, &view);
        solid_sector_classify(s, h, &view, &watch);
        check_equal(watch.bare, 1 << 5);
        check_equal(watch.broken, 1 << 0);
        check_equal(watch.l[0][0], l);
        const double gap[4] = {0, 1.999, 2.001, 0.5};
        for (int k = 0; k < 4; k++) {
            s->d[0][l] = gap[k] * SPACING;
            check_equal(solid_sector_void(s, &watch), k == 2 ? 1 << 5 | 1 << 0 : 1 << 5);
        }
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(cones), cmocka_unit_test(both_ways),
                                       cmocka_unit_test(opens_and_closes)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
