/* What the scene imposes on the solid as time goes on: loads, driven layers, the displacement at the start, refinement.
 */
#pragma once
#include "scene/scene.h"
#include "solid/state.h"

/* Into the input that setup_solid has made; before setup_solid_free, given_free. Times are borrowed from the scene. */
void given_add(const struct scene *scene, struct solid_input *in);
void given_free(struct solid_input *in);
