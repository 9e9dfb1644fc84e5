/* The slip time of the forcing. */
#include "coupling/interface/slip.h"
#include "coupling/interface/leak.h"
#include "coupling/run.h"

#include <math.h>

/* The slip time over the times in which momentum diffuses over a cell, the flow crosses one, and a wave of the solid
 * crosses one. A longer slip time lets more fluid through the wall and damps the solid's motion; with a shorter one the
 * part of the force that the markers cannot see fades more slowly, in dt^2 over the slip time. */
static const double SLIP_OF_DIFFUSION = 4e-3, SLIP_OF_CONVECTION = 0.02, SLIP_OF_WAVE = 0.02;

double slip_time_of(struct run *r) {
    const struct fluid_input *in = fluid_input_of(r->fluid);
    const struct solid_input *solid = &r->solid->in;
    const double dx = fluid_grid_of(r->fluid)->d[0];
    double most =
        fmin(SLIP_OF_DIFFUSION * dx * dx / in->viscosity, SLIP_OF_CONVECTION * dx / fluid_limits_speed(r->fluid));
    most = fmin(most, leak_slip_time(r->medium, r->fluid, r->surface->immersed_area));
    for (int m = 0; m < solid->materials && r->needs.bonds; m++)
        most = fmin(most, SLIP_OF_WAVE * dx * sqrt(solid->material[m].density / solid->material[m].youngs_modulus));
    return most;
}

/* By probes the load of a moving solid under implicit diffusion is a step old. With the short slip time of a solid at
 * rest the markers then answer each motion with a force that grows from step to step: a soft block on a wall became
 * unstable within 10 ms, whatever the step. */
double slip_time_of_implicit(struct run *r) {
    if (!r->needs.bonds) return slip_time_of(r);
    return fmin(fluid_limits_explicit_step(r->fluid) / 3,
                leak_slip_time(r->medium, r->fluid, r->surface->immersed_area));
}
