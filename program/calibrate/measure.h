/* Numbers of a calibration from the tables of its runs. */
#pragma once
#include "program/calibrate/sample.h"

/* Effective fracture energy of a crack through a strip: slopes of straight lines through all samples with the tip in
 * the window. */
struct calibrate_measure_crack {
    int samples;       /* with the tip in the window */
    double reached;    /* the farthest place of the tip along the strip, spacings */
    double balance;    /* loss of strain and kinetic energy that was not damped, over area and G0 */
    double bonds;      /* energy of the bonds when they broke, over area and G0; with bonds that soften also theirs */
    double deflection; /* angle of its path to the cut, degrees */
};
/* Where a notch starts: mean force of both clamps over Griffith's. */
struct calibrate_measure_notch {
    double first;   /* the largest until the first bond breaks */
    double largest; /* the largest while the notch has run by less than two horizons */
};

/* Each dies with exit code 4 if a table is missing. Not collective. */
struct calibrate_measure_crack calibrate_measure_crack(const char *folder, const struct calibrate_scene *c);
double calibrate_measure_energy(const char *folder); /* strain energy at the end */
/* griffith: the force at Griffith's load. */
struct calibrate_measure_notch calibrate_measure_notch(const char *folder, const struct calibrate_scene *c,
                                                       double griffith);
/* The bar's largest stress, over E. */
double calibrate_measure_strength(const char *folder, const struct calibrate_scene *c);
