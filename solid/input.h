/* What a solid is made from: model, materials, bodies, cuts, constraints, loads.  (001: ch. 3.3; docs/scene.md) */
#pragma once
#include "base/ensure.h"

#include <stddef.h>
#include <stdint.h>

/* What the bonds stand for: a solid in three dimensions (nu = 1/4), or a plate in the x-y plane (nu = 1/3 in plane
 * stress, 1/4 in plane strain). A plate has two components of everything, and the third arrays are NULL. */
enum solid_model { SOLID_3D, SOLID_PLANE_STRESS, SOLID_PLANE_STRAIN };
enum { SOLID_MODELS = SOLID_PLANE_STRAIN + 1 };

/* How c depends on the length of a bond: solid/law/micromodulus.h.  (000: eqs 9, 10) */
enum solid_micromodulus_kind { SOLID_CONSTANT, SOLID_CONICAL, SOLID_EXPONENTIAL, SOLID_MICROMODULI };

/* Gamma: the exact fraction of a particle's cell inside the horizon, or the linear ramp.  (SPEC 2; 000: eq. 22) */
enum solid_partial { SOLID_PARTIAL_EXACT, SOLID_PARTIAL_RAMP };

/* Bonds between particles of different horizons: both ends' halves (Ren, Zhuang and Rabczuk 2016), or each end by its
 * own horizon alone (000: sec. 1.2.5). */
enum solid_horizons { SOLID_DUAL_HORIZON, SOLID_ONE_SIDED };

struct solid_material {
    double youngs_modulus;  /* Pa */
    double density;         /* kg/m3 */
    double fracture_energy; /* G0, J/m2; INFINITY: never breaks */
    double horizon_ratio;   /* m = delta / spacing */
    enum solid_micromodulus_kind micromodulus;
};

/* One closed curve of a plate's outline: from each corner to the next (from the last to the first) a straight line or
 * an arc. Borrowed. */
struct solid_outline {
    int is_hole;
    int corners;
    const double (*corner)[2]; /* m */
    const double (*centre)[2]; /* m, of the arc from the corner; read where turn is not 0 */
    const signed char *turn;   /* 0: straight, +1: arc counterclockwise, -1: clockwise */
};

/* An initial crack: in a plate a line of points, in 3D a plane quadrilateral of four corners. Bonds that it crosses are
 * broken from the start. Borrowed. */
struct solid_cut {
    int points;
    const double (*point)[3]; /* m; z is 0 in a plate */
};

enum solid_shape {
    SOLID_BOX,
    SOLID_SPHERE,
    SOLID_CYLINDER,
    SOLID_ELLIPSOID,
    SOLID_POINTS,
    SOLID_POLYGON,
    SOLID_SHAPES
};

/* A body cut from a cubic lattice whose points stand at origin + (i + 1/2) spacing. */
struct solid_body {
    char name[64];
    enum solid_shape shape;
    double low[3], high[3];   /* box, m */
    double centre[3], radius; /* sphere, cylinder */
    int axis;                 /* cylinder */
    double length;            /* cylinder */
    double radii[3];          /* ellipsoid, along x, y, z */
    /* spherical cavities on a cubic array, cut out of any shape; period 0: none */
    double cavity_period, cavity_radius, cavity_centre[3];
    /* SOLID_POINTS: particles as they are, on no lattice; borrowed, [points] */
    long points;
    const double *point[3];      /* of a plate: x, y, NULL */
    const double *point_volume;  /* m3; of a plate the area, m2 */
    const double *point_horizon; /* m; NULL: the material's */
    /* SOLID_POLYGON: pieces and holes of a plate */
    int outlines;
    const struct solid_outline *outline; /* borrowed */
    int material;
    double least_horizon; /* m, of its particles; solid_new sets it */
};

/* A factor that varies in time: straight lines between points, constant before the first and after the last. n = 0: 1.
 * Borrowed. */
struct solid_time {
    int n;
    const double *t, *factor; /* [n] s, ascending; 1 */
};

/* What is imposed on the particles of a region (X0 inside the box): per direction free, or the velocity given, or the
 * displacement, times a factor of time. Over a substep a particle moves at one speed, the mean of the speeds given, so
 * that either integrator brings it where it is to be at the substep's end. */
struct solid_constraint {
    double low[3], high[3];
    int direction[3];   /* 1: held or driven in this direction */
    double velocity[3]; /* 0: held */
    int has_displacement;
    double displacement[3]; /* m, instead of the velocity */
    struct solid_time time;
};

