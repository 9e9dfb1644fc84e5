/* Loads, imposed and initial displacements and refinement of the scene, for the solid's input. */
#pragma once
#include "scene/scene.h"
#include "solid/state.h"

/* imposed_add: adds them to the input that setup_solid has made. imposed_free: to be called before setup_solid_free.
 * Times are borrowed from the scene. */
void imposed_add(const struct scene *scene, struct solid_input *in);
void imposed_free(struct solid_input *in);
