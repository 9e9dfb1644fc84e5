/* The moments of an injection into cracks, by the series. */
#pragma once
#include "postproc/data/history.h"

struct postproc_instant {
    double t, pressure; /* s, Pa; NAN: it did not come */
};
struct postproc_injection {
    long n;                                   /* rows; 0: the series has no such columns */
    double *t, *pressure, *rate;              /* [n] kept */
    struct postproc_instant first, breakdown; /* a bond broke; the largest pressure from the sample before that on,
                                               * after which it fell, of a given rate; where bonds broke since the
                                               * sample before the median of five samples counts */
    struct postproc_instant shut_in, closure; /* nothing is injected any more; the cracks have closed */
    double speed;                             /* of the tips, the largest, m/s; NAN: they have not run far */
};

/* The tips' advance is that of a crack with two tips, in space of a circular one, of the wet area; a speed is over five
 * spacings. The cracks have closed when their mean aperture is at most `least`. */
struct postproc_injection postproc_injection_new(const struct postproc_history *h, double least);
