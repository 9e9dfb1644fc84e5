/* The table of the state of the cracks' fluid: what a later step depends on, by wet particle and by injection. */
#include "cracks/state_table.h"
#include "base/memory.h"
#include "base/par.h"
#include "cracks/outlet.h"
#include "cracks/project.h"
#include "solid/state_table.h"

#include <string.h>

/* A row of a wet particle: global id, p, content, cavity, volume, storage, share, since (0 if nothing leaks off). The
 * row of the totals: leaked, filled, began. A row of what
 * a wet particle got from the fluid outside: global id, rate as an outlet (0: it is none), gain. */
enum { WET_ROW = 10, INJECTION_ROW = 2, TOTAL_ROW = 3, OUTLET_ROW = 3 };

static struct cracks *cracks_of(const void *owner) { return (struct cracks *)(uintptr_t)owner; }

static long wet_rows(const void *owner) { return cracks_of(owner)->struts.n; }

static void save_wet(void *owner, void *value) {
    const struct cracks *c = cracks_of(owner);
    double(*row)[WET_ROW] = value;
    for (int i = 0; i < c->struts.n; i++) {
        const double values[WET_ROW] = {(double)(c->solid->first[par_rank()] + c->struts.h[i]),
                                        c->p[i],
                                        c->content[i],
                                        c->cavity[i],
                                        c->volume[i],
                                        c->storage[i],
                                        c->share[i][0],
                                        c->share[i][1],
                                        c->share[i][2],
                                        c->since ? c->since[i] : 0};
        memcpy(row[i], values, sizeof values);
    }
}

/* Replaces the wet particles and their values, by local index. The struts are made again before they are used. */
static void restore_wet(void *owner, long n, const void *value) {
    struct cracks *c = cracks_of(owner);
    struct cracks_struts *t = &c->struts;
    const double(*row)[WET_ROW] = value;
    const long first = c->solid->first[par_rank()];
    t->h = memory_renew(MEMORY_SOLID, t->h, (size_t)n + 1, sizeof *t->h);
    double **const array[] = {&c->p, &c->content, &c->cavity, &c->volume, &c->storage};
    for (int a = 0; a < 5; a++) *array[a] = memory_renew(MEMORY_SOLID, *array[a], (size_t)n + 1, sizeof **array[a]);
    c->share = memory_renew(MEMORY_SOLID, c->share, (size_t)n + 1, sizeof *c->share);
    if (c->since) c->since = memory_renew(MEMORY_SOLID, c->since, (size_t)n + 1, sizeof *c->since);
    for (long i = 0; i < n; i++) {
        t->h[i] = (int)((long)row[i][0] - first);
        for (int a = 0; a < 5; a++) (*array[a])[i] = row[i][1 + a];
        c->share[i] = (cracks_vec){row[i][6], row[i][7], row[i][8], 0};
        if (c->since) c->since[i] = row[i][9];
    }
    t->n = (int)n;
    t->ghosts = 0;
    c->restored = 1;
    c->status.failed = 0;
}

static int load_wet(void *owner, long n, const void *value) {
    struct cracks *c = cracks_of(owner);
    struct solid *s = c->solid;
    const double(*all)[WET_ROW] = value;
    double(*own)[WET_ROW] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *own);
    int found = 0;
    for (long k = 0; k < n; k++) {
        const long h = (long)all[k][0] - s->first[par_rank()];
        if (h < 0 || h >= s->n || found == s->n) continue;
        memcpy(own[found++], all[k], sizeof *own);
    }
    restore_wet(owner, found, own);
    memory_free(own);
    cracks_project_end(c);
    return 0;
}

static long injection_rows(const void *owner) { return cracks_of(owner)->in.injections; }

static void save_injections(void *owner, void *value) {
    const struct cracks *c = cracks_of(owner);
    double(*row)[INJECTION_ROW] = value;
    for (int q = 0; q < c->in.injections; q++) row[q][0] = c->injected[q], row[q][1] = c->rate[q];
}

static int load_injections(void *owner, long n, const void *value) {
    struct cracks *c = cracks_of(owner);
    const double(*row)[INJECTION_ROW] = value;
    if (n != c->in.injections) return 1;
    for (int q = 0; q < n; q++) c->injected[q] = row[q][0], c->rate[q] = row[q][1];
    return 0;
}

static long total_rows(const void *owner) {
    (void)owner;
    return 1;
}

static int has_totals(const void *owner) {
    const struct cracks *c = owner;
    return c->in.porous || c->in.leak_off > 0;
}

static void save_totals(void *owner, void *value) {
    const struct cracks *c = cracks_of(owner);
    const double row[TOTAL_ROW] = {c->leaked, c->filled, c->began};
    memcpy(value, row, sizeof row);
}

