/* A kept state of the solid, and the items of it that are not simply copied. Inside the room only. */
#pragma once
#include "files/state_item.h"
#include "solid/contact/keep.h"
#include "solid/surface/surface.h"

/* What the table's functions take. */
struct solid_state_owner {
    struct solid *solid;           /* borrowed */
    struct solid_surface *surface; /* borrowed; NULL unless immersed */
};

enum { SOLID_KEPT_PATHS = 2 };

/* Data that the last sweep has left for the next one over a body's bonds, such as which segments are tested first. */
struct solid_kept_path {
    int n;
    void *copy[SOLID_KEPT_PATHS];
    size_t size[SOLID_KEPT_PATHS];
};

struct solid_keep {
    int taken, may_break;
    struct state_copy *copy; /* what the table copies; the members below belong to the items with their own functions */
    /* sweep */
    int a_held;         /* the accelerations held: a copy of them is there */
    double *a_bonds[3]; /* [n] v_old */
    /* bonds; lost NULL: no bond ever breaks */
    struct solid_lost *lost; /* finds the particles whose bits differ from the present bonds */
    uint8_t *bits;           /* [n][bytes] */
    long version;
    int differs; /* of the last restore: bonds or flags were not those of the kept state */
    /* given */
    double *factor; /* [loads] */
    /* paths */
    struct solid_kept_path *path; /* [bodies] */
    int bodies;
    struct solid_contact_keep contact;
    struct solid_surface_keep *surface;
};

/* For the table (solid/state_table.c): their `keep` is a struct solid_keep, their owner a struct solid_state_owner. */
extern const struct state_kept solid_kept_sweep, solid_kept_bonds, solid_kept_given, solid_kept_paths,
    solid_kept_contact, solid_kept_surface;
