/* Depth of interface particles by the number of their neighbours. */
#include "solid/surface/counted.h"
#include "physics/depth.h"
#include "solid/geometry/shape.h"

#include <math.h>

/* The farthest shell that is complete in the family, which holds |xi| < horizon + spacing/2 (solid/law/stencil.h). */
static int reach2_of(const struct solid *s, const struct solid_body *body) {
    const double reach = s->in.material[body->material].horizon_ratio + 0.5;
    int reach2 = PHYSICS_DEPTH_REACH2;
    while (reach2 > 2 && !(reach * reach > reach2 * (1 + 1e-6))) reach2--;
    return reach2;
}

float solid_counted_depth(const struct solid *s, int h, const struct solid_family_view *view) {
    const struct solid_body *body = &s->in.body[s->body[h]];
    if (s->dim == 2 || !solid_shape_is_on_lattice(body)) return -1;
    const int reach2 = reach2_of(s, body);
    int present = physics_depth_weight(0, reach2);
    for (int b = 0; b < view->n; b++) {
        double r2 = 0;
        for (int c = 0; c < 3; c++) r2 += view->xi[b][c] * view->xi[b][c];
        present += physics_depth_weight((int)lrint(r2 / (s->in.spacing * s->in.spacing)), reach2);
    }
    return (float)physics_depth(present, reach2);
}
