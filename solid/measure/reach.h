/* How near the bonds are to the stretches at which they break or begin to soften; computed at the end of stages only.
 */
#pragma once
#include "solid/state.h"

struct solid_reach {
    double part;     /* the largest stretch over the bond's own limit; 0: no bond has a limit */
    double critical; /* that limit */
    double modulus;  /* the smaller E of that bond's two ends, Pa */
    long beyond;     /* bonds beyond their limits; a bond that begins to soften has passed it */
    int softens;     /* at the limit the bond begins to soften; 0: it breaks */
};
/* Of the intact bonds that may break: unbreakable particles have none. Each bond has the limit of its own materials or
 * interface. Of materials with `s00`, whose limits follow the other bonds, all is 0. Collective. */
struct solid_reach solid_reach_find(struct solid *s);
