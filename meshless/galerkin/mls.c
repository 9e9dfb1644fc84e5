/* Moving least squares: bins of nodes, moment matrix, shape functions, the mean of two bases. */
#include "meshless/galerkin/mls.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "meshless/galerkin/cut.h"
#include "meshless/galerkin/weight.h"

#include <math.h>

enum { TERMS = 7 };

static int bin_of(const struct galerkin_bins *b, int c, double x) {
    const int i = (int)floor((x - b->low[c]) / b->size);
    return i < 0 ? 0 : i >= b->n[c] ? b->n[c] - 1 : i;
}

void meshless_mls_bins(struct galerkin *g) {
    struct galerkin_bins *b = &g->bins;
    double high[2] = {-INFINITY, -INFINITY};
    b->low[0] = b->low[1] = INFINITY;
    for (int i = 0; i < g->in.nodes; i++)
        for (int c = 0; c < 2; c++) {
            b->low[c] = fmin(b->low[c], g->in.node[i][c]);
            high[c] = fmax(high[c], g->in.node[i][c]);
        }
    b->size = g->widest;
    for (int c = 0; c < 2; c++) b->n[c] = 1 + (int)floor((high[c] - b->low[c]) / b->size);
    const int bins = b->n[0] * b->n[1];
    b->first = memory_new(MEMORY_SOLID, (size_t)bins + 1, sizeof *b->first);
    b->node = memory_new(MEMORY_SOLID, (size_t)g->in.nodes, sizeof *b->node);
    for (int pass = 0; pass < 2; pass++) {
        for (int i = g->in.nodes - 1; i >= 0; i--) {
            const int at = bin_of(b, 1, g->in.node[i][1]) * b->n[0] + bin_of(b, 0, g->in.node[i][0]);
            if (pass == 0)
                b->first[at]++;
            else
                b->node[--b->first[at]] = i;
        }
        if (pass == 0)
            for (int k = 1; k <= bins; k++) b->first[k] += b->first[k - 1];
    }
}

/* The tip's functions are sqrt(r) f(angle). */
static int angular(enum galerkin_basis basis, double t, double f[4], double df[4]) {
    switch (basis) {
    case GALERKIN_LINEAR:
        return 0;
    case GALERKIN_SQRT_R:
        f[0] = 1;
        df[0] = 0;
        return 1;
    case GALERKIN_TIP: {
        const double c = cos(t / 2), s = sin(t / 2), C = cos(t), S = sin(t);
        f[0] = c, df[0] = -s / 2;
        f[1] = s, df[1] = c / 2;
        f[2] = s * S, df[2] = c * S / 2 + s * C;
        f[3] = c * S, df[3] = -s * S / 2 + c * C;
        return 4;
    }
    }
    ENSURE(0, "basis %d", (int)basis);
}

int meshless_mls_functions(enum galerkin_basis basis, const struct galerkin_tip *tip, const double x[2],
                           const double see[2], double *value, double (*gradient)[2]) {
    double r, t, f[4], df[4];
    meshless_cut_polar(tip, x, see, &r, &t);
    const int n = angular(basis, t, f, df);
    const double root = sqrt(r), c = cos(t), s = sin(t), over = root > 0 ? 1 / root : 0;
    for (int k = 0; k < n; k++) {
        value[k] = root * f[k];
        if (!gradient) continue;
        const double along = over * (0.5 * f[k] * c - df[k] * s), across = over * (0.5 * f[k] * s + df[k] * c);
        gradient[k][0] = along * tip->along[0] - across * tip->along[1];
        gradient[k][1] = along * tip->along[1] + across * tip->along[0];
    }
    return n;
}

/* The basis about a place. */
struct local_basis {
    int terms;
    double h, scale;                 /* of the linear functions, and of the tip's */
    double value[4], gradient[4][2]; /* of the tip's functions at the place */
    int tangent;                     /* 1: minus the tangent plane */
};

static void basis_begin(const struct galerkin *g, const struct galerkin_place *at, int tip, double h,
                        struct local_basis *b, double p[TERMS], double dp[TERMS][2]) {
    *b = (struct local_basis){.terms = 3, .h = h};
    for (int k = 0; k < TERMS; k++) p[k] = dp[k][0] = dp[k][1] = 0;
    p[0] = 1;
    dp[1][0] = dp[2][1] = 1 / b->h;
    if (tip < 0) return;
    const struct galerkin_tip *its = &g->tip[tip];
    const double r = hypot(at->x[0] - its->x[0], at->x[1] - its->x[1]);
    const int n = meshless_mls_functions(g->in.basis, its, at->x, at->see, b->value, b->gradient);
    b->terms += n;
    b->tangent = r > 0.25 * h;
    b->scale = b->tangent ? 1 / (b->h * b->h / (r * sqrt(r))) : 1 / sqrt(b->h);
    for (int k = 0; k < n && !b->tangent; k++) {
        p[3 + k] = b->scale * b->value[k];
        for (int c = 0; c < 2; c++) dp[3 + k][c] = b->scale * b->gradient[k][c];
    }
}

