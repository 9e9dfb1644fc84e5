/* Run time at a given error, by interpolation between levels. */
#include "program/study/result/iso.h"

#include <math.h>

double study_iso_time(int n, const double *error, const double *time, double at, double floor, int *at_most) {
    int above = -1, below = -1;
    *at_most = 0;
    if (!(at >= floor) || !(at > 0)) return NAN;
    for (int i = 0; i < n; i++) {
        if (!isfinite(error[i]) || !isfinite(time[i]) || time[i] <= 0) continue;
        if (error[i] > at) {
            above = i;
            below = -1;
        } else if (below < 0) {
            below = i;
        }
    }
    if (below < 0) return NAN;
    if (above < 0) {
        *at_most = 1;
        return time[below];
    }
    const double e0 = log(error[above]), e1 = log(fmax(fmax(error[below], floor), 1e-300));
    const double t0 = log(time[above]), t1 = log(time[below]);
    return exp(t0 + (t1 - t0) * (e0 - log(at)) / (e0 - e1));
}

double study_iso_round(int k) { return pow(10, -(k / 2)) * (k % 2 ? 0.3 : 1); }

int study_iso_cheapest(int n, const double *error, const double *time, double at) {
    int found = -1;
    for (int i = n - 1; i >= 0 && !(error[i] > at); i--) /* a finer level above the error: the coarser one was below it
                                                          * by chance */
        if (isfinite(error[i]) && time[i] > 0 && (found < 0 || time[i] <= time[found])) found = i;
    return found;
}
