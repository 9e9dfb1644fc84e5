/* Makes, numbers and walks the bricks of a body's lattice sites. */
#include "solid/body/bricks.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/geometry/bisect.h"

#include <stdlib.h>
#include <string.h>

/* The first cut is across z, along which the fluid is divided first, then y, if it has few more ghosts than the best
 * one: at most a 25th of the particles, and not more than twice as many, as a ring's second border gives. The
 * direction does not depend on the number of ranks, because a run may be resumed on any number. */
enum { PART = 25, TIMES = 2 };
enum { REACH = 3 }; /* layers of ghosts: the usual horizon, spacings */

static size_t bricks_of(struct solid_sites *sites) {
    for (int c = 0; c < 3; c++)
        sites->bricks[c] = c == 0 ? sites->rows[c] : (sites->rows[c] + SOLID_ROW - 1) / SOLID_ROW;
    return (size_t)sites->bricks[0] * (size_t)sites->bricks[1] * (size_t)sites->bricks[2];
}

int solid_bricks_shift(const long *layer, int n) {
    long all = 0, before = 0, nearest = -1;
    int plane = 0;
    for (int k = 0; k < n; k++) all += layer[k];
    for (int k = 0; k < n; k++) {
        before += layer[k];
        if (nearest >= 0 && labs(2 * before - all) >= nearest) continue;
        nearest = labs(2 * before - all);
        plane = k + 1;
    }
    return (SOLID_ROW - plane % SOLID_ROW) % SOLID_ROW;
}

void solid_bricks_new(struct solid_sites *sites) {
    sites->bits = memory_new(MEMORY_SOLID, bricks_of(sites), SOLID_BRICK);
}

void solid_bricks_share(struct solid_sites *sites) {
    sites->map = par_shared_new(MEMORY_SOLID, bricks_of(sites) * SOLID_BRICK);
    sites->bits = sites->map->data;
}

/* Particles in the first rows of a brick. */
static long count_rows(const struct solid_sites *sites, size_t brick, int rows) {
    const uint8_t *bits = sites->bits + brick * SOLID_BRICK;
    long n = 0;
    int r = 0;
    for (uint64_t eight; r + 8 <= rows; r += 8) {
        memcpy(&eight, bits + r, sizeof eight);
        n += __builtin_popcountll(eight);
    }
    for (; r < rows; r++) n += __builtin_popcount(bits[r]);
    return n;
}

/* The brick as an item of the order: its weight is its rows with a particle, which a sweep goes through. Returns
 * whether it has any. */
static int item_of(const struct solid_sites *sites, int b, struct solid_bisect_item *item) {
    const uint8_t *bits = sites->bits + (size_t)b * SOLID_BRICK;
    unsigned in_x = 0, in_y = 0, in_z = 0;
    *item = (struct solid_bisect_item){
        .at = {b % sites->bricks[0], b / sites->bricks[0] % sites->bricks[1], b / sites->bricks[0] / sites->bricks[1]},
        .item = b};
    for (int r = 0; r < SOLID_BRICK; r++) {
        if (!bits[r]) continue;
        in_x |= bits[r];
        in_y |= 1u << r % SOLID_ROW;
        in_z |= 1u << r / SOLID_ROW;
        item->weight++;
    }
    const unsigned in[3] = {in_x, in_y, in_z};
    for (int c = 0; c < 3 && item->weight > 0; c++) {
        item->low[c] = (uint8_t)__builtin_ctz(in[c]);
        item->high[c] = (uint8_t)(32 - __builtin_clz(in[c]));
    }
    return item->weight > 0;
}

/* Sites from the lowest to the highest one of these bricks. */
static int length_of(const struct solid_bisect_item *item, int n, int c) {
    int low = 0, high = 0;
    for (int q = 0; q < n; q++) {
        const int from = SOLID_ROW * item[q].at[c] + item[q].low[c], to = SOLID_ROW * item[q].at[c] + item[q].high[c];
        if (q == 0 || from < low) low = from;
        if (q == 0 || to > high) high = to;
    }
    return high - low;
}

/* Particles in each layer of sites along c, from the first brick's corner. Returns how many layers. */
static int layers_of(const struct solid_sites *sites, const struct solid_bisect_item *item, int n, int c, long *layer) {
    for (int q = 0; q < n; q++) {
        const uint8_t *bits = sites->bits + (size_t)item[q].item * SOLID_BRICK;
        for (int r = 0; r < SOLID_BRICK; r++) {
            const int place[3] = {0, r % SOLID_ROW, r / SOLID_ROW}, at = SOLID_ROW * item[q].at[c] + place[c];
            if (c > 0) layer[at] += __builtin_popcount(bits[r]);
            for (unsigned in = c > 0 ? 0 : bits[r]; in; in &= in - 1) layer[at + __builtin_ctz(in)]++;
        }
    }
    return SOLID_ROW * sites->bricks[c];
}

static long sum(const long *layer, int layers, int from, int to) {
    long all = 0;
    for (int k = from < 0 ? 0 : from; k < to && k < layers; k++) all += layer[k];
    return all;
}

/* Ghosts of two ranks if the body is cut across c, at the plane of bricks nearest to a half: the particles within a
 * horizon of it, and of a ring those at its two ends, which touch. */
