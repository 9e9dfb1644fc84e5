/* A mirror-symmetric plate stays symmetric to the bit while it is loaded and breaks. */
/* A mirror-symmetric plate stays mirror-symmetric to the bit while it is loaded and breaks, on one rank and at any
 * position in the coordinates. */
#include "tests/solid/make_plate.h"
#include "solid/contact/contact.h"
#include "solid/law/material.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "tests/check.h"

/* Of every particle the one that is its mirror image about the plate's middle line across c, by lattice indices; and by
 * number. */
static int *mirror_of(const struct solid *s, const struct make *m, int axis) {
    int *at = malloc(((size_t)m->sites[0] * (size_t)m->sites[1] + 1) * sizeof *at),
        *mirror = malloc(((size_t)s->n + 1) * sizeof *mirror);
    for (int pass = 0; pass < 2; pass++)
        for (int h = 0; h < s->n; h++) {
            int site[2];
            for (int c = 0; c < 2; c++) site[c] = (int)floor((s->x0[c][h] - m->shift[c]) / SPACING);
            if (pass) site[axis] = m->sites[axis] - 1 - site[axis];
            int *here = &at[site[1] * m->sites[0] + site[0]];
            if (pass)
                mirror[h] = *here;
            else
                *here = h;
        }
    free(at);
    return mirror;
}

static uint64_t bits_of(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* Bonds of h as seen in the mirror: each that is broken has a broken image. */
static void assert_bonds_mirrored(const struct solid *s, int h, int image, int axis) {
    static struct solid_family_view here, there;
    solid_family_view(s, h, &here);
    solid_family_view(s, image, &there);
    assert_int_equal(here.n, there.n);
    for (int b = 0; b < here.n; b++) {
        int found = 0;
        for (int k = 0; k < there.n && !found; k++) {
            const double sign = axis == 0 ? -1 : 1;
            if (there.xi[k][0] != sign * here.xi[b][0] || there.xi[k][1] != -sign * here.xi[b][1]) continue;
            assert_int_equal(there.intact[k], here.intact[b]);
            found = 1;
        }
        assert_true(found);
    }
}

static void assert_mirrored(const struct solid *s, const struct make *m, int axis) {
    int *mirror = mirror_of(s, m, axis);
    for (int h = 0; h < s->n; h++) {
        for (int c = 0; c < 2; c++) {
            const double *const array[2] = {s->d[c], s->v[c]};
            for (int k = 0; k < 2; k++) {
                const double image = c == axis ? -array[k][mirror[h]] : array[k][mirror[h]];
                if (array[k][h] != image)
                    fail_msg("%s %d of particle %d: %.17g and %.17g (%llx, %llx)", k ? "v" : "d", c, h, array[k][h],
                             image, (unsigned long long)bits_of(array[k][h]), (unsigned long long)bits_of(image));
            }
        }
        assert_bonds_mirrored(s, h, mirror[h], axis);
    }
    free(mirror);
}

/* A plate torn apart along y from a crack in the middle of its left side (mirror image about y), or from cracks on both
 * sides (about x). Returns how many bonds broke besides these. */
static long tear(int axis, int sites_y, double shift, int verlet, int damped, int softens) {
    const struct solid_material brittle = {YOUNG, DENSITY, G0, 3, PHYSICS_CONSTANT, 0, 0};
    const double s0 = solid_material_constants(PHYSICS_PLANE_STRESS, THICKNESS, &brittle, 3 * SPACING).s0;
    struct make m = {.sites = {41, sites_y}, .brittle = 1, .contact = 1, .shift = {shift, -0.37 * shift}};
    m.tensile_strength = softens ? 0.6 * YOUNG * s0 : 0;
    const double left = shift, bottom = -0.37 * shift, width = 41 * SPACING, height = sites_y * SPACING;
    const double y = bottom + sites_y / 2 * SPACING;
    const double line[2][2][3] = {{{left, y, 0}, {left + 12 * SPACING, y, 0}},
                                  {{left + width, y, 0}, {left + width - 12 * SPACING, y, 0}}};
    const struct solid_cut cut[2] = {{2, line[0]}, {2, line[1]}};
    const double t[2] = {0, 2e-6}, factor[2] = {0, 1};
    const struct solid_time time = {2, t, factor, 0};
    const struct solid_load load[2] = {
        {SOLID_LOAD_EDGE, .edge = {{left, bottom}, {left + width, bottom}}, .traction = {0, -6e7}, .time = time},
        {SOLID_LOAD_EDGE, .edge = {{left, bottom + height}, {left + width, bottom + height}}, .traction = {0, 6e7},
         .over_horizon = 1, .time = time}};
    struct solid_load both[2] = {load[0], load[1]};
    both[0].over_horizon = both[1].over_horizon = axis; /* in turn one layer and the horizon */
    m.correction = verlet ? SOLID_CORRECTION_ENERGY : SOLID_CORRECTION_VOLUME;
    m.cuts = 1 + (axis == 0);
    m.cut = cut;
    m.loads = 2;
    m.load = both;
    struct solid *s = make(m);
    s->stage = (struct solid_stage){
        .integrator = verlet ? SOLID_VERLET : SOLID_RK3, .breakage = 1, .damping_relative = damped ? 1e16 : 0};
    solid_family_count(s);
    const long before = s->bonds_broken;
    for (int i = 0; i < 60; i++) {
        solid_contact_update(s);
        solid_integrate(s, step_of(0.3), 5);
        if (i % 20 == 19) assert_mirrored(s, &m, axis);
    }
    solid_family_count(s);
    const long broken = s->bonds_broken - before;
    solid_free(s);
    return broken;
}

static void test_across_y(void **state) {
    (void)state;
    for (int verlet = 0; verlet < 2; verlet++)
        for (int far = 0; far < 2; far++) check_above(tear(1, 20, far ? 0.1 * M_SQRT2 : 0, verlet, 0, 0), 200);
}

static void test_across_x(void **state) {
    (void)state;
    for (int verlet = 0; verlet < 2; verlet++)
        for (int far = 0; far < 2; far++) check_above(tear(0, 21, far ? -0.1 * M_E : 0, verlet, verlet, 0), 200);
}

static void test_softening(void **state) {
    (void)state;
    for (int axis = 0; axis < 2; axis++) check_above(tear(axis, 21 - axis, 0.1 * M_SQRT2, 1, axis == 0, 1), 200);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_across_y), cmocka_unit_test(test_across_x),
                                       cmocka_unit_test(test_softening)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
