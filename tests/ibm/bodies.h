/* Bodies as markers, for tests and measurements: this rank's part of a list that is the same on all ranks. */
#pragma once
#include "base/par.h"
#include "ibm/ibm.h"
#include "physics/depth.h"

#include <math.h>
#include <stdlib.h>

struct body {
    int n;      /* markers of this rank */
    long total; /* of all ranks */
    double *x[3], *normal[3], *v[3];
    double *volume, *area; /* A_h dx; A_h */
};

static inline struct body body_new(long capacity) {
    struct body b = {0};
    for (int d = 0; d < 3; d++) {
        b.x[d] = calloc((size_t)capacity, sizeof(double));
        b.normal[d] = calloc((size_t)capacity, sizeof(double));
        b.v[d] = calloc((size_t)capacity, sizeof(double));
    }
    b.volume = calloc((size_t)capacity, sizeof(double));
    b.area = calloc((size_t)capacity, sizeof(double));
    return b;
}

static inline void body_free(struct body *b) {
    for (int d = 0; d < 3; d++) {
        free(b->x[d]);
        free(b->normal[d]);
        free(b->v[d]);
    }
    free(b->volume);
    free(b->area);
}

static inline void body_add(struct body *b, const double x[3], const double normal[3]) {
    const int i = (int)b->total++;
    for (int d = 0; d < 3; d++) b->x[d][i] = x[d], b->normal[d][i] = normal[d];
}

/* The wetted area shared evenly by the markers, and this rank's piece of the list cut out. */
static inline void body_finish(struct body *b, double area, double dx) {
    const long first = b->total * par_rank() / par_size(), end = b->total * (par_rank() + 1) / par_size();
    b->n = (int)(end - first);
    for (int i = 0; i < b->n; i++) {
        for (int d = 0; d < 3; d++) {
            b->x[d][i] = b->x[d][i + first];
            b->normal[d][i] = b->normal[d][i + first];
        }
        b->area[i] = area / (double)b->total;
        b->volume[i] = b->area[i] * dx;
    }
}

static inline double body_square(const double r[3]) { return r[0] * r[0] + r[1] * r[1] + r[2] * r[2]; }

/* Depth of the site at r from a sphere's centre, m, by the number of its neighbours inside. */
static inline double body_sphere_depth(const double r[3], double radius, double dx) {
    int present = 0;
    for (int k = -2; k <= 2; k++)
        for (int j = -2; j <= 2; j++)
            for (int i = -2; i <= 2; i++) {
                const double other[3] = {r[0] + i * dx, r[1] + j * dx, r[2] + k * dx};
                if (body_square(other) < radius * radius) present += physics_depth_weight(i * i + j * j + k * k);
            }
    return physics_depth(present) * dx;
}

enum body_depth { BODY_HALF, BODY_COUNTED, BODY_TRUE }; /* half a spacing; by the number of neighbours; as it is */

/* Outer layer of a sphere cut from the lattice lattice[] + i dx: sites within the radius that have a site outside among
 * their six neighbours; normals radial; every marker the retraction (m) inside the face that its depth gives. */
