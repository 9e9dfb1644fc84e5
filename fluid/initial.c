/* Initial velocity: uniform flow or developed profile, plus Taylor-Green vortices. */
#include "base/memory.h"
#include "fluid/grid/boundary.h"
#include "fluid/grid/profile.h"
#include "fluid/internal.h"

#include <math.h>

/* Component c of the vortices at x, per unit velocity.  (Taylor and Green 1937; Brachet 1983)
 * The height of the second component makes the discrete divergence 0:
 *     sin(k_a d_a/2)/d_a = height sin(k_b d_b/2)/d_b,  k = 2 pi/length. */
static double vortices_at(const struct fluid_input *in, int c, const double x[3]) {
    const int *along = in->vortices.along, a = along[0] ? 0 : 1, b = along[1] && a == 0 ? 1 : 2;
    double value = c == b ? -1 : c == a ? 1 : 0;
    for (int d = 0; d < 3; d++)
        if (along[d]) {
            const double angle = 2 * M_PI * x[d] / in->length[d];
            value *= d == c ? sin(angle) : cos(angle);
        }
    const double height =
        sin(M_PI / in->n[a]) * in->n[a] / in->length[a] / (sin(M_PI / in->n[b]) * in->n[b] / in->length[b]);
    return c == b ? height * value : value;
}

/* A uniform velocity, or for each component the developed profile with that mean; vortices are added. */
void fluid_initial_fill(struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    for (int c = 0; c < 3; c++) {
        double *q = fluid_component(&f->state, c), *profile = NULL;
        int a, b;
        fluid_boundary_others(c, &a, &b);
        if (f->in.initial_poiseuille) {
            profile = memory_new(MEMORY_FLUID, (size_t)g->n[a] * (size_t)g->n[b], sizeof *profile);
            fluid_profile_developed(&f->in, c, profile);
        }
        for (int k = -1; k < g->m[2]; k++) /* low faces as well: an outflow starts from them */
            for (int j = -1; j < g->m[1]; j++)
                for (int i = -1; i < g->m[0]; i++) {
                    const int at[3] = {i, j, k};
                    const int ja = at[a] + g->lo[a], jb = at[b] + g->lo[b];
                    const double shape = !profile || ja < 0 || jb < 0 ? 1 : profile[jb * g->n[a] + ja];
                    double value = f->in.initial_velocity[c] * shape, x[3];
                    for (int d = 0; d < 3; d++) x[d] = (at[d] + g->lo[d] + (d == c ? 1.0 : 0.5)) * g->d[d];
                    if (f->in.vortices.velocity != 0) value += f->in.vortices.velocity * vortices_at(&f->in, c, x);
                    q[fluid_grid_at(g, i, j, k)] = value;
                }
        memory_free(profile);
    }
}
