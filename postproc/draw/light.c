/* Lighting of a picture: a lamp and the sky, with shadows by ray marching through voxels. */
#include "postproc/draw/light.h"
#include "base/memory.h"
#include "postproc/draw/ray.h"

#include <math.h>

enum { SKY_RAYS = 64, LAMP_RAYS = 12, SMOOTH_RADIUS = 2 };
static const double sky_length = 28, lamp_length = 110, lamp_spread = 0.12; /* cells, cells, rad */

struct postproc_light {
    double lamp[3], fill[3]; /* unit vectors towards the lights */
    struct postproc_ray toward_lamp[LAMP_RAYS];
    struct postproc_ray sky[3][2][SKY_RAYS]; /* over the half space of each axis and sign, denser near the normal */
};

/* Van der Corput's sequence in base 2. */
static double radical_inverse(unsigned i) {
    double x = 0, f = 0.5;
    for (; i; i >>= 1, f *= 0.5) x += (i & 1) * f;
    return x;
}

static void normalise(double a[3]) {
    const double r = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    for (int k = 0; k < 3; k++) a[k] /= r;
}

struct postproc_light *postproc_light_new(const struct postproc_camera *camera) {
    struct postproc_light *light = memory_new(MEMORY_OUTPUT, 1, sizeof *light);
    for (int k = 0; k < 3; k++) {
        light->lamp[k] = -0.45 * camera->right[k] + 0.75 * camera->up[k] + 0.65 * camera->toward[k];
        light->fill[k] = 0.9 * camera->right[k] + 0.1 * camera->up[k] + 0.5 * camera->toward[k];
    }
    normalise(light->lamp);
    normalise(light->fill);
    for (int i = 0; i < LAMP_RAYS; i++) {
        const double r = lamp_spread * sqrt((i + 0.5) / LAMP_RAYS), a = 2.399963 * i; /* the golden angle */
        double d[3];
        for (int k = 0; k < 3; k++) d[k] = light->lamp[k] + r * (cos(a) * camera->right[k] + sin(a) * camera->up[k]);
        normalise(d);
        postproc_ray_cast(&light->toward_lamp[i], d, lamp_length);
    }
    for (int axis = 0; axis < 3; axis++)
        for (int side = 0; side < 2; side++)
            for (int i = 0; i < SKY_RAYS; i++) { /* Hammersley points, weighted by the cosine */
                const double u = (i + 0.5) / SKY_RAYS, a = 2 * M_PI * radical_inverse((unsigned)i), r = sqrt(u);
                double d[3];
                d[axis] = (side ? 1 : -1) * sqrt(1 - u);
                d[(axis + 1) % 3] = r * cos(a);
                d[(axis + 2) % 3] = r * sin(a);
                postproc_ray_cast(&light->sky[axis][side][i], d, sky_length);
            }
    return light;
}

void postproc_light_free(struct postproc_light *light) { memory_free(light); }

/* The direction out of the material, from the occupied cells around: smooths the steps of a cavity made of cubes. */
static void smooth_normal(const struct postproc_voxels *v, const int cell[3], double n[3]) {
    const int r = SMOOTH_RADIUS;
    n[0] = n[1] = n[2] = 0;
    for (int k = -r; k <= r; k++)
        for (int j = -r; j <= r; j++)
            for (int i = -r; i <= r; i++) {
                const int rr = i * i + j * j + k * k;
                if (rr == 0 || rr > r * r + 1 || postproc_voxels_at(v, cell[0] + i, cell[1] + j, cell[2] + k) < 0)
                    continue;
                n[0] -= i / (double)rr;
                n[1] -= j / (double)rr;
                n[2] -= k / (double)rr;
            }
    const double size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int c = 0; c < 3; c++) n[c] = size > 0.5 ? n[c] / size : 0;
}

void postproc_light_face(const struct postproc_light *light, const struct postproc_voxels *v, const int cell[3],
                         int axis, int sign, float lit[3], float *sheen) {
    int out[3] = {cell[0], cell[1], cell[2]};
    out[axis] += sign;
    double n[3];
    smooth_normal(v, cell, n);
    for (int k = 0; k < 3; k++) n[k] = 0.65 * n[k] + (k == axis ? 0.55 * sign : 0);
    normalise(n);

    double open = 0, shine = 0, lamp = 0, fill = 0;
    for (int i = 0; i < SKY_RAYS; i++) {
        const double d = postproc_ray_hit(&light->sky[axis][sign > 0][i], v, out);
        open += d < 0 ? 1 : 0.85 * d / sky_length;
    }
    open /= SKY_RAYS;
    for (int k = 0; k < 3; k++) {
        lamp += n[k] * light->lamp[k];
        fill += n[k] * light->fill[k];
    }
    if (lamp > 0) {
        for (int i = 0; i < LAMP_RAYS; i++) shine += postproc_ray_hit(&light->toward_lamp[i], v, out) < 0;
        shine *= lamp / LAMP_RAYS;
    }
    const double sky = open * (0.8 + 0.2 * n[1]);
    fill = open * fmax(fill, 0);
    /* warm lamp, cool sky */
    const double tint[3][3] = {{1.00, 0.97, 0.92}, {0.93, 0.97, 1.03}, {0.95, 0.97, 1.0}};
    for (int c = 0; c < 3; c++)
        lit[c] = (float)(0.70 * shine * tint[0][c] + 0.52 * sky * tint[1][c] + 0.14 * fill * tint[2][c] + 0.015);
    *sheen = (float)(0.026 * shine + 0.010 * sky);
}
