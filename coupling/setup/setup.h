/* From the scene to the inputs of the rooms. */
#pragma once
#include "fluid/fluid.h"
#include "scene/scene.h"
#include "solid/state.h"

/* Dies (exit 2) on a plate whose outlines bound no body, and on cracks outside; makes nothing. */
void setup_check(const struct scene *scene);
void setup_fluid(const struct scene *scene, struct fluid_input *in);
/* The input with the bodies' and materials' arrays behind it, without what is imposed in time (coupling/setup/given.h);
 * free with setup_solid_free once the solid is made. Collective: rank 0 reads point files. */
struct solid_input *setup_solid(const struct scene *scene);
void setup_solid_free(struct solid_input *in);
void setup_stage(const struct scene_stage *from, struct solid_stage *to);

/* Which parts a scene needs, from its sections and stages alone. */
struct setup_needs {
    int fluid, solid; /* sections present */
    int bonds;        /* some stage has an elastic solid */
    int immersed;     /* both */
    int breakage;     /* some stage lets bonds break, and some material can */
    int contact;      /* particles that no bond joins may meet */
};
struct setup_needs setup_needs_of(const struct scene *scene);
