/* The small scenes of a calibration as YAML that frana run takes. */
#pragma once
#include "program/calibrate/sample.h"
#include <stdio.h>

/* Not collective. */
void calibrate_scenes_write(FILE *f, const struct calibrate_scene *c);

/* Where the strip lies on the lattice: its length runs along (cos, sin), its middle is centre. */
struct calibrate_frame {
    double centre[2], cos, sin, length, height; /* spacings */
};
struct calibrate_frame calibrate_scenes_frame(const struct calibrate_scene *c);
/* How far along the strip from its left end, and across it from its middle line, a place is. */
void calibrate_scenes_local(const struct calibrate_frame *w, const double x[2], double *along, double *across);
