/* The particles that may touch in a substep, and their accelerations by contact: what solid/contact/implicit.c solves
 * for. For solid/ only. */
#pragma once
#include "solid/contact/ends.h"
#include "solid/contact/remote.h"
#include "solid/contact/tensor.h"

/* A particle of a near pair: what the sum over the pairs reads and writes, in one cache line; and the rest. */
struct solid_near_end {
    double d[3];   /* displacement at the end of the substep, by the last iterate, m */
    double sum[3]; /* acceleration by contact with that d, without added mass, m/s2 */
    double unused[2];
};
struct solid_near_node {
    /* what a term of the iteration reads and writes: a cache line */
    double turn[3];       /* last change of the iterate, m/s2 */
    double predicted[3];  /* displacement at the end of the substep without contact, m */
    int particle;         /* as in struct solid_contact_end */
    int end;              /* in contact's ends */
    uint8_t is_own, held; /* held: bit c is set if direction c is imposed */
    /* the rest */
    double first[3];          /* the iterate at the start, m/s2 */
    double start[3];          /* displacement at the beginning of the substep, m */
    double push[3];           /* the sum less what added mass takes, m/s2; only if there are faces */
    double stiffness[TENSOR]; /* sum of 2 kappa/rho e e, 1/s2 */
    double unused;
};
_Static_assert(sizeof(struct solid_near_node) == 192, "three cache lines");

/* A pair that may touch in the substep. */
struct solid_near_pair {
    int is_own;                      /* both ends are owned here */
    double xi[3], start[3];          /* X0_h - X0_l; X_h - X_l at the beginning, m */
    double depth, potential, radius; /* q and phi at the beginning; r_c of the pair */
    double on_h, on_l;               /* k_c V_l/rho_h, k_c V_h/rho_l, m/s2 */
    double push_h[3], push_l[3];     /* its part of the sums, m/s2 */
};

/* A wetted face of a node, with added mass. */
struct solid_near_face {
    int of, node; /* index in s->added */
    double lost;  /* the part of the acceleration along the normal that the added mass takes, m/s2 */
};

struct solid_near {
    double (*start)[3];           /* [ends] displacements at the beginning of the substep, m */
    int *node_of;                 /* [ends] 1 + node; 0: none, as always between calls */
    struct solid_near_end *end;   /* [nodes] */
    struct solid_near_node *node; /* [nodes] */
    double (*a)[3];               /* [nodes] the iterate, m/s2 */
    uint8_t *has_moved;           /* [nodes] d has changed since the sum */
    uint8_t *has_turn;            /* [nodes] the last term has changed a */
    uint8_t *may_differ;          /* [nodes] its residual may have changed in the last solid_near_push */
    uint8_t *held;                /* [nodes] as in the node; all bits of one that is not owned */
    struct solid_near_pair *pair; /* [pairs] */
    int (*of)[2];                 /* [pairs] their nodes h and l */
    struct solid_near_face *face;
    int nodes, pairs, faces, room_start, room_of, room_end, room_node, room_a, room_moved, room_turn, room_differ,
        room_held, room_pair, room_nodes, room_face;
    struct solid_contact_remote remote;
    int *serve, *ask, room_serve, room_ask; /* [remote.served], [remote.asked] nodes; -1: none */
};

void solid_near_free(struct solid_near *m);
/* Keeps the displacements at the beginning of a substep. Collective. */
void solid_near_begin(const struct solid *s, struct solid_contact *c, struct solid_near *m);
/* The displacements at its end without contact; forgets all nodes. Not collective. */
void solid_near_predict(const struct solid *s, struct solid_contact *c, struct solid_near *m);
/* Puts the ends where their nodes are, asks the other ranks for theirs, and gathers the pairs that touch at the
 * beginning, or at the end but for reach, m. Further nodes are added. Collective. */
void solid_near_gather(struct solid *s, struct solid_contact *c, struct solid_near *m, double reach);
/* Asks the owners of the other nodes where these are. Collective. */
void solid_near_ask(const struct solid *s, const struct solid_contact *c, struct solid_near *m);
/* The accelerations by contact if the nodes end at d: of the pairs with an end that has moved, the others are as they
 * were. Sums of multiples of the quantum are exact, so they are the same as if all pairs were summed. */
void solid_near_push(const struct solid *s, const struct solid_contact *c, struct solid_near *m);
/* [3] of node k, as the last solid_near_push found them. */
static inline const double *solid_near_pushed(const struct solid_near *m, int k) {
    return m->faces > 0 ? m->node[k].push : m->end[k].sum;
}
