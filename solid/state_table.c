/* The table of the solid's state: the data of struct solid and of its bonds, contact and surface that a later step
 * depends on.  (docs/design/state.md) */
#include "solid/state_table.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/soft.h"
#include "solid/force/dilatation.h"
#include "solid/imposed/external_loads.h"
#include "solid/snapshot_items.h"
#include "solid/refine/refine.h"
#include "solid/surface/state.h"

#include <string.h>

static struct solid *solid_of(const void *owner) { return ((const struct solid_state_owner *)owner)->solid; }
static struct solid_surface *surface_of(const void *owner) {
    return ((const struct solid_state_owner *)owner)->surface;
}

static int is_refined(const void *owner) { return solid_of(owner)->refine != NULL; }
static int is_loaded(const void *owner) { return solid_of(owner)->external_loads != NULL; }
static int is_in_contact(const void *owner) { return solid_of(owner)->in.contact; }
static int is_recorded(const void *owner) { return solid_of(owner)->breaks != NULL; }
static int is_recorded_soft(const void *owner) { return is_recorded(owner) && solid_of(owner)->soft; }
static int is_immersed(const void *owner) { return surface_of(owner) != NULL; }

static void save_level(void *owner, void *value) {
    struct solid *s = solid_of(owner);
    double place[3];
    for (int h = 0; h < s->n; h++) solid_refine_restore_save(s, h, &((uint8_t *)value)[h], place);
}

static void save_place(void *owner, void *value) {
    struct solid *s = solid_of(owner);
    double(*place)[3] = value;
    uint8_t level;
    for (int h = 0; h < s->n; h++) solid_refine_restore_save(s, h, &level, place[h]);
}

static int bond_bytes(const void *owner) { return solid_family_bytes(solid_of(owner)); }

static void save_bonds(void *owner, void *value) {
    const size_t bytes = (size_t)bond_bytes(owner);
    for (int h = 0; h < solid_of(owner)->n; h++) solid_family_save(solid_of(owner), h, (uint8_t *)value + h * bytes);
}

static int load_bonds(void *owner, const void *value, char *why, size_t capacity) {
    const size_t bytes = (size_t)bond_bytes(owner);
    (void)why, (void)capacity;
    for (int h = 0; h < solid_of(owner)->n; h++)
        solid_family_load(solid_of(owner), h, (const uint8_t *)value + h * bytes);
    return 0;
}

static int surface_comps(const void *owner) {
    (void)owner;
    return solid_surface_state_size();
}

static void save_surface(void *owner, void *value) {
    solid_surface_state_save(solid_of(owner), surface_of(owner), value);
}

static int load_surface(void *owner, const void *value, char *why, size_t capacity) {
    (void)why, (void)capacity;
    solid_surface_state_load(solid_of(owner), surface_of(owner), value);
    return 0;
}

/* Softening bonds: the global id of the end that owns it, the bond's number in its view, the largest stretch. */
enum { SOFT_COMPS = 3 };

static long soft_rows(const void *owner) { return solid_of(owner)->soft->n; }

static void save_soft(void *owner, void *value) {
    const struct solid *s = solid_of(owner);
    double(*row)[SOFT_COMPS] = value;
    for (int i = 0; i < s->soft->n; i++) {
        const struct solid_soft_bond *bond = &s->soft->bond[i];
        row[i][0] = (double)(s->first[par_rank()] + bond->h);
        row[i][1] = bond->place;
        row[i][2] = bond->most;
    }
}

static int load_soft(void *owner, long n, const void *value) {
    struct solid *s = solid_of(owner);
    const double(*row)[SOFT_COMPS] = value;
    solid_soft_clear(s);
    for (long i = 0; i < n; i++) {
        const long h = (long)row[i][0] - s->first[par_rank()];
        if (h >= 0 && h < s->n) solid_soft_add_placed(s, (int)h, (int)row[i][1], row[i][2]);
    }
    solid_soft_order(s->soft);
    s->a_holds = 0;
    return 0;
}

/* The same bonds' energies released so far, J, which only events.csv needs: the third number is the energy. */
static void save_released(void *owner, void *value) {
    const struct solid *s = solid_of(owner);
    double(*row)[SOFT_COMPS] = value;
    save_soft(owner, value);
    for (int i = 0; i < s->soft->n; i++) row[i][2] = s->soft->bond[i].released;
}

static int load_released(void *owner, long n, const void *value) {
    struct solid *s = solid_of(owner);
    const double(*row)[SOFT_COMPS] = value;
    for (long i = 0; i < n; i++) {
        const long h = (long)row[i][0] - s->first[par_rank()];
        if (h >= 0 && h < s->n) solid_soft_set_released(s, (int)h, (int)row[i][1], row[i][2]);
    }
    return 0;
}

