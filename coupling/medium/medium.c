/* Measurement box of a porous medium, and the solid fraction of every cell in it. */
#include "coupling/medium/medium.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_exchange.h"
#include "base/par_halo.h"
#include "coupling/medium/parts.h"

#include <math.h>
#include <string.h>

/* Part of cell i (of width d) inside [low, high]. */
static double part_inside(int i, double d, double low, double high) {
    const double part = fmin(high / d, i + 1.0) - fmax(low / d, i);
    return part < MEDIUM_SNAP ? 0 : part > 1 - MEDIUM_SNAP ? 1 : part;
}

struct medium *medium_new(const struct fluid_grid *g, const double low[3], const double high[3]) {
    struct medium *m = memory_new(MEMORY_COUPLING, 1, sizeof *m);
    m->g = g;
    m->total = 1;
    m->reach = 1;
    for (int c = 0; c < 3; c++) {
        const double L = g->length[c];
        m->low[c] = fmax(low[c], 0);
        m->high[c] = fmin(high[c], L);
        m->weight[c] = memory_new(MEMORY_COUPLING, (size_t)g->m[c], sizeof(double));
        for (int i = 0; i < g->m[c]; i++) m->weight[c][i] = part_inside(g->lo[c] + i, g->d[c], m->low[c], m->high[c]);
        double along = 0;
        m->first[c] = -1;
        for (int i = 0; i < g->n[c]; i++) {
            const double part = part_inside(i, g->d[c], m->low[c], m->high[c]);
            along += part;
            if (part > 0) m->last[c] = i;
            if (part > 0 && m->first[c] < 0) m->first[c] = i;
        }
        if (!(along > 0))
            die_all(EXIT_CODE_SCENE,
                    "coupling.medium: the box from %g to %g m along %c has nothing in the domain, 0 to %g m", low[c],
                    high[c], "xyz"[c], L);
        m->total *= along;
        m->whole_period[c] = g->periodic[c] && along == g->n[c];
    }
    const size_t cells = (size_t)g->m[0] * (size_t)g->m[1] * (size_t)g->m[2];
    const size_t rimmed = (size_t)(g->m[0] + 2) * (size_t)(g->m[1] + 2) * (size_t)(g->m[2] + 2);
    m->fraction = memory_new(MEMORY_COUPLING, g->size, sizeof(double));
    m->carry = memory_new(MEMORY_COUPLING, g->size, sizeof(double));
    m->cell = memory_new(MEMORY_COUPLING, rimmed, sizeof(uint8_t));
    memset(m->cell, MEDIUM_WALL, rimmed);
    m->effective = -1;
    m->stack = memory_new(MEMORY_COUPLING, cells, sizeof(int));
    const int most = g->n[0] > g->n[1] ? g->n[0] : g->n[1];
    m->section = memory_new(MEMORY_COUPLING, (size_t)(g->n[2] > most ? g->n[2] : most), sizeof(double));
    medium_along(m, (const double[3]){1, 0, 0});
    return m;
}

void medium_along(struct medium *m, const double along[3]) {
    const double length = sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    m->axis = 0;
    for (int c = 0; c < 3; c++) {
        m->along[c] = along[c] / length;
        if (fabs(along[c]) > fabs(along[m->axis])) m->axis = c;
    }
    m->slanted = 0;
    for (int c = 0; c < 3; c++) m->slanted |= c != m->axis && along[c] != 0;
    m->effective = -1;
    memset(m->cell, MEDIUM_WALL, (size_t)(m->g->m[0] + 2) * (size_t)(m->g->m[1] + 2) * (size_t)(m->g->m[2] + 2));
}

double medium_extent(const struct medium *m) {
    double sum = 0;
    for (int c = 0; c < 3; c++) sum += fabs(m->along[c]) * (m->high[c] - m->low[c]);
    return sum;
}

int medium_is_across(const struct medium *m) {
    int whole = 1;
    for (int c = 0; c < 3; c++)
        if (c != m->axis) whole &= m->high[c] - m->low[c] >= m->g->length[c] - MEDIUM_SNAP * m->g->d[c];
    return whole;
}

