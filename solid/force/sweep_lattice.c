/* Force sweep over the bonds of a lattice body: fills the field arrays, computes the segments' forces, breaks bonds. */
#include "base/vec.h"
#include "solid/bonds/breaks.h"
#include "solid/bonds/family.h"
#include "solid/bonds/kinds.h"
#include "solid/bonds/soft.h"
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
    double look;                  /* eps from which on single bonds are tested; of several materials: in this segment */
    enum solid_kernel damped, mixed; /* mixed: of several materials, whether this segment has bonds of several */
    int may_break;
    double power; /* m2/s3 */
};

/* Copies one component of a field to its array: for owned particles and their periodic images; for ghosts. */
static void fill_owned(const struct solid_lattice *lattice, const double *restrict from, double *restrict box) {
    for (int r = 0; r < lattice->rows; r++)
        vec_store(box + solid_lattice_place(lattice, lattice->row_cell[r]),
                  vec_spread(lattice->row_owned[r], from + lattice->row_first[r]));
    for (int i = lattice->ghosts; i < lattice->away; i++) box[lattice->copy_at[i]] = from[lattice->copy_local[i]];
}

static void fill_ghosts(const struct solid_lattice *lattice, const double *restrict from, double *restrict box) {
    for (int i = 0; i < lattice->ghosts; i++) box[lattice->copy_at[i]] = from[lattice->copy_local[i]];
}

void solid_sweep_lattice_refill(const struct solid *s, const struct solid_lattice *lattice) {
    for (int c = 0; c < 3; c++) {
        fill_ghosts(lattice, s->d[c], lattice->d[c]);
        fill_ghosts(lattice, s->v[c], lattice->v[c]);
    }
}

static void clear(const struct solid_lattice *lattice, double *restrict box) {
    for (int r = 0; r < lattice->rows; r++)
        vec_store(box + solid_lattice_place(lattice, lattice->row_cell[r]), vec_set(0));
    for (int i = 0; i < lattice->away; i++) box[lattice->copy_at[i]] = 0;
}

/* The offsets' constants with damping and, behind them, the same with all forces negated. stiffer: the factor of
 * elastic forces. */
