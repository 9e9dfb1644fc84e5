/* The end of a stage that has a duration. */
#pragma once

struct run;

/* 1: the present stage has reached its duration. Not collective. */
int duration_is_over(const struct run *r);
/* 1: the next step may reach it. Not collective. */
int duration_may_end(const struct run *r);
/* A part of the step: shortens the step where it would go beyond the stage's end. An automatic step that would leave a
 * short rest is half of what is left. */
void duration_shorten_step(struct run *r);
/* The number of steps that the present stage will have taken at its end, if all that come are as long as the present
 * one: its `steps`, or those that its duration takes. Not collective. */
long duration_steps(const struct run *r);
