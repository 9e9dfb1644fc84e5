/* Rows of a plate's lattice in the list store: eight consecutive sites along x, whose particles mostly have the same
 * family.
 *
 *       o o o o o o o o       a row; the other ends of its bonds at one offset are eight consecutive sites too
 *           \ \ \ \ \ \ \ \
 *            o o o o o o o o
 *
 * Most particles of a plate on a lattice have the same xi, stiffness and correction to the bit, only those near an edge
 * have others. As long as all of its bonds are intact, such a particle is swept with the family's constants
 * (solid/force/sweep_rows.h), and its list of bonds is not read. The numbers that it needs of other particles stand by
 * lattice site in a box over the rank's part of the plate. */
#pragma once
#include "solid/bonds/list.h"

enum { SOLID_LIST_ROW_FEWEST = 4 }; /* particles of a row; fewer are swept faster by their lists */

/* A bond of the common family. */
struct solid_list_rows_bond {
    double xi[2], inverse; /* spacings; 1/|xi|^2 */
    double stiffness;      /* as solid_list.stiffness */
    double per_length;     /* stiffness/|xi| */
    int shift;             /* in sites */
};

struct solid_list_row {
    int site;                       /* the first */
    int particle[SOLID_LIST_BLOCK]; /* numbers in the list; of a member of the row where `member` has no bit */
    uint8_t member, complete;       /* bits: has the common family; and all of its bonds are swept */
};

struct solid_list_rows {
    int family; /* number of bonds of the common family */
    struct solid_list_rows_bond *bond;
    double w, digit, eps_limit; /* of the members, and w of their neighbours (solid_list.w) */
    int sites;                  /* of the box, with room for a horizon around the members */
    int *site;                  /* [list.n + list.others] of a record; -1: in none */
    double *d[2], *v[2];        /* [sites] spacings, m/s; v is NULL before the first damped sweep */
    int rows;                   /* number of rows */
    struct solid_list_row *row; /* [rows] ascending by site */
    uint8_t *complete;          /* [list.n] 1: all of its bonds are swept with the row */
};

/* Finds the rows of a complete list, list->rows; none if its particles are on no lattice, or scattered. Not
 * collective. */
void solid_list_rows_find(struct solid_list *list, const struct solid_cloud *cloud);
void solid_list_rows_free(struct solid_list_rows *rows);
/* Copies the list's records into the box. Not collective. */
void solid_list_rows_fill(const struct solid_list *list, int damped);
/* Number of bonds that are swept without being read. */
long solid_list_rows_bonds(const struct solid_list *list);
