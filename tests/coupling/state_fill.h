/* Fills every variable of a run's state with values that no other variable or place has. */
#pragma once
#include "base/par.h"
#include "coupling/run_state.h"
#include "cracks/outlet.h"
#include "cracks/project.h"
#include "cracks/state_table.h"
#include "solid/bonds/breaks.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/segments.h"
#include "solid/bonds/soft.h"
#include "solid/contact/list.h"
#include "solid/force/dilatation.h"
#include "solid/imposed/external_loads.h"
#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

/* Items without a plain member, and what fills them and reads them. seed: 1, 2: other values. */
typedef void filler(struct run *r, const struct state_item *item, const struct state_part *part, int seed);
typedef size_t reader(struct run *r, void *bytes); /* into bytes, room for 1 MB; returns how many */
struct special {
    const char *name;
    filler *fill;
    reader *read; /* NULL: item->save does */
};

static void fill_nothing(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)r, (void)item, (void)part, (void)seed;
}

static void fill_stage(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    r->stage = 2 - seed;
}

/* One more bond of some particles is broken. */
static void fill_bonds(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    struct solid_family_view view;
    (void)item, (void)part;
    for (int h = seed; h < r->solid->n && r->needs.breakage; h += 7) {
        solid_family_view(r->solid, h, &view);
        for (int b = 0; b < view.n; b++)
            if (view.intact[b]) {
                solid_family_break(r->solid, h, b);
                break;
            }
    }
}

/* The other flags decide on what is in which list. */
static void fill_flag(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    for (int h = 0; h < r->solid->n + r->solid->n_ghost; h++)
        if (h % 5 == seed) r->solid->flag[h] ^= SOLID_UNBREAKABLE;
}

static void fill_piece(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    for (int h = 0; h < r->solid->n; h++) r->solid->fragment[h] = 1000 * seed + r->solid->first[par_rank()] + h;
}

/* Normals and feelers of the interface. */
static void fill_surface(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    const int comps = item->comps_of(part->owner);
    double *value = calloc((size_t)r->solid->n * (size_t)comps + 1, sizeof *value);
    char why[64];
    item->save(part->owner, value);
    for (int i = 0; i < r->surface->n; i++)
        for (int c = 0; c < 9; c++) value[r->surface->h[i] * comps + c] *= 1 + 1e-6 * seed;
    assert_int_equal(item->load(part->owner, value, why, sizeof why), 0);
    free(value);
}

static void fill_extension(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    for (int h = 0; h < r->solid->n; h++) r->solid->dilatation->extension[h] = 10 * seed + 0.01 * h;
}

static void fill_marker_force(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    double *value = calloc(3 * (size_t)r->solid->n + 1, sizeof *value);
    char why[64];
    for (int i = 0; i < 3 * r->solid->n; i++) value[i] = seed + 0.001 * i;
    assert_int_equal(item->load(part->owner, value, why, sizeof why), 0);
    free(value);
}

static void fill_given(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    solid_external_loads_update(r->solid, 0.1 * seed, 0);
}

static size_t read_given(struct run *r, void *bytes) {
    solid_external_loads_save(r->solid, bytes);
    return (size_t)r->solid->in.loads * sizeof(double);
}

static void path_of(struct run *r, int b, uint8_t **large, void **high, size_t *size, int *n) {
    const struct solid_family *f = r->solid->family;
    *large = f->lattice[b] ? f->lattice[b]->segments->large : f->list[b]->large;
    *high = f->lattice[b] ? (void *)f->lattice[b]->segments->high : (void *)f->list[b]->power;
    *size = f->lattice[b] ? sizeof(float) : sizeof(double);
    *n = f->lattice[b] ? f->lattice[b]->segments->n : f->list[b]->n;
}

static void fill_paths(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    for (int b = 0; b < r->solid->in.bodies; b++) {
        uint8_t *large;
        void *high;
        size_t size;
        int n;
        path_of(r, b, &large, &high, &size, &n);
        memset(large, seed - 1, (size_t)n);
        memset(high, 16 * seed, (size_t)n * size);
    }
}

static size_t read_paths(struct run *r, void *bytes) {
    char *to = bytes;
    for (int b = 0; b < r->solid->in.bodies; b++) {
        uint8_t *large;
        void *high;
        size_t size;
        int n;
        path_of(r, b, &large, &high, &size, &n);
        memcpy(to, large, (size_t)n);
        memcpy(to + n, high, (size_t)n * size);
        to += (size_t)n * (1 + size);
    }
    return (size_t)(to - (char *)bytes);
}

