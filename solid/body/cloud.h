/* The particles of a body that is not in the lattice store (solid/bonds/lattice.h): plates, points, refined bodies.
 * Every rank holds all of them. Lengths are in spacings of the lattice, from an origin of the body's own. Every
 * position is a multiple of 2^-20 spacing: differences are exact, and a mirror-symmetric body is so to the bit wherever
 * the coordinates' origin is. Numbers follow halves of the body (solid/geometry/bisect.h); number i has the global id
 * first + i. */
#pragma once
#include "solid/law/pair.h"

struct solid_sites;

/* Particles sorted into cells. */
struct solid_cloud_cells {
    double low[3], width; /* spacings */
    int cells[3];
    long *start; /* [cells + 2] */
    long *item;  /* [n] numbers by cell, ascending within a cell */
};

struct solid_cloud {
    int dim;
    long n, first;
    double spacing;       /* m */
    double origin[3];     /* m */
    double period[3];     /* spacings, 0: not periodic */
    double unit;          /* volume unit, m3 per spacings^dim: spacing^3, or spacing^2 thickness */
    double *place[3];     /* [n] position, third NULL in a plate */
    double *size;         /* [n] side of the particle's cell: 1, 1/2, 1/4 ..., or volume^(1/dim) */
    double *volume;       /* [n] spacings^dim */
    double *horizon;      /* [n] delta */
    double longest_reach; /* upper bound of a bond's length */
    struct solid_bond_law law;
    struct solid_cloud_cells cells;
    char name[64]; /* name of the body */
};

struct solid_cloud_input {
    const char *name;
    long n, first;
    double spacing, thickness; /* m; thickness of a plate */
    double origin[3];          /* m */
    double period[3];          /* m, 0: not periodic */
    const double *place[3];    /* [n] positions in spacings from origin, in the order of the numbering; rounded to
                                * 2^-20 */
    const double *size;        /* [n], or NULL: volume^(1/dim) */
    const double *volume;      /* [n] spacings^dim */
    const double *horizon;     /* [n] spacings, or NULL: that of the law */
    struct solid_bond_law law; /* law.dim is the dimension */
};

/* Copies the input. Dies (exit 2) on a particle without volume. Collective (same input on all ranks). */
struct solid_cloud *solid_cloud_new(const struct solid_cloud_input *in);
/* The cloud of a body of points; that of a body of lattice sites. Numbered as in sites. Collective (same input on all
 * ranks). */
struct solid_cloud *solid_cloud_points(const struct solid_input *in, const struct solid_body *body,
                                       const struct solid_sites *sites);
struct solid_cloud *solid_cloud_lattice(const struct solid_input *in, const struct solid_body *body,
                                        const struct solid_sites *sites);
void solid_cloud_free(struct solid_cloud *cloud);

/* X0 of a particle in direction c, m. */
static inline double solid_cloud_x(const struct solid_cloud *cloud, int c, long i) {
    return cloud->origin[c] + cloud->place[c][i] * cloud->spacing;
}

static inline struct solid_end solid_cloud_end(const struct solid_cloud *cloud, long i) {
    return (struct solid_end){cloud->size[i], cloud->horizon[i], cloud->volume[i]};
}

/* The family of a particle: all particles it has bonds with, ordered by xi: z, then y, then x. */
struct solid_cloud_near {
    int n;
    long number[SOLID_FAMILY_MAX];
    int image[SOLID_FAMILY_MAX];    /* see solid_cloud_image_of */
    double xi[SOLID_FAMILY_MAX][3]; /* X0_l - X0_h, spacings; the third 0 in a plate */
};

/* 1: a particle, or an image of one, is at x, m, to the precision of positions. Not collective. */
int solid_cloud_near_holds(const struct solid_cloud *cloud, const double x[3]);
/* Dies (exit 2) when there are more than SOLID_FAMILY_MAX or two particles coincide. Not collective. */
void solid_cloud_near_find(const struct solid_cloud *cloud, long i, struct solid_cloud_near *near);
/* Their number only, which is faster. */
int solid_cloud_near_count(const struct solid_cloud *cloud, long i);
/* Calls for every particle within reach of a position, given in spacings from the origin; xi: vector from the position
 * to the particle. Not collective. */
typedef void solid_cloud_visitor(void *with, long number, int image, const double xi[3]);
void solid_cloud_near_visit(const struct solid_cloud *cloud, const double place[3], double reach,
                            solid_cloud_visitor *visit, void *with);

/* Periodic images: -1, 0 or 1 periods in each direction. */
enum { SOLID_IMAGES = 27, SOLID_NO_IMAGE = 13 };
static inline int solid_cloud_image_code(const int image[3]) {
    return SOLID_NO_IMAGE + image[0] + 3 * image[1] + 9 * image[2];
}
static inline int solid_cloud_image_of(int code, int c) {
    static const int power[3] = {1, 3, 9};
    return code / power[c] % 3 - 1;
}
