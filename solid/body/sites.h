/* The particles of a body and the order of their numbers. Every rank holds this for the whole body during the set-up:
 * one bit per lattice site, and one number per brick of 8 x 8 x 8 sites. */
#pragma once
#include "base/par_shared.h"
#include "solid/state.h"

enum { SOLID_ROW = 8, SOLID_BRICK = 64 }; /* sites of a row; rows of a brick (solid/body/bricks.h) */

struct solid_sites {
    int is_lattice;
    long first, count; /* global ids first .. first+count-1 */
    long on_surface;   /* lattice points on the body's surface; they count as inside (solid/geometry/on_surface.h) */
    double gap;        /* no other lattice point is nearer to the surface than this, m; INFINITY: points */
    /* lattice: rows of eight sites along x. Of a body that extends beyond a periodic side all sites of the domain in
     * that direction. */
    int low[3];    /* lattice index of the corner */
    int rows[3];   /* rows along x (eight sites each), sites along y and z */
    int bricks[3]; /* bricks along x (as many as rows), y and z (eight sites each) */
    int base[3];   /* the body's lowest lattice index */
    int wrap[3];   /* sites in a period, 0: not periodic; also for the cells of a polygon */
    uint8_t *bits; /* [bricks][8 in z][8 in y] rows: bits of the row's sites that belong to the body */
    long *start;   /* [bricks] global id of the brick's first particle */
    int ordered;   /* number of bricks with a particle */
    int *order;    /* [ordered] bricks in the order of their numbers; the rows of a brick are numbered in turn */
    struct par_shared *map, *numbers; /* that hold bits, and start and order, once a node; NULL: this rank holds them */
    long tested;                      /* depths below a shape that were computed to cut the body */
    /* points, and the cells of a polygon */
    long *point; /* [count] index of the particle numbered first+i, among the body's points or solid_outline_cells' */
    int (*cell)[2]; /* polygon: [count] lattice indices, by number */
    double *area;   /* polygon: [count] area of the body in the particle's cell and in the partial cells added to it, in
                     * cells */
};

/* first: id of the body's first particle. Dies (exit 2) on an empty body. Collective (same input on all ranks). */
struct solid_sites *solid_sites_new(const struct solid_input *in, const struct solid_body *body, long first, int reach);
void solid_sites_free(struct solid_sites *sites);
/* The global id of a lattice site, also across periodic sides; -1: not in the body. Not collective. */
long solid_sites_id(const struct solid_sites *sites, const int site[3]);
/* The index along c, within the domain, of the particle at a site: what extends beyond a periodic side comes in at the
 * opposite one. wrap: sites in the period, 0: not periodic. Not collective. */
int solid_sites_in_period(const struct solid_input *in, const int wrap[3], int c, int site);
