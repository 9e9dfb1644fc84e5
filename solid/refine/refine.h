/* Refinement of plates in levels, at the start or while they move.  (000: ch. 2)
 *
 * A refined particle of spacing h keeps its position and gets a cell of side h/2; at those of its eight neighbouring
 * positions at h/2 that have no particle, a new one is made. Coarse particles keep the part of their cell that no finer
 * cell covers (000: eq. 38), so that the areas always add up to the body's. All ranks take the same decisions, from
 * gathered data.
 *
 * Families near a change are made again. A bond that existed keeps its lambda. A new bond is broken if a bond between
 * parents of its ends was (a particle that stays is its own parent, a new one has two or four), or if it crosses an
 * initial crack. No energy is released. So bonds_total and bonds_broken count the bonds of the present families,
 * inherited ones included, and damage is the broken part of the present family. */
#pragma once
#include "solid/state.h"

/* Marks the particles that the triggers select (000: sec. 2.1.1) and refines them with their families (sec. 2.1.2).
 * Returns how many particles were refined; 0: the solid is unchanged. Ghosts must be current. Collective. */
long solid_refine_criteria(struct solid *s);
/* Refines the particles marked by the caller, mark [n]. Collective. */
long solid_refine_marked(struct solid *s, const uint8_t *mark);

int solid_refine_level(const struct solid *s, int h); /* of an owned particle. Not collective. */
int solid_refine_finest(const struct solid *s);       /* the finest level of all bodies. Not collective. */
long solid_refine_events(const struct solid *s);      /* refinements since the solid was made. Not collective. */

/* The data of an owned particle in a checkpoint: its level, and its position and volume in spacings of the cloud. Not
 * collective. */
void solid_refine_restore_save(const struct solid *s, int h, uint8_t *level, double place[3]);
/* Restores the bodies' particles, [n] by global id, the same on every rank; all else is as at the start. Returns 1 if
 * they do not fit the bodies. Collective. */
int solid_refine_restore(struct solid *s, long n, const uint8_t *body, const uint8_t *level, const double (*place)[3]);

/* An upper bound of the largest eigenvalue of the present bonds' stiffness over mass, all bonds counted as intact,
 * 1/s2: twice the largest eigenvalue of a sum of k e e over a family. Collective. */
double solid_refine_rate_bound(const struct solid *s);
/* The largest eigenvalue of an endless lattice of the level's particles, without surface correction, 1/s2; the largest
 * of all bodies. Not collective. */
double solid_refine_rate_lattice(const struct solid *s, int level);

/* For solid_new and solid_free. */
struct solid_refine *solid_refine_new(struct solid_input *in);
void solid_refine_free(struct solid_refine *refine);
void solid_refine_start(struct solid *s); /* Collective. */
