/* Translates the scene's kinds (side types, shapes, models, ...) to those of fluid and solid. */
#include "coupling/setup/kinds.h"
#include "base/ensure.h"

#include <string.h>

enum fluid_side_type setup_kinds_side(enum scene_side_type kind) {
    switch (kind) {
    case SCENE_PERIODIC:
        return FLUID_PERIODIC;
    case SCENE_WALL:
        return FLUID_WALL;
    case SCENE_SLIP:
        return FLUID_SLIP;
    case SCENE_INFLOW:
        return FLUID_INFLOW;
    case SCENE_OUTFLOW:
        return FLUID_OUTFLOW;
    case SCENE_PRESSURE:
        return FLUID_PRESSURE;
    case SCENE_GENERAL:
        return FLUID_GENERAL;
    }
    ENSURE(0, "side type %d of the scene", (int)kind);
}

enum fluid_profile setup_kinds_profile(enum scene_profile kind) {
    switch (kind) {
    case SCENE_UNIFORM:
        return FLUID_UNIFORM;
    case SCENE_POISEUILLE:
        return FLUID_POISEUILLE;
    case SCENE_PROFILE_FILE:
        return FLUID_PROFILE_FILE;
    }
    ENSURE(0, "profile %d of the scene", (int)kind);
}

enum fluid_condition setup_kinds_condition(enum scene_condition kind) {
    switch (kind) {
    case SCENE_DIRICHLET:
        return FLUID_DIRICHLET;
    case SCENE_NEUMANN:
        return FLUID_NEUMANN;
    }
    ENSURE(0, "condition %d of the scene", (int)kind);
}

enum fluid_projection setup_kinds_projection(enum scene_projection kind) {
    switch (kind) {
    case SCENE_EACH_STAGE:
        return FLUID_EACH_STAGE;
    case SCENE_LAST_STAGE:
        return FLUID_LAST_STAGE;
    }
    ENSURE(0, "projection %d of the scene", (int)kind);
}

enum fluid_integrator setup_kinds_fluid_integrator(enum scene_fluid_integrator kind) {
    switch (kind) {
    case SCENE_FLUID_RK3:
        return FLUID_RK3;
    case SCENE_FLUID_AB2:
        return FLUID_AB2;
    }
    ENSURE(0, "integrator %d of the scene's fluid", (int)kind);
}

enum fluid_driving_type setup_kinds_driving(enum scene_driving kind) {
    switch (kind) {
    case SCENE_DRIVING_NONE:
        return FLUID_DRIVING_NONE;
    case SCENE_DRIVING_GRADIENT:
        return FLUID_DRIVING_GRADIENT;
    case SCENE_DRIVING_BULK:
        return FLUID_DRIVING_BULK;
    }
    ENSURE(0, "driving %d of the scene", (int)kind);
}

enum solid_model setup_kinds_model(enum scene_model kind) {
    switch (kind) {
    case SCENE_3D:
        return SOLID_3D;
    case SCENE_PLANE_STRESS:
        return SOLID_PLANE_STRESS;
    case SCENE_PLANE_STRAIN:
        return SOLID_PLANE_STRAIN;
    }
    ENSURE(0, "model %d of the scene", (int)kind);
}

double setup_kinds_strength(const struct scene_material *material) {
    switch (material->breakage) {
    case SCENE_BRITTLE:
        return 0;
    case SCENE_BILINEAR:
        return material->tensile_strength;
    }
    ENSURE(0, "law of breakage %d of the scene", (int)material->breakage);
}

enum solid_micromodulus_kind setup_kinds_micromodulus(enum scene_micromodulus kind) {
    switch (kind) {
    case SCENE_CONSTANT:
        return SOLID_CONSTANT;
    case SCENE_CONICAL:
        return SOLID_CONICAL;
    case SCENE_EXPONENTIAL:
        return SOLID_EXPONENTIAL;
    }
    ENSURE(0, "micromodulus %d of the scene", (int)kind);
}