static void basis_at(const struct galerkin *g, const struct galerkin_place *at, int tip, const struct local_basis *b,
                     const double x[2], double p[TERMS]) {
    const double dx = x[0] - at->x[0], dy = x[1] - at->x[1];
    p[0] = 1;
    p[1] = dx / b->h;
    p[2] = dy / b->h;
    if (tip < 0) return;
    double value[4];
    const int n = meshless_mls_functions(g->in.basis, &g->tip[tip], x, x, value, NULL);
    for (int k = 0; k < n; k++)
        p[3 + k] =
            b->scale * (value[k] - (b->tangent ? b->value[k] + b->gradient[k][0] * dx + b->gradient[k][1] * dy : 0));
}

/* Cholesky factor of a symmetric matrix in place; 0 if it is singular to rounding. */
static int factor(int n, double m[TERMS][TERMS]) {
    for (int j = 0; j < n; j++) {
        const double diagonal = m[j][j];
        for (int k = 0; k < j; k++) m[j][j] -= m[j][k] * m[j][k];
        if (!(m[j][j] > 1e-11 * diagonal)) return 0;
        m[j][j] = sqrt(m[j][j]);
        for (int i = j + 1; i < n; i++) {
            for (int k = 0; k < j; k++) m[i][j] -= m[i][k] * m[j][k];
            m[i][j] /= m[j][j];
        }
    }
    return 1;
}

static void solve(int n, double m[TERMS][TERMS], double x[TERMS]) {
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++) x[i] -= m[i][k] * x[k];
        x[i] /= m[i][i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) x[i] -= m[k][i] * x[k];
        x[i] /= m[i][i];
    }
}

/* The nodes that the place sees, their weights and the weights' gradients; the least radius among them in *h. */
static enum meshless_mls_fault gather(const struct galerkin *g, const struct galerkin_place *at,
                                      struct galerkin_shape *shape, double weight[GALERKIN_NEAR],
                                      double dw[GALERKIN_NEAR][2], double *h) {
    const struct galerkin_bins *b = &g->bins;
    const int low[2] = {bin_of(b, 0, at->x[0] - g->widest), bin_of(b, 1, at->x[1] - g->widest)};
    const int high[2] = {bin_of(b, 0, at->x[0] + g->widest), bin_of(b, 1, at->x[1] + g->widest)};
    shape->n = 0;
    *h = g->widest;
    for (int j = low[1]; j <= high[1]; j++)
        for (int k = b->first[j * b->n[0] + low[0]]; k < b->first[j * b->n[0] + high[0] + 1]; k++) {
            double gradient[2], dwds;
            const int node = b->node[k], i = shape->n;
            const double radius = g->radius[node], s = meshless_cut_distance(g, at, node, gradient) / radius;
            if (!(s < 1)) continue;
            if (i == GALERKIN_NEAR) return MESHLESS_MLS_MANY;
            meshless_weight(g->in.weight, s, &weight[i], &dwds);
            for (int c = 0; c < 2; c++) dw[i][c] = dwds * gradient[c] / radius;
            shape->node[shape->n++] = node;
            *h = fmin(*h, radius);
        }
    return MESHLESS_MLS_DONE;
}

