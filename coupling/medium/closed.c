/* The parts of the pore space without a way out, and what moving solid displaces into each of them. */
/* Each rank joins its own cells to pieces and numbers them. Pieces that meet across the ranks' faces take the lesser
 * number, again and again, until none changes: then all pieces of a part have one number, and its sums are those of all
 * pieces with it. */
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_halo.h"
#include "coupling/medium/parts.h"

#include <limits.h>
#include <math.h>
#include <string.h>

void medium_closed_mark(const struct medium *m, const double v[3], double *const velocity[3]) {
    const struct fluid_grid *g = m->g;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) {
                const size_t at = fluid_grid_at(g, i, j, k);
                for (int c = 0; c < 3 && !medium_kernels_is_pore(m->fraction[at]); c++) velocity[c][at] = v[c];
            }
    par_halo_fill(g->halos, 3, velocity, 1);
}

struct faces {
    double rate, size; /* m3/s: displaced into the cell by moving solid beyond its faces; its magnitude */
};

/* Of cell i,j,k, which is fluid. */
static struct faces faces_of(const struct fluid_grid *g, const double *const velocity[3], int i, int j, int k) {
    const ptrdiff_t stride[3] = {1, g->row, g->plane};
    const size_t at = fluid_grid_at(g, i, j, k);
    struct faces f = {0};
    for (int c = 0; c < 3; c++) {
        const double area = g->d[(c + 1) % 3] * g->d[(c + 2) % 3];
        const double low = velocity[c][(ptrdiff_t)at - stride[c]], high = velocity[c][(ptrdiff_t)at + stride[c]];
        f.rate += area * (low - high);
        f.size += area * (fabs(low) + fabs(high));
    }
    return f;
}

double medium_closed_fronts(const struct medium *m, const double *const velocity[3], double *net) {
    const struct fluid_grid *g = m->g;
    double sum[2] = {0};
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) {
                const size_t at = fluid_grid_at(g, i, j, k);
                if (velocity[0][at] != 0 || velocity[1][at] != 0 || velocity[2][at] != 0) continue;
                const struct faces f = faces_of(g, velocity, i, j, k);
                sum[0] += f.size;
                if (medium_kernels_is_pore(m->fraction[at])) sum[1] += f.rate;
            }
    par_sum_array(sum, 2);
    *net = sum[1];
    return 0.5 * sum[0];
}

/* The pieces of this rank's cells that the flood from the outlets has not reached. */
struct pieces {
    int n;
    int *piece_of; /* [mz+2][my+2][mx+2] piece of a cell, from 1; 0: none */
    long *number;  /* [n + 1] */
};

/* Joins the cells that are connected with one of them, within the rank. */
static void join(const struct medium *m, struct pieces *p, int from) {
    const int row = m->g->m[0] + 2, plane = row * (m->g->m[1] + 2);
    const int neighbour[6] = {-1, 1, -row, row, -plane, plane};
    int n = 0;
    p->piece_of[from] = p->n;
    m->stack[n++] = from;
    while (n > 0) {
        const int at = m->stack[--n];
        for (int b = 0; b < 6; b++) {
            const int to = at + neighbour[b];
            if (m->cell[to] != MEDIUM_PORE || p->piece_of[to] > 0) continue;
            p->piece_of[to] = p->n;
            m->stack[n++] = to;
        }
    }
}

static struct pieces pieces_new(const struct medium *m) {
    const size_t rimmed = (size_t)(m->g->m[0] + 2) * (size_t)(m->g->m[1] + 2) * (size_t)(m->g->m[2] + 2);
    struct pieces p = {.piece_of = memory_new(MEMORY_COUPLING, rimmed, sizeof *p.piece_of)};
    for (size_t at = 0; at < rimmed; at++) {
        if (m->cell[at] != MEDIUM_PORE || p.piece_of[at] > 0) continue;
        p.n++;
        join(m, &p, (int)at);
    }
    p.number = memory_new(MEMORY_COUPLING, (size_t)p.n + 1, sizeof *p.number);
    const long before = par_sum_before(p.n);
    for (int l = 1; l <= p.n; l++) p.number[l] = before + l;
    return p;
}

