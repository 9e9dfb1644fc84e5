/* What the room holds: the markers served here, sorted into slabs, and the plans of exchange.
 *
 * A rank serves every marker whose block reaches one of its cells, and touches none but its own cells and the faces on
 * the domain's low sides: what several ranks have a part of is summed over them marker by marker, and no ghost is read
 * or written. A marker in cell i of a direction reaches cells i-2 .. i+1, whatever its place in the cell. Inner
 * markers, whose whole blocks are free faces of this rank, are kept in two cache lines each. The others are edges: each
 * has one or several pieces, which are its block as this rank's cells, or its periodic image, cut it. */
#pragma once
#include "base/par_exchange.h"
#include "base/par_swap.h"
#include "ibm/cell.h"
#include "ibm/ibm.h"
#include "ibm/kernel.h"

/* Staggered alignments of a direction: at the cells' centres, or at their faces. Component c is at faces along c only.
 */
enum { IBM_CENTRE, IBM_FACE };
/* Cells that a block reaches before and behind the marker's own, and planes of a slab: markers of slabs that are not
 * neighbours do not touch. */
enum { IBM_BEFORE = 2, IBM_BEHIND = 1, IBM_SLAB = IBM_BEFORE + IBM_BEHIND };
/* A marker on its way: place, cells; volume, cells; velocity, m/s. */
enum { IBM_X = 0, IBM_VOLUME = 3, IBM_V = 4, IBM_ITEM = 7 };
enum { IBM_PIECES = 8, IBM_SHARERS = 4 }; /* at most: images of a marker on a rank, ranks that serve it */

/* One block of a component's array: first of the 3 x 3 x 3 values, weights. */
struct ibm_block {
    ptrdiff_t at[3];
    double x[3][4], y[3][3], z[3][3]; /* [component]; x: the last zero */
};

/* Reading, what lies beyond a side is made from what lies before it; writing, it takes nothing. */
struct ibm_piece {
    int edge;
    struct ibm_block read, write;
};

struct ibm_edge {
    double s[3];         /* cells of the whole domain */
    double v[3], volume; /* m/s; A_h dx / cell volume */
    double constant[3];  /* part of U_h that the sides' conditions give, m/s */
    double share[3];     /* fraction of the force that falls on faces which take it */
    int cell[3];         /* of the whole domain */
    int mine;            /* its cell is this rank's: it is counted here */
    int pieces, piece[IBM_PIECES];
    int summands, summand[IBM_SHARERS]; /* what makes U_h up, in b->sum: by rising rank, so that all agree to the bit */
};

/* A layout's items on their way: what they are, and who serves them. */
struct ibm_route {
    int n, capacity;
    long *key; /* [n] what decides who serves an item */
    struct par_exchange *plan;
    int *item, *dest;      /* [copies] while a plan is made */
    double *mine, *served; /* items as sent; as arrived */
    size_t served_size;
};

/* A marker while it is sorted. */
struct ibm_place {
    int bin, x;
    int cell[3];
};

/* Ranks in y and z that a marker's block reaches from a cell: first and last. */
struct ibm_touch {
    short low, high;
};

/* Vectors of the implicit forcing's equation. */
enum ibm_vector {
    IBM_DEMAND,    /* y: what the force is made from, m/s2; kept from stage to stage */
    IBM_FORCE,     /* q = B y, m/s2 */
    IBM_RESIDUAL,  /* of the equation of y, m/s */
    IBM_Z,         /* B residual */
    IBM_D,         /* direction of the search */
    IBM_BD,        /* B direction */
    IBM_KD,        /* the equation's operator on the direction */
    IBM_TARGET,    /* scratch of B, and of a read */
    IBM_INCREMENT, /* scratch of B */
    IBM_VECTORS
};

/* Of the markers that are counted here: what the fluid receives of their increments, and their slips. */
struct ibm_tally {
    double given[3], squares;
};

struct ibm {
    struct fluid *fluid;           /* borrowed */
    const struct fluid_grid *grid; /* borrowed */
    int iterations;
    struct fluid_mirror mirror[3][3][2]; /* [component][direction][side] */
    struct ibm_touch *touch[3];          /* [n[direction]], owned; x: NULL */
    int *owner[3];                       /* [n[direction]] a cell's part of its rank's number; x: NULL */
    int inner_low[3], inner_high[3];     /* cells of the whole domain whose markers are inner */

    struct ibm_route route; /* of the markers */
    int served;             /* markers that have arrived: inner first, then edges, in the order below */
    int *arrival;           /* [served] which of the arrivals */
    int capacity;
    struct ibm_place *place; /* [served] of the arrivals */
    int *by_x, *bin;         /* [served]; first of each bin */
    int *peer;               /* [3 size] */
    int moved;               /* inner markers that have changed their cell since they were sorted */
    int slabs;               /* of IBM_SLAB planes, the last one thicker */
    int *slab_at; /* [4][slabs + 1] first of each slab: inner markers, near edges, their pieces, far pieces */
    int inner;    /* inner markers, [inner] */
    struct ibm_stencil *stencil;
    int edges, near_edges,
        edge_capacity; /* near ones have all their pieces in one slab of this rank; far ones follow */
    struct ibm_edge *edge;
    int pieces, piece_capacity;
    struct ibm_piece *piece;
    double (*increment)[3];           /* [served] (V - U) A_h dx / cell volume, m/s */
    double (*received)[3];            /* [served] its sum over stages and iterations */
    int implicit;                     /* diffusion is implicit: ibm/implicit.c */
    double (*vector[IBM_VECTORS])[3]; /* [served] of its equation, by enum ibm_vector */
    double *home;                     /* [n][3] the demand, as its markers came */
    size_t home_size;

