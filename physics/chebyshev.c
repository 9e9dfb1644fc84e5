/* Coefficients of Chebyshev's iteration. */
#include "physics/chebyshev.h"

struct physics_chebyshev physics_chebyshev_of(double low, double high) {
    return (struct physics_chebyshev){.middle = 0.5 * (high + low), .half = 0.5 * (high - low)};
}

void physics_chebyshev_next(struct physics_chebyshev *c) {
    if (c->ratio == 0) {
        c->ratio = c->half / c->middle;
        c->keep = 0;
        c->gain = 1 / c->middle;
        return;
    }
    const double next = 1 / (2 * c->middle / c->half - c->ratio);
    c->keep = next * c->ratio;
    c->gain = 2 * next / c->half;
    c->ratio = next;
}
