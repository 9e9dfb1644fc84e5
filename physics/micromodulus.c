/* Table of the micromodulus functions; a kind without a line does not compile. */
#include "physics/micromodulus.h"
#include "base/ensure.h"

const struct physics_micromodulus_law *physics_micromodulus_of(enum physics_micromodulus kind) {
    switch (kind) {
    case PHYSICS_CONSTANT:
        return &physics_micromodulus_constant;
    case PHYSICS_CONICAL:
        return &physics_micromodulus_conical;
    case PHYSICS_EXPONENTIAL:
        return &physics_micromodulus_exponential;
    case PHYSICS_MICROMODULI:
        break;
    }
    ENSURE(0, "micromodulus %d", (int)kind);
}
