/* What the files of implicit contact share: the pairs that touch in a substep, their particles, and the iterate. For
 * solid/contact/implicit*.c only. */
#pragma once
#include "base/step_status.h"
#include "solid/contact/list.h"
#include "solid/contact/touching.h"

/* Units of r_c. If the ends of a pair are on two ranks and nearer than r_c plus this, the ranks exchange positions in
 * each iteration. */
#define SOLID_CONTACT_NEAR 0.1

/* Units of r_c. While no node has moved by more than half of this since the first search for pairs, later searches
 * examine only the pairs that were then nearer than r_c plus this. */
#define SOLID_CONTACT_CLOSE 0.05

/* Three components and a zero. */
typedef double solid_contact_row[4];

/* Where an end of a listed pair is; in one cache line, as searches read both. */
struct solid_contact_motion {
    solid_contact_row start; /* displacement at the beginning of the substep, m */
    solid_contact_row now;   /* at its end, m; of nodes by the iterate before the last search for pairs */
};

/* A particle of a pair that touches. */
struct solid_contact_node {
    double stiffness[6];  /* sum of 2 kappa/rho e e: xx, yy, zz, xy, xz, yz, 1/s2 */
    int end, particle;    /* as in struct solid_contact_end */
    uint8_t is_own, held; /* held: bit c is set if direction c is imposed */
};

/* What an iteration reads and writes of the nodes, [nodes + 1] each, four numbers a node; the last node is 0, so that
 * loops over a vec of numbers at a time may run beyond the others. */
struct solid_contact_iterate {
    solid_contact_row *a, *turn;  /* the iterate, and its last change, m/s2 */
    solid_contact_row *now;       /* displacement at the end of the substep with a, m */
    solid_contact_row *push;      /* acceleration by contact with `now`, m/s2 */
    solid_contact_row *predicted; /* displacement at the end of the substep without contact, m */
    solid_contact_row *moves;     /* 1: contact moves it in this direction; 0: held, or of another rank */
};

/* A wetted face of a node, with added mass. */
struct solid_contact_face {
    double normal[3];
    double share; /* of the acceleration along the normal: what the added mass takes */
    double lost;  /* as much, m/s2 */
    int node;
};

struct solid_contact_implicit {
    struct solid_contact_motion *motion; /* [ends] */
    int *node_of;                        /* [ends] 1 + node of the last substep; 0: none */
    int *face_of;                        /* [ends] 1 + its first face in s->added; 0: none */
    int *remote;                         /* ends of other ranks' particles */
    uint8_t *taken[SOLID_CONTACT_KINDS]; /* [pairs/VEC_LANES] bits of the listed pairs that touch */
    uint8_t *close; /* [pairs/VEC_LANES] pairs of owned particles that nearly touched in the first search */
    struct solid_contact_touching touching;
    struct solid_contact_law law;
    struct solid_contact_node *node;
    struct solid_contact_iterate by;
    struct solid_contact_face *face;
    int nodes, faces, remote_ends;
    int nodes_capacity; /* of `node` and of the iterate's arrays */
    int motion_capacity, close_capacity, node_of_capacity, face_of_capacity, remote_capacity, face_capacity,
        taken_capacity[SOLID_CONTACT_KINDS];
    int across;      /* 1: a pair of two ranks may touch, on some rank */
    double stiffest; /* largest eigenvalue of a node's stiffness, 1/s2 */
    struct step_status status;
};

/* solid/contact/implicit_find.c */
/* Which ends have faces with added mass. Not collective. */
void solid_contact_implicit_find_faces(const struct solid *s, struct solid_contact *c);
/* Adds the listed pairs that touch at the end, by the nodes' `now`, and are not in the list yet; if is_first, also
 * those that touch at the beginning. Sets across and stiffest. Not collective. */
void solid_contact_implicit_find(const struct solid *s, struct solid_contact *c, int is_first);

/* solid/contact/implicit_solve.c */
/* Whether some rank lists a pair with another rank. Not collective. */
int solid_contact_implicit_solve_crosses(const struct solid_contact *c);
/* Solves a = C(d* + half a)/rho, half = dt^2/2, s2; at the end the nodes' `now` belongs to a, and a to `now` but for a
 * tolerance.
 * Sets the status if it fails. Collective. */
void solid_contact_implicit_solve(struct solid *s, struct solid_contact *c, double half);
