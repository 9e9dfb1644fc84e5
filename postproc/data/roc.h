/* How well a number tells beforehand which samples become something: hits against false alarms. */
#pragma once
#include <stdint.h>

struct postproc_roc {
    long n, become;    /* samples, and those of them that become it */
    double area;       /* under the curve of hits over false alarms: the chance that one that becomes it has a larger
                        * value than one that does not; 1/2: the number says nothing */
    double threshold;  /* the least value that counts as a warning where hits less false alarms are most */
    double hits;       /* share of those that become it with a warning at this threshold */
    double false_ones; /* share of the others with a warning */
};

/* value [n], becomes [n]: 0 or 1. NaN is left out. Numbers are NAN unless some become it and some do not.
 * (Youden 1950) */
struct postproc_roc postproc_roc_new(long n, const double *value, const uint8_t *becomes);
/* Shares at a given threshold: of those that become it, and of the others, the part with value >= threshold. */
void postproc_roc_at(long n, const double *value, const uint8_t *becomes, double threshold, double *hits,
                     double *false_ones);
