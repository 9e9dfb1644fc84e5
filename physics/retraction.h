/* The frozen retraction r_d of the markers: the distance of a marker inside the wetted face, in cells. A particle's
 * centre is its depth inside that face, so its marker is placed (depth - r_d dx) outward of the centre. Measured:
 * docs/retraction.md. (Breugem 2012) */
#pragma once

#define PHYSICS_RETRACTION 0.28

/* What a curved surface adds to r_d: this times its mean curvature times the cell. For shapes only; the depth by the
 * number of neighbours (physics/depth.h) contains as much. */
#define PHYSICS_RETRACTION_CURVED 0.5
