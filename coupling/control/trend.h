/* A value that approaches a steady one: its windows since the stage began, joined in pairs whenever there are too
 * many. */
#pragma once

/* All 0: nothing yet. */
enum { TREND_PERIODS = 32 };
struct trend {
    struct trend_period {
        double low, high, last; /* of its samples */
    } period[TREND_PERIODS];
    long periods;             /* complete ones */
    long each;                /* windows of a period; 0: as 1 */
    double now_low, now_high; /* of the period under way, the last sample before it included */
    long samples;             /* in it, that one included */
    long windows;             /* of the period under way */
    long quiet;               /* periods at whose ends, one after another, the value was steady */
};

struct trend_found {
    double spread, left; /* largest less smallest value; how far it is still from its end. NaN: not known yet */
    long windows;        /* of which the spread is */
};

/* A sample at the end of a window, or within it. Returns 1 if a period ends with it. Not collective, as all below. */
int trend_add(struct trend *t, double value, int ends);
/* Spread and what is left at the end of a period. tail: periods over which the value must be quiet, at least; it is an
 * eighth of all at least. NaN: there are not twice as many. */
struct trend_found trend_estimate(const struct trend *t, long tail);
/* Counts the end of a period at which the value was steady to a change, or was not. Returns 1 if it was for enough
 * windows. */
int trend_count(struct trend *t, const struct trend_found *found, double change);
