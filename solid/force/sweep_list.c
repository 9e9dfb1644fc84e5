/* Force sweep over the bonds of a body in the list store: one kernel per dimension, series and damping; breaks
 * bonds. */
#include "base/threads.h"
#include "solid/bonds/breaks.h"
#include "solid/bonds/soft.h"
#include "solid/force/dilatation_loss.h"
#include "solid/force/sweep_family.h"
#include "solid/force/sweep_list.h"
#include "solid/force/sweep_rows.h"
#include "solid/force/absorbed.h"

#include <math.h>

/* Bonds are tested from slightly below the limit: the kernels' eps may differ from bond_eps in its last digit. */
static const double NEAR_LIMIT = 1 - 1e-9;

static inline __attribute__((always_inline)) void fill_places(const struct solid *s, const struct solid_list *list,
                                                              const int dim) {
    const int width = dim == 2 ? 2 : 4;
    const double inv_spacing = 1 / list->spacing, *d[3];
    for (int c = 0; c < dim; c++) d[c] = s->d[c];
    for (long r = 0; r < list->n; r++)
        for (int c = 0; c < dim; c++) list->record[width * r + c] = d[c][list->first + r] * inv_spacing;
    for (long r = 0; r < list->others; r++)
        for (int c = 0; c < dim; c++)
            list->record[width * (list->n + r) + c] = d[c][list->other_local[r]] * inv_spacing;
}

void solid_sweep_list_fill(const struct solid *s, const struct solid_list *list) {
    if (list->dim == 2)
        fill_places(s, list, 2);
    else
        fill_places(s, list, 3);
}

static void speeds_new(struct solid_list *list) {
    const int records = list->n + list->others;
    list->speed = solid_store_array((size_t)SOLID_LIST_SPEED * (size_t)records, sizeof *list->speed);
    for (int r = 0; r < records; r++) list->speed[(long)SOLID_LIST_SPEED * (r + 1) - 1] = list->w[r];
}

static void fill(const struct solid *s, struct solid_list *list, int damped) {
    solid_sweep_list_fill(s, list);
    if (damped && !list->speed) speeds_new(list);
    for (int r = 0; damped && r < list->n + list->others; r++)
        for (int c = 0; c < list->dim; c++)
            list->speed[(long)SOLID_LIST_SPEED * r + c] = s->v[c][solid_list_local(list, r)];
    if (list->rows) solid_list_rows_fill(list, damped);
}

/* The kernels of a family, compiled for a plate and for 3D, with and without damping, with square roots (exact) and
 * with the series. */
typedef struct solid_sweep_family kernel(const struct solid_list *, int i, double viscous);
#define KERNEL(name, dim, exact, damped)                                                                               \
    static __attribute__((noinline)) struct solid_sweep_family name(const struct solid_list *b, int i,                 \
                                                                    double viscous) {                                  \
        return solid_sweep_family_of(b, i, viscous, dim, exact, damped, 0);                                            \
    }                                                                                                                  \
    static __attribute__((noinline)) struct solid_sweep_family pressed_##name(const struct solid_list *b, int i,       \
                                                                              double viscous) {                        \
        return solid_sweep_family_of(b, i, viscous, dim, exact, damped, 1);                                            \
    }
KERNEL(plane_series, 2, 0, 0)
KERNEL(plane_exact, 2, 1, 0)
KERNEL(plane_damped_series, 2, 0, 1)
KERNEL(plane_damped_exact, 2, 1, 1)
KERNEL(space_series, 3, 0, 0)
KERNEL(space_exact, 3, 1, 0)
KERNEL(space_damped_series, 3, 0, 1)
KERNEL(space_damped_exact, 3, 1, 1)

static kernel *const kernels[2][2][2] = {{{plane_series, plane_exact}, {plane_damped_series, plane_damped_exact}},
                                         {{space_series, space_exact}, {space_damped_series, space_damped_exact}}};

/* The same with the pressure of dilatations, and their sums; the latter know no damping. */
#define EXTENSION(name, dim, exact)                                                                                    \
    static __attribute__((noinline)) struct solid_sweep_family name(const struct solid_list *b, int i,                 \
                                                                    double viscous) {                                  \
        (void)viscous;                                                                                                 \
        return solid_sweep_family_extension(b, i, dim, exact);                                                         \
    }
