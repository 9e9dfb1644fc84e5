/* Fragments followed in time: numbers, origins, times, sizes, across ranks, periodic sides and refinements. */
#include "solid/measure/detachment.h"
#include "solid/refine/refine.h"
#include "solid/solid.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

static const double volume = SPACING * SPACING * SPACING;

struct look {
    int n;
    long *id;
    struct solid_fragment *list;
    struct solid_detachment *record;
    struct solid_detachment_size *size;
};

static struct look look_at(struct solid *s, double t) {
    struct look k = {.id = malloc(((size_t)s->n + 1) * sizeof(long))};
    k.n = solid_detachment_update(s, t, k.id, &k.list, &k.record);
    int *which = malloc((size_t)k.n * sizeof *which);
    k.size = malloc((size_t)k.n * sizeof *k.size);
    for (int i = 0; i < k.n; i++) which[i] = i;
    solid_detachment_sizes(s, k.id, k.list, k.n, which, k.size);
    free(which);
    return k;
}

static void look_free(struct look *k) {
    free(k->id);
    free(k->list);
    free(k->record);
    free(k->size);
}

/* The fragment with a number. */
static int with(const struct look *k, long number) {
    for (int i = 0; i < k->n; i++)
        if (k->record[i].number == number) return i;
    fail_msg("no fragment has the number %ld", number);
    return -1;
}

static void check_piece(const struct look *k, long number, long particles, double since) {
    const int i = with(k, number);
    assert_int_equal(k->list[i].particles, particles);
    check_equal(k->record[i].since, since);
    check_relative(k->size[i].volume, (double)particles * volume, 1e-12);
    check_relative(k->list[i].mass, DENSITY * k->size[i].volume, 1e-12);
}

/* A bar of thirty layers loses seven at its start, which has the smallest ids, and then eleven at its end: what is left
 * in the middle keeps number and time. */
static void bar_that_breaks_twice(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 5, 6, 30);
    for (int general = 0; general < 2; general++) {
        struct solid_input in = bodies_input(1, &body);
        in.general_bonds = general;
        struct solid *s = solid_new(&in);
        solid_detachment_begin(s);
        struct look k = look_at(s, 1);
        assert_int_equal(k.n, 1);
        check_piece(&k, 0, 900, 1);
        assert_false(k.record[0].is_new);
        check_relative(k.size[0].extent, 30 * SPACING, 1e-12);
        look_free(&k);

        bodies_cut(s, 2, 7);
        k = look_at(s, 2);
        assert_int_equal(k.n, 2);
        check_piece(&k, 0, 690, 1);
        check_piece(&k, 1, 210, 2);
        assert_true(k.record[with(&k, 1)].is_new);
        assert_false(k.record[with(&k, 0)].is_new);
        assert_int_equal(k.record[with(&k, 1)].from, 0);
        look_free(&k);
        k = look_at(s, 3); /* nothing has broken since */
        check_piece(&k, 1, 210, 2);
        assert_false(k.record[with(&k, 1)].is_new);
        look_free(&k);

        bodies_cut(s, 2, 19);
        bodies_cut(s, 2, 3); /* and of the first piece three layers of seven */
        k = look_at(s, 4);
        assert_int_equal(k.n, 4);
        check_piece(&k, 0, 360, 1);
        check_piece(&k, 1, 120, 2);
        check_piece(&k, 2, 330, 4);
        check_piece(&k, 3, 90, 4);
        assert_int_equal(k.record[with(&k, 2)].from, 0);
        assert_int_equal(k.record[with(&k, 3)].from, 1);
        double mass = 0;
        for (int i = 0; i < k.n; i++) mass += k.list[i].mass;
        check_relative(mass, DENSITY * 900 * volume, 1e-13);
        for (int h = 0; h < s->n; h++) {
            int p[3];
            bodies_site(s, h, p);
            assert_int_equal(s->fragment[h], p[2] < 3 ? 3 : p[2] < 7 ? 1 : p[2] < 19 ? 0 : 2);
        }
        look_free(&k);
        solid_free(s);
    }
}

/* Two halves of equal size: the one with the smallest id keeps the number. Crushed: as many numbers as particles, and
 * each is used once. */
