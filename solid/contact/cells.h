/* Points hashed by cells, to find those near a place; periodic where the box is. Filled again and again, its arrays
 * only grow. Inside the room only. */
#pragma once

struct solid_cells {
    int n;
    const double (*x)[3]; /* [n] borrowed, m */
    double size[3];       /* of a cell, at least the reach asked for, m */
    int count[3];         /* cells in a period, 0: not periodic */
    int mask;
    int *head, *next; /* hash table [mask + 1], chains [n] */
    int (*cell)[3];   /* [n] */
    int head_capacity, next_capacity, cell_capacity;
};

/* Into cells that were zero or filled before. Not collective. */
void solid_contact_cells_fill(struct solid_cells *cells, int n, const double (*x)[3], double reach,
                              const int periodic[3], const double length[3]);
void solid_contact_cells_free(struct solid_cells *cells);
/* Indices of points in the cells about x, each once, into found (room for n); returns how many. */
int solid_contact_cells_near(const struct solid_cells *cells, const double x[3], int *found);
