/* The model of the bonds, and the Poisson's ratio that follows from it.  (000: sec. 1.2.1) */
#pragma once

/* A solid in three dimensions, or a plate in the x-y plane. */
enum physics_model { PHYSICS_3D, PHYSICS_PLANE_STRESS, PHYSICS_PLANE_STRAIN };
enum { PHYSICS_MODELS = PHYSICS_PLANE_STRAIN + 1 };

/* Forces along the bonds leave one free elastic constant: nu = 1/3 in plane stress, else 1/4. */
double physics_model_poisson_ratio(enum physics_model model);
