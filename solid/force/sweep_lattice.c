/* Force sweep over the bonds of a lattice body: fills the field arrays, computes the segments' forces, breaks bonds. */
#include "base/ensure.h"
#include "base/threads.h"
#include "base/vec.h"
#include "solid/bonds/breaks.h"
#include "solid/bonds/family.h"
#include "solid/bonds/materials.h"
#include "solid/bonds/soft.h"
#include "solid/force/dilatation_loss.h"
#include "solid/force/fields.h"
#include "solid/force/segment.h"
#include "solid/force/segment_single.h"
#include "solid/force/series.h"
#include "solid/force/sweep_lattice.h"
#include "solid/force/absorbed.h"

#include <math.h>
#include <string.h>

/* If the largest eps of a segment was above this fraction of the limit, its bonds are tested before the forces are
 * computed. */
static const double NEAR_LIMIT = 0.9;

struct sweep {
    struct solid *s;
    struct solid_lattice *b;
    struct solid_boxes box, undo; /* undo: the constants with negated forces, which subtract a segment's forces again */
    struct solid_boxes_single box_single, undo_single; /* the same in mixed precision */
    double series;                                     /* largest |eps| without square roots */
    double threshold;       /* eps from which on single bonds are tested; of several materials: in this segment */
    enum solid_kernel part; /* KERNEL_EXTENSION, KERNEL_PRESSED or 0 */
    int is_measure;
    enum solid_kernel damped, several; /* several: whether this segment has bonds of several materials */
    int near;                          /* KERNEL_NEAR: displacements are rounded; 0 */
    int may_break;
    int defers;   /* 1: other threads sweep too; segments with bonds that may break are deferred */
    int deferred; /* number of them */
    double power; /* m2/s3 */
};

