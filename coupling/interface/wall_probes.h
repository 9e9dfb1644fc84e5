/* Probes at the solid's wetted faces: where pressure and stress of the flow are read for the loads. */
#pragma once
#include "solid/imposed/added_mass.h"

#include <stdint.h>

struct run;

/* One probe for each particle of the surface with bonds, two for a wall wetted on both faces. Work arrays, computed
 * from the state; none for a load that no probe reads. */
struct wall_probes {
    int n, capacity;
    int *owner;                              /* [n] index in the surface */
    int *particle;                           /* [n] its particle */
    double *root[3], *normal[3];             /* [n] m; outward unit normal */
    double *acceleration_n;                  /* [n] dV/dt . n at the root, m/s2 */
    double *traction[3], *pressure;          /* [n] Pa */
    uint8_t *active;                         /* [n] 0: its tip stands outside the domain */
    double *added;                           /* [n] added mass, kg per m3 of the particle */
    double *lost, *lost_before, *moved_from; /* [n] work of the added mass */
    double work;                             /* of the loads in the last step, J, this rank's share */
    struct solid_added_mass added_mass;      /* the same for the solid, pointing here */
};

/* Sets roots, normals, velocities, accelerations and added masses of r->probes from the surface's present state. Not
 * collective. */
void wall_probes_update(struct run *r);
void wall_probes_free(struct wall_probes *p);
/* Added mass that a particle carries over what the probe's formula says. */
extern const double wall_probes_carried_more;
