/* Lighting of a face: lamp, sky light with occlusion, ambient light. */
#pragma once
#include "postproc/draw/camera.h"
#include "postproc/draw/voxels.h"

struct postproc_light; /* opaque: the lamp for this camera, and the rays */

struct postproc_light *postproc_light_new(const struct postproc_camera *camera);
void postproc_light_free(struct postproc_light *light);
/* The light on the face of `cell` towards sign * axis, linear: lit is to be multiplied by the face's colour; sheen,
 * equal for all colours, is to be added. */
void postproc_light_face(const struct postproc_light *light, const struct postproc_voxels *v, const int cell[3],
                         int axis, int sign, float lit[3], float *sheen);
