/* Orders of convergence, as slopes in logarithms. Pure. */
#pragma once

/* ln(e_coarse/e_fine) / ln(h_coarse/h_fine); NAN where that does not exist. */
double study_order_between(double e_coarse, double e_fine, double h_coarse, double h_fine);
/* Least squares slope of ln y over ln x, of the pairs [n] that are positive and finite; NAN for fewer than two of them
 * or where x is the same in all. */
double study_order_fit(int n, const double *x, const double *y);
