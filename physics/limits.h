/* The largest numbers of things that the scene's rules allow and the solid's arrays hold. */
#pragma once

enum {
    PHYSICS_BODIES_MAX = 255, /* the body of a particle is stored in one byte */
    PHYSICS_LEVELS_MAX = 4    /* of refinement; each halves the spacing */
};
