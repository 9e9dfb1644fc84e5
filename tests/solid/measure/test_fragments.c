/* Fragments of a broken body: sizes, masses, centres, velocities. */
#include "solid/measure/fragments.h"
#include "solid/bonds/soft.h"
#include "solid/solid.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

static const double mass = DENSITY * SPACING * SPACING * SPACING;

/* A bar cut in three: sizes, names, masses, centres, velocities, and which is held. */
static void bar_in_three(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 5, 6, 30);
    const struct solid_constraint hold = {.low = {-1, -1, -1}, .high = {1, 1, 2.1e-3}, .direction = {0, 1, 0}};
    for (int general = 0; general < 2; general++) {
        struct solid_input in = bodies_input(1, &body);
        in.general_bonds = general;
        in.constraints = 1;
        in.constraint = &hold;
        struct solid *s = solid_new(&in);
        long *id = malloc(((size_t)s->n + 1) * sizeof *id);
        struct solid_fragment *list = NULL;
        assert_int_equal(solid_fragments_measure(s, id, &list), 1);
        assert_int_equal(list[0].particles, 900);
        assert_int_equal(list[0].id, 0);
        for (int h = 0; h < s->n; h++) assert_int_equal(id[h], 0);
        free(list);

        bodies_cut(s, 2, 7);
        bodies_cut(s, 2, 18);
        const int from[4] = {0, 7, 18, 30}, order[3] = {2, 1, 0}; /* 12, 11, 7 layers */
        for (int h = 0; h < s->n; h++) {
            int p[3];
            bodies_site(s, h, p);
            const int part = p[2] < 7 ? 0 : p[2] < 18 ? 1 : 2;
            s->d[0][h] = 0.01 * part;
            s->v[2][h] = part + 0.5;
        }
        assert_int_equal(solid_fragments_measure(s, id, &list), 3);
        for (int k = 0; k < 3; k++) {
            const int part = order[k], layers = from[part + 1] - from[part];
            const double centre[3] = {2.5 * SPACING + 0.01 * part, 3 * SPACING,
                                      0.5 * (from[part] + from[part + 1]) * SPACING};
            long first = 1000;
            assert_int_equal(list[k].particles, 30 * layers);
            check_relative(list[k].mass, 30 * layers * mass, 1e-12);
            assert_int_equal(list[k].held, part == 0);
            for (int c = 0; c < 3; c++) {
                check_close(list[k].x[c], centre[c], 1e-14);
                check_close(list[k].v[c], c == 2 ? part + 0.5 : 0, 1e-12);
            }
            for (int h = 0; h < s->n; h++) {
                int p[3];
                bodies_site(s, h, p);
                if (p[2] < from[part] || p[2] >= from[part + 1]) continue;
                assert_int_equal(id[h], list[k].id);
                if (bodies_id(s, h) < first) first = bodies_id(s, h);
            }
            assert_int_equal((long)par_min((double)first), list[k].id);
        }
        free(list);
        free(id);
        solid_free(s);
    }
}

/* A comb whose teeth hang together only at its far end: pieces that meet across several ranks and back are one. */
static void comb(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 40, 12, 2);
    struct solid_input in = bodies_input(1, &body);
    struct solid *s = solid_new(&in);
    struct solid_family_view view;
    for (int separate = 0; separate < 2; separate++) {
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                const double y = s->x0[1][h], to = y + view.xi[b][1];
                const double x = fmin(s->x0[0][h], s->x0[0][h] + view.xi[b][0]);
                const int crosses = floor(y / (3 * SPACING)) != floor(to / (3 * SPACING));
                /* teeth of three rows along x, joined for x > 36 at first */
                if (crosses && view.intact[b] && (separate || x < 36 * SPACING)) solid_family_break(s, h, b);
            }
        }
        assert_int_equal(solid_fragments_measure(s, NULL, NULL), separate ? 4 : 1);
    }
    solid_free(s);
}

/* Across a plane only the bonds that reach farthest are intact: the body is one piece until they break as well. */
static void joined_by_far_bonds(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 40, 16, 18);
    struct solid_input in = bodies_input(1, &body);
    for (int axis = 0; axis < 3; axis++) {
        const int at[3] = {20, 8, 9};
        struct solid *s = solid_new(&in);
        struct solid_family_view view;
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                const double plane = at[axis] * SPACING, from = s->x0[axis][h], to = from + view.xi[b][axis];
                if ((from < plane) != (to < plane) && fabs(to - from) < 2.5 * SPACING) solid_family_break(s, h, b);
            }
        }
        assert_int_equal(solid_fragments_measure(s, NULL, NULL), 1);
        bodies_cut(s, axis, at[axis]);
        assert_int_equal(solid_fragments_measure(s, NULL, NULL), 2);
        solid_free(s);
    }
}

/* Across a plane only bonds that soften are left: in either store they hold the body together until they break. */
static void joined_by_softening_bonds(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 40, 16, 18);
    const struct solid_material material = {YOUNG, DENSITY, 1, 3, PHYSICS_CONSTANT, 2e4, 0};
    const double plane = 8 * SPACING;
    for (int general = 0; general < 2; general++) {
        struct solid_input in = bodies_input(1, &body);
        struct solid_family_view view;
        in.material = &material;
        in.general_bonds = general;
        struct solid *s = solid_new(&in);
        assert_non_null(s->soft);
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                const double from = s->x0[1][h], to = from + view.xi[b][1];
                double s_e, s_c;
                if ((from < plane) == (to < plane)) continue;
                solid_soft_limits(s, h, &s_e, &s_c);
                if (fabs(to - from) < 1.5 * SPACING)
                    solid_family_break(s, h, b);
                else
                    solid_soft_add_placed(s, h, b, 0.5 * (s_e + s_c));
            }
        }
        solid_soft_order(s->soft);
        assert_int_equal(solid_fragments_measure(s, NULL, NULL), 1);
        solid_soft_clear(s);
        bodies_cut(s, 1, 8);
        assert_int_equal(solid_fragments_measure(s, NULL, NULL), 2);
        solid_free(s);
    }
}

/* Crushed entirely: every particle is its own. */
static void dust(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 4, 5, 3);
    struct solid_input in = bodies_input(1, &body);
    struct solid *s = solid_new(&in);
    struct solid_family_view view;
    struct solid_fragment *list = NULL;
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++)
            if (view.intact[b]) solid_family_break(s, h, b);
    }
    assert_int_equal(solid_fragments_measure(s, NULL, &list), 60);
    for (int k = 0; k < 60; k++) {
        assert_int_equal(list[k].id, k);
        assert_int_equal(list[k].particles, 1);
    }
    free(list);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bar_in_three),
        cmocka_unit_test(comb),
        cmocka_unit_test(joined_by_far_bonds),
        cmocka_unit_test(joined_by_softening_bonds),
        cmocka_unit_test(dust),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