static int load_totals(void *owner, long n, const void *value) {
    struct cracks *c = cracks_of(owner);
    const double *row = value;
    if (n != 1) return 1;
    c->leaked = row[0];
    c->filled = row[1];
    c->began = row[2] > 0;
    return 0;
}

static int has_outlets(const void *owner) { return cracks_of(owner)->outlets != NULL; }

static long outlet_rows(const void *owner) { return cracks_of(owner)->struts.n; }

static void save_outlets(void *owner, void *value) {
    const struct cracks *c = cracks_of(owner);
    double(*row)[OUTLET_ROW] = value;
    for (int i = 0; i < c->struts.n; i++) {
        const int h = c->struts.h[i];
        row[i][0] = (double)(c->solid->first[par_rank()] + h);
        row[i][1] = cracks_outlet_rate(c->outlets, h);
        row[i][2] = c->outlets->gain[h];
    }
}

/* Takes the rows of this rank's particles. What else an outlet has is set in the next step. */
static int load_outlets(void *owner, long n, const void *value) {
    struct cracks *c = cracks_of(owner);
    struct cracks_outlets *m = c->outlets;
    const double(*row)[OUTLET_ROW] = value;
    m->n = 0;
    memset(m->gain, 0, (size_t)c->solid->n * sizeof *m->gain);
    for (long k = 0; k < n; k++) {
        const long h = (long)row[k][0] - c->solid->first[par_rank()];
        if (h < 0 || h >= c->solid->n) continue;
        cracks_outlet_reserve(m, m->n + 1);
        m->h[m->n] = (int)h;
        m->rate[m->n++] = row[k][1];
        m->gain[h] = row[k][2];
    }
    return 0;
}

/* The members from one up to another. */
#define MEMBERS(from, to)                                                                                              \
    .offset = offsetof(struct cracks, from), .bytes = offsetof(struct cracks, to) - offsetof(struct cracks, from)

/* Last, when bonds, displacements and loads of the solid are in place. A checkpoint of a scene without the fluid leaves
 * the cracks empty. */
const struct state_item cracks_state_table[] = {
    {"crack_fluid", STATE_DOUBLE, STATE_ROWS, MEMBERS(p, injected), .comps = WET_ROW, .last = 1, .in = STATE_BOTH,
     .missing = STATE_LEFT, .rows_of = wet_rows, .save = save_wet, .load_rows = load_wet, .restore_rows = restore_wet},
    {"crack_injected", STATE_DOUBLE, STATE_ROWS, MEMBERS(injected, leaked), .comps = INJECTION_ROW, .last = 1,
     .in = STATE_BOTH, .missing = STATE_LEFT, .rows_of = injection_rows, .save = save_injections,
     .load_rows = load_injections, .is_shared = 1},
    {"crack_totals", STATE_DOUBLE, STATE_ROWS, MEMBERS(leaked, entered), .comps = TOTAL_ROW, .last = 1,
     .in = STATE_BOTH, .missing = STATE_LEFT, .is_part = has_totals, .rows_of = total_rows, .save = save_totals,
     .load_rows = load_totals, .is_shared = 1},
    {"crack_entered", STATE_DOUBLE, STATE_ONE, STATE_MEMBER(struct cracks, entered), .last = 1, .in = STATE_BOTH,
     .missing = STATE_LEFT, .is_part = has_outlets},
    {"crack_resolved", STATE_DOUBLE, STATE_ONE, STATE_MEMBER(struct cracks, resolved), .last = 1, .in = STATE_BOTH,
     .missing = STATE_LEFT, .is_part = has_outlets},
    {"crack_handed", STATE_DOUBLE, STATE_ONE, STATE_MEMBER(struct cracks, handed), .last = 1, .in = STATE_BOTH,
     .missing = STATE_LEFT, .is_part = has_outlets},
    {"crack_mouths", STATE_DOUBLE, STATE_ROWS, MEMBERS(outlets, struts), .comps = OUTLET_ROW, .last = 1,
     .in = STATE_BOTH, .missing = STATE_LEFT, .is_part = has_outlets, .rows_of = outlet_rows, .save = save_outlets,
     .load_rows = load_outlets},
};

#undef MEMBERS

static void size_of(const void *owner, struct state_size *size) {
    solid_state_table_size(cracks_of(owner)->solid, size);
}

struct state_part cracks_state_table_part(struct cracks *c) {
    return (struct state_part){.item = cracks_state_table,
                               .items = sizeof cracks_state_table / sizeof cracks_state_table[0],
                               .base = c,
                               .owner = c,
                               .size = size_of};
}
