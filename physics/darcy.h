/* Permeability: its unit, and the tensor's principal values. */
#pragma once

/* 1 D = 1 cm3/s cP cm/(cm2 atm), in m2; 1 atm = 101325 Pa */
#define PHYSICS_DARCY 9.869233e-13

/* u = -K grad p/mu. The tensor of a medium is symmetric; a measured one is so to its error. */
struct physics_darcy_principal {
    double value[3];    /* of the symmetric part (K + K^T)/2, the largest first, m2 */
    double along[3][3]; /* [value][component] their unit directions, the largest component positive */
    double asymmetry;   /* |K - K^T|/|K + K^T|, Frobenius norms */
};
struct physics_darcy_principal physics_darcy_principal_of(const double K[3][3]);
