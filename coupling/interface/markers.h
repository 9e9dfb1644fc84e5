/* Markers at the solid's interface: where the forcing imposes the solid's velocity on the fluid. */
#pragma once

struct run;
struct solid_attachment;

/* One marker for each particle of the surface. Work arrays, computed from the state. */
struct markers {
    int n, capacity;
    double *x[3], *v[3];   /* [n] position m, velocity m/s: what is demanded of the fluid */
    double (*fraction)[3]; /* [n] p, the fraction of the particles' velocity that v is, and of the force that they get:
                            * 1 away from the sides (ibm_markers_fraction), and for particles without bonds, which have
                            * the drag of a sphere there too */
    double *volume;        /* [n] A_h dx, m3 */
    double *force[3];      /* [n] mean force of the forcing on the fluid over the last step, N */
    double *shift;         /* [n] distance from its particle in the undeformed body, along the outward normal, m */
    struct solid_attachment *attachment; /* weights by which near particles carry the markers; NULL: a marker has the
                                          * velocity of its particle, which takes its force */
};

/* From now on the markers are carried by their particles and those near them (solid/force/attachment.h). */
void markers_attach(struct run *r);
/* Sets r->markers from the surface's present state. Collective. */
void markers_update(struct run *r);
void markers_free(struct markers *m);
