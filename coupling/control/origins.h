/* Times of loads, constraints and injections that count from the start of a stage. */
#pragma once

struct run;
struct scene;

/* 1: some time of the scene counts from a stage's start. Not collective. */
int origins_are_used(const struct scene *scene);
/* At the start of a stage, or when a run is resumed within it: stores the time at which the stage began, and sets
 * the origins of all times. Not collective. */
void origins_set(struct run *r);
