/* Aggregation of the rows of a matrix, and the matrix of the aggregates. */
#include "stokes/aggregate.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/sort.h"

#include <stdlib.h>
#include <string.h>

#define STRONG 0.25F   /* of the largest weight of a row */
#define SLOW 0.35      /* of a level's rows: more of them on the next one, and single rows join pairs */
#define ROUND_OFF 1e-5 /* of a sum of weights: what a diagonal has beyond its row's weights is 0 below it */

/* Joins rows of this rank in pairs. Sets coarse [n]; returns the number of pairs and single rows. A row without
 * neighbours is left out: a sweep solves it. */
static int pair_rows(const struct stokes_level *l, int *coarse) {
    int pairs = 0;
    for (int i = 0; i < l->n; i++) coarse[i] = -2;
    for (int i = 0; i < l->n; i++) {
        struct stokes_level_row row;
        if (coarse[i] != -2) continue;
        stokes_level_row_of(l, i, &row);
        if (row.n == 0 || !(l->inverse[i] > 0)) {
            coarse[i] = -1;
            continue;
        }
        int best = -1;
        float most = 0, of_best = 0;
        for (int e = 0; e < row.n; e++) {
            const int j = row.column[e];
            most = row.weight[e] > most ? row.weight[e] : most;
            if (j >= l->n || coarse[j] != -2 || !(l->inverse[j] > 0) || row.weight[e] <= of_best) continue;
            best = j;
            of_best = row.weight[e];
        }
        coarse[i] = pairs;
        if (best >= 0 && of_best >= STRONG * most) coarse[best] = pairs;
        pairs++;
    }
    return pairs;
}

/* Rows that stayed single though they have a strong neighbour join its pair: around a wide pore many narrow ones end,
 * of which a pair takes only one. Numbers the aggregates again; returns how many there are. */
static int join_single(const struct stokes_level *l, int *coarse, int aggregates) {
    int *rows = memory_new(MEMORY_FLUID, (size_t)aggregates + 1, sizeof *rows), n = 0;
    for (int i = 0; i < l->n; i++)
        if (coarse[i] >= 0) rows[coarse[i]]++;
    for (int i = 0; i < l->n; i++) {
        struct stokes_level_row row;
        if (coarse[i] < 0 || rows[coarse[i]] != 1) continue;
        int best = -1;
        float most = 0;
        stokes_level_row_of(l, i, &row);
        for (int e = 0; e < row.n; e++)
            if (row.weight[e] > most) {
                most = row.weight[e];
                best = row.column[e];
            }
        if (best < 0 || best >= l->n || coarse[best] < 0 || rows[coarse[best]] < 2) continue;
        rows[coarse[i]] = 0;
        coarse[i] = coarse[best];
    }
    for (int a = 0; a < aggregates; a++) rows[a] = rows[a] ? n++ : -1;
    for (int i = 0; i < l->n; i++)
        if (coarse[i] >= 0) coarse[i] = rows[coarse[i]];
    memory_free(rows);
    return n;
}

/* Rows by aggregate: those of aggregate a are order[at[a]] .. order[at[a + 1] - 1]. */
struct groups {
    int *at, *order;
};

static struct groups groups_of(int n, const int *coarse, int aggregates) {
    struct groups g = {memory_new(MEMORY_FLUID, (size_t)aggregates + 2, sizeof(int)),
                       memory_new(MEMORY_FLUID, (size_t)n + 1, sizeof(int))};
    for (int i = 0; i < n; i++)
        if (coarse[i] >= 0) g.at[coarse[i] + 2]++;
    for (int a = 0; a < aggregates; a++) g.at[a + 2] += g.at[a + 1];
    for (int i = 0; i < n; i++)
        if (coarse[i] >= 0) g.order[g.at[coarse[i] + 1]++] = i;
    return g;
}

/* The rows of the aggregates. to [n + ghosts of fine]: the coarse column of each fine one, -1: dropped; columns: their
 * number. The diagonal is the sum of the entries that the aggregates hold. */
