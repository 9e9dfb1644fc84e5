/* Options of frana post. */
#pragma once

enum postproc_quantity {
    POSTPROC_DAMAGE,
    POSTPROC_STRETCH,
    POSTPROC_ENERGY,
    POSTPROC_DISPLACEMENT_X,
    POSTPROC_DISPLACEMENT_Y,
    POSTPROC_QUANTITIES
};

struct postproc_options {
    int film;                             /* 1: a picture of each field file of a plate */
    enum postproc_quantity film_quantity; /* the quantity of these pictures */
    double level;                         /* of the damage contour; 0: automatic */
    double magnify;                       /* factor of the displacements; 0: automatic */
};

/* The quantity of a name: damage, stretch, energy, displacement_x, displacement_y; -1: unknown name. */
int postproc_options_quantity(const char *word);
const char *postproc_options_name(enum postproc_quantity quantity);