/* The lists are longest at first: what is added to them later is cut off. */
static void fill_contact(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    struct solid_contact *c = r->solid->contact;
    (void)item, (void)part;
    if (!c) return;
    for (int k = 0; k < SOLID_CONTACT_KINDS && seed == 2; k++) c->pairs[k].n = 0;
    c->any = seed;
}

static size_t read_contact(struct run *r, void *bytes) {
    const struct solid_contact *c = r->solid->contact;
    int *to = bytes;
    for (int k = 0; c && k < SOLID_CONTACT_KINDS; k++) to[k] = c->pairs[k].n;
    to[SOLID_CONTACT_KINDS] = c ? c->any : 0;
    return (SOLID_CONTACT_KINDS + 1) * sizeof *to;
}

/* One more bond of some particles softens. */
static void fill_soft(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    struct solid_family_view view;
    (void)item, (void)part;
    for (int h = seed; h < r->solid->n; h += 7) {
        solid_family_view(r->solid, h, &view);
        for (int b = seed; b < view.n; b++)
            if (view.intact[b] && solid_soft_share(r->solid, h, b) == 1) {
                double s_e, s_c;
                solid_soft_limits(r->solid, h, &s_e, &s_c);
                solid_soft_add_placed(r->solid, h, b, s_e + 0.1 * (s_c - s_e));
                break;
            }
    }
    solid_soft_order(r->solid->soft);
}

static size_t read_soft(struct run *r, void *bytes) {
    double *to = bytes;
    for (int i = 0; i < r->solid->soft->n; i++) {
        const struct solid_soft_bond *bond = &r->solid->soft->bond[i];
        *to++ = bond->h;
        *to++ = bond->l;
        *to++ = bond->place;
        *to++ = (double)bond->at;
        *to++ = bond->weight;
        *to++ = bond->elastic;
        *to++ = bond->most;
    }
    return (size_t)((char *)to - (char *)bytes);
}

static void fill_released(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    for (int i = 0; i < r->solid->soft->n; i++) {
        struct solid_soft_bond *bond = &r->solid->soft->bond[i];
        bond->released = seed + 1e-3 * bond->place;
    }
}

static size_t read_released(struct run *r, void *bytes) {
    double *to = bytes;
    for (int i = 0; i < r->solid->soft->n; i++) *to++ = r->solid->soft->bond[i].released;
    return (size_t)((char *)to - (char *)bytes);
}

static void fill_breaks(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    const double xi[3] = {1, 0, 0};
    (void)item, (void)part;
    for (int k = 0; k < seed; k++) solid_breaks_add(r->solid, 0, 0, xi, 1, 1);
}

static size_t read_breaks(struct run *r, void *bytes) {
    const struct solid_breaks *b = r->solid->breaks;
    const long number[2] = {b->made, b->n};
    memcpy(bytes, number, sizeof number);
    return sizeof number;
}

/* Values by global id. */
static void fill_wet(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    struct cracks *c = r->cracks;
    (void)item, (void)part;
    cracks_project_end(c);
    for (int i = 0; i < c->struts.n; i++) {
        const double base = 100 * seed + 1e-3 * (double)(r->solid->first[par_rank()] + c->struts.h[i]);
        c->p[i] = base;
        c->content[i] = base + 1;
        c->cavity[i] = base + 2;
        c->volume[i] = base + 3;
        c->storage[i] = base + 4;
        c->share[i] = (cracks_vec){base + 5, base + 6, 0, 0};
        if (c->since) c->since[i] = base + 7;
    }
}

static void fill_injected(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    r->cracks->injected[0] = seed;
    r->cracks->rate[0] = 10 * seed;
}

static void fill_totals(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    r->cracks->leaked = seed;
    r->cracks->filled = 10 * seed;
    r->cracks->began = 1;
}

static void fill_outlets(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    const struct cracks_struts *t = &r->cracks->struts;
    struct cracks_outlets *m = r->cracks->outlets;
    (void)item, (void)part;
    cracks_project_end(r->cracks);
    cracks_outlet_reserve(m, t->n);
    m->n = t->n;
    for (int i = 0; i < t->n; i++) {
        const double base = 100 * seed + 1e-3 * (double)(r->solid->first[par_rank()] + t->h[i]);
        m->h[i] = t->h[i];
        m->rate[i] = base;
        m->gain[t->h[i]] = base + 1;
    }
}

