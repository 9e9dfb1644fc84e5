/* Draws particles as lit cubes, and the edges of a box. */
#include "postproc/draw/render.h"
#include "postproc/draw/light.h"
#include "postproc/draw/voxels.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

/* One of the three orientations that the camera sees: normal n along +-axis, and the face as a parallelogram on the
 * canvas. */
struct facing {
    int axis, sign;
    double corner[3];           /* from the cube's centre: pixels and depth of the face's corner */
    double inverse[2][2];       /* pixels from that corner -> (s, t) in the unit square */
    double slope[2], extent[4]; /* depth per s, t; bounds of the parallelogram from the corner, pixels */
};

/* A face seen edge-on is not drawn. */
static int facing_new(struct facing *f, const struct postproc_camera *camera, int axis, double size) {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    if (fabs(camera->toward[axis]) < 1e-9) return 0;
    f->axis = axis;
    f->sign = camera->toward[axis] > 0 ? 1 : -1;
    double from[3] = {0, 0, 0}, edge[2][3] = {{0}};
    from[axis] = 0.5 * size * f->sign;
    from[b] = from[c] = -0.5 * size;
    edge[0][b] = edge[1][c] = size;
    double origin[3], p[3], e[2][3];
    const double zero[3] = {0, 0, 0};
    struct postproc_camera centred = *camera;
    for (int k = 0; k < 3; k++) centred.centre[k] = 0;
    postproc_camera_see(&centred, zero, origin);
    postproc_camera_see(&centred, from, p);
    for (int k = 0; k < 3; k++) f->corner[k] = p[k] - origin[k];
    for (int m = 0; m < 2; m++) {
        postproc_camera_see(&centred, edge[m], e[m]);
        for (int k = 0; k < 3; k++) e[m][k] -= origin[k];
        f->slope[m] = e[m][2];
    }
    const double det = e[0][0] * e[1][1] - e[1][0] * e[0][1];
    f->inverse[0][0] = e[1][1] / det;
    f->inverse[0][1] = -e[1][0] / det;
    f->inverse[1][0] = -e[0][1] / det;
    f->inverse[1][1] = e[0][0] / det;
    for (int k = 0; k < 2; k++) {
        f->extent[k] = fmin(0, e[0][k]) + fmin(0, e[1][k]);
        f->extent[2 + k] = fmax(0, e[0][k]) + fmax(0, e[1][k]);
    }
    return 1;
}

/* Draws the face's pixels where it is nearest. rim: width of a darker line along its edges. over: overlap beyond its
 * edges, so that no light shows between neighbours with a small gap. Both as fractions of the edge. */
static void face_draw(struct postproc_canvas *canvas, const struct facing *f, const double p[3], const float colour[3],
                      double rim, double over) {
    const int i0 = (int)fmax(0, ceil(p[0] + f->extent[0] - 1)), j0 = (int)fmax(0, ceil(p[1] + f->extent[1] - 1));
    const int i1 = (int)fmin(canvas->width - 1, floor(p[0] + f->extent[2]));
    const int j1 = (int)fmin(canvas->height - 1, floor(p[1] + f->extent[3]));
    for (int j = j0; j <= j1; j++)
        for (int i = i0; i <= i1; i++) {
            const double x = i + 0.5 - p[0], y = j + 0.5 - p[1];
            const double s = f->inverse[0][0] * x + f->inverse[0][1] * y,
                         t = f->inverse[1][0] * x + f->inverse[1][1] * y;
            if (!(s >= -over && s < 1 + over && t >= -over && t < 1 + over)) continue;
            const size_t at = (size_t)j * (size_t)canvas->width + (size_t)i;
            const float z = (float)(p[2] + s * f->slope[0] + t * f->slope[1]);
            if (z <= canvas->depth[at]) continue;
            canvas->depth[at] = z;
            const double edge = fmin(fmin(s, 1 - s), fmin(t, 1 - t));
            const float shade = edge < rim ? 0.8f : 1;
            for (size_t k = 0; k < 3; k++) canvas->rgb[3 * at + k] = shade * colour[k];
        }
}

/* Whether the face of particle i is covered by a neighbour's. */
static int face_covered(const struct postproc_voxels *v, const double (*x)[3], long i, const int cell[3],
                        const struct facing *f) {
    int q[3] = {cell[0], cell[1], cell[2]};
    q[f->axis] += f->sign;
    const int l = postproc_voxels_at(v, q[0], q[1], q[2]);
    if (l < 0) return 0;
    for (int c = 0; c < 3; c++) {
        const double lattice = c == f->axis ? f->sign * v->size : 0;
        if (fabs(x[l][c] - x[i][c] - lattice) > 0.1 * v->size) return 0;
    }
    return 1;
}

