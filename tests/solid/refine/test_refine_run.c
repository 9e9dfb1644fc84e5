/* Plates refined while they move and break: symmetry, ranks, checkpoints, energy, stable step. */
#include "tests/solid/make_plate.h"
#include "solid/body/cloud.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/store.h"
#include "solid/force/force.h"
#include "solid/measure/energy.h"
#include "solid/refine/refine.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "solid/step/stable.h"
#include "tests/check.h"
#include "tests/one_rank.h"

#include <stdio.h>

static struct solid_refinement levels(int n) {
    return (struct solid_refinement){.levels = n, .energy = 0.5, .damage = 0.05, .low = {-1, -1}, .high = {1, 1}};
}

/* A particle on every rank, by its place. */
struct particle {
    double place[2], level, d[2], v[2], volume, intact, flag;
};
enum { NUMBERS = sizeof(struct particle) / sizeof(double) };

static int by_place(const void *a, const void *b) {
    const struct particle *x = a, *y = b;
    for (int c = 1; c >= 0; c--)
        if (x->place[c] != y->place[c]) return x->place[c] < y->place[c] ? -1 : 1;
    return 0;
}

static struct particle *gather(const struct solid *s) {
    static struct solid_family_view view;
    const struct solid_cloud *t = s->family->cloud[0];
    struct particle *all = calloc((size_t)s->n_global, sizeof *all);
    for (int h = 0; h < s->n; h++) {
        const long i = s->first[par_rank()] + h;
        struct particle *p = &all[i];
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) p->intact += view.intact[b];
        for (int c = 0; c < 2; c++) {
            p->place[c] = t->place[c][i];
            p->d[c] = s->d[c][h];
            p->v[c] = s->v[c][h];
        }
        p->volume = t->volume[i];
        p->level = solid_refine_level(s, h);
        p->flag = s->flag[h];
    }
    par_sum_array((double *)(void *)all, (int)(NUMBERS * s->n_global));
    qsort(all, (size_t)s->n_global, sizeof *all, by_place);
    return all;
}

/* Torn at both ends, cracked in its middle. */
static struct solid *pulled_plate(const struct solid_refinement *refinement, int verlet, enum solid_horizons horizons,
                                  double ratio_excess) {
    static const double point[2][3] = {{10.5 * SPACING, 8 * SPACING}, {17.5 * SPACING, 8 * SPACING}};
    const struct solid_cut cut = {2, point};
    const struct solid_load load[2] = {
        {SOLID_LOAD_EDGE, .edge = {{0, 0}, {28 * SPACING, 0}}, .traction = {0, -4e7}},
        {SOLID_LOAD_EDGE, .edge = {{0, 16 * SPACING}, {28 * SPACING, 16 * SPACING}}, .traction = {0, 4e7}}};
    struct solid *s = make((struct make){.sites = {28, 16},
                                         .brittle = 1,
                                         .cuts = 1,
                                         .cut = &cut,
                                         .loads = 2,
                                         .load = load,
                                         .contact = 0,
                                         .horizons = horizons,
                                         .refinement = refinement,
                                         .ratio_excess = ratio_excess});
    s->stage = (struct solid_stage){.integrator = verlet ? SOLID_VERLET : SOLID_RK3, .breakage = 1};
    return s;
}

static void tear(struct solid *s, int from, int to) {
    for (int k = from; k < to; k++) {
        if (k % 2) solid_refine_criteria(s);
        solid_integrate(s, step_of(0.2), 8);
    }
}

