/* A picture of a plate: its particles as squares of their own size at their present positions, with contours over
 * them. */
#pragma once
#include "postproc/data/contour.h"
#include "postproc/data/plate.h"
#include "postproc/draw/colour.h"

struct postproc_plate_picture {
    const char *folder, *name; /* folder/NAME.png */
    int all;                   /* 1: also .svg and .pdf */
    const char *title, *subtitle;
    const char *label; /* of the colour bar */
    const struct postproc_plate *plate;
    const double *value; /* value[i * stride] is particle i's; NAN: light grey */
    int stride;
    double value_low, value_high; /* of the colours */
    enum postproc_map map;
    int along;      /* 0: the picture shows x and y, 1: x and z, 2: y and z */
    double magnify; /* factor of the displacements in the picture */
    /* NULL: none; with the displacement on a grid, which moves the contour */
    const struct postproc_contour *contour;
    const struct postproc_grid *displacement[2];
    int width, height; /* pixels */
};

/* Returns 0, or -1 when the file could not be written (errno). */
int postproc_plate_picture_draw(const struct postproc_plate_picture *p);
/* A round factor (1, 2, 5, 10 ...) that shows displacements as up to 3 % of the plate's larger side. The largest 1 % of
 * the displacements is ignored. */
double postproc_plate_picture_magnify(const struct postproc_plate *plate);
