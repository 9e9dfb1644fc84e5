/* Particles as shaded cubes, in software: z-buffer, soft light from above the eye's left, and the light of the sky that
 * reaches each face. Needs no display. */
#pragma once
#include "postproc/draw/camera.h"
#include "postproc/draw/canvas.h"

struct postproc_cubes {
    long n;
    const double (*x)[3];     /* [n] centres, m; borrowed */
    const float (*colour)[3]; /* [n] linear light; borrowed */
    double size;              /* edge, m */
    double low[3], high[3];   /* cubes with their centres outside are left out */
};

/* Returns the number of faces drawn. flat: colours as they are, without light (tests, masks). */
long postproc_render_cubes(struct postproc_canvas *canvas, const struct postproc_camera *camera,
                           const struct postproc_cubes *cubes, int flat);
/* The edges of a box; those behind cubes faintly. */
void postproc_render_box(struct postproc_canvas *canvas, const struct postproc_camera *camera, const double low[3],
                         const double high[3], struct postproc_pen pen);