/* Mirror images about both axes, to the bit, through refinement and fracture. */
static void test_symmetry(void **state) {
    (void)state;
    for (int kind = 0; kind < 3; kind++) { /* one level, two, two with another Poisson's ratio */
        if (check_skips(kind, 2)) continue;
        const int two = kind > 0;
        const struct solid_refinement refinement = levels(1 + two);
        struct solid *s = pulled_plate(&refinement, 1, SOLID_DUAL_HORIZON, kind == 2 ? 0.1 : 0);
        tear(s, 0, 16);
        solid_family_count(s);
        check_at_least(solid_refine_events(s), 2);
        check_equal(solid_refine_finest(s), 1 + two);
        check_above(par_sum(s->e_fracture), 0);
        struct particle *all = gather(s);
        for (int c = 0; c < 2; c++)
            for (long i = 0; i < s->n_global; i++) {
                struct particle image = all[i];
                image.place[c] = (c ? 16 : 28) - image.place[c];
                const struct particle *p = bsearch(&image, all, (size_t)s->n_global, sizeof *all, by_place);
                assert_non_null(p);
                check_equal(p->level, image.level);
                check_equal(p->volume, image.volume);
                check_equal(p->intact, image.intact);
                for (int k = 0; k < 2; k++) {
                    const double sign = k == c ? -1 : 1;
                    check_equal(p->d[k], sign * image.d[k]);
                    check_equal(p->v[k], sign * image.v[k]);
                }
            }
        free(all);
        solid_free(s);
    }
}

/* Every number but the last `left`, to the tolerance, in terms of the column's largest; 0: to the bit. */
static void compare(const struct solid *s, const struct particle *all, long n, const struct particle *expected,
                    double tolerance, int left) {
    const double *one = (const double *)(const void *)all, *two = (const double *)(const void *)expected;
    assert_int_equal(s->n_global, n);
    for (int k = 0; k < NUMBERS - left; k++) {
        double most = 0;
        for (long i = 0; i < n; i++) most = fmax(most, fabs(two[i * NUMBERS + k]));
        for (long i = 0; i < n; i++) check_close(one[i * NUMBERS + k], two[i * NUMBERS + k], tolerance * most);
    }
}

/* The same results on more ranks, to the bit. One rank writes its results to a file. */
static void test_ranks(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        if (par_size() <= 2 && check_skips(kind, 2)) continue;
        char name[64];
        struct solid_refinement refinement = levels(2);
        refinement.interface_corrected = kind == 2;
        struct solid *s = pulled_plate(&refinement, kind != 1, kind == 2 ? SOLID_ONE_SIDED : SOLID_DUAL_HORIZON,
                                       kind == 3 ? -0.2 : 0);
        shake(s, 1e-6, 0);
        tear(s, 0, 10);
        check_at_least(solid_refine_events(s), 2);
        struct particle *all = gather(s);
        snprintf(name, sizeof name, "solid_test_refine_run_%d", kind);
        struct particle *expected = malloc((size_t)s->n_global * sizeof *all);
        one_rank_expects(name, all, (size_t)s->n_global * sizeof *all, expected);
        compare(s, all, s->n_global, expected, 0, 0);
        free(expected);
        free(all);
        solid_free(s);
    }
}

/* The data of a checkpoint, on every rank. */
struct kept {
    long n;
    uint8_t *body, *level, *bits;
    double (*place)[3], (*motion)[6];
    int bytes;
};

static struct kept keep(const struct solid *s) {
    struct kept k = {.n = s->n_global, .bytes = solid_family_bytes(s)};
    double *flat = calloc((size_t)(k.n * (9 + k.bytes + 1)), sizeof *flat);
    const long width = 9 + k.bytes + 1;
    for (int h = 0; h < s->n; h++) {
        double *row = flat + (s->first[par_rank()] + h) * width;
        uint8_t level, bits[SOLID_FAMILY_MAX];
        solid_refine_restore_save(s, h, &level, row);
        solid_family_save(s, h, bits);
        for (int c = 0; c < 2; c++) {
            row[3 + c] = s->d[c][h];
            row[5 + c] = s->v[c][h];
            row[7 + c] = s->v_old[c][h];
        }
        for (int b = 0; b < k.bytes; b++) row[9 + b] = bits[b];
        row[9 + k.bytes] = level;
    }
    par_sum_array(flat, (int)(k.n * width));
    k.body = calloc((size_t)k.n, 1);
    k.level = calloc((size_t)k.n, 1);
    k.bits = calloc((size_t)(k.n * k.bytes), 1);
    k.place = calloc((size_t)k.n, sizeof *k.place);
    k.motion = calloc((size_t)k.n, sizeof *k.motion);
    for (long i = 0; i < k.n; i++) {
        const double *row = flat + i * width;
        memcpy(k.place[i], row, sizeof *k.place);
        memcpy(k.motion[i], row + 3, sizeof *k.motion);
        for (int b = 0; b < k.bytes; b++) k.bits[i * k.bytes + b] = (uint8_t)row[9 + b];
        k.level[i] = (uint8_t)row[9 + k.bytes];
    }
    free(flat);
    return k;
}

