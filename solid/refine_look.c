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

/* A sum of numbers not below 0 that is the same in any order: of multiples of a digit that leaves room for 2^9 of the largest, rounded
 * by the last digit of a number that large. */
static double sum_of(const double *term, int n) {
    double most = 0, sum = 0;
    for (int k = 0; k < n; k++) most = term[k] > most ? term[k] : most;
    if (!(most > 0)) return 0;
    const double shift = ldexp(1.5, ilogb(most) + 11);
    for (int k = 0; k < n; k++) sum += (term[k] + shift) - shift;
    return sum;
}

/* The way of each of its family, spacings. */
static int ways_of(const struct solid *s, const struct solid_list *t, int i,
                   double eta[2][SOLID_FAMILY_MAX]) {
    const int h = t->first + i, n = (int)(t->end[i] - t->start[i]);
    for (int k = 0; k < n; k++) {
        const int l = solid_list_other(t, t->start[i] + k);
        for (int c = 0; c < 2; c++) eta[c][k] = (s->d[c][l] - s->d[c][h]) / t->spacing;
    }
    return n;
}

/* 1/4 sum of alpha c s^2 |xi| Gamma V_l, with k = alpha c Gamma V_l/(rho |xi|), negative where broken.  (001: eq. 3.23) */
static double energy_of(const struct solid *s, const struct solid_list *t, int i) {
    double eta[2][SOLID_FAMILY_MAX], term[SOLID_FAMILY_MAX];
    const int n = ways_of(s, t, i, eta);
    for (int k = 0; k < n; k++) {
        const long j = t->start[i] + k;
        const double x = *solid_list_step(t, j, 0), y = *solid_list_step(t, j, 1), length2 = x * x + y * y;
        const double one = eta[0][k] * (x + (x + eta[0][k])), two = eta[1][k] * (y + (y + eta[1][k]));
        const double eps = (one + two) / length2, stretch = eps / (1 + sqrt(1 + eps));
        const double of = t->stiffness[j] * length2 * (stretch * stretch);
        term[k] = of > 0 ? of : 0;
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

static void look_make_room(const struct solid *s) {
    struct solid_refine *r = s->refine;
    if (s->n < r->looked) return;
    memory_free(r->mark);
    memory_free(r->energy);
    r->looked = s->n + s->n / 4 + 1024;
    r->mark = memory_new(MEMORY_SOLID, (size_t)r->looked, 1);
    r->energy = memory_new(MEMORY_SOLID, (size_t)r->looked, sizeof *r->energy);
}

long solid_refine_look(struct solid *s) {
    const struct solid_refinement *in = &s->refine->in;
    look_make_room(s);
    uint8_t *mark = s->refine->mark;
    double *energy = s->refine->energy, most = 0;
    for (int h = 0; h < s->n; h++) mark[h] = (uint8_t)solid_constraint_inside(s, h, in->low, in->high);
    if (in->energy > 0) most = energy_where(s, mark, energy);
    for (int h = 0; h < s->n; h++) {
        if (!mark[h]) continue;
        mark[h] = solid_refine_level(s, h) < in->levels && ((most > 0 && energy[h] >= in->energy * most) ||
                                                            (in->damage > 0 && damage_of(s, h) > in->damage));
    }
    return solid_refine_marked(s, mark);
}
