/* Pressure along the axis of the stream, by sections across it. */
#pragma once
#include "postproc/data/history.h"

struct postproc_profile {
    int n;
    double time;
    double *x;        /* [n] place along the axis, m; kept, as all below */
    double *pressure; /* [n] mean over the section, Pa */
    double *fluid;    /* [n] mean over the section's fluid, Pa; NULL without solid_fraction */
    double *porosity; /* [n] of the section; NULL without solid_fraction */
};

/* From the last fluid file not later than t, or the first. Empty (n = 0) if there is none. */
struct postproc_profile postproc_profile_new(const struct postproc_history *h, double t);
/* Means of the sections across an axis of an image [nz][ny][nx]; without solid (NULL), fluid and porosity are not
 * written. */
void postproc_profile_means(const int n[3], int axis, const double *pressure, const double *solid, double *mean,
                            double *fluid, double *porosity);
