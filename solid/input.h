/* The input of a solid: model, materials, bodies, initial cracks, constraints, loads.  (001: ch. 3.3; docs/scene.md)
 * In a plate (physics/model.h) all vectors have two components, and the third arrays are NULL. */
#pragma once
#include "base/ensure.h"
#include "physics/bond.h"
#include "physics/choice_solid.h"
#include <stddef.h>
#include <stdint.h>

enum { SOLID_FAMILY_MAX = 512 };        /* bonds of a particle at most */
enum { SOLID_BODY_MATERIALS_MAX = 16 }; /* materials of a body at most */

struct solid_material {
    double youngs_modulus;  /* Pa */
    double density;         /* kg/m3 */
    double fracture_energy; /* G0, J/m2; INFINITY: bonds never break */
    double horizon_ratio;   /* m = delta / spacing */
    enum physics_micromodulus micromodulus;
    double tensile_strength; /* Pa: bonds soften by the bilinear law (physics/softening.h); 0: they are brittle */
    double ratio_excess;     /* Poisson's ratio less that of bonds alone (physics/dilatation.h) */
};

/* A limit of the stretch that follows the other bonds of the step before: solid/force/sweep_limit.h. Its material has
 * an infinite fracture energy, so that no other sweep breaks its bonds. */
struct solid_limit {
    double s00, alpha;      /* s00 = 0: the material has no such limit */
    double fracture_energy; /* of a constant limit s00, J/m2: for the area of the cracks */
};

/* One closed curve of a plate's outline: a straight line or an arc from each corner to the next (and from the last to
 * the first). Borrowed. */
struct solid_outline {
    int is_hole;
    int corners;
    const double (*corner)[2]; /* m */
    const double (*centre)[2]; /* m, of the arc from the corner; used if turn is not 0 */
    const signed char *turn;   /* 0: straight, +1: arc counterclockwise, -1: clockwise */
};

/* An initial crack: in a plate a line of points, in 3D a plane quadrilateral of four corners. Bonds that it crosses are
 * broken from the start. Borrowed. */
struct solid_cut {
    int points;
    const double (*point)[3]; /* m; z is 0 in a plate */
};

/* A rotation of a box, a cylinder, an ellipsoid or a region: its point y, as its other numbers say, is at
 * about + sum_k (y - about)_k edge_k (solid/geometry/turn.h). */
struct solid_turn {
    int is_turned;     /* 0: the members below do not count */
    double about[3];   /* m */
    double edge[3][3]; /* [k] unit vector of its direction k */
};

/* A body cut from a cubic lattice whose points are at origin + (i + 1/2) spacing. What extends beyond a periodic side
 * comes in at the opposite one. */
struct solid_body {
    char name[64];
    enum solid_shape shape;
    double low[3], high[3];   /* box, bounds of an image, m */
    double centre[3], radius; /* sphere, cylinder */
    int axis;                 /* cylinder */
    double length;            /* cylinder */
    double radii[3];          /* ellipsoid, along x, y, z */
    struct solid_turn turn;   /* box, cylinder, ellipsoid */
    /* SOLID_SPHERES: spheres and ellipsoids in any number, overlapping or not; borrowed */
    long entries;
    const double (*entry)[6]; /* [entries] centre, and half the lengths along x, y and z, m */
    /* further shapes on the lattice that belong to the body, and holes in it; borrowed. Of a part only the numbers of
     * its shape and is_hole count. */
    int parts, is_hole;
    const struct solid_body *part;
    int contacts_broken; /* 1: no bond joins particles of different shapes of the body */
    /* spherical cavities on a cubic array, removed from any shape; period 0: none */
    double cavity_period, cavity_radius, cavity_centre[3];
    const struct solid_voxels *voxels; /* SOLID_IMAGE; borrowed (solid/voxels/voxels.h) */
    /* SOLID_POINTS: given particles, on no lattice; borrowed, [points] */
    long points;
    const double *point[3];      /* of a plate: x, y, NULL */
    const double *point_volume;  /* m3; in a plate the area, m2 */
    const double *point_horizon; /* m; NULL: the material's */
    long outside;                /* of these beyond the domain's sides; the first is in this line of the file */
    long outside_line;
    double outside_at[3]; /* m */
    /* SOLID_POLYGON: pieces and holes of a plate */
    int outlines;
    const struct solid_outline *outline; /* borrowed */
    /* Bodies in a cloud: each particle is moved by at most this in each direction, spacings; 0: none. The move depends
     * on the seed and on the cell or the number of the point alone. */
    double perturbation;
    int perturbation_seed;
    int material; /* of several: the first of them */
    /* SOLID_IMAGE of several materials: their number, and the material of each kind of voxel; 0: one material. They
     * have one horizon and a constant micromodulus, and are brittle (solid/bonds/materials.h). */
    int image_materials, image_material[SOLID_BODY_MATERIALS_MAX];
    double velocity[3]; /* at the start, m/s */
    /* set by solid_new */
    double least_horizon; /* m, the least of its particles */
    long on_surface;      /* lattice points on its surface; they count as inside (solid/geometry/on_surface.h) */
    double surface_gap;   /* no other lattice point is nearer to its surface, m */
};

/* A factor that varies in time: linear between points, constant before the first and after the last. n = 0: the factor
 * is 1. Borrowed. */
struct solid_time {
    int n;
    const double *t, *factor; /* [n] times, s, ascending; [n] factors */
    double origin;            /* s, the time from which t counts; INFINITY: it has not begun, the first factor holds */
};

/* Imposed motion of the particles of a region (X0 inside the box): in each direction free, or a given velocity or
 * displacement times a factor of time. During a substep a particle moves with the mean of the given velocity, so that
 * either integrator brings it to the given position at the end of the substep. */
