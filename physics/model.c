/* Poisson's ratio of the bond-based model. */
#include "physics/model.h"
#include "base/ensure.h"

double physics_model_poisson_ratio(enum physics_model model) {
    switch (model) {
    case PHYSICS_PLANE_STRESS:
        return 1. / 3;
    case PHYSICS_3D:
    case PHYSICS_PLANE_STRAIN:
        return 0.25;
    }
    ENSURE(0, "model %d", (int)model);
}
