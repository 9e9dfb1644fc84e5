/* The linear solid of any Poisson's ratio: bonds, and a pressure that follows the change of volume of a family.
 * (Silling et al. 2007, an ordinary state-based solid with the influence function 1/|xi|)
 *
 * Bonds alone have one Poisson's ratio (physics/model.h), and with it the bulk modulus k_b = 5/3 mu in space, 2 mu in a
 * plate. What a material's bulk modulus k has beyond that is borne by the dilatation theta of the family,
 *     W = bonds' part + 1/2 (k - k_b) theta^2 */
#pragma once
#include "physics/model.h"

/* The smallest and the largest Poisson's ratio. */
#define PHYSICS_DILATATION_MIN (-0.5)
#define PHYSICS_DILATATION_MAX 0.45

struct physics_dilatation {
    double bonds_modulus; /* Pa, Young's modulus of bonds alone with the material's shear modulus */
    double bulk_modulus;  /* k, Pa; of a plate that of strains in its plane */
    double stretch2;      /* s0^2 over that of those bonds with the same fracture energy  (Madenci and Oterkus 2014) */
};

/* E Pa; ratio_excess: Poisson's ratio less that of bonds alone; 0: bonds alone, whose constants are E, k_b, 1. */
struct physics_dilatation physics_dilatation_of(enum physics_model model, double youngs_modulus, double ratio_excess);

/* Poisson's ratio less that of bonds alone; 0 for a ratio that is this one in a few digits, as 1/3 has no finite
 * decimal form: 0.333 to 0.3334 are it. */
double physics_dilatation_ratio_excess(enum physics_model model, double poisson_ratio);
/* The ratio itself; that of bonds alone where it is this one in a few digits. */
double physics_dilatation_ratio(enum physics_model model, double poisson_ratio);
