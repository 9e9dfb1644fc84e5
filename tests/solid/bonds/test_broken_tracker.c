/* Which particles have lost bonds since the last check, against a comparison of all views; and who has yet to look. */
#include "solid/bonds/broken_tracker.h"
#include "tests/solid/make.h"
#include "tests/check.h"

#include <stdlib.h>

static int by_number(const void *a, const void *b) { return *(const int *)a - *(const int *)b; }

/* Breaks a bond of some particles; touched [n] becomes 1 for both ends. */
static int break_some(struct solid *s, int from, uint8_t *touched) {
    struct solid_family_view view;
    int ends = 0;
    memset(touched, 0, (size_t)s->n);
    for (int h = from; h < s->n; h += 23) {
        solid_family_view(s, h, &view);
        const int b = (5 * h + from) % view.n;
        if (!view.intact[b]) continue;
        solid_family_break(s, h, b);
        touched[h] = touched[view.l[b]] = 1;
    }
    for (int h = 0; h < s->n; h++) ends += touched[h];
    return ends;
}

static void check_found(struct solid_broken_tracker *tracker, int n, const uint8_t *touched, int ends) {
    check_equal(n, ends);
    check_equal(tracker->found, n);
    qsort(tracker->h, (size_t)n, sizeof *tracker->h, by_number);
    for (int k = 0; k < n; k++) {
        check_equal(touched[tracker->h[k]], 1);
        if (k > 0) check_above(tracker->h[k], tracker->h[k - 1]);
    }
}

/* Exactly the ends of bonds broken since the last check, once; none without news; a copy goes on from the same state.
 */
static void found_once(void **state) {
    (void)state;
    for (int list = 0; list < 2; list++) {
        struct solid *s = make((struct make){.sites = {9, 6, 5}, .list = list});
        struct solid_broken_tracker *tracker = solid_broken_tracker_new(s), *copy = solid_broken_tracker_new(s);
        uint8_t *touched = malloc((size_t)s->n + 1);
        check_equal(solid_broken_tracker_find(tracker, s), 0);
        for (int round = 0; round < 3; round++) {
            const int ends = break_some(s, round, touched);
            check_above(ends, 10);
            solid_broken_tracker_copy(copy, tracker, s);
            check_found(tracker, solid_broken_tracker_find(tracker, s), touched, ends);
            check_equal(solid_broken_tracker_find(tracker, s), 0);
            check_found(copy, solid_broken_tracker_find(copy, s), touched, ends);
        }
        struct solid_family_view view;
        for (int h = 0; h < s->n; h++) {
            int intact = 0;
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) intact += view.intact[b];
            if (s->flag[h] & SOLID_BROKEN) check_equal(tracker->intact[h], intact);
        }
        free(touched);
        solid_broken_tracker_free(copy);
        solid_broken_tracker_free(tracker);
        solid_free(s);
    }
}

/* After the counts are forgotten every particle counts as changed: in a list those that have lost a bond. */
static void forgotten(void **state) {
    (void)state;
    for (int list = 0; list < 2; list++) {
        struct solid *s = make((struct make){.sites = {6, 6, 5}, .list = list});
        struct solid_broken_tracker *tracker = solid_broken_tracker_new(s);
        uint8_t *touched = malloc((size_t)s->n + 1);
        const int ends = break_some(s, 0, touched);
        solid_broken_tracker_find(tracker, s);
        solid_broken_tracker_reset(tracker, s);
        check_equal(solid_broken_tracker_find(tracker, s), list ? ends : s->n);
        check_equal(solid_broken_tracker_find(tracker, s), 0);
        free(touched);
        solid_broken_tracker_free(tracker);
        solid_free(s);
    }
}

/* News reaches every reader once; contact is a reader only if the solid has contact. */
static void readers(void **state) {
    (void)state;
    for (int contact = 0; contact < 2; contact++) {
        struct solid s = {.in.contact = contact};
        check_equal(solid_broken_tracker_take(&s, SOLID_BROKE_SURFACE), 0);
        s.broke = SOLID_BROKE_NEW;
        check_equal(solid_broken_tracker_take(&s, SOLID_BROKE_SURFACE), 1);
        check_equal(solid_broken_tracker_take(&s, SOLID_BROKE_SURFACE), 0);
        check_equal(s.broke, contact ? SOLID_BROKE_CONTACT : 0);
        check_equal(solid_broken_tracker_take(&s, SOLID_BROKE_CONTACT), contact);
        check_equal(solid_broken_tracker_take(&s, SOLID_BROKE_CONTACT), 0);
        check_equal(s.broke, 0);
        s.broke = SOLID_BROKE_NEW | SOLID_BROKE_SURFACE; /* broken again before the surface has looked */
        check_equal(solid_broken_tracker_take(&s, SOLID_BROKE_CONTACT), 1);
        check_equal(solid_broken_tracker_take(&s, SOLID_BROKE_SURFACE), 1);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(found_once), cmocka_unit_test(forgotten),
                                       cmocka_unit_test(readers)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
