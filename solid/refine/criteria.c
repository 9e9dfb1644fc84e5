/* Marks the particles that the energy and damage triggers select for refinement.  (000: sec. 2.1.1) */
#include "base/memory.h"
#include "base/par.h"
#include "base/vec_shuffle.h"
#include "solid/bonds/list_lanes.h"
#include "solid/force/dilatation.h"
#include "solid/force/sweep_family.h"
#include "solid/force/sweep_list.h"
#include "solid/imposed/constraint.h"
#include "solid/refine/parts.h"

#include <math.h>

/* A sum that is the same in any order: the terms are rounded to multiples of a digit that leaves room for 2^9 of the
 * largest. */
static double sum_of(const double *term, int n) {
    double most = 0, sum = 0;
    for (int k = 0; k < n; k++) most = fabs(term[k]) > most ? fabs(term[k]) : most;
    if (!(most > 0)) return 0;
    const double shift = ldexp(1.5, ilogb(most) + 11);
    for (int k = 0; k < n; k++) sum += (term[k] + shift) - shift;
    return sum;
}

/* sum_of, a vec of terms at a time, padded with 0; most: the largest term. */
static inline double sum_of_blocks(const double *term, long n, double most) {
    const vec shift = vec_set(vec_power_below(most) * 0x1.8p11);
    vec sum = vec_set(0);
    for (long k = 0; k < n; k += VEC_LANES) sum += (vec_load(term + k) + shift) - shift;
    return vec_total(sum);
}

/* 1/4 sum of alpha c s^2 |xi| Gamma V_l, with k = alpha c Gamma V_l/(rho |xi|), negative for a broken bond. From the
 * records. (001: eq. 3.23) */
static double energy_of(const struct solid_list *list, int i) {
    double term[SOLID_FAMILY_MAX + VEC_LANES];
    const double *here = list->record + (long)list->width * i;
    const long n = list->end[i] - list->start[i];
    vec most = vec_set(0);
    for (long k = 0; k < n; k += VEC_LANES) {
        const long j = list->start[i] + k;
        const vec x = vec_load_floats(solid_list_step(list, j, 0)), y = vec_load_floats(solid_list_step(list, j, 1));
        const vec stiffness = vec_load(list->stiffness + j), length2 = x * x + y * y;
        vec there[2];
        vec_shuffle_gather2(list->record, list->at + j, there);
        const vec dx = there[0] - here[0], dy = there[1] - here[1];
        const vec one = dx * (x + (x + dx)), two = dy * (y + (y + dy));
        const vec eps = (one + two) * vec_reciprocal(length2), stretch = eps / (1 + vec_sqrt(1 + eps));
        const vec energy = vec_where(solid_list_lanes_intact(list, j), stiffness * length2 * (stretch * stretch));
        most = vec_max(most, energy);
        vec_store(term + k, energy);
    }
    const double largest = vec_highest(most);
    return largest > 0 ? 0.25 * list->law.density * list->spacing * sum_of_blocks(term, n, largest) : 0;
}

/* 1/2 excess (M/M_0) theta^2 = 1/2 excess (n sum K |xi| s V)^2/(M M_0).  (solid/force/dilatation.h) */
static double of_dilatation(const struct solid *s, const struct solid_list *list, int i) {
    const struct solid_dilatation *d = s->dilatation;
    const double *here = list->record + (long)list->width * i, unit = list->law.density * list->spacing;
    double extension[SOLID_FAMILY_MAX], weight[SOLID_FAMILY_MAX];
    int n = 0;
    if (!d || !d->of_body[s->body[list->first + i]]) return 0;
    for (long j = list->start[i]; j < list->end[i]; j++) {
        const double *there = list->record + list->at[j];
        double xi[3], q[2];
        if (!solid_list_is_intact(list, j)) continue;
        solid_list_steps(list, j, xi);
        for (int c = 0; c < 2; c++) q[c] = (there[c] - here[c]) * (xi[c] + (xi[c] + (there[c] - here[c])));
        const double length2 = xi[0] * xi[0] + xi[1] * xi[1], eps = (q[0] + q[1]) / length2;
        weight[n] = list->plain[j] * length2;
        extension[n] = weight[n] * (eps / (1 + sqrt(1 + eps)));
        n++;
    }
    const double m = unit * sum_of(weight, n), sum = unit * 2 * sum_of(extension, n);
    return m > 0 ? 0.5 * d->excess[list->first + i] * sum * sum / (m * d->full[list->first + i]) : 0;
}

