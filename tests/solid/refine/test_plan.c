/* Plans of a refinement: who is refined with whom, new positions and their values, horizons. */
#include "solid/refine/parts.h"
#include "solid/refine/places.h"
#include "tests/solid/make_plate.h"
#include "tests/check.h"

static struct solid_refinement levels(int n) {
    return (struct solid_refinement){.levels = n, .low = {-1, -1}, .high = {1, 1}};
}

/* The particle of the plan in the middle of cell i, j of the lattice. */
static long in_cell(const struct solid_refine_plan *p, int i, int j) {
    int at[2] = {i, j};
    for (int c = 0; c < 2; c++)
        at[c] = (int)lrint((at[c] + 0.5 - p->cloud->origin[c] / p->cloud->spacing) * SOLID_REFINE_UNIT);
    return solid_refine_places_at(p, at[0], at[1]);
}

/* New particles are where none was, once, and take a linear field from their sources exactly. */
static void check_interpolated(const struct solid_refine_plan *p) {
    for (long i = p->before; i < p->n; i++) {
        const struct solid_refine_interpolated *interpolated = &p->interpolated[i - p->before];
        double sum = 0, x[2] = {0, 0};
        check_equal(solid_refine_places_at(p, p->at[i][0], p->at[i][1]), i);
        check_between(interpolated->parents, 0, SOLID_REFINE_PARENTS + 1);
        for (int k = 0; k < SOLID_REFINE_PARENTS; k++) {
            if (interpolated->weight[k] == 0) continue;
            check_below(interpolated->source[k], i);
            sum += interpolated->weight[k];
            for (int c = 0; c < 2; c++) x[c] += interpolated->weight[k] * p->at[interpolated->source[k]][c];
        }
        check_close(sum, 1, 1e-15);
        for (int c = 0; c < 2; c++) check_close(x[c], p->at[i][c], 1e-12);
    }
}

/* One particle alone: eight new ones at half a spacing around it. At a corner of the plate three. */
static void one_particle(void **state) {
    (void)state;
    const struct solid_refinement refinement = levels(1);
    struct solid *s = make((struct make){.sites = {12, 10}, .refinement = &refinement});
    const int cell[2][2] = {{5, 4}, {0, 9}};
    for (int k = 0; k < 2; k++) {
        struct solid_refine_plan *p = solid_refine_plan_of(s, 0, NULL);
        const long i = in_cell(p, cell[k][0], cell[k][1]);
        check_at_least(i, 0);
        solid_refine_plan_close(p, &i, 1, 0);
        check_equal(p->refined, 1);
        check_equal(p->level[i], 1);
        check_equal(p->n - p->before, 8);
        for (long n = p->before; n < p->n; n++) {
            const int dx = abs(p->at[n][0] - p->at[i][0]), dy = abs(p->at[n][1] - p->at[i][1]);
            check_equal(dx > dy ? dx : dy, SOLID_REFINE_UNIT / 2);
            check_equal(p->level[n], 1);
        }
        check_interpolated(p);
        solid_refine_plan_free(p);
    }
    solid_free(s);
}

/* With its family: the 29 particles within 3 spacings. A kept one is left out; marked alone it stops everything. */
static void families_and_kept(void **state) {
    (void)state;
    const struct solid_refinement refinement = levels(1);
    struct solid *s = make((struct make){.sites = {14, 14}, .refinement = &refinement});
    uint8_t *kept = calloc((size_t)s->n_global + 1, 1);
    for (int k = 0; k < 3; k++) {
        struct solid_refine_plan *p = solid_refine_plan_of(s, 0, k ? kept : NULL);
        const long i = in_cell(p, 7, 6), other = in_cell(p, 10, 6);
        solid_refine_plan_close(p, &i, 1, 1);
        check_equal(p->refined, 29 - (k == 1) - (k == 2 ? 29 : 0));
        check_equal(p->level[other], k == 0);
        check_interpolated(p);
        kept[other] = 1;
        kept[i] = k == 1;
        solid_refine_plan_free(p);
    }
    free(kept);
    solid_free(s);
}

/* A particle between two marked ones has six of the eight places around it filled, and is refined with them; in their
 * corner it has five, and is not. */