int medium_axis(const struct medium *m) { return m->axis; }

int medium_is_whole_period(const struct medium *m, int c) { return m->whole_period[c]; }

void medium_pores_only(struct medium *m) { m->pores_only = 1; }

void medium_reach(struct medium *m, double cells) { m->reach = fmax(1, cells); }

void medium_freeze(struct medium *m) {
    par_exchange_free(m->exchange);
    MEMORY_FREE(m->dest, m->mine, m->served);
    m->exchange = NULL;
    m->dest = NULL;
    m->mine = m->served = NULL;
    m->capacity = m->served_capacity = 0;
}

void medium_free(struct medium *m) {
    if (!m) return;
    par_exchange_free(m->exchange);
    for (int c = 0; c < 3; c++) memory_free(m->weight[c]);
    MEMORY_FREE(m->fraction, m->spread, m->carry, m->cell, m->stack, m->section, m->dest, m->mine, m->served, m);
}

/* The rank that deposits the cube: that of the cell of its centre, or of the nearest cell if the centre is outside the
 * domain. -1: the cube is wholly outside. */
static inline int rank_of_cube(const struct fluid_grid *g, struct medium_cube *q) {
    double x[3];
    for (int c = 0; c < 3; c++) {
        const double L = g->length[c], half = 0.5 * q->side;
        if (!isfinite(q->x[c])) return -1;
        if (g->periodic[c]) {
            q->x[c] -= L * floor(q->x[c] / L);
            if (q->x[c] >= L) q->x[c] = 0;
            x[c] = q->x[c];
        } else {
            if (q->x[c] + half <= 0 || q->x[c] - half >= L) return -1;
            const double low = 0.5 * g->d[c], high = L - 0.5 * g->d[c];
            x[c] = q->x[c] < low ? low : q->x[c] > high ? high : q->x[c];
        }
    }
    return fluid_grid_rank_of(g, x);
}

/* Where cubes are surely this rank's, without a look at the other ranks' cells: the bounds of its cells less a margin,
 * m.
 */
struct own {
    double low[3], high[3];
    int rank;
};

static struct own own_of(const struct fluid_grid *g) {
    struct own own = {.rank = par_rank()};
    for (int c = 0; c < 3; c++) {
        own.low[c] = (g->lo[c] + MEDIUM_SNAP) * g->d[c];
        own.high[c] = (g->lo[c] + g->m[c] - MEDIUM_SNAP) * g->d[c];
    }
    return own;
}

static inline int is_own(const struct own *own, const double x[3]) {
    int is = 1;
    for (int c = 0; c < 3; c++) is &= x[c] > own->low[c] && x[c] < own->high[c];
    return is;
}

static void particles_reserve(struct medium *m, int n) {
    if (n <= m->capacity && m->capacity > 0) return;
    MEMORY_FREE(m->dest, m->mine);
    m->capacity = n + n / 8 + 1;
    m->dest = memory_new(MEMORY_COUPLING, (size_t)m->capacity, sizeof *m->dest);
    m->mine = memory_new(MEMORY_COUPLING, (size_t)m->capacity, sizeof *m->mine);
    m->particles = -1;
}

