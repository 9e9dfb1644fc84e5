/* Keeps the solid's whole state in memory and restores it, to the bit. */
#include "solid/keep.h"
#include "base/bits.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/lost.h"
#include "solid/bonds/segments.h"
#include "solid/contact/keep.h"
#include "solid/force/sweep_lattice.h"
#include "solid/imposed/given.h"
#include "solid/surface/state.h"

#include <string.h>

enum { VECTORS = 4, ARRAYS = 3 * VECTORS, SHARES = 5, PATHS = 2 };

/* How the last sweep went over a body's bonds: which way each is taken next. */
struct path {
    int n;
    void *copy[PATHS];
    size_t size[PATHS];
};

struct solid_keep {
    int taken;
    double *copy[ARRAYS];
    size_t count[ARRAYS];
    double t, share[SHARES], *factor;
    int broke, a_holds;
    struct solid_stage stage_of_a;
    uint8_t *flag;
    struct path *path; /* [bodies] */
    int bodies;
    /* bonds; lost NULL: none ever breaks */
    struct solid_lost *lost; /* whose bits are not those of now */
    uint8_t *bits;           /* [n][bytes] */
    long version, bonds_broken;
    struct solid_contact_keep contact;
    struct solid_surface_keep *surface;
};

/* Displacement and velocity with the ghosts', load, bonds' and contact's part of the acceleration. */
static void arrays_of(const struct solid *s, double *array[ARRAYS], size_t count[ARRAYS]) {
    const size_t n = (size_t)s->n, all = n + (size_t)s->n_ghost;
    for (int c = 0; c < 3; c++) {
        double *const vector[VECTORS] = {s->d[c], s->v[c], s->load[c], s->v_old[c]};
        for (int k = 0; k < VECTORS; k++) {
            array[3 * k + c] = vector[k];
            count[3 * k + c] = vector[k] ? k < 2 ? all : n : 0;
        }
    }
}

static int is_acceleration(int array) { return array >= 3 * (VECTORS - 1); }

static void shares_of(struct solid *s, double *at[SHARES]) {
    double *const all[SHARES] = {&s->e_damped, &s->e_fracture, &s->e_constraint, &s->work_load, &s->power_pairwise};
    memcpy(at, all, sizeof all);
}

static int path_of(const struct solid *s, int b, void *at[PATHS], size_t size[PATHS]) {
    const struct solid_lattice *t = s->family->lattice[b];
    const struct solid_list *list = s->family->list[b];
    at[0] = t ? (void *)t->segments->large : (void *)list->large;
    at[1] = t ? (void *)t->segments->high : (void *)list->power;
    size[0] = 1;
    size[1] = t ? sizeof *t->segments->high : sizeof *list->power;
    return t ? t->segments->n : list->n;
}

struct solid_keep *solid_keep_new(const struct solid *s, const struct solid_surface *surface, int may_break) {
    struct solid_keep *k = memory_new(MEMORY_OUTPUT, 1, sizeof *k);
    const size_t n = (size_t)s->n;
    double *array[ARRAYS];
    arrays_of(s, array, k->count);
    for (int i = 0; i < ARRAYS; i++)
        if (array[i]) k->copy[i] = memory_new(MEMORY_OUTPUT, k->count[i] + 1, sizeof(double));
    k->flag = memory_new(MEMORY_OUTPUT, n + (size_t)s->n_ghost + 1, 1);
    k->factor = memory_new(MEMORY_OUTPUT, (size_t)s->in.loads + 1, sizeof *k->factor);
    k->bodies = s->family->bodies;
    k->path = memory_new(MEMORY_OUTPUT, (size_t)k->bodies, sizeof *k->path);
    for (int b = 0; b < k->bodies; b++) {
        void *at[PATHS];
        k->path[b].n = path_of(s, b, at, k->path[b].size);
        for (int i = 0; i < PATHS; i++)
            k->path[b].copy[i] = memory_new(MEMORY_OUTPUT, (size_t)k->path[b].n + 1, k->path[b].size[i]);
    }
    if (surface) k->surface = solid_surface_state_keep_new(s);
    if (!may_break) return k;
    k->lost = solid_lost_new(s);
    k->bits = memory_new(MEMORY_OUTPUT, n * (size_t)solid_family_bytes(s) + 1, 1);
    k->version = -1; /* all bonds are to be taken */
    return k;
}

void solid_keep_free(struct solid_keep *k) {
    if (!k) return;
    for (int i = 0; i < ARRAYS; i++) memory_free(k->copy[i]);
    for (int b = 0; b < k->bodies; b++)
        for (int i = 0; i < PATHS; i++) memory_free(k->path[b].copy[i]);
    solid_lost_free(k->lost);
    solid_contact_keep_free(&k->contact);
    solid_surface_state_keep_free(k->surface);
    void *const own[] = {k->flag, k->factor, k->path, k->bits, k};
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) memory_free(own[i]);
}

