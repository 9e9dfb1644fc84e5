/* Rows of a plate's lattice: the same bits as by the lists of bonds; which particles are in them. */
#include "tests/solid/make_plate.h"
#include "solid/bonds/list_rows.h"
#include "solid/force/force.h"
#include "tests/check.h"

enum { NX = 40, NY = 36 };

static struct solid_list *list_of(const struct solid *s) { return s->family->list[0]; }

/* The forces by the lists alone. */
static void sweep_lists(struct solid *s, double *const a[2], int may_break) {
    struct solid_list_rows *rows = list_of(s)->rows;
    list_of(s)->rows = NULL;
    solid_force(s, may_break);
    list_of(s)->rows = rows;
    for (int c = 0; c < 2; c++) memcpy(a[c], s->a[c], (size_t)s->n * sizeof(double));
}

static void check_same(struct solid *s, double *const a[2]) {
    long differ = 0;
    for (int c = 0; c < 2; c++)
        for (int h = 0; h < s->n; h++) differ += s->a[c][h] != a[c][h];
    check_equal(par_sum_long(differ), 0);
}

static double most_of(const struct solid *s, const double *a) {
    double most = 0;
    for (int h = 0; h < s->n; h++) most = fmax(most, fabs(a[h]));
    return most;
}

/* Whole are the members of rows all of whose bonds are swept; both records of it agree. */
static void check_whole(const struct solid *s) {
    const struct solid_list *list = list_of(s);
    const struct solid_list_rows *rows = list->rows;
    long complete = 0;
    if (!rows) return; /* of a rank with edges only */
    for (int i = 0; i < list->n; i++) complete += rows->complete[i];
    for (int r = 0; r < rows->rows; r++)
        for (int k = 0; k < SOLID_LIST_BLOCK; k++) {
            const int i = rows->row[r].particle[k];
            int intact = 1;
            if (!(rows->row[r].member >> k & 1)) continue;
            for (long j = list->start[i]; j < list->end[i]; j++) intact &= solid_list_is_swept(list, j);
            check_equal(rows->row[r].complete >> k & 1, intact);
            check_equal(rows->complete[i], intact);
            check_equal(rows->site[i], rows->row[r].site + k);
        }
    check_equal(solid_list_rows_bonds(list), complete * rows->family);
}

/* By rows and by lists: small and large strains, with and without damping, bonds that break and that are joined again,
 * across periodic sides. A strain that grows changes the digit to which sums are rounded. */
static void same_bits(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        const int damped = kind & 1, periodic = kind >> 1;
        struct solid *s = make((struct make){.sites = {NX, NY}, .brittle = 1, .periodic = {periodic, 0}});
        double *a[2];
        for (int c = 0; c < 2; c++) a[c] = malloc((size_t)(s->n + 1) * sizeof(double));
        s->stage = (struct solid_stage){.breakage = 1, .damping_relative = damped ? 1e8 : 0};
        const long complete = par_sum_long(solid_list_rows_bonds(list_of(s)));
        check_above(complete, 0.3 * (double)par_sum_long(list_of(s)->bonds));
        for (int turn = 0; turn < 9; turn++) {
            /* 1e-6, 4e-6 ... 2.6e-4 of a spacing; then about s0, where some bonds break; then beyond the series */
            shake(s, turn < 5 ? 3e-6 * (1 << 2 * turn) : turn < 7 ? 1e-3 : 4e-3, 1);
            for (int may_break = 0; may_break < 2; may_break++) {
                /* twice: whether a family takes the series or square roots depends on the sweep before too */
                for (int k = 0; k < 2; k++) solid_force(s, may_break);
                sweep_lists(s, a, may_break);
                solid_force(s, may_break);
                check_same(s, a);
                for (int c = 0; c < 2 && turn == 0; c++) check_above(par_max(most_of(s, a[c])), 0);
                check_whole(s);
            }
        }
        solid_family_count(s);
        check_above(s->bonds_broken, 0);
        check_below(par_sum_long(solid_list_rows_bonds(list_of(s))), complete);
        uint8_t intact[SOLID_FAMILY_MAX / 8 + 1];
        memset(intact, 0xff, sizeof intact);
        for (int h = 0; h < s->n; h++) solid_family_load(s, h, intact);
        check_whole(s);
        check_equal(par_sum_long(solid_list_rows_bonds(list_of(s))), complete);
        for (int c = 0; c < 2; c++) free(a[c]);
        solid_free(s);
    }
}

/* Points moved from a lattice are in no row. */
static void irregular(void **state) {
    (void)state;
    struct solid *s = make((struct make){.sites = {NX, NY}, .perturbation = 0.2, .seed = 3});
    check_equal(solid_list_rows_bonds(list_of(s)), 0);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(same_bits), cmocka_unit_test(irregular)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
