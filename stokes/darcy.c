/* The Darcy operator and its solution. */
#include "stokes/darcy.h"
#include "base/memory.h"
#include "base/par.h"
#include "stokes/multigrid.h"

#include <string.h>

enum { CYCLES_MAX = 200 };

struct stokes_darcy {
    const struct stokes_cells *cells;
    uint16_t (*phi)[3];
    struct stokes_level fine;
    struct stokes_multigrid *multigrid;
};

struct stokes_darcy *stokes_darcy_new(const struct stokes_cells *cells, float (*phi)[3]) {
    struct stokes_darcy *d = memory_new(MEMORY_FLUID, 1, sizeof *d);
    const double *edge = cells->g->in.d;
    d->cells = cells;
    d->phi = memory_new(MEMORY_FLUID, stokes_cells_size(cells), sizeof *d->phi);
    for (size_t i = 0; i < stokes_cells_size(cells); i++)
        for (int c = 0; c < 3; c++) d->phi[i][c] = stokes_level_upper(phi[i][c]);
    memory_free(phi);
    d->fine = (struct stokes_level){.n = cells->n,
                                    .ghosts = cells->ghosts,
                                    .first = cells->first,
                                    .ghost = cells->ghost,
                                    .next = (const int(*)[6])cells->next,
                                    .phi = (const uint16_t(*)[3])d->phi};
    for (int c = 0; c < 3; c++) d->fine.scale[c] = (float)(1 / (edge[c] * edge[c]));
    d->fine.inverse = memory_new(MEMORY_FLUID, (size_t)cells->n + 1, sizeof(float));
    for (int i = 0; i < cells->n; i++) {
        struct stokes_level_row row;
        float sum = 0;
        stokes_level_row_of(&d->fine, i, &row);
        for (int e = 0; e < row.n; e++) sum += row.weight[e];
        d->fine.inverse[i] = sum > 0 ? 1 / sum : 0;
    }
    for (int k = 0; k < cells->outside; k++) d->fine.inverse[cells->of_outside[k]] = 0;
    d->multigrid = stokes_multigrid_new(&d->fine);
    return d;
}

void stokes_darcy_free(struct stokes_darcy *d) {
    if (!d) return;
    stokes_multigrid_free(d->multigrid);
    MEMORY_FREE(d->phi, d->fine.inverse, d);
}

void stokes_darcy_force(const struct stokes_darcy *d, int c, float *b) {
    const float edge = (float)d->cells->g->in.d[c];
    for (int i = 0; i < d->cells->n; i++)
        b[i] = (stokes_level_phi(d->phi[d->cells->next[i][2 * c]][c]) - stokes_level_phi(d->phi[i][c])) / edge;
    for (int k = 0; k < d->cells->outside; k++) b[d->cells->of_outside[k]] = 0;
}

static double dot(int n, const float *a, const float *b) {
    double sum = 0;
    for (int i = 0; i < n; i++) sum += (double)a[i] * (double)b[i];
    return sum;
}

int stokes_darcy_solve(struct stokes_darcy *d, double tolerance, float *b, float *x, float *const work[3]) {
    const struct stokes_level *l = &d->fine;
    const size_t size = stokes_level_size(l);
    float *z = work[0], *s = work[1], *q = work[2];
    double before = 0, gain = 1, all = 0;
    int k = 0;
    memset(x, 0, size * sizeof *x);
    memset(s, 0, size * sizeof *s);
    for (; k < CYCLES_MAX && gain > tolerance * tolerance * all; k++) {
        double sum[2];
        stokes_multigrid_cycle(d->multigrid, b, z);
        sum[0] = dot(l->n, z, b);
        sum[1] = k > 0 ? dot(l->n, z, q) : 0;
        par_sum_array(sum, 2);
        const double beta =
            k > 0 ? -sum[1] / before : 0; /* z is not M-orthogonal to s by itself: cycles are nonlinear */
        for (size_t i = 0; i < size; i++) s[i] = z[i] + (float)beta * s[i];
        stokes_level_product(l, s, q);
        double more[2] = {dot(l->n, s, q), dot(l->n, s, b)};
        par_sum_array(more, 2);
        if (!(more[0] > 0)) break;
        const float alpha = (float)(more[1] / more[0]);
        for (size_t i = 0; i < size; i++) x[i] += alpha * s[i];
        for (int i = 0; i < l->n; i++) b[i] -= alpha * q[i];
        before = more[0];
        gain = more[1] * more[1] / more[0];
        all += gain;
    }
    return k;
}