EXTENSION(plane_extension_series, 2, 0)
EXTENSION(plane_extension_exact, 2, 1)
EXTENSION(space_extension_series, 3, 0)
EXTENSION(space_extension_exact, 3, 1)

static kernel *const pressed_kernels[2][2][2] = {
    {{pressed_plane_series, pressed_plane_exact}, {pressed_plane_damped_series, pressed_plane_damped_exact}},
    {{pressed_space_series, pressed_space_exact}, {pressed_space_damped_series, pressed_space_damped_exact}}};
static kernel *const extension_kernels[2][2] = {{plane_extension_series, plane_extension_exact},
                                                {space_extension_series, space_extension_exact}};

/* The same of a row. Not inlined: the compiler keeps all numbers of a small loop in registers. */
static __attribute__((noinline)) struct solid_sweep_family row_series(const struct solid_list *b,
                                                                      const struct solid_list_row *row, int first) {
    return solid_sweep_rows_of(b, row, first, 0, 0);
}
static __attribute__((noinline)) struct solid_sweep_family
row_damped_series(const struct solid_list *b, const struct solid_list_row *row, int first, double viscous) {
    return solid_sweep_rows_of(b, row, first, viscous, 1);
}

static inline struct solid_sweep_family row_sums(const struct solid_list *b, const struct solid_list_row *row,
                                                 int first, double viscous, int damped) {
    return damped ? row_damped_series(b, row, first, viscous) : row_series(b, row, first);
}

/* The number that decides whether a bond breaks. Both ends get the same value to the bit: all signs are opposite,
 * nothing else differs. */
static __attribute__((noinline)) double bond_eps(const double *xi, const double *eta, int dim) {
    double q = 0, xi2 = 0;
    for (int c = 0; c < dim; c++) {
        q += eta[c] * (xi[c] + (xi[c] + eta[c]));
        xi2 += xi[c] * xi[c];
    }
    return q / xi2;
}

/* Not inlined, so that the sums of the sweep are rounded the same whether broken bonds are recorded or not. */
static __attribute__((noinline)) void record(struct solid *s, const struct solid_list *list, int h, long j,
                                             double stretch, double taken, double s0) {
    double xi[3];
    const double length = solid_list_steps(list, j, xi);
    const double energy = 0.25 * list->law.density * list->stiffness[j] * length * (length * list->spacing) *
                          s->volume[h]; /* of this end's half, over the square of the stretch */
    for (int c = 0; c < 3; c++) xi[c] *= list->spacing;
    solid_breaks_add(s, h, solid_list_other(list, j), xi, taken * (energy * stretch * stretch),
                     energy * s0 * s0 / solid_list_bonds_energy(list, j));
}

/* Breaks the bonds of the particle that are stretched beyond their limits, on its side; bonds that soften are moved to
 * the list of softening bonds. Returns how many. */
static int break_bonds(struct solid *s, struct solid_list *list, int i) {
    const int h = list->first + i;
    const double *here = list->record + (long)list->width * i;
    int broken = 0;
    for (long j = list->start[i]; j < list->end[i]; j++) {
        const double *there = list->record + list->at[j];
        double xi[3], eta[3] = {0};
        if (!solid_list_is_swept(list, j) || ((s->flag[h] | s->flag[solid_list_other(list, j)]) & SOLID_UNBREAKABLE))
            continue;
        const double length = solid_list_steps(list, j, xi);
        for (int c = 0; c < list->dim; c++) eta[c] = there[c] - here[c];
        const double eps = bond_eps(xi, eta, list->dim);
        if (!(eps > list->eps_limit[i])) continue;
        const double limit = solid_list_limit(list, h, j);
        if (!(eps > limit)) continue;
        broken++;
        if (list->soft) {
            solid_soft_add(s, h, j, list->law.s0);
            continue;
        }
        const double stretch = eps / (1 + sqrt(1 + eps));
        solid_list_xi(list, j, xi);
        const double taken = solid_absorbed_fraction(s, h, solid_list_other(list, j), xi, stretch);
        s->e_fracture += taken * (0.25 * list->law.density * list->stiffness[j] * length * stretch * stretch *
                                  (length * list->spacing) * s->volume[h]);
        const double s0 = limit / (1 + sqrt(1 + limit));
        s->crack_area += 0.25 * list->law.density * list->stiffness[j] * length * s0 * s0 * (length * list->spacing) *
                         s->volume[h] / solid_list_bonds_energy(list, j);
        if (s->breaks) record(s, list, h, j, stretch, taken, s0);
        if (s->dilatation)
            solid_dilatation_loss_add(s,
                                      &(struct solid_dilatation_loss){.h = h,
                                                                      .l = solid_list_other(list, j),
                                                                      .xi = {xi[0], xi[1], xi[2]},
                                                                      .stiffness = list->plain[j] * list->law.density *
                                                                                   length * length * list->spacing,
                                                                      .now = stretch,
                                                                      .before = taken * stretch,
                                                                      .soft = -1});
        solid_list_set(list, j, 0);
    }
    if (broken && !list->soft) {
        s->flag[h] |= SOLID_BROKEN;
        s->broke = 1;
    }
    return broken;
}

