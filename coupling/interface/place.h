/* Where a particle stands in the fluid's domain. */
#pragma once

struct run;

/* Whether particle h stands in the domain. Not collective. */
int place_is_inside(const struct run *r, int h);
