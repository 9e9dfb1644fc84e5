/* What the room holds: the markers served here, the shell through which forces cross ranks, the plans of exchange. */
#pragma once
#include "base/par_exchange.h"
#include "ibm/ibm.h"

/* Staggered alignments of a direction: at the cells' centres, or at their faces. Component c is at faces along c only. */
enum { IBM_CENTRE, IBM_FACE };

/* One marker's block in each component's array, and its weights in one dimension.  */
struct ibm_stencil {
    ptrdiff_t at[3];      /* first of the 3 x 3 x 3 values, in u, v, w */
    double weight[2][10]; /* [alignment] x: 0-3, the last zero; y: 4-6; z: 7-9 */
};
enum { IBM_X = 0, IBM_Y = 4, IBM_Z = 7 };

struct ibm_marker {
    double v[3];   /* velocity, m/s */
    double volume; /* A_h dx / cell volume */
    double share
        [3];    /* fraction of the force that falls on faces which take it: 1 away from the domain's sides */
    int inside; /* the block touches none but faces of this rank that take a force */
};

/* A layout's items on their way: what they were, and who serves them. */
struct ibm_route {
    int n, capacity;
    int *dest; /* [n] */
    struct par_exchange *plan;
    int *order, order_capacity; /* [served] in order of cells <- by arrival */
    double *mine, *served;      /* buffers: what is sent, what has arrived */
    size_t mine_size, served_size;
};

struct ibm {
    struct fluid *fluid;           /* borrowed */
    const struct fluid_grid *grid; /* borrowed */
    int iterations;

    struct ibm_route route; /* of the markers */
    double *kept;           /* [n][7] position, velocity, volume of this rank's own markers, last call */
    size_t kept_size;
    int n, capacity;             /* markers served here */
    struct ibm_stencil *stencil; /* [n] */
    struct ibm_marker *marker;   /* [n] */
    double *received[3];         /* [n] sum over stages and iterations of increment, m/s */
    double *increment[3];        /* [n] (V - U) A_h dx / cell volume, m/s */

    double *shell[3];  /* as the grid's arrays: forces near the sides of this rank's piece */
    int crossing;      /* some marker on some rank reaches over a side of a rank's piece */
    int crossing_x;    /* ... of the domain in x */
    int x_low, x_high; /* local range of x that all markers have touched so far */

    double given[3]; /* sum over stages of gamma_r rho Q_h V_h of the markers served here, N */

    struct ibm_route probe;
};

/* Finds who serves each point and renews the plan if that has changed on any rank. x [3][n] in m, moved into the
 * domain where periodic. Returns whether the plan is new. Collective. */
int ibm_route_set(struct ibm_route *route, const struct fluid_grid *grid, int n, const double *const x[3]);
/* Sorts what is served by its cells, as the fields' caches like it. s: first of three coordinates in cells, every `stride`. */
void ibm_route_sort(struct ibm_route *route, const struct fluid_grid *grid, const double *s, size_t stride);
void ibm_route_free(struct ibm_route *route);
/* Room for this many doubles, contents not kept. */
void ibm_reserve(double **buffer, size_t *size, size_t wanted);

/* Coordinate in cells: within [0, n) where periodic. */
double ibm_wrap(const struct fluid_grid *g, int direction, double x);

/* What the markers lack of their velocity, times their volume in cells: b->increment <- (V_h - U_h) A_h dx / cell, m/s,
 * which is the increment of dt_r Q_h V_h before the kernel spreads it.  (001: eqs 3.79, 3.80)
 * u: three faces' arrays, two ghost layers read. given[3] grows by the part of the increments that the fluid receives,
 * *squares is the sum of |V_h - U_h|^2; both of the markers served here. Not collective. */
void ibm_interpolate(struct ibm *b, double *const u[3], double given[3], double *squares);
/* u += b->increment delta, on the faces that take a force; ghosts are left stale. Collective.  (001: eqs 3.81, 3.82) */
void ibm_spread(struct ibm *b, double *const u[3]);

/* The shell: rows within four cells of the sides of this rank's piece. */
void ibm_shell_clear(struct ibm *b);
void ibm_shell_add(struct ibm *b, double *const u[3]); /* exchanges ghosts, then u += shell. Collective. */