    /* sums over the blocks of edges, m/s: those of this rank's edges, then those of other ranks */
    double (*sum)[3], (*sent)[3]; /* [edges + swapped], [swapped] */
    int swapped;                  /* sums that other ranks have a part of, once for each of these ranks */
    int *swap_edge;               /* [swapped] the edge, by rank */
    struct par_swap *swap;

    double given[3]; /* sum over stages of gamma_r rho Q_h V_h of the markers counted here, N */
    double *by_marker;
    size_t by_marker_size;
    struct ibm_route probe;
};

/* The range of a slab in one of the four lists. */
enum ibm_list { IBM_INNER, IBM_NEAR, IBM_NEAR_PIECES, IBM_FAR_PIECES, IBM_LISTS };
static inline int ibm_slab_first(const struct ibm *b, enum ibm_list list, int slab) {
    return b->slab_at[(int)list * (b->slabs + 1) + slab];
}

/* Room for this many doubles, contents not kept. */
void ibm_buffer_reserve(double **buffer, size_t *size, size_t wanted);
/* Room for n items of so many doubles, contents not kept; returns whether a new plan is needed for their number alone.
 */
int ibm_route_reserve(struct ibm_route *route, int n, size_t doubles);
void ibm_route_free(struct ibm_route *route);

/* A probe's tip on its way: place, cells, outward normal, and the wall's velocity; and back: p|e, dp/dn|e, viscous
 * traction, and, read for the wall, dp/dn carried there and mu |u - V|/l2, both Pa/m. */
enum { IBM_TIP_NORMAL = 3, IBM_TIP_VELOCITY = 6, IBM_TIP_SENT = 9 };
enum { IBM_TIP_SLOPE = 1, IBM_TIP_STRESS = 2, IBM_TIP_WALL_SLOPE = 5, IBM_TIP_SCALE = 6, IBM_TIP_RETURNED = 7 };
/* What all tips have in common. */
struct ibm_tip_form {
    double density, mu; /* kg/m3, Pa s */
    double length;      /* from the wall, m, where stresses are carried there; 0: the tip's own */
};
/* The served tips, from the state with its ghosts: item [tips][IBM_TIP_SENT] -> result [tips][IBM_TIP_RETURNED]. Not
 * collective. */
void ibm_tip_measure(const struct fluid_grid *g, const struct fluid_state *f, const struct ibm_tip_form *form,
                     size_t tips, const double *item, double *result);

/* The ranks that serve a marker in a cell, by rising number; returns how many. */
int ibm_share_ranks(const struct ibm *b, const int cell[3], int rank[IBM_SHARERS]);

/* Sorts what has arrived into inner markers, edges and slabs, and sets the edges' pieces up. Not collective. */
void ibm_layout(struct ibm *b);
int ibm_layout_bins(const struct ibm *b); /* what they are sorted into */
int ibm_layout_is_inner(const struct ibm *b, const int cell[3]);
int ibm_layout_slab_of(const struct ibm *b, int plane); /* plane of this rank, or beside it */
/* The pieces of an edge: returns how many, and the plane of the marker as each of them sees it. */
int ibm_edge_planes(const struct ibm *b, const int cell[3], int plane[IBM_PIECES]);
/* Weights of an edge's pieces, its constant and share, from its place. */
void ibm_edge_set(struct ibm *b, struct ibm_edge *e);

/* What becomes of an increment besides: nothing, or it is what a marker has given, or is added to it. */
enum ibm_keep { IBM_LOOK, IBM_SET, IBM_ADD };
static inline void ibm_keep(double received[3], const double increment[3], enum ibm_keep keep) {
    for (int c = 0; c < 3 && keep != IBM_LOOK; c++)
        received[c] = keep == IBM_SET ? increment[c] : received[c] + increment[c];
}
/* increment <- (V_h - U_h) A_h dx / cell, which is the increment of dt_r Q_h V_h before the kernel spreads it.  (001:
 * eqs 3.79, 3.80)      Inner markers first .. last-1. */
void ibm_sweep_gather(struct ibm *b, double *const u[3], int first, int last, enum ibm_keep keep, struct ibm_tally *t);
/* u += increment delta  (001: eqs 3.81, 3.82) */
void ibm_sweep_read(const struct ibm *b, double *const u[3], double (*velocity)[3]);
void ibm_sweep_scatter(const struct ibm *b, double *const u[3], int first, int last);
/* The same for edges: sums over pieces; the increments once the sums are complete; pieces. */
void ibm_edge_sum(struct ibm *b, double *const u[3], int first_piece, int last_piece);
void ibm_edge_finish(struct ibm *b, int first, int last, enum ibm_keep keep, struct ibm_tally *t);
void ibm_edge_velocity(struct ibm *b, int with_sides, double (*velocity)[3]);
void ibm_edge_scatter(const struct ibm *b, double *const u[3], int first_piece, int last_piece);
/* The demand, to those that sent the markers (kept in home), and back once they are sorted anew; unless they are the
 * same, what they had is forgotten. Collective. */
void ibm_demand_home(struct ibm *b);
void ibm_demand_out(struct ibm *b, int same);
/* All markers' velocities, velocity [served]; with what the sides' conditions add to it, or without. Collective. */
void ibm_whole_read(struct ibm *b, double *const u[3], int with_sides, double (*velocity)[3]);
/* u += strength delta, of all markers, strength [served]. Not collective. */
void ibm_whole_write(struct ibm *b, double *const u[3], const double (*strength)[3]);
/* Completes the sums of far edges across ranks. Collective. */
void ibm_share_sums(struct ibm *b);
