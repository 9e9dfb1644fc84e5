/* The frozen retraction r_d of the markers: how far one stands inside the true wetted face, in cells. A particle's
 * centre stands half a spacing inside, so it is moved outward by (1/2 - r_d) dx. Measured: docs/retraction.md. (Breugem
 * 2012) */
#pragma once

#define PHYSICS_RETRACTION 0.6       /* from the faces of the lattice */
#define PHYSICS_RETRACTION_SHAPE 0.3 /* from the surfaces of shapes */
