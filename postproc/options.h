/* What frana post is asked for besides the run folder. */
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
    int film;                             /* 1: a picture of every field file of a plate */
    enum postproc_quantity film_quantity; /* of what */
    double level;                         /* of the damage contour; 0: chosen */
    double magnify;                       /* of the displacements; 0: chosen */
};

/* By its name: damage, stretch, energy, displacement_x, displacement_y; -1: it is none. */
int postproc_options_quantity(const char *word);
const char *postproc_options_name(enum postproc_quantity quantity);
