/* Probability densities of samples. */
#pragma once

struct postproc_pdf {
    int bins;
    double low, width;                         /* bin i: low + i width ... low + (i+1) width */
    double *density;                           /* [bins], sum density width = 1 over the samples in the bins; kept */
    long n, outside;                           /* number of samples, and number of those beyond the bins */
    double mean, deviation, smallest, largest; /* of all samples */
};

/* Bins by the rule of Freedman and Diaconis (1981), 2 IQR n^(-1/3), between 16 and 400 of them. If the tails need more
 * bins, these cover the 0.1 % to 99.9 % quantiles, but at most ten interquartile ranges from the quartiles (crushed
 * material has strains of a hundred times s0); samples beyond are counted as outside. NaN is left out. */
struct postproc_pdf postproc_pdf_new(long n, const double *value);
/* The fraction of the samples above a value. */
double postproc_pdf_above(long n, const double *value, double threshold);
