/* The fluid's state and its ghosts. */
#include "base/par_halo.h"
#include "fluid/grid/boundary.h"
#include "fluid/grid/outflow.h"
#include "fluid/grid/reach.h"
#include "fluid/internal.h"

struct fluid_state *fluid_state_of(struct fluid *f) {
    return &f->state;
}

/* Fills the ghosts of pi that the momentum equation reads, if p's are not these. The correction keeps them current. */
static void refresh_predictor(struct fluid *f) {
    const struct par_halo_part nearest = par_halo_whole(f->grid->halos, 1);
    if (f->state.pi != f->state.p) fluid_boundary_pressure(f->boundary, f->grid, f->state.pi, &nearest);
}

/* A free low side is closed by continuity, which reads one ghost layer of the neighbours; so these ghosts are filled
 * first. */
static void state_refresh(struct fluid *f, const struct par_halo_part *part) {
    double *const q[3] = {f->state.u, f->state.v, f->state.w};
    fluid_outflow_take(f->boundary, f->grid, q);
    if (f->boundary->low_unowned) {
        fluid_boundary_velocity(f->boundary, f->grid, q, 1);
        fluid_boundary_close(f->boundary, f->grid, q);
        fluid_outflow_take(f->boundary, f->grid, q);
    }
    fluid_boundary_velocity_part(f->boundary, f->grid, q, part);
    fluid_boundary_pressure(f->boundary, f->grid, f->state.p, part);
}

void fluid_state_refresh(struct fluid *f) {
    const struct par_halo_part whole = par_halo_whole(f->grid->halos, f->grid->halo);
    state_refresh(f, &whole);
    refresh_predictor(f);
}

void fluid_state_refresh_near(struct fluid *f, int layers, const int low[3], const int high[3]) {
    const struct par_halo_part part = fluid_reach(f->grid, layers, low, high);
    state_refresh(f, &part);
}