enum solid_partial setup_kinds_partial(enum scene_partial kind) {
    switch (kind) {
    case SCENE_PARTIAL_EXACT:
        return SOLID_PARTIAL_EXACT;
    case SCENE_PARTIAL_RAMP:
        return SOLID_PARTIAL_RAMP;
    case SCENE_PARTIAL_RAMP_CUT:
        return SOLID_PARTIAL_RAMP_CUT;
    }
    ENSURE(0, "partial volume %d of the scene", (int)kind);
}

enum solid_correction setup_kinds_correction(enum scene_correction kind) {
    switch (kind) {
    case SCENE_CORRECTION_NONE:
        return SOLID_CORRECTION_NONE;
    case SCENE_CORRECTION_VOLUME:
        return SOLID_CORRECTION_VOLUME;
    case SCENE_CORRECTION_ENERGY:
        return SOLID_CORRECTION_ENERGY;
    }
    ENSURE(0, "surface correction %d of the scene", (int)kind);
}

enum solid_precision setup_kinds_precision(enum scene_precision kind) {
    switch (kind) {
    case SCENE_PRECISION_DOUBLE:
        return SOLID_DOUBLE;
    case SCENE_PRECISION_MIXED:
        return SOLID_MIXED;
    }
    ENSURE(0, "precision %d of the scene", (int)kind);
}

enum solid_horizons setup_kinds_horizons(enum scene_horizons kind) {
    switch (kind) {
    case SCENE_HORIZONS_DUAL:
        return SOLID_DUAL_HORIZON;
    case SCENE_HORIZONS_ONE_SIDED:
        return SOLID_ONE_SIDED;
    }
    ENSURE(0, "horizons %d of the scene", (int)kind);
}

enum solid_depth setup_kinds_depth(enum scene_surface kind) {
    switch (kind) {
    case SCENE_SURFACE_LATTICE:
        return SOLID_DEPTH_COUNTED;
    case SCENE_SURFACE_SHAPE:
        return SOLID_DEPTH_SHAPE;
    }
    ENSURE(0, "surface %d of the scene", (int)kind);
}

enum solid_shape setup_kinds_shape(enum scene_shape kind) {
    switch (kind) {
    case SCENE_BOX:
        return SOLID_BOX;
    case SCENE_SPHERE:
        return SOLID_SPHERE;
    case SCENE_CYLINDER:
        return SOLID_CYLINDER;
    case SCENE_ELLIPSOID:
        return SOLID_ELLIPSOID;
    case SCENE_SPHERES:
        return SOLID_SPHERES;
    case SCENE_IMAGE:
        return SOLID_IMAGE;
    case SCENE_POINTS:
        return SOLID_POINTS;
    case SCENE_RECTANGLE:
    case SCENE_DISC:
    case SCENE_POLYGON:
        return SOLID_POLYGON;
    }
    ENSURE(0, "shape %d of the scene", (int)kind);
}

enum solid_load_kind setup_kinds_load(enum scene_load_kind kind) {
    switch (kind) {
    case SCENE_LOAD_REGION:
        return SOLID_LOAD_REGION;
    case SCENE_LOAD_EDGE:
        return SOLID_LOAD_EDGE;
    }
    ENSURE(0, "load %d of the scene", (int)kind);
}

enum solid_initial_shape setup_kinds_initial(enum scene_initial_shape kind) {
    switch (kind) {
    case SCENE_GAUSSIAN:
        return SOLID_GAUSSIAN;
    case SCENE_SINE:
        return SOLID_SINE;
    }
    ENSURE(0, "initial shape %d of the scene", (int)kind);
}

enum solid_integrator setup_kinds_integrator(enum scene_integrator kind) {
    switch (kind) {
    case SCENE_RK3:
        return SOLID_RK3;
    case SCENE_VERLET:
        return SOLID_VERLET;
    }
    ENSURE(0, "integrator %d of the scene", (int)kind);
}

struct solid_turn setup_kinds_turn(const struct scene_turn *turn) {
    struct solid_turn to = {.is_turned = turn->is_turned};
    memcpy(to.about, turn->about, sizeof to.about);
    memcpy(to.edge, turn->edge, sizeof to.edge);
    return to;
}
