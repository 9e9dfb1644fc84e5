/* Finds the weights of near particles for place, velocity and force of markers: moving least squares of first order. */
#include "solid/surface/attach.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "solid/bonds/family.h"
#include "solid/bonds/broken_tracker.h"
#include "solid/measure/tensors.h"
#include "solid/surface/normal.h"
#include "solid/surface/exact.h"

#include <math.h>
#include <string.h>

enum { CHUNK = 1024 };                 /* weights that are allocated at once */
static const double near_enough = 1.5; /* spacings */
static const double flat = 0.1;        /* spacings^2: below it the near particles do not extend in a direction */

struct solid_attachment *solid_attach_new(const struct solid *s) {
    struct solid_attachment *a = memory_new(MEMORY_SOLID, 1, sizeof *a);
    for (int c = 0; c < 3; c++) a->given[c] = memory_new(MEMORY_SOLID, (size_t)(s->n + s->n_ghost) + 1, sizeof(double));
    a->place = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *a->place);
    for (int h = 0; h < s->n; h++) a->place[h] = -1;
    return a;
}

void solid_attach_free(struct solid_attachment *a) {
    if (!a) return;
    for (int k = 0; k < a->chunks; k++) memory_free(a->pool[k]);
    MEMORY_FREE(a->given[0], a->given[1], a->given[2], a->pool, a->place, a->weights, a->inverse_mass, a);
}

static void reserve(struct solid_attachment *a, int n) {
    if (n <= a->capacity) return;
    MEMORY_FREE(a->weights, a->inverse_mass);
    a->capacity = n + n / 4 + 64;
    a->weights = memory_new(MEMORY_SOLID, (size_t)a->capacity, sizeof *a->weights);
    a->inverse_mass = memory_new(MEMORY_SOLID, (size_t)a->capacity, sizeof *a->inverse_mass);
}

/* The weights of particle h, which may not have been found yet. */
static struct solid_attachment_weights *weights_of(struct solid_attachment *a, int h) {
    if (a->place[h] < 0) {
        if (a->pooled == CHUNK * a->chunks) {
            a->pool = memory_grown(MEMORY_SOLID, a->pool, (size_t)a->chunks, (size_t)a->chunks + 1, sizeof *a->pool);
            a->pool[a->chunks++] = memory_new(MEMORY_SOLID, CHUNK, sizeof **a->pool);
        }
        a->place[h] = a->pooled++;
        a->pool[a->place[h] / CHUNK][a->place[h] % CHUNK].intact = -1;
    }
    return &a->pool[a->place[h] / CHUNK][a->place[h] % CHUNK];
}

/* The outward normal of the undeformed body with the bonds that are intact now. */
static void find_normal(const struct solid *s, const struct solid_surface *f, int h,
                        const struct solid_family_view *view, double n[3]) {
    double depth, curvature;
    if (solid_exact_at(f, h, n, &depth, &curvature)) {
        for (int c = 0; c < 3; c++) n[c] = f->exact->normal[c][h];
    } else {
        struct solid_normal_data data;
        solid_normal_compute_undeformed(s, h, view, f->normal_data[h].open, &data);
        memcpy(n, data.n, sizeof data.n);
    }
}

/* Near particles among the intact bonds: their places in the view. Returns how many; t <- sum of xi xi^T. */
static int find_near(const struct solid *s, const struct solid_family_view *view, int near[SOLID_ATTACHMENT_MAX],
                     double t[6]) {
    const double reach = near_enough * s->in.spacing;
    int n = 0;
    memset(t, 0, 6 * sizeof *t);
    for (int b = 0; b < view->n && n < SOLID_ATTACHMENT_MAX; b++) {
        const double *xi = view->xi[b];
        if (!view->intact[b] || xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2] > reach * reach) continue;
        near[n++] = b;
        for (int c = 0; c < 3; c++) {
            t[c] += xi[c] * xi[c];
            t[3 + c] += xi[c] * xi[(c + 1) % 3];
        }
    }
    return n;
}