/* Shape functions with one basis, that of the tip (-1: linear). */
static enum meshless_mls_fault plain(const struct galerkin *g, const struct galerkin_place *at, int tip,
                                     struct galerkin_shape *shape) {
    double weight[GALERKIN_NEAR], dw[GALERKIN_NEAR][2], p[GALERKIN_NEAR][TERMS];
    double m[TERMS][TERMS] = {{0}}, dm[2][TERMS][TERMS] = {{{0}}};
    double a[TERMS], here[TERMS], slope[TERMS][2], da[2][TERMS], h;
    struct local_basis basis;
    if (gather(g, at, shape, weight, dw, &h)) return MESHLESS_MLS_MANY;
    basis_begin(g, at, tip, h, &basis, here, slope);
    const int n = basis.terms;
    for (int i = 0; i < shape->n; i++) {
        basis_at(g, at, tip, &basis, g->in.node[shape->node[i]], p[i]);
        for (int r = 0; r < n; r++)
            for (int q = 0; q <= r; q++) {
                const double pp = p[i][r] * p[i][q];
                m[r][q] += weight[i] * pp;
                dm[0][r][q] += dw[i][0] * pp;
                dm[1][r][q] += dw[i][1] * pp;
            }
    }
    if (shape->n < n) return MESHLESS_MLS_FEW;
    if (!factor(n, m)) return MESHLESS_MLS_SINGULAR;
    for (int r = 0; r < n; r++) a[r] = here[r];
    solve(n, m, a);
    for (int c = 0; c < 2; c++) {
        for (int r = 0; r < n; r++) {
            da[c][r] = slope[r][c];
            for (int q = 0; q < n; q++) da[c][r] -= (q <= r ? dm[c][r][q] : dm[c][q][r]) * a[q];
        }
        solve(n, m, da[c]);
    }
    for (int i = 0; i < shape->n; i++) {
        double pa = 0, dpa[2] = {0, 0};
        for (int r = 0; r < n; r++) {
            pa += p[i][r] * a[r];
            dpa[0] += p[i][r] * da[0][r];
            dpa[1] += p[i][r] * da[1][r];
        }
        shape->phi[i] = weight[i] * pa;
        for (int c = 0; c < 2; c++) shape->d[i][c] = dw[i][c] * pa + weight[i] * dpa[c];
    }
    return MESHLESS_MLS_DONE;
}

enum meshless_mls_fault meshless_mls_shape(const struct galerkin *g, const struct galerkin_place *at,
                                           struct galerkin_shape *shape) {
    int tip = -1;
    const double r = meshless_cut_nearest(g, at->x, &tip), zone = g->in.tip_radius * g->in.spacing;
    if (g->in.basis == GALERKIN_LINEAR || tip < 0 || r >= zone) return plain(g, at, -1, shape);
    enum meshless_mls_fault fault = plain(g, at, tip, shape);
    if (fault || r <= 0.5 * zone) return fault;
    struct galerkin_shape linear; /* it sees the same nodes in the same order */
    fault = plain(g, at, -1, &linear);
    if (fault) return fault;
    const double t = 2 * r / zone - 1, share = 1 - t * t * (3 - 2 * t), rate = -6 * t * (1 - t) * 2 / (zone * r);
    for (int i = 0; i < shape->n; i++) {
        const double difference = shape->phi[i] - linear.phi[i];
        for (int c = 0; c < 2; c++)
            shape->d[i][c] = share * shape->d[i][c] + (1 - share) * linear.d[i][c] +
                             rate * (at->x[c] - g->tip[tip].x[c]) * difference;
        shape->phi[i] = share * shape->phi[i] + (1 - share) * linear.phi[i];
    }
    return MESHLESS_MLS_DONE;
}

static int nearest_node(const struct galerkin *g, const double x[2], double *distance) {
    int nearest = 0;
    *distance = INFINITY;
    for (int i = 0; i < g->in.nodes; i++) {
        const double r = hypot(x[0] - g->in.node[i][0], x[1] - g->in.node[i][1]);
        if (r < *distance) *distance = r, nearest = i;
    }
    return nearest;
}

void meshless_mls_need(const struct galerkin *g, const struct galerkin_place *at, struct galerkin_shape *shape) {
    const enum meshless_mls_fault fault = meshless_mls_shape(g, at, shape);
    if (fault == MESHLESS_MLS_DONE) return;
    double away;
    const int node = nearest_node(g, at->x, &away);
    const double *x = at->x, *its = g->in.node[node];
    switch (fault) {
    case MESHLESS_MLS_DONE:
        return;
    case MESHLESS_MLS_FEW:
    case MESHLESS_MLS_SINGULAR:
        die_all(EXIT_CODE_SCENE,
                "solid.element_free.support = %g: the point (%.6g, %.6g) sees %d nodes, and these do not determine "
                "the basis; the nearest node is %d at (%.6g, %.6g), %.3g spacings away. Take a larger support, a "
                "basis with fewer functions, or nodes that fill the body",
                g->in.support, x[0], x[1], shape->n, node, its[0], its[1], away / g->in.spacing);
    case MESHLESS_MLS_MANY:
        die_all(EXIT_CODE_SCENE,
                "solid.element_free.support = %g: the point (%.6g, %.6g) next to node %d at (%.6g, %.6g) sees more "
                "than %d nodes; take a smaller support",
                g->in.support, x[0], x[1], node, its[0], its[1], GALERKIN_NEAR);
    }
    ENSURE(0, "fault %d", (int)fault);
}
