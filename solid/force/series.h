/* Where a bond's |eps| is small a polynomial stands for the square root. Inside the room only. */
#pragma once

/* Up to this |eps|, to 5e-16. */
#define SOLID_SERIES_LIMIT 2e-3

/* g(eps)/eps = (1 - 1/sqrt(1 + eps))/eps: Chebyshev fit of degree four. */
static const double G0 = 0.5, G1 = -0.3749999999988720654, G2 = 0.31249999999895263208, G3 = -0.27343862793361512552,
                    G4 = 0.24609479736699067424;
