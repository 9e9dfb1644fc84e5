/* Outlets: wet particles at which the cracks are open to a fluid outside, whose pressure is given.
 *
 * An outlet is joined to the fluid outside by a conductance G, so that fluid enters at the rate Q = G (p_out - p). The
 * outside is p_out = p_flow + Q_last/G, with p_flow the pressure that was read and Q_last the mean rate of the last
 * step: 1/G is the inertia of the fluid before the outlet over the step. So a change of the rate costs pressure, and at
 * a steady rate p is p_flow. The outside has at least the least pressure, so that nothing leaves a void. */
#pragma once
#include "cracks/cracks.h"

struct cracks_outlets {
    int n, capacity;
    int *h;              /* [n] local index in the solid, ascending */
    double *rate;        /* [n] that entered in the last step, m3/s */
    double *pressure;    /* [n] p_out, Pa */
    double *conductance; /* [n] G, m3/(s Pa) */
    double *volume;      /* [n] that has entered in the present step, m3 */
    double *storage;     /* [n] work: S_h without the outlet, m3/Pa */
    double *gain; /* [the solid's n] what particles got in the present or last step, through outlets and links, m3 */
};

struct cracks_outlets *cracks_outlet_new(const struct solid *s);
void cracks_outlet_free(struct cracks_outlets *m);
/* Whether the particle h may be an outlet: it has a strut. The strut may be off: then fluid flows through the particle
 * to struts that are on. Not collective. */
int cracks_outlet_is_wet(const struct cracks *c, int h);
/* The outlets of the coming step. flow [n] p_flow, Pa. Particles that are outlets already keep their rate. Not
 * collective. */
void cracks_outlet_set(struct cracks *c, int n, const int *h, const double *flow, const double *conductance);
/* Room for n outlets; values are kept. Not collective. */
void cracks_outlet_reserve(struct cracks_outlets *m, int n);

/* Of an outlet of the last step, m3/s; 0: the particle was none. Not collective. */
double cracks_outlet_rate(const struct cracks_outlets *m, int h);

/* In a substep. begin adds dt G to the storage and source adds dt G p_out to the source [n], m3, so that the solution
 * for the pressures includes the outlets. end subtracts dt G from the storage again; fill adds the volume that has
 * entered to the content. Not collective. */
void cracks_outlet_begin(struct cracks *c, double dt);
void cracks_outlet_source(const struct cracks *c, double dt, double *source);
void cracks_outlet_end(struct cracks *c);
void cracks_outlet_fill(struct cracks *c, double dt);
/* After a step of length dt: the rates, and c->entered. Collective. */
void cracks_outlet_end_step(struct cracks *c, double dt);