static void fill_offsets(const struct solid_lattice *lattice, double damping, double stiffer,
                         struct solid_lattice_offset *to) {
    const int n = lattice->stencil->n;
    for (int o = 0; o < n; o++) {
        to[o] = lattice->offset[o];
        to[o].elastic *= stiffer;
        to[o].elastic_twice *= stiffer;
        to[n + o] = to[o];
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

/* Breaks the bond at offset o of the particle at the cell if it is stretched beyond s0 (one that softens leaves this
 * sweep for another): from both ends if both are owned here, else from this end; the owner of the other end does the
 * same. Returns the number of directed bonds. */
static int break_bond(struct solid *s, struct solid_lattice *lattice, long cell, int o) {
    const struct solid_offset *t = &lattice->stencil->offset[o];
    const long far = cell + lattice->offset[o].shift;
    const int h = lattice->local[cell], l = lattice->local[far];
    double eta[3];
    for (int c = 0; c < 3; c++)
        eta[c] = lattice->d[c][solid_lattice_place(lattice, far)] - lattice->d[c][solid_lattice_place(lattice, cell)];
    const double eps = bond_eps(t->xi, eta, t->inv_length2);
    const struct solid_law *law = solid_kinds_law(lattice, h, l);
    if (!(eps > law->eps_limit) || ((s->flag[h] | s->flag[l]) & SOLID_UNBREAKABLE)) return 0;
    const int home = l >= lattice->first && l < lattice->first + lattice->n && lattice->cell[l - lattice->first] == far;
    if (lattice->soft) {
        solid_soft_add(s, h, o, lattice->law.s_e);
        if (home) solid_soft_add(s, l, lattice->stencil->n - 1 - o, lattice->law.s_e);
        return 1 + home;
    }
    const double stretch = eps / (1 + sqrt(1 + eps)),
                 alpha = 2 / (*solid_lattice_w(lattice, cell) + *solid_lattice_w(lattice, far));
    const double volume = lattice->stencil->spacing * lattice->stencil->spacing * lattice->stencil->spacing;
    const double s0 = law->eps_limit / (1 + sqrt(1 + law->eps_limit));
    const double energy = 0.25 * law->c0 * alpha * stretch * stretch * t->length * t->weight * volume;
    const double area = energy * (s0 * s0 / (stretch * stretch)) / law->fracture_energy;
    solid_lattice_cut(lattice, h, o);
    s->flag[h] |= SOLID_BROKEN;
    s->e_fracture += energy;
    s->crack_area += area;
    if (s->breaks) solid_breaks_add(s, h, l, t->xi, (1 + home) * energy, (1 + home) * area);
    if (!home) return 1;
    solid_lattice_cut(lattice, l, lattice->stencil->n - 1 - o);
    s->flag[l] |= SOLID_BROKEN;
    s->e_fracture += energy;
    s->crack_area += area;
    return 2;
}

/* Returns the number of directed bonds of the segment that broke. */
static int break_segment(struct solid *s, struct solid_lattice *lattice, int g) {
    const struct solid_segments *segments = lattice->segments;
    int broken = 0;
    for (int k = 0; k < SOLID_ROW; k++) {
        if (!(segments->owned[g] >> k & 1)) continue;
        const long cell = segments->cell[g] + k;
        const size_t row = (size_t)lattice->row_of[cell / SOLID_ROW] * (size_t)lattice->stencil->n;
        const uint8_t *lambda = lattice->lambda + row, *soft = lattice->soft ? lattice->soft + row : NULL;
        for (int o = 0; o < lattice->stencil->n; o++)
            if ((lambda[o] & (soft ? ~soft[o] : 0xff)) >> cell % SOLID_ROW & 1)
                broken += break_bond(s, lattice, cell, o);
    }
    if (broken && !lattice->soft) s->broke = 1;
    return broken;
}

/* Whether some bond of the segment may be stretched beyond its limit. */
static int is_beyond(struct sweep *w, int g) {
    const enum solid_kernel judge = KERNEL_JUDGE | w->mixed;
    return solid_segment_force(&w->box, w->b->segments, g, judge, &w->power).high > (w->mixed ? 0 : w->look);
}

/* Of several materials: takes the constants of the segment's bonds. */
static void turn_to(struct sweep *w, int g) {
    const struct solid_kinds *kinds = w->b->kinds;
    const int n = w->b->stencil->n, is_mixed = kinds->segment[g] == SOLID_KINDS_MIXED,
              kind = is_mixed ? 0 : kinds->segment[g];
    const double limit = is_mixed ? kinds->least : kinds->pair[kind][kind].eps_limit;
    w->box.offset = kinds->table + 2 * n * kind;
    w->undo.offset = w->box.offset + n;
    w->mixed = is_mixed ? KERNEL_MIXED : 0;
    w->look = w->may_break ? limit * (1 - 1e-9) : INFINITY;
}

/* Computes the forces of segment g. If bonds must break or the series does not hold, the forces are undone and computed
 * again. That is rare, because segments near either limit are tested first. */
static void sweep_segment(struct sweep *w, int g) {
    struct solid_lattice *lattice = w->b;
    struct solid_segments *segments = lattice->segments;
    const int judged = segments->high[g] > NEAR_LIMIT * w->look;
    if (segments->stale[g]) solid_segments_pack(lattice, g);
    if (judged && is_beyond(w, g) && break_segment(w->s, lattice, g)) solid_segments_pack(lattice, g);

    const enum solid_kernel plain = w->damped | w->mixed | (segments->bulk[g] ? KERNEL_BULK : 0),
                            exact = plain | KERNEL_EXACT, first = segments->large[g] ? exact : plain;
    struct solid_range range = solid_segment_force(&w->box, segments, g, first, &w->power);
    const int too_large = first == plain && fmax(range.high, -range.low) > SOLID_SERIES_LIMIT;
    const int breaks =
        !judged && range.high > w->look && (!w->mixed || is_beyond(w, g)) && break_segment(w->s, lattice, g);
    if (too_large || breaks) {
        solid_segment_force(&w->undo, segments, g, first, &w->power);
        if (breaks) solid_segments_pack(lattice, g);
        range = solid_segment_force(&w->box, segments, g, exact, &w->power);
    }
    segments->high[g] = (float)range.high;
    segments->large[g] = fmax(range.high, -range.low) > (segments->large[g] ? 0.5 : 1) * SOLID_SERIES_LIMIT;
}

/* Computes the forces of the segments from .. to-1; returns the power of damping, W. */
static double sweep_segments(struct solid *s, struct solid_lattice *lattice, const struct solid_sweep *sweep, int from,
                             int to) {
    struct solid_lattice_offset offset[2 * SOLID_FAMILY_MAX];
    /* the kernels' eps may differ from bond_eps in its last digit: bonds are tested from slightly below the limit */
    struct sweep w = {.s = s,
                      .b = lattice,
                      .look = sweep->may_break ? lattice->law.eps_limit * (1 - 1e-9) : INFINITY,
                      .damped = sweep->damping > 0 ? KERNEL_DAMPED : 0,
                      .may_break = sweep->may_break};
    const struct solid_kinds *kinds = lattice->kinds;
    if (!kinds) fill_offsets(lattice, sweep->damping, 1, offset);
    for (int k = 0; kinds && k < kinds->n; k++)
        fill_offsets(lattice, sweep->damping, kinds->stiffer[k], kinds->table + 2 * lattice->stencil->n * k);
    w.box = (struct solid_boxes){.w = lattice->w, .offset = offset};
    if (kinds) {
        w.box.half = kinds->half;
        w.box.look = kinds->look;
    }
    for (int c = 0; c < 3; c++) {
        w.box.d[c] = lattice->d[c];
        w.box.v[c] = lattice->v[c];
        w.box.a[c] = lattice->f[c];
    }
    w.undo = w.box;
    w.undo.offset = offset + lattice->stencil->n;
    for (int g = from; g < to; g++) {
        if (kinds) turn_to(&w, g);
        sweep_segment(&w, g);
    }
    const double spacing = lattice->stencil->spacing;
    return 0.5 * lattice->law.density * (spacing * spacing * spacing) * w.power;
}

double solid_sweep_lattice_begin(struct solid *s, struct solid_lattice *lattice, const struct solid_sweep *sweep) {
    for (int c = 0; c < 3; c++) {
        fill_owned(lattice, s->d[c], lattice->d[c]);
        if (sweep->damping > 0) fill_owned(lattice, s->v[c], lattice->v[c]);
        clear(lattice, lattice->f[c]);
    }
    return sweep_segments(s, lattice, sweep, 0, lattice->segments->inner);
}

double solid_sweep_lattice_end(struct solid *s, struct solid_lattice *lattice, const struct solid_sweep *sweep) {
    for (int c = 0; c < 3; c++) {
        fill_ghosts(lattice, s->d[c], lattice->d[c]);
        if (sweep->damping > 0) fill_ghosts(lattice, s->v[c], lattice->v[c]);
    }
    const double power = sweep_segments(s, lattice, sweep, lattice->segments->inner, lattice->segments->n);
    for (int c = 0; c < 3; c++)
        for (int r = 0; r < lattice->rows; r++)
            vec_press(lattice->row_owned[r],
                      vec_load(lattice->f[c] + solid_lattice_place(lattice, lattice->row_cell[r])),
                      s->a[c] + lattice->row_first[r]);
    const struct solid_kinds *kinds = lattice->kinds;
    for (int c = 0; c < 3 && kinds && !kinds->is_even; c++)
        for (int h = lattice->first; h < lattice->first + lattice->n; h++)
            s->a[c][h] *= kinds->lighter[solid_kinds_of(kinds, h)];
    return power;
}
