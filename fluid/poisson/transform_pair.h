/* Periodic, Neumann-Neumann and Dirichlet-Dirichlet transforms of pairs of real lines, each pair as one complex line
 * (fluid/poisson/fourier.h): moves lines, one after another or side by side, to rows of vectors and back. */
#pragma once
#include "fluid/poisson/transform.h"

struct fluid_transform_pair; /* opaque: transform of rows, scratch */

/* NULL if the two ends are of different kinds, or n has a large prime factor. Not collective. */
struct fluid_transform_pair *fluid_transform_pair_new(const struct fluid_transform_input *in);
void fluid_transform_pair_free(struct fluid_transform_pair *t);
void fluid_transform_pair_forward(const struct fluid_transform_pair *t, double *in_place);
void fluid_transform_pair_backward(const struct fluid_transform_pair *t, const double *from, double *to);
