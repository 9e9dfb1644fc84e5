/* The members of struct medium: for the files of coupling/medium only. */
#pragma once
#include "coupling/medium/kernels.h"
#include "coupling/medium/medium.h"

/* Faces of a box and of a cell that differ by less than this are the same: the input is decimal, cells are
 * fractions. */
#define MEDIUM_SNAP 1e-9

struct par_exchange;

struct medium {
    const struct fluid_grid *g; /* borrowed */
    double low[3], high[3];     /* the box within the domain, m */
    double total;               /* sum of the weights over all ranks: its volume in cells */
    double reach;               /* of the force on the fluid beyond the box's faces, cells; at least 1 */
    double along[3];            /* unit vector along which the flow is measured */
    int axis, slanted;          /* its largest component; 1: it has others */
    int first[3], last[3];      /* sections of the domain that the box holds, or has a part of, along each direction */
    int pores_only;             /* 1: the fluid in solid cells does not count */
    int whole_period[3];        /* the direction is periodic and the box is the whole domain along it */
    double *weight[3];          /* [m[c]] fraction of this rank's cell inside the box, along c */
    double *fraction;           /* [g->size] */
    double *spread;             /* [g->size] the same, spread as a force is; NULL: not asked for */
    double effective;           /* connected porosity of this solid fraction, -1: not known */
    /* work */
    double *carry;   /* [g->size] states of cells, exchanged between ranks */
    uint8_t *cell;   /* [mz+2][my+2][mx+2] values after the last flood */
    int *stack;      /* [mx my mz] */
    double *section; /* [largest of n] mean pressures along the axis */
    /* exchange of particles with the ranks that hold their cells; planned again only if a particle goes to another
     * rank */
    struct par_exchange *exchange;
    int particles, capacity, served_capacity;
    int *dest;                  /* [particles] */
    struct medium_cube *mine;   /* [particles] */
    struct medium_cube *served; /* the cubes that this rank deposits */
};

/* Index of cell i,j,k in the rimmed array. */
static inline int medium_rimmed(const struct fluid_grid *g, int i, int j, int k) {
    return ((k + 1) * (g->m[1] + 2) + j + 1) * (g->m[0] + 2) + i + 1;
}
/* 1: this rank's cells end at the end of the domain. */
static inline int medium_at_end(const struct fluid_grid *g, int c, int high) {
    return high ? g->lo[c] + g->m[c] == g->n[c] : g->lo[c] == 0;
}
/* Floods a level on all ranks from the first n cells of the stack. over [3]: also across the periodic sides of that
 * direction. Collective. */
void medium_connect_flood(struct medium *m, uint8_t level, int n, const int over[3]);

/* Sets all cells of the domain and floods the pores from the outlets. over as above. Collective. */
void medium_cut_off_flood(struct medium *m, const int outlets[3][2], const int over[3]);

/* Mean pressure at the box's front (high = 0) or back face. section is up to date; driving: the part of the gradient
 * along the axis that p does not contain, Pa/m. Not collective. */
double medium_face_pressure(const struct medium *m, const struct fluid_input *in, double driving, int high);
/* 1: some section of the domain is clear of the force beyond that face. Not collective. */
int medium_face_is_clear(const struct medium *m, int high);

struct medium_cube {
    double x[3], side; /* centre, wrapped, m */
};
