/* The items of a snapshot that are not simply copied: how each is copied and restored. */
#include "solid/snapshot_items.h"
#include "base/bits.h"
#include "base/memory.h"
#include "base/files/state_copy.h"
#include "solid/bonds/breaks.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/broken_tracker.h"
#include "solid/bonds/segments.h"
#include "solid/bonds/soft.h"
#include "solid/force/sweep_lattice.h"
#include "solid/imposed/external_loads.h"
#include "solid/surface/state.h"

#include <string.h>

static struct solid *solid_of(void *owner) { return ((struct solid_state_owner *)owner)->solid; }
static struct solid_surface *surface_of(void *owner) { return ((struct solid_state_owner *)owner)->surface; }

/* The bonds' and contact's part of the acceleration (Verlet) is copied only while it is valid. */
static void sweep_make(void *snapshot, void *owner) {
    struct solid_snapshot *k = snapshot;
    const struct solid *s = solid_of(owner);
    for (int c = 0; c < s->dim; c++) k->a_bonds[c] = memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof(double));
}

static void sweep_take(void *snapshot, void *owner) {
    struct solid_snapshot *k = snapshot;
    const struct solid *s = solid_of(owner);
    k->a_is_saved = s->a_holds;
    for (int c = 0; c < s->dim && k->a_is_saved; c++) memcpy(k->a_bonds[c], s->v_old[c], (size_t)s->n * sizeof(double));
}

/* The next stage multiplies the rates of the last stage by 0, so they must be finite. */
static void clear_rates(struct solid *s) {
    for (int c = 0; c < s->dim; c++) {
        memset(s->v_old[c], 0, (size_t)s->n * sizeof(double));
        memset(s->a_old[c], 0, (size_t)s->n * sizeof(double));
    }
}

static void sweep_restore(void *snapshot, void *owner) {
    const struct solid_snapshot *k = snapshot;
    struct solid *s = solid_of(owner);
    if (!k->a_is_saved) clear_rates(s);
    for (int c = 0; c < s->dim && k->a_is_saved; c++) memcpy(s->v_old[c], k->a_bonds[c], (size_t)s->n * sizeof(double));
}

static void sweep_drop(void *snapshot) {
    for (int c = 0; c < 3; c++) memory_free(((struct solid_snapshot *)snapshot)->a_bonds[c]);
}

const struct state_snapshot solid_snapshot_items_sweep = {sweep_make, sweep_take, sweep_restore, sweep_drop};

static void bonds_make(void *snapshot, void *owner) {
    struct solid_snapshot *k = snapshot;
    const struct solid *s = solid_of(owner);
    if (!k->may_break) return;
    k->tracker = solid_broken_tracker_new(s);
    k->bits = memory_new(MEMORY_OUTPUT, (size_t)s->n * (size_t)solid_family_bytes(s) + 1, 1);
    k->version = -1; /* the bits of all bonds are to be copied */
}

static void bonds_take(void *snapshot, void *owner) {
    struct solid_snapshot *k = snapshot;
    const struct solid *s = solid_of(owner);
    const size_t bytes = (size_t)solid_family_bytes(s);
    const int all = k->version != s->bonds_version;
    if (!k->tracker) return;
    if (all) solid_broken_tracker_reset(k->tracker, s);
    const int found = solid_broken_tracker_find(k->tracker, s), n = all ? s->n : found;
    for (int i = 0; i < n; i++) {
        const int h = all ? i : k->tracker->h[i];
        solid_family_save(s, h, k->bits + (size_t)h * bytes);
    }
    k->version = s->bonds_version;
}

/* Restores the families that have lost bonds since the state was taken. Returns how many. */
static int restore_lost(struct solid_snapshot *k, struct solid *s) {
    const size_t bytes = (size_t)solid_family_bytes(s);
    const int found = solid_broken_tracker_find(k->tracker, s);
    for (int i = 0; i < found; i++) {
        const int h = k->tracker->h[i];
        const uint8_t *bits = k->bits + (size_t)h * bytes;
        solid_family_load(s, h, bits);
        k->tracker->intact[h] = (uint16_t)bits_count(bits, bytes);
        struct solid_list *list = s->family->list[s->body[h]];
        if (list) list->counted[h - list->first] = 0;
    }
    if (found > 0) solid_broken_tracker_find(k->tracker, s); /* updates the counts of the rows as well */
    k->version = s->bonds_version = ++s->versions;
    return found;
}

