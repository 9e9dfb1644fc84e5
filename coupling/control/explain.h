/* The limit that a step has exceeded, in words. */
#pragma once
#include <stddef.h>

struct run;

/* Describes which limit a step of dt with its substeps exceeds in the present state, and which step would be stable;
 * else how near it is to the nearest limit. Collective. */
void explain_abort(struct run *r, double dt, int substeps, char *text, size_t size);
