/* Polynomials that replace the square root for small |eps|. For solid/ only. */
#pragma once

/* The largest |eps| for the short and for the long one; error 5e-16. */
#define SOLID_SERIES_LIMIT 2e-3
#define SOLID_SERIES_LONG_LIMIT 1.5e-2

enum solid_series {
    SERIES_SHORT, /* for |eps| up to SOLID_SERIES_LIMIT */
    SERIES_ROOTS, /* square roots, for any eps */
    SERIES_LONG /* for any eps: the long series if it holds for all bonds that are computed together, else square roots.
                 * A bond's last digit depends on the others */
};

/* g(eps)/eps = (1 - 1/sqrt(1 + eps))/eps: Chebyshev fits of degree four and six. */
static const double G0 = 0.5, G1 = -0.3749999999988720654, G2 = 0.31249999999895263208, G3 = -0.27343862793361512552,
                    G4 = 0.24609479736699067424;
static const double L0 = 0.5, L1 = -0.37500000000024474717, L2 = 0.31250000000023115098, L3 = -0.2734374912980980274,
                    L4 = 0.24609374178150818851, L5 = -0.2256632818841141981, L6 = 0.20954570392105659358;
