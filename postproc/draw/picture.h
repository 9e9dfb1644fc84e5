/* A picture of the solid coloured by a quantity: view, outline of the channel, colour bar, title. */
#pragma once
#include "postproc/draw/colour.h"

struct postproc_picture {
    const char *path;
    const char *title, *subtitle;
    const char *label; /* of the colour bar */
    long n;
    const double (*x)[3];         /* [n] m */
    const double *value;          /* [n] */
    double value_low, value_high; /* of the colours */
    enum postproc_map map;
    double size;            /* edge of a cube, m */
    double domain[3];       /* the channel's box, from 0, m */
    double toward[3];       /* from the solid to the camera */
    double low[3], high[3]; /* cubes outside are cut away */
    int width, height;      /* pixels */
};

/* Returns 0, or -1 when the file could not be written (errno). */
int postproc_picture_draw(const struct postproc_picture *p);
