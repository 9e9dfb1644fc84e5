/* Orders of convergence, as slopes in logarithms. Pure. */
#pragma once

/* ln(e_coarse/e_fine) / ln(h_coarse/h_fine); NAN if it does not exist. */
double study_order_between(double e_coarse, double e_fine, double h_coarse, double h_fine);
/* Least squares slope of ln y over ln x, from the pairs [n] that are positive and finite; NAN for fewer than two of
 * them or if all x are equal. */
double study_order_fit(int n, const double *x, const double *y);
