/* Data of the forcing and the probe: the markers served here, sorted into slabs, and the exchange plans.
 *
 * A rank serves every marker whose block reaches one of its cells. It changes only its own cells and the faces on the
 * domain's low sides: for a marker that several ranks serve, the ranks' parts are summed, and no ghost is read or
 * written. A marker in cell i of a direction reaches cells i-2 .. i+1, wherever it is in the cell. Inner markers, whose
 * whole blocks are cells of this rank away from the sides, are stored in two cache lines each. The other markers are
 * edges: each has one or several pieces, the parts of its block, or of the block's periodic images, on this rank. */
#pragma once
#include "base/par_exchange.h"
#include "base/par_swap.h"
#include "ibm/cell.h"
#include "ibm/ibm.h"
#include "ibm/kernel.h"

/* Staggered alignments of a direction: at cell centres or at faces. Component c is at faces along c only. */
enum { IBM_CENTRE, IBM_FACE };
/* Number of cells that a block reaches before and behind the marker's own cell; planes of a slab. Blocks of markers in
 * slabs that are not neighbours do not overlap. */
enum { IBM_BEFORE = 2, IBM_BEHIND = 1, IBM_SLAB = IBM_BEFORE + IBM_BEHIND };
/* A marker as it is sent: position, cells; volume, cells; velocity, m/s. */
enum { IBM_X = 0, IBM_VOLUME = 3, IBM_V = 4, IBM_ITEM = 7 };
enum {
    IBM_PIECES = 8,
    IBM_SHARERS = 4
}; /* largest numbers of images of a marker on a rank, and of ranks that serve
    * it */

/* One block of a component's array: index of the first of the 3 x 3 x 3 values, weights. */
struct ibm_block {
    ptrdiff_t at[3];
    double x[3][4], y[3][3], z[3][3]; /* [component]; x: the fourth is zero */
};

/* The part of a block on this rank. Reading beyond a side uses the boundary condition; force is never spread beyond a
 * side. */
struct ibm_piece {
    int edge;
    struct ibm_block read, write;
};

struct ibm_edge {
    double s[3];         /* cells of the whole domain */
    double v[3], volume; /* m/s; A_h dx / cell volume */
    double constant[3];  /* part of U_h that comes from the sides' boundary conditions, m/s */
    double share[3];     /* fraction of the force that is spread to the domain's faces */
    int cell[3];         /* of the whole domain */
    int mine;            /* 1: its cell belongs to this rank, which counts it in sums */
    int pieces, piece[IBM_PIECES];
    int summands, summand[IBM_SHARERS]; /* indices in b->sum of the parts of U_h, by rising rank, so that all ranks
                                         * agree to the bit */
};

/* Items that are exchanged, and the ranks that serve them. */
struct ibm_route {
    int n, capacity;
    long *key; /* [n] number that decides which rank serves an item */
    struct par_exchange *plan;
    int *item, *dest;      /* [copies] used while a plan is made */
    double *mine, *served; /* items as sent; items as received */
    size_t served_size;
};

/* A marker during the sorting. */
struct ibm_place {
    int bin, x;
    int cell[3];
};

/* First and last rank in y or z that a marker's block reaches from a cell. */
struct ibm_touch {
    short low, high;
};

/* Vectors of the implicit forcing's equation. */
enum ibm_vector {
    IBM_MARKER_FORCE, /* kept from step to step, m/s2: with feedback and with implicit diffusion f */
    IBM_RESIDUAL,     /* residual of the equation of f, m/s */
    IBM_D,            /* search direction */
    IBM_KD,           /* the equation's operator on the direction */
    IBM_STRENGTH,     /* scratch of writing and reading */
    IBM_VECTORS
};

/* Sums over the markers that this rank counts: the force that the fluid receives, and the slip. */
struct ibm_tally {
    double impulse[3], squares;
};

/* The fluid inside a body (ibm/inside.c). */
struct ibm_inside {
    const double *part[3]; /* of solid in each cell, for the driving along each direction, borrowed; NULL: the fluid
                            * inside is driven as all fluid is */
    double taken[3];       /* from this rank's faces: mean force of the step on the fluid, N */
};

/* Of the forcing with feedback on the fluid, in a step that adds it up (ibm/feedback_work.c). */
struct ibm_work {
    double (*u)[3], (*received)[3]; /* [served] at the end of the last stage, m/s; NULL: no step has added any */
    int capacity;
    double sum; /* this rank's share, J */
};

struct ibm {
    /* Parameters: read-only once it is made. */
    struct fluid *fluid;           /* borrowed */
    const struct fluid_grid *grid; /* borrowed */
    int iterations;
    int implicit;     /* diffusion is implicit: ibm/implicit.c */
    double slip_time; /* s, of the forcing with feedback or with implicit diffusion; 0: it is neither */
    struct ibm_inside inside;
    struct fluid_mirror mirror[3][3][2]; /* [component][direction][side] */
    int is_wall[3][2];                   /* [direction][side] */
    struct ibm_touch *touch[3];          /* [n[direction]], owned; x: NULL */
    int *owner[3];                       /* [n[direction]] contribution of a cell to the number of the rank that owns
                                          * it; x: NULL */
    int inner_low[3], inner_high[3];     /* cells of the whole domain in which a marker is an inner one */

