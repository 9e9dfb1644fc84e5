/* The time over which the surface's acceleration is taken. */
#include "coupling/interface/acceleration.h"

double acceleration_time(const struct run *r) {
    const double last = r->dt_last > 0 ? r->dt_last : r->dt;
    return r->strong ? 0.5 * (last + r->dt) : last;
}
