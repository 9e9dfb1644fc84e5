/* The arms of a plate's cracks: where they begin, fork and end, in which direction and how fast, from the damaged
 * particles and the times at which they were damaged. No direction of the lattice or of the plate is special. */
#pragma once
#include "postproc/data/crack_shape.h"

struct postproc_arms_input {
    long n;
    const double (*x)[2]; /* [n] damaged particles, m */
    const double *t;      /* [n] when they were first damaged, s; NAN: unknown */
    const char *initial;  /* [n] 1: damaged by an initial crack */
    double spacing;       /* of the coarsest particles, m */
    double fit;           /* length over which angles are fitted, m */
    double window;        /* time over which speeds are fitted, s */
    double rayleigh;      /* m/s */
};

/* The part of a crack between two of these points: its beginning, a fork, a tip. */
struct postproc_arm {
    int parent;                        /* the arm that forks into this one, -1: none */
    int alone;                         /* 1: of a crack that is not connected to an initial one */
    double begin[2], end[2];           /* m; after a fork: where undamaged particles first separate it */
    double middle[2];                  /* of the particles that `first` is fitted to, m */
    double length;                     /* m */
    struct postproc_angle first, last; /* counterclockwise from the x axis, -180 ... 180 degrees */
    double t_begin, t_end;             /* s: the tip passes the first and the last place */
    double speed, top, top_t;          /* m/s: length over time; the largest of all windows, at its middle; NAN: none */
    long windows, above;               /* windows in which the tip was followed; those faster than Rayleigh's speed */
    long jumps;                        /* times at which a new front formed ahead of the tip */
    long first_place, places;          /* of its tip's path */
};
struct postproc_place {    /* of a tip */
    double t, x[2], speed; /* s, m, m/s in the window that ends here; NAN: not resolved */
    int jumped;            /* 1: farther from the previous place than a Rayleigh wave travels */
};
struct postproc_fork {
    int arm, arms;                    /* that ends here; that begin here */
    int first;                        /* the first of these */
    double place[2], t, angle, error; /* where the lines of the outermost arms meet, m; s; between these, degrees */
};
struct postproc_arms {
    int arms, forks;
    long places;
    struct postproc_arm *arm; /* owned, as all; an arm comes after its parent */
    struct postproc_fork *fork;
    struct postproc_place *place; /* [places] by arm, in time */
};

/* Damaged particles are joined to their neighbours, and across gaps of up to two particles. Distances along these
 * joints, from the initial cracks or, in a crack without one, from where it began, order the particles into bands of
 * two spacings. The connected parts of the bands make a tree; parts of it shorter than five spacings are not counted as
 * arms. Pure.
 */
struct postproc_arms *postproc_crack_arms_of(const struct postproc_arms_input *in);
void postproc_crack_arms_free(struct postproc_arms *a);
/* The least speed that can be distinguished from rest: one spacing over the window. */
double postproc_crack_arms_grain(const struct postproc_arms_input *in);