/* To be called before the flags are restored: the present flags tell which particles have lost bonds. */
static void bonds_restore(void *snapshot, void *owner) {
    struct solid_snapshot *k = snapshot;
    struct solid *s = solid_of(owner);
    const int changed = k->tracker ? restore_lost(k, s) : 0;
    k->differs = changed > 0 || memcmp(state_copy_of(k->copy, "flag"), s->flag, (size_t)s->n) != 0;
}

static void bonds_drop(void *snapshot) {
    struct solid_snapshot *k = snapshot;
    solid_broken_tracker_free(k->tracker);
    memory_free(k->bits);
}

const struct state_snapshot solid_snapshot_items_bonds = {bonds_make, bonds_take, bonds_restore, bonds_drop};

static void soft_make(void *snapshot, void *owner) { (void)snapshot, (void)owner; /* as bonds begin to soften */ }

static void soft_take(void *snapshot, void *owner) {
    struct solid_snapshot *k = snapshot;
    const struct solid_soft *soft = solid_of(owner)->soft;
    if (soft->n > k->soft_capacity) {
        memory_free(k->soft);
        k->soft = memory_new(MEMORY_OUTPUT, (size_t)soft->capacity, sizeof *k->soft);
        k->soft_capacity = soft->capacity;
    }
    k->softens = soft->n;
    if (soft->n > 0) memcpy(k->soft, soft->bond, (size_t)soft->n * sizeof *k->soft);
}

/* The bonds that broke since are intact again already. */
static void soft_restore(void *snapshot, void *owner) {
    const struct solid_snapshot *k = snapshot;
    struct solid *s = solid_of(owner);
    solid_soft_clear(s);
    for (int i = 0; i < k->softens; i++) {
        solid_soft_add(s, k->soft[i].h, k->soft[i].at, k->soft[i].most);
        s->soft->bond[i].released = k->soft[i].released;
    }
    solid_soft_order(s->soft);
}

static void soft_drop(void *snapshot) { memory_free(((struct solid_snapshot *)snapshot)->soft); }

const struct state_snapshot solid_snapshot_items_soft = {soft_make, soft_take, soft_restore, soft_drop};

static void breaks_make(void *snapshot, void *owner) { (void)snapshot, (void)owner; /* one number */ }
static void breaks_take(void *snapshot, void *owner) {
    ((struct solid_snapshot *)snapshot)->breaks = solid_of(owner)->breaks->made;
}
static void breaks_restore(void *snapshot, void *owner) {
    solid_breaks_restore(solid_of(owner)->breaks, ((struct solid_snapshot *)snapshot)->breaks);
}
static void breaks_drop(void *snapshot) { (void)snapshot; }

const struct state_snapshot solid_snapshot_items_breaks = {breaks_make, breaks_take, breaks_restore, breaks_drop};

static void external_loads_make(void *snapshot, void *owner) {
    struct solid_snapshot *k = snapshot;
    k->factor = memory_new(MEMORY_OUTPUT, (size_t)solid_of(owner)->in.loads + 1, sizeof *k->factor);
}

static void external_loads_take(void *snapshot, void *owner) {
    solid_external_loads_save(solid_of(owner), ((struct solid_snapshot *)snapshot)->factor);
}

static void external_loads_restore(void *snapshot, void *owner) {
    solid_external_loads_restore(solid_of(owner), ((struct solid_snapshot *)snapshot)->factor);
}

static void external_loads_drop(void *snapshot) { memory_free(((struct solid_snapshot *)snapshot)->factor); }

const struct state_snapshot solid_snapshot_items_external_loads = {external_loads_make, external_loads_take,
                                                                   external_loads_restore, external_loads_drop};

static int path_of(const struct solid *s, int b, void *at[SOLID_SNAPSHOT_PATHS], size_t size[SOLID_SNAPSHOT_PATHS]) {
    const struct solid_lattice *lattice = s->family->lattice[b];
    const struct solid_list *list = s->family->list[b];
    at[0] = lattice ? (void *)lattice->segments->large : (void *)list->large;
    at[1] = lattice ? (void *)lattice->segments->high : (void *)list->power;
    size[0] = 1;
    size[1] = lattice ? sizeof *lattice->segments->high : sizeof *list->power;
    return lattice ? lattice->segments->n : list->n;
}

