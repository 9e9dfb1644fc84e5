/* Streamlines: lines along a velocity field, by the classical Runge-Kutta method in arc length. */
#pragma once

/* The velocity at a place. Returns 0 where there is no fluid: a line ends there. */
typedef int (*postproc_velocity)(const void *field, const double x[3], double u[3]);

/* Line k: points first[k] ... first[k + 1] - 1. */
struct postproc_stream {
    int lines, lines_capacity;
    long *first;    /* [lines + 1]; owned, as all below */
    double (*x)[3]; /* m; not wrapped by periodic sides */
    double *speed;  /* m/s */
    long capacity;
};

struct postproc_stream_input {
    postproc_velocity at;
    const void *field;
    double step;               /* of the arc, m */
    double slowest;            /* a line ends where the speed is not above this, m/s */
    double longest;            /* of one direction of a line, m */
    void (*begin)(void *with); /* called at the seed, before each direction; NULL: nothing is */
    /* Asked for every new point of a line; a line ends where it is nonzero. NULL: nothing ends it. */
    int (*enough)(void *with, const double x[3]);
    void *with;
};

/* A line through the seed, downstream, and upstream too if `both`. Adds nothing and returns 0 if there is no flow at
 * the seed; otherwise returns the number of points added. */
long postproc_stream_add(struct postproc_stream *s, const struct postproc_stream_input *in, const double seed[3],
                         int both);
/* Mean of length over low ... high along an axis, over high - low, of the lines that cross all of it, weighted by one
 * over the time that they take; NAN if none does.  (001: eqs 2.5, 2.6) */
double postproc_stream_tortuosity(const struct postproc_stream *s, int axis, double low, double high);
/* Drops the last line. */
void postproc_stream_drop(struct postproc_stream *s);
void postproc_stream_free(struct postproc_stream *s); /* what it holds */
