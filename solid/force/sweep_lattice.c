/* Force sweep over the bonds of a lattice body: fills the field arrays, computes the segments' forces, breaks bonds. */
#include "base/vec.h"
#include "solid/bonds/family.h"
#include "solid/force/segment.h"
#include "solid/force/series.h"
#include "solid/force/sweep_lattice.h"

#include <math.h>

/* If the largest eps of a segment was above this fraction of the limit, its bonds are tested before the forces are
 * computed. */
static const double NEAR_LIMIT = 0.9;

struct sweep {
    struct solid *s;
    struct solid_lattice *b;
    struct solid_boxes box, undo; /* undo: the same with all forces negated, to undo a segment */
    double look;                  /* eps from which on single bonds are tested */
    enum solid_kernel damped;
    double power; /* m2/s3 */
};

/* Copies one component of a field to its array: for owned particles and their periodic images; for ghosts. */
static void fill_owned(const struct solid_lattice *b, const double *restrict from, double *restrict box) {
    for (int r = 0; r < b->rows; r++)
        vec_store(box + solid_lattice_place(b, b->row_cell[r]), vec_spread(b->row_owned[r], from + b->row_first[r]));
    for (int i = b->ghosts; i < b->away; i++) box[b->copy_at[i]] = from[b->copy_local[i]];
}

static void fill_ghosts(const struct solid_lattice *b, const double *restrict from, double *restrict box) {
    for (int i = 0; i < b->ghosts; i++) box[b->copy_at[i]] = from[b->copy_local[i]];
}

void solid_sweep_lattice_refill(const struct solid *s, const struct solid_lattice *b) {
    for (int c = 0; c < 3; c++) {
        fill_ghosts(b, s->d[c], b->d[c]);
        fill_ghosts(b, s->v[c], b->v[c]);
    }
}

static void clear(const struct solid_lattice *b, double *restrict box) {
    for (int r = 0; r < b->rows; r++) vec_store(box + solid_lattice_place(b, b->row_cell[r]), vec_set(0));
    for (int i = 0; i < b->away; i++) box[b->copy_at[i]] = 0;
}

/* The offsets' constants with damping and, behind them, the same with all forces negated. */
static void fill_offsets(const struct solid_lattice *b, double damping, struct solid_lattice_offset *to) {
    const int n = b->stencil->n;
    for (int o = 0; o < n; o++) {
        to[o] = to[n + o] = b->offset[o];
        to[o].viscous *= damping;
        to[n + o].viscous *= -damping;
        to[n + o].elastic *= -1;
        to[n + o].elastic_twice *= -1;
    }
}

/* The number that decides whether a bond breaks. One function with one order of operations: both ends get the same
 * value to the bit. */
static __attribute__((noinline)) double bond_eps(const double xi[3], const double eta[3], double inv_length2) {
    double q = 0;
    for (int c = 0; c < 3; c++) q += eta[c] * (xi[c] + (xi[c] + eta[c]));
    return q * inv_length2;
}

/* Breaks the bond at offset o of the particle at the cell if it is stretched beyond s0: from both ends if both are
 * owned here, else from this end; the owner of the other end does the same. Returns the number of directed bonds. */
static int break_bond(struct solid *s, struct solid_lattice *b, long cell, int o) {
    const struct solid_offset *t = &b->stencil->offset[o];
    const long far = cell + b->offset[o].shift;
    const int h = b->local[cell], l = b->local[far];
    double eta[3];
    for (int c = 0; c < 3; c++) eta[c] = b->d[c][solid_lattice_place(b, far)] - b->d[c][solid_lattice_place(b, cell)];
    const double eps = bond_eps(t->xi, eta, t->inv_length2);
    if (!(eps > b->law.eps_limit) || ((s->flag[h] | s->flag[l]) & SOLID_UNBREAKABLE)) return 0;
    const double stretch = eps / (1 + sqrt(1 + eps)),
                 alpha = 2 / (*solid_lattice_w(b, cell) + *solid_lattice_w(b, far));
    const double volume = b->stencil->spacing * b->stencil->spacing * b->stencil->spacing;
    const double energy = 0.25 * b->law.c0 * alpha * stretch * stretch * t->length * t->weight * volume;
    const int home = l >= b->first && l < b->first + b->n && b->cell[l - b->first] == far;
    solid_lattice_cut(b, h, o);
    s->flag[h] |= SOLID_BROKEN;
    s->e_fracture += energy;
    if (!home) return 1;
    solid_lattice_cut(b, l, b->stencil->n - 1 - o);
    s->flag[l] |= SOLID_BROKEN;
    s->e_fracture += energy;
    return 2;
}

