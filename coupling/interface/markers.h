/* Markers at the solid's interface: where the forcing imposes the solid's velocity on the fluid. */
#pragma once

struct run;

/* One marker for each particle of the surface. Work arrays, computed from the state. */
struct markers {
    int n, capacity;
    double *x[3], *v[3]; /* [n] position m, velocity m/s */
    double *volume;      /* [n] A_h dx, m3 */
    double *force[3];    /* [n] mean force of the forcing on the fluid over the last step, N */
};

/* Sets r->markers from the surface's present state. Not collective. */
void markers_update(struct run *r);
void markers_free(struct markers *m);
