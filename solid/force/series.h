/* Polynomials that replace the square root for small |eps|. For solid/ only. */
#pragma once

/* The largest |eps| for them; error 5e-16. */
#define SOLID_SERIES_LIMIT 2e-3

/* g(eps)/eps = (1 - 1/sqrt(1 + eps))/eps: Chebyshev fit of degree four. */
static const double G0 = 0.5, G1 = -0.3749999999988720654, G2 = 0.31249999999895263208, G3 = -0.27343862793361512552,
                    G4 = 0.24609479736699067424;
