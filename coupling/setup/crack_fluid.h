/* Translates the fluid of cracks from the scene to its input. */
#pragma once
#include "cracks/cracks.h"
#include "scene/scene.h"

/* NULL: the scene has no such fluid. Makes the cracks' fluid of the solid. Collective. */
struct cracks *setup_crack_fluid(const struct scene *scene, struct solid *s);
