/* A field file of the solid, read back. */
#pragma once
#include "postproc/data/history.h"
#include <stdint.h>

/* Numbers of the particles whose distributions are drawn: the largest principal strain; the principal stresses; von
 * Mises' stress; the tension that is as near to fracture by Griffith's criterion (physics/griffith.h). */
enum postproc_measure {
    POSTPROC_STRAIN,
    POSTPROC_STRESS,
    POSTPROC_STRESS_MIDDLE,
    POSTPROC_STRESS_LEAST,
    POSTPROC_VON_MISES,
    POSTPROC_GRIFFITH
};
enum { POSTPROC_MEASURES = POSTPROC_GRIFFITH + 1 };
struct postproc_body_kind {
    const char *name, *unit, *title, *at_end,
        *xlabel;              /* name: of the plot and of NAME.csv; title at the end of a run */
    const char *mark, *label; /* name of the threshold, in the report and in a plot; NULL: it has none */
    int is_strain, is_least;  /* is_least: its extreme is the smallest value */
};
extern const struct postproc_body_kind postproc_body_kind[POSTPROC_MEASURES];
/* Threshold in a run: s0 or sigma0 = E s0; NAN without one. */
double postproc_body_threshold(enum postproc_measure kind, const struct postproc_history *h);

struct postproc_body {
    long n;
    double time;
    long step;
    double (*x)[3];                     /* [n] current positions, m; owned, as all below */
    double *displacement;               /* [n][3] m; NULL for a quantity that is not in the file */
    double *damage, *held;              /* [n] */
    double *measure[POSTPROC_MEASURES]; /* [n] */
};

/* The last file not later than t, or the first; NULL if there is none. */
struct postproc_body *postproc_body_new(const struct postproc_history *h, double t);
/* The solid at the origin of time: the last file of the run, or of the earlier run, that is not later; NULL if all of
 * them are later, as in a run that was resumed there and whose earlier run was not named. */
struct postproc_body *postproc_body_before(const struct postproc_history *h);
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
    double third[3][3]; /* [axis][low, middle, high]: shares of the damage in the thirds of that box */
    const char *where;  /* "front", "middle", "back" along the axis of the stream */
};
struct postproc_onset postproc_body_onset(const struct postproc_history *h);
/* The box in which the medium is measured: the scene's, or the particles' bounds within the domain. */
void postproc_body_box(const struct postproc_history *h, const struct postproc_body *b, double low[3], double high[3]);
