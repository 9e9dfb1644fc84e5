/* The number of the solid's substeps in a step. */
#pragma once
#include "solid/contact/contact.h"
#include "solid/state.h"

struct run;

enum { SUBSTEPS_MAX = 1000000 };

/* 1: the stage's solid has substeps, and their number is automatic. Not collective. */
int substeps_are_automatic(const struct run *r);
/* A part of the step: sets the number from the solid's limits. Collective. */
void substeps_choose(struct run *r);
/* The least number that is stable with the present contact, with the stage's safety. Collective. */
int substeps_wanted(struct run *r);

/* For the acceptance of a step: */
/* The least number, with the speed of the fastest particle of all ranks, m/s; the search of contact's rate ends once
 * `enough` is true, NULL: with the best bound. Sets the stable step. Collective. */
int substeps_for(struct run *r, double fastest, solid_contact_enough *enough);
/* The fewest that an automatic number is in the present stage, whatever is stable. Not collective. */
int substeps_fewest(const struct run *r);
/* Whether the present number is stable with contact of this rate. Not collective. */
int substeps_suffice(const void *run, double contact);
/* Whether the number depends on the particles' speed. Not collective. */
int substeps_need_speed(const struct run *r);
/* Whether bodies that are still apart cannot come near each other within the next step, with the speed of the fastest
 * particle of all ranks, m/s. Not collective. */
int substeps_may_skip(const struct run *r, double fastest);
/* Speed of this rank's fastest particle, m/s. */
double substeps_fastest(const struct solid *s);
/* Sets the number, and logs it. Not collective. */
void substeps_set(struct run *r, int substeps);
