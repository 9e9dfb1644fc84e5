/* The weights by which near particles carry a marker. */
#pragma once
#include "solid/force/attachment.h"
#include "solid/surface/surface.h"

struct solid_attachment *solid_attach_new(const struct solid *s);
void solid_attach_free(struct solid_attachment *a);
/* Sets the weights of the interface's markers, again where bonds have broken or the shift has changed: in the
 * undeformed body sum_l g_l (X_l - X_h) = shift n, with the normal n of the bonds that are intact now. shift [f->n], m.
 * The near particles are those within 1.5 spacings; a direction in which they do not extend gets no shift. A wall
 * wetted on both faces and a particle without bonds have their markers at the centre. The weights follow from the
 * present bonds, not from those before. Collective. */
void solid_attach_update(struct solid_attachment *a, const struct solid *s, const struct solid_surface *f,
                         const double *shift);
