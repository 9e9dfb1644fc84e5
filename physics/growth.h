/* How fast a length grows that is known at single times, when it sticks and slips. */
#pragma once

/* The speed up to sample i: over the shortest time before it in which the length has grown by `advance`; 0: it has not
 * since sample 0. t s, length m: ascending, [i + 1]. first: 0 before the first call, then samples in their order. */
double physics_growth_speed(const double *t, const double *length, long i, double advance, long *first);
