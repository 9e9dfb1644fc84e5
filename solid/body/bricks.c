/* Makes, numbers and walks the bricks of a body's lattice sites. */
#include "solid/body/bricks.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/geometry/curve.h"

#include <stdlib.h>
#include <string.h>

struct keyed {
    uint64_t key;
    int brick;
};

static int by_key(const void *a, const void *b) {
    const struct keyed *x = a, *y = b;
    return (x->key > y->key) - (x->key < y->key);
}

static size_t bricks_of(struct solid_sites *sites) {
    for (int c = 0; c < 3; c++)
        sites->bricks[c] = c == 0 ? sites->rows[c] : (sites->rows[c] + SOLID_ROW - 1) / SOLID_ROW;
    return (size_t)sites->bricks[0] * (size_t)sites->bricks[1] * (size_t)sites->bricks[2];
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

/* The bricks with a particle in the order of the curve; returns how many. */
static int sort_bricks(const struct solid_sites *sites, int bricks, struct keyed *key) {
    int n = 0;
    for (int b = 0; b < bricks; b++) {
        const uint32_t at[3] = {(uint32_t)(b % sites->bricks[0]), (uint32_t)(b / sites->bricks[0] % sites->bricks[1]),
                                (uint32_t)(b / sites->bricks[0] / sites->bricks[1])};
        if (count_rows(sites, (size_t)b, SOLID_BRICK) > 0) key[n++] = (struct keyed){solid_curve_key(at, 3), b};
    }
    qsort(key, (size_t)n, sizeof *key, by_key);
    return n;
}

/* The arrays of numbers; of a shared map one of its writers tells how many bricks have a particle. */
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
    struct keyed *key = is_mine ? memory_new(MEMORY_SOLID, (size_t)bricks, sizeof *key) : NULL;
    if (is_mine) sites->ordered = sort_bricks(sites, bricks, key);
    numbers_new(sites, (size_t)bricks);
    long id = sites->first;
    for (int q = 0; is_mine && q < sites->ordered; q++) {
        const int b = key[q].brick;
        sites->order[q] = b;
        sites->start[b] = id;
        id += count_rows(sites, (size_t)b, SOLID_BRICK);
    }
    if (sites->map) par_shared_fence(sites->numbers);
    memory_free(key);
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
