/* Probability densities of samples. */
#pragma once

struct postproc_pdf {
    int bins;
    double low, width; /* bin i: low + i width ... low + (i+1) width */
    double *density;   /* [bins], sum density width = 1 over the samples that are in a bin; owned */
    long n, outside;   /* samples, and those beyond the bins */
    double mean, deviation, smallest, largest; /* of all samples */
};

/* Bins by the rule of Freedman and Diaconis (1981), 2 IQR n^(-1/3), between 16 and 400 of them. Where tails would need
 * more, the bins stand between the 0.1 % and 99.9 % quantiles, no further than ten interquartile ranges from the
 * quartiles (crushed matter strains by a hundred times s0), and what is beyond is counted as outside. NaN is left out.
 */
struct postproc_pdf postproc_pdf_new(long n, const double *value);
void postproc_pdf_free(struct postproc_pdf *p);
/* The share of samples above a value. */
double postproc_pdf_above(long n, const double *value, double threshold);
