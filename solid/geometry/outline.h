/* The plane shape of a plate: pieces and holes bounded by straight lines and circular arcs, and the particles that it
 * is divided into. Corners may run in either sense. Nothing here is collective: every rank computes the same.  (003:
 * ch. 3)
 *
 * The cells of a lattice are [i, i+1] x [j, j+1] in units of the spacing, from the origin. */
#pragma once
#include "solid/state.h"

/* 1: the outlines bound no body, and text says why in one sentence (outlines, corners and edges counted from 1, edge k
 * starts at corner k). A body may have pieces inside the holes of others; outlines may not touch. The functions below
 * need a valid body. */
int solid_outline_fault(const struct solid_outline *outline, int n, char *text, size_t size);

void solid_outline_bounds(const struct solid_outline *outline, int n, double low[2], double high[2]); /* m */
double solid_outline_area(const struct solid_outline *outline, int n);                                /* m2 */
/* 1: x is in the body, or on its boundary (solid/geometry/on_surface.h). */
int solid_outline_contains(const struct solid_outline *outline, int n, const double x[2], double spacing);
/* Area of the body inside a square with this centre and side, m2. */
double solid_outline_area_in(const struct solid_outline *outline, int n, const double centre[2], double side);
/* Length of the part of a crack that is in a plate's body or on its boundary, m. */
double solid_outline_length_inside(const struct solid_outline *outline, int n, const struct solid_cut *cut,
                                   double spacing);

/* A particle at origin + (i + 1/2, j + 1/2) spacing. */
struct solid_outline_cell {
    int i, j;
    int is_inside; /* 0: the cell contains a part of the body, but its centre is outside */
    double area;   /* area of the body, in cells */
};

struct solid_outline_cells {
    long n;
    struct solid_outline_cell *cell; /* [n] by j, then i; owned */
    int low[2], high[2];             /* smallest and largest i, j */
    long on_edge;                    /* cells with their centre on the boundary; they count as inside */
    double gap;                      /* no other centre of a cell is nearer to it, in spacings, at most 1/2 */
    long *row;                       /* [high[1] - low[1] + 2] index of the first cell of each row; owned */
};

/* There is one particle for every cell whose centre is in the body or on its boundary. The part of
 * the body in another cell is added, in equal parts, to the particles nearest to that cell's centre among its eight
 * neighbours; if there are none, the cell is a particle of its own. So particles do not overlap, not even in concave
 * corners, and their areas add up to the body's (to 1e-12 of it, if it is no thinner than a hundredth of its distance
 * from the origin). The zones of influence of 003 have neither property there: they double the cell and halve the area
 * that two of them share. Pieces of less than 1e-12 of a cell without an adjacent particle are left out. Dies if the
 * box of the body has more than 2^30 cells along a direction. */
struct solid_outline_cells *solid_outline_cells(const struct solid_outline *outline, int n, const double origin[2],
                                                double spacing);
void solid_outline_cells_free(struct solid_outline_cells *cells);
/* The number of the particle at i, j, or -1. */
long solid_outline_cells_at(const struct solid_outline_cells *cells, int i, int j);

enum { SOLID_OUTLINE_NEAR = 16 };
/* The particles nearest to the centre of cell i, j, among the cells up to `reach` rows and columns away (without the
 * cell itself); all that are equally near; on request only those with their centre in the body. Returns how many. */
int solid_outline_cells_near(const struct solid_outline_cells *cells, int i, int j, int reach, int only_inside,
                             long near[SOLID_OUTLINE_NEAR]);

/* The length of boundary of one particle. */
struct solid_outline_share {
    long cell;     /* its number in the cells */
    double length; /* m */
};

struct solid_outline_lengths {
    long n;
    struct solid_outline_share *share; /* [n] by cell; owned */
};

/* How much of the boundary between two points belongs to each particle: the length in its cell, and its part of the
 * lengths in cells without a particle, divided as the areas are. The boundary is straight from end to end (one edge or
 * several in line) or a part of one arc; if two arcs join the points, the one with the body on its left. Points are on
 * the boundary to 1e-6 of the spacing. Returns NULL, with a sentence in text, if no such boundary joins the points.
 * cells NULL: the lengths of all lattice cells, by solid_outline_key. */
static inline long solid_outline_key(int i, int j) { return (long)j * (1L << 32) + i; }
static inline int solid_outline_key_j(long key) { return (int)((key + (1L << 31)) >> 32); }
static inline int solid_outline_key_i(long key) { return (int)(key - (long)solid_outline_key_j(key) * (1L << 32)); }
struct solid_outline_lengths *solid_outline_lengths(const struct solid_outline *outline, int n, const double origin[2],
                                                    double spacing, const struct solid_outline_cells *cells,
                                                    const double from[2], const double to[2], char *text, size_t size);
void solid_outline_lengths_free(struct solid_outline_lengths *lengths);

/* If the particles are mirror images of each other about the middle of their box, in x or in y, with areas equal to
 * 1e-9 of a cell, their areas are made equal to the bit. The same for lengths (count lists) whose mirror image is in
 * one of the lists, equal to 1e-9 of the spacing. */
void solid_outline_symmetry_cells(struct solid_outline_cells *cells);
void solid_outline_symmetry_lengths(const struct solid_outline_cells *cells, double spacing,
                                    struct solid_outline_lengths *const *lengths, int count);
