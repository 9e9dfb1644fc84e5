/* The view of a particle's bonds, the same for both bond stores: lists, breaks, counts, saves and loads them. */
#include "solid/bonds/family.h"
#include "base/bits.h"
#include "base/ensure.h"
#include "base/par.h"
#include "solid/bonds/materials.h"
#include "solid/bonds/list_lanes.h"
#include "solid/bonds/soft.h"

#include <math.h>
#include <string.h>

/* The stencil offset of the b-th bond of lattice particle h. */
static int offset_of(const struct solid_lattice *lattice, int h, int b) {
    const int cell = lattice->cell[h - lattice->first];
    for (int o = 0; o < lattice->stencil->n; o++)
        if (lattice->local[cell + lattice->offset[o].shift] >= 0 && b-- == 0) return o;
    ENSURE(0, "particle %d has no bond %d", h, b);
}

static uint8_t *lambda_of(const struct solid_lattice *lattice, int h) {
    return lattice->lambda +
           (size_t)lattice->row_of[lattice->cell[h - lattice->first] / SOLID_ROW] * (size_t)lattice->stencil->n;
}

static void view_lattice(const struct solid_lattice *lattice, int h, struct solid_family_view *view) {
    const int cell = lattice->cell[h - lattice->first];
    const uint8_t *lambda = lambda_of(lattice, h);
    int n = 0;
    for (int o = 0; o < lattice->stencil->n; o++) {
        const long other = cell + lattice->offset[o].shift;
        if (lattice->local[other] < 0) continue;
        const struct solid_offset *bond = &lattice->stencil->offset[o];
        view->l[n] = lattice->local[other];
        for (int c = 0; c < 3; c++) view->xi[n][c] = bond->xi[c];
        view->weight[n] = bond->weight;
        view->alpha[n] = 2 / (*solid_lattice_w(lattice, cell) + *solid_lattice_w(lattice, other));
        view->micro[n] = solid_materials_law(lattice, h, lattice->local[other])->c0;
        view->intact[n] = lambda[o] >> cell % SOLID_ROW & 1;
        n++;
    }
    view->n = n;
}

static void view_list(const struct solid_list *list, int h, struct solid_family_view *view) {
    const long start = list->start[h - list->first];
    view->n = (int)(list->end[h - list->first] - start);
    for (int b = 0; b < view->n; b++) {
        const long j = start + b;
        view->l[b] = solid_list_other(list, j);
        solid_list_xi(list, j, view->xi[b]);
        view->alpha[b] = solid_list_alpha(list, h, j);
        view->micro[b] = solid_list_micromodulus(list, h, j);
        view->weight[b] = solid_list_weight(list, h, j, view->micro[b]);
        view->intact[b] = (uint8_t)solid_list_is_intact(list, j);
    }
}

void solid_family_view(const struct solid *s, int h, struct solid_family_view *view) {
    const struct solid_family *f = s->family;
    const int b = s->body[h];
    ENSURE(h >= 0 && h < s->n, "particle %d of %d owned", h, s->n);
    if (f->lattice[b])
        view_lattice(f->lattice[b], h, view);
    else
        view_list(f->list[b], h, view);
    solid_soft_weaken(s, h, view->micro);
}

int solid_family_initial_bonds(const struct solid *s, int h) {
    const struct solid_family *f = s->family;
    const int b = s->body[h];
    int n = 0;
    if (f->list[b]) {
        const struct solid_list *list = f->list[b];
        return (int)(list->end[h - list->first] - list->start[h - list->first]);
    }
    const struct solid_lattice *lattice = f->lattice[b];
    const int *local = lattice->local + lattice->cell[h - lattice->first];
    for (int o = 0; o < lattice->stencil->n; o++) n += local[lattice->offset[o].shift] >= 0;
    return n;
}

/* Of up to eight bytes: bit k is set if the lane's bit of byte k is not; of other bytes it is not set. */
static unsigned gone(const uint8_t *lambda, int bytes, int lane) {
    uint64_t word = UINT64_MAX;
    memcpy(&word, lambda, (size_t)bytes);
    word = ~word >> lane & 0x0101010101010101u;
    return (unsigned)(word * 0x0102040810204080u >> 56);
}

static int broken_in_lattice(const struct solid_lattice *lattice, int h, uint8_t *known, int *other) {
    const int cell = lattice->cell[h - lattice->first], offsets = lattice->stencil->n;
    const uint8_t *lambda = lambda_of(lattice, h);
    int n = 0;
    for (int o = 0; o < offsets; o += 8) {
        const int bytes = offsets - o < 8 ? offsets - o : 8;
        unsigned left = gone(lambda + o, bytes, cell % SOLID_ROW) & ~(unsigned)known[o / 8];
        known[o / 8] |= (uint8_t)left; /* of a site without a particle, too */
        for (; left; left &= left - 1) {
            other[n] = lattice->local[cell + lattice->offset[o + __builtin_ctz(left)].shift];
            n += other[n] >= 0;
        }
    }
    return n;
}

