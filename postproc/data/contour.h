/* Contours of a field on a grid, by marching squares. */
#pragma once
#include "postproc/data/grid.h"

/* Polylines with higher values to their left; a closed one ends where it began. */
struct postproc_contour {
    int lines;
    long *first;    /* [lines + 1] line k: points first[k] ... first[k + 1] - 1; owned */
    double (*x)[2]; /* m; owned */
};

/* A square of which a node has no value gets no line. In a saddle the mean of the four corners decides which corners
 * are connected. */
struct postproc_contour *postproc_contour_new(const struct postproc_grid *g, double level);
void postproc_contour_free(struct postproc_contour *c);
/* polyline,x,y. Returns 0, or -1 (errno). */
int postproc_contour_write_csv(const struct postproc_contour *c, const char *path);
/* As polylines in VTK's legacy format. Returns 0, or -1 (errno). */
int postproc_contour_write_vtk(const struct postproc_contour *c, const char *path);
