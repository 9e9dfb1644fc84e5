/* What steps leave over for the next ones beside the state. */
#pragma once

struct run;

/* Resets what no checkpoint holds and what affects the last digits of the next steps: the form in which each bond
 * was computed, contact's lists, and ghosts that were updated instead of filled. To be called when a checkpoint was
 * written or read: the steps after it are then the same to the bit. Collective. */
void leftover_reset(struct run *r);