/* The broken bonds of a particle in a list: their numbers in its view, and the particles at their other ends. */
static int broken_in_list(const struct solid_list *list, int h, int *place, int *other) {
    const long start = list->start[h - list->first], end = list->end[h - list->first];
    int n = 0;
    for (long from = start; from < end; from += SOLID_LIST_BLOCK)
        for (unsigned left = ~solid_list_lanes_block_intact(list, from) & 0xffu; left; left &= left - 1) {
            const long j = from + __builtin_ctz(left);
            if (j >= end) break;
            place[n] = (int)(j - start);
            other[n++] = solid_list_other(list, j);
        }
    return n;
}

int solid_family_newly_broken(const struct solid *s, int h, uint8_t *known, int *other) {
    const struct solid_list *list = s->family->list[s->body[h]];
    int place[SOLID_FAMILY_MAX], n = 0;
    if (!list) return broken_in_lattice(s->family->lattice[s->body[h]], h, known, other);
    const int broken = broken_in_list(list, h, place, other);
    for (int k = 0; k < broken; k++) {
        const uint8_t bit = (uint8_t)(1u << place[k] % 8);
        if (known[place[k] / 8] & bit) continue;
        known[place[k] / 8] |= bit;
        other[n++] = other[k];
    }
    return n;
}

/* Bonds whose lambda is `intact`, 0 or 1. */
static int of_lattice(const struct solid_lattice *lattice, int h, unsigned intact, int *other, signed char (*step)[3]) {
    const int cell = lattice->cell[h - lattice->first];
    const uint8_t *lambda = lambda_of(lattice, h);
    int n = 0;
    for (int o = 0; o < lattice->stencil->n; o++) {
        if ((lambda[o] >> cell % SOLID_ROW & 1u) != intact) continue;
        other[n] = lattice->local[cell + lattice->offset[o].shift];
        for (int c = 0; c < 3; c++) step[n][c] = (signed char)lattice->stencil->offset[o].step[c];
        n += other[n] >= 0;
    }
    return n;
}

static void step_of_list(const struct solid_list *list, long j, signed char step[3]) {
    for (int c = 0; c < 3; c++) step[c] = c < list->dim ? (signed char)rintf(*solid_list_step(list, j, c)) : 0;
}

int solid_family_struts(const struct solid *s, int h, int *other, signed char (*step)[3]) {
    const struct solid_list *list = s->family->list[s->body[h]];
    int place[SOLID_FAMILY_MAX];
    if (!list) return of_lattice(s->family->lattice[s->body[h]], h, 0, other, step);
    const int n = broken_in_list(list, h, place, other);
    for (int k = 0; k < n; k++) step_of_list(list, list->start[h - list->first] + place[k], step[k]);
    return n;
}

int solid_family_intact(const struct solid *s, int h, int *other, signed char (*step)[3]) {
    const struct solid_list *list = s->family->list[s->body[h]];
    int n = 0;
    if (!list) return of_lattice(s->family->lattice[s->body[h]], h, 1, other, step);
    for (long j = list->start[h - list->first]; j < list->end[h - list->first]; j++) {
        if (!solid_list_is_intact(list, j)) continue;
        other[n] = solid_list_other(list, j);
        step_of_list(list, j, step[n++]);
    }
    return n;
}

int solid_family_intact_bonds(const struct solid *s, int h) {
    const struct solid_list *list = s->family->list[s->body[h]];
    int n = 0;
    if (!list) {
        const struct solid_lattice *lattice = s->family->lattice[s->body[h]];
        const uint8_t *lambda = lambda_of(lattice, h);
        const unsigned lane = lattice->cell[h - lattice->first] % SOLID_ROW;
        for (int o = 0; o < lattice->stencil->n; o++) n += lambda[o] >> lane & 1;
        return n;
    }
    for (long j = list->start[h - list->first]; j < list->end[h - list->first]; j += SOLID_LIST_BLOCK)
        n += __builtin_popcount(solid_list_lanes_block_intact(list, j));
    return n;
}

static void nearest_in_lattice(const struct solid_lattice *lattice, int h, int nearest[6]) {
    const int cell = lattice->cell[h - lattice->first];
    const long shift[3] = {1, lattice->size[0], (long)lattice->size[0] * lattice->size[1]};
    for (int f = 0; f < 6; f++) {
        const int l = lattice->local[cell + (f % 2 ? shift[f / 2] : -shift[f / 2])];
        nearest[f] = l < 0 ? -1 : l;
    }
}

void solid_family_nearest(const struct solid *s, int h, int nearest[6]) {
    const struct solid_list *list = s->family->list[s->body[h]];
    if (!list) {
        nearest_in_lattice(s->family->lattice[s->body[h]], h, nearest);
        return;
    }
    for (int f = 0; f < 6; f++) nearest[f] = -1;
    for (long j = list->start[h - list->first]; j < list->end[h - list->first]; j++) {
        double xi[3];
        if (solid_list_steps(list, j, xi) > 1.25) continue;
        for (int c = 0; c < list->dim; c++)
            if (fabs(xi[c]) > 0.75) nearest[2 * c + (xi[c] > 0)] = solid_list_other(list, j);
    }
}

