/* Times of loads, constraints and injections that count from the start of a stage. */
#pragma once

struct run;

/* At the start of a stage, or when a run is resumed within it: stores the time at which the stage began, and sets
 * the origins of all times. Not collective. */
void origins_set(struct run *r);
