/* What a scene's solid and domain were when the run was set up. A checkpoint holds it, because a resumed run takes
 * bonds, held and unbreakable particles from the checkpoint, and not from its scene. */
#pragma once
#include <stddef.h>

struct run;
struct scene;
struct solid;

/* Sums over all particles that differ, but for rounding, if one particle differs. */
struct beginning {
    double size[3];     /* m, of the domain, in the directions in which it counts: with a fluid, or periodic; else 0 */
    double place[2];    /* of the particles; 0 without a solid, as all that follows */
    double held;        /* which of them constraints hold, and in which directions */
    double unbreakable; /* which of them lose no bond */
    double bonds;       /* which bonds they have, less those that initial cracks and shapes cut */
    double particles;
};

/* s: NULL, no solid. Its bonds are those of the set-up. Collective. */
struct beginning beginning_of(const struct scene *scene, const struct solid *s);

void beginning_write(const struct beginning *b, char *text, size_t size);
/* Whether the checkpoint's text is of another beginning than the scene's. Returns 1 with a sentence in why. */
int beginning_differs(const struct beginning *now, const char *text, char *why, size_t size);