struct solid_constraint {
    double low[3], high[3];
    int direction[3];   /* 1: imposed in this direction */
    double velocity[3]; /* m/s */
    int has_displacement;
    double displacement[3]; /* m, instead of the velocity */
    struct solid_time time;
    struct solid_turn turn; /* of the region */
};

/* A force per unit volume on the particles of a region, or per unit area of a plate's edge on the particles along a
 * part of the edge; times a factor of time. A substep uses the mean of the factor over the substep. */
struct solid_load {
    enum solid_load_kind kind;
    double low[3], high[3]; /* region (X0), m */
    double force[3];        /* region, N/m3 */
    double edge[2][2];      /* its two end points, m */
    double traction[3];     /* edge, Pa */
    int over_horizon; /* straight edge: 1: spread evenly over all particles within the horizon behind it; 0: over the
                       * outermost ones */
    struct solid_time time;
    struct solid_turn turn; /* of the region */
};

/* The displacement at the start: displacement times exp(-r^2) or sin(2 pi r), r = (x - centre)/width, with x along the
 * direction `along`; several of them add up. */
struct solid_initial {
    enum solid_initial_shape shape;
    int along;
    double centre, width, displacement[3]; /* m */
};

/* A rigid sphere, in a plate a disc, that pushes the particles inside it outward: solid/imposed/indenter.h. */
struct solid_indenter {
    double centre[3], radius; /* m, at t = 0 */
    double velocity[3];       /* m/s */
    double stiffness;         /* N/m5 */
};

/* Two bodies, not otherwise bonded, whose particles are bonded to each other. Each end brings its half of a bond's
 * stiffness, with the constants of its material, and its critical stretch follows from the interface's fracture energy.
 */
struct solid_interface {
    int body[2];
    double fracture_energy; /* J/m2 of a crack along the interface; INFINITY: its bonds never break */
};

/* Bonds with an end in the region (X0) never break. */
struct solid_region {
    double low[3], high[3];
    struct solid_turn turn;
};

/* Refinement of plates that are polygons: each level halves the spacing.  (000: ch. 2; solid/refine/refine.h) */
struct solid_refined { /* a region (X0) that is refined from the start */
    double low[3], high[3];
    int level;
    struct solid_turn turn;
};
struct solid_refinement {
    int levels;
    double energy;           /* kappa: refine if W >= kappa W_max; 0: off */
    double damage;           /* refine if the damage is above this value; 0: off */
    double low[3], high[3];  /* refine only in this box (X0), m */
    struct solid_turn turn;  /* of that box */
    int horizon_kept;        /* 1: all levels have the material's horizon; 0: scaled with the spacing */
    int interface_corrected; /* 1: the horizon of fine particles next to coarse ones is multiplied by sqrt(2)  (000: eq.
                              * 40) */
    int held_refine;         /* 1: particles with constraints and loads are refined too */
    int starts;
    const struct solid_refined *start; /* borrowed during the call */
};

struct solid_input {
    enum physics_model model; /* default PHYSICS_3D */
    double thickness;         /* of a plate, m */
    enum solid_partial partial;
    enum solid_horizons horizons;
    int cuts;
    const struct solid_cut *cut; /* borrowed during the call */
    double spacing;              /* m */
    double speed;                /* of the surrounding fluid, m/s; 0: none */
    double origin[3];            /* of the lattice */
    int periodic[3];             /* periodic directions, with these lengths */
    double length[3];
    int wall[3][2]; /* 1: particles do not pass this side, low or high, of the domain (solid/imposed/walls.h) */
    int bodies;
    const struct solid_body *body; /* borrowed during the call */
    int materials;
    const struct solid_material *material;
    const struct solid_limit *limit; /* [materials]; NULL: none has one */
    int interfaces;
    const struct solid_interface *interface;
    int indenters;
    const struct solid_indenter *indenter;
    int constraints;
    const struct solid_constraint *constraint;
    int unbreakables;
    const struct solid_region *unbreakable;
    int loads;
    const struct solid_load *load;
    int initials;
    const struct solid_initial *initial;       /* borrowed during the call */
    const struct solid_refinement *refinement; /* NULL: none; for plates only */
    double body_force[3];                      /* per unit mass, m/s2 */
    enum solid_correction surface_correction;
    enum solid_precision precision;
    int general_bonds;        /* 1: the list store for lattice bodies as well (tests) */
    int contact;              /* 1: particles without a common intact bond repel each other at short
                               * distance */
    double contact_stiffness; /* k_c / c0, default 15 */
    double contact_exponent;  /* n_c, default 1 */
    double contact_radius;    /* r_c / spacing, default 1 */
    enum solid_depth depth;   /* SOLID_DEPTH_HALF where no fluid wets the solid */
    int rigid;                /* 1: no stage computes forces; bonds only tell where the surface is */
};

static inline int solid_dim(const struct solid_input *in) {
    switch (in->model) {
    case PHYSICS_3D:
        return 3;
    case PHYSICS_PLANE_STRESS:
    case PHYSICS_PLANE_STRAIN:
        return 2;
    }
    ENSURE(0, "model %d", (int)in->model);
}
/* Depth of a plate, m; 1 in 3D. The volume of a particle is spacing^dim times the depth. */
static inline double solid_depth(const struct solid_input *in) { return solid_dim(in) == 3 ? 1 : in->thickness; }

/* Dies (exit 2) on numbers that make no solid. Collective (same input on all ranks). */
void solid_input_check(const struct solid_input *in);
/* Copies the input and its arrays. The arrays of a body's points, outlines, initial cracks and initial displacements
 * are not copied: they are borrowed until the solid is made. Not collective. */
void solid_input_copy(struct solid_input *to, const struct solid_input *from);
void solid_input_free(struct solid_input *in);
