/* Points hashed into cells, to find those near a position, also across periodic sides. Filled many times; the arrays
 * only grow. For solid/ only. */
#pragma once

struct solid_cells {
    int n;
    const double (*x)[3]; /* [n] borrowed, m */
    double size[3];       /* of a cell, at least the search radius, m */
    int count[3];         /* cells in a period, 0: not periodic */
    int mask;
    int *head, *next; /* hash table [mask + 1], chains [n] */
    int (*cell)[3];   /* [n] */
    int head_capacity, next_capacity, cell_capacity;
};

/* Fills cells that are zero or were filled before. Not collective. */
void solid_contact_cells_fill(struct solid_cells *cells, int n, const double (*x)[3], double reach,
                              const int periodic[3], const double length[3]);
void solid_contact_cells_free(struct solid_cells *cells);
/* Indices of the points in the cells around x, each once, in found (with room for n): all nearer than `rings` times
 * reach, 1 or 2. Returns how many. */
int solid_contact_cells_near(const struct solid_cells *cells, const double x[3], int rings, int *found);