    /* State: vector[IBM_MARKER_FORCE] alone, by marker. A checkpoint has it by particle, as `demand`
     * (coupling/run_state.c). */
    double (
        *vector[IBM_VECTORS])[3]; /* [served] of the implicit forcing's equation, by enum ibm_vector; others: work */

    /* Work: the layout of the markers, found again whenever they are set. */
    struct ibm_route route; /* of the markers */
    int served;             /* number of markers that have arrived; sorted: inner markers first, then edges */
    int *arrival;           /* [served] index of each in the order of arrival */
    int capacity;
    struct ibm_place *place; /* [served] in the order of arrival */
    int *by_x, *bin;         /* [served]; first index of each bin */
    int *peer;               /* [3 size] */
    int moved;               /* number of inner markers that have changed their cell since the last sort */
    int must_sort;           /* 1: ibm_markers_sort_again */
    int slabs;               /* of IBM_SLAB planes, the last one thicker */
    int *slab_at; /* [4][slabs + 1] first index of each slab: inner markers, near edges, their pieces, far pieces */
    struct ibm_tally *tally; /* [slabs + 1] of a stage's slabs, and of the far edges */
    int inner;               /* inner markers, [inner] */
    struct ibm_stencil *stencil;
    int edges, near_edges,
        edge_capacity; /* near edges have all their pieces in one slab of this rank; far edges follow them */
    struct ibm_edge *edge;
    int pieces, piece_capacity;
    struct ibm_piece *piece;
    struct ibm_route probe; /* of the tips that other ranks serve; key, mine [n][3], cells: of all tips */
    int away;               /* number of these tips; their probes: probe.item */
    double *away_item;      /* [away][IBM_TIP_SENT], then results [away][IBM_TIP_RETURNED] */
    size_t away_size;

    /* Work: of a stage or a step. */
    double (*increment)[3]; /* [served] (V - U) A_h dx / cell volume, m/s */
    double (*velocity)[3];  /* [served] of the forcing with feedback: U_h, then its slip, m/s; NULL otherwise */
    double (*change)[3];    /* [served] of the kept force in this step, m/s2; NULL without feedback */
    double (*received)[3];  /* [served] sum of the increments over stages and iterations */
    double *marker_force;   /* [n][3] what IBM_MARKER_FORCE holds, in the order of ibm_markers_set */
    size_t marker_force_size;
    int marker_force_is_next; /* 1: set by ibm_marker_force_set_next, for the next markers */
    /* sums over the blocks of edges, m/s: of this rank's edges, then those received from other ranks */
    double (*sum)[3], (*sent)[3]; /* [edges + swapped], [swapped] */
    int swapped;                  /* number of sums shared with other ranks, counted once for each of these ranks */
    int *swap_edge;               /* [swapped] the edge, by rank */
    struct par_swap *swap;
    struct ibm_work work;
    double total_force[3]; /* sum over stages of gamma_r rho Q_h V_h of the markers counted here, N */
    double *by_marker;
    size_t by_marker_size;
};

/* The four lists of a slab. */
enum ibm_list { IBM_INNER, IBM_NEAR, IBM_NEAR_PIECES, IBM_FAR_PIECES, IBM_LISTS };
static inline int ibm_slab_first(const struct ibm *ibm, enum ibm_list list, int slab) {
    return ibm->slab_at[(int)list * (ibm->slabs + 1) + slab];
}

/* Makes the buffer hold this many doubles; its contents are lost. */
void ibm_buffer_reserve(double **buffer, size_t *size, size_t wanted);
/* Makes room for n items of so many doubles; contents are lost. Returns 1 if the number of items has changed, so that a
 * new plan is needed. */
int ibm_route_reserve(struct ibm_route *route, int n, size_t doubles);
void ibm_route_free(struct ibm_route *route);

/* A probe's tip as it is sent: position, cells, outward normal, and the wall's velocity. Its result: p|e, dp/dn|e,
 * viscous traction; with the wall's velocity also dp/dn extrapolated to the wall, and mu |u - V|/l2, both Pa/m. */
enum { IBM_TIP_NORMAL = 3, IBM_TIP_VELOCITY = 6, IBM_TIP_SENT = 9 };
enum { IBM_TIP_SLOPE = 1, IBM_TIP_STRESS = 2, IBM_TIP_WALL_SLOPE = 5, IBM_TIP_SCALE = 6, IBM_TIP_RETURNED = 7 };
/* Values common to all tips. */
struct ibm_tip_form {
    double density, mu; /* kg/m3, Pa s */
    double length;      /* distance from the wall, m, over which stresses are extrapolated; 0: stresses at the tip are
                         * used */
};
/* Evaluates tips in this rank's cells on the state, whose ghosts are filled: item [tips][IBM_TIP_SENT] -> result
 * [tips][IBM_TIP_RETURNED]. By any thread. Not collective. */
void ibm_tip_measure(const struct fluid_grid *g, const struct fluid_state *f, const struct ibm_tip_form *form, int tips,
                     const double *item, double *result);

