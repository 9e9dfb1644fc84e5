/* The loads of the input, as forces per unit volume. For solid/ and for the coupling. */
#pragma once
#include "solid/body/sites.h"

struct solid_given;

/* Makes s->given: the input's loads on the owned particles, added to s->load with their values at s->t; NULL if there
 * are no loads. Dies (exit 2) on a load without a particle. sites: of the bodies; NULL once these are freed, the clouds
 * then hold the positions. Collective. */
void solid_given_new(struct solid *s, struct solid_sites *const *sites);
void solid_given_free(struct solid_given *given);
/* Replaces the loads' part of s->load by its mean over t .. t + dt (dt = 0: the value at t). Returns whether it has
 * changed. Not collective. */
int solid_given_set(struct solid *s, double t, double dt);
/* To be called after s->load was overwritten: the loads are then no longer in it. Before the next solid_given_set. Not
 * collective. */
void solid_given_forget(struct solid *s);
/* The factors of the loads in s->load, factor [s->in.loads]; and their restoration together with s->load. Not
 * collective. */
void solid_given_keep(const struct solid *s, double *factor);
void solid_given_restore(struct solid *s, const double *factor);
/* Sets mark [n] to 1 for particles with a load. Not collective. */
void solid_given_mark(const struct solid *s, uint8_t *mark);
/* The loads' part of s->load for particle h in direction c, N/m3. */
double solid_given_of(const struct solid *s, int h, int c);
