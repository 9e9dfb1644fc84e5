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
/* s(eps)/eps = (sqrt(1 + eps) - 1)/eps: the same; error 4e-17. */
static const double S0 = 0.5, S1 = -0.12499999999989746, S2 = 0.06249999999991943, S3 = -0.039062602539324344,
                    S4 = 0.027343830566624452;
static const double R0 = 0.5, R1 = -0.12500000000001632, R2 = 0.0625000000000136, R3 = -0.03906249941991327,
                    R4 = 0.027343749516589837, R5 = -0.020512968518312906, R6 = 0.016117577963057603;
