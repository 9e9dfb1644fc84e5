/* Depth of interface particles by the number of their neighbours. */
#include "solid/surface/counted.h"
#include "physics/depth.h"
#include "solid/geometry/shape.h"

#include <math.h>

/* The stencil holds |xi| < horizon + spacing/2 (solid/law/stencil.h). */
static int reaches(const struct solid *s, const struct solid_body *body) {
    const double reach = s->in.material[body->material].horizon_ratio + 0.5;
    return reach * reach > PHYSICS_DEPTH_REACH2 * (1 + 1e-6);
}

float solid_counted_depth(const struct solid *s, int h, const struct solid_family_view *view) {
    const struct solid_body *body = &s->in.body[s->body[h]];
    if (s->dim == 2 || !solid_shape_is_on_lattice(body) || !reaches(s, body)) return -1;
    int present = physics_depth_weight(0);
    for (int b = 0; b < view->n; b++) {
        double r2 = 0;
        for (int c = 0; c < 3; c++) r2 += view->xi[b][c] * view->xi[b][c];
        present += physics_depth_weight((int)lrint(r2 / (s->in.spacing * s->in.spacing)));
    }
    return (float)physics_depth(present);
}
