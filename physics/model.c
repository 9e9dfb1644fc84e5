/* Poisson's ratio of the bond-based model. */
#include "physics/model.h"

double physics_model_poisson_ratio(enum physics_model model) { return model == PHYSICS_PLANE_STRESS ? 1. / 3 : 0.25; }