static void pieces_free(struct pieces *p) { MEMORY_FREE(p->piece_of, p->number); }

/* Gives a piece a number if that is less. */
static int lower(struct pieces *p, int l, double number) {
    if (l == 0 || !(number > 0) || !(number < (double)p->number[l])) return 0;
    p->number[l] = (long)number;
    return 1;
}

/* Takes the lesser numbers beyond one side across y (c = 1) or z (c = 2) from the ghosts of m->carry. */
static int lower_across(const struct medium *m, struct pieces *p, int c, int high) {
    const struct fluid_grid *g = m->g;
    const int other = 3 - c, own = high ? g->m[c] - 1 : 0, ghost = high ? g->m[c] : -1;
    int changed = 0;
    for (int t = 0; t < g->m[other]; t++)
        for (int i = 0; i < g->m[0]; i++) {
            const int at = c == 1 ? medium_rimmed(g, i, own, t) : medium_rimmed(g, i, t, own);
            const size_t from = c == 1 ? fluid_grid_at(g, i, ghost, t) : fluid_grid_at(g, i, t, ghost);
            changed |= lower(p, p->piece_of[at], m->carry[from]);
        }
    return changed;
}

/* The same across the periodic side of x, both ends of which the rank holds. */
static int lower_over_x(const struct medium *m, struct pieces *p) {
    const struct fluid_grid *g = m->g;
    int changed = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const int low = p->piece_of[medium_rimmed(g, 0, j, k)],
                      high = p->piece_of[medium_rimmed(g, g->m[0] - 1, j, k)];
            if (low == 0 || high == 0) continue;
            changed |= lower(p, low, (double)p->number[high]) | lower(p, high, (double)p->number[low]);
        }
    return changed;
}

static void number_parts(struct medium *m, struct pieces *p) {
    const struct fluid_grid *g = m->g;
    long changed;
    do {
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++) {
                    const int l = p->piece_of[medium_rimmed(g, i, j, k)];
                    m->carry[fluid_grid_at(g, i, j, k)] = l > 0 ? (double)p->number[l] : 0;
                }
        par_halo_fill(g->halos, 1, &m->carry, 1);
        changed = 0;
        for (int c = 1; c < 3; c++)
            for (int high = 0; high < 2; high++)
                if (g->periodic[c] || !medium_at_end(g, c, high)) changed |= lower_across(m, p, c, high);
        if (g->periodic[0]) changed |= lower_over_x(m, p);
    } while (par_sum_long(changed) > 0);
}

long medium_closed_parts(struct medium *m, const int outlets[3][2], const double *const velocity[3],
                         struct medium_part **part) {
    enum { SUMS = sizeof **part / sizeof(double) };
    const struct fluid_grid *g = m->g;
    medium_cut_off_flood(m, outlets, g->periodic);
    struct pieces p = pieces_new(m);
    number_parts(m, &p);
    const long all = par_sum_long(p.n);
    ENSURE(all < INT_MAX / SUMS, "%ld pieces", all);
    struct medium_part *sum = memory_new(MEMORY_COUPLING, (size_t)all + 1, sizeof *sum);
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) {
                const int l = p.piece_of[medium_rimmed(g, i, j, k)];
                if (l == 0) continue;
                const struct faces f = faces_of(g, velocity, i, j, k);
                struct medium_part *to = &sum[p.number[l] - 1];
                to->volume += g->d[0] * g->d[1] * g->d[2];
                to->rate += f.rate;
                to->faces += f.size;
            }
    par_sum_array(&sum[0].volume, SUMS * (int)all);
    long n = 0;
    for (long k = 0; k < all; k++)
        if (sum[k].volume > 0) sum[n++] = sum[k];
    pieces_free(&p);
    memset(m->cell, MEDIUM_WALL, (size_t)(g->m[0] + 2) * (size_t)(g->m[1] + 2) * (size_t)(g->m[2] + 2));
    m->effective = -1;
    *part = sum;
    return n;
}
