/* A picture of space: the solid coloured by a quantity, lines and planes of the flow, the outline of the domain, axes,
 * scale, colour bars, title. */
#pragma once
#include "postproc/data/stream.h"
#include "postproc/draw/colour.h"
#include "postproc/draw/render.h"

struct postproc_picture {
    const char *folder, *name; /* folder/NAME.png */
    int all;                   /* 1: also .svg and .pdf */
    const char *title, *subtitle;
    double domain[3]; /* the box, from 0, m */
    double toward[3]; /* from the scene to the camera */
    int width, height;

    /* the solid */
    long n;
    const double (*x)[3]; /* [n] m */
    const double *value;  /* [n]; NULL: all of one colour, without a bar */
    const char *label;    /* of the colour bar */
    double value_low, value_high;
    enum postproc_map map;
    double size;            /* edge of a cube, m */
    double low[3], high[3]; /* cubes outside are cut away */
    double through;         /* how much of a line behind the solid is seen: 0 nothing ... 1 all */

    /* the flow */
    const struct postproc_stream *stream; /* coloured by speed; NULL: none. Wrapped into the domain */
    int planes;
    const struct postproc_plane *plane;
    const char *flow_label; /* of the colour bar of lines and planes */
    double flow_low, flow_high;
    enum postproc_map flow_map;
    double flow[3]; /* direction of the arrow; 0: no arrow */
};

/* Returns 0, or -1 when a file could not be written (errno). */
int postproc_picture_draw(const struct postproc_picture *p);
