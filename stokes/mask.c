/* The bits of pore cells, and their numbers. */
#include "stokes/mask.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_piece.h"
#include "base/sort.h"

#include <math.h>

struct stokes_mask *stokes_mask_new(const int n[3]) {
    struct stokes_mask *m = memory_new(MEMORY_FLUID, 1, sizeof *m);
    for (int c = 0; c < 3; c++) m->n[c] = n[c];
    m->words = (n[0] + 63) / 64;
    m->shared_pore = par_shared_new(MEMORY_FLUID, (size_t)m->words * (size_t)n[1] * (size_t)n[2] * sizeof *m->pore);
    m->pore = m->shared_pore->data;
    m->before = memory_new(MEMORY_FLUID, (size_t)n[1] * (size_t)n[2] + 1, sizeof *m->before);
    return m;
}

void stokes_mask_free(struct stokes_mask *m) {
    if (!m) return;
    par_shared_free(m->shared_pore);
    MEMORY_FREE(m->before, m);
}

long stokes_mask_count(struct stokes_mask *m) {
    const long lines = (long)m->n[1] * m->n[2];
    par_shared_unite(m->shared_pore);
    for (long l = 0; l < lines; l++) {
        long sum = 0;
        for (long w = 0; w < m->words; w++) sum += __builtin_popcountll(m->pore[l * m->words + w]);
        m->before[l + 1] = m->before[l] + sum;
    }
    return m->before[lines];
}

struct stokes_mask *stokes_mask_extended(const struct stokes_mask *m, int axis) {
    int n[3] = {m->n[0], m->n[1], m->n[2]};
    n[axis] += 2;
    struct stokes_mask *to = stokes_mask_new(n);
    const int first = par_piece_low(n[2], par_size(), par_rank()),
              last = par_piece_low(n[2], par_size(), par_rank() + 1);
    for (int k = first; k < last; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++) {
                int at[3] = {i, j, k};
                at[axis] = at[axis] == 0 ? 0 : at[axis] == n[axis] - 1 ? m->n[axis] - 1 : at[axis] - 1;
                if (stokes_mask_is(m, at[0], at[1], at[2])) stokes_mask_set(to, i, j, k);
            }
    stokes_mask_count(to);
    return to;
}

void stokes_mask_find(const struct stokes_mask *m, long number, int at[3]) {
    const long low = sort_find(m->before, (long)m->n[1] * m->n[2], number);
    at[0] = -1;
    at[1] = (int)(low % m->n[1]);
    at[2] = (int)(low / m->n[1]);
    for (long left = number - m->before[low]; left >= 0; left--) stokes_mask_next(m, at);
}

void stokes_mask_next(const struct stokes_mask *m, int at[3]) {
    long line = stokes_mask_line(m, at[1], at[2]), w = (at[0] + 1) / 64;
    uint64_t word = w < m->words ? m->pore[line * m->words + w] & ~(uint64_t)0 << (at[0] + 1) % 64 : 0;
    while (!word) {
        if (++w >= m->words) w = 0, line++;
        word = m->pore[line * m->words + w];
    }
    at[0] = (int)(64 * w) + __builtin_ctzll(word);
    at[1] = (int)(line % m->n[1]);
    at[2] = (int)(line / m->n[1]);
}

struct stokes_mask_overlap stokes_mask_overlap(const struct stokes_mask *m, int axis) {
    struct stokes_mask_overlap sum = {0};
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int q = 0; q < m->n[a]; q++)
        for (int r = 0; r < m->n[b]; r++) {
            int at[3] = {0};
            at[a] = q;
            at[b] = r;
            const int low = stokes_mask_is(m, at[0], at[1], at[2]);
            at[axis] = m->n[axis] - 1;
            const int high = stokes_mask_is(m, at[0], at[1], at[2]);
            sum.low += low;
            sum.high += high;
            sum.both += low && high;
        }
    return sum;
}

double stokes_mask_overlap_share(const struct stokes_mask_overlap *q, double cells, int *is_cut) {
    static const double ENOUGH = 0.9, LEAST = 0.5;
    const double pores = 0.5 * (double)(q->low + q->high);
    *is_cut = 0;
    if (!(pores > 0)) return NAN;
    const double share = (double)q->both / pores, chance = (double)q->low * (double)q->high / (cells * pores);
    *is_cut = share < ENOUGH && share - chance < LEAST * fmax(1 - chance, 1e-9);
    return share;
}

long stokes_mask_surface(const struct stokes_mask *m, int axis) {
    const int first = par_piece_low(m->n[2], par_size(), par_rank()),
              last = par_piece_low(m->n[2], par_size(), par_rank() + 1);
    long sum = 0;
    for (int k = first; k < last; k++)
        for (int j = 0; j < m->n[1]; j++)
            for (int i = 0; i < m->n[0]; i++) {
                int to[3] = {i, j, k};
                to[axis] = (to[axis] + 1) % m->n[axis];
                sum += stokes_mask_is(m, i, j, k) != stokes_mask_is(m, to[0], to[1], to[2]);
            }
    return par_sum_long(sum);
}
