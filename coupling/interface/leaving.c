/* Tells the fluid which outflows moving bodies are near (fluid/grid/outflow.h). */
#include "coupling/interface/leaving.h"
#include "coupling/run.h"

#include <math.h>

/* Cells between a marker and the side, before and behind it, within which the body is near. A ball of three cells'
 * radius leaves with the same momentum for 4 to 100 of them; with 2 it is 1 % less. */
static const double REACH = 6;

static int is_near(const struct run *r, int d, int side) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const double *x = r->markers.x[d], at = side ? g->length[d] : 0, reach = REACH * g->d[d];
    for (int i = 0; i < r->markers.n; i++)
        if (fabs(x[i] - at) <= reach) return 1;
    return 0;
}

void leaving_update(const struct run *r) {
    const struct fluid_input *in = fluid_input_of(r->fluid);
    const int moves = run_stage(r)->solid != SCENE_SOLID_RIGID;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            if (in->side[d][side].type == FLUID_OUTFLOW)
                fluid_outflow_near(r->fluid, d, side, moves && is_near(r, d, side));
}