/* Upper bound of energy_of, if the list's last sweep was without damping at the present displacements: from the power
 * of two of its largest |eps| and the family's digit for k |xi|. INFINITY: no bound is known. */
static double energy_bound(const struct solid_list *list, int i) {
    const double eps = 2 * list->power[i];
    if (!(eps > 0) || eps > 0.03) return INFINITY;
    const double force = list->digit[i] / solid_list_headroom(list, i), reach = list->law.horizon + 1;
    return 0.25 * list->law.density * list->spacing * (double)(list->end[i] - list->start[i]) * force * reach *
           (0.26 * eps * eps);
}

/* The fraction of the family's volume with broken bonds, the same for mirror images. */
static double damage_of(const struct solid *s, int h) {
    struct solid_family_view view;
    double weight[SOLID_FAMILY_MAX], lost[SOLID_FAMILY_MAX];
    if (!(s->flag[h] & SOLID_BROKEN)) return 0;
    solid_family_view(s, h, &view);
    int broken = 0;
    for (int b = 0; b < view.n; b++) {
        weight[b] = view.weight[b];
        if (!view.intact[b]) lost[broken++] = view.weight[b];
    }
    const double all = sum_of(weight, view.n);
    return all > 0 ? sum_of(lost, broken) / all : 0;
}

/* The energy densities of the marked particles, and the largest of them. A particle that is known to have less than
 * `part` of the largest gets 0 and is not computed. */
static double energy_where(const struct solid *s, const uint8_t *mark, double part, double *energy) {
    const int is_bound = s->a_holds && s->stage_of_a.damping_relative == 0 && !s->dilatation;
    double most = 0;
    for (int b = 0; b < s->in.bodies; b++) {
        const struct solid_list *list = s->family->list[b];
        int first = -1; /* the particle with the largest eps: most others are then known to have less */
        double power = 0;
        for (int i = 0; is_bound && i < list->n; i++) {
            if (!mark[list->first + i] || list->power[i] <= power) continue;
            power = list->power[i];
            first = i;
        }
        solid_sweep_list_fill(s, list);
        if (first >= 0) most = fmax(most, energy_of(list, first));
        for (int i = 0; i < list->n; i++) {
            const int h = list->first + i;
            energy[h] = 0;
            if (!mark[h] || (is_bound && energy_bound(list, i) < part * most)) continue;
            energy[h] = energy_of(list, i) + of_dilatation(s, list, i);
            most = energy[h] > most ? energy[h] : most;
        }
    }
    return par_max(most);
}

static void marks_reserve(const struct solid *s) {
    struct solid_refine *r = s->refine;
    if (s->n < r->criteria_capacity) return;
    MEMORY_FREE(r->mark, r->energy);
    r->criteria_capacity = s->n + s->n / 8 + 256;
    r->mark = memory_new(MEMORY_SOLID, (size_t)r->criteria_capacity, 1);
    r->energy = memory_new(MEMORY_SOLID, (size_t)r->criteria_capacity, sizeof *r->energy);
}

long solid_refine_criteria(struct solid *s) {
    const struct solid_refinement *in = &s->refine->in;
    marks_reserve(s);
    uint8_t *mark = s->refine->mark;
    double *energy = s->refine->energy, most = 0;
    for (int h = 0; h < s->n; h++) mark[h] = (uint8_t)solid_constraint_inside(s, h, in->low, in->high, &in->turn);
    if (in->energy > 0) most = energy_where(s, mark, in->energy, energy);
    for (int h = 0; h < s->n; h++) {
        if (!mark[h]) continue;
        mark[h] = ((most > 0 && energy[h] >= in->energy * most) || (in->damage > 0 && damage_of(s, h) > in->damage)) &&
                  solid_refine_level(s, h) < in->levels;
    }
    return solid_refine_marked(s, mark);
}