static void put_back(struct solid *s, struct kept *k) {
    assert_int_equal(solid_refine_restore(s, k->n, k->body, k->level, (const double(*)[3])k->place), 0);
    assert_int_equal(solid_family_bytes(s), k->bytes);
    for (int h = 0; h < s->n; h++) {
        const long i = s->first[par_rank()] + h;
        for (int c = 0; c < 2; c++) {
            s->d[c][h] = k->motion[i][c];
            s->v[c][h] = k->motion[i][2 + c];
            s->v_old[c][h] = k->motion[i][4 + c];
        }
        solid_family_load(s, h, k->bits + i * k->bytes);
    }
    solid_ghosts_update(s);
    solid_integrate_resume(s);
    void *const own[] = {k->body, k->level, k->bits, k->place, k->motion};
    for (int q = 0; q < 5; q++) free(own[q]);
}

/* Stopped and restored into another solid with another division over ranks: the same results to the last digits. (A
 * family with large stretches starts with square roots; that is not restored.) */
static void test_resume(void **state) {
    (void)state;
    const struct solid_refinement refinement = levels(2);
    for (int other = 0; other < 2; other++) { /* a Poisson's ratio of 0.43 */
        if (check_skips(other + par_size(), 2)) continue;
        struct solid *s = pulled_plate(&refinement, 1, SOLID_DUAL_HORIZON, other ? 0.1 : 0),
                     *t = pulled_plate(&refinement, 1, SOLID_DUAL_HORIZON, other ? 0.1 : 0);
        tear(s, 0, 10);
        check_at_least(solid_refine_events(s), 2);
        struct kept kept = keep(s);
        put_back(t, &kept);
        t->t = s->t;
        tear(s, 10, 16);
        tear(t, 10, 16);
        struct particle *one = gather(s), *two = gather(t);
        compare(t, two, s->n_global, one, 1e-12, 1);
        free(one);
        free(two);
        solid_free(s);
        solid_free(t);
    }
}

/* Change of the strain energy of a smooth field by a refinement, and the forces of an affine field across levels,
 * relative to those of one row of bonds. */
static void test_jumps(void **state) {
    (void)state;
    for (int kind = 0; kind < 5; kind++) {
        if (check_skips(kind, 2)) continue;
        struct solid_refinement refinement = levels(2);
        refinement.interface_corrected = kind == 2;
        struct solid *s = make((struct make){.sites = {40, 40},
                                             .horizons = kind == 1 || kind == 2 ? SOLID_ONE_SIDED : SOLID_DUAL_HORIZON,
                                             .refinement = &refinement,
                                             .ratio_excess = kind < 3    ? 0
                                                             : kind == 3 ? -0.2
                                                                         : 0.1});
        uint8_t *mark = calloc(100000, 1);
        double before = 0, jump = 0, most = 0;
        for (int level = 0; level < 2; level++) {
            for (int c = 0; c < 2; c++)
                for (int h = 0; h < s->n; h++)
                    s->d[c][h] =
                        1e-6 * SPACING * cos(2 * M_PI / 40 * (s->x0[0][h] + (2 * c - 1) * s->x0[1][h]) / SPACING);
            before = solid_energy_measure(s).strain;
            for (int h = 0; h < s->n; h++)
                mark[h] = solid_refine_level(s, h) == level &&
                          hypot(s->x0[0][h] / SPACING - 20, s->x0[1][h] / SPACING - 20) < 3;
            check_above(solid_refine_marked(s, mark), 0);
            const double after = solid_energy_measure(s).strain;
            jump = check_worst(jump, after / before - 1);
        }
        for (int c = 0; c < 2; c++)
            for (int h = 0; h < s->n; h++) s->d[c][h] = 1e-6 * (1 + c) * s->x0[c][h];
        solid_ghosts_update(s);
        solid_force(s, 0);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 2; c++)
                if (fabs(s->x0[0][h] / SPACING - 20) < 16 && fabs(s->x0[1][h] / SPACING - 20) < 16)
                    most = fmax(most, fabs(s->a[c][h]) * DENSITY * SPACING / (YOUNG * 1e-6));
        most = par_max(most);
        print_message("%s: energy %.2g of itself at most, patch %.2g\n",
                      kind == 0   ? "dual horizon"
                      : kind == 1 ? "one-sided"
                      : kind == 2 ? "one-sided, corrected"
                      : kind == 3 ? "dual horizon, nu = 0.13"
                                  : "dual horizon, nu = 0.43",
                      jump, most);
        check_below(jump, 0.005);
        check_below(most, 2);
        free(mark);
        solid_free(s);
    }
}

