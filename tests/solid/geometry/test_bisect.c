/* The order by halves: every part of a dyadic share is a box, uneven layers stand alone, and rings are cut last. */
#include "base/par.h"
#include "solid/geometry/bisect.h"
#include "tests/check.h"

#include <stdlib.h>

enum { MOST = 4096 };

/* A block of n[0] x n[1] x n[2] full bricks of `side` sites, from a corner; the first `cut` layers of sites are left
 * out at each face. */
static int block(struct solid_bisect_item *item, const int n[3], int side, int cut) {
    int index = 0;
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++, index++) {
                struct solid_bisect_item *t = &item[index];
                *t = (struct solid_bisect_item){.at = {i - 3, j + 5, k}, .item = index, .weight = 1};
                for (int c = 0; c < 3; c++) {
                    const int at = (int[]){i, j, k}[c];
                    t->low[c] = (uint8_t)(at == 0 ? cut : 0);
                    t->high[c] = (uint8_t)(at == n[c] - 1 ? side - cut : side);
                    t->weight *= t->high[c] - t->low[c];
                }
            }
    return index;
}

/* Bricks of the box around these. */
static long box(const struct solid_bisect_item *item, long n, int length[3]) {
    long volume = 1;
    for (int c = 0; c < 3; c++) {
        int low = item[0].at[c], high = item[0].at[c];
        for (long i = 1; i < n; i++) {
            if (item[i].at[c] < low) low = item[i].at[c];
            if (item[i].at[c] > high) high = item[i].at[c];
        }
        length[c] = high - low + 1;
        volume *= length[c];
    }
    return volume;
}

static void each_is_there_once(void **state) {
    (void)state;
    static struct solid_bisect_item item[MOST];
    static char seen[MOST];
    const int n = block(item, (int[]){7, 11, 5}, 8, 3);
    solid_bisect_order(item, n, 8, (int[]){0, 0, 0}, -1);
    for (int i = 0; i < n; i++) {
        check_between((double)item[i].item, -1, n);
        check_equal(seen[item[i].item]++, 0);
    }
}

/* Halves, quarters ... of a cube of 2^12 bricks, down to single bricks, are boxes whose sides are as 1 : 1 or 1 : 2. */
static void shares_are_boxes(void **state) {
    (void)state;
    static struct solid_bisect_item item[MOST];
    const int n = block(item, (int[]){16, 16, 16}, 8, 0);
    solid_bisect_order(item, n, 8, (int[]){0, 0, 0}, -1);
    for (long share = n; share >= 1; share /= 2)
        for (long from = 0; from < n; from += share) {
            int length[3];
            check_equal(box(item + from, share, length), share);
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++) check_at_most(length[a], 2 * length[b]);
        }
}

/* The longest side is cut in sites, not in bricks: 6 bricks with 2 sites missing at each end are longer than 5 full
 * ones, with 5 missing at each end they are shorter. */
static void sides_are_in_sites(void **state) {
    (void)state;
    static struct solid_bisect_item item[MOST];
    for (int cut = 2; cut <= 5; cut += 3) {
        const int n = block(item, (int[]){6, 5, 1}, 8, 0);
        for (int i = 0; i < n; i++) {
            if (item[i].at[0] == -3) item[i].low[0] = (uint8_t)cut;
            if (item[i].at[0] == 2) item[i].high[0] = (uint8_t)(8 - cut);
        }
        solid_bisect_order(item, n, 8, (int[]){0, 0, 0}, -1);
        int length[3];
        const int first = cut == 2 ? 3 * 5 : 6 * 2;
        check_equal(box(item, first, length), first);
        check_equal(length[0], cut == 2 ? 3 : 6);
    }
}

/* Of five equal layers the middle one comes between two and two; of four none is alone. */
static void uneven_layers(void **state) {
    (void)state;
    static struct solid_bisect_item item[MOST];
    int length[3];
    int n = block(item, (int[]){2, 2, 5}, 8, 0);
    solid_bisect_order(item, n, 8, (int[]){0, 0, 0}, -1);
    for (int i = 0; i < n; i++)
        check_equal(i < 8 ? item[i].at[2] < 2 : i < 12 ? item[i].at[2] == 2 : item[i].at[2] > 2, 1);
    n = block(item, (int[]){2, 2, 4}, 8, 0);
    solid_bisect_order(item, n, 8, (int[]){0, 0, 0}, -1);
    check_equal(box(item, 8, length), 8);
    check_equal(length[2], 2);
}

/* A ring has two cuts, so it is cut across its length only where that is twice another side. After the first cut it is
 * no ring any more. */
static void rings(void **state) {
    (void)state;
    static struct solid_bisect_item item[MOST];
    const struct {
        int n[3], is_ring[3], across;
    } row[] = {{{4, 6, 8}, {0, 0, 0}, 2}, {{4, 6, 8}, {0, 0, 1}, 1}, {{4, 4, 10}, {0, 0, 1}, 2}};
    for (int q = 0; q < 3; q++) {
        const int n = block(item, row[q].n, 8, 0);
        int length[3];
        solid_bisect_order(item, n, 8, row[q].is_ring, -1);
        check_equal(box(item, n / 2, length), n / 2);
        for (int c = 0; c < 3; c++) check_equal(length[c], row[q].n[c] / (c == row[q].across ? 2 : 1));
    }
}

/* The first cut is across the given direction, if there is more than one layer along it; the second across the longest
 * side again. */
static void given_first(void **state) {
    (void)state;
    static struct solid_bisect_item item[MOST];
    int length[3];
    int n = block(item, (int[]){4, 8, 4}, 8, 0);
    solid_bisect_order(item, n, 8, (int[]){0, 0, 1}, 2);
    check_equal(box(item, n / 2, length), n / 2);
    check_equal(length[2], 2);
    check_equal(box(item, n / 4, length), n / 4);
    check_equal(length[1], 4);
    n = block(item, (int[]){4, 8, 1}, 8, 0);
    solid_bisect_order(item, n, 8, (int[]){0, 0, 0}, 2);
    check_equal(box(item, n / 2, length), n / 2);
    check_equal(length[1], 4);
}

/* Points in one cell stay as they were. */
static void one_cell(void **state) {
    (void)state;
    struct solid_bisect_item item[7];
    for (int i = 0; i < 7; i++)
        item[i] = (struct solid_bisect_item){.at = {i % 2, 0, 0}, .weight = 1, .high = {1, 1, 1}, .item = i};
    solid_bisect_order(item, 7, 1, (int[]){0, 0, 0}, -1);
    const int want[7] = {0, 2, 4, 6, 1, 3, 5};
    for (int i = 0; i < 7; i++) check_equal(item[i].item, want[i]);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_is_there_once),
                                       cmocka_unit_test(shares_are_boxes),
                                       cmocka_unit_test(sides_are_in_sites),
                                       cmocka_unit_test(uneven_layers),
                                       cmocka_unit_test(rings),
                                       cmocka_unit_test(given_first),
                                       cmocka_unit_test(one_cell)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
