/* How far bodies are apart, what bodies hold within each other's reach, and which speed contact can stop. */
#include "solid/contact/passing.h"
#include "solid/bonds/ghosts.h"
#include "solid/law/material.h"
#include "solid/solid.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

#include <math.h>

static struct solid *boxes(double gap, double radius) {
    const struct solid_body body[2] = {bodies_box(0, 0, 0, 4, 4, 4), bodies_box(4 + gap, 0, 0, 5, 4, 4)};
    struct solid_input in = bodies_input(2, body);
    in.contact = 1;
    in.contact_radius = radius;
    return solid_new(&in);
}

/* Faces of `gap` spacings between them have particles of gap + 1 spacings. */
static void gaps(void **state) {
    (void)state;
    for (int gap = 0; gap < 9; gap += 4) {
        struct solid *s = boxes(gap, 1);
        check_close(solid_contact_passing_gap(s), fmax(0, gap + 1 - 1.35) * SPACING, 1e-9 * SPACING);
        for (int h = 0; h < s->n; h++) s->d[0][h] = s->body[h] == 0 ? -2 * SPACING : 0;
        check_close(solid_contact_passing_gap(s), (gap + 3 - 1.35) * SPACING, 1e-9 * SPACING);
        solid_free(s);
    }
}

/* Faces of 4 x 4 particles: 16 pairs a spacing apart, and 48 at the root of two. */
static void meets(void **state) {
    (void)state;
    struct solid *s = boxes(0, 1.5);
    const int broke = s->broke;
    const double rc = 1.5 * SPACING, volume = SPACING * SPACING * SPACING, far = sqrt(2) * SPACING;
    const double near_potential = rc * log(rc / SPACING) - (rc - SPACING),
                 far_potential = rc * log(rc / far) - (rc - far);
    const struct solid_contact_overlap m = solid_contact_passing_overlap(s);
    check_equal(m.pairs, 64);
    check_relative(m.least, SPACING, 1e-12);
    check_relative(m.potential,
                   s->in.contact_stiffness * solid_material_micromodulus(&bodies_material, SPACING) * volume * volume *
                       (16 * near_potential + 48 * far_potential),
                   1e-12);
    assert_null(s->contact);
    check_equal(s->broke, broke);
    solid_free(s);
    s = boxes(0, 1);
    check_equal(solid_contact_passing_overlap(s).pairs, 0);
    solid_free(s);
}

/* At this speed the kinetic energy of two free particles is contact's potential at half of r_c; it grows with the root
 * of the stiffness. */
static void holds(void **state) {
    (void)state;
    struct solid *s = boxes(4, 1);
    const double v = solid_contact_passing_held_speed(s), volume = SPACING * SPACING * SPACING;
    const double potential = s->in.contact_stiffness * solid_material_micromodulus(&bodies_material, SPACING) * volume *
                             volume * SPACING * (log(2) - 0.5);
    check_relative(0.25 * bodies_material.density * volume * v * v, potential, 1e-12);
    s->in.contact_stiffness *= 4;
    check_relative(solid_contact_passing_held_speed(s), 2 * v, 1e-12);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(gaps), cmocka_unit_test(meets), cmocka_unit_test(holds)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
