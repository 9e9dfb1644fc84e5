/* A plane of the fluid as a plot: colours of a quantity, the solid in grey, streamlines in the plane, axes in units of
 * length. Drawn by gnuplot from NAME.gp and the values in NAME.bin (float32, row by row, over the power of ten of the
 * colour bar; a cell of a small plane is several values). */
#pragma once
#include "postproc/data/slice.h"
#include "postproc/draw/colour.h"
#include "postproc/gnuplot.h"

struct postproc_slice_plot {
    const char *folder, *name;            /* folder/name.gp, .bin, .png, .svg, .pdf */
    int all;                              /* 0: only the PNG */
    const char *title, *subtitle, *label; /* label: of the colour bar */
    const struct postproc_slice *slice;
    const double *value;                 /* one of the slice's */
    const struct postproc_stream *lines; /* NULL: none */
    double low, high;                    /* of the colours */
    enum postproc_map map;
};
/* Sets a map of colours as the palette of a script, in bands of one colour each, or smooth with 0. */
void postproc_slice_palette(FILE *f, enum postproc_map map, int bands);
enum postproc_plot_status postproc_slice_draw(const struct postproc_slice_plot *p);
