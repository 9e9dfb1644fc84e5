/* Reduces a sampled curve within a time window to its last, first, largest, least or mean value, or a time. */
#include "program/study/runs/window.h"
#include "base/ensure.h"

#include <math.h>

double study_window(const struct study_samples *s, enum study_at at, double after, double before, double above) {
    double first = NAN, last = NAN, most = NAN, least = NAN, time = NAN, peak = NAN, area = 0, length = 0, t_last = NAN;
    for (long i = 0; i < s->n; i++) {
        const double t = s->t[i * s->stride], x = s->x[i * s->stride];
        if (isnan(x) || !(t >= after && t <= before)) continue;
        if (!isnan(t_last)) {
            area += 0.5 * (last + x) * (t - t_last);
            length += t - t_last;
        }
        if (isnan(time) && x > above) time = t;
        if (!(x <= most)) peak = t;
        most = fmax(most, x); /* fmax ignores NAN */
        least = fmin(least, x);
        if (isnan(last)) first = x;
        last = x;
        t_last = t;
    }
    switch (at) {
    case STUDY_MAX:
        return most;
    case STUDY_MIN:
        return least;
    case STUDY_MEAN:
        return length > 0 ? area / length : last;
    case STUDY_TIME:
        return time;
    case STUDY_TIME_MAX:
        return peak;
    case STUDY_FIRST:
        return first;
    case STUDY_LAST:
        return last;
    }
    ENSURE(0, "a curve's value at %d", (int)at);
}
