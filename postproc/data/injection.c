/* Finds breakdown, shut-in and closure in the series of an injection. */
#include "postproc/data/injection.h"
#include "physics/growth.h"

#include <math.h>

#define ADVANCE 5 /* spacings over which a tip's speed is measured */
/* A rate below this part of the largest is none. */
#define STILL 1e-6

static const struct postproc_instant never = {NAN, NAN};

static struct postproc_instant moment(const struct postproc_injection *in, long i) {
    return i < 0 ? never : (struct postproc_instant){in->t[i], in->pressure[i]};
}

static double speed_of(const struct postproc_history *h, const struct postproc_injection *in) {
    double *area = postproc_history_column(h, "crack_area_wet"), most = 0;
    const int plate = h->scene->dimension == 2;
    long first = 0;
    for (long i = 0; area && i < in->n; i++) {
        area[i] = plate ? 0.5 * area[i] / h->scene->solid->thickness : sqrt(area[i] / acos(-1));
        most = fmax(most, physics_growth_speed(in->t, area, i, ADVANCE * h->spacing, &first));
    }
    return most > 0 ? most : NAN;
}

/* The pressure at row i, if bonds broke since the row before the median of five rows: a crack that slips gains volume
 * at once, and the pressure of the incompressible fluid is then an impulse over the step, large for one or two rows. */
static double without_impulse(const struct postproc_injection *in, const double *broken, long i) {
    if (i < 2 || i + 2 >= in->n || broken[i] == broken[i - 1]) return in->pressure[i];
    for (long k = i - 2; k < i + 2; k++) {
        int below = 0, equal = 0;
        for (long l = i - 2; l <= i + 2; l++) {
            below += in->pressure[l] < in->pressure[k];
            equal += in->pressure[l] == in->pressure[k];
        }
        if (below <= 2 && below + equal > 2) return in->pressure[k];
    }
    return in->pressure[i + 2];
}

/* The row of the largest pressure, if the first injection has a given rate, bonds broke, and the pressure fell again.
 */
static long breakdown_of(const struct postproc_history *h, const struct postproc_injection *in, const double *broken,
                         long broke) {
    const struct scene_crack_fluid *f = h->scene->crack_fluid;
    if (broke < 0 || f->injections == 0 || f->injection[0].is_pressure) return -1;
    long most = broke - 1; /* a sudden start has an earlier peak by inertia, which breaks nothing */
    for (long i = broke; i < in->n; i++)
        if (without_impulse(in, broken, i) > without_impulse(in, broken, most)) most = i;
    return most + 1 < in->n ? most : -1;
}

struct postproc_injection postproc_injection_new(const struct postproc_history *h, double least) {
    struct postproc_injection in = {.first = never, .breakdown = never, .shut_in = never, .closure = never};
    double *broken = postproc_history_column(h, "bonds_broken"), *wide = postproc_history_column(h, "aperture_mean");
    in.t = postproc_history_column(h, "t");
    in.pressure = postproc_history_column(h, "injection_pressure");
    in.rate = postproc_history_column(h, "injection_rate");
    if (in.t && in.pressure && in.rate && broken && wide) in.n = h->series->rows;
    long broke = -1, stop = -1, closed = -1;
    double most = 0;
    for (long i = 0; i < in.n; i++) {
        most = fmax(most, in.rate[i]);
        if (broke < 0 && broken[i] > broken[0]) broke = i;
        if (in.rate[i] > STILL * most)
            stop = closed = -1;
        else if (most > 0 && stop < 0)
            stop = i;
        if (stop >= 0 && closed < 0 && wide[i] <= least) closed = i;
    }
    in.first = moment(&in, broke);
    const long peak = breakdown_of(h, &in, broken, broke);
    in.breakdown = moment(&in, peak);
    if (peak >= 0) in.breakdown.pressure = without_impulse(&in, broken, peak);
    in.shut_in = moment(&in, stop);
    in.closure = moment(&in, closed);
    in.speed = in.n > 0 ? speed_of(h, &in) : NAN;
    return in;
}
