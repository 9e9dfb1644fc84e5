/* The hierarchy of levels, and the cycle over them. */
#include "stokes/multigrid.h"
#include "base/memory.h"
#include "base/par.h"
#include "stokes/aggregate.h"
#include "stokes/direct.h"

#include <string.h>

enum { LEVELS = 40, DIRECT = 100 /* rows that are solved directly */, DIRECT_MAX = 1500 };
#define ONE_STEP 0.25 /* of the right-hand side is left after a step on the next level: a second step is not taken */
#define SHRINKS 0.9   /* a level that has more rows than this part of the one before is the last */

/* [size] floats each. */
struct vectors {
    float *b;      /* right-hand side */
    float *first;  /* a step of the conjugate gradients; the solution in the end */
    float *second; /* M times the first step, and then a second step */
};

struct stokes_multigrid {
    int levels;
    struct stokes_level *level[LEVELS]; /* [0] borrowed */
    struct vectors work[LEVELS];
    long rows[LEVELS]; /* of all ranks */
    struct stokes_direct *direct;
};

static void vectors_new(struct vectors *v, const struct stokes_level *l) {
    float **all[] = {&v->b, &v->first, &v->second};
    for (int k = 0; k < 3; k++) *all[k] = memory_new(MEMORY_FLUID, stokes_level_size(l), sizeof(float));
}

struct stokes_multigrid *stokes_multigrid_new(struct stokes_level *fine) {
    struct stokes_multigrid *m = memory_new(MEMORY_FLUID, 1, sizeof *m);
    m->level[0] = fine;
    m->rows[0] = par_sum_long(fine->n);
    m->levels = 1;
    while (m->rows[m->levels - 1] > DIRECT && m->levels < LEVELS) {
        const int at = m->levels++;
        m->level[at] = stokes_aggregate(m->level[at - 1]);
        m->rows[at] = par_sum_long(m->level[at]->n);
        if ((double)m->rows[at] > SHRINKS * (double)m->rows[at - 1]) break;
    }
    for (int l = 1; l < m->levels; l++) vectors_new(&m->work[l], m->level[l]);
    if (m->rows[m->levels - 1] <= DIRECT_MAX) m->direct = stokes_direct_new(m->level[m->levels - 1]);
    return m;
}

void stokes_multigrid_free(struct stokes_multigrid *m) {
    if (!m) return;
    for (int l = 1; l < m->levels; l++) {
        const struct vectors *v = &m->work[l];
        float *const all[] = {v->b, v->first, v->second};
        for (int k = 0; k < 3; k++) memory_free(all[k]);
        stokes_aggregate_free(m->level[l]);
    }
    memory_free(m->level[0]->coarse);
    m->level[0]->coarse = NULL;
    stokes_direct_free(m->direct);
    memory_free(m);
}

static double dot(int n, const float *a, const float *b) {
    double sum = 0;
    for (int i = 0; i < n; i++) sum += (double)a[i] * (double)b[i];
    return sum;
}

static void prolong(const struct stokes_level *l, const float *coarse, float *x) {
    for (int i = 0; i < l->n; i++)
        if (l->coarse[i] >= 0) x[i] += coarse[l->coarse[i]];
}

static void solve(struct stokes_multigrid *m, int at);

/* x ~ M^-1 b on a level. */
static void cycle(struct stokes_multigrid *m, int at, const float *b, float *x) {
    const struct stokes_level *l = m->level[at];
    memset(x, 0, stokes_level_size(l) * sizeof *x);
    if (at + 1 == m->levels && m->direct) {
        stokes_direct_solve(m->direct, b, x);
        stokes_level_fill(l, x);
        return;
    }
    stokes_level_sweep(l, 1, b, x);
    stokes_level_fill(l, x);
    if (at + 1 < m->levels) {
        stokes_level_restrict(l, b, x, m->level[at + 1]->n, m->work[at + 1].b);
        solve(m, at + 1);
        prolong(l, m->work[at + 1].first, x);
        stokes_level_fill(l, x);
    }
    stokes_level_sweep(l, 0, b, x);
    stokes_level_fill(l, x);
}

/* A cycle, or on the levels between one or two steps of conjugate gradients with it: M first ~ b of the level's work; b
 * is lost. */
static void solve(struct stokes_multigrid *m, int at) {
    const struct stokes_level *l = m->level[at];
    struct vectors *v = &m->work[at];
    double sum[3], more[3];
    if (at + 1 == m->levels) {
        cycle(m, at, v->b, v->first);
        return;
    }
    cycle(m, at, v->b, v->first);
    stokes_level_product(l, v->first, v->second);
    sum[0] = dot(l->n, v->first, v->second);
    sum[1] = dot(l->n, v->first, v->b);
    sum[2] = dot(l->n, v->b, v->b);
    par_sum_array(sum, 3);
    const double alpha = sum[0] > 0 ? sum[1] / sum[0] : 0;
    for (int i = 0; i < l->n; i++) v->b[i] -= (float)alpha * v->second[i];
    const double left = par_sum(dot(l->n, v->b, v->b));
    double beta = 0, gamma = alpha;
    if (left > ONE_STEP * ONE_STEP * sum[2] && sum[0] > 0) {
        cycle(m, at, v->b, v->second);
        stokes_level_energies(l, v->second, v->first, more);
        more[2] = dot(l->n, v->second, v->b);
        par_sum_array(more, 3);
        const double pivot = more[0] - more[1] * more[1] / sum[0];
        beta = pivot > 0 ? more[2] / pivot : 0;
        gamma -= more[1] / sum[0] * beta;
    }
    for (int i = 0; i < l->n; i++) v->first[i] = (float)gamma * v->first[i] + (float)beta * v->second[i];
}

void stokes_multigrid_cycle(struct stokes_multigrid *m, const float *b, float *x) { cycle(m, 0, b, x); }
