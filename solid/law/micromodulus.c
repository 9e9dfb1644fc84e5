/* Table of the micromodulus functions. */
#include "solid/law/micromodulus.h"
#include "base/ensure.h"

#include <assert.h>
#include <stddef.h>

static const struct solid_micromodulus *const law[] = {[SOLID_CONSTANT] = &solid_micromodulus_constant,
                                                       [SOLID_CONICAL] = &solid_micromodulus_conical,
                                                       [SOLID_EXPONENTIAL] = &solid_micromodulus_exponential};
static_assert(sizeof law / sizeof *law == SOLID_MICROMODULI, "every enum solid_micromodulus_kind needs its law");

const struct solid_micromodulus *solid_micromodulus_of(enum solid_micromodulus_kind kind) {
    ENSURE((unsigned)kind < SOLID_MICROMODULI && law[kind], "micromodulus %d", (int)kind);
    return law[kind];
}
