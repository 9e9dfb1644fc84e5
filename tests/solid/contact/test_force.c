/* Repulsion of two particles by hand: the force and its potential for two exponents, and across a periodic side. */
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"
#include "solid/contact/list.h"
#include "solid/law/material.h"
#include "solid/solid.h"
#include "solid/surface/surface.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

/* Two bodies of one particle, of materials with different stiffness and density, a gap of 4 between their sites. */
static struct solid *two_particles(double exponent, int periodic) {
    struct solid_body body[2] = {bodies_box(0, 0, 0, 1, 1, 1), bodies_box(5, 0, 0, 1, 1, 1)};
    const struct solid_material material[2] = {bodies_material,
                                               {3 * YOUNG, 2 * DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0}};
    body[1].material = 1;
    struct solid_input in = bodies_input(2, body);
    in.materials = 2;
    in.material = material;
    in.contact = 1;
    in.contact_exponent = exponent;
    in.contact_radius = 1.2;
    in.periodic[0] = periodic;
    in.length[0] = 10 * SPACING;
    return solid_new(&in);
}

/* Moves the second particle to r e from the first one, or from its image a period away. */
static void place(struct solid *s, double r, const double e[3], double away) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) s->d[c][h] = s->body[h] == 0 ? 0 : r * e[c] + (c == 0 ? away - 5 * SPACING : 0);
    solid_ghosts_update(s);
}

static const double e[3] = {0.48, -0.64, 0.6}, rc = 1.2 * SPACING, volume = SPACING * SPACING * SPACING;

/* k_c of the pair: 15 times the mean of the materials' c0, 2 c0 of the softer one. */
static double k_of_pair(void) { return 15 * 2 * solid_material_micromodulus(&bodies_material, SPACING); }

static void pushes_apart(void **state) {
    (void)state;
    const double exponent[3] = {1, 2, 4.5}, distance[4] = {0.05, 0.5, 0.9, 0.999};
    for (int k = 0; k < 12; k++) {
        struct solid *s = two_particles(exponent[k % 3], k >= 6);
        struct solid_surface *surface = solid_surface_new(s);
        const double r = distance[k / 3] * rc, away = k >= 6 ? 10 * SPACING : 0;
        place(s, r, e, away);
        solid_contact_update(s);
        assert_non_null(s->contact);
        solid_contact_force(s);
        const double force = k_of_pair() * (pow(rc / r, exponent[k % 3]) - 1) * volume;
        for (int h = 0; h < s->n; h++) {
            const double on = s->body[h] == 0 ? -force / DENSITY : force / (2 * DENSITY);
            for (int c = 0; c < 3; c++) check_close(s->a[c][h], on * e[c], 1e-9 * force / DENSITY);
        }
        solid_surface_free(surface);
        solid_contact_free(s);
        solid_free(s);
    }
}

/* Closed forms: k V^2 (r_c log(r_c/r) - (r_c - r)) for the exponent 1, k V^2 (r_c - r)^2/r for 2; none beyond r_c. */
static void potential(void **state) {
    (void)state;
    for (int k = 0; k < 4; k++) {
        struct solid *s = two_particles(k % 2 ? 2 : 1, 0);
        struct solid_surface *surface = solid_surface_new(s);
        const double r = (k < 2 ? 0.4 : 1.01) * rc;
        check_equal(solid_contact_force_energy(s), 0);
        place(s, r, e, 0);
        solid_contact_update(s);
        const double closed = k % 2 ? (rc - r) * (rc - r) / r : rc * log(rc / r) - (rc - r);
        const double expected = k < 2 ? k_of_pair() * volume * volume * closed : 0;
        check_close(solid_contact_force_energy(s), expected, 1e-10 * expected);
        if (k >= 2) {
            solid_contact_force(s);
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < 3; c++) check_equal(s->a[c][h], 0);
        }
        solid_surface_free(surface);
        solid_contact_free(s);
        solid_free(s);
    }
}

/* A force is added to what is in a, once; two calls add it twice. */
static void added(void **state) {
    (void)state;
    struct solid *s = two_particles(1, 0);
    struct solid_surface *surface = solid_surface_new(s);
    double once[2];
    place(s, 0.5 * rc, e, 0);
    solid_contact_update(s);
    solid_contact_force(s);
    for (int h = 0; h < s->n; h++) once[h] = s->a[0][h];
    solid_contact_force(s);
    for (int h = 0; h < s->n; h++) check_equal(s->a[0][h], 2 * once[h]);
    solid_surface_free(surface);
    solid_contact_free(s);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(pushes_apart), cmocka_unit_test(potential),
                                       cmocka_unit_test(added)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
