/* Chebyshev's iteration: its error is the polynomial that is least between the bounds of the eigenvalues. */
#include "physics/chebyshev.h"

#include <math.h>
#include "tests/check.h"

/* The residual after n terms for an eigenvalue, over that of the start. */
static double left(double low, double high, double eigenvalue, int n) {
    struct physics_chebyshev c = physics_chebyshev_of(low, high);
    double x = 0, change = 0;
    for (int k = 0; k < n; k++) {
        physics_chebyshev_next(&c);
        change = c.keep * change + c.gain * (1 - eigenvalue * x);
        x += change;
    }
    return 1 - eigenvalue * x;
}

/* It is T_n((middle - eigenvalue)/half)/T_n(middle/half), with T_n(x) = cos(n acos x) or cosh(n acosh x). */
static void polynomial(void **state) {
    (void)state;
    const double low = 1, high = 4, at = 5. / 3;
    for (int n = 1; n < 12; n++)
        for (int i = 0; i <= 30; i++) {
            const double eigenvalue = low + (high - low) * i / 30, x = (2.5 - eigenvalue) / 1.5;
            check_close(left(low, high, eigenvalue, n), cos(n * acos(fmax(-1, fmin(1, x)))) / cosh(n * acosh(at)),
                        1e-14);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(polynomial)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