/* A force on the particles of a region, per unit volume, or on those along a piece of a plate's edge, per unit area of
 * the edge; times a factor of time. A substep sees the mean of the factor over it, as a constant. */
enum solid_load_kind { SOLID_LOAD_REGION, SOLID_LOAD_EDGE };
struct solid_load {
    enum solid_load_kind kind;
    double low[3], high[3]; /* region (X0), m */
    double force[3];        /* region, N/m3 */
    double edge[2][2];      /* from, to, m */
    double traction[3];     /* edge, Pa */
    int over_horizon; /* edge, straight: even over all particles within the horizon behind it; 0: over the outermost */
    struct solid_time time;
};

/* The displacement at the start: displacement times exp(-r^2) or sin(2 pi r), r = (x - centre)/width, x the coordinate
 * `along`; several add up. */
enum solid_initial_shape { SOLID_GAUSSIAN, SOLID_SINE };
struct solid_initial {
    enum solid_initial_shape shape;
    int along;
    double centre, width, displacement[3]; /* m */
};

/* Bonds with an end in the region (X0) never break. */
struct solid_region {
    double low[3], high[3];
};

/* Refinement of plates that are polygons: each level halves the spacing.  (000: ch. 2; solid/refine/refine.h) */
struct solid_refined { /* from the start, X0 */
    double low[3], high[3];
    int level;
};
struct solid_refinement {
    int levels;
    double energy;           /* kappa: refine where W >= kappa W_max; 0: off */
    double damage;           /* refine where the damage is above; 0: off */
    double low[3], high[3];  /* only here (X0), m */
    int horizon_kept;        /* 1: all levels have the material's horizon; 0: scaled with the spacing */
    int interface_corrected; /* 1: fine particles next to coarse ones have sqrt(2) times their horizon  (000: eq. 40) */
    int held_refine;         /* 1: particles of constraints and loads are refined too */
    int starts;
    const struct solid_refined *start; /* borrowed during the call */
};

struct solid_input {
    enum solid_model model; /* default SOLID_3D */
    double thickness;       /* of a plate, m */
    enum solid_partial partial;
    enum solid_horizons horizons;
    int cuts;
    const struct solid_cut *cut; /* borrowed during the call */
    double spacing;              /* m */
    double speed;                /* of the fluid it stands in, m/s; 0: none */
    double origin[3];            /* of the lattice */
    int periodic[3];             /* bonded across, with these lengths */
    double length[3];
    int bodies;
    const struct solid_body *body; /* borrowed during the call */
    int materials;
    const struct solid_material *material;
    int constraints;
    const struct solid_constraint *constraint;
    int unbreakables;
    const struct solid_region *unbreakable;
    int loads;
    const struct solid_load *load;
    int initials;
    const struct solid_initial *initial;       /* borrowed during the call */
    const struct solid_refinement *refinement; /* of plates; NULL: none */
    double body_force[3];                      /* per unit mass, m/s2 */
    int surface_correction;                    /* volume method on (default 1) */
    int general_bonds;                         /* 1: lists of bonds even for lattice bodies (tests) */
    int contact;                               /* 1: particles that come near repel; costs nothing before they can */
    double contact_stiffness;                  /* k_c / c0, default 15 */
    double contact_exponent;                   /* n_c, default 1 */
    double contact_radius;                     /* r_c / spacing, default 1 */
    int shape_surface; /* 1: the wetted surface is the shapes' own, not the lattice's (solid/surface/shaped.h) */
};

static inline int solid_dim(const struct solid_input *in) {
    switch (in->model) {
    case SOLID_3D:
        return 3;
    case SOLID_PLANE_STRESS:
    case SOLID_PLANE_STRAIN:
        return 2;
    }
    ENSURE(0, "model %d", (int)in->model);
}
/* Depth of a plate, m; 1 in 3D: a particle's volume is spacing^dim times it. */
static inline double solid_depth(const struct solid_input *in) { return solid_dim(in) == 3 ? 1 : in->thickness; }

/* Dies (exit 2) on numbers that make no solid. Collective (all ranks alike). */
void solid_input_check(const struct solid_input *in);
/* The input with its own copies; what a body's points, outlines, cuts and initial displacements point to stays the
 * caller's, and is forgotten once the solid is made. Not collective. */
void solid_input_copy(struct solid_input *to, const struct solid_input *from);
void solid_input_free(struct solid_input *in);
