/* Takes snapshots of the solid's whole state, and restores it from them, to the bit. */
#include "solid/snapshot.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/files/state_copy.h"
#include "solid/snapshot_items.h"
#include "solid/state_table.h"

/* The table and its owner. Functions that only read the solid cast its const away here. */
static struct state_part part_of(struct solid_state_owner *owner, const struct solid *s,
                                 const struct solid_surface *surface) {
    *owner = (struct solid_state_owner){(struct solid *)s, (struct solid_surface *)surface};
    return solid_state_table_part(owner);
}

struct solid_snapshot *solid_snapshot_new(const struct solid *s, const struct solid_surface *surface, int may_break) {
    struct solid_snapshot *k = memory_new(MEMORY_OUTPUT, 1, sizeof *k);
    struct solid_state_owner owner;
    const struct state_part part = part_of(&owner, s, surface);
    k->may_break = may_break;
    k->copy = state_copy_new(&part, k);
    return k;
}

void solid_snapshot_free(struct solid_snapshot *k) {
    if (!k) return;
    state_copy_free(k->copy, k);
    memory_free(k);
}

void solid_snapshot_take(struct solid_snapshot *k, struct solid *s, const struct solid_surface *surface) {
    struct solid_state_owner owner;
    const struct state_part part = part_of(&owner, s, surface);
    state_copy_take(k->copy, &part, k);
    k->taken = 1;
}

void solid_snapshot_restore(struct solid_snapshot *k, struct solid *s, struct solid_surface *surface) {
    struct solid_state_owner owner;
    const struct state_part part = part_of(&owner, s, surface);
    ENSURE(k->taken, "no state of the solid to put back, %d particles", s->n);
    state_copy_restore(k->copy, &part, k);
}
