/* Symmetric tensors as sums of e e: the stiffness of contacts at a particle. For solid/ only. */
#pragma once
#include <math.h>
#include <string.h>

enum solid_contact_tensor { XX, YY, ZZ, XY, XZ, YZ, TENSOR };

/* The largest eigenvalue of a tensor that is not negative: (tr T^p)^{1/p} by squaring, p = 64, at most 2 % high. */
static inline double solid_contact_tensor_largest(const double t[TENSOR]) {
    enum { SQUARINGS = 6 };
    double a[TENSOR], trace[SQUARINGS + 1];
    memcpy(a, t, sizeof a);
    for (int i = 0; i <= SQUARINGS; i++) {
        trace[i] = a[XX] + a[YY] + a[ZZ];
        if (!(trace[i] > 0)) return 0;
        const double inverse = 1 / trace[i];
        for (int k = 0; k < TENSOR; k++) a[k] *= inverse;
        const double b[TENSOR] = {
            a[XX] * a[XX] + a[XY] * a[XY] + a[XZ] * a[XZ], a[XY] * a[XY] + a[YY] * a[YY] + a[YZ] * a[YZ],
            a[XZ] * a[XZ] + a[YZ] * a[YZ] + a[ZZ] * a[ZZ], a[XX] * a[XY] + a[XY] * a[YY] + a[XZ] * a[YZ],
            a[XX] * a[XZ] + a[XY] * a[YZ] + a[XZ] * a[ZZ], a[XY] * a[XZ] + a[YY] * a[YZ] + a[YZ] * a[ZZ]};
        memcpy(a, b, sizeof a);
    }
    double root = trace[SQUARINGS];
    for (int i = SQUARINGS - 1; i >= 0; i--) root = trace[i] * sqrt(root);
    return root;
}
