/* The flows of which a tensor of permeability is made, as fields and pictures: frana permeability --fields. */
#pragma once
#include "scene/scene.h"
#include "stokes/stokes.h"

/* Makes the folders OUT/fields and OUT/pictures. Dies with exit code 4. Collective. */
void permeability_fields_begin(const char *out);
/* Writes the flow along an axis that s holds to OUT/fields/flow_AXIS.hdf: velocity and pressure at the cells' centres,
 * for a mean gradient in Pa/m, which the pressure includes, and the scene's viscosity; the solid fraction. Collective.
 */
void permeability_fields_write(const char *out, const struct scene *scene, const struct stokes *s, int axis,
                               double gradient);
/* Draws speed and pressure on a middle plane along each of the axes' flows that were written: OUT/pictures. Returns a
 * sentence on what is missing, or NULL. Not collective. */
const char *permeability_fields_draw(const char *out, const struct scene *scene, const int written[3]);
