/* Sets markers and probes from the interface, and gives the markers to the forcing. */
#include "coupling/interface/interface.h"
#include "coupling/interface/leaving.h"
#include "coupling/interface/marker_force.h"
#include "coupling/interface/markers.h"
#include "coupling/interface/wall_probes.h"
#include "coupling/run.h"

void interface_update(struct run *r) {
    markers_update(r);
    wall_probes_update(r);
}

void interface_begin_step(struct run *r) {
    interface_update(r);
    marker_force_assign(r);
    ibm_markers_set(r->ibm, r->markers.n, (const double *const *)r->markers.x, (const double *const *)r->markers.v,
                    r->markers.volume);
    leaving_update(r);
}