static void enclosed(void **state) {
    (void)state;
    const struct solid_refinement refinement = levels(1);
    struct solid *s = make((struct make){.sites = {12, 12}, .refinement = &refinement});
    for (int corner = 0; corner < 2; corner++) {
        struct solid_refine_plan *p = solid_refine_plan_of(s, 0, NULL);
        const long marked[2] = {in_cell(p, 4, 5), corner ? in_cell(p, 5, 4) : in_cell(p, 6, 5)};
        solid_refine_plan_close(p, marked, 2, 0);
        check_equal(p->level[in_cell(p, 5, 5)], !corner);
        check_equal(p->refined, corner ? 2 : 3);
        check_interpolated(p);
        solid_refine_plan_free(p);
    }
    solid_free(s);
}

/* A particle refined alone and once more: first the eight coarser ones within its horizon of 3/2. */
static void coarser_ones_first(void **state) {
    (void)state;
    const struct solid_refinement refinement = levels(2);
    struct solid *s = make((struct make){.sites = {12, 12}, .refinement = &refinement});
    struct solid_refine_plan *p = solid_refine_plan_of(s, 0, NULL);
    const long i = in_cell(p, 5, 5);
    solid_refine_plan_close(p, &i, 1, 0);
    solid_refine_plan_close(p, &i, 1, 0);
    check_equal(p->refined, 1 + 8 + 1);
    for (int k = 0; k < 9; k++) check_equal(p->level[in_cell(p, 4 + k % 3, 4 + k / 3)], k == 4 ? 2 : 1);
    check_interpolated(p);
    solid_refine_plan_free(p);
    solid_free(s);
}

/* Refined again and again in one place: within a particle's horizon all others are at most one level coarser, and no
 * particle has more than five of the eight places around it filled. */
static void graded(void **state) {
    (void)state;
    const struct solid_refinement refinement = levels(3);
    struct solid *s = make((struct make){.sites = {30, 24}, .refinement = &refinement});
    struct solid_refine_plan *p = solid_refine_plan_of(s, 0, NULL);
    const long i = in_cell(p, 14, 11);
    for (int round = 1; round <= 3; round++) {
        solid_refine_plan_close(p, &i, 1, 1);
        check_equal(p->level[i], round);
        check_interpolated(p);
        for (long a = 0; a < p->n; a++) {
            const int h = solid_refine_plan_spacing(p->level[a]);
            int about = 0;
            for (long b = 0; b < p->n; b++) {
                const int dx = abs(p->at[a][0] - p->at[b][0]), dy = abs(p->at[a][1] - p->at[b][1]);
                about += a != b && dx <= h / 2 && dy <= h / 2;
                if (dx * dx + dy * dy <= 9 * h * h) check_at_least(p->level[b] + 1, p->level[a]);
            }
            check_at_most(about, 5);
        }
    }
    const long n = p->n, refined = p->refined;
    solid_refine_plan_close(p, &i, 1, 1); /* it is at the finest level */
    check_equal(p->n, n);
    check_equal(p->refined, refined);
    solid_refine_plan_free(p);
    solid_free(s);
}

/* m h, or the material's m at all levels; sqrt(2) times that where a coarser particle is next to it. */
static void horizons(void **state) {
    (void)state;
    check_equal(solid_refine_plan_level(1), 0);
    check_equal(solid_refine_plan_level(0.5), 1);
    check_equal(solid_refine_plan_level(0.125), 3);
    for (int k = 0; k < 4; k++) {
        struct solid_refinement refinement = levels(1);
        refinement.horizon_kept = k & 1;
        refinement.interface_corrected = k >> 1;
        struct solid *s = make((struct make){.sites = {14, 14}, .refinement = &refinement});
        struct solid_refine_plan *p = solid_refine_plan_of(s, 0, NULL);
        const long i = in_cell(p, 7, 6), far = in_cell(p, 1, 1), rim = in_cell(p, 10, 6);
        solid_refine_plan_close(p, &i, 1, 1);
        const long edge = solid_refine_places_at(p, p->at[rim][0] + SOLID_REFINE_UNIT / 2, p->at[rim][1]);
        check_at_least(edge, 0);
        check_equal(solid_refine_plan_horizon(p, far), 3);
        check_equal(solid_refine_plan_horizon(p, i), k & 1 ? 3 : 1.5);
        check_relative(solid_refine_plan_horizon(p, edge), (k & 1 ? 3 : 1.5) * (k >> 1 ? sqrt(2) : 1), 1e-15);
        solid_refine_plan_free(p);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_particle), cmocka_unit_test(families_and_kept),
                                       cmocka_unit_test(enclosed),     cmocka_unit_test(coarser_ones_first),
                                       cmocka_unit_test(graded),       cmocka_unit_test(horizons)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
