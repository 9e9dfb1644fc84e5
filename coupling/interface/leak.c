/* How much fluid passes through a porous body's walls, and the slip time that keeps it small. */
/* The forcing acts on markers in the solid's surface. Behind it is the inner fluid, which is at rest and whose pressure
 * is uniform along the flow, the driving included. The pores' pressure falls from dp/2 above it to dp/2 below it, so
 * the walls have a jump of up to dp/2. A force of that size has the slip s F, with s the slip time:
 *
 *     F = dp/(2 rho dx) ,   leak = s F ,   U = k dp/(mu L) ,   leak/U = s nu L/(2 k dx) .
 *
 * In a rock the solid is connected from the front to the back, so this flow goes through it. The longer and denser the
 * sample, the more it is: 30 % of k in a sandstone of 110 cells with s = 0.004 dx^2/nu. An estimate of k is enough to
 * limit it. Kozeny and Carman give k = phi^3/(5 S^2), with phi the porosity and S the surface per volume of the box. */
#include "coupling/interface/leak.h"

#include <math.h>

static const double PART = 0.015, CARMAN = 5;

double leak_slip_time(struct medium *m, const struct fluid *fluid, double immersed_area) {
    const double dx = fluid_grid_of(fluid)->d[0];
    if (!medium_is_across(m)) return INFINITY;
    if (medium_spans(m, medium_axis(m)) == MEDIUM_SPAN_NONE) return INFINITY;
    const double porosity = medium_measure_porosity(m);
    const double surface = medium_measure_specific_surface(m, immersed_area);
    if (!(porosity > 0) || !(surface > 0)) return INFINITY;
    const double permeability = pow(porosity, 3) / (CARMAN * surface * surface);
    return PART * 2 * permeability * dx / (fluid_input_of(fluid)->viscosity * medium_extent(m));
}