long postproc_render_cubes(struct postproc_canvas *canvas, const struct postproc_camera *camera,
                           const struct postproc_cubes *cubes, int flat) {
    struct postproc_voxels *v = postproc_voxels_new(cubes->n, cubes->x, cubes->size, cubes->low, cubes->high);
    if (!v) return 0;
    struct postproc_light *light = postproc_light_new(camera);
    /* a rim of about one pixel; none if cubes are small */
    const double pixels = camera->scale * cubes->size, rim = flat || pixels < 9 ? 0 : 1.1 / pixels;
    const double over = flat ? 0 : 0.35 / pixels;
    long drawn = 0;
    for (int axis = 0; axis < 3; axis++) {
        struct facing f;
        if (!facing_new(&f, camera, axis, cubes->size)) continue;
        for (long i = 0; i < cubes->n; i++) {
            int cell[3];
            if (!postproc_voxels_cell(v, cubes->x[i], cell) || face_covered(v, cubes->x, i, cell, &f)) continue;
            double p[3];
            postproc_camera_see(camera, cubes->x[i], p);
            for (int k = 0; k < 3; k++) p[k] += f.corner[k];
            float lit[3] = {1, 1, 1}, sheen = 0;
            if (!flat) postproc_light_face(light, v, cell, f.axis, f.sign, lit, &sheen);
            for (int k = 0; k < 3; k++) lit[k] = lit[k] * cubes->colour[i][k] + sheen;
            face_draw(canvas, &f, p, lit, rim, over);
            drawn++;
        }
    }
    postproc_light_free(light);
    postproc_voxels_free(v);
    return drawn;
}

void postproc_render_box(struct postproc_canvas *canvas, const struct postproc_camera *camera, const double low[3],
                         const double high[3], struct postproc_pen pen) {
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < 4; k++) {
            double x[2][3], p[2][3];
            for (int end = 0; end < 2; end++) {
                x[end][axis] = end ? high[axis] : low[axis];
                x[end][(axis + 1) % 3] = k & 1 ? high[(axis + 1) % 3] : low[(axis + 1) % 3];
                x[end][(axis + 2) % 3] = k & 2 ? high[(axis + 2) % 3] : low[(axis + 2) % 3];
                postproc_camera_see(camera, x[end], p[end]);
            }
            postproc_canvas_line(canvas, p[0], p[1], pen);
        }
}

long postproc_render_plane(struct postproc_canvas *canvas, const struct postproc_camera *camera,
                           const struct postproc_plane *plane, enum postproc_map map, double low, double high) {
    const int axis = plane->axis, across[2] = {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
    if (fabs(camera->toward[axis]) < 1e-9) return 0;
    long painted = 0;
    for (int j = 0; j < canvas->height; j++)
        for (int i = 0; i < canvas->width; i++) {
            const double right = (i + 0.5 - camera->cx) / camera->scale, up = (camera->cy - j - 0.5) / camera->scale;
            double x[3];
            for (int c = 0; c < 3; c++) x[c] = camera->centre[c] + right * camera->right[c] + up * camera->up[c];
            const double z = (plane->place - x[axis]) / camera->toward[axis]; /* along the line of sight */
            int cell[2], inside = 1;
            for (int c = 0; c < 2; c++) {
                const double q = (x[across[c]] + z * camera->toward[across[c]]) / plane->d[c];
                inside = inside && q >= 0 && q < plane->n[c];
                cell[c] = inside ? (int)q : 0;
            }
            const size_t at = (size_t)j * (size_t)canvas->width + (size_t)i;
            if (!inside || (float)z <= canvas->depth[at]) continue;
            const double value = plane->value[(size_t)cell[1] * (size_t)plane->n[0] + (size_t)cell[0]];
            if (isnan(value)) continue;
            double srgb[3];
            postproc_colour_map(map, (value - low) / (high - low), srgb);
            for (size_t k = 0; k < 3; k++) canvas->rgb[3 * at + k] = (float)postproc_colour_linear(srgb[k]);
            canvas->depth[at] = (float)z;
            painted++;
        }
    return painted;
}

void postproc_render_tube(struct postproc_canvas *canvas, const double a[3], const double b[3], double radius,
                          double metres, const double srgb[3]) {
    const int i0 = (int)fmax(0, floor(fmin(a[0], b[0]) - radius)), j0 = (int)fmax(0, floor(fmin(a[1], b[1]) - radius));
    const int i1 = (int)fmin(canvas->width - 1, ceil(fmax(a[0], b[0]) + radius));
    const int j1 = (int)fmin(canvas->height - 1, ceil(fmax(a[1], b[1]) + radius));
    const double ex = b[0] - a[0], ey = b[1] - a[1], ee = ex * ex + ey * ey;
    float colour[3];
    for (int k = 0; k < 3; k++) colour[k] = (float)postproc_colour_linear(srgb[k]);
    for (int j = j0; j <= j1; j++)
        for (int i = i0; i <= i1; i++) {
            const double x = i + 0.5 - a[0], y = j + 0.5 - a[1];
            const double t = ee > 0 ? fmin(fmax((x * ex + y * ey) / ee, 0), 1) : 0;
            const double off = hypot(x - t * ex, y - t * ey) / radius;
            if (!(off <= 1)) continue;
            const double bulge = sqrt(1 - off * off);
            const float z = (float)(a[2] + t * (b[2] - a[2]) + bulge * radius * metres);
            const size_t at = (size_t)j * (size_t)canvas->width + (size_t)i;
            if (z <= canvas->depth[at]) continue;
            canvas->depth[at] = z;
            for (size_t k = 0; k < 3; k++) canvas->rgb[3 * at + k] = (float)(0.45 + 0.55 * bulge) * colour[k];
        }
}
