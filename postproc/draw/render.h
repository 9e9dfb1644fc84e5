/* Draws particles as shaded cubes, in software: z-buffer, soft light from above left of the camera, and sky light on
 * each face. Needs no display. */
#pragma once
#include "postproc/draw/camera.h"
#include "postproc/draw/canvas.h"
#include "postproc/draw/colour.h"

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
/* Cells of a plane across an axis at a place; the plane's directions are the other two in rising order. */
struct postproc_plane {
    int axis;
    double place; /* m */
    int n[2];
    double d[2];         /* edges of a cell, m; the first begins at 0 */
    const double *value; /* [n1][n0]; NaN: the cell is not drawn; borrowed */
};
/* Paints the plane's cells where nothing is nearer. Returns the number of pixels painted; 0 for a plane seen edge-on.
 */
long postproc_render_plane(struct postproc_canvas *canvas, const struct postproc_camera *camera,
                           const struct postproc_plane *plane, enum postproc_map map, double low, double high);
/* A round rod between two points (pixels and depth), lit from the camera, where it is nearest. radius: pixels; metres:
 * depth of a pixel. */
void postproc_render_tube(struct postproc_canvas *canvas, const double a[3], const double b[3], double radius,
                          double metres, const double srgb[3]);
/* Draws the edges of a box; edges behind cubes are faint. */
void postproc_render_box(struct postproc_canvas *canvas, const struct postproc_camera *camera, const double low[3],
                         const double high[3], struct postproc_pen pen);
