/* Points sorted into cells, to find those near a position, also across periodic sides. Filled many times; the arrays
 * only grow. For solid/ only. */
#pragma once

struct solid_cells {
    int n;
    double reach;     /* search radius, m */
    double low[3];    /* where cell 0 begins, m; 0 along a period */
    double size[3];   /* of a cell, at least reach, m */
    double period[3]; /* m, 0: not periodic */
    int count[3];     /* cells along each direction. Without a period the outermost ones hold all points beyond them */
    int *first;       /* [cells + 1] the first point of each cell, cells along x one after another */
    int *point;       /* [n] the points by cell */
    double *x[3];     /* [n + a vec] their positions, m */
    int *cell;        /* [n] work */
    int first_capacity, point_capacity, x_capacity[3], cell_capacity;
};

/* Fills cells that are zero or were filled before. Not collective. */
void solid_contact_cells_fill(struct solid_cells *cells, int n, const double (*x)[3], double reach,
                              const int periodic[3], const double length[3]);
void solid_contact_cells_free(struct solid_cells *cells);
/* Indices of the points that are nearer to x than `rings` times reach, 1 or 2, each once, in found (with room for n);
 * some that are farther by round-off may be among them. Returns how many. */
int solid_contact_cells_near(const struct solid_cells *cells, const double x[3], int rings, int *found);
