/* Fixed point of H(x) without its derivative, for a vector spread over the ranks; all ranks take the same decisions.
 *
 * Aitken: x <- x + w r, r = H(x) - x, with the factor from the last two residuals,
 *     w <- -w r_last.(r - r_last)/|r - r_last|^2                 (Kuettler and Wall 2008; Causin et al. 2005)
 * Quasi-Newton with least squares (IQN-ILS):
 *     x <- H(x) + W c,   c = argmin |r + V c|
 * with the differences of residuals in V's columns and of images H(x) in W's.      (Degroote, Bathe, Vierendeels 2009)
 * Columns of earlier solves are reused while there is room; columns nearly dependent on newer ones are dropped. */
#pragma once

enum quasi_newton_kind { QUASI_NEWTON_LEAST_SQUARES, QUASI_NEWTON_AITKEN };
enum { QUASI_NEWTON_COLUMNS = 32 };

struct quasi_newton; /* opaque */
struct quasi_newton_input {
    enum quasi_newton_kind kind;
    double relaxation; /* w without an earlier residual, between 0 and 1 */
    double filter; /* a column is dropped if less than this fraction of it is independent of newer ones; preCICE's QR2
                    * has 1e-2 */
};

struct quasi_newton *quasi_newton_new(const struct quasi_newton_input *in);
void quasi_newton_free(struct quasi_newton *q);
/* Begins the solution of another map of the same kind, with n unknowns on this rank. Columns of earlier maps are kept,
 * unless n has changed on some rank or some rank sets `forget`. Collective. */
void quasi_newton_begin(struct quasi_newton *q, int n, int forget);
/* Replaces x [n] by the next guess, from image [n] = H(x). Collective. */
void quasi_newton_next(struct quasi_newton *q, double *x, const double *image);
int quasi_newton_columns(const struct quasi_newton *q);
