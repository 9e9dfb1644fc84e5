/* Options of frana post. */
#pragma once

enum postproc_quantity {
    POSTPROC_DAMAGE,
    POSTPROC_STRETCH,
    POSTPROC_ENERGY,
    POSTPROC_DISPLACEMENT_X,
    POSTPROC_DISPLACEMENT_Y,
    POSTPROC_FLOW, /* from here on in 3D only */
    POSTPROC_SPEED,
    POSTPROC_PRESSURE,
    POSTPROC_APERTURE, /* from here on of cracks with fluid, in plates and in 3D */
    POSTPROC_CRACK_PRESSURE,
    POSTPROC_QUANTITIES
};
enum { POSTPROC_PLATE_QUANTITIES = POSTPROC_FLOW };

struct postproc_options {
    int film;                             /* 1: a picture of each field file */
    enum postproc_quantity film_quantity; /* the quantity of these pictures */
    int film_named;                       /* 0: damage of a plate; in 3D the flow, or damage if nothing flows */
    double level;                         /* of the damage contour; 0: automatic */
    int sliced[3];      /* 1: the slice across this direction is at the place `slice`, else in the middle */
    double slice[3];    /* m */
    double magnify;     /* factor of the displacements; 0: automatic */
    const char *before; /* the run that has the state before the last stage; NULL: the run itself */
    int width;          /* of pictures of bodies and flow, pixels; 0: 1400 */
};

/* The quantity of a name; -1: unknown name. */
int postproc_options_quantity(const char *word);
const char *postproc_options_name(enum postproc_quantity quantity);
