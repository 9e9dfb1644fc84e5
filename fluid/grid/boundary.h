/* Conditions of the six sides, by ghost cells.  (001: secs 3.4.3, 4.1)
 *
 * A value at cell centres is extended about the side's face oddly for a Dirichlet, evenly for a Neumann condition:
 *     ghost(l) = 2 value - inner(l)         ghost(l) = inner(l) + (2l - 1) d gradient         l = 1 .. layers
 * and the velocity normal to the side, which lives on the face itself, about that face. A side's face is the array's
 * index -1 at the low side, m-1 at the high one. Gradients are along the outward normal. */
#pragma once
#include "base/par_halo.h"
#include "fluid/fluid.h"
#include "fluid/poisson/transform.h"

/* What decides the normal velocity on the side's face. */
enum fluid_normal {
    FLUID_NORMAL_GIVEN,      /* by a plane of values: walls, inflow */
    FLUID_NORMAL_CONVECTIVE, /* by a plane of values that the outflow condition advances */
    FLUID_NORMAL_FREE        /* by its own momentum equation and the pressure */
};

struct fluid_boundary_side {
    int here; /* this rank touches the side, and the direction is not periodic */
    enum fluid_normal normal;
    enum fluid_condition condition[4]; /* of u, v, w, p; the normal one: Dirichlet unless free */
    double value[4];                   /* the value (Dirichlet) or outward gradient (Neumann) */
    double *plane; /* [m_b][m_a] velocity along the direction on the face, a < b the other directions; owned */
    double speed;  /* U_c, convective: mean velocity out of the domain at the start of the step, m/s */
    int drains;    /* free: 1: fluid comes in at a given velocity or at a higher pressure elsewhere */
    int is_near;   /* convective: 1: a body of this rank's is near (fluid_outflow_near) */
    int follows;   /* convective: 1: a body of some rank's is: U_c is the flow's own velocity where that is larger */
};

/* 1: component c passes a side of direction d with a gradient of zero, as fluid that leaves does. Fluid that comes in
 * then brings no velocity along the side (fluid/momentum/open.c). Not collective. */
static inline int fluid_boundary_is_open(const struct fluid_boundary_side *s, int d, int c) {
    return s->normal == FLUID_NORMAL_FREE && (c == d || (s->condition[c] == FLUID_NEUMANN && s->value[c] == 0));
}

/* 1: fluid comes in through an open side, or an edge of one of its faces, at this normal velocity, and brings no
 * velocity along the side. sign: 1 at a high side, -1 at a low one. Not collective. */
static inline int fluid_boundary_comes_in(double normal, double sign) { return sign * normal < 0; }

/* The square of the velocity with which normal momentum passes a free face, m2/s2: of the face's own velocity here
 * where fluid leaves, and of the mean with that inside where it comes in, less the dynamic pressure at a side that
 * drains. sign: as above. Not collective. */
static inline double fluid_boundary_open_flux(double here, double inside, double sign, int drains) {
    const double mean = 0.5 * (here + inside);
    return fluid_boundary_comes_in(here, sign) ? mean * mean - drains * (here * here) : here * here;
}

struct fluid_boundary {
    struct fluid_boundary_side side[3][2];
    double inflow;   /* through all given planes, into the domain, m3/s */
    double outlet;   /* area of the convective sides, m2 */
    int open;        /* some side has a free normal velocity */
    int low_unowned; /* the normal velocity on some low side is free: no array stores it */
};

/* Dies (exit 2) on conditions that contradict each other. Collective. */
struct fluid_boundary *fluid_boundary_new(const struct fluid_grid *g, const struct fluid_input *in);
void fluid_boundary_free(struct fluid_boundary *boundary);

/* Sets normal velocities that are not free on the faces of the sides, then exchanges and extends `layers` ghosts of the
 * three components. q [3]. Collective. */
void fluid_boundary_velocity(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3],
                             int layers);
/* The ghosts of one direction in part, after the faces are set and the directions before it are filled. Collective. */
void fluid_boundary_ghosts(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3],
                           int direction, const struct par_halo_part *part);
/* The same for a part of the ghosts and of the faces. Collective. */
void fluid_boundary_velocity_part(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3],
                                  const struct par_halo_part *part);
/* Sets the faces of a part. Not collective. */
void fluid_boundary_faces(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3],
                          const struct par_halo_part *part);
/* Fills a part of the pressure's ghosts. Collective. */
void fluid_boundary_pressure(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *p,
                             const struct par_halo_part *part);
/* Free normal velocities on low sides. No array stores them; they follow from continuity in the cells behind them. Not
 * collective. */
void fluid_boundary_close(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3]);

/* The end of a solver's lines at a side, of values at cell centres: of u, v, w or p. Not collective. */
enum fluid_end fluid_boundary_end(const struct fluid_boundary *boundary, int direction, int side, int quantity);

/* The distance, in doubles, from a cell to the next along a direction. */
static inline ptrdiff_t fluid_boundary_stride(const struct fluid_grid *g, int direction) {
    return direction == 0 ? 1 : direction == 1 ? g->row : g->plane;
}
/* The face of a side for the cell a, b of the other two directions (a < b). */
static inline size_t fluid_boundary_face(const struct fluid_grid *g, int direction, int side, int a, int b) {
    const int f = side ? g->m[direction] - 1 : -1;
    return direction == 0   ? fluid_grid_at(g, f, a, b)
           : direction == 1 ? fluid_grid_at(g, a, f, b)
                            : fluid_grid_at(g, a, b, f);
}
/* The other two directions, a < b. */
static inline void fluid_boundary_others(int direction, int *a, int *b) {
    *a = direction == 0 ? 1 : 0;
    *b = direction == 2 ? 1 : 2;
}

/* The faces of component c that the momentum equation advances on this rank: index low .. high-1 of each direction. Not
 * collective. */
void fluid_boundary_advanced(const struct fluid_boundary *boundary, const struct fluid_grid *g, int c, int low[3],
                             int high[3]);
