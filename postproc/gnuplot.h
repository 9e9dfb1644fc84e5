/* What all of gnuplot's scripts share: typeface, formats, powers of ten on axes, and how gnuplot is called. */
#pragma once
#include <stdio.h>

enum postproc_plot_status {
    POSTPROC_PLOT_DONE,
    POSTPROC_PLOT_NO_FILE,    /* the script could not be written; errno */
    POSTPROC_PLOT_NO_GNUPLOT, /* the script is written, gnuplot was not found */
    POSTPROC_PLOT_FAILED      /* gnuplot returned an error */
};
enum postproc_format { POSTPROC_PNG, POSTPROC_SVG, POSTPROC_PDF, POSTPROC_FORMATS };

/* Opens the script folder/NAME.gp. NULL: it cannot be written (errno). */
FILE *postproc_gnuplot_script_new(const char *folder, const char *name);
/* Closes the script and runs it in its folder, without a shell and without output. The first one starts gnuplot, which
 * goes on until postproc_gnuplot_end. Scripts and pictures have their names once they are whole. */
enum postproc_plot_status postproc_gnuplot_script_end(FILE *f, const char *folder, const char *name);
void postproc_gnuplot_end(void); /* every command that draws calls it at its end */
/* The title in the upper left corner, as gnuplot's label 1. */
void postproc_gnuplot_title(FILE *f, const char *title);
/* set terminal and set output NAME.png, .svg or .pdf. width, height: pixels of the PNG. The page of the PDF is as
 * large as the PNG at 96 pixels an inch. */
void postproc_gnuplot_terminal(FILE *f, enum postproc_format format, const char *name, int width, int height);
/* Draws what PNG has again as SVG and PDF; command: "replot", or another one that draws it again. */
void postproc_gnuplot_again(FILE *f, const char *name, int width, int height, const char *command);
/* A text between gnuplot's single quotes, on one line. */
void postproc_gnuplot_text(FILE *f, const char *text);
/* n of the factor 10^n that is written once beside an axis whose values reach `most`: a multiple of 3, and 0 where the
 * numbers are short without it. */
int postproc_gnuplot_power(double most);
