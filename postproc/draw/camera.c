/* Parallel projection of space onto a picture. */
#include "postproc/draw/camera.h"

#include <math.h>

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const double a[3], const double b[3], double c[3]) {
    for (int k = 0; k < 3; k++) c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static void normalise(double a[3]) {
    const double r = sqrt(dot(a, a));
    for (int k = 0; k < 3; k++) a[k] /= r;
}

void postproc_camera_see(const struct postproc_camera *c, const double x[3], double pixel[3]) {
    const double r[3] = {x[0] - c->centre[0], x[1] - c->centre[1], x[2] - c->centre[2]};
    pixel[0] = c->cx + c->scale * dot(r, c->right);
    pixel[1] = c->cy - c->scale * dot(r, c->up);
    pixel[2] = dot(r, c->toward);
}

struct postproc_camera postproc_camera_new(const double toward[3], const double low[3], const double high[3],
                                           const double window[4]) {
    struct postproc_camera c = {.scale = 1};
    const double y[3] = {0, 1, 0};
    for (int k = 0; k < 3; k++) {
        c.toward[k] = toward[k];
        c.centre[k] = 0.5 * (low[k] + high[k]);
    }
    normalise(c.toward);
    cross(y, c.toward, c.right);
    normalise(c.right);
    cross(c.toward, c.right, c.up);
    double half[2] = {1e-30, 1e-30}; /* a box is projected symmetrically about its centre */
    for (int k = 0; k < 8; k++) {
        const double corner[3] = {k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]};
        double p[3];
        postproc_camera_see(&c, corner, p);
        half[0] = fmax(half[0], fabs(p[0]));
        half[1] = fmax(half[1], fabs(p[1]));
    }
    c.scale = 0.5 * fmin((window[2] - window[0]) / half[0], (window[3] - window[1]) / half[1]);
    c.cx = 0.5 * (window[0] + window[2]);
    c.cy = 0.5 * (window[1] + window[3]);
    return c;
}
