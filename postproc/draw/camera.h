/* Orthographic camera. */
#pragma once

struct postproc_camera {
    double right[3], up[3], toward[3]; /* orthonormal; toward: from the scene to the camera */
    double centre[3];                  /* the point seen at (cx, cy), m */
    double cx, cy;                     /* pixels */
    double scale;                      /* pixels per m */
};

/* Looks from `toward` (any length), y up, so that the box fills the window x0, y0, x1, y1 (pixels, y downward). */
struct postproc_camera postproc_camera_new(const double toward[3], const double low[3], const double high[3],
                                           const double window[4]);
/* pixel[0], [1]: x, y; [2]: the depth, m, larger is nearer. */
void postproc_camera_see(const struct postproc_camera *c, const double x[3], double pixel[3]);
