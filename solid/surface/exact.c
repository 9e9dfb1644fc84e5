/* Depth and normal of interface particles by the shape they were cut from, rotated with the deformation. */
#include "solid/surface/exact.h"
#include "base/memory.h"
#include "solid/surface/normal.h"
#include "solid/surface/piece.h"

static void find(struct solid_exact *exact, const struct solid *s, const struct solid_surface *f,
                 struct solid_compound *compound, int h) {
    const double x[3] = {s->x0[0][h], s->x0[1][h], s->x0[2][h]};
    struct solid_family_view view;
    struct solid_normal_data start;
    struct solid_piece piece;
    double normal[3];
    if (!compound || !solid_piece_of(compound, x, f->bare[h], &piece)) return;
    solid_family_view(s, h, &view);
    solid_normal_compute_initial(s, h, &view, f->bare[h], &start);
    if (start.two_sided != SOLID_ONE_FACE) return;
    exact->on[h] = 1;
    exact->depth[h] = piece.depth(&piece, x, normal);
    exact->curvature[h] = piece.curvature(&piece, normal);
    for (int c = 0; c < 3; c++) {
        exact->normal[c][h] = normal[c];
        exact->lattice[c][h] = start.n[c];
    }
}

struct solid_exact *solid_exact_new(const struct solid *s, const struct solid_surface *surface) {
    const size_t n = (size_t)s->n + 1;
    struct solid_exact *exact = memory_new(MEMORY_SOLID, 1, sizeof *exact);
    exact->on = memory_new(MEMORY_SOLID, n, 1);
    exact->depth = memory_new(MEMORY_SOLID, n, sizeof *exact->depth);
    exact->curvature = memory_new(MEMORY_SOLID, n, sizeof *exact->curvature);
    for (int c = 0; c < 3; c++) {
        exact->normal[c] = memory_new(MEMORY_SOLID, n, sizeof(double));
        exact->lattice[c] = memory_new(MEMORY_SOLID, n, sizeof(double));
    }
    struct solid_compound **compound = memory_new(MEMORY_SOLID, (size_t)s->in.bodies, sizeof(struct solid_compound *));
    for (int b = 0; b < s->in.bodies; b++) compound[b] = solid_compound_new(&s->in, &s->in.body[b]);
    for (int h = 0; h < s->n; h++)
        if (s->flag[h] & SOLID_FIRST) find(exact, s, surface, compound[s->body[h]], h);
    for (int b = 0; b < s->in.bodies; b++) solid_compound_free(compound[b]);
    memory_free(compound);
    return exact;
}

void solid_exact_free(struct solid_exact *exact) {
    if (!exact) return;
    for (int c = 0; c < 3; c++) MEMORY_FREE(exact->normal[c], exact->lattice[c]);
    MEMORY_FREE(exact->depth, exact->curvature, exact->on, exact);
}

static void cross(const double a[3], const double b[3], double c[3]) {
    for (int d = 0; d < 3; d++) c[d] = a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
}

/* Applies to x the smallest rotation from a to b, unit vectors: x + w x + w (w x)/(1 + a.b), w = a x b. */
static void turn(const double a[3], const double b[3], double x[3]) {
    double w[3], wx[3], wwx[3], along = 1;
    cross(a, b, w);
    cross(w, x, wx);
    cross(w, wx, wwx);
    for (int c = 0; c < 3; c++) along += a[c] * b[c];
    for (int c = 0; c < 3; c++) x[c] += wx[c] + wwx[c] / along;
}

int solid_exact_at(const struct solid_surface *f, int h, double normal[3], double *depth, double *curvature) {
    const struct solid_exact *exact = f->exact;
    const struct solid_normal_data *now = &f->normal_data[h];
    if (!exact || !exact->on[h] || now->two_sided || now->open != f->bare[h]) return 0;
    double then[3], cosine = 0;
    int has_turned = 0;
    for (int c = 0; c < 3; c++) {
        then[c] = exact->lattice[c][h];
        normal[c] = exact->normal[c][h];
        cosine += then[c] * now->n[c];
        has_turned |= then[c] != now->n[c];
    }
    if (cosine < -0.99) return 0; /* nearly opposite: the smallest rotation is not unique */
    if (has_turned) turn(then, now->n, normal);
    *depth = exact->depth[h];
    *curvature = exact->curvature[h];
    return 1;
}