static void halves_and_dust(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 4, 6, 8);
    struct solid_input in = bodies_input(1, &body);
    struct solid *s = solid_new(&in);
    struct solid_family_view view;
    solid_detachment_begin(s);
    struct look k = look_at(s, 0);
    look_free(&k);
    bodies_cut(s, 2, 4);
    k = look_at(s, 1);
    assert_int_equal(k.list[with(&k, 0)].id, 0);
    check_piece(&k, 1, 96, 1);
    look_free(&k);
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++)
            if (view.intact[b]) solid_family_break(s, h, b);
    }
    k = look_at(s, 2);
    assert_int_equal(k.n, 192);
    char seen[192] = "";
    for (int i = 0; i < k.n; i++) {
        assert_in_range(k.record[i].number, 0, 191);
        assert_false(seen[k.record[i].number]++);
        check_relative(k.size[i].extent, SPACING, 1e-12);
        check_equal(k.record[i].since, k.record[i].number == 0 ? 0 : k.record[i].number == 1 ? 1 : 2);
    }
    look_free(&k);
    solid_free(s);
}

/* A rod of 20 x 2 x 2 particles turned into the direction d: its longest distance is within the stated share. */
static void extent_of_a_turned_rod(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 20, 2, 2);
    const struct solid_input in = bodies_input(1, &body);
    struct solid *s = solid_new(&in);
    const double longest = sqrt(19. * 19 + 2) * SPACING;
    double least = INFINITY;
    solid_detachment_begin(s);
    for (int i = 0; i < 40; i++) {
        for (int c = 0; c < 3; c++)
            for (int h = 0; h < s->n; h++) s->d[c][h] = 0;
        bodies_turn(s, 0.157 * i, 0.3 * i);
        struct look k = look_at(s, 0);
        check_between((k.size[0].extent - SPACING) / longest, 0.88, 1 + 1e-12);
        least = fmin(least, (k.size[0].extent - SPACING) / longest);
        double x[3] = {0};
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) x[c] += (s->x0[c][h] + s->d[c][h]) / 80;
        par_sum_array(x, 3);
        for (int c = 0; c < 3; c++) check_close(k.size[0].centre[c], x[c], 1e-15 * 80);
        look_free(&k);
    }
    check_below(least, 0.97);
    solid_free(s);
}

/* A piece across a periodic side is put together; the body that spans the whole period is taken as it is. */
static void across_a_periodic_side(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 3, 4, 20);
    struct solid_input in = bodies_input(1, &body);
    in.periodic[2] = 1;
    in.length[2] = 20 * SPACING;
    struct solid *s = solid_new(&in);
    struct solid_family_view view;
    solid_detachment_begin(s);
    struct look k = look_at(s, 0);
    check_close(k.size[0].centre[2], 10 * SPACING, 1e-15);
    look_free(&k);
    for (int h = 0; h < s->n; h++) { /* layers 17 ... 19, 0, 1 come off */
        solid_family_view(s, h, &view);
        int p[3];
        bodies_site(s, h, p);
        for (int b = 0; b < view.n; b++) {
            const int other = (p[2] + (int)lrint(view.xi[b][2] / SPACING) + 20) % 20;
            if (view.intact[b] && (p[2] < 2 || p[2] > 16) != (other < 2 || other > 16)) solid_family_break(s, h, b);
        }
    }
    k = look_at(s, 1);
    assert_int_equal(k.n, 2);
    check_piece(&k, 1, 60, 1);
    const int i = with(&k, 1);
    const double z = k.size[i].centre[2] / SPACING;
    check_close(z - 20 * floor(z / 20), 19.5, 1e-12);
    check_relative(k.size[i].extent, (1 + 9 / sqrt(3)) * SPACING, 1e-12); /* along a space diagonal, (2, 3, 4) */
    check_close(k.size[with(&k, 0)].centre[2], 9.5 * SPACING, 1e-14);
    look_free(&k);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bar_that_breaks_twice),
        cmocka_unit_test(halves_and_dust),
        cmocka_unit_test(extent_of_a_turned_rod),
        cmocka_unit_test(across_a_periodic_side),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
