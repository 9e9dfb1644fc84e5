/* The fluid that the solid displaces, if it moves as the solid does. */
#pragma once

struct run;

/* This rank's share, of its particles in the domain. */
struct displaced {
    double momentum[3], mass, kinetic; /* N s, kg, J */
};

/* rho sum V v, rho sum V, and rho/2 sum V v^2, with the fluid's density. Not collective. */
struct displaced displaced_by_solid(const struct run *r);
