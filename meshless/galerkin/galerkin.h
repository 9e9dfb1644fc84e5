/* Element-free Galerkin: plane elasticity of a cracked plate on scattered nodes.  (002; docs/design/meshless.md)
 *
 * The displacement is u(x) = sum phi_I(x) u_I with shape functions of moving least squares (mls.h). A crack is a line
 * of straight parts; nodes near it are cut off from points on its other side (cut.h). The equilibrium is integrated
 * over background cells (cells.h). Given displacements and the continuity across a virtual crack are linear constraints
 * on the nodal values (constraint.h), met by an augmented Lagrangian (solve.h). Stress-intensity factors follow from
 * domain integrals (intensity.h).
 *
 * All ranks hold the whole problem and do the same arithmetic. */
#pragma once
#include "physics/choice_points.h"
#include <stddef.h>

/* A crack from end 0 over the bends to end 1; an end that is inside the body is a tip. */
struct galerkin_crack {
    double end[2][2]; /* m */
    int bends;
    const double (*bend)[2]; /* [bends] m */
};

/* A hole in the body. */
struct galerkin_hole {
    int corners;
    const double (*corner)[2]; /* [corners] convex, counterclockwise, m */
};

/* Given displacement along the part of the body's outline between `from` and `to` (its mean over each cell's edge), or
 * at a point (from = to). value, if not NULL, gives it as a function of place instead of `displacement`. */
struct galerkin_fixed {
    double from[2], to[2]; /* m */
    int direction[2];      /* 1: given in this direction */
    double displacement[2];
    void (*value)(const double x[2], double u[2]);
};

/* Force per unit area along the part of the body's outline between `from` and `to`. */
struct galerkin_pull {
    double from[2], to[2];                         /* m */
    double traction[2];                            /* Pa */
    void (*value)(const double x[2], double t[2]); /* not NULL: instead of traction */
};

struct galerkin_input {
    int plane_strain;
    double youngs_modulus, poisson_ratio, thickness; /* Pa, 1, m */
    double spacing;                                  /* of the nodes, the widest, m */
    int nodes;
    const double (*node)[2]; /* [nodes] m */
    const double *size;      /* [nodes] nodal spacing about each node, m; NULL: spacing */
    int corners;
    const double (*corner)[2]; /* [corners] of the body, convex, counterclockwise, m */
    int holes;
    const struct galerkin_hole *hole; /* [holes] inside the body */
    int cracks;
    const struct galerkin_crack *crack;
    int fixed, pulls;
    const struct galerkin_fixed *fix;
    const struct galerkin_pull *pull;
    double body_force[2]; /* per unit volume, N/m3 */

    enum galerkin_basis basis;
    enum galerkin_weight weight;
    double support;    /* radius of a node's weight, in spacings about it */
    double tip_radius; /* radius of the zone in which the basis has the tip's functions, spacings */
    int cells[2];      /* background cells along x and y */
    int levels;        /* rows of cells next to a tip are halved so many times, as the nodes are (nodes.h) */
    double patch;      /* half width of a level about a tip, spacings of the level before */
    int turned;        /* the nodes' levels lie along the tips (nodes.h), and their corners reach farther */
    int gauss;         /* points of a cell along each direction */
    int gauss_tip;     /* the same within a support of a tip */
    enum galerkin_method method;
    double interface_spacing; /* of the points along a virtual crack's extension, local spacings */
    double penalty;           /* alpha, in units of E times the thickness */
    double tolerance;         /* largest violation of a constraint, relative to the largest nodal displacement */
    int iterations;           /* at most */
    enum galerkin_update update;
};

enum { GALERKIN_CRACKS = 8, GALERKIN_TIPS = 2 * GALERKIN_CRACKS };
/* A straight part of a crack and its own frame: (xi, eta) with the origin at its first point, xi along it. */
struct galerkin_part {
    double origin[2], along[2], length;
};
struct galerkin_line {
    int parts; /* in order from end 0 to end 1 */
    struct galerkin_part *part;
    int is_tip[2];   /* [end] inside the body */
    double reach[2]; /* [end] the cut goes on by this beyond a tip, m; 0 without an extension */
};
struct galerkin_tip {
    double x[2], along[2]; /* place, and unit vector that points ahead of the tip */
    int line, end;
};

/* A list of nodes by square bins of the support's size. */
struct galerkin_bins {
    double low[2], size;
    int n[2];
    int *first, *node; /* [n0 n1 + 1], [nodes] */
};

/* A point at which shape functions are wanted. see: a point next to it on the side of the cracks from which nodes are
 * seen; x itself if x is on no crack. */
struct galerkin_place {
    double x[2], see[2];
};

enum { GALERKIN_NEAR = 512 }; /* nodes that a point sees at most */
struct galerkin_shape {
    int n;
    int node[GALERKIN_NEAR];
    double phi[GALERKIN_NEAR], d[GALERKIN_NEAR][2]; /* shape functions and their gradients */
};

/* Convex pieces of background cells. */
struct galerkin_piece {
    int corners, first; /* first: of its corners in the array of all */
    int tip;            /* the tip that is one of its corners, or -1 */
    int points;         /* Gauss points along each direction */
    int cell;
};
struct galerkin_cells {
    int pieces, corners;
    struct galerkin_piece *piece;
    double (*corner)[2];
    long points; /* Gauss points of all pieces */
    double near; /* edges and pieces within this of a tip have gauss_tip points */
};

/* A constraint sum_k value_k u[unknown_k] = given. */
struct galerkin_rows {
    int rows, entries, row_capacity, entry_capacity;
    int *first;    /* [rows + 1] */
    int *unknown;  /* [entries] 2 node + component */
    double *value; /* [entries] */
    double *given; /* [rows] */
    int *kind;     /* [rows] enum galerkin_row */
};
enum galerkin_row { GALERKIN_ROW_FIXED, GALERKIN_ROW_JUMP, GALERKIN_ROW_STRAIN };

struct galerkin_solution {
    double *u;          /* [2 nodes] nodal values (not the displacement at the nodes) */
    double *multiplier; /* [rows] */
    int iterations, converged;
    double violation;   /* largest |G u - g| over the largest |u| */
    double equilibrium; /* |K u + G^T r - f| over |f| and |G^T r| */
    double energy;      /* 1/2 u K u, J */
    double *history;    /* [iterations] violation after each, owned */
};

struct galerkin {
    struct galerkin_input in; /* arrays are borrowed */
    double widest;            /* radius of a weight, m */
    double *radius;           /* [nodes] of the weights, m */
    double elastic[3][3];     /* plane stiffness, Pa */
    int lines, tips;
    struct galerkin_line line[GALERKIN_CRACKS];
    struct galerkin_tip tip[GALERKIN_TIPS];
    unsigned char *near_line; /* [nodes] bit c: the node's support meets crack c */
    struct galerkin_bins bins;
    struct galerkin_cells cells;
    struct galerkin_rows rows;
    struct galerkin_solution solution;
    int *rank, *node_of; /* [nodes] order of the nodes in the band, and back */
    int half_band;
};

/* Dies (exit 2) with the node, the number and what to change, where the problem is badly posed. The input's arrays are
 * borrowed as long as it lives. Collective. */
struct galerkin *meshless_galerkin_new(const struct galerkin_input *in);
void meshless_galerkin_free(struct galerkin *g);
