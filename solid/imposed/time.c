/* Piecewise linear factor of time: value, mean over an interval, copy. */
#include "solid/imposed/time.h"
#include "base/memory.h"

#include <math.h>
#include <stdint.h>

double solid_time_factor(const struct solid_time *f, double t) {
    if (f->n == 0) return 1;
    t -= f->origin;
    if (t <= f->t[0]) return f->factor[0];
    int k = 1;
    while (k < f->n && f->t[k] <= t) k++;
    if (k == f->n) return f->factor[k - 1];
    const double part = (t - f->t[k - 1]) / (f->t[k] - f->t[k - 1]);
    return f->factor[k - 1] + part * (f->factor[k] - f->factor[k - 1]);
}

double solid_time_ends(const struct solid_time *f) {
    return f->n > 1 && isfinite(f->origin) ? f->origin + f->t[f->n - 1] : -INFINITY;
}

/* Trapezium rule over from, the points between, and to. */
double solid_time_mean(const struct solid_time *f, double from, double to) {
    const double first = solid_time_factor(f, from);
    from -= f->origin;
    to -= f->origin;
    if (f->n < 2 || !(to > from) || from >= f->t[f->n - 1] || to <= f->t[0]) return first;
    double sum = 0, t = from, value = first;
    for (int k = 0; k <= f->n; k++) {
        if (k < f->n && (f->t[k] <= from || f->t[k] >= to)) continue;
        const double next = k < f->n ? f->t[k] : to, there = solid_time_factor(f, f->origin + next);
        sum += 0.5 * (value + there) * ((next - t) / (to - from));
        t = next;
        value = there;
    }
    return sum;
}

void solid_time_copy(struct solid_time *f) {
    f->t = memory_copy(MEMORY_SOLID, f->t, (size_t)f->n, sizeof(double));
    f->factor = memory_copy(MEMORY_SOLID, f->factor, (size_t)f->n, sizeof(double));
}

void solid_time_free(struct solid_time *f) {
    MEMORY_FREE((void *)(uintptr_t)f->t, (void *)(uintptr_t)f->factor);
    *f = (struct solid_time){0};
}
