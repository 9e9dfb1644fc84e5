/* Conjugate gradients for the pressure. */
#include "stokes/solve.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "stokes/darcy.h"
#include "stokes/kernels.h"
#include "stokes/viscous.h"

#include <math.h>
#include <string.h>

#define START_TOLERANCE 0.01   /* of the first pressure, M p = G^T phi f */
#define DARCY_TOLERANCE 0.3    /* of a solution with M within an iteration */
#define VISCOUS_TOLERANCE 0.03 /* of a solution with A */
#define VISCOUS_LOOSE 0.1      /* the same, where k is asked for with an error of LOOSE or more */
#define LOOSE 1e-3
#define ROUND 1e-3 /* of the error is left by a round of iterations: A is not solved well enough for more */
#define SAFETY 3   /* the error of k is r.S^-1 r; 1 + M^-1 is above S^-1 divided by this */
#define OFF 10     /* entries off the diagonal are off by the root of what u lacks */
#define ENOUGH 0.3 /* a round ends at this part of the error that is allowed: what A leaves adds to it */
enum { ROUNDS_MAX = 30, ITERATIONS_MAX = 8 /* of a round */ };

/* What an iteration keeps, [size] floats: the direction d and y = G^T A^-1 G d, which stands where the viscous solver's
 * right-hand side was, which is used up. */
struct vectors {
    float *d, *y;
};

/* Places in the arrays of the viscous solver that are free while the Darcy operator is solved. */
struct borrowed {
    float *z, *b, *work[3];
};

static struct borrowed borrow(const struct stokes *s) {
    const size_t size = stokes_cells_size(s->cells);
    float *e = (float *)s->viscous->e, *v = (float *)s->viscous->v;
    return (struct borrowed){(float *)s->viscous->s, v, {e, e + size, e + 2 * size}};
}

static double viscous_tolerance(const struct stokes *s) {
    return s->g.in.tolerance < LOOSE ? VISCOUS_TOLERANCE : VISCOUS_LOOSE;
}

static const int (*next_of(const struct stokes *s))[6] { return (const int(*)[6])s->cells->next; }
static const uint8_t (*kind_of(const struct stokes *s))[3] { return (const uint8_t(*)[3])s->faces->kind; }

static double dot(int n, const float *a, const float *b) {
    double sum = 0;
    for (int i = 0; i < n; i++) sum += (double)a[i] * (double)b[i];
    return sum;
}

static void close_outside(const struct stokes *s, float *q) {
    for (int k = 0; k < s->cells->outside; k++) q[s->cells->of_outside[k]] = 0;
}

/* Corrects u for the present p: u += A^-1 (f - G p - A u). Returns the energy of the correction. */
static double correct_velocity(struct stokes *s, int axis) {
    struct stokes_viscous *v = s->viscous;
    const struct stokes_faces *f = s->faces;
    const double force[3] = {axis == 0, axis == 1, axis == 2}, of_halves = axis == s->g.axis;
    const double(*u)[3] = (const double(*)[3])s->u;
    stokes_kernels_momentum(s->cells->n, next_of(s), kind_of(s), (const double(*)[256])f->diagonal, s->g.in.d, force,
                            s->p, u, v->r);
    stokes_kernels_momentum_halves(f->halves, f->half, s->g.axis, next_of(s), (const double(*)[256])f->diagonal,
                                   kind_of(s), s->g.in.d, of_halves, s->p, u, v->r);
    const double energy = stokes_viscous_solve(v, viscous_tolerance(s));
    for (size_t i = 0; i < stokes_cells_size(s->cells); i++)
        for (int c = 0; c < 3; c++) s->u[i][c] += (double)v->e[i][c];
    return energy;
}

/* r = G^T u */
static void divergence(const struct stokes *s, float *r) {
    stokes_kernels_divergence(s->cells->n, next_of(s), s->g.in.d, (const double(*)[3])s->u, r);
    close_outside(s, r);
}

/* z = r + M^-1 r, in the borrowed place, with r = G^T u, which is in b in the end; returns r.z. */
static double precondition(struct stokes *s, struct stokes_effort *effort) {
    const struct borrowed borrowed = borrow(s);
    divergence(s, borrowed.b);
    effort->cycles += stokes_darcy_solve(s->darcy, DARCY_TOLERANCE, borrowed.b, borrowed.z, borrowed.work);
    divergence(s, borrowed.b); /* the solution loses it */
    for (int i = 0; i < s->cells->n; i++) borrowed.z[i] += borrowed.b[i];
    stokes_cells_fill(s->cells, sizeof *borrowed.z, borrowed.z);
    return par_sum(dot(s->cells->n, borrowed.b, borrowed.z));
}

/* A step along d = z + beta d. Returns d.S d. */
static double step(struct stokes *s, const struct vectors *w, double beta) {
    const size_t size = stokes_cells_size(s->cells);
    const float *z = borrow(s).z;
    struct stokes_viscous *v = s->viscous;
    for (size_t i = 0; i < size; i++) w->d[i] = z[i] + (float)beta * w->d[i];
    double sum[2] = {0, dot(s->cells->n, w->d, borrow(s).b)};
    stokes_kernels_gradient(s->cells->n, next_of(s), kind_of(s), s->g.in.d, w->d, v->r);
    stokes_viscous_solve(v, viscous_tolerance(s));
    stokes_kernels_divergence_float(s->cells->n, next_of(s), s->g.in.d, (const float(*)[3])v->e, w->y);
    close_outside(s, w->y);
    sum[0] = dot(s->cells->n, w->d, w->y);
    par_sum_array(sum, 2);
    const double alpha = sum[0] > 0 ? sum[1] / sum[0] : 0;
    for (size_t i = 0; i < size; i++) {
        s->p[i] += alpha * (double)w->d[i];
        for (int c = 0; c < 3; c++) s->u[i][c] -= alpha * (double)v->e[i][c];
    }
    return sum[0];
}

