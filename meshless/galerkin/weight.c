/* Cubic and quartic spline weights. */
#include "meshless/galerkin/weight.h"
#include "base/ensure.h"

void meshless_weight(enum galerkin_weight kind, double s, double *w, double *dw) {
    *w = *dw = 0;
    if (s >= 1) return;
    switch (kind) {
    case GALERKIN_CUBIC:
        if (s < 0.5) {
            *w = 2. / 3 - 4 * s * s + 4 * s * s * s;
            *dw = -8 * s + 12 * s * s;
        } else {
            *w = 4. / 3 * (1 - s) * (1 - s) * (1 - s);
            *dw = -4 * (1 - s) * (1 - s);
        }
        return;
    case GALERKIN_QUARTIC:
        *w = 1 - s * s * (6 - s * (8 - 3 * s));
        *dw = -12 * s * (1 - s) * (1 - s);
        return;
    }
    ENSURE(0, "weight %d", (int)kind);
}
