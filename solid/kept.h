/* A kept state of the solid, and its items that are not simply copied. For solid/ only. */
#pragma once
#include "base/files/state_item.h"
#include "solid/contact/keep.h"
#include "solid/surface/surface.h"

/* Argument of the table's functions. */
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
    struct state_copy *copy; /* the copied items; the members below belong to the items with their own functions */
    /* sweep */
    int a_held;         /* 1: the accelerations were valid and are copied */
    double *a_bonds[3]; /* [n] v_old */
    /* bonds; lost NULL: no bond ever breaks */
    struct solid_broken_tracker *tracker; /* finds the particles whose bits differ from the present bonds */
    uint8_t *bits;                        /* [n][bytes] */
    long version;
    /* softening: a copy of the list */
    int softens, soft_room;
    struct solid_soft_bond *soft;
    long breaks; /* number of records of bonds that broke */
    int differs; /* 1: in the last restoration the bonds or flags differed from the kept state's */
    /* given */
    double *factor; /* [loads] */
    /* paths */
    struct solid_kept_path *path; /* [bodies] */
    int bodies;
    struct solid_contact_keep contact;
    struct solid_surface_keep *surface;
};

/* For the table (solid/state_table.c): their `keep` is a struct solid_keep, their owner a struct solid_state_owner. */
extern const struct state_kept solid_kept_sweep, solid_kept_bonds, solid_kept_soft, solid_kept_breaks,
    solid_kept_external_loads, solid_kept_paths, solid_kept_contact, solid_kept_surface;