/* The ranks that serve a marker in a cell, by rising number. Returns how many. */
int ibm_share_ranks(const struct ibm *ibm, const int cell[3], int rank[IBM_SHARERS]);

/* Sorts the arrived markers into inner markers, edges and slabs, and makes the edges' pieces. Not collective. */
void ibm_layout(struct ibm *ibm);
/* Before the first forcing of a stage (ibm/inside.c). */
void ibm_inside_stage(struct ibm *ibm, int r, double dt);
int ibm_layout_bins(const struct ibm *ibm); /* number of bins of the sort */
int ibm_layout_is_inner(const struct ibm *ibm, const int cell[3]);
int ibm_layout_slab_of(const struct ibm *ibm, int plane); /* plane of this rank, or next to it */
/* The planes of a marker and of its images that have pieces here. Returns the number of pieces. */
int ibm_edge_planes(const struct ibm *ibm, const int cell[3], int plane[IBM_PIECES]);
/* Sets the weights of an edge's pieces, its constant and its share, from its position. */
void ibm_edge_set(struct ibm *ibm, struct ibm_edge *e);
/* The fraction of a marker's kernel across the sides of direction d that is not on a wall or beyond it; s: cells. */
double ibm_edge_fraction(const struct ibm *ibm, int d, double s);

/* What is done with an increment: it is evaluated alone, overwrites the received force, or is added to it. */
enum ibm_record { IBM_EVALUATE, IBM_OVERWRITE, IBM_ACCUMULATE };
static inline void ibm_record(double received[3], const double increment[3], enum ibm_record record) {
    for (int c = 0; c < 3 && record != IBM_EVALUATE; c++)
        received[c] = record == IBM_OVERWRITE ? increment[c] : received[c] + increment[c];
}
/* increment <- (V_h - U_h) A_h dx / cell, which is the increment of dt_r Q_h V_h before the kernel spreads it.  (001:
 * eqs 3.79, 3.80)      For the inner markers first .. last-1. */
void ibm_sweep_gather(struct ibm *ibm, double *const u[3], int first, int last, enum ibm_record record,
                      struct ibm_tally *t);
/* velocity [served] <- U_h of the inner markers first .. last-1  (001: eq. 3.79) */
void ibm_sweep_read(const struct ibm *ibm, double *const u[3], int first, int last, double (*velocity)[3]);
/* u += increment delta  (001: eqs 3.81, 3.82) */
void ibm_sweep_scatter(const struct ibm *ibm, double *const u[3], int first, int last);
/* The same for edges: sums over pieces (001: eq. 3.79); increments, once the sums are complete (eq. 3.80); spreading by
 * pieces (eqs 3.81, 3.82). */
void ibm_edge_sum(struct ibm *ibm, double *const u[3], int first_piece, int last_piece);
void ibm_edge_sum_spread(struct ibm *ibm, double *const u[3]); /* all, with the weights of spreading */
void ibm_edge_finish(struct ibm *ibm, int first, int last, enum ibm_record record, struct ibm_tally *t);
void ibm_edge_velocity(struct ibm *ibm, int with_sides, double (*velocity)[3]);
void ibm_edge_scatter(const struct ibm *ibm, double *const u[3], int first_piece, int last_piece);
/* A thread's slabs, from .. to-1: about as many markers as the others'. */
void ibm_slabs_share(const struct ibm *ibm, int thread, int *from, int *to);
/* u += increment delta, for all pieces of a slab; none: nothing is done. A thread's part of all slabs, within
 * threads_run: waits for the increments of all threads, and writes even slabs before odd ones. */
void ibm_slabs_write(const struct ibm *ibm, double *const u[3], int slab);
void ibm_slabs_write_part(const struct ibm *ibm, double *const u[3], int from, int to);
/* velocity [served] <- U_h of a slab's inner markers, and the sums of its near edges; then, on one thread, U_h of all
 * edges. The second is collective. */
void ibm_slabs_read(struct ibm *ibm, double *const u[3], int slab, double (*velocity)[3]);
void ibm_slabs_finish(struct ibm *ibm, double *const u[3], int with_sides, double (*velocity)[3]);
/* Returns each marker's force to the rank that sent the marker; and sends it out again after a new sort. Unless the
 * markers are the same, the forces are set to zero. Collective. */
void ibm_marker_force_collect(struct ibm *ibm);
void ibm_marker_force_distribute(struct ibm *ibm, int same);
/* Velocities at all markers, velocity [served]; with_sides: with the part that comes from the sides' boundary
 * conditions. Collective. */
void ibm_transfer_read(struct ibm *ibm, double *const u[3], int with_sides, double (*velocity)[3]);
/* u += strength delta, for all markers, strength [served]. Not collective. */
void ibm_transfer_write(struct ibm *ibm, double *const u[3], const double (*strength)[3]);
/* Completes the sums of far edges across ranks. Collective. */
void ibm_share_sums(struct ibm *ibm);
/* velocity <- U of all markers after a stage, with the weights of spreading. Collective. */
void ibm_feedback_read_again(struct ibm *ibm);