/* Whether power is the power of two at or below the largest of a. */
static inline int is_power_below(double power, vec a) {
    const double before = power * (1 - 0x1p-53);
    return !vec_any_above(a, 2 * before) && (power == 0 || vec_any_above(a, before));
}

struct sweep {
    struct solid *s;
    struct solid_list *b;
    kernel *const *kernels; /* series, exact */
    double *power;          /* list->power, or of the sums of extensions */
    double viscous;
    int may_break, damped;
    int by_force; /* 1: digits follow from the largest component of a force; 0: from the largest |eps| */
    enum solid_sweep_part part;
    int is_measure;
    int defers; /* 1: particles with bonds that may break are deferred */
};

/* The values that determine the rounding digit of a sum. */
static inline vec decides(const struct sweep *k, const struct solid_sweep_family *sums) {
    return k->by_force ? sums->largest : sums->far;
}

/* The sums, rounded to the right digits. */
static struct solid_sweep_family in_digits(const struct sweep *k, int i, int exact) {
    struct solid_list *list = k->b;
    struct solid_sweep_family sums = k->kernels[exact](list, i, k->viscous);
    const vec a = decides(k, &sums);
    if (list->dim == 3 || is_power_below(k->power[i], a)) return sums;
    k->power[i] = vec_power_below(vec_highest(a));
    return k->kernels[exact](list, i, k->viscous);
}

static inline int may_break_here(const struct sweep *k, int i, const struct solid_sweep_family *sums) {
    return k->may_break && vec_any_above(sums->high, k->b->eps_limit[i] * NEAR_LIMIT);
}

/* Computes a family that the fast path cannot: again, if bonds break or an eps is beyond the range of the series; with
 * square roots from the start, if eps was large in the last sweep. */
static __attribute__((noinline)) struct solid_sweep_family swept_with_breakage(const struct sweep *k, int i) {
    struct solid_list *list = k->b;
    const int exact = list->large[i];
    const struct solid_sweep_family sums = in_digits(k, i, exact);
    const int too_large = vec_any_above(sums.far, (exact ? 0.5 : 1) * SOLID_SERIES_LIMIT);
    const int broken = may_break_here(k, i, &sums) && break_bonds(k->s, list, i);
    list->large[i] = (uint8_t)too_large;
    return broken || (too_large && !exact) ? in_digits(k, i, exact || too_large) : sums;
}

enum { ROW_FEWEST = (VEC_LANES + 1) / 2 }; /* particles of a row at a time; fewer are swept faster by their lists */
enum { LATER = 2 };                        /* in list->large until the first thread has come to the particle */

/* Sweeps particle i, unless it is deferred. Returns the power of its viscous forces, over half the density. */
static inline __attribute__((always_inline)) double sweep_one(const struct sweep *k, int i, const int dim,
                                                              const int damped) {
    struct solid *s = k->s;
    struct solid_list *list = k->b;
    const int h = list->first + i;
    struct solid_sweep_family sums = solid_sweep_family_of(list, i, k->viscous, dim, 0, damped, 0);
    if (k->defers && may_break_here(k, i, &sums)) {
        list->large[i] |= LATER;
        return 0;
    }
    if (list->large[i] || vec_any_above(sums.far, SOLID_SERIES_LIMIT) || may_break_here(k, i, &sums) ||
        (dim == 2 && !is_power_below(list->power[i], damped ? sums.largest : sums.far)))
        sums = swept_with_breakage(k, i);
    for (int c = 0; c < dim; c++) s->a[c][h] = vec_total(sums.sum[c]);
    return damped ? vec_sum(sums.power) * s->volume[h] : 0;
}

