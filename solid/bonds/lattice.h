/* The lattice store of bonds: rows of eight lattice sites along x. A rank numbers the sites of a box around its part of
 * a body (the dense box), with the family's reach as margin; the neighbours of a row at one offset are then eight
 * consecutive sites.
 *
 *      site      . . . . . . . . | h h h h h h h h | . . . . . . . .      row of h
 *      offset -2             l l | l l l l l l                            unaligned load at h - 2
 *
 * The field arrays (doubles) contain only the rows that hold a particle or a neighbour of one, in the same order. Eight
 * consecutive sites are eight consecutive numbers there as well; lanes without a bond may hold any finite number, of
 * another site.
 *
 * Order of the set-up: new, wanted (then the ghosts are made), link, volumes (then these are exchanged), weights. */
#pragma once
#include "solid/bonds/store.h"

/* Constants of an offset, in the form that the sweep needs. */
struct solid_lattice_offset {
    double xi[3];       /* m */
    double xi2[3];      /* 2 xi */
    double inv_length2; /* 1/|xi|^2, 1/m2 */
    double elastic;     /* c0 Gamma V/(|xi| rho), 1/(m s2) / m */
    double viscous;     /* Gamma V/(|xi|^2 rho), m4/kg */
    long shift;         /* difference of dense indices */
    double elastic_twice;
    double length2; /* |xi|^2, m2 */
};

/* The same in single, as a sweep in mixed precision needs them. */
struct solid_lattice_offset_single {
    float xi[3], xi2[3], inv_length2, elastic, viscous, elastic_twice, length2;
};

struct solid_materials;
struct solid_segments;

struct solid_lattice {
    const struct solid_stencil *stencil; /* borrowed */
    struct solid_law law;                /* of several materials: of the first one */
    struct solid_materials *materials; /* several materials (solid/bonds/materials.h), once they are known; NULL: one */
    int low[3], size[3];               /* dense box: lattice index of its corner, number of sites; whole rows along x */
    long sites;
    int rows;
    int *row_cell;         /* [rows] dense index of the row's first site */
    int *row_first;        /* [rows] local index of the row's first owned particle; the others follow */
    uint8_t *row_owned;    /* [rows] bits of the row's sites that are particles owned here */
    long *row_active;      /* [rows + 1] first index of the row's offsets in active */
    uint16_t *active;      /* offsets at which some particle of the row has a bond in its unbroken family, ascending */
    uint8_t *row_bulk;     /* [rows] alpha = 1 for all the row's bonds */
    uint8_t *lambda;       /* [rows][n offsets] one bit for each bond, 1: intact */
    unsigned *row_version; /* [rows] counts the changes of the row's lambda and soft */
    uint8_t *soft;         /* the same, 1: swept as a softening bond (solid/bonds/soft.h); NULL: brittle */
    int is_whole;          /* 1: soft is disregarded (solid/step/rates.c) */
    struct solid_lattice_offset *offset; /* [n offsets] */
    int *row_of;                         /* [sites/8] row, or -1 */
    int first, n;                        /* local indices first .. first+n-1 */
    int *cell;                           /* [n] dense index */
    int copies;                          /* number of copies in the box: owned particles, ghosts, images */
    int ghosts, away;                    /* the copies' order: ghosts, images (up to away), owned particles */
    int *copy_at, *copy_local;           /* [copies] index in the field arrays; local index */
    int *local;                          /* [sites] local index, or -1: no particle, or none that is needed here */
    int *place;          /* [sites/8] index of a row in the field arrays, or of the part of it that the next
                          * row continues */
    long places;         /* index of the end of the last row */
    double *field;       /* memory of the arrays below */
    double *d[3], *v[3]; /* [places + 8] copies for a sweep, 0 at sites without a particle; NULL: rigid */
    double *f[3];        /* [places + 8] the sweep's accelerations, m/s2; NULL: rigid */
    double *w;           /* [places + 8] surface correction: alpha = 2/(w_h + w_l) */
    /* [places + 8] in mixed precision: d rounded, and what f, v and w are else; f and v are NULL. NULL: double */
    float *d_single[3], *f_single[3], *v_single[3], *w_single;
    double *pressure;       /* [places + 8] of the families' dilatation (solid/force/dilatation.h); NULL: bonds alone */
    float *pressure_single; /* the same in mixed precision; pressure is NULL then */
    int is_near; /* mixed precision: d_single is good enough in this sweep (solid/force/segment_single.h); d is old */
    struct solid_segments *segments; /* order of the bonds in the sweep (solid/bonds/segments.h), of lambda; NULL:
                                      * rigid */
};

/* The index in the field arrays of eight sites that begin at the cell. */
static inline long solid_lattice_place(const struct solid_lattice *lattice, long cell) {
    return lattice->place[cell / 8] + cell % 8;
}

static inline double *solid_lattice_w(const struct solid_lattice *lattice, long cell) {
    return lattice->w + solid_lattice_place(lattice, cell);
}

/* rigid: the bonds are never swept. single: they are in mixed precision (solid/force/segment_single.h). Not
 * collective. */
struct solid_lattice *solid_lattice_new(const struct solid_sites *sites, const struct solid_stencil *stencil,
                                        struct solid_law law, long from, long to, int first, int rigid, int single);
void solid_lattice_free(struct solid_lattice *lattice);
/* The ids needed here and owned by other ranks; id may be NULL. Returns how many (with repetitions). Not collective. */
long solid_lattice_wanted(const struct solid_lattice *lattice, const struct solid_sites *sites, long from, long to,
                          long *id);
void solid_lattice_link(struct solid_lattice *lattice, const struct solid_sites *sites,
                        const struct solid_numbering *numbering);
/* V_h of the owned particles, m3.  (001: eq. 3.44) */
void solid_lattice_volumes(const struct solid_lattice *lattice, double *family_volume);
/* Sets w, by local index, from which alpha follows (solid/bonds/correction.h).  (001: eq. 3.43, mended) */
void solid_lattice_weights(struct solid_lattice *lattice, const double *w);

/* The array of the families' pressure; and its values, by local index, at the copies from .. to-1. */
void solid_lattice_pressure_new(struct solid_lattice *lattice);
void solid_lattice_pressure_set(const struct solid_lattice *lattice, int from, int to, const double *pressure);

/* The bits of lambda of one row with every bond intact, as in solid_lattice_new. Not collective. */
void solid_lattice_initial_bonds(const struct solid_lattice *lattice, int row, uint8_t *lambda);
/* Breaks the bond of particle h (local) at offset o, on h's side only. */
void solid_lattice_cut(struct solid_lattice *lattice, int h, int o);
/* Marks the bond as softening, or as elastic again, on h's side only. */
void solid_lattice_soften(struct solid_lattice *lattice, int h, int o, int softens);
/* To be called after lambda was written by other code: for particle h (local), or for all. Not collective. */
void solid_lattice_changed(struct solid_lattice *lattice, int h);
void solid_lattice_changed_all(struct solid_lattice *lattice);
