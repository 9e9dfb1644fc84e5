/* What a scene chooses for the solid: solid computes with it, scene has the words (scene/keys/table_solid.c,
 * table_body.c). */
#pragma once

/* Gamma: the exact part of a particle's cell in the horizon, a ramp, or the ramp over the cells
 * whose centres are within the horizon, as LAMMPS has it.  (001: eq. 3.33, mended; 000: eq. 22) */
enum solid_partial { SOLID_PARTIAL_EXACT, SOLID_PARTIAL_RAMP, SOLID_PARTIAL_RAMP_CUT };

/* How bonds near a surface are stiffened, solid/bonds/correction.h. */
enum solid_correction { SOLID_CORRECTION_NONE, SOLID_CORRECTION_VOLUME, SOLID_CORRECTION_ENERGY };

/* How the force sweep over the bonds of lattice bodies of one material computes: solid/force/segment_single.h. */
enum solid_precision { SOLID_DOUBLE, SOLID_MIXED };

/* Bonds between particles of different horizons: each end contributes half (Ren et al. 2016), or each end
 * uses its own horizon (000: sec. 1.2.5). */
enum solid_horizons { SOLID_DUAL_HORIZON, SOLID_ONE_SIDED };

/* How deep an interface particle's centre is below the wetted surface: half a spacing; by the number of its neighbours
 * (solid/surface/counted.h); by the shape that its body is cut from (solid/surface/exact.h). */
enum solid_depth { SOLID_DEPTH_HALF, SOLID_DEPTH_COUNTED, SOLID_DEPTH_SHAPE };

/* The shapes whose bodies stand on the lattice, a line each:
 *     X(constant, word of a scene and of solid/geometry/shape_WORD.c, keys of a scene that it takes)
 * The enumerator, the word, and the line in the solid's table of shapes follow from it. */
#define SOLID_LATTICE_SHAPES(X)                                                                                        \
    X(BOX, box, "low high rotation")                                                                                   \
    X(SPHERE, sphere, "centre radius")                                                                                 \
    X(CYLINDER, cylinder, "centre radius length axis rotation")                                                        \
    X(ELLIPSOID, ellipsoid, "centre radii rotation")                                                                   \
    X(SPHERES, spheres, "file spheres")

#define SOLID_SHAPE_CASE(constant, word, keys) case SOLID_##constant:
#define SOLID_SHAPE_ENUMERATOR(constant, word, keys) SOLID_##constant,
enum solid_shape {
    SOLID_LATTICE_SHAPES(SOLID_SHAPE_ENUMERATOR) /* and: */
    SOLID_IMAGE,
    SOLID_POINTS,
    SOLID_POLYGON,
    SOLID_RECTANGLE, /* of a scene: polygons in the solid */
    SOLID_DISC
};
enum { SOLID_SHAPES = SOLID_POLYGON + 1 }; /* the number of those of the solid */

enum solid_load_kind { SOLID_LOAD_REGION, SOLID_LOAD_EDGE };

enum solid_initial_shape { SOLID_GAUSSIAN, SOLID_SINE };

enum solid_integrator { SOLID_RK3, SOLID_VERLET };