/* to <- t^+ n: the pseudo-inverse leaves out directions in which the near particles do not extend. */
static void solve(const struct solid *s, const double t[6], const double n[3], double to[3]) {
    double value[3], vector[3][3];
    solid_tensors_eigen(t, value, vector);
    to[0] = to[1] = to[2] = 0;
    for (int e = 0; e < 3; e++) {
        const double along = vector[e][0] * n[0] + vector[e][1] * n[1] + vector[e][2] * n[2];
        if (!(value[e] > flat * s->in.spacing * s->in.spacing)) continue;
        for (int c = 0; c < 3; c++) to[c] += along / value[e] * vector[e][c];
    }
}

/* g_l = shift n.T^+ xi_l, the least weights with sum_l g_l xi_l = shift n. */
static void find_weights(const struct solid *s, const struct solid_surface *f, int h,
                         struct solid_attachment_weights *w) {
    struct solid_family_view view;
    int near[SOLID_ATTACHMENT_MAX];
    double t[6], n[3], b[3];
    solid_family_view(s, h, &view);
    find_normal(s, f, h, &view, n);
    const int count = find_near(s, &view, near, t);
    solve(s, t, n, b);
    for (int k = 0; k < count; k++) {
        const double *xi = view.xi[near[k]], g = w->shift * (xi[0] * b[0] + xi[1] * b[1] + xi[2] * b[2]);
        if (fabs(g) < 1e-9) continue; /* across the normal, but for round-off */
        w->other[w->n] = view.l[near[k]];
        w->share[w->n++] = g;
        w->own -= g;
    }
}

/* Sets the weights of marker i, if what they follow from has changed. Returns whether it has. */
static int renew(struct solid_attachment *a, const struct solid *s, const struct solid_surface *f, int i,
                 double shift) {
    const int h = f->h[i], intact = f->tracker->intact[h], faces = f->two_sided[i], open = f->normal_data[h].open;
    struct solid_attachment_weights *w = weights_of(a, h);
    a->weights[i] = w;
    if (w->intact == intact && w->faces == faces && w->open == open && w->shift == shift) return 0;
    w->own = 1;
    w->n = 0;
    w->intact = intact;
    w->faces = faces;
    w->open = open;
    w->shift = shift;
    if (faces == SOLID_ONE_FACE) find_weights(s, f, h, w);
    return 1;
}

static int is_held(const struct solid *s, int h) {
    const int held = SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z;
    return (s->flag[h] & held) == held;
}

/* D = |N| M^-1 |N|^T 1. */
static void find_inverse_mass(struct solid_attachment *a, const struct solid *s) {
    double *sum = a->given[0];
    memset(sum, 0, sizeof *sum * (size_t)(s->n + s->n_ghost));
    for (int i = 0; i < a->n; i++) {
        const struct solid_attachment_weights *w = a->weights[i];
        sum[a->h[i]] += fabs(w->own);
        for (int k = 0; k < w->n; k++) sum[w->other[k]] += fabs(w->share[k]);
    }
    par_ghost_add(s->ghost, 1, a->given, s->n);
    for (int h = 0; h < s->n; h++) sum[h] *= is_held(s, h) ? 0 : 1 / (s->volume[h] * solid_density(s, h));
    par_ghost_update(s->ghost, 1, a->given, s->n);
    for (int i = 0; i < a->n; i++) {
        const struct solid_attachment_weights *w = a->weights[i];
        a->inverse_mass[i] = fabs(w->own) * sum[a->h[i]];
        for (int k = 0; k < w->n; k++) a->inverse_mass[i] += fabs(w->share[k]) * sum[w->other[k]];
    }
}

void solid_attach_update(struct solid_attachment *a, const struct solid *s, const struct solid_surface *f,
                         const double *shift) {
    int changed = a->n != f->n || a->bonds_version != s->bonds_version;
    reserve(a, f->n);
    for (int k = 0; k < a->pooled && a->bonds_version != s->bonds_version; k++)
        a->pool[k / CHUNK][k % CHUNK].intact = -1;
    a->bonds_version = s->bonds_version;
    a->n = f->n;
    a->h = f->h;
    for (int i = 0; i < f->n; i++) changed |= renew(a, s, f, i, shift[i]);
    if (par_max(changed) > 0) find_inverse_mass(a, s);
}