static int has_dilatation(const void *owner) { return solid_of(owner)->dilatation != NULL; }

static void save_extension(void *owner, void *value) {
    const struct solid *s = solid_of(owner);
    memcpy(value, s->dilatation->extension, (size_t)s->n * sizeof(double));
}

static int load_extension(void *owner, const void *value, char *why, size_t capacity) {
    const struct solid *s = solid_of(owner);
    (void)why, (void)capacity;
    memcpy(s->dilatation->extension, value, (size_t)s->n * sizeof(double));
    return 0;
}

#define OF(member) STATE_MEMBER(struct solid, member)

const struct state_item solid_state_table[] = {
    /* the particles of a plate that is refined during the run */
    {"body", STATE_BYTE, STATE_SET, OF(body), .in = STATE_CHECKPOINT, .is_part = is_refined,
     .why = "a snapshot does not outlive a refinement"},
    {"level", STATE_BYTE, STATE_SET, OF(refine), .comps = 1, .in = STATE_CHECKPOINT, .is_part = is_refined,
     .save = save_level, .why = "a snapshot does not outlive a refinement"},
    {"place", STATE_DOUBLE, STATE_SET, OF(refine), .comps = 3, .in = STATE_CHECKPOINT, .is_part = is_refined,
     .save = save_place, .why = "a snapshot does not outlive a refinement"},
    /* motion */
    {"displacement", STATE_DOUBLE, STATE_PARTICLE, OF(d), .ghosts = 1, .in = STATE_BOTH},
    {"velocity", STATE_DOUBLE, STATE_PARTICLE, OF(v), .ghosts = 1, .in = STATE_BOTH},
    {"load", STATE_DOUBLE, STATE_PARTICLE, OF(load), .in = STATE_BOTH},
    {"sweep", STATE_DOUBLE, STATE_PARTICLE, OF(v_old), .in = STATE_BOTH, .snapshot = &solid_snapshot_items_sweep},
    /* of the same sweep: from it follows what bonds absorb that break in the next substep */
    {"extension", STATE_DOUBLE, STATE_PARTICLE, OF(dilatation), .comps = 1, .in = STATE_BOTH, .missing = STATE_LEFT,
     .is_part = has_dilatation, .save = save_extension, .load = load_extension, .by_values = 1},
    /* bonds; before `flag`, because their restoration reads the present flags */
    {"bonds", STATE_BYTE, STATE_PARTICLE, OF(family), .in = STATE_BOTH, .comps_of = bond_bytes, .save = save_bonds,
     .load = load_bonds, .snapshot = &solid_snapshot_items_bonds},
    {"flag", STATE_BYTE, STATE_PARTICLE, OF(flag), .ghosts = 1, .in = STATE_BOTH},
    /* after `bonds`, whose load makes all intact bonds elastic */
    {"softening", STATE_DOUBLE, STATE_ROWS, OF(soft), .comps = SOFT_COMPS, .in = STATE_BOTH, .rows_of = soft_rows,
     .save = save_soft, .load_rows = load_soft, .snapshot = &solid_snapshot_items_soft},
    {"softening_released", STATE_DOUBLE, STATE_ROWS, .comps = SOFT_COMPS, .in = STATE_CHECKPOINT, .missing = STATE_LEFT,
     .is_part = is_recorded_soft, .rows_of = soft_rows, .save = save_released, .load_rows = load_released,
     .why = "it is kept with the list of the softening bonds"},
    {"stretch_limit", STATE_DOUBLE, STATE_PARTICLE, OF(stretch_limit), .comps = 1, .in = STATE_BOTH},
    /* what fragments.csv goes on from */
    {"piece", STATE_LONG, STATE_PARTICLE, OF(fragment), .comps = 1, .in = STATE_BOTH, .missing = STATE_LEFT},
    {"piece_since", STATE_DOUBLE, STATE_PARTICLE, OF(fragment_since), .comps = 1, .in = STATE_BOTH,
     .missing = STATE_LEFT},
    {"breaks", STATE_LONG, STATE_PARTICLE, OF(breaks), .in = STATE_SNAPSHOT, .is_part = is_recorded,
     .snapshot = &solid_snapshot_items_breaks, .why = "events.csv is written before a checkpoint is"},
    /* energies */
    {"e_damped", STATE_DOUBLE, STATE_SHARE, OF(e_damped), .in = STATE_BOTH},
    {"balance", STATE_LONG, STATE_ONE, OF(balance), .in = STATE_BOTH, .missing = STATE_ZERO},
    {"e_fracture", STATE_DOUBLE, STATE_SHARE, OF(e_fracture), .in = STATE_BOTH},
    {"crack_area", STATE_DOUBLE, STATE_SHARE, OF(crack_area), .in = STATE_BOTH, .missing = STATE_ZERO},
    {"e_constraint", STATE_DOUBLE, STATE_SHARE, OF(e_constraint), .in = STATE_BOTH},
    {"work_load", STATE_DOUBLE, STATE_SHARE, OF(work_load), .in = STATE_BOTH},
    {"e_integrator", STATE_DOUBLE, STATE_SHARE, OF(e_integrator), .in = STATE_BOTH, .missing = STATE_ZERO},
    {"power_pairwise", STATE_DOUBLE, STATE_SHARE, OF(power_pairwise), .in = STATE_BOTH},
    /* the interface's normals: once bonds, flags and displacements are in place, with their ghosts */
    {"surface", STATE_DOUBLE, STATE_PARTICLE, .last = 1, .in = STATE_BOTH, .is_part = is_immersed,
     .comps_of = surface_comps, .save = save_surface, .load = load_surface, .snapshot = &solid_snapshot_items_surface},
    /* needed only so that the same steps from a snapshot give the same results to the bit */
    {"solid_t", STATE_DOUBLE, STATE_ONE, OF(t), .in = STATE_SNAPSHOT,
     .why = "between steps it is the run's t, from which it is set when a checkpoint is read"},
    {"bonds_broken", STATE_LONG, STATE_ONE, OF(bonds_broken), .in = STATE_SNAPSHOT,
     .why = "it is counted from the bonds when a checkpoint is read"},
    {"given", STATE_DOUBLE, STATE_PARTICLE, OF(external_loads), .in = STATE_SNAPSHOT, .is_part = is_loaded,
     .snapshot = &solid_snapshot_items_external_loads,
     .why = "external loads are a function of time, and are added again after reading"},
    {"paths", STATE_BYTE, STATE_PARTICLE, .in = STATE_SNAPSHOT, .snapshot = &solid_snapshot_items_paths,
     .why = "it is round-off: which of two forms of the same force each bond takes next"},
    {"contact", STATE_BYTE, STATE_PARTICLE, OF(contact), .in = STATE_SNAPSHOT, .is_part = is_in_contact,
     .snapshot = &solid_snapshot_items_contact, .why = "its lists are made from positions and bonds after reading"},
    /* whether `sweep` holds, and the stage that it belongs to; after all that says that it does not */
    {"sweep_holds", STATE_INT, STATE_ONE, OF(a_holds), .last = 1, .in = STATE_BOTH, .missing = STATE_ZERO},
    {"sweep_integrator", STATE_INT, STATE_ONE, OF(stage_of_a.integrator), .last = 1, .in = STATE_BOTH,
     .missing = STATE_ZERO},
    {"sweep_breakage", STATE_INT, STATE_ONE, OF(stage_of_a.breakage), .last = 1, .in = STATE_BOTH,
     .missing = STATE_ZERO},
    {"sweep_damping_relative", STATE_DOUBLE, STATE_ONE, OF(stage_of_a.damping_relative), .last = 1, .in = STATE_BOTH,
     .missing = STATE_ZERO},
    {"sweep_damping_absolute", STATE_DOUBLE, STATE_ONE, OF(stage_of_a.damping_absolute), .last = 1, .in = STATE_BOTH,
     .missing = STATE_ZERO},
    /* after the surface, which sets it */
    {"broke", STATE_INT, STATE_ONE, OF(broke), .last = 1, .in = STATE_SNAPSHOT,
     .why = "after reading, surface and contact are made from all bonds"},
};

#undef OF

void solid_state_table_size(const struct solid *s, struct state_size *size) {
    size->n_global = s->n_global;
    size->first = s->first[par_rank()];
    size->n = s->n;
    size->n_ghost = s->n_ghost;
}

static void size_of(const void *owner, struct state_size *size) { solid_state_table_size(solid_of(owner), size); }

/* value: body, level, place */
static int make(void *owner, long n, void *const *value) {
    return solid_refine_restore(solid_of(owner), n, value[0], value[1], (const double(*)[3])value[2]);
}

static void settle(void *owner) {
    struct solid *s = solid_of(owner);
    solid_external_loads_restart(s);
    par_ghost_update_bytes(s->ghost, s->flag, s->n);
    solid_ghosts_update(s);
    solid_family_count(s);
}

struct state_part solid_state_table_part(struct solid_state_owner *owner) {
    return (struct state_part){.item = solid_state_table,
                               .items = sizeof solid_state_table / sizeof solid_state_table[0],
                               .base = owner->solid,
                               .owner = owner,
                               .size = size_of,
                               .make = make,
                               .settle = settle};
}
