/* Interface after bonds have broken and the solid has moved, against detection from scratch. */
#include "solid/snapshot.h"
#include "solid/solid.h"
#include "solid/surface/surface.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

static struct solid *block_new(int nx, int ny, int nz, int general) {
    const struct solid_body body = bodies_box(0, 0, 0, nx, ny, nz);
    struct solid_input in = bodies_input(1, &body);
    in.general_bonds = general;
    return solid_new(&in);
}

/* An update's outcome against detection from scratch: the same set, areas, sides; normals to the tolerance within which
 * they are not turned (0.02 spacings at the end of a bond 3 long). */
static void check_against_scratch(struct solid *s, const struct solid_surface *f) {
    uint8_t *flag = malloc((size_t)s->n + 1);
    memcpy(flag, s->flag, (size_t)s->n);
    struct solid_surface *scratch = solid_surface_new(s);
    for (int h = 0; h < s->n; h++) assert_int_equal(flag[h], s->flag[h]);
    assert_int_equal(f->n, scratch->n);
    assert_int_equal(f->total, scratch->total);
    check_equal(f->initial_area, scratch->initial_area);
    check_equal(f->immersed_area, scratch->immersed_area);
    for (int i = 0; i < f->n; i++) {
        assert_int_equal(f->h[i], scratch->h[i]);
        check_equal(f->area[i], scratch->area[i]);
        assert_int_equal(f->two_sided[i], scratch->two_sided[i]);
        double cosine = 0;
        for (int c = 0; c < 3; c++) cosine += f->normal[c][i] * scratch->normal[c][i];
        if (f->two_sided[i]) cosine = fabs(cosine);
        check_above(cosine, cos(0.02));
    }
    solid_surface_free(scratch);
    free(flag);
}

/* A plane crack across each direction: hidden up to delta between the two layers, both layers beyond, hidden when
 * closed. */
static void crack(void **state) {
    (void)state;
    for (int axis = 0; axis < 3; axis++)
        for (int general = 0; general < 2; general++) {
            int n[3] = {7, 7, 7};
            n[axis] = 10;
            struct solid *s = block_new(n[0], n[1], n[2], general);
            struct solid_surface *f = solid_surface_new(s);
            const long before = f->total;
            assert_int_equal(solid_surface_update(s, f), 0);
            assert_int_equal(f->cones_used, 0);
            bodies_cut(s, axis, 5);
            const double opening[4] = {0, 0.9, 1.1, 0.9}; /* of delta, between the layers facing each other */
            for (int k = 0; k < 4; k++) {
                bodies_open(s, axis, 5, k == 0 ? 0 : opening[k] * DELTA - SPACING);
                assert_int_equal(solid_surface_update(s, f), k >= 2);
                assert_int_equal(f->total, k == 2 ? before + 2 * 25 : before);
                for (int i = 0; i < f->n; i++) {
                    int p[3], inner = 1;
                    bodies_site(s, f->h[i], p);
                    for (int c = 0; c < 3; c++) inner = inner && p[c] > 0 && p[c] < n[c] - 1;
                    if (!inner) continue;
                    assert_true(p[axis] == 4 || p[axis] == 5);
                    assert_false(s->flag[f->h[i]] & SOLID_FIRST);
                    check_relative(f->area[i], SPACING * SPACING, 1e-12);
                    const int centre = p[(axis + 1) % 3] == 3 && p[(axis + 2) % 3] == 3;
                    if (centre) check_close(f->normal[axis][i], p[axis] == 4 ? 1 : -1, 1e-12);
                }
                check_against_scratch(s, f);
            }
            solid_surface_free(f);
            solid_free(s);
        }
}

/* A particle deep inside that has lost all its bonds joins the interface, alone, and is two-sided. */
static void isolated(void **state) {
    (void)state;
    struct solid *s = block_new(9, 9, 9, 0);
    struct solid_surface *f = solid_surface_new(s);
    const long before = f->total;
    struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        int p[3];
        bodies_site(s, h, p);
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            int centre = p[0] == 4 && p[1] == 4 && p[2] == 4, to_centre = 1;
            for (int c = 0; c < 3; c++)
                to_centre = to_centre && fabs(s->x0[c][h] + view.xi[b][c] - 4.5 * SPACING) < 1e-9;
            if ((centre || to_centre) && view.intact[b]) solid_family_break(s, h, b);
        }
    }
    assert_int_equal(solid_surface_update(s, f), 1);
    assert_int_equal(f->total, before + 1);
    for (int i = 0; i < f->n; i++) {
        int p[3];
        bodies_site(s, f->h[i], p);
        const int centre = p[0] == 4 && p[1] == 4 && p[2] == 4;
        assert_int_equal(centre, !(s->flag[f->h[i]] & SOLID_FIRST));
        assert_int_equal(centre ? SOLID_ISOLATED : SOLID_ONE_FACE, f->two_sided[i]);
    }
    check_against_scratch(s, f);
    solid_surface_free(f);
    solid_free(s);
}

