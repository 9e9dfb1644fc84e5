/* The pores of a scene's rigid bodies, as cells of the fluid's grid or of finer ones. */
#pragma once
#include "scene/scene.h"
#include "stokes/mask.h"

/* Why a scene's solid cannot be taken as pores and walls at rest: a sentence's end; NULL: it can. Not collective. */
const char *setup_pores_why(const struct scene *scene);
/* Whether all bodies are images: their voxels are the geometry, and their edges its own. Not collective. */
int setup_pores_are_voxels(const struct scene *scene);
/* Cells of the grid, each cut in `finer` parts along each axis. A cell is solid if its centre is in a body: of a body
 * from an image in one of its voxels, of other bodies in its shape. Collective. */
struct stokes_mask *setup_pores(const struct scene *scene, int finer);