static inline struct body body_sphere_cut(const double centre[3], double radius, double dx, const double lattice[3],
                                          enum body_depth depth, double retraction) {
    static const int neighbour[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const int reach = (int)(radius / dx) + 2;
    struct body b = body_new(8L * (2 * reach + 1) * (2 * reach + 1) + 64);
    int middle[3];
    for (int d = 0; d < 3; d++) middle[d] = (int)floor((centre[d] - lattice[d]) / dx);
    for (int k = -reach; k <= reach; k++)
        for (int j = -reach; j <= reach; j++)
            for (int i = -reach; i <= reach; i++) {
                const int site[3] = {middle[0] + i, middle[1] + j, middle[2] + k};
                double r[3], outer = 0;
                for (int d = 0; d < 3; d++) r[d] = lattice[d] + site[d] * dx - centre[d];
                const double inner = body_square(r);
                if (inner >= radius * radius) continue;
                for (int n = 0; n < 6; n++) {
                    double far = 0;
                    for (int d = 0; d < 3; d++) far += pow(r[d] + neighbour[n][d] * dx, 2);
                    if (far > outer) outer = far;
                }
                if (outer < radius * radius) continue;
                const double below = depth == BODY_COUNTED ? body_sphere_depth(r, radius, dx) : 0.5 * dx;
                double x[3], normal[3];
                for (int d = 0; d < 3; d++) {
                    normal[d] = r[d] / sqrt(inner);
                    x[d] = centre[d] + r[d] + (below - retraction) * normal[d];
                }
                body_add(&b, x, normal);
            }
    body_finish(&b, 4 * M_PI * radius * radius, dx);
    return b;
}

/* The same at the sites, moved outward by shift. */
static inline struct body body_sphere_lattice(const double centre[3], double radius, double dx, const double lattice[3],
                                              double shift) {
    return body_sphere_cut(centre, radius, dx, lattice, BODY_HALF, 0.5 * dx - shift);
}

/* A body in a periodic box, in cells: two equal slabs a box, or a ball, cylinder or cavity. */
struct body_shape {
    int across[3];            /* slabs: the direction of their normal, whole numbers */
    double period, thickness; /* slabs: distance of their lower faces, and thickness */
    double offset;            /* slabs: of a lower face from the corner of the box, along the normal */
    int round[3];             /* round: the directions that count in the distance from the centre */
    double centre[3], radius; /* round */
    int inside;               /* round: 1: the material is inside the radius; -1: outside; 0: slabs */
};

/* Depth of x below the surface, > 0 in the material; the normal out of it; which of the two slabs. */
static inline double body_shape_depth(const struct body_shape *b, const double x[3], double normal[3], int *slab) {
    double along = -b->offset, r2 = 0, length2 = 0;
    for (int c = 0; c < 3; c++) {
        normal[c] = b->inside ? (b->round[c] ? x[c] - b->centre[c] : 0) : b->across[c];
        length2 += b->across[c] * b->across[c];
        r2 += normal[c] * normal[c];
    }
    for (int c = 0; c < 3; c++) {
        along += x[c] * b->across[c] / sqrt(length2);
        normal[c] *= (b->inside < 0 ? -1 : 1) / sqrt(r2);
    }
    *slab = 0;
    if (b->inside) return b->inside * (b->radius - sqrt(r2));
    const double turns = floor(along / b->period), s = along - turns * b->period;
    *slab = ((int)turns & 1) != 0;
    const int is_upper = s < b->thickness ? s > b->thickness / 2 : s < (b->thickness + b->period) / 2;
    for (int c = 0; c < 3 && !is_upper; c++) normal[c] = -normal[c];
    return s < b->thickness ? fmin(s, b->thickness - s) : -fmin(s - b->thickness, b->period - s);
}

static inline int body_shape_has(const struct body_shape *b, const double x[3]) {
    double normal[3];
    int slab;
    return body_shape_depth(b, x, normal, &slab) > 1e-9;
}

/* Outer layer of the lattice's sites in the shape, in a box of n[] cells of size 1; a marker is `retraction` inside the
 * face that its depth gives. On slabs v is +speed and -speed along `way`. area: of the whole surface. */
static inline struct body body_cut(const struct body_shape *shape, const int n[3], const double lattice[3],
                                   enum body_depth depth, double retraction, double area, const double way[3]) {
    struct body b = body_new((long)n[0] * n[1] * n[2]);
    for (int site = 0; site < n[0] * n[1] * n[2]; site++) {
        double x[3] = {site % n[0] + lattice[0], site / n[0] % n[1] + lattice[1], site / n[0] / n[1] + lattice[2]};
        double normal[3];
        int slab, is_outer = 0, present = 0;
        double below = body_shape_depth(shape, x, normal, &slab);
        if (!(below > 1e-9)) continue;
        for (int k = -2; k <= 2; k++)
            for (int j = -2; j <= 2; j++)
                for (int i = -2; i <= 2; i++) {
                    const double other[3] = {x[0] + i, x[1] + j, x[2] + k};
                    const int has = body_shape_has(shape, other), r2 = i * i + j * j + k * k;
                    if (has) present += physics_depth_weight(r2);
                    is_outer |= !has && r2 == 1;
                }
        if (!is_outer) continue;
        if (depth != BODY_TRUE) below = depth == BODY_HALF ? 0.5 : physics_depth(present);
        for (int c = 0; c < 3; c++) {
            x[c] += (below - retraction) * normal[c];
            b.v[c][b.total] = way ? (slab ? -1 : 1) * way[c] : 0;
        }
        body_add(&b, x, normal);
    }
    const long first = b.total * par_rank() / par_size();
    body_finish(&b, area, 1);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < b.n; i++) b.v[c][i] = b.v[c][i + first];
    return b;
}

/* The same sphere with evenly spread markers (a spiral of equal areas), about one per dx^2, at the depth r_d dx. */
static inline struct body body_sphere_even(const double centre[3], double radius, double dx, double depth) {
    const double area = 4 * M_PI * radius * radius;
    const int n = (int)(area / (dx * dx) + 0.5);
    struct body b = body_new(n);
    for (int i = 0; i < n; i++) {
        const double z = 1 - (2 * i + 1.0) / n, s = sqrt(1 - z * z), turn = M_PI * (3 - sqrt(5)) * i;
        const double normal[3] = {s * cos(turn), s * sin(turn), z};
        double x[3];
        for (int d = 0; d < 3; d++) x[d] = centre[d] + (radius - depth) * normal[d];
        body_add(&b, x, normal);
    }
    body_finish(&b, area, dx);
    return b;
}

static inline void body_send(struct ibm *ibm, const struct body *b) {
    ibm_markers_set(ibm, b->n, (const double *const *)b->x, (const double *const *)b->v, b->volume);
}
