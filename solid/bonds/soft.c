/* The list of softening bonds: which there are, and the largest stretch of each so far. */
#include "solid/bonds/soft.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/law/softening.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct solid_soft *solid_soft_new(const struct solid *s) {
    int softens = 0;
    for (int m = 0; m < s->in.materials; m++) softens |= s->in.material[m].tensile_strength > 0;
    return softens ? memory_new(MEMORY_SOLID, 1, sizeof(struct solid_soft)) : NULL;
}

void solid_soft_free(struct solid_soft *soft) {
    if (!soft) return;
    MEMORY_FREE(soft->bond, soft);
}

void solid_soft_limits(const struct solid *s, int h, double *s_e, double *s_c) {
    const struct solid_lattice *lattice = s->family->lattice[s->body[h]];
    const struct solid_list *list = s->family->list[s->body[h]];
    *s_e = lattice ? lattice->law.s_e : list->law.s0;
    *s_c = lattice ? lattice->law.s_c : list->law.s_c;
}

static struct solid_soft_bond of_lattice(const struct solid_lattice *t, int h, int o) {
    const int cell = t->cell[h - t->first];
    const long far = cell + t->offset[o].shift;
    const struct solid_offset *from = &t->stencil->offset[o];
    const double alpha = 2 / (*solid_lattice_w(t, cell) + *solid_lattice_w(t, far));
    struct solid_soft_bond bond = {.h = h, .l = t->local[far], .length = from->length, .weight = from->weight};
    for (int k = 0; k < o; k++) bond.place += t->local[cell + t->offset[k].shift] >= 0;
    for (int c = 0; c < 3; c++) bond.xi[c] = from->xi[c];
    bond.elastic = alpha * t->law.c0 * from->weight;
    return bond;
}

static struct solid_soft_bond of_list(const struct solid_list *t, int h, long j) {
    struct solid_soft_bond bond = {.h = h, .l = solid_list_other(t, j), .place = (int)(j - t->start[h - t->first])};
    double xi[3];
    const double steps = solid_list_steps(t, j, xi);
    for (int c = 0; c < 3; c++) bond.xi[c] = xi[c] * t->spacing;
    bond.length = steps * t->spacing;
    bond.weight = solid_list_weight(t, h, j, solid_list_micromodulus(t, h, j));
    bond.elastic = fabs(t->stiffness[j]) * t->law.density * steps;
    return bond;
}

double solid_soft_plain(const struct solid *s, const struct solid_soft_bond *bond) {
    const struct solid_lattice *lattice = s->family->lattice[s->body[bond->h]];
    const struct solid_list *list = s->family->list[s->body[bond->h]];
    const double plain = lattice ? lattice->law.c0 * bond->weight
                                 : list->plain[bond->at] * list->law.density * (bond->length / list->spacing);
    return plain * bond->length;
}

static void append(struct solid_soft *soft, const struct solid_soft_bond *bond) {
    MEMORY_MORE(MEMORY_SOLID, soft->bond, soft->n, soft->capacity);
    soft->bond[soft->n++] = *bond;
    soft->added++;
}

void solid_soft_add(struct solid *s, int h, long at, double most) {
    struct solid_lattice *lattice = s->family->lattice[s->body[h]];
    struct solid_list *list = s->family->list[s->body[h]];
    struct solid_soft_bond bond = lattice ? of_lattice(lattice, h, (int)at) : of_list(list, h, at);
    bond.at = at;
    bond.most = most;
    if (lattice)
        solid_lattice_soften(lattice, h, (int)at, 1);
    else
        solid_list_soften(list, at, 1);
    append(s->soft, &bond);
}