void solid_sweep_lattice_refill(const struct solid *s, const struct solid_lattice *lattice) {
    solid_fields_of(lattice)->copies(s, lattice, 0, lattice->ghosts, 1);
    if (lattice->w_single) solid_fields_double.copies(s, lattice, 0, lattice->ghosts, 0);
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

/* The dilatations of both ends that are owned here lose the bond at offset o of h. */
static void lose(struct solid *s, const struct solid_lattice *lattice, int h, int l, int o, double stiffness,
                 double stretch, int is_own) {
    const struct solid_offset *t = &lattice->stencil->offset[o];
    const struct solid_dilatation_loss there = {.h = l,
                                                .l = h,
                                                .xi = {-t->xi[0], -t->xi[1], -t->xi[2]},
                                                .stiffness = stiffness * t->weight * t->length,
                                                .now = stretch,
                                                .before = stretch * solid_absorbed_fraction(s, h, l, t->xi, stretch),
                                                .soft = -1};
    struct solid_dilatation_loss here = there;
    here.h = h;
    here.l = l;
    memcpy(here.xi, t->xi, sizeof here.xi);
    solid_dilatation_loss_add(s, &here);
    if (is_own) solid_dilatation_loss_add(s, &there);
}

/* Breaks the bond at offset o of the particle at the cell if it is stretched beyond s0: from both ends if both are
 * owned here, else from this end, and the owner of the other end does the same. A bond that softens is moved to the
 * list of softening bonds. Returns the number of directed bonds. */
static int break_bond(struct solid *s, struct solid_lattice *lattice, long cell, int o) {
    const struct solid_offset *t = &lattice->stencil->offset[o];
    const long far = cell + lattice->offset[o].shift;
    const int h = lattice->local[cell], l = lattice->local[far];
    double eta[3];
    for (int c = 0; c < 3; c++) eta[c] = s->d[c][l] - s->d[c][h];
    const double eps = bond_eps(t->xi, eta, t->inv_length2);
    const struct solid_law *law = solid_materials_law(lattice, h, l);
    if (!(eps > law->eps_limit) || ((s->flag[h] | s->flag[l]) & SOLID_UNBREAKABLE)) return 0;
    const int is_own =
        l >= lattice->first && l < lattice->first + lattice->n && lattice->cell[l - lattice->first] == far;
    if (lattice->soft) {
        solid_soft_add(s, h, o, lattice->law.s_e);
        if (is_own) solid_soft_add(s, l, lattice->stencil->n - 1 - o, lattice->law.s_e);
        return 1 + is_own;
    }
    const double stretch = eps / (1 + sqrt(1 + eps)),
                 alpha = 2 / (*solid_lattice_w(lattice, cell) + *solid_lattice_w(lattice, far));
    const double volume = lattice->stencil->spacing * lattice->stencil->spacing * lattice->stencil->spacing;
    const double s0 = law->eps_limit / (1 + sqrt(1 + law->eps_limit));
    const double held = 0.25 * law->c0 * alpha * stretch * stretch * t->length * t->weight * volume;
    const double area = held * (s0 * s0 / (stretch * stretch)) / law->bonds_energy;
    const double energy = held * solid_absorbed_fraction(s, h, l, t->xi, stretch);
    if (s->dilatation) lose(s, lattice, h, l, o, law->c0, stretch, is_own);
    solid_lattice_cut(lattice, h, o);
    s->flag[h] |= SOLID_BROKEN;
    s->e_fracture += energy;
    s->crack_area += area;
    if (s->breaks) solid_breaks_add(s, h, l, t->xi, (1 + is_own) * energy, (1 + is_own) * area);
    if (!is_own) return 1;
    solid_lattice_cut(lattice, l, lattice->stencil->n - 1 - o);
    s->flag[l] |= SOLID_BROKEN;
    s->e_fracture += energy;
    s->crack_area += area;
    return 2;
}

/* Displacements of VEC_LANES sites in the field arrays, as the sweep reads them, m. */
static void displacements(const struct sweep *w, long at, vec d[3]) {
    for (int c = 0; c < 3; c++) d[c] = w->near ? vec_load_floats(w->b->d_single[c] + at) : vec_load(w->b->d[c] + at);
}

/* Bits of the sites of segment g whose bond at the offset, if there is one, is stretched beyond w->threshold. */
static unsigned stretched(const struct sweep *w, int g, int o) {
    const struct solid_lattice *lattice = w->b;
    const struct solid_offset *t = &lattice->stencil->offset[o];
    const long at = lattice->segments->at[g],
               far = solid_lattice_place(lattice, lattice->segments->cell[g] + lattice->offset[o].shift);
    unsigned bits = 0;
    for (int k = 0; k < SOLID_ROW; k += VEC_LANES) {
        vec here[3], there[3], q = vec_set(0);
        displacements(w, at + k, here);
        displacements(w, far + k, there);
        for (int c = 0; c < 3; c++) q += (there[c] - here[c]) * (2 * t->xi[c] + (there[c] - here[c]));
        bits |= vec_signs(w->threshold - q * t->inv_length2) << k;
    }
    return bits;
}

/* Returns the number of directed bonds of the segment that broke. */
static int break_segment(struct sweep *w, int g) {
    struct solid *s = w->s;
    struct solid_lattice *lattice = w->b;
    const struct solid_segments *segments = lattice->segments;
    const int n = lattice->stencil->n;
    uint8_t beyond[SOLID_FAMILY_MAX];
    int broken = 0;
    for (int o = 0; o < n; o++) beyond[o] = (uint8_t)(segments->owned[g] & stretched(w, g, o));
    for (int k = 0; k < SOLID_ROW; k++) {
        if (!(segments->owned[g] >> k & 1)) continue;
        const long cell = segments->cell[g] + k;
        const size_t row = (size_t)lattice->row_of[cell / SOLID_ROW] * (size_t)n;
        const uint8_t *lambda = lattice->lambda + row, *soft = lattice->soft ? lattice->soft + row : NULL;
        for (int o = 0; o < n; o++)
            if (beyond[o] >> k & 1 && (lambda[o] & (soft ? ~soft[o] : 0xff)) >> cell % SOLID_ROW & 1)
                broken += break_bond(s, lattice, cell, o);
    }
    if (broken && !lattice->soft) s->broke = 1;
    return broken;
}

static struct solid_range force_of(struct sweep *w, int g, enum solid_kernel kernel) {
    if (w->b->w_single)
        return solid_segment_single_force(&w->box_single, w->b->segments, g, (int)kernel | w->near, &w->power);
    return solid_segment_force(&w->box, w->b->segments, g, kernel, &w->power);
}

static void undo(struct sweep *w, int g, enum solid_kernel kernel) {
    if (w->b->w_single)
        solid_segment_single_force(&w->undo_single, w->b->segments, g, (int)kernel | w->near, &w->power);
    else
        solid_segment_force(&w->undo, w->b->segments, g, kernel, &w->power);
}

/* Whether some bond of the segment may be stretched beyond its limit. */
static int is_beyond(struct sweep *w, int g) {
    const enum solid_kernel stretch_only = KERNEL_STRETCH_ONLY | w->several;
    return force_of(w, g, stretch_only).high > (w->several ? 0 : w->threshold);
}

/* With several materials: selects the constants of the segment's bonds. */
static void set_material(struct sweep *w, int g) {
    const struct solid_materials *materials = w->b->materials;
    const int n = w->b->stencil->n, has_several = materials->segment[g] == SOLID_MATERIALS_SEVERAL,
              kind = has_several ? 0 : materials->segment[g];
    const double limit = has_several ? materials->least : materials->pair[kind][kind].eps_limit;
    w->box.offset = materials->table + 2 * n * kind;
    w->undo.offset = w->box.offset + n;
    w->several = has_several ? KERNEL_SEVERAL : 0;
    w->threshold = w->may_break ? limit * (1 - 1e-9) : INFINITY;
}

static void defer(struct sweep *w, int g) {
    w->b->segments->large[g] |= SOLID_SEGMENTS_LATER;
    w->deferred++;
}

/* Computes the forces of segment g. If bonds must break, or an eps is beyond the range of the series, the forces are
 * subtracted again and recomputed. That is rare, because segments near either limit are tested first. */
static void sweep_segment(struct sweep *w, int g) {
    struct solid_lattice *lattice = w->b;
    struct solid_segments *segments = lattice->segments;
    const int near_limit = segments->high[g] > NEAR_LIMIT * w->threshold;
    if (segments->stale[g]) solid_segments_pack(lattice, g);
    if (w->is_measure) {
        force_of(w, g, w->part | w->several | KERNEL_EXACT | (segments->bulk[g] ? KERNEL_BULK : 0));
        return;
    }
    if (near_limit && is_beyond(w, g)) {
        if (w->defers) {
            defer(w, g);
            return;
        }
        if (break_segment(w, g)) solid_segments_pack(lattice, g);
    }

    const enum solid_kernel plain = w->part | w->damped | w->several | (segments->bulk[g] ? KERNEL_BULK : 0),
                            exact = plain | KERNEL_EXACT, first = segments->large[g] ? exact : plain;
    struct solid_range range = force_of(w, g, first);
    if (w->part == KERNEL_PRESSED) return; /* the pass of extensions has tested its bonds */
    const int too_large = first == plain && fmax(range.high, -range.low) > w->series;
    const int may_break = !near_limit && range.high > w->threshold && (!w->several || is_beyond(w, g));
    if (may_break && w->defers) {
        undo(w, g, first);
        defer(w, g);
        return;
    }
    const int breaks = may_break && break_segment(w, g);
    if (too_large || breaks) {
        undo(w, g, first);
        if (breaks) solid_segments_pack(lattice, g);
        range = force_of(w, g, exact);
    }
    segments->high[g] = (float)range.high;
    segments->large[g] = fmax(range.high, -range.low) > (segments->large[g] ? 0.5 : 1) * w->series;
}

static void sweep_one(struct sweep *w, int g) {
    if (w->b->materials) set_material(w, g);
    sweep_segment(w, g);
}

struct shared {
    const struct sweep *w;
    const struct solid_slabs *slabs;
    double power[2 * THREADS_MAX];
    int deferred[2 * THREADS_MAX];
};

/* Every other slab, then the ones between. */
static void sweep_every_other(int thread, void *data) {
    struct shared *all = data;
    for (int turn = 0; turn < 2; turn++) {
        for (int i = 2 * thread + turn; i < all->slabs->n; i += 2 * threads_count()) {
            struct sweep w = *all->w;
            w.defers = 1;
            for (int k = all->slabs->first[i]; k < all->slabs->first[i + 1]; k++) sweep_one(&w, all->slabs->segment[k]);
            all->power[i] = w.power;
            all->deferred[i] = w.deferred;
        }
        threads_wait();
    }
}

/* Sweeps the slabs on all threads; then, on the first thread, the deferred segments, slab by slab. */
static void sweep_slabs(struct sweep *w, const struct solid_slabs *slabs) {
    struct shared all = {.w = w, .slabs = slabs};
    uint8_t *large = w->b->segments->large;
    threads_run(sweep_every_other, &all);
    for (int i = 0; i < slabs->n; i++) w->power += all.power[i];
    for (int i = 0; i < slabs->n; i++)
        for (int k = slabs->first[i]; all.deferred[i] && k < slabs->first[i + 1]; k++) {
            const int g = slabs->segment[k];
            if (!(large[g] & SOLID_SEGMENTS_LATER)) continue;
            large[g] &= (uint8_t)~SOLID_SEGMENTS_LATER;
            sweep_one(w, g);
        }
}

/* Mixed precision: the boxes of the sweep, of the same displacements and offsets. */
static void turn_single(struct sweep *w, struct solid_lattice_offset_single *offset) {
    const struct solid_lattice *lattice = w->b;
    const int n = lattice->stencil->n;
    struct solid_boxes_single *box = &w->box_single;
    solid_segment_single_offsets(w->box.offset, 2 * n, offset);
    *box = (struct solid_boxes_single){.w = lattice->w_single, .pressure = lattice->pressure_single, .offset = offset};
    for (int c = 0; c < 3; c++) {
        box->d[c] = lattice->d[c];
        box->d_single[c] = lattice->d_single[c];
        box->v[c] = lattice->v_single[c];
        box->a[c] = lattice->f_single[c];
    }
    w->undo_single = *box;
    w->undo_single.offset = offset + n;
    w->near = lattice->is_near ? KERNEL_NEAR : 0;
    w->series = SOLID_SINGLE_SERIES_LIMIT;
    w->threshold -= SOLID_SINGLE_EPS_ERROR;
}

static enum solid_kernel kernel_of(enum solid_sweep_part part) {
    switch (part) {
    case SOLID_SWEEP_FORCES:
        return 0;
    case SOLID_SWEEP_EXTENSIONS:
        return KERNEL_EXTENSION;
    case SOLID_SWEEP_PRESSED:
        return KERNEL_PRESSED;
    }
    ENSURE(0, "part %d of a sweep", (int)part);
}

/* Computes the forces of the inner segments (0) or the others (1); returns the power of damping, W. */
static double sweep_segments(struct solid *s, struct solid_lattice *lattice, const struct solid_sweep *sweep,
                             int others) {
    const struct solid_segments *segments = lattice->segments;
    const struct solid_slabs *slabs = &segments->slabs[others];
    const int from = others ? segments->inner : 0, to = others ? segments->n : segments->inner;
    struct solid_lattice_offset offset[2 * SOLID_FAMILY_MAX];
    struct solid_lattice_offset_single offset_single[2 * SOLID_FAMILY_MAX];
    /* the kernels' eps may differ from bond_eps in its last digit: bonds are tested from slightly below the limit */
    struct sweep w = {.s = s,
                      .b = lattice,
                      .threshold = sweep->may_break ? lattice->law.eps_limit * (1 - 1e-9) : INFINITY,
                      .part = kernel_of(sweep->part),
                      .is_measure = sweep->is_measure,
                      .damped = sweep->damping > 0 && sweep->part != SOLID_SWEEP_EXTENSIONS ? KERNEL_DAMPED : 0,
                      .may_break = sweep->may_break,
                      .series = SOLID_SERIES_LIMIT};
    const struct solid_materials *materials = lattice->materials;
    if (!materials) fill_offsets(lattice, sweep->damping, 1, offset);
    for (int k = 0; materials && k < materials->n; k++)
        fill_offsets(lattice, sweep->damping, materials->stiffer[k], materials->table + 2 * lattice->stencil->n * k);
    w.box = (struct solid_boxes){.w = lattice->w, .pressure = lattice->pressure, .offset = offset};
    if (materials) {
        w.box.half = materials->half;
        w.box.threshold = materials->threshold;
    }
    for (int c = 0; c < 3; c++) {
        w.box.d[c] = lattice->d[c];
        w.box.v[c] = lattice->v[c];
        w.box.a[c] = lattice->f[c];
    }
    w.undo = w.box;
    w.undo.offset = offset + lattice->stencil->n;
    if (lattice->w_single) turn_single(&w, offset_single);
    if (slabs->first)
        sweep_slabs(&w, slabs);
    else
        for (int g = from; g < to; g++) sweep_one(&w, g);
    const double spacing = lattice->stencil->spacing;
    return 0.5 * lattice->law.density * (spacing * spacing * spacing) * w.power;
}

/* Rows as the threads share them. */
struct rows {
    struct solid *s;
    struct solid_lattice *lattice;
    int damped;
    double farthest[THREADS_MAX]; /* largest size of a component of a displacement, m */
};

static void begin_rows(int thread, void *data) {
    struct rows *rows = data;
    int from, to;
    threads_share(rows->lattice->rows, SOLID_ROW, thread, &from, &to);
    rows->farthest[thread] = solid_fields_of(rows->lattice)->rows(rows->s, rows->lattice, from, to, rows->damped);
}

/* Copies rows and images to the field arrays. Returns whether their displacements may be rounded. */
static int fill(struct rows *rows) {
    struct solid_lattice *lattice = rows->lattice;
    double farthest = 0;
    threads_run(begin_rows, rows);
    for (int k = 0; k < threads_count(); k++) farthest = fmax(farthest, rows->farthest[k]);
    solid_fields_of(lattice)->copies(rows->s, lattice, lattice->ghosts, lattice->away, rows->damped);
    return farthest <= SOLID_SINGLE_NEAR * rows->s->in.spacing;
}

static int fill_ghosts(const struct rows *rows) {
    const struct solid_lattice *lattice = rows->lattice;
    const double farthest = solid_fields_of(lattice)->copies(rows->s, lattice, 0, lattice->ghosts, rows->damped);
    return farthest <= SOLID_SINGLE_NEAR * rows->s->in.spacing;
}

static void end_rows(int thread, void *data) {
    const struct rows *rows = data;
    int from, to;
    threads_share(rows->lattice->rows, SOLID_ROW, thread, &from, &to);
    solid_fields_of(rows->lattice)->end(rows->s, rows->lattice, from, to);
}

double solid_sweep_lattice_begin(struct solid *s, struct solid_lattice *lattice, const struct solid_sweep *sweep) {
    struct rows rows = {.s = s, .lattice = lattice, .damped = sweep->damping > 0};
    const int was_near = lattice->is_near;
    if (sweep->part == SOLID_SWEEP_PRESSED) return sweep_segments(s, lattice, sweep, 0);
    lattice->is_near = fill(&rows);
    if (was_near && !lattice->is_near) fill(&rows);
    return sweep_segments(s, lattice, sweep, 0);
}

double solid_sweep_lattice_end(struct solid *s, struct solid_lattice *lattice, const struct solid_sweep *sweep) {
    struct rows rows = {.s = s, .lattice = lattice, .damped = sweep->damping > 0};
    if (sweep->part != SOLID_SWEEP_PRESSED && !fill_ghosts(&rows) && lattice->is_near) {
        lattice->is_near = 0;
        fill(&rows);
        fill_ghosts(&rows);
    }
    const double power = sweep_segments(s, lattice, sweep, 1);
    threads_run(end_rows, &rows);
    const struct solid_materials *materials = sweep->part == SOLID_SWEEP_EXTENSIONS ? NULL : lattice->materials;
    for (int c = 0; c < 3 && materials && !materials->is_even; c++)
        for (int h = lattice->first; h < lattice->first + lattice->n; h++)
            s->a[c][h] *= materials->lighter[solid_materials_of(materials, h)];
    return power;
}
