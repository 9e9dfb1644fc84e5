/* A small built-in stroke font, so that pictures need no installed font. Printable ASCII; a few other
 * letters are replaced by ASCII ones. */
#pragma once
#include "postproc/draw/canvas.h"

/* Text with its baseline's left end at (x, y), capitals `height` pixels tall; drawn over everything. */
void postproc_font_draw(struct postproc_canvas *c, double x, double y, double height, unsigned colour,
                        const char *text);
double postproc_font_width(double height, const char *text); /* pixels */