/* A rigid turn turns the normals with it; a shift leaves them as they are. */
static void turn(void **state) {
    (void)state;
    struct solid *s = block_new(8, 7, 6, 0);
    struct solid_surface *f = solid_surface_new(s);
    const double before[3] = {f->normal[0][0], f->normal[1][0], f->normal[2][0]};
    for (int k = 0; k < 2; k++) {
        const double angle = k == 0 ? 0 : 0.7, c = cos(angle), t = (1 - c) / 3, w = sin(angle) / sqrt(3);
        bodies_turn(s, angle, 0.01);
        assert_int_equal(solid_surface_update(s, f), 0);
        const double turned[3] = {(c + t) * before[0] + (t - w) * before[1] + (t + w) * before[2],
                                  (t + w) * before[0] + (c + t) * before[1] + (t - w) * before[2],
                                  (t - w) * before[0] + (t + w) * before[1] + (c + t) * before[2]};
        for (int i = 0; i < 3; i++) {
            check_close(f->normal[i][0], turned[i], 1e-10);
        }
        check_against_scratch(s, f);
    }
    solid_surface_free(f);
    solid_free(s);
}

/* Breaks a part of the bonds at random, from any particle on, up or down, and moves all particles. */
static void crush(struct solid *s, int round, double part) {
    struct solid_family_view view;
    const int first = s->n > 0 ? (int)(bodies_random(round, par_rank()) * s->n) : 0;
    for (int k = 0; k < s->n; k++) {
        const int h = (first + (round % 2 ? k : s->n - 1 - k)) % s->n;
        int p[3];
        bodies_site(s, h, p);
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            int q[3];
            for (int c = 0; c < 3; c++) q[c] = (int)floor((s->x0[c][h] + view.xi[b][c]) / SPACING);
            const long i = p[0] + 8 * (p[1] + 8 * p[2]), j = q[0] + 8 * (q[1] + 8 * q[2]);
            if (view.intact[b] && bodies_random(i < j ? i : j, (i < j ? j : i) + 1000 * round) < part)
                solid_family_break(s, h, b);
        }
        for (int c = 0; c < 3; c++)
            s->d[c][h] += 1.5 * SPACING * (bodies_random(p[0] + 8 * (p[1] + 8 * p[2]), 7 * round + c) - 0.5);
    }
}

/* Bonds broken and particles moved at random, several times over: every update is as good as starting again. */
static void random_crushing(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++) {
        struct solid *s = block_new(8, 7, 6, general);
        struct solid_surface *f = solid_surface_new(s);
        long most = 0;
        for (int round = 1; round <= 5; round++) {
            crush(s, round, 0.3);
            solid_surface_update(s, f);
            check_against_scratch(s, f);
            most = f->total;
        }
        check_above(most, 8 * 7 * 6 - 6 * 5 * 4); /* the crushing has exposed something */
        solid_surface_free(f);
        solid_free(s);
    }
}

/* A snapshot is restored: after more damage, the earlier bonds, displacements and flags with the kept normals give
 * the same results as if nothing had happened in between. */
static void kept_and_restored(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++) {
        struct solid *s = block_new(8, 7, 6, general);
        struct solid_surface *f = solid_surface_new(s);
        const size_t n = (size_t)s->n;
        struct solid_snapshot *kept = solid_snapshot_new(s, f, 1);
        double *normal = malloc((3 * n + 1) * sizeof *normal);
        crush(s, 1, 0.3);
        solid_surface_update(s, f);
        const int on = f->n;
        solid_snapshot_take(kept, s, f);
        for (size_t c = 0; c < 3; c++) memcpy(normal + c * n, f->normal[c], (size_t)on * sizeof *normal);
        crush(s, 2, 0.5);
        solid_surface_update(s, f);
        solid_snapshot_restore(kept, s, f);
        assert_int_equal(f->n, on);
        for (int i = 0; i < on; i++)
            for (size_t c = 0; c < 3; c++) check_equal(f->normal[c][i], normal[c * n + (size_t)i]);
        solid_surface_update(s, f);
        check_against_scratch(s, f);
        crush(s, 3, 0.4);
        solid_surface_update(s, f);
        check_against_scratch(s, f);
        free(normal);
        solid_snapshot_free(kept);
        solid_surface_free(f);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crack),           cmocka_unit_test(isolated),          cmocka_unit_test(turn),
        cmocka_unit_test(random_crushing), cmocka_unit_test(kept_and_restored),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
