/* The frozen retraction r_d of the markers: the distance of a marker inside the true wetted face, in cells. A
 * particle's centre is half a spacing inside, so the marker is placed (1/2 - r_d) dx outward of it. Measured:
 * docs/retraction.md. (Breugem 2012) */
#pragma once

#define PHYSICS_RETRACTION 0.6       /* from the faces of the lattice */
#define PHYSICS_RETRACTION_SHAPE 0.3 /* from the surfaces of shapes */