static void add_rows(const struct stokes_level *fine, struct stokes_level *l, const int *to, int columns) {
    const struct groups g = groups_of(fine->n, to, l->n);
    int *place = memory_new(MEMORY_FLUID, (size_t)columns + 1, sizeof *place), entries = 0, capacity = 8 * l->n + 64;
    l->start = memory_new(MEMORY_FLUID, (size_t)l->n + 1, sizeof *l->start);
    l->inverse = memory_new(MEMORY_FLUID, (size_t)l->n + 1, sizeof *l->inverse);
    l->extra = memory_new(MEMORY_FLUID, (size_t)l->n + 1, sizeof *l->extra);
    l->column = memory_new(MEMORY_FLUID, (size_t)capacity, sizeof *l->column);
    l->weight = memory_new(MEMORY_FLUID, (size_t)capacity, sizeof *l->weight);
    for (int c = 0; c < columns; c++) place[c] = -1;
    for (int a = 0; a < l->n; a++) {
        double diagonal = 0, all = 0;
        for (int k = g.at[a]; k < g.at[a + 1]; k++) {
            struct stokes_level_row row;
            const int i = g.order[k];
            stokes_level_row_of(fine, i, &row);
            all += 1 / (double)fine->inverse[i];
            if (entries + row.n > capacity) {
                const int more = capacity + capacity / 2 + row.n;
                l->column = memory_grown(MEMORY_FLUID, l->column, (size_t)entries, (size_t)more, sizeof *l->column);
                l->weight = memory_grown(MEMORY_FLUID, l->weight, (size_t)entries, (size_t)more, sizeof *l->weight);
                capacity = more;
            }
            for (int e = 0; e < row.n; e++) {
                const int c = to[row.column[e]];
                if (c == a) diagonal -= (double)row.weight[e];
                if (c < 0 || c == a) continue;
                if (place[c] < l->start[a]) {
                    place[c] = entries++;
                    l->column[place[c]] = c;
                    l->weight[place[c]] = 0;
                }
                l->weight[place[c]] += row.weight[e];
            }
        }
        l->start[a + 1] = entries;
        double sum = 0;
        for (int e = l->start[a]; e < entries; e++) sum += (double)l->weight[e];
        diagonal += all;
        if (diagonal - sum < ROUND_OFF * all) diagonal = sum;
        l->extra[a] = (float)(diagonal - sum);
        l->inverse[a] = diagonal > 0 ? (float)(1 / diagonal) : 0;
    }
    MEMORY_FREE(place, g.at, g.order);
    l->column = memory_grown(MEMORY_FLUID, l->column, (size_t)entries, (size_t)entries + 1, sizeof *l->column);
    l->weight = memory_grown(MEMORY_FLUID, l->weight, (size_t)entries, (size_t)entries + 1, sizeof *l->weight);
}

/* The columns of other ranks: asks them for their aggregates, and numbers these after the own ones. */
static void find_ghosts(const struct stokes_level *fine, struct stokes_level *l, int *to) {
    const size_t size = (size_t)fine->n + (size_t)fine->ghosts + 1;
    long *number = memory_new(MEMORY_FLUID, size, sizeof *number),
         *sorted = memory_new(MEMORY_FLUID, (size_t)fine->ghosts + 1, sizeof *sorted);
    int n = 0;
    for (int i = 0; i < fine->n; i++) number[i] = to[i] < 0 ? -1 : l->first[par_rank()] + to[i];
    par_ghost_update_records(fine->ghost, sizeof *number, number, fine->n);
    for (int g = 0; g < fine->ghosts; g++)
        if (number[fine->n + g] >= 0) sorted[n++] = number[fine->n + g];
    l->ghosts = (int)sort_unique(sorted, n);
    for (int g = 0; g < fine->ghosts; g++) {
        const long wanted = number[fine->n + g];
        to[fine->n + g] = wanted < 0 ? -1 : l->n + (int)sort_find(sorted, l->ghosts, wanted);
    }
    to[fine->n + fine->ghosts] = -1;
    l->ghost = par_ghost_new(l->first, l->ghosts, sorted);
    MEMORY_FREE(number, sorted);
}

static void number_all(struct stokes_level *l) {
    const int size = par_size();
    const long n = l->n;
    l->first = memory_new(MEMORY_FLUID, (size_t)size + 1, sizeof *l->first);
    par_all_gather(&n, sizeof n, l->first + 1);
    for (int r = 0; r < size; r++) l->first[r + 1] += l->first[r];
}

struct stokes_level *stokes_aggregate(struct stokes_level *fine) {
    struct stokes_level *l = memory_new(MEMORY_FLUID, 1, sizeof *l), between = {0};
    const size_t size = stokes_level_size(fine);
    int *to = memory_new(MEMORY_FLUID, size, sizeof *to);
    between.n = pair_rows(fine, to);
    for (size_t k = (size_t)fine->n; k < size; k++) to[k] = -1;
    add_rows(fine, &between, to, between.n);
    int *second = memory_new(MEMORY_FLUID, (size_t)between.n + 1, sizeof *second);
    l->n = pair_rows(&between, second);
    if (l->n > SLOW * fine->n) l->n = join_single(&between, second, l->n);
    for (int i = 0; i < between.n; i++)
        if (second[i] < 0) second[i] = l->n++; /* its neighbours are on other ranks, or in its own pair alone */
    fine->coarse = memory_new(MEMORY_FLUID, (size_t)fine->n + 1, sizeof *fine->coarse);
    for (int i = 0; i < fine->n; i++) fine->coarse[i] = to[i] = to[i] < 0 ? -1 : second[to[i]];
    MEMORY_FREE(second, between.start, between.column, between.weight, between.inverse, between.extra);
    number_all(l);
    find_ghosts(fine, l, to);
    add_rows(fine, l, to, l->n + l->ghosts);
    memory_free(to);
    return l;
}

void stokes_aggregate_free(struct stokes_level *l) {
    if (!l) return;
    par_ghost_free(l->ghost);
    MEMORY_FREE(l->first, l->start, l->column, l->weight, l->inverse, l->extra, l->coarse, l);
}