void solid_soft_add_placed(struct solid *s, int h, int place, double most) {
    const struct solid_lattice *t = s->family->lattice[s->body[h]];
    long at;
    if (t) {
        const int cell = t->cell[h - t->first];
        for (at = 0; at < t->stencil->n; at++)
            if (t->local[cell + t->offset[at].shift] >= 0 && place-- == 0) break;
        ENSURE(at < t->stencil->n, "particle %d has no such bond", h);
    } else {
        const struct solid_list *list = s->family->list[s->body[h]];
        at = list->start[h - list->first] + place;
        ENSURE(at < list->end[h - list->first], "particle %d has no bond %d", h, place);
    }
    solid_soft_add(s, h, at, most);
    struct solid_soft_bond *bond = &s->soft->bond[s->soft->n - 1];
    double s_e, s_c;
    solid_soft_limits(s, h, &s_e, &s_c); /* 1/2 k times the sum of s_1 s_2 (f_1 - f_2), from s_e to `most` */
    bond->released = 0.25 * bond->elastic * s_e * s_c * (most - s_e) / (s_c - s_e) * bond->length * s->volume[bond->h];
}

static int compare(const void *a, const void *b) {
    const struct solid_soft_bond *x = a, *y = b;
    if (x->h != y->h) return x->h < y->h ? -1 : 1;
    return (x->place > y->place) - (x->place < y->place);
}

void solid_soft_order(struct solid_soft *soft) {
    if (soft->added > 0) qsort(soft->bond, (size_t)soft->n, sizeof *soft->bond, compare);
    soft->added = 0;
}

void solid_soft_break(struct solid *s, const struct solid_soft_bond *bond) {
    struct solid_lattice *lattice = s->family->lattice[s->body[bond->h]];
    struct solid_list *list = s->family->list[s->body[bond->h]];
    if (lattice) {
        solid_lattice_soften(lattice, bond->h, (int)bond->at, 0);
        solid_lattice_cut(lattice, bond->h, (int)bond->at);
    } else {
        solid_list_soften(list, bond->at, 0);
        solid_list_set(list, bond->at, 0);
    }
    s->flag[bond->h] |= SOLID_BROKEN;
    s->broke = 1;
}

void solid_soft_clear(struct solid *s) {
    for (int i = 0; i < s->soft->n; i++) {
        const struct solid_soft_bond *bond = &s->soft->bond[i];
        struct solid_lattice *lattice = s->family->lattice[s->body[bond->h]];
        if (lattice)
            solid_lattice_soften(lattice, bond->h, (int)bond->at, 0);
        else
            solid_list_soften(s->family->list[s->body[bond->h]], bond->at, 0);
    }
    s->soft->n = s->soft->added = 0;
}

/* The first bond of h in the list, or the place where it would be. */
static int first_of(const struct solid_soft *soft, int h) {
    int low = 0, high = soft->n;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (soft->bond[middle].h < h)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static int is_empty(const struct solid *s) { return !s->soft || s->soft->n == 0 || s->soft->is_hidden; }

void solid_soft_set_released(struct solid *s, int h, int place, double released) {
    for (int i = first_of(s->soft, h); i < s->soft->n && s->soft->bond[i].h == h; i++)
        if (s->soft->bond[i].place == place) s->soft->bond[i].released = released;
}

double solid_soft_share(const struct solid *s, int h, int place) {
    double s_e, s_c;
    if (is_empty(s)) return 1;
    for (int i = first_of(s->soft, h); i < s->soft->n && s->soft->bond[i].h == h; i++)
        if (s->soft->bond[i].place == place) {
            solid_soft_limits(s, h, &s_e, &s_c);
            return solid_softening_share(s_e, s_c, s->soft->bond[i].most);
        }
    return 1;
}

void solid_soft_weaken(const struct solid *s, int h, double *value) {
    double s_e, s_c;
    if (is_empty(s)) return;
    solid_soft_limits(s, h, &s_e, &s_c);
    for (int i = first_of(s->soft, h); i < s->soft->n && s->soft->bond[i].h == h; i++)
        value[s->soft->bond[i].place] *= solid_softening_share(s_e, s_c, s->soft->bond[i].most);
}
