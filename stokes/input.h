/* The input of a creeping-flow problem: a box of cells, each pore or solid, and what its sides are. */
#pragma once

enum stokes_side {
    STOKES_SIDE_PERIODIC, /* both sides of a pair */
    STOKES_SIDE_WALL,     /* at rest */
    STOKES_SIDE_SLIP,     /* free of shear, nothing passes */
    STOKES_SIDE_PRESSURE  /* given pressure, the velocity does not vary across; both sides of one pair */
};

struct stokes_input {
    double d[3]; /* edges of a cell, m */
    enum stokes_side side[3][2];
    int smooth;               /* 1: the cells are the stairs of a smooth solid; 0: their edges are its own
                               * (stokes/faces.h) */
    double tolerance;         /* of the permeability, relative: error of the iteration, not of the grid */
    int (*stops)(void *with); /* called once an iteration, 1: it ends there; collective. NULL: never */
    void *with;
};
