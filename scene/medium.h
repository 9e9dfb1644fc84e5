/* The direction along which a scene's medium is measured, and why it cannot be. */
#pragma once
#include "scene/scene.h"

struct scene_medium {
    double along[3]; /* the direction, of any length */
    char why[240];   /* a sentence on what makes a permeability meaningless; empty: nothing that the scene tells */
};

/* The direction is coupling.medium.direction. auto: of the first pair of sides that are not periodic and drive a flow
 * through the domain; else of the driving and the body force in the periodic directions; else x. For a scene with
 * coupling and fluid. Not collective. */
void scene_medium_of(const struct scene *s, struct scene_medium *m);
/* Whether a scene asks for a permeability: it gives the direction, or a stage waits for it. Not collective. */
int scene_medium_is_wanted(const struct scene *s);
