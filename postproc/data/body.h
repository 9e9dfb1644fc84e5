/* A field file of the solid, read back. */
#pragma once
#include "postproc/data/history.h"
#include <stdint.h>

struct postproc_body {
    long n;
    double time;
    long step;
    double (*x)[3];          /* [n] current positions, m; owned, as all below */
    double *displacement;    /* [n][3] m; NULL for a quantity that is not in the file */
    double *damage, *held;   /* [n] */
    double *strain, *stress; /* [n] largest principal values, 1 and Pa */
};

/* The last file not later than t, or the first; NULL if there is none. */
struct postproc_body *postproc_body_new(const struct postproc_history *h, double t);
void postproc_body_free(struct postproc_body *b);
/* The values of particles that are free to move and have at least one bond: [*m], by memory_new. value [n]. */
double *postproc_body_sample(const struct postproc_body *b, const double *value, long *m);

/* Where the solid first broke, from the earliest file with damage. */
struct postproc_onset {
    int found;
    double time;
    long particles;     /* damaged in that file */
    double x[3];        /* mean position before displacement, weighted by damage, m */
    double fraction[3]; /* the same position in the medium's box, 0 ... 1 */
    const char *where;  /* "front", "middle", "back" along x */
};
struct postproc_onset postproc_body_onset(const struct postproc_history *h);
/* The box in which the medium is measured: the scene's, or the particles' bounds within the domain. */
void postproc_body_box(const struct postproc_history *h, const struct postproc_body *b, double low[3], double high[3]);
