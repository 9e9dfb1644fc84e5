/* The root of H(x) - x without H's derivative: the vector is spread over the ranks, what is decided is decided alike on
 * all.
 *
 * Aitken: x <- x + w r, r = H(x) - x, the factor from the last two residuals,
 *     w <- -w r_last.(r - r_last)/|r - r_last|^2                             (Kuettler and Wall 2008; Causin et al.
 * 2005) Quasi-Newton with least squares (IQN-ILS): x <- H(x) + W c,   c = argmin |r + V c| with the differences of
 * residuals in V's columns and of images H(x) in W's.                  (Degroote, Bathe, Vierendeels 2009) Columns of
 * earlier solves are used again while there is room; those nearly dependent on newer ones are dropped. */
#pragma once

enum quasi_newton_kind { QUASI_NEWTON_LEAST_SQUARES, QUASI_NEWTON_AITKEN };
enum { QUASI_NEWTON_COLUMNS = 32 };

struct quasi_newton; /* opaque */
struct quasi_newton_input {
    enum quasi_newton_kind kind;
    double relaxation; /* w while nothing is known, between 0 and 1 */
    double
        filter; /* a column is dropped if less of it than this is independent of newer ones; preCICE's QR2 has 1e-2 */
};

struct quasi_newton *quasi_newton_new(const struct quasi_newton_input *in);
void quasi_newton_free(struct quasi_newton *q);
/* Another map of the same kind on n unknowns of this rank. What is known of the last one is kept, unless n has changed
 * on some rank or `forget` is set on some. Collective. */
void quasi_newton_begin(struct quasi_newton *q, int n, int forget);
/* x [n] to the next guess from image [n] = H(x). Collective. */
void quasi_newton_next(struct quasi_newton *q, double *x, const double *image);
int quasi_newton_columns(const struct quasi_newton *q);