static long ghosts_of(const long *layer, int layers, int is_ring) {
    const long all = sum(layer, layers, 0, layers);
    int plane = SOLID_ROW, low = 0, high = layers;
    for (int k = SOLID_ROW; k < layers; k += SOLID_ROW)
        if (labs(2 * sum(layer, layers, 0, k) - all) < labs(2 * sum(layer, layers, 0, plane) - all)) plane = k;
    while (low < layers && layer[low] == 0) low++;
    while (high > low && layer[high - 1] == 0) high--;
    return sum(layer, layers, plane - REACH, plane + REACH) +
           (is_ring ? sum(layer, layers, low, low + REACH) + sum(layer, layers, high - REACH, high) : 0);
}

int solid_bricks_first_cut(const long ghosts[3], long particles) {
    long fewest = -1;
    for (int c = 0; c < 3; c++)
        if (ghosts[c] >= 0 && (fewest < 0 || ghosts[c] < fewest)) fewest = ghosts[c];
    for (int c = 2; c >= 0; c--) {
        const int is_like_fewest = ghosts[c] <= TIMES * fewest && (ghosts[c] - fewest) * PART <= particles;
        if (ghosts[c] >= 0 && is_like_fewest) return c;
    }
    return -1;
}

/* The direction of the body's first cut. */
static int first_cut(const struct solid_sites *sites, const struct solid_bisect_item *item, int n,
                     const int is_ring[3]) {
    long ghosts[3] = {-1, -1, -1}, particles = 0;
    for (int c = 0; c < 3; c++) {
        if (sites->bricks[c] < 2) continue;
        long *layer = memory_new(MEMORY_SOLID, (size_t)sites->bricks[c] * SOLID_ROW, sizeof *layer);
        const int layers = layers_of(sites, item, n, c, layer);
        particles = sum(layer, layers, 0, layers);
        ghosts[c] = ghosts_of(layer, layers, is_ring[c]);
        memory_free(layer);
    }
    return solid_bricks_first_cut(ghosts, particles);
}

/* The bricks with a particle, by halves; returns how many. */
static int sort_bricks(const struct solid_sites *sites, int bricks, struct solid_bisect_item **item) {
    struct solid_bisect_item one;
    int n = 0, is_ring[3];
    for (int b = 0; b < bricks; b++) n += count_rows(sites, (size_t)b, SOLID_BRICK) > 0;
    *item = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof **item);
    n = 0;
    for (int b = 0; b < bricks; b++)
        if (item_of(sites, b, &one)) (*item)[n++] = one;
    for (int c = 0; c < 3; c++) is_ring[c] = sites->wrap[c] > 0 && sites->wrap[c] - length_of(*item, n, c) < SOLID_ROW;
    solid_bisect_order(*item, n, SOLID_ROW, is_ring, first_cut(sites, *item, n, is_ring));
    return n;
}

/* Allocates the arrays of numbers. If the ranks of a node share the map, one of them counts the bricks with a
 * particle. */
static void numbers_new(struct solid_sites *sites, size_t bricks) {
    if (!sites->map) {
        sites->order = memory_new(MEMORY_SOLID, (size_t)sites->ordered + 1, sizeof *sites->order);
        sites->start = memory_new(MEMORY_SOLID, bricks, sizeof *sites->start);
        return;
    }
    par_bcast(&sites->ordered, sizeof sites->ordered, 0);
    sites->numbers =
        par_shared_new(MEMORY_SOLID, bricks * sizeof *sites->start + (size_t)sites->ordered * sizeof *sites->order);
    sites->start = sites->numbers->data;
    sites->order = (int *)(sites->start + bricks);
}

void solid_bricks_number(struct solid_sites *sites) {
    const int bricks = sites->bricks[0] * sites->bricks[1] * sites->bricks[2];
    const int is_mine = !sites->map || sites->map->is_writer;
    struct solid_bisect_item *item = NULL;
    if (is_mine) sites->ordered = sort_bricks(sites, bricks, &item);
    numbers_new(sites, (size_t)bricks);
    long id = sites->first;
    for (int q = 0; is_mine && q < sites->ordered; q++) {
        const int b = (int)item[q].item;
        sites->order[q] = b;
        sites->start[b] = id;
        id += count_rows(sites, (size_t)b, SOLID_BRICK);
    }
    if (sites->map) par_shared_fence(sites->numbers);
    memory_free(item);
}

int solid_bricks_next(const struct solid_sites *sites, struct solid_bricks_walk *w) {
    for (; w->brick < sites->ordered; w->brick++, w->row = 0) {
        const int b = sites->order[w->brick];
        if (w->row == 0) w->next = sites->start[b];
        for (; w->row < SOLID_BRICK; w->row++) {
            w->bits = sites->bits[(size_t)b * SOLID_BRICK + (size_t)w->row];
            if (!w->bits) continue;
            w->site[0] = sites->low[0] + SOLID_ROW * (b % sites->bricks[0]);
            w->site[1] = sites->low[1] + SOLID_ROW * (b / sites->bricks[0] % sites->bricks[1]) + w->row % SOLID_ROW;
            w->site[2] = sites->low[2] + SOLID_ROW * (b / sites->bricks[0] / sites->bricks[1]) + w->row / SOLID_ROW;
            w->id = w->next;
            w->next += __builtin_popcount(w->bits);
            w->row++;
            return 1;
        }
    }
    return 0;
}

long solid_bricks_id(const struct solid_sites *sites, const int at[3]) {
    const size_t row = solid_bricks_row(sites, at[0] / SOLID_ROW, at[1], at[2]), brick = row / SOLID_BRICK;
    const unsigned bit = 1u << at[0] % SOLID_ROW;
    if (!(sites->bits[row] & bit)) return -1;
    return sites->start[brick] + count_rows(sites, brick, (int)(row % SOLID_BRICK)) +
           __builtin_popcount(sites->bits[row] & (bit - 1));
}
