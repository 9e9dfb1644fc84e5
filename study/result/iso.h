/* Run times at equal error. Pure. */
#pragma once

/* The time at which a curve comes down to the error and stays below it: between the last level above it and the next,
 * linear in the logarithms. error, time [n], coarse to fine, NAN where a run failed (it is passed over). An error below
 * the floor, which the reference does not resolve, counts as the floor. Nothing is extrapolated: NAN where the curve
 * does not come down to the error or the error is below the floor; where no level is above it, the first one's time,
 * and *at_most is 1. */
double study_iso_time(int n, const double *error, const double *time, double at, double floor, int *at_most);
/* The k-th round error: 1, 0.3, 0.1, 0.03, ... */
double study_iso_round(int k);
/* The cheapest of the levels from which on the error stays at or below `at`, coarse to fine; -1: none. NAN is passed
 * over. */
int study_iso_cheapest(int n, const double *error, const double *time, double at);
