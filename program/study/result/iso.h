/* Run times at equal error. Pure. */
#pragma once

/* The time at which a curve falls to the error and stays below it: between the last level above the error and the next
 * one, linear in the logarithms. error, time [n], coarse to fine; NAN for a failed run, which is skipped. An error
 * below the floor, which the reference does not resolve, counts as the floor. Nothing is extrapolated: NAN if the curve
 * does not fall to the error or if the error is below the floor. If no level is above the error: the first level's
 * time, and *at_most is 1. */
double study_iso_time(int n, const double *error, const double *time, double at, double floor, int *at_most);
/* The k-th round error: 1, 0.3, 0.1, 0.03, ... */
double study_iso_round(int k);
/* The cheapest of the levels (coarse to fine) from which on the error stays at or below `at`; -1: none. NAN is
 * skipped. */
int study_iso_cheapest(int n, const double *error, const double *time, double at);