/* The pressure of Darcy's flow, and no velocity. */
static void start(struct stokes *s, int axis, struct stokes_effort *effort) {
    const size_t size = stokes_cells_size(s->cells);
    const struct borrowed borrowed = borrow(s);
    stokes_darcy_force(s->darcy, axis, borrowed.b);
    effort->cycles += stokes_darcy_solve(s->darcy, START_TOLERANCE, borrowed.b, borrowed.z, borrowed.work);
    for (size_t i = 0; i < size; i++) s->p[i] = (double)borrowed.z[i];
    memset(s->u, 0, size * sizeof *s->u);
}

static double flow_of(const struct stokes *s, int c) {
    double sum = 0;
    for (int i = 0; i < s->cells->n; i++) sum += s->u[i][c] * (stokes_faces_is_half(s->faces->kind[i][c]) ? 0.5 : 1);
    return par_sum(sum);
}

/* Sums of u over the faces, and of u less p G^T u for those pressures that are known. To those of the axis belongs
 * u.(f - G p - A u), which the viscous solver has left. */
static void sums_of(const struct stokes *s, int axis, double sum[3], double better[3]) {
    memset(sum, 0, 3 * sizeof *sum);
    memset(better, 0, 3 * sizeof *better);
    for (int i = 0; i < s->cells->n; i++) {
        double r = 0;
        for (int c = 0; c < 3; c++) r += (s->u[s->cells->next[i][2 * c]][c] - s->u[i][c]) / s->g.in.d[c];
        for (int c = 0; c < 3; c++) {
            sum[c] += s->u[i][c] * (stokes_faces_is_half(s->faces->kind[i][c]) ? 0.5 : 1);
            better[axis] += s->u[i][c] * (double)s->viscous->r[i][c];
            if (s->pressure[c]) better[c] -= (double)s->pressure[c][i] * r;
        }
    }
    for (int c = 0; c < 3; c++) better[c] += sum[c];
    par_sum_array(sum, 3);
    par_sum_array(better, 3);
}

/* The tensor's column: by a p and a u of which either is off by little, an entry is off by the product of both. */
static void set_column(struct stokes *s, int axis) {
    const size_t size = stokes_cells_size(s->cells);
    double sum[3], better[3];
    if (!s->pressure[axis]) s->pressure[axis] = memory_new(MEMORY_FLUID, size, sizeof(float));
    for (size_t i = 0; i < size; i++) s->pressure[axis][i] = (float)s->p[i];
    sums_of(s, axis, sum, better);
    s->tensor[axis][axis] = better[axis] / s->volume;
    for (int c = 0; c < 3; c++) {
        if (c == axis || !s->pieces.percolates[c]) continue; /* there it is 0 */
        s->tensor[c][axis] = (s->pressure[c] && s->g.axis < 0 ? better[c] : sum[c]) / s->volume;
        if (s->pressure[c] && s->g.axis < 0) s->tensor[axis][c] = s->tensor[c][axis];
    }
}

/* starts: 1: from Darcy's flow; 0: from the present u and p. */
static struct stokes_effort solve(struct stokes *s, int axis, int starts) {
    struct stokes_effort effort = {.seconds = -par_seconds()};
    const size_t size = stokes_cells_size(s->cells);
    const long before = s->viscous->products;
    const double tolerance = s->g.in.tolerance;
    ENSURE(s->cells && s->pieces.percolates[axis], "no pores lead through along %c", "xyz"[axis]);
    const struct vectors w = {memory_new(MEMORY_FLUID, size, sizeof(float)), (float *)s->viscous->r};
    if (starts) start(s, axis, &effort);
    for (int round = 0; round < ROUNDS_MAX && !effort.stopped; round++) {
        double of_u, flow, beta = 0;
        correct_velocity(s, axis);
        flow = fabs(flow_of(s, axis));
        const double remaining = precondition(s, &effort);
        of_u = s->viscous->left / flow;
        effort.error = SAFETY * remaining / flow + of_u;
        if (effort.error <= tolerance && of_u <= OFF * tolerance * tolerance) break;
        const double enough = fmax(ENOUGH / SAFETY * tolerance * flow, ROUND * remaining);
        double left = SAFETY * remaining <= tolerance * flow ? 0 : remaining; /* then u alone is not good enough */
        for (int k = 0; k < ITERATIONS_MAX && left > enough && !effort.stopped; k++, effort.outer++) {
            const double curvature = step(s, &w, beta);
            left = precondition(s, &effort);
            beta = curvature > 0 ? -par_sum(dot(s->cells->n, borrow(s).z, w.y)) / curvature : 0;
            effort.stopped = s->g.in.stops && s->g.in.stops(s->g.in.with);
        }
    }
    memory_free(w.d);
    set_column(s, axis);
    effort.products = s->viscous->products - before;
    effort.seconds += par_seconds();
    return effort;
}

struct stokes_effort stokes_solve(struct stokes *s, int axis) {
    return solve(s, axis, 1);
}

struct stokes_effort stokes_solve_on(struct stokes *s, int axis) {
    return solve(s, axis, 0);
}
