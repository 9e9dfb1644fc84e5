/* The table of state: one line for each variable that a later step depends on.  (docs/design/state.md)
 *
 * Each of fluid, solid and coupling lists the state of its structs in such a table. Checkpoints
 * (base/files/state_file.h) and snapshots in memory (base/files/state_copy.h) loop over it. A test checks that it
 * covers every byte of a struct's state group. */
#pragma once
#include "base/files/store.h"

#include <stddef.h>

/* STATE_TEXT: only for `save` and `load`, [STATE_TEXT_BYTES] with the final 0. */
enum state_kind { STATE_DOUBLE, STATE_LONG, STATE_INT, STATE_BYTE, STATE_TEXT };
enum { STATE_TEXT_BYTES = 1024, STATE_COMPS_MAX = 3 };

/* The content of the member. */
enum state_shape {
    STATE_ONE,      /* a value, the same on every rank */
    STATE_SHARE,    /* a double of which each rank has its share: stored as the sum, which is continued on rank 0 */
    STATE_PARTICLE, /* one array by owned particle or, for a vector, three of them; a plate's third is NULL */
    STATE_CELL,     /* an array of doubles over the fluid's grid with its ghosts; a checkpoint stores the inner cells */
    STATE_ROWS,     /* a list of any length, [rows][comps]; stored as one list, which every rank reads completely */
    STATE_SET       /* by particle, and defines the particles: read completely by every rank, before the others */
};

/* Where a variable is stored: in checkpoints, in snapshots (copies of the state in memory), or in both. */
enum state_in { STATE_CHECKPOINT = 1, STATE_SNAPSHOT = 2, STATE_BOTH = 3 };

/* What is done if a checkpoint, of an earlier version or of a scene without the variable, does not have it. */
enum state_missing {
    STATE_FAULT, /* the checkpoint is refused */
    STATE_LEFT,  /* the variable is left as it is */
    STATE_ZERO,  /* a value is set to 0 */
    STATE_ABOVE  /* a STATE_CELL array gets the values of the item above it, which is one too */
};

/* How a snapshot stores a variable that is not simply copied. snapshot: the owner of the copy. */
struct state_snapshot {
    void (*make)(void *snapshot, void *owner); /* allocates its memory */
    void (*take)(void *snapshot, void *owner);
    void (*restore)(void *snapshot, void *owner);
    void (*drop)(void *snapshot); /* frees the memory; also if only `make` was called */
};

struct state_item {
    const char *name; /* in a checkpoint; unique among all tables */
    enum state_kind kind;
    enum state_shape shape;
    size_t offset, bytes; /* the member, or members, of its struct: STATE_MEMBER; bytes 0: none */
    int comps;            /* values for each particle or body; 0: as many as the member has pointers */
    int ghosts;           /* 1: ghosts' values are kept too */
    int last;             /* 1: loaded and restored after all others */
    enum state_in in;
    enum state_missing missing;
    const char *after; /* the item of another table that it follows in a checkpoint; NULL: the item above it */
    const char *why;   /* the reason, if `in` is not STATE_BOTH */
    /* NULL: the variable exists in every scene that has the table and, for a pointer, if it is not NULL */
    int (*is_part)(const void *owner);
    /* NULL: the member itself is read and written. Values as in a checkpoint: [n][comps] by particle, or one. load
     * returns 1 if the value does not fit the scene, and may give the reason. Collective. */
    int (*comps_of)(const void *owner); /* instead of comps */
    void (*save)(void *owner, void *value);
    int (*load)(void *owner, const void *value, char *why, size_t size);
    /* STATE_ROWS: the number of rows of this rank, which `save` writes; and, instead of load, all n rows of all ranks.
     * is_shared: all ranks have the same rows, and a checkpoint gets those of rank 0 */
    long (*rows_of)(const void *owner);
    int (*load_rows)(void *owner, long n, const void *value);
    int is_shared;
    /* A snapshot is made by `snapshot` or, where that is NULL, of the values as in a checkpoint if by_values is set or
     * the item is a list of rows; else the member is copied. restore_rows: takes this rank's rows back; NULL: load_rows
     */
    const struct state_snapshot *snapshot;
    int by_values;
    void (*restore_rows)(void *owner, long n, const void *value);
};

#define STATE_MEMBER(type, member) .offset = offsetof(type, member), .bytes = sizeof(((type *)0)->member)

/* Sizes of the arrays. */
struct state_size {
    long n_global, first;     /* particles of all ranks; global id of this rank's first */
    int n, n_ghost;           /* of this rank */
    size_t cells;             /* of a STATE_CELL array, ghosts included */
    ptrdiff_t inner;          /* index of the first of them that is not a ghost */
    struct store_block block; /* the inner cells */
};

/* A table and its struct. */
struct state_part {
    const struct state_item *item; /* [items], static */
    int items;
    void *base;  /* the struct whose members the items are; borrowed */
    void *owner; /* argument of the items' functions; borrowed */
    void (*size)(const void *owner, struct state_size *size);
    /* Makes the particles of a checkpoint, value [STATE_SET items][n][comps]; returns 1 if they do not fit. NULL: the
     * table has no STATE_SET. Collective. */
    int (*make)(void *owner, long n, void *const *value);
    /* Rebuilds ghosts and counts after all items but the last ones are loaded. NULL: nothing to rebuild. Collective. */
    void (*settle)(void *owner);
};

/* None of these is collective. */
int state_item_is_part(const struct state_item *item, const struct state_part *part);
int state_item_comps(const struct state_item *item, const struct state_part *part);
size_t state_item_value_bytes(enum state_kind kind);
/* The member if it is a value, else its array of component c. */
void *state_item_array(const struct state_item *item, const struct state_part *part, int c);