/* The same of the sums of extensions, or with pressures, by kernels that are not inlined. */
static double sweep_dilated(const struct sweep *k, int i) {
    struct solid *s = k->s;
    struct solid_list *list = k->b;
    const int h = list->first + i;
    struct solid_sweep_family sums = k->kernels[k->is_measure](list, i, k->viscous);
    if (k->defers && may_break_here(k, i, &sums)) {
        list->large[i] |= LATER;
        return 0;
    }
    if (k->is_measure)
        sums = in_digits(k, i, 1);
    else if (list->large[i] || vec_any_above(sums.far, SOLID_SERIES_LIMIT) || may_break_here(k, i, &sums) ||
             (list->dim == 2 && !is_power_below(k->power[i], decides(k, &sums))))
        sums = swept_with_breakage(k, i);
    for (int c = 0; c < list->dim; c++) s->a[c][h] = vec_total(sums.sum[c]);
    return k->damped ? vec_sum(sums.power) * s->volume[h] : 0;
}

static __attribute__((noinline)) double sweep_alone(const struct sweep *k, int i) {
    if (k->part != SOLID_SWEEP_FORCES) return sweep_dilated(k, i);
    if (k->b->dim == 2) return k->damped ? sweep_one(k, i, 2, 1) : sweep_one(k, i, 2, 0);
    return k->damped ? sweep_one(k, i, 3, 1) : sweep_one(k, i, 3, 0);
}

/* Which of the complete particles of a row must be swept by their lists, because bonds may break or eps is large: a bit
 * for each. Here and below: of the particles from `first` on, as many as a vec has lanes. */
static inline unsigned row_swept_again(const struct sweep *k, const struct solid_list_row *row, int first,
                                       const struct solid_sweep_family *sums) {
    unsigned bits = ~vec_signs((vec)(sums->far <= SOLID_SERIES_LIMIT));
    if (k->may_break) bits |= ~vec_signs((vec)(sums->high <= k->b->rows->eps_limit * NEAR_LIMIT));
    for (int lane = 0; lane < VEC_LANES; lane++)
        bits |= (unsigned)(k->b->large[row->particle[first + lane]] != 0) << lane;
    return bits & row->complete >> first & VEC_ALL;
}

/* Sets the powers of those particles of a row whose digit does not fit. Returns whether there are some. */
static inline int row_powers_set(const struct sweep *k, const struct solid_list_row *row, int first, vec a,
                                 unsigned bits) {
    const vec before = solid_sweep_rows_load(k->b->power, row, first) * (1 - 0x1p-53);
    bits &= ~vec_signs((vec)((a <= 2 * before) & ((before == 0) | (a > before))));
    for (unsigned wrong = bits; wrong; wrong &= wrong - 1) {
        const int lane = __builtin_ctz(wrong);
        k->b->power[row->particle[first + lane]] = vec_power_below(a[lane]);
    }
    return bits != 0;
}

/* Writes the sums of some of a row's particles. Returns the power of their viscous forces. */
static inline double row_write(const struct sweep *k, const struct solid_list_row *row, int first,
                               const struct solid_sweep_family *sums, unsigned bits) {
    struct solid *s = k->s;
    double power = 0;
    for (int lane = 0; lane < VEC_LANES; lane++) {
        const int h = k->b->first + row->particle[first + lane];
        if (!(bits >> lane & 1)) continue;
        for (int c = 0; c < 2; c++) s->a[c][h] = sums->sum[c][lane];
        if (k->damped) power += sums->power[lane] * s->volume[h];
    }
    return power;
}

/* Sweeps the complete particles among those; where the fast path does not hold, or they are few, by their lists. */
static inline double sweep_row_from(const struct sweep *k, const struct solid_list_row *row, int first) {
    const unsigned complete = row->complete >> first & VEC_ALL;
    unsigned alone = complete;
    double power = 0;
    if (__builtin_popcount(complete) >= ROW_FEWEST) {
        struct solid_sweep_family sums = row_sums(k->b, row, first, k->viscous, k->damped);
        alone = row_swept_again(k, row, first, &sums);
        if (row_powers_set(k, row, first, decides(k, &sums), complete & ~alone))
            sums = row_sums(k->b, row, first, k->viscous, k->damped);
        power = row_write(k, row, first, &sums, complete & ~alone);
    }
    for (; alone; alone &= alone - 1) power += sweep_alone(k, row->particle[first + __builtin_ctz(alone)]);
    return power;
}

