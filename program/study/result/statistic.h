/* Order statistics of repeated measurements. Pure. */
#pragma once

double study_statistic_mean(int n, const double *x);      /* NAN for n = 0 */
double study_statistic_deviation(int n, const double *x); /* with n - 1 in the denominator; NAN for n < 2 */

void study_statistic_sort(int n, double *x); /* ascending, in place */
/* The q-quantile, 0 <= q <= 1, of x [n] in ascending order, linear between neighbours (Hyndman and Fan 1996, type 7);
 * NAN for n = 0. */
double study_statistic_quantile(int n, const double *x, double q);
