/* The loads that the input gives, as forces per unit volume. Inside the room, and for the coupling. */
#pragma once
#include "solid/body/sites.h"

struct solid_given;

/* Adds the boundary from one point to the other by number in the body's cloud, m; returns 0 where it does not run so.
 */
typedef int solid_edge_load_lengths(const struct solid *s, int body, const double from[2], const double to[2],
                                    double *length);

/* s->given: the input's loads on the owned particles, added to s->load as they are at s->t; NULL where there are none.
 * Dies (exit 2) on one that no particle takes up. sites: of the bodies; NULL once they are gone, when clouds say where
 * particles are, by of_cloud. Collective. */
void solid_given_new(struct solid *s, struct solid_sites *const *sites, solid_edge_load_lengths *of_cloud);
void solid_given_free(struct solid_given *given);
/* s->load: the mean over t .. t + dt (dt = 0: as at t) in place of what it held of them. Returns whether that differs.
 * Not collective. */
int solid_given_set(struct solid *s, double t, double dt);
/* They are no longer in s->load, which somebody else has set: to be called before the next solid_given_set. Not
 * collective. */
void solid_given_forget(struct solid *s);
/* The factors that s->load holds them with, factor [s->in.loads]; and what s->load is said to hold of them: put back
 * with it. Not collective. */
void solid_given_keep(const struct solid *s, double *factor);
void solid_given_restore(struct solid *s, const double *factor);
/* Sets mark [n] to 1 where a load is taken up. Not collective. */
void solid_given_mark(const struct solid *s, uint8_t *mark);
/* What s->load holds of them for particle h in direction c, N/m3. */
double solid_given_of(const struct solid *s, int h, int c);
