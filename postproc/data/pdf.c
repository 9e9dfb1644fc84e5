/* Probability density of a sample, with its moments and tail. */
#include "postproc/data/pdf.h"
#include "base/arena.h"
#include "base/memory.h"
#include "base/sort.h"

#include <math.h>

enum { BINS_MIN = 16, BINS_MAX = 400, FENCE = 10 };

/* A quantile, linear between the sorted samples. */
static double quantile(const double *sorted, long n, double q) {
    const double at = q * (double)(n - 1);
    const long i = (long)at < n - 1 ? (long)at : n - 1;
    return i + 1 < n ? sorted[i] + (at - (double)i) * (sorted[i + 1] - sorted[i]) : sorted[i];
}

static void moments(struct postproc_pdf *p, const double *sorted) {
    double sum = 0, squares = 0;
    for (long i = 0; i < p->n; i++) sum += sorted[i];
    p->mean = sum / (double)p->n;
    for (long i = 0; i < p->n; i++) squares += (sorted[i] - p->mean) * (sorted[i] - p->mean);
    p->deviation = sqrt(squares / (double)p->n);
    p->smallest = sorted[0];
    p->largest = sorted[p->n - 1];
}

static void choose_bins(struct postproc_pdf *p, const double *sorted) {
    const double first = quantile(sorted, p->n, 0.25), third = quantile(sorted, p->n, 0.75), iqr = third - first;
    double width = 2 * iqr / cbrt((double)p->n), low = p->smallest, high = p->largest;
    if (!(high > low)) { /* all values equal: one bin around them */
        p->bins = 1;
        p->width = fmax(fabs(low), 1) * 1e-6;
        p->low = low - 0.5 * p->width;
        return;
    }
    if (width > 0 && (high - low) / width > BINS_MAX) {
        low = fmax(quantile(sorted, p->n, 0.001), first - FENCE * iqr);
        high = fmin(quantile(sorted, p->n, 0.999), third + FENCE * iqr);
    }
    if (!(high > low)) {
        low = p->smallest;
        high = p->largest;
    }
    p->bins = width > 0 ? (int)fmin(fmax(ceil((high - low) / width), BINS_MIN), BINS_MAX) : BINS_MIN;
    p->low = low;
    p->width = (high - low) / p->bins;
}

struct postproc_pdf postproc_pdf_new(long n, const double *value) {
    struct postproc_pdf p = {.mean = NAN, .deviation = NAN, .smallest = NAN, .largest = NAN};
    double *sorted = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *sorted);
    for (long i = 0; i < n; i++)
        if (isfinite(value[i])) sorted[p.n++] = value[i];
    if (p.n > 0) {
        sort_ascending(sorted, (size_t)p.n);
        moments(&p, sorted);
        choose_bins(&p, sorted);
        p.density = arena_new((size_t)p.bins, sizeof *p.density);
        for (long i = 0; i < p.n; i++) {
            const double at = (sorted[i] - p.low) / p.width;
            if (at < 0 || at > p.bins * (1 + 1e-12))
                p.outside++;
            else
                p.density[at < p.bins ? (int)at : p.bins - 1] += 1;
        }
        for (int i = 0; i < p.bins; i++) p.density[i] /= (double)(p.n - p.outside) * p.width;
    }
    memory_free(sorted);
    return p;
}

double postproc_pdf_above(long n, const double *value, double threshold) {
    long all = 0, above = 0;
    for (long i = 0; i < n; i++) {
        if (!isfinite(value[i])) continue;
        all++;
        above += value[i] > threshold;
    }
    return all ? (double)above / (double)all : NAN;
}
