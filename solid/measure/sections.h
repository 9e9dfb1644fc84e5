/* Nominal stresses on plane sections of bodies under given forces, by statics alone. */
#pragma once
#include "solid/state.h"

/* A section across an axis, through one layer of particles. */
struct solid_section {
    double stress; /* the uniaxial tension that is as near to fracture (physics/griffith.h), Pa */
    int axis;      /* -1: there is none */
    double at;     /* its place along the axis, m */
    double area;   /* of its particles, m2 */
};
/* The worst section of the chosen bodies, [s->in.bodies], taken as one: normal force over area, moment over section
 * modulus and 3/2 of the shear force over area, as of a beam. Endless bodies are a bar whose ends the next period
 * holds: the sections' stretches, shears and bends add up to 0 over a period. force: [3][n] N/m3 on owned particles;
 * the support's reactions are added to it (solid/measure/support.h). Collective. */
struct solid_section solid_sections_worst(const struct solid *s, const uint8_t *chosen, double *const force[3]);
