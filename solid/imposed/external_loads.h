/* The loads of the input, as forces per unit volume. For solid/ and for the coupling. */
#pragma once
#include "solid/body/sites.h"

struct solid_external_loads;

/* Adds to length, by number in the body's cloud, each particle's part of the outline between two points, m. Returns 0
 * if the outline has no edge from one to the other. */
typedef int solid_edge_load_lengths(const struct solid *s, int body, const double from[2], const double to[2],
                                    double *length);

/* Sets s->external_loads to the input's loads on the owned particles, and adds their values at s->t to s->load; NULL if
 * the input has no load. Dies (exit 2) on a load that no particle takes up. sites: the lattice sites of the bodies,
 * from which edges find their particles; NULL after a refinement, when of_cloud finds them. Collective. */
void solid_external_loads_new(struct solid *s, struct solid_sites *const *sites, solid_edge_load_lengths *of_cloud);
void solid_external_loads_free(struct solid_external_loads *g);
/* Replaces the loads' part of s->load by its mean over t .. t + dt (dt = 0: the value at t). Returns whether it has
 * changed. Not collective. */
int solid_external_loads_update(struct solid *s, double t, double dt);
/* To be called after s->load was overwritten: the loads are then no longer in it. Before the next
 * solid_external_loads_update. Not collective. */
void solid_external_loads_invalidate(struct solid *s);
/* Clears s->load where the input has loads, which the next update adds; what else acts sets its own part again. Not
 * collective. */
void solid_external_loads_restart(struct solid *s);
/* The factors of the loads in s->load, factor [s->in.loads]; and their restoration together with s->load. Not
 * collective. */
void solid_external_loads_save(const struct solid *s, double *factor);
void solid_external_loads_restore(struct solid *s, const double *factor);
/* Sets mark [n] to 1 for particles with a load. Not collective. */
void solid_external_loads_mark(const struct solid *s, uint8_t *mark);
/* The factor of load k in s->load. */
double solid_external_loads_factor(const struct solid *s, int k);
/* This rank's share of load k: its force at a factor of 1, N, and its particles with the sum of volume times
 * displacement, m4. Not collective. */
struct solid_external_loads_sum {
    int particles;
    double volume, force[3], moved[3];
};
struct solid_external_loads_sum solid_external_loads_sum_of(const struct solid *s, int k);
/* The loads' part of s->load for particle h in direction c, N/m3. */
double solid_external_loads_on(const struct solid *s, int h, int c);
