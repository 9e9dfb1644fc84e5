/* What is to be refined.  (000: sec. 2.1.1) */
#include "base/memory.h"
#include "base/par.h"
#include "solid/constraint.h"
#include "solid/family.h"
#include "solid/list.h"
#include "solid/measures.h"
#include "solid/refine_parts.h"

#include <math.h>
#include <string.h>

/* A sum of numbers not below 0 that is the same in any order: of multiples of a digit that leaves room for 2^10 of the largest. */
static double sum_of(const double *term, int n) {
    double most = 0, sum = 0;
    for (int k = 0; k < n; k++) most = fmax(most, term[k]);
    if (!(most > 0)) return 0;
    const double digit = ldexp(1, ilogb(most) - 42);
    for (int k = 0; k < n; k++) sum += digit * rint(term[k] / digit);
    return sum;
}

/* 1/4 sum of alpha c s^2 |xi| Gamma V_l, with k = alpha c Gamma V_l/(rho |xi|).  (001: eq. 3.23) */
static double energy_of(const struct solid *s, const struct solid_list *t, int i) {
    double term[SOLID_FAMILY_MAX];
    const int h = t->first + i;
    int n = 0;
    for (long j = t->start[i]; j < t->end[i]; j++) {
        if (!solid_list_is_intact(t, j)) continue;
        const int l = solid_list_other(t, j);
        double xi[3], q = 0;
        const double length = solid_list_steps(t, j, xi);
        for (int c = 0; c < 2; c++) {
            const double eta = (s->d[c][l] - s->d[c][h]) / t->spacing;
            const double of = eta * (xi[c] + (xi[c] + eta));
            q = c == 0 ? of : q + of;
        }
        const double eps = q / (length * length), stretch = eps / (1 + sqrt(1 + eps));
        term[n++] = t->stiffness[j] * (length * length) * (stretch * stretch);
    }
    return 0.25 * t->law.density * t->spacing * sum_of(term, n);
}

void solid_refine_energy(const struct solid *s, double *energy) {
    for (int b = 0; b < s->in.bodies; b++) {
        const struct solid_list *t = s->family->list[b];
        for (int i = 0; i < t->n; i++) energy[t->first + i] = energy_of(s, t, i);
    }
}

/* The part of the family's volume that is behind broken bonds, the same for mirror images. */
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

/* Of the particles that mark says, and the largest of them. */
static double energy_where(const struct solid *s, const uint8_t *mark, double *energy) {
    double most = 0;
    for (int b = 0; b < s->in.bodies; b++) {
        const struct solid_list *t = s->family->list[b];
        for (int i = 0; i < t->n; i++) {
            const int h = t->first + i;
            energy[h] = mark[h] ? energy_of(s, t, i) : 0;
            most = fmax(most, energy[h]);
        }
    }
    return par_max(most);
}

long solid_refine_look(struct solid *s) {
    const struct solid_refinement *in = &s->refine->in;
    uint8_t *mark = memory_new(MEMORY_SOLID, (size_t)s->n + 1, 1);
    double *energy = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *energy), most = 0;
    for (int h = 0; h < s->n; h++) mark[h] = (uint8_t)solid_constraint_inside(s, h, in->low, in->high);
    if (in->energy > 0) most = energy_where(s, mark, energy);
    for (int h = 0; h < s->n; h++) {
        if (!mark[h]) continue;
        mark[h] = solid_refine_level(s, h) < in->levels && ((most > 0 && energy[h] >= in->energy * most) ||
                                                            (in->damage > 0 && damage_of(s, h) > in->damage));
    }
    const long refined = solid_refine_marked(s, mark);
    memory_free(energy);
    memory_free(mark);
    return refined;
}
