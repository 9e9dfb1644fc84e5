/* Translates the scene into the inputs of fluid and solid. */
#pragma once
#include "fluid/fluid.h"
#include "scene/scene.h"
#include "solid/state.h"

/* Dies (exit 2) on a plate whose outlines bound no body, and on cracks outside; creates nothing. */
void setup_check(const struct scene *scene);
/* Whether the fluid's cells are cubes, which a solid in a flow that is stepped needs. */
int setup_check_are_cubes(const struct scene *scene);
void setup_fluid(const struct scene *scene, struct fluid_input *in);
/* The solid's input with the arrays of its bodies and materials, without loads and imposed displacements
 * (coupling/setup/imposed.h). To be freed by setup_solid_free once the solid is made. Collective: rank 0 reads point
 * files. */
struct solid_input *setup_solid(const struct scene *scene);
void setup_solid_free(struct solid_input *in);
void setup_stage(const struct scene_stage *from, struct solid_stage *to);

/* The parts that a scene needs, from its sections and stages only. */
struct setup_needs {
    int fluid, solid; /* sections present */
    int bonds;        /* some stage has an elastic solid */
    int immersed;     /* both */
    int breakage;     /* 1: some stage lets bonds break, and some material can break */
    int contact;      /* 1: particles without a common bond may meet */
};
struct setup_needs setup_needs_of(const struct scene *scene);