static void paths_make(void *snapshot, void *owner) {
    struct solid_snapshot *k = snapshot;
    const struct solid *s = solid_of(owner);
    k->bodies = s->family->bodies;
    k->path = memory_new(MEMORY_OUTPUT, (size_t)k->bodies, sizeof *k->path);
    for (int b = 0; b < k->bodies; b++) {
        void *at[SOLID_SNAPSHOT_PATHS];
        k->path[b].n = path_of(s, b, at, k->path[b].size);
        for (int i = 0; i < SOLID_SNAPSHOT_PATHS; i++)
            k->path[b].copy[i] = memory_new(MEMORY_OUTPUT, (size_t)k->path[b].n + 1, k->path[b].size[i]);
    }
}

static void paths_take(void *snapshot, void *owner) {
    struct solid_snapshot *k = snapshot;
    for (int b = 0; b < k->bodies; b++) {
        void *at[SOLID_SNAPSHOT_PATHS];
        struct solid_snapshot_items_path *p = &k->path[b];
        path_of(solid_of(owner), b, at, p->size);
        for (int i = 0; i < SOLID_SNAPSHOT_PATHS; i++) memcpy(p->copy[i], at[i], (size_t)p->n * p->size[i]);
    }
}

static void paths_restore(void *snapshot, void *owner) {
    struct solid_snapshot *k = snapshot;
    struct solid *s = solid_of(owner);
    for (int b = 0; b < k->bodies; b++) {
        void *at[SOLID_SNAPSHOT_PATHS];
        struct solid_snapshot_items_path *p = &k->path[b];
        if (s->family->lattice[b]) solid_sweep_lattice_refill(s, s->family->lattice[b]);
        path_of(s, b, at, p->size);
        for (int i = 0; i < SOLID_SNAPSHOT_PATHS; i++) memcpy(at[i], p->copy[i], (size_t)p->n * p->size[i]);
    }
}

static void paths_drop(void *snapshot) {
    struct solid_snapshot *k = snapshot;
    for (int b = 0; b < k->bodies; b++)
        for (int i = 0; i < SOLID_SNAPSHOT_PATHS; i++) memory_free(k->path[b].copy[i]);
    memory_free(k->path);
}

const struct state_snapshot solid_snapshot_items_paths = {paths_make, paths_take, paths_restore, paths_drop};

static void contact_make(void *snapshot, void *owner) { (void)snapshot, (void)owner; /* as there is contact */ }
static void contact_take(void *snapshot, void *owner) {
    solid_contact_snapshot_take(&((struct solid_snapshot *)snapshot)->contact, solid_of(owner));
}
static void contact_restore(void *snapshot, void *owner) {
    solid_contact_snapshot_restore(&((struct solid_snapshot *)snapshot)->contact, solid_of(owner));
}
static void contact_drop(void *snapshot) { solid_contact_snapshot_free(&((struct solid_snapshot *)snapshot)->contact); }

const struct state_snapshot solid_snapshot_items_contact = {contact_make, contact_take, contact_restore, contact_drop};

static void surface_make(void *snapshot, void *owner) {
    ((struct solid_snapshot *)snapshot)->surface = solid_surface_state_snapshot_new(solid_of(owner));
}

static void surface_take(void *snapshot, void *owner) {
    solid_surface_state_snapshot_take(((struct solid_snapshot *)snapshot)->surface, surface_of(owner));
}

static void surface_restore(void *snapshot, void *owner) {
    const struct solid_snapshot *k = snapshot;
    solid_surface_state_snapshot_restore(k->surface, solid_of(owner), surface_of(owner),
                                         k->differs ? k->tracker : NULL);
}

static void surface_drop(void *snapshot) {
    solid_surface_state_snapshot_free(((struct solid_snapshot *)snapshot)->surface);
}

const struct state_snapshot solid_snapshot_items_surface = {surface_make, surface_take, surface_restore, surface_drop};
