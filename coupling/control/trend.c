/* Judges how far a value is still from its steady one. */
#include "coupling/control/trend.h"

#include <math.h>

/* The largest ratio of the spreads of two lengths of time that is used: a spread at round-off no longer falls. */
#define SLOWEST 0.99
/* A value whose change from the first sample to the last is more than this part of the spread drifts; any other only
 * varies about a mean. */
#define ON_ITS_WAY 0.8
enum { QUIET = 3 /* windows at whose ends the value must be steady */ };

/* Joins the periods in pairs. */
static void join(struct trend *t) {
    for (long k = 0; k < TREND_PERIODS / 2; k++) {
        t->period[k].low = fmin(t->period[2 * k].low, t->period[2 * k + 1].low);
        t->period[k].high = fmax(t->period[2 * k].high, t->period[2 * k + 1].high);
        t->period[k].last = t->period[2 * k + 1].last;
    }
    t->periods = TREND_PERIODS / 2;
    t->each *= 2;
}

int trend_add(struct trend *t, double value, int ends) {
    if (t->each == 0) t->each = 1;
    if (t->samples == 0) t->now_low = t->now_high = value;
    t->now_low = fmin(t->now_low, value);
    t->now_high = fmax(t->now_high, value);
    t->samples++;
    t->windows += ends;
    if (!ends || t->windows < t->each) return 0;
    if (t->periods == TREND_PERIODS) join(t);
    if (t->windows < t->each) return 0; /* half of a longer period */
    t->period[t->periods++] = (struct trend_period){t->now_low, t->now_high, value};
    t->now_low = t->now_high = value;
    t->samples = 1;
    t->windows = 0;
    return 1;
}

int trend_count(struct trend *t, const struct trend_found *found, double change) {
    t->quiet = found->spread <= change && found->left <= change ? t->quiet + 1 : 0;
    return t->quiet * t->each >= QUIET;
}

/* Some periods before the last `skipped` ones. */
struct part {
    double spread, change; /* largest less smallest value; last less first one */
};
static struct part part_of(const struct trend *t, long length, long skipped) {
    const long to = t->periods - skipped, from = to - length;
    double low = INFINITY, high = -INFINITY;
    for (long k = from; k < to; k++) {
        low = fmin(low, t->period[k].low);
        high = fmax(high, t->period[k].high);
    }
    return (struct part){high - low, from > 0 ? t->period[to - 1].last - t->period[from - 1].last : NAN};
}

static int is_on_its_way(const struct part *p) { return fabs(p->change) >= ON_ITS_WAY * p->spread; }

/* How far the value is still from its end, by the last so many periods and as many before them.
 *
 *  value
 *   |         _ _ _ _ _ _ _  end
 *   |      .  - - -  left = spread r/(1 - r)
 *   |   .     - - -
 *   | .       spread
 *   +-------+--------+----   time; r: this spread over the one before
 *
 * A value that varies about a mean, as with implicit diffusion, is as far from it as its spread. */
static double left_by(const struct trend *t, long length) {
    const struct part now = part_of(t, length, 0), before = part_of(t, length, length);
    const int goes_on = is_on_its_way(&now) && (isnan(before.change) || now.change * before.change > 0);
    const double r = now.spread < before.spread ? fmin(now.spread / before.spread, SLOWEST) : SLOWEST;
    return now.spread == 0 ? 0 : goes_on ? now.spread * r / (1 - r) : now.spread;
}

/* The largest of the estimates by all lengths of time: an oscillation at the start may hide a slow decay from one of
 * them. */
struct trend_found trend_estimate(const struct trend *t, long tail) {
    const long length = (t->periods + 7) / 8 > tail ? (t->periods + 7) / 8 : tail;
    if (t->periods < 2 * length) return (struct trend_found){NAN, NAN, 0};
    double left = 0;
    for (long k = 1; k < length; k *= 2) left = fmax(left, left_by(t, k));
    return (struct trend_found){part_of(t, length, 0).spread, fmax(left, left_by(t, length)), length * t->each};
}
