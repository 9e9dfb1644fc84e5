/* A field file of a plate, read back. */
#pragma once
#include "postproc/data/grid.h"
#include "postproc/data/history.h"

struct postproc_plate {
    long n;
    double time;
    long step;
    double (*x)[2];                    /* [n] initial positions, m; owned, as all below */
    double (*u)[2];                    /* [n] displacement, m */
    double *size;                      /* [n] edge of the particle's square, m */
    double *damage, *stretch, *energy; /* [n] 1, 1, J/m3; NULL for a quantity that is not in the file */
    double low[2], high[2];            /* bounds of the squares at the start, m */
};

/* The k-th file; NULL if it cannot be read or contains no particle. */
struct postproc_plate *postproc_plate_new(const struct postproc_history *h, int k);
void postproc_plate_free(struct postproc_plate *p);
/* value[i * stride] of the particles on the lattice's nodes. */
struct postproc_grid *postproc_plate_grid(const struct postproc_plate *p, const struct postproc_history *h,
                                          const double *value, int stride);
