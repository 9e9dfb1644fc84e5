/* Draws particles as shaded cubes, in software: z-buffer, soft light from above left of the camera, and sky light on
 * each face. Needs no display. */
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

/* Returns the number of faces drawn. flat: unchanged colours, without light (tests, masks). */
long postproc_render_cubes(struct postproc_canvas *canvas, const struct postproc_camera *camera,
                           const struct postproc_cubes *cubes, int flat);
/* Draws the edges of a box; edges behind cubes are faint. */
void postproc_render_box(struct postproc_canvas *canvas, const struct postproc_camera *camera, const double low[3],
                         const double high[3], struct postproc_pen pen);