void solid_family_break(struct solid *s, int h, int b) {
    const struct solid_family *f = s->family;
    int l;
    if (f->lattice[s->body[h]]) {
        struct solid_lattice *t = f->lattice[s->body[h]];
        const int o = offset_of(t, h, b);
        l = t->local[t->cell[h - t->first] + t->offset[o].shift];
        solid_lattice_cut(t, h, o);
        if (l < s->n) solid_lattice_cut(t, l, t->stencil->n - 1 - o);
    } else {
        struct solid_list *t = f->list[s->body[h]];
        const long j = t->start[h - t->first] + b;
        l = solid_list_other(t, j);
        struct solid_list *other = f->list[s->body[l]];
        const long reverse = solid_list_reverse(t, other, h, j);
        solid_list_set(t, j, 0);
        if (reverse >= 0) solid_list_set(other, reverse, 0);
    }
    s->flag[h] |= SOLID_BROKEN;
    if (l < s->n) s->flag[l] |= SOLID_BROKEN;
    s->broke = 1;
    s->a_holds = 0;
}

int solid_family_is_mixed(const struct solid *s, int body) {
    const struct solid_lattice *lattice = s->family->lattice[body];
    return lattice && lattice->w_single;
}

int solid_family_bytes(const struct solid *s) { return s->family->bytes; }

void solid_family_save(const struct solid *s, int h, uint8_t *bits) {
    const struct solid_family *f = s->family;
    memset(bits, 0, (size_t)f->bytes);
    int b = 0;
    if (f->lattice[s->body[h]]) {
        const struct solid_lattice *t = f->lattice[s->body[h]];
        const int cell = t->cell[h - t->first];
        const uint8_t *lambda = lambda_of(t, h);
        for (int o = 0; o < t->stencil->n; o++) {
            if (t->local[cell + t->offset[o].shift] < 0) continue;
            bits[b / 8] |= (uint8_t)((lambda[o] >> cell % SOLID_ROW & 1) << b % 8);
            b++;
        }
    } else {
        const struct solid_list *t = f->list[s->body[h]];
        for (long j = t->start[h - t->first]; j < t->end[h - t->first]; j++, b++)
            bits[b / 8] |= (uint8_t)(solid_list_is_intact(t, j) << b % 8);
    }
}

void solid_family_load(struct solid *s, int h, const uint8_t *bits) {
    const struct solid_family *f = s->family;
    int b = 0, lost = 0;
    if (f->lattice[s->body[h]]) {
        struct solid_lattice *t = f->lattice[s->body[h]];
        const int cell = t->cell[h - t->first];
        uint8_t *lambda = lambda_of(t, h), *soft = t->soft ? t->soft + (lambda - t->lambda) : NULL;
        solid_lattice_changed(t, h);
        for (int o = 0; soft && o < t->stencil->n; o++) soft[o] &= (uint8_t) ~(1u << cell % SOLID_ROW);
        for (int o = 0; o < t->stencil->n; o++) {
            if (t->local[cell + t->offset[o].shift] < 0) continue;
            const unsigned intact = bits[b / 8] >> b % 8 & 1u;
            lambda[o] = (uint8_t)((lambda[o] & ~(1u << cell % SOLID_ROW)) | intact << cell % SOLID_ROW);
            lost += !intact;
            b++;
        }
    } else {
        struct solid_list *t = f->list[s->body[h]];
        for (long j = t->start[h - t->first]; j < t->end[h - t->first]; j++, b++) {
            const int intact = bits[b / 8] >> b % 8 & 1;
            if (t->soft) solid_list_soften(t, j, 0);
            solid_list_set(t, j, intact);
            lost += !intact;
        }
    }
    if (lost)
        s->flag[h] |= SOLID_BROKEN;
    else
        s->flag[h] &= (uint8_t)~SOLID_BROKEN;
    s->a_holds = 0;
}

long solid_family_directed(const struct solid *s) {
    const struct solid_family *f = s->family;
    long count = 0;
    uint8_t made[SOLID_FAMILY_MAX];
    for (int b = 0; b < f->bodies; b++) {
        if (f->list[b]) count += f->list[b]->bonds;
        for (int r = 0; f->lattice[b] && r < f->lattice[b]->rows; r++) {
            solid_lattice_initial_bonds(f->lattice[b], r, made);
            count += bits_count(made, (size_t)f->lattice[b]->stencil->n);
        }
    }
    return count;
}

void solid_family_count(struct solid *s) {
    const struct solid_family *f = s->family;
    long intact = 0;
    for (int b = 0; b < f->bodies; b++) {
        const struct solid_lattice *lattice = f->lattice[b];
        intact += lattice ? bits_count(lattice->lambda, (size_t)lattice->rows * (size_t)lattice->stencil->n)
                          : solid_list_intact(f->list[b]);
    }
    s->bonds_broken = s->bonds_total - par_sum_long(intact) / 2;
}
