/* The sparse, symmetric, positive matrix of a nonlocal operator, its rows divided over the ranks.  (004: eq. 10) */
#pragma once
#include "meshless/arrange/arrange.h"

struct par_ghost;

struct meshless_matrix_input {
    const struct meshless_points *points;
    double exponent;  /* P */
    double horizon;   /* delta, m */
    const char *free; /* [points] 1: the value is solved for */
};

/* Row i: sum over |x_j - x_i| <= delta, j not i, of V_i V_j / |x_j - x_i|^P (u_i - u_j), as CSR: the own rows of the
 * free points, numbered in the points' order by space; a column is an own row, or rows + a ghost's number. */
struct meshless_matrix {
    const struct meshless_points *points; /* borrowed */
    long rows_global, first[2];           /* unknowns of all ranks; own: first[0] ... first[1] - 1 */
    int rows, ghosts;
    long *point;      /* [rows] number of the row's point */
    long *start;      /* [rows + 1] */
    int *column;      /* [start[rows]] */
    double *value;    /* [start[rows]] off the diagonal */
    double *diagonal; /* [rows] */
    long *ghost_id;   /* [ghosts] */
    long entries;     /* of all ranks, diagonal included */
    struct par_ghost *exchange;
    /* the bonds between free points and given ones: what given values of `u` add to the right-hand side */
    long *given_start; /* [rows + 1] */
    long *given;       /* points */
    double *given_value;
};

/* Dies (exit 2) on points that coincide and on free points without a neighbour. Collective. */
struct meshless_matrix *meshless_matrix_new(const struct meshless_matrix_input *in);
void meshless_matrix_free(struct meshless_matrix *a);
/* y [rows] = A x. x [rows + ghosts]: its ghosts are written. Collective. */
void meshless_matrix_times(struct meshless_matrix *a, double *x, double *y);
double meshless_matrix_dot(const struct meshless_matrix *a, const double *x, const double *y); /* Collective. */
/* The whole matrix [rows_global][rows_global] on rank 0, by memory_new; NULL on the others. Collective. */
double *meshless_matrix_dense(const struct meshless_matrix *a);
