/* Hits and false alarms of a number as a warning, at every threshold. */
#include "postproc/data/roc.h"
#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

struct sample {
    double value;
    int becomes;
};

static int largest_first(const void *a, const void *b) {
    const double p = ((const struct sample *)a)->value, q = ((const struct sample *)b)->value;
    return (p < q) - (p > q);
}

static struct sample *sorted(long n, const double *value, const uint8_t *becomes, long count[2], long *m) {
    struct sample *s = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *s);
    *m = count[0] = count[1] = 0;
    for (long i = 0; i < n; i++) {
        if (isnan(value[i])) continue;
        s[(*m)++] = (struct sample){value[i], becomes[i] != 0};
        count[becomes[i] != 0]++;
    }
    qsort(s, (size_t)*m, sizeof *s, largest_first);
    return s;
}

struct postproc_roc postproc_roc_new(long n, const double *value, const uint8_t *becomes) {
    long count[2], seen[2] = {0, 0}, m;
    struct sample *s = sorted(n, value, becomes, count, &m);
    struct postproc_roc r = {m, count[1], NAN, NAN, NAN, NAN};
    double most = -INFINITY, area = 0;
    for (long i = 0; i < m && count[0] && count[1];) {
        const double from[2] = {(double)seen[0], (double)seen[1]};
        const double at = s[i].value;
        for (; i < m && s[i].value == at; i++) seen[s[i].becomes]++; /* equal values give one point of the curve */
        area += ((double)seen[0] - from[0]) * 0.5 * (from[1] + (double)seen[1]);
        const double hits = (double)seen[1] / (double)count[1], false_ones = (double)seen[0] / (double)count[0];
        if (hits - false_ones <= most) continue;
        most = hits - false_ones;
        r.threshold = at, r.hits = hits, r.false_ones = false_ones;
    }
    if (count[0] && count[1]) r.area = area / ((double)count[0] * (double)count[1]);
    memory_free(s);
    return r;
}

void postproc_roc_at(long n, const double *value, const uint8_t *becomes, double threshold, double *hits,
                     double *false_ones) {
    long count[2] = {0, 0}, above[2] = {0, 0};
    for (long i = 0; i < n; i++) {
        if (isnan(value[i])) continue;
        count[becomes[i] != 0]++;
        above[becomes[i] != 0] += value[i] >= threshold;
    }
    *hits = count[1] ? (double)above[1] / (double)count[1] : NAN;
    *false_ones = count[0] ? (double)above[0] / (double)count[0] : NAN;
}