/* Returns the number of directed bonds of the segment that broke. */
static int break_segment(struct solid *s, struct solid_lattice *b, int g) {
    const struct solid_segments *t = b->segments;
    int broken = 0;
    for (int k = 0; k < SOLID_ROW; k++) {
        if (!(t->owned[g] >> k & 1)) continue;
        const long cell = t->cell[g] + k;
        const uint8_t *lambda = b->lambda + (size_t)b->row_of[cell / SOLID_ROW] * (size_t)b->stencil->n;
        for (int o = 0; o < b->stencil->n; o++)
            if (lambda[o] >> cell % SOLID_ROW & 1) broken += break_bond(s, b, cell, o);
    }
    if (broken) s->broke = 1;
    return broken;
}

/* Computes the forces of segment g. If bonds must break or the series does not hold, the forces are undone and computed
 * again. That is rare, because segments near either limit are tested first. */
static void sweep_segment(struct sweep *w, int g) {
    struct solid_lattice *b = w->b;
    struct solid_segments *t = b->segments;
    const int judged = t->high[g] > NEAR_LIMIT * w->look;
    if (t->stale[g]) solid_segments_pack(b, g);
    if (judged && solid_segment_force(&w->box, t, g, KERNEL_JUDGE, &w->power).high > w->look &&
        break_segment(w->s, b, g))
        solid_segments_pack(b, g);

    const enum solid_kernel plain = w->damped | (t->bulk[g] ? KERNEL_BULK : 0), exact = plain | KERNEL_EXACT,
                            first = t->large[g] ? exact : plain;
    struct solid_range range = solid_segment_force(&w->box, t, g, first, &w->power);
    const int too_large = first == plain && fmax(range.high, -range.low) > SOLID_SERIES_LIMIT;
    const int breaks = !judged && range.high > w->look && break_segment(w->s, b, g);
    if (too_large || breaks) {
        solid_segment_force(&w->undo, t, g, first, &w->power);
        if (breaks) solid_segments_pack(b, g);
        range = solid_segment_force(&w->box, t, g, exact, &w->power);
    }
    t->high[g] = (float)range.high;
    t->large[g] = fmax(range.high, -range.low) > (t->large[g] ? 0.5 : 1) * SOLID_SERIES_LIMIT;
}

/* Computes the forces of the segments from .. to-1; returns the power of damping, W. */
static double sweep_segments(struct solid *s, struct solid_lattice *b, const struct solid_sweep *sweep, int from,
                             int to) {
    struct solid_lattice_offset offset[2 * SOLID_FAMILY_MAX];
    /* the kernels' eps may differ from bond_eps in its last digit: bonds are tested from slightly below the limit */
    struct sweep w = {.s = s,
                      .b = b,
                      .look = sweep->may_break ? b->law.eps_limit * (1 - 1e-9) : INFINITY,
                      .damped = sweep->damping > 0 ? KERNEL_DAMPED : 0};
    fill_offsets(b, sweep->damping, offset);
    w.box = (struct solid_boxes){.w = b->w, .offset = offset};
    for (int c = 0; c < 3; c++) {
        w.box.d[c] = b->d[c];
        w.box.v[c] = b->v[c];
        w.box.a[c] = b->f[c];
    }
    w.undo = w.box;
    w.undo.offset = offset + b->stencil->n;
    for (int g = from; g < to; g++) sweep_segment(&w, g);
    const double spacing = b->stencil->spacing;
    return 0.5 * b->law.density * (spacing * spacing * spacing) * w.power;
}

double solid_sweep_lattice_begin(struct solid *s, struct solid_lattice *b, const struct solid_sweep *sweep) {
    for (int c = 0; c < 3; c++) {
        fill_owned(b, s->d[c], b->d[c]);
        if (sweep->damping > 0) fill_owned(b, s->v[c], b->v[c]);
        clear(b, b->f[c]);
    }
    return sweep_segments(s, b, sweep, 0, b->segments->inner);
}

double solid_sweep_lattice_end(struct solid *s, struct solid_lattice *b, const struct solid_sweep *sweep) {
    for (int c = 0; c < 3; c++) {
        fill_ghosts(b, s->d[c], b->d[c]);
        if (sweep->damping > 0) fill_ghosts(b, s->v[c], b->v[c]);
    }
    const double power = sweep_segments(s, b, sweep, b->segments->inner, b->segments->n);
    for (int c = 0; c < 3; c++)
        for (int r = 0; r < b->rows; r++)
            vec_press(b->row_owned[r], vec_load(b->f[c] + solid_lattice_place(b, b->row_cell[r])),
                      s->a[c] + b->row_first[r]);
    return power;
}
