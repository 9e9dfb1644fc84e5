/* The preconditioner of the pressures: polynomials of the flow, on the particles and on bricks of them. */
#include "cracks/precondition.h"
#include "base/par.h"
#include "cracks/coarse.h"
#include "cracks/solve.h"
#include "cracks/struts.h"
#include "physics/chebyshev.h"

#include <math.h>

/* On the particles alone the polynomial is made for eigenvalues over a span of at most SPAN_MAX. Where the span is
 * wider than SPAN_FEW the bricks are taken, if they are of use. With them it is made for what varies within a brick:
 * the square of its side. */
static const double SPAN_FEW = 64, SPAN_MAX = 240;
/* The number of terms over sqrt(span). Fewer leave more iterations, each with two sweeps over the struts; more cost
 * more than they save. */
static const double TERMS = 2, TERMS_BRICKS = 1.75;

enum { TERMS_MAX = 16 }; /* without bricks */

static double mass_of(const struct cracks *c, double dt, int i) {
    return c->storage[i] + dt * dt * c->struts.diagonal[i];
}

/* The matrix of the bricks. Uses along and z. */
static void bricks_begin(const struct cracks *c, double dt) {
    const struct cracks_struts *t = &c->struts;
    const struct cracks_rows *r = &t->rows;
    struct cracks_work *w = c->work;
    for (int i = 0; i < t->n; i++) { /* A 1 has the flow to particles that are not full */
        w->along[i] = w->of_ones[i] - w->ones_stiff[i] + dt * dt * t->diagonal[i];
        w->z[i] = w->set[i] == CRACKS_FULL;
    }
    cracks_struts_update(t, sizeof *w->z, w->z);
    for (int i = 0; i < t->n + t->ghosts; i++) r->x[t->place[i]] = w->z[i];
    cracks_coarse_begin(w->coarse, c, dt, w->along, r->x);
}

void cracks_precondition_begin(struct cracks *c, double dt) {
    const struct cracks_struts *t = &c->struts;
    struct cracks_work *w = c->work;
    double sum[2] = {0, 0};
    for (int i = 0; i < t->n; i++) {
        const int full = w->set[i] == CRACKS_FULL;
        const double mass = mass_of(c, dt, i);
        w->diagonal[i] = mass + dt * w->outflow[t->slot[i]];
        w->weight[t->slot[i]] = full && w->diagonal[i] > 0 ? 1 / w->diagonal[i] : 0;
        sum[0] += full ? mass : 0;
        sum[1] += full ? w->diagonal[i] : 0;
    }
    par_sum_array(sum, 2);
    w->span = sum[0] > 0 ? 2 * sum[1] / sum[0] : 2;
    w->bricks = w->span > SPAN_FEW && w->coarse->useful;
    w->span = w->bricks ? w->coarse->side * w->coarse->side : fmin(w->span, SPAN_MAX);
    const int terms = (int)ceil((w->bricks ? TERMS_BRICKS : TERMS) * sqrt(w->span));
    w->terms = terms < TERMS_MAX || w->bricks ? terms : TERMS_MAX;
    const long links = t->rows.n > 0 ? CRACKS_LANES * t->rows.link_start[t->rows.n] : 0;
    for (long k = 0; k < links; k++) w->smooth[k] = (float)w->conductance[k];
    if (w->bricks) bricks_begin(c, dt);
}

static void relax(const struct cracks *c, double dt, double keep, double gain, double *x, double *next) {
    const struct cracks_rows *r = &c->struts.rows;
    const struct cracks_work *w = c->work;
    cracks_struts_update_near(&c->struts, w->z, x);
    cracks_kernel_relax(r->n, r->first, r->link_start, r->link_start + 1, r->link, w->smooth, dt, keep, gain, w->left,
                        w->weight, x, w->change, next);
}

/* Terms of Chebyshev's iteration from x on; the first one is done if begun. */
static void smooth(const struct cracks *c, double dt, int begun, double **x, double **next) {
    const struct cracks_work *w = c->work;
    struct physics_chebyshev chebyshev = physics_chebyshev_of(2 / w->span, 2);
    if (begun) physics_chebyshev_next(&chebyshev);
    for (int term = begun; term < w->terms; term++) {
        physics_chebyshev_next(&chebyshev);
        relax(c, dt, chebyshev.keep, chebyshev.gain, *x, *next);
        double *const before = *x;
        *x = *next;
        *next = before;
    }
}

/* x += what the bricks find for the residual of x. */
static void add_slow(const struct cracks *c, double dt, double *x, double *next) {
    const struct cracks_struts *t = &c->struts;
    const struct cracks_work *w = c->work;
    struct cracks_coarse *b = w->coarse;
    relax(c, dt, 0, 1, x, next); /* change is D^-1 times the residual */
    for (int q = 0; q < b->bricks; q++) b->residual[q] = 0;
    for (int i = 0; i < t->n; i++) b->residual[b->brick[i]] += w->diagonal[i] * w->change[t->slot[i]];
    cracks_coarse_solve(b);
    for (int i = 0; i < t->n; i++)
        if (w->set[i] == CRACKS_FULL) x[t->place[i]] += b->x[b->brick[i]];
}

/* P z = r, P = D - dt T: A with a diagonal elastic part. */
void cracks_precondition(const struct cracks *c, double dt) {
    const struct cracks_struts *t = &c->struts;
    const struct cracks_rows *r = &t->rows;
    struct cracks_work *w = c->work;
    const double first = 1 / physics_chebyshev_of(2 / w->span, 2).middle;
    double *x = r->x, *next = r->u[0];
    for (int i = 0; i < t->n; i++) w->left[t->slot[i]] = w->residual[i];
    cracks_kernel_scale(r->n, r->first, first, w->left, w->weight, w->change, x);
    smooth(c, dt, 1, &x, &next);
    if (w->bricks) {
        add_slow(c, dt, x, next);
        smooth(c, dt, 0, &x, &next);
    }
    for (int i = 0; i < t->n; i++) w->z[i] = x[t->place[i]];
}
