/* Mouths: wet particles at which the cracks are open to a fluid outside, whose pressure is given.
 *
 * A mouth is joined to the fluid outside by a conductance G, so that fluid enters at the rate Q = G (p_out - p). The
 * outside is p_out = p_flow + Q_last/G, with p_flow the pressure that was read and Q_last the mean rate of the last
 * step: 1/G is the inertia of the fluid before the mouth over the step. So a change of the rate costs pressure, and at
 * a steady rate p is p_flow. The outside has at least the least pressure, so that nothing leaves a void. */
#pragma once
#include "cracks/cracks.h"

struct cracks_mouths {
    int n, room;
    int *h;              /* [n] local index in the solid, ascending */
    double *rate;        /* [n] that entered in the last step, m3/s */
    double *pressure;    /* [n] p_out, Pa */
    double *conductance; /* [n] G, m3/(s Pa) */
    double *volume;      /* [n] that has entered in the present step, m3 */
    double *storage;     /* [n] work: S_h without the mouth, m3/Pa */
    double *gain; /* [the solid's n] what particles got in the present or last step, through mouths and links, m3 */
};

struct cracks_mouths *cracks_mouth_new(const struct solid *s);
void cracks_mouth_free(struct cracks_mouths *m);
/* Whether the particle h may be one: it has a strut, be it off: then fluid flows through it to struts that are on. Not
 * collective. */
int cracks_mouth_is_wet(const struct cracks *c, int h);
/* The mouths of the coming step. flow [n] p_flow, Pa. Particles that are mouths already keep their rate. Not
 * collective. */
void cracks_mouth_set(struct cracks *c, int n, const int *h, const double *flow, const double *conductance);
/* Room for n mouths; values are kept. Not collective. */
void cracks_mouth_room(struct cracks_mouths *m, int n);

/* Of a mouth of the last step, m3/s; 0: the particle was none. Not collective. */
double cracks_mouth_rate(const struct cracks_mouths *m, int h);

/* In a substep. The first adds dt G to the storage, the second dt G p_out to the source [n], m3; so the pressures are
 * found with the mouths. The third takes the storage back, the fourth books what has entered. Not collective. */
void cracks_mouth_begin(struct cracks *c, double dt);
void cracks_mouth_source(const struct cracks *c, double dt, double *source);
void cracks_mouth_end(struct cracks *c);
void cracks_mouth_fill(struct cracks *c, double dt);
/* After a step of length dt: the rates, and c->entered. Collective. */
void cracks_mouth_settle(struct cracks *c, double dt);
