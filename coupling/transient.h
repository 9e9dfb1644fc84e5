/* What steps pass on to later ones but no checkpoint holds. */
#pragma once

struct run;

/* Resets what no checkpoint holds but affects the last digits of later steps: the form in which each bond
 * was computed, contact's lists, and ghosts that were updated instead of filled. To be called after a checkpoint was
 * written or read: the steps after it are then the same to the bit. Collective. */
void transient_reset(struct run *r);
