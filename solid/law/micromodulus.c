/* Table of the micromodulus functions; a kind without a line does not compile. */
#include "solid/law/micromodulus.h"
#include "base/ensure.h"

const struct solid_micromodulus *solid_micromodulus_of(enum solid_micromodulus_kind kind) {
    switch (kind) {
    case SOLID_CONSTANT:
        return &solid_micromodulus_constant;
    case SOLID_CONICAL:
        return &solid_micromodulus_conical;
    case SOLID_EXPONENTIAL:
        return &solid_micromodulus_exponential;
    case SOLID_MICROMODULI:
        break;
    }
    ENSURE(0, "micromodulus %d", (int)kind);
}
