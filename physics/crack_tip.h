/* The field about the tip of a straight crack with free faces in an infinite plate.  (Williams 1957) */
#pragma once

struct physics_crack_tip {
    double youngs_modulus, poisson_ratio; /* Pa, 1 */
    int plane_strain;                     /* 0: plane stress */
};

/* E' = E in plane stress, E/(1 - nu^2) in plane strain; J = (K_I^2 + K_II^2)/E'. */
double physics_crack_tip_modulus(const struct physics_crack_tip *in);
/* In the tip's frame, whose first axis goes on from the crack, at distance r and angle t in [-pi, pi], for K_I = 1
 * (mode 0), K_II = 1 (mode 1), or a force of 1 N/m on the tip along the first axis (mode 2): stress (11, 22, 12),
 * displacement u_1, u_2, and its derivatives u_1,1, u_2,1. The interaction integral with the force is T/E', T the
 * stress along the crack that is constant in r.  (Kfouri 1986) */
void physics_crack_tip_field(const struct physics_crack_tip *in, int mode, double r, double t, double stress[3],
                             double u[2], double slope[2]);