static void take_bonds(struct solid_keep *k, const struct solid *s) {
    const size_t bytes = (size_t)solid_family_bytes(s);
    const int all = k->version != s->bonds_version;
    if (all) solid_lost_forget(k->lost, s);
    const int found = solid_lost_find(k->lost, s), n = all ? s->n : found;
    for (int i = 0; i < n; i++) {
        const int h = all ? i : k->lost->h[i];
        solid_family_save(s, h, k->bits + (size_t)h * bytes);
    }
    k->version = s->bonds_version;
    k->bonds_broken = s->bonds_broken;
}

/* Families that have lost bonds since; returns how many. */
static int restore_bonds(struct solid_keep *k, struct solid *s) {
    const size_t bytes = (size_t)solid_family_bytes(s);
    const int found = solid_lost_find(k->lost, s);
    for (int i = 0; i < found; i++) {
        const int h = k->lost->h[i];
        const uint8_t *bits = k->bits + (size_t)h * bytes;
        solid_family_load(s, h, bits);
        k->lost->intact[h] = (uint16_t)bits_count(bits, bytes);
        struct solid_list *t = s->family->list[s->body[h]];
        if (t) t->counted[h - t->first] = 0;
    }
    if (found > 0) solid_lost_find(k->lost, s); /* rows too */
    k->version = s->bonds_version = ++s->versions;
    s->bonds_broken = k->bonds_broken;
    return found;
}

void solid_keep_take(struct solid_keep *k, struct solid *s, const struct solid_surface *surface) {
    double *array[ARRAYS], *share[SHARES];
    size_t count[ARRAYS];
    arrays_of(s, array, count);
    for (int i = 0; i < ARRAYS; i++)
        if (array[i] && (s->a_holds || !is_acceleration(i))) memcpy(k->copy[i], array[i], count[i] * sizeof(double));
    shares_of(s, share);
    for (int i = 0; i < SHARES; i++) k->share[i] = *share[i];
    solid_given_keep(s, k->factor);
    memcpy(k->flag, s->flag, (size_t)(s->n + s->n_ghost));
    for (int b = 0; b < k->bodies; b++) {
        void *at[PATHS];
        struct path *p = &k->path[b];
        path_of(s, b, at, p->size);
        for (int i = 0; i < PATHS; i++) memcpy(p->copy[i], at[i], (size_t)p->n * p->size[i]);
    }
    k->t = s->t;
    k->broke = s->broke;
    k->a_holds = s->a_holds;
    k->stage_of_a = s->stage_of_a;
    if (k->lost) take_bonds(k, s);
    if (s->in.contact) solid_contact_keep_take(&k->contact, s);
    if (surface) solid_surface_state_keep_take(k->surface, surface);
    k->taken = 1;
}

/* Rates of a stage before are multiplied by 0 at the next: they must be numbers. */
static void clear_rates(struct solid *s) {
    for (int c = 0; c < s->dim; c++) {
        memset(s->v_old[c], 0, (size_t)s->n * sizeof(double));
        memset(s->a_old[c], 0, (size_t)s->n * sizeof(double));
    }
}

void solid_keep_restore(struct solid_keep *k, struct solid *s, struct solid_surface *surface) {
    double *array[ARRAYS], *share[SHARES];
    size_t count[ARRAYS];
    ENSURE(k->taken, "no state of the solid to put back, %d particles", s->n);
    const int lost = k->lost ? restore_bonds(k, s) : 0;
    const int same = lost == 0 && memcmp(k->flag, s->flag, (size_t)s->n) == 0;
    if (!k->a_holds) clear_rates(s);
    arrays_of(s, array, count);
    for (int i = 0; i < ARRAYS; i++)
        if (array[i] && (k->a_holds || !is_acceleration(i))) memcpy(array[i], k->copy[i], count[i] * sizeof(double));
    shares_of(s, share);
    for (int i = 0; i < SHARES; i++) *share[i] = k->share[i];
    solid_given_restore(s, k->factor);
    memcpy(s->flag, k->flag, (size_t)(s->n + s->n_ghost));
    for (int b = 0; b < k->bodies; b++) {
        void *at[PATHS];
        struct path *p = &k->path[b];
        if (s->family->lattice[b]) solid_sweep_lattice_refill(s, s->family->lattice[b]);
        path_of(s, b, at, p->size);
        for (int i = 0; i < PATHS; i++) memcpy(at[i], p->copy[i], (size_t)p->n * p->size[i]);
    }
    s->t = k->t;
    s->a_holds = k->a_holds;
    s->stage_of_a = k->stage_of_a;
    if (s->in.contact) solid_contact_keep_restore(&k->contact, s);
    if (surface) solid_surface_state_keep_restore(k->surface, s, surface, same ? NULL : k->lost);
    s->broke = k->broke;
}
