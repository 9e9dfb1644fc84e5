/* The table of state: one line a variable that a later step depends on.  (docs/design/state.md)
 *
 * A room lists the state of its structs in such a table. Checkpoints (files/state_file.h) and the state kept in memory
 * (files/state_copy.h) loop over it, and a test looks that it covers every byte of a struct's state group. */
#pragma once
#include "files/store.h"

#include <stddef.h>

/* STATE_TEXT: only what `save` and `load` give and take, [STATE_TEXT_BYTES] with the final 0. */
enum state_kind { STATE_DOUBLE, STATE_LONG, STATE_INT, STATE_BYTE, STATE_TEXT };
enum { STATE_TEXT_BYTES = 64, STATE_COMPS_MAX = 3 };

/* What the member holds. */
enum state_shape {
    STATE_ONE,      /* a value, the same on every rank */
    STATE_SHARE,    /* a double of which each rank has its share: stored as the sum, which rank 0 carries on */
    STATE_PARTICLE, /* one array by owned particle or, for a vector, three of them; a plate's third is NULL */
    STATE_CELL,     /* an array of doubles over the fluid's grid with its ghosts; a checkpoint stores the inner cells */
    STATE_BODY,     /* an array [bodies][comps] of doubles, the same on every rank */
    STATE_SET       /* by particle, and says which particles there are: read whole by every rank, before the others */
};

enum state_in { STATE_STORED = 1, STATE_KEPT = 2, STATE_BOTH = 3 }; /* in checkpoints; in the state kept in memory */

/* What is done where a checkpoint of an earlier version, or of a scene without the variable, does not have it. */
enum state_missing { STATE_FAULT, STATE_LEFT, STATE_ZERO }; /* refused; left as it is; set to 0 */

/* How a variable is kept in memory that is not simply copied. keep: where the copy goes, for the table's room. */
struct state_kept {
    void (*make)(void *keep, void *owner); /* memory for it */
    void (*take)(void *keep, void *owner);
    void (*restore)(void *keep, void *owner);
    void (*drop)(void *keep); /* frees the memory; after `make` alone too */
};

struct state_item {
    const char *name; /* in a checkpoint; unique among all tables */
    enum state_kind kind;
    enum state_shape shape;
    size_t offset, bytes; /* the member, or members, of its struct: STATE_MEMBER; bytes 0: none */
    int comps;            /* values a particle or body; 0: as many as the member has pointers */
    int ghosts;           /* 1: ghosts' values are kept too */
    int last;             /* 1: loaded and restored when all others are in place */
    enum state_in in;
    enum state_missing missing;
    const char *after; /* the item of another table that it follows in a checkpoint; NULL: the one above it */
    const char *why;   /* where `in` is not STATE_BOTH: why that is enough */
    /* NULL: of every scene that has the table, and where the member is a pointer, unless that is NULL */
    int (*is_part)(const void *owner);
    /* NULL: to and from the member as it is. Values as in a checkpoint: [n][comps] by particle, or one. load returns 1
     * where the value does not fit the scene, and may say why. Collective. */
    int (*comps_of)(const void *owner); /* instead of comps */
    void (*save)(void *owner, void *value);
    int (*load)(void *owner, const void *value, char *why, size_t size);
    const struct state_kept *kept; /* NULL: copied */
};

#define STATE_MEMBER(of, member) .offset = offsetof(of, member), .bytes = sizeof(((of *)0)->member)

/* How many there are of what the arrays go by. */
struct state_size {
    long n_global, first; /* particles of all ranks; global id of this rank's first */
    int n, n_ghost;       /* of this rank */
    int bodies;
    size_t cells;             /* of a STATE_CELL array, ghosts included */
    ptrdiff_t inner;          /* of them, the first that is no ghost */
    struct store_block block; /* the inner cells */
};

/* A table and the struct that it is of. */
struct state_part {
    const struct state_item *item; /* [items], static */
    int items;
    void *base;  /* the struct whose members the items are; borrowed */
    void *owner; /* what the functions of the items take; borrowed */
    void (*size)(const void *owner, struct state_size *size);
    /* The particles that a checkpoint has, value [STATE_SET items][n][comps]; 1 where they do not fit. NULL: the table
     * has no STATE_SET. Collective. */
    int (*make)(void *owner, long n, void *const *value);
    /* Rebuilds ghosts and counts once all items but the last ones are loaded. NULL: nothing. Collective. */
    void (*settle)(void *owner);
};

/* None of these is collective. */
int state_item_is_part(const struct state_item *item, const struct state_part *part);
int state_item_comps(const struct state_item *item, const struct state_part *part);
size_t state_item_value_bytes(enum state_kind kind);
/* The member where it is a value, else its array of component c. */
void *state_item_array(const struct state_item *item, const struct state_part *part, int c);
/* The first offset in from .. to-1 that no item covers, or `to`. Bytes of padding count as not covered. */
size_t state_item_uncovered(const struct state_item *item, int items, size_t from, size_t to);
