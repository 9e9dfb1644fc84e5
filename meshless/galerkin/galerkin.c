/* Makes and frees an element-free plate. */
#include "meshless/galerkin/galerkin.h"
#include "base/die.h"
#include "base/memory.h"
#include "meshless/galerkin/assemble.h"
#include "meshless/galerkin/cells.h"
#include "meshless/galerkin/constraint.h"
#include "meshless/galerkin/cut.h"
#include "meshless/galerkin/mls.h"

#include <math.h>

static void set_elastic(struct galerkin *g) {
    const double e = g->in.youngs_modulus, nu = g->in.poisson_ratio;
    const double e1 = g->in.plane_strain ? e / (1 - nu * nu) : e, nu1 = g->in.plane_strain ? nu / (1 - nu) : nu;
    const double c = e1 / (1 - nu1 * nu1);
    g->elastic[0][0] = g->elastic[1][1] = c;
    g->elastic[0][1] = g->elastic[1][0] = c * nu1;
    g->elastic[2][2] = 0.5 * c * (1 - nu1);
}

static void set_radii(struct galerkin *g) {
    g->radius = memory_new(MEMORY_SOLID, (size_t)g->in.nodes, sizeof *g->radius);
    for (int i = 0; i < g->in.nodes; i++) {
        g->radius[i] = g->in.support * (g->in.size ? g->in.size[i] : g->in.spacing);
        g->widest = fmax(g->widest, g->radius[i]);
    }
}

/* Two tips' zones must not meet: between them the nearest tip changes. */
static void set_zone(struct galerkin *g) {
    double least = INFINITY;
    for (int a = 0; a < g->tips; a++)
        for (int b = 0; b < a; b++)
            least = fmin(least, hypot(g->tip[a].x[0] - g->tip[b].x[0], g->tip[a].x[1] - g->tip[b].x[1]));
    g->in.tip_radius = fmin(g->in.tip_radius, 0.5 * least / g->in.spacing);
}

struct galerkin *meshless_galerkin_new(const struct galerkin_input *in) {
    struct galerkin *g = memory_new(MEMORY_SOLID, 1, sizeof *g);
    g->in = *in;
    if (in->nodes < 4)
        die_all(EXIT_CODE_SCENE, "the body holds %d nodes; take a smaller solid.spacing than %g m", in->nodes,
                in->spacing);
    set_elastic(g);
    set_radii(g);
    meshless_cut_begin(g);
    set_zone(g);
    g->near_line = memory_new(MEMORY_SOLID, (size_t)in->nodes, 1);
    meshless_cut_mark(g);
    meshless_mls_bins(g);
    meshless_cells_new(g);
    meshless_constraint_new(g);
    meshless_assemble_order(g);
    return g;
}

void meshless_galerkin_free(struct galerkin *g) {
    if (!g) return;
    meshless_cut_end(g);
    meshless_cells_free(g);
    meshless_constraint_free(g);
    MEMORY_FREE(g->radius, g->near_line, g->bins.first, g->bins.node, g->rank, g->node_of, g->solution.u,
                g->solution.multiplier, g->solution.history, g);
}
