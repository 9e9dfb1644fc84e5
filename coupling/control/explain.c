/* Describes the limit that a step has exceeded. */
#include "coupling/control/explain.h"
#include "coupling/control/substeps.h"
#include "coupling/control/time_step.h"
#include "coupling/run.h"

#include <math.h>
#include <stdio.h>

void explain_abort(struct run *r, double dt, int substeps, char *text, size_t size) {
    const char *name = "nothing"; /* a solid without bonds has no limit */
    double most = 0, stable = INFINITY;
    int of_solid = 0;
    if (r->fluid) {
        const struct fluid_limits l = fluid_limits_stable_step(r->fluid);
        const int diffuses = l.viscous <= l.convective || dt > l.viscous; /* then the speeds are the consequence */
        name = time_step_bound_name[diffuses ? STEP_BOUND_DIFFUSION : STEP_BOUND_CONVECTION];
        stable = dt > l.viscous ? l.viscous : l.step;
        most = stable > 0 ? dt / stable : INFINITY;
    }
    if (substeps > 0) {
        substeps_wanted(r);
        of_solid = dt / substeps > most * r->solid_stable;
        if (of_solid) {
            name = solid_stable_bound_name[r->solid_bound];
            stable = r->solid_stable;
            most = dt / substeps / stable;
        }
    }
    const double step = of_solid ? dt / substeps : dt;
    const char *what = of_solid ? "solid's substep" : "step";
    if (!isfinite(stable))
        snprintf(text, size, "nothing limits the %s of %.4g s in the last good state", what, step);
    else if (!(stable > 0))
        snprintf(text, size, "no %s is short enough for %s: its limit is 0 s", what, name);
    else if (most <= 1)
        snprintf(text, size,
                 "no limit of the last good state was exceeded: the %s of %.4g s is %.3g of what %s would allow", what,
                 step, most, name);
    else if (of_solid)
        snprintf(text, size, "the %s of %.4g s is %.3g times what %s would allow, %.4g s: %.0f substeps would do", what,
                 step, most, name, stable, ceil(dt / (run_stage(r)->safety * stable)));
    else
        snprintf(text, size, "the %s of %.4g s is %.3g times what %s would allow, %.4g s", what, step, most, name,
                 stable);
}