/* The stable step is one when levels are mixed, and the bound by families is one of it. */
static void test_stable(void **state) {
    (void)state;
    static const double excess[3] = {0, -0.2, 0.1};
    for (int kind = 0; kind < 6; kind++) {
        if (check_skips(kind >> 1, 3)) continue;
        const int above = kind & 1;
        const double ratio_excess = excess[kind >> 1];
        const struct solid_refinement refinement = levels(2);
        struct solid *s =
            make((struct make){.sites = {20, 18}, .refinement = &refinement, .ratio_excess = ratio_excess});
        s->stage.integrator = SOLID_VERLET;
        const double coarse = solid_rates_stable_step(s, SOLID_VERLET);
        uint8_t *mark = calloc(100000, 1);
        for (int level = 0; level < 2; level++) {
            for (int h = 0; h < s->n; h++)
                mark[h] = solid_refine_level(s, h) == level &&
                          hypot(s->x0[0][h] / SPACING - 10, s->x0[1][h] / SPACING - 9) < 0.8;
            check_above(solid_refine_marked(s, mark), 0);
        }
        free(mark);
        struct solid_rates rates;
        solid_rates_of(s, &rates);
        const double bound = solid_refine_rate_bound(s);
        check_at_least(bound, rates.stiffness);
        check_below(bound, 2 * rates.stiffness);
        /* of a small region a little slower than an endless one, which is slower than the bound */
        const double endless = solid_refine_rate_lattice(s, 2);
        check_close(endless / solid_refine_rate_lattice(s, 0), 16, 1e-9);
        struct solid *plain = make((struct make){.sites = {20, 18}, .uncorrected = 1, .ratio_excess = ratio_excess});
        const double alone = solid_rates_stable_step(plain, SOLID_VERLET);
        check_close(4 / (alone * alone) / solid_refine_rate_lattice(s, 0), 1, 0.02);
        solid_free(plain);
        check_below(endless, bound);
        check_above(rates.stiffness, 0.8 * endless);
        const double fine = solid_stable_of(&rates, SOLID_VERLET, 0, NULL);
        if (!above) print_message("stable step: %.4f of the coarse one\n", fine / coarse);
        check_close(fine / coarse, 0.26, 0.015);
        shake(s, 1e-9, 0);
        solid_integrate(s, fine * (above ? 1.02 : 0.98), 1500);
        double most = 0;
        for (int h = 0; h < s->n; h++) most += fabs(s->d[0][h]);
        most = par_sum(most) / (1e-9 * SPACING * (double)s->n_global);
        if (above)
            assert_false(most < 100); /* NaN too */
        else
            check_below(most, 2);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_symmetry), cmocka_unit_test(test_ranks),  cmocka_unit_test(test_resume),
        cmocka_unit_test(test_jumps),    cmocka_unit_test(test_stable),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
