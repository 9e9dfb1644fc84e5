/* The view of a particle's bonds in both stores: reciprocity, breaking, counts, and lambda as a checkpoint stores it.
 */
#include "tests/solid/make.h"
#include "tests/check.h"

static struct solid *block(int list) {
    return make((struct make){.sites = {7, 5, 6}, .periodic = {0, 1, 0}, .list = list});
}

/* The bond of l's view opposite to bond b of a view, or -1. */
static int opposite(const struct solid_family_view *view, int b, int h, const struct solid_family_view *of_l) {
    for (int k = 0; k < of_l->n; k++) {
        double apart = 0;
        for (int c = 0; c < 3; c++) apart = fmax(apart, fabs(of_l->xi[k][c] + view->xi[b][c]));
        if (of_l->l[k] == h && apart < 1e-6 * SPACING) return k;
    }
    return -1;
}

/* Breaks every 17th bond; returns how many were intact before. */
static long break_some(struct solid *s) {
    struct solid_family_view view;
    long broken = 0, met = 0;
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++)
            if (met++ % 17 == 0 && view.intact[b]) {
                solid_family_break(s, h, b);
                broken++;
            }
    }
    return broken;
}

/* Both ends see one bond: opposite vectors, one alpha and one lambda, and xi is the difference of the places. */
static void both_ends(void **state) {
    (void)state;
    static struct solid_family_view view, other;
    for (int list = 0; list < 2; list++) {
        struct solid *s = block(list);
        assert_true(break_some(s) > 100);
        int broken = 0;
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                const int l = view.l[b];
                for (int c = 0; c < 3; c++)
                    check_close(solid_shortest(s, c, view.xi[b][c] - (s->x0[c][l] - s->x0[c][h])), 0, 1e-9 * SPACING);
                solid_family_view(s, l, &other);
                const int back = opposite(&view, b, h, &other);
                check_at_least(back, 0);
                check_equal(other.alpha[back], view.alpha[b]);
                check_equal(other.intact[back], view.intact[b]);
                broken += !view.intact[b];
            }
        }
        check_above(broken, 200);
        solid_free(s);
    }
}

/* Breaks one bond of every fifth particle. */
static void break_others(struct solid *s) {
    struct solid_family_view view;
    for (int h = 0; h < s->n; h += 5) {
        solid_family_view(s, h, &view);
        if (view.intact[h % view.n]) solid_family_break(s, h, h % view.n);
    }
}

/* The list of torn bonds is the view's, but for those that it had in an earlier call, by their bits as saved then. */
static void check_broken(const struct solid *s, uint8_t (*known)[SOLID_FAMILY_MAX / 8],
                         uint8_t (*before)[SOLID_FAMILY_MAX / 8]) {
    static struct solid_family_view view;
    static int other[SOLID_FAMILY_MAX];
    for (int h = 0; h < s->n; h++) {
        const int n = solid_family_newly_broken(s, h, known[h], other);
        int k = 0, broken = 0;
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            broken += !view.intact[b];
            if (view.intact[b] || !(before[h][b / 8] >> b % 8 & 1)) continue;
            check_below(k, n);
            check_equal(other[k++], view.l[b]);
        }
        check_equal(k, n);
        check_equal((s->flag[h] & SOLID_BROKEN) != 0, broken > 0);
        check_equal(solid_family_newly_broken(s, h, known[h], other), 0);
    }
}

