/* A snapshot of the solid, and its items that are not simply copied. For solid/ only. */
#pragma once
#include "base/files/state_item.h"
#include "solid/contact/snapshot.h"
#include "solid/surface/surface.h"

/* Argument of the table's functions. */
struct solid_state_owner {
    struct solid *solid;           /* borrowed */
    struct solid_surface *surface; /* borrowed; NULL unless immersed */
};

enum { SOLID_SNAPSHOT_PATHS = 2 };

/* Data that the last sweep has left for the next one over a body's bonds, such as which segments are tested first. */
struct solid_snapshot_items_path {
    int n;
    void *copy[SOLID_SNAPSHOT_PATHS];
    size_t size[SOLID_SNAPSHOT_PATHS];
};

struct solid_snapshot {
    int taken, may_break;
    struct state_copy *copy; /* the copied items; the members below belong to the items with their own functions */
    /* sweep */
    int a_is_saved;     /* 1: the accelerations were valid and are copied */
    double *a_bonds[3]; /* [n] v_old */
    /* bonds; tracker NULL: no bond ever breaks */
    struct solid_broken_tracker *tracker; /* finds the particles whose bits differ from the present bonds */
    uint8_t *bits;                        /* [n][bytes] */
    long version;
    /* softening: a copy of the list */
    int softens, soft_capacity;
    struct solid_soft_bond *soft;
    long breaks; /* number of records of bonds that broke */
    int differs; /* 1: in the last restoration the bonds or flags differed from the snapshot's */
    /* external loads */
    double *factor; /* [loads] */
    /* paths */
    struct solid_snapshot_items_path *path; /* [bodies] */
    int bodies;
    struct solid_contact_snapshot contact;
    struct solid_surface_snapshot *surface;
};

/* For the table (solid/state_table.c): their `snapshot` is a struct solid_snapshot, their owner a struct
 * solid_state_owner.
 */
extern const struct state_snapshot solid_snapshot_items_sweep, solid_snapshot_items_bonds, solid_snapshot_items_soft,
    solid_snapshot_items_breaks, solid_snapshot_items_external_loads, solid_snapshot_items_paths,
    solid_snapshot_items_contact, solid_snapshot_items_surface;