static void fill_periods(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    r->steady.trend.periods = 2;
    for (int k = 0; k < 2; k++)
        r->steady.trend.period[k] = (struct trend_period){seed + k, 10 * seed + k, 5 * seed + k};
}

static void fill_means(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    for (int q = 0; q < 3; q++)
        for (int c = 0; c < 3; c++) {
            r->inner_mean[q].velocity[c] = 100 * seed + 10 * q + c;
            r->inner_mean[q].excess[c] = 100 * seed + 10 * q + c + 5;
        }
}

static const struct special special[] = {{"stage", fill_stage, NULL},
                                         {"spacing", fill_nothing, NULL},
                                         {"beginning", fill_nothing, NULL},
                                         {"tables", fill_nothing, NULL},
                                         {"body", fill_nothing, NULL},
                                         {"level", fill_nothing, NULL},
                                         {"place", fill_nothing, NULL},
                                         {"bonds", fill_bonds, NULL},
                                         {"flag", fill_flag, NULL},
                                         {"surface", fill_surface, NULL},
                                         {"extension", fill_extension, NULL},
                                         {"demand", fill_marker_force, NULL},
                                         {"given", fill_given, read_given},
                                         {"paths", fill_paths, read_paths},
                                         {"contact", fill_contact, read_contact},
                                         {"piece", fill_piece, NULL},
                                         {"softening", fill_soft, read_soft},
                                         {"breaks", fill_breaks, read_breaks},
                                         {"softening_released", fill_released, read_released},
                                         {"crack_fluid", fill_wet, NULL},
                                         {"crack_injected", fill_injected, NULL},
                                         {"crack_totals", fill_totals, NULL},
                                         {"crack_mouths", fill_outlets, NULL},
                                         {"trend_period", fill_periods, NULL},
                                         {"inner_mean", fill_means, NULL}};

static const struct special *special_of(const struct state_item *item) {
    for (size_t k = 0; k < sizeof special / sizeof special[0]; k++)
        if (!strcmp(special[k].name, item->name)) return &special[k];
    if (item->save || item->bytes == 0)
        fail_msg("%s has functions of its own: state_fill.h must be told how to fill it", item->name);
    return NULL;
}

static struct state_size size_of(const struct state_part *part) {
    struct state_size size = {0};
    part->size(part->owner, &size);
    return size;
}

/* Values of a plain array on this rank, ghosts included. */
static size_t values_of(const struct state_item *item, const struct state_size *size) {
    if (item->shape == STATE_CELL) return size->cells;
    return (size_t)(size->n + (item->ghosts ? size->n_ghost : 0));
}

/* Numbers that no other item or place has; displacements stay small. */
static void fill_plain(const struct state_item *item, const struct state_part *part, int number, int seed) {
    const struct state_size size = size_of(part);
    const double scale = strcmp(item->name, "displacement") == 0 ? 1e-12 : 1;
    const int share = item->shape == STATE_SHARE ? par_rank() : 0;
    const double base = 1000 * number + 500 * seed + 0.25 + share;
    if (item->shape == STATE_ONE || item->shape == STATE_SHARE) {
        char *member = state_item_array(item, part, 0);
        const long count = 10 * number + seed;
        const int small = (int)count;
        if (item->kind == STATE_DOUBLE)
            for (size_t k = 0; k < item->bytes / sizeof base; k++)
                memcpy(member + k * sizeof base, &(double){base + (double)k}, sizeof base);
        else if (item->kind == STATE_LONG)
            memcpy(member, &count, sizeof count);
        else if (item->kind == STATE_INT)
            memcpy(member, &small, sizeof small);
        else
            memset(member, small, item->bytes);
        return;
    }
    assert_int_equal(item->kind, STATE_DOUBLE);
    const int comps = state_item_comps(item, part);
    for (int c = 0; c < comps; c++) {
        double *value = state_item_array(item, part, c);
        const long first = item->shape == STATE_PARTICLE ? size.first : 0;
        for (size_t i = 0; i < values_of(item, &size); i++)
            value[i] = scale * (base + 0.125 * c + 1e-6 * (double)(first + (long)i));
    }
}

static void fill(struct run *r, int seed) {
    struct run_state state;
    run_state_of(r, &state);
    for (int last = 0; last < 2; last++)
        for (int k = 0; k < state.list.n; k++) {
            const struct state_item *item = state.list.at[k].item;
            const struct special *is = special_of(item);
            if (item->last != last) continue;
            if (is)
                is->fill(r, item, state.list.at[k].part, seed);
            else
                fill_plain(item, state.list.at[k].part, k + 1, seed);
        }
}
