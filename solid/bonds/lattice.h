/* The fast store: rows of eight lattice sites along x. A rank numbers the sites of a box around its part of a body,
 * with the family's reach as margin; the neighbours of a row at one offset are then eight consecutive sites.
 *
 *      site      . . . . . . . . | h h h h h h h h | . . . . . . . .      row of h
 *      offset -2             l l | l l l l l l                            unaligned load at h - 2
 *
 * Doubles stand in boxes of those rows alone that hold a particle or a neighbour of one, in the same order. There such
 * a run is eight consecutive numbers, too; lanes of sites that no bond asks for hold something, a number of another
 * place.
 *
 * Setup order: new, wanted (then ghosts are made), link, volumes (then exchanged), weights. */
#pragma once
#include "solid/bonds/store.h"

/* An offset's numbers as the sweep wants them. */
struct solid_lattice_offset {
    double xi[3];       /* m */
    double xi2[3];      /* 2 xi */
    double inv_length2; /* 1/|xi|^2, 1/m2 */
    double elastic;     /* c0 Gamma V/(|xi| rho), 1/(m s2) / m */
    double viscous;     /* Gamma V/(|xi|^2 rho), m4/kg */
    long shift;         /* in dense index */
    double elastic_twice;
};

struct solid_segments;

struct solid_lattice {
    const struct solid_stencil *stencil; /* borrowed */
    struct solid_law law;
    int low[3], size[3]; /* dense box: lattice index of its corner, sites; whole rows along x */
    long sites;
    int rows;
    int *row_cell;      /* [rows] dense index of the row's first site */
    int *row_first;     /* [rows] local index of the row's first owned particle; the others follow */
    uint8_t *row_owned; /* [rows] which of the eight are particles owned here */
    long *row_active;   /* [rows + 1] where the row's offsets stand in active */
    uint16_t *active;   /* offsets at which some particle of the row has a bond in the unbroken family, ascending */
    uint8_t *row_bulk;  /* [rows] alpha = 1 for all the row's bonds */
    uint8_t *lambda;    /* [rows][n offsets] a bit a bond, set: intact */
    struct solid_lattice_offset *offset; /* [n offsets] */
    int *row_of;                         /* [sites/8] row, or -1 */
    int first, n;                        /* local indices first .. first+n-1 */
    int *cell;                           /* [n] dense index */
    int copies;                          /* particles and images in the box */
    int ghosts, away;                    /* of them, in this order: ghosts, images (up to away), the others */
    int *copy_at, *copy_local;           /* [copies] where it stands in the boxes; local index */
    int *local;                          /* [sites] local index, or -1: no particle that matters here */
    int *place;                      /* [sites/8] where a row stands in the boxes, or the part of it in the next row */
    long places;                     /* where the last row ends */
    double *field;                   /* the boxes that follow */
    double *d[3], *v[3];             /* [places + 8] copies for a sweep, 0 where there is no particle */
    double *f[3];                    /* [places + 8] the sweep's accelerations, m/s2 */
    double *w;                       /* [places + 8] V_h/V0, or 1 without surface correction: alpha = 2/(w_h + w_l) */
    struct solid_segments *segments; /* the sweep's own order of the bonds (solid/bonds/segments.h), made from lambda */
};

/* Where a run of up to eight sites from the cell on stands in the boxes. */
static inline long solid_lattice_place(const struct solid_lattice *lattice, long cell) {
    return lattice->place[cell / 8] + cell % 8;
}

static inline double *solid_lattice_w(const struct solid_lattice *lattice, long cell) {
    return lattice->w + solid_lattice_place(lattice, cell);
}

struct solid_lattice *solid_lattice_new(const struct solid_sites *sites, const struct solid_stencil *stencil,
                                        struct solid_law law, long from, long to, int first);
void solid_lattice_free(struct solid_lattice *lattice);
/* Ids needed here and owned elsewhere; id may be NULL. Returns how many (with repetitions). Not collective. */
long solid_lattice_wanted(const struct solid_lattice *lattice, const struct solid_sites *sites, long from, long to,
                          long *id);
void solid_lattice_link(struct solid_lattice *lattice, const struct solid_sites *sites,
                        const struct solid_numbering *numbering);
void solid_lattice_volumes(const struct solid_lattice *lattice, double *family_volume);
void solid_lattice_weights(struct solid_lattice *lattice, const double *family_volume, int surface_correction);

/* The bits of lambda with every bond intact, as solid_lattice_new made them, for one row. Not collective. */
void solid_lattice_made(const struct solid_lattice *lattice, int row, uint8_t *lambda);
/* The bond of particle h (local) at offset o is broken, on h's side alone. */
void solid_lattice_cut(struct solid_lattice *lattice, int h, int o);
/* Who writes lambda otherwise says so: of particle h (local), or of all. Not collective. */
void solid_lattice_changed(struct solid_lattice *lattice, int h);
void solid_lattice_changed_all(struct solid_lattice *lattice);
