/* What a scene chooses for the flow: fluid computes with it, scene has the words (scene/keys/table_fluid.c). */
#pragma once

/* Conditions of one side. Each stands for a Dirichlet or Neumann condition on u, v, w and the pressure correction. */
enum fluid_side_type {
    FLUID_PERIODIC,
    FLUID_WALL,     /* no slip; may move in its plane */
    FLUID_SLIP,     /* no normal velocity, no shear */
    FLUID_INFLOW,   /* normal velocity from a profile; pressure Neumann */
    FLUID_OUTFLOW,  /* convective, mass-conserving; pressure correction Neumann */
    FLUID_PRESSURE, /* open: given pressure, velocities Neumann; pressure correction Dirichlet */
    FLUID_GENERAL,  /* each of u, v, w separately Dirichlet or Neumann with a value; pressure Neumann or Dirichlet */
};
enum { FLUID_SIDE_TYPES = FLUID_GENERAL + 1 };

enum fluid_profile { FLUID_UNIFORM, FLUID_POISEUILLE, FLUID_PROFILE_FILE };

enum fluid_condition { FLUID_DIRICHLET, FLUID_NEUMANN };

enum fluid_driving_type { FLUID_DRIVING_NONE, FLUID_DRIVING_GRADIENT, FLUID_DRIVING_BULK };

/* How a step is taken: fluid/scheme.h. */
enum fluid_integrator { FLUID_RK3, FLUID_AB2 };

/* The stages of a step after which the pressure is solved for. */
enum fluid_projection { FLUID_EACH_STAGE, FLUID_LAST_STAGE };
