/* Chebyshev's iteration for A x = b, where A has eigenvalues between low and high only, 0 < low < high. A term is
 *
 *     change <- keep change + gain (b - A x)      x <- x + change
 *
 * Its coefficients need no scalar products. (Saad 2003: Iterative methods for sparse linear systems, alg. 12.1) */
#pragma once

struct physics_chebyshev {
    double middle, half; /* of the eigenvalues: (high + low)/2, (high - low)/2 */
    double ratio;        /* of the last term; 0: none was made */
    double keep, gain;   /* of the present term */
};

struct physics_chebyshev physics_chebyshev_of(double low, double high);
/* Sets keep and gain of the next term. Of the first one keep is 0 and gain is 1/middle. */
void physics_chebyshev_next(struct physics_chebyshev *c);