static double sweep_row(const struct sweep *k, const struct solid_list_row *row) {
    double power = 0;
    for (int first = 0; first < SOLID_LIST_BLOCK; first += VEC_LANES) power += sweep_row_from(k, row, first);
    return power;
}

static double sweep_rows(const struct sweep *k, int from, int to) {
    double power = 0;
    for (int r = from; r < to; r++) power += sweep_row(k, &k->b->rows->row[r]);
    return power;
}

/* Sweeps the particles from .. to-1 that are in no row, or the deferred ones among them. */
static inline __attribute__((always_inline)) double sweep_run(const struct sweep *k, int from, int to, const int dim,
                                                              const int damped) {
    const uint8_t *complete = dim == 2 && k->b->rows ? k->b->rows->complete : NULL;
    double power = 0;
    for (int i = from; i < to; i++)
        if (!complete || !complete[i]) power += sweep_one(k, i, dim, damped);
    return power;
}

static double sweep_part(const struct sweep *k, int from, int to) {
    double power = 0;
    if (k->part != SOLID_SWEEP_FORCES) {
        for (int i = from; i < to; i++) power += sweep_dilated(k, i);
        return power;
    }
    if (k->b->dim == 2) return k->damped ? sweep_run(k, from, to, 2, 1) : sweep_run(k, from, to, 2, 0);
    return k->damped ? sweep_run(k, from, to, 3, 1) : sweep_run(k, from, to, 3, 0);
}

/* Parts of a body that the threads share: their sums are the same on any number of threads. */
enum { PARTS = THREADS_MAX };

/* A part of n numbers: from .. to-1, in multiples of `unit` but for the end. */
static void part_of(int n, int unit, int part, int *from, int *to) {
    const long units = (n + unit - 1) / unit;
    const long first = units * part / PARTS * unit, next = units * (part + 1) / PARTS * unit;
    *from = first < n ? (int)first : n;
    *to = next < n ? (int)next : n;
}

struct shared {
    const struct sweep *k;
    double power[PARTS];
};

static void sweep_of_thread(int thread, void *data) {
    struct shared *all = data;
    const struct solid_list_rows *rows = all->k->part == SOLID_SWEEP_FORCES ? all->k->b->rows : NULL;
    int first, next, from, to;
    threads_share(PARTS, 1, thread, &first, &next);
    for (int part = first; part < next; part++) {
        part_of(all->k->b->n, SOLID_LIST_BLOCK, part, &from, &to);
        all->power[part] = sweep_part(all->k, from, to);
    }
    for (int part = first; rows && part < next; part++) {
        part_of(rows->rows, 1, part, &from, &to);
        all->power[part] += sweep_rows(all->k, from, to);
    }
}

/* Sweeps the particles on all threads; then, in their order, the deferred ones. */
double solid_sweep_list(struct solid *s, struct solid_list *list, const struct solid_sweep *asked) {
    const int extends = asked->part == SOLID_SWEEP_EXTENSIONS, presses = asked->part == SOLID_SWEEP_PRESSED,
              damped = asked->damping > 0 && !extends;
    struct sweep k = {.s = s,
                      .b = list,
                      .kernels = extends   ? extension_kernels[list->dim - 2]
                                 : presses ? pressed_kernels[list->dim - 2][damped]
                                           : kernels[list->dim - 2][damped],
                      .power = extends ? list->extension_power : list->power,
                      .by_force = damped || presses,
                      .part = asked->part,
                      .is_measure = asked->is_measure,
                      .viscous = asked->damping / (2 * list->law.c),
                      .may_break = asked->may_break,
                      .damped = damped,
                      .defers = asked->may_break};
    struct shared all = {.k = &k};
    double power = 0;
    if (!presses) fill(s, list, asked->damping > 0);
    threads_run(sweep_of_thread, &all);
    for (int part = 0; part < PARTS; part++) power += all.power[part];
    k.defers = 0;
    for (int i = 0; k.may_break && i < list->n; i++) {
        if (!(list->large[i] & LATER)) continue;
        list->large[i] &= (uint8_t)~LATER;
        power += sweep_alone(&k, i);
    }
    return 0.5 * list->law.density * power;
}
