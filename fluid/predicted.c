/* The predicted velocity of a stage, and its ghosts. */
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"

double *const *fluid_predicted(struct fluid *f) { return f->predicted; }

void fluid_predicted_refresh(struct fluid *f, int layers) {
    fluid_boundary_velocity(f->boundary, f->grid, f->predicted, layers);
}
