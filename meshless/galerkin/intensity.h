/* Stress-intensity factors by domain integrals over a ring about a tip, from half a radius to the radius.
 *
 *     J = int (s_ij u_i,1 - W d_1j) q,j dA,      q falls from 1 to 0 across the ring;  J = (K_I^2 + K_II^2)/E'
 *     I = int (s_ij a_i,1 + t_ij u_i,1 - s_ik e_ik d_1j) q,j dA = 2 (K_I K_I^a + K_II K_II^a)/E'
 *
 * with u, s the solution and a, t, e the field of a crack in an infinite plate with K^a = 1 in one mode.  (Moran and
 * Shih 1987; Yau et al. 1980) With the field of a force f on the tip I = T f/E'.  (Kfouri 1986) */
#pragma once
#include "meshless/galerkin/galerkin.h"

struct galerkin_intensity {
    double k[2];   /* K_I, K_II by the interaction integral, Pa m^1/2 */
    double j, k_j; /* J, J/m2; root of J E', Pa m^1/2 */
    double t;      /* T-stress: along the crack, constant in the distance from the tip, Pa */
};
/* The largest radius of a ring about the tip: it stays in the body and about the straight crack. */
double meshless_intensity_widest(const struct galerkin *g, int tip);
struct galerkin_intensity meshless_intensity_of(const struct galerkin *g, int tip, double radius);