/* Fills m->mine and m->dest. Returns the number of ghost layers that the largest cube reaches. Collective. */
static int particles_plan(struct medium *m, int n, const double *const x[3], const double *volume) {
    const struct fluid_grid *g = m->g;
    particles_reserve(m, n);
    const double narrow = fmin(g->d[0], fmin(g->d[1], g->d[2]));
    const struct own own = own_of(g);
    double found[2] = {m->exchange == NULL || m->particles != n,
                       0};             /* 1: a new plan is needed; the largest half side in cells */
    double last_volume = -1, side = 0; /* most particles have equal volumes */
    for (int h = 0; h < n; h++) {
        struct medium_cube *q = &m->mine[h];
        for (int c = 0; c < 3; c++) q->x[c] = x[c][h];
        if (volume[h] != last_volume) {
            last_volume = volume[h];
            side = cbrt(last_volume);
            found[1] = fmax(found[1], 0.5 * side / narrow);
        }
        q->side = side;
        const int dest = is_own(&own, q->x) ? own.rank : rank_of_cube(g, q);
        if (m->particles != n || dest != m->dest[h]) found[0] = 1;
        m->dest[h] = dest;
    }
    m->particles = n;
    par_max_array(found, 2);
    if (found[0] > 0) {
        par_exchange_free(m->exchange);
        m->exchange = par_exchange_new(n, m->dest);
        const int served = par_exchange_count(m->exchange);
        if (served > m->served_capacity || !m->served) {
            memory_free(m->served);
            m->served_capacity = served + served / 8 + 1;
            m->served = memory_new(MEMORY_COUPLING, (size_t)m->served_capacity, sizeof *m->served);
        }
    }
    if (found[1] > g->halo)
        die_all(EXIT_CODE_SCENE, "solid: a particle is %g cells wide; its volume can be spread over %d cells at most",
                2 * found[1], 2 * g->halo);
    return (int)fmax(1, ceil(found[1] - MEDIUM_SNAP));
}

/* Adds the cubes that this rank serves to f, up to so many ghost layers. */
static void lay_cubes(const struct medium *m, double *f, int layers) {
    const struct fluid_grid *g = m->g;
    int first[3], last[3];
    for (int c = 0; c < 3; c++) first[c] = -layers, last[c] = g->m[c] + layers;
    const int served = par_exchange_count(m->exchange);
    for (int q = 0; q < served; q++) {
        double low[3], high[3];
        for (int c = 0; c < 3; c++) {
            const double s = m->served[q].x[c] / g->d[c] - g->lo[c], half = 0.5 * m->served[q].side / g->d[c];
            low[c] = s - half, high[c] = s + half;
        }
        medium_kernels_deposit(low, high, first, last, g->row, g->plane, f);
    }
}

/* The same with the volume of each spread by the forcing's kernel. */
static void spread_cubes(const struct medium *m, double *f) {
    const struct fluid_grid *g = m->g;
    const int served = par_exchange_count(m->exchange);
    for (int q = 0; q < served; q++) {
        double s[3], side[3];
        for (int c = 0; c < 3; c++) {
            s[c] = fmin(fmax(m->served[q].x[c] / g->d[c], g->lo[c]), g->lo[c] + g->m[c] - MEDIUM_SNAP);
            side[c] = m->served[q].side / g->d[c];
        }
        medium_kernels_spread(g, s, side, f);
    }
}

static void sum_ghosts(const struct fluid_grid *g, double **q, int layers) {
    par_halo_add(g->halos, 1, q, layers);
    par_halo_fill(g->halos, 1, q, 1);
}

void medium_deposit(struct medium *m, int n, const double *const x[3], const double *volume) {
    clock_begin(CLOCK_OUTPUT);
    const int layers = particles_plan(m, n, x, volume);
    par_exchange_forward(m->exchange, m->mine, m->served, sizeof *m->mine);
    memset(m->fraction, 0, m->g->size * sizeof(double));
    lay_cubes(m, m->fraction + fluid_grid_at(m->g, 0, 0, 0), layers);
    sum_ghosts(m->g, &m->fraction, layers);
    m->effective = -1;
    clock_end(CLOCK_OUTPUT);
}

const double *medium_spread(struct medium *m, int n, const double *const x[3], const double *volume) {
    particles_plan(m, n, x, volume);
    par_exchange_forward(m->exchange, m->mine, m->served, sizeof *m->mine);
    if (!m->spread) m->spread = memory_new(MEMORY_COUPLING, m->g->size, sizeof(double));
    memset(m->spread, 0, m->g->size * sizeof(double));
    spread_cubes(m, m->spread + fluid_grid_at(m->g, 0, 0, 0));
    sum_ghosts(m->g, &m->spread, MEDIUM_SPREAD_REACH);
    return m->spread;
}

const double *medium_fraction(const struct medium *m) { return m->fraction; }
