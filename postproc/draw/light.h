/* The light on a face: a soft lamp, the sky as far as it is open, and a little from everywhere. */
#pragma once
#include "postproc/draw/camera.h"
#include "postproc/draw/voxels.h"

struct postproc_light; /* opaque: the lamp for this eye, and the rays */

struct postproc_light *postproc_light_new(const struct postproc_camera *camera);
void postproc_light_free(struct postproc_light *light);
/* On the face of `cell` towards sign * axis, linear: lit, to be multiplied by the face's colour, and the sheen that
 * every colour has, to be added. */
void postproc_light_face(const struct postproc_light *light, const struct postproc_voxels *v, const int cell[3],
                         int axis, int sign, float lit[3], float *sheen);
