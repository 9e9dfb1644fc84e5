/* Which cells of a box are pore: a bit a cell, in lines along x. Each node holds the bits once (base/par_shared.h).
 * Pore cells are numbered in the order of the lines. */
#pragma once
#include "base/par_shared.h"

#include <stdint.h>

struct stokes_mask {
    int n[3];       /* cells along x, y, z */
    long words;     /* words of 64 cells in a line */
    uint64_t *pore; /* [n[2]][n[1]][words] 1: pore; 0 past the end of a line */
    long *before;   /* [n[1] n[2] + 1] pore cells of all lines before; set by stokes_mask_count */
    struct par_shared *shared_pore;
};

/* All solid. Collective. */
struct stokes_mask *stokes_mask_new(const int n[3]);
void stokes_mask_free(struct stokes_mask *m); /* may be NULL. Not collective. */
/* Joins what the ranks have set, and numbers the pore cells. Returns their number. Collective. */
long stokes_mask_count(struct stokes_mask *m);
/* The same box with one layer more at both ends of an axis, where the pores of the outermost cells go on. Collective.
 */
struct stokes_mask *stokes_mask_extended(const struct stokes_mask *m, int axis);

/* Faces between a pore and a solid cell across an axis, those across its sides as well. Collective. */
long stokes_mask_surface(const struct stokes_mask *m, int axis);
/* The numbers of pore cells at the low and at the high side across an axis, and of those that are pore at both. Not
 * collective, as all below. */
struct stokes_mask_overlap {
    long low, high, both;
};
struct stokes_mask_overlap stokes_mask_overlap(const struct stokes_mask *m, int axis);
/* The share of the pores' area that is pore at both of two periodic sides of `cells` cells; NaN: there are no pores.
 * is_cut: 1: the pores do not continue across the sides, as in a sample that was cut from a larger one: the share is
 * less than nine tenths, and less than halfway from that of two unrelated sides to 1. */
double stokes_mask_overlap_share(const struct stokes_mask_overlap *q, double cells, int *is_cut);
static inline long stokes_mask_line(const struct stokes_mask *m, int j, int k) { return (long)k * m->n[1] + j; }
static inline int stokes_mask_is(const struct stokes_mask *m, int i, int j, int k) {
    return (int)(m->pore[stokes_mask_line(m, j, k) * m->words + i / 64] >> i % 64 & 1);
}
/* While other ranks may set other bits of the word. */
static inline void stokes_mask_set(const struct stokes_mask *m, int i, int j, int k) {
    uint64_t *word = m->pore + stokes_mask_line(m, j, k) * m->words + i / 64;
    __atomic_fetch_or(word, (uint64_t)1 << i % 64, __ATOMIC_RELAXED);
}
/* The number of a pore cell. */
static inline long stokes_mask_number(const struct stokes_mask *m, int i, int j, int k) {
    const long line = stokes_mask_line(m, j, k);
    const uint64_t *word = m->pore + line * m->words;
    long sum = m->before[line];
    for (int w = 0; w < i / 64; w++) sum += __builtin_popcountll(word[w]);
    return sum + __builtin_popcountll(word[i / 64] & (((uint64_t)1 << i % 64) - 1));
}
/* The cell of a number, 0 <= number < all. */
void stokes_mask_find(const struct stokes_mask *m, long number, int at[3]);
/* The next pore cell after `at`. There must be one. */
void stokes_mask_next(const struct stokes_mask *m, int at[3]);