/* The lists of broken bonds are the view's; the flags say who has one; the counts are of bonds without a sense. */
static void broken_bonds(void **state) {
    (void)state;
    enum { MOST = 300 };
    for (int list = 0; list < 2; list++) {
        static uint8_t known[MOST][SOLID_FAMILY_MAX / 8], before[MOST][SOLID_FAMILY_MAX / 8];
        struct solid *s = block(list);
        const long directed = solid_family_directed(s);
        check_at_least(MOST, s->n);
        memset(known, 0, sizeof known);
        memset(before, 0xff, sizeof before);
        check_equal(directed, 2 * s->bonds_total);
        solid_family_count(s);
        check_equal(s->bonds_broken, 0);
        s->broke = 0;
        s->a_holds = 1;
        const long broken = break_some(s);
        check_equal(s->broke, 1);
        check_equal(s->a_holds, 0);
        solid_family_count(s);
        check_equal(s->bonds_broken, broken);
        check_broken(s, known, before);
        for (int h = 0; h < s->n; h++) solid_family_save(s, h, before[h]);
        break_others(s);
        check_broken(s, known, before);
        solid_family_count(s);
        check_above(s->bonds_broken, broken + 20);
        solid_free(s);
    }
}

/* Bits saved from one solid and loaded into another break the same bonds there; both stores have the same bits. */
static void saved_and_loaded(void **state) {
    (void)state;
    static struct solid_family_view view, again;
    uint8_t bits[2][SOLID_FAMILY_MAX / 8] = {{0}};
    for (int list = 0; list < 2; list++) {
        struct solid *s = block(list), *copy = block(list);
        int longest = 0;
        break_some(s);
        for (int h = 0; h < s->n; h++) {
            solid_family_save(s, h, bits[0]);
            solid_family_view(s, h, &view);
            assert_int_equal(solid_family_initial_bonds(s, h), view.n);
            if (view.n > longest) longest = view.n;
            for (int b = 0; b < view.n; b++) check_equal(bits[0][b / 8] >> b % 8 & 1, view.intact[b]);
            solid_family_load(copy, h, bits[0]);
            solid_family_view(copy, h, &again);
            for (int b = 0; b < view.n; b++) check_equal(again.intact[b], view.intact[b]);
            solid_family_save(copy, h, bits[1]);
            assert_memory_equal(bits[0], bits[1], (size_t)solid_family_bytes(s));
        }
        check_at_least(8 * solid_family_bytes(s), longest);
        solid_free(copy);
        solid_free(s);
    }
}

/* On the lattice: struts are the broken bonds of the view, with steps in spacings; the nearest particles are those at
 * one spacing along an axis, across periodic sides too. */
static void struts_and_nearest(void **state) {
    (void)state;
    static struct solid_family_view view;
    static signed char step[SOLID_FAMILY_MAX][3];
    int other[SOLID_FAMILY_MAX], nearest[6];
    for (int list = 0; list < 2; list++) {
        struct solid *s = block(list);
        long struts = 0, missing = 0;
        break_some(s);
        for (int h = 0; h < s->n; h++) {
            int found[6] = {-1, -1, -1, -1, -1, -1}, k = 0;
            const int n = solid_family_struts(s, h, other, step);
            solid_family_view(s, h, &view);
            solid_family_nearest(s, h, nearest);
            for (int b = 0; b < view.n; b++) {
                double length2 = 0;
                for (int c = 0; c < 3; c++) length2 += view.xi[b][c] * view.xi[b][c];
                for (int c = 0; c < 3 && length2 < 1.5 * SPACING * SPACING; c++)
                    if (fabs(view.xi[b][c]) > 0.5 * SPACING) found[2 * c + (view.xi[b][c] > 0)] = view.l[b];
                if (view.intact[b]) continue;
                check_below(k, n);
                check_equal(other[k], view.l[b]);
                for (int c = 0; c < 3; c++) check_close(step[k][c] - view.xi[b][c] / SPACING, 0, 1e-6);
                k++;
            }
            check_equal(k, n);
            struts += n;
            for (int f = 0; f < 6; f++) {
                check_equal(nearest[f], found[f]);
                missing += found[f] < 0;
            }
        }
        check_above(struts, 200);
        check_equal(missing, 2 * (5 * 6 + 7 * 5)); /* the sides that are not periodic */
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(both_ends), cmocka_unit_test(broken_bonds),
                                       cmocka_unit_test(saved_and_loaded), cmocka_unit_test(struts_and_nearest)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
