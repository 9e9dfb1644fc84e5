/* Symmetric tensors [6] as xx yy zz xy yz zx; as many at once as a vec has lanes, if they are vec. */
#pragma once
#include "base/vec_type.h"

/* Eigenvalues in no order; vector[k] is the unit eigenvector of value[k]. By Jacobi rotations. */
void solid_tensors_turn(const vec t[6], vec value[3], vec vector[3][3]);
/* value[3], largest first. */
void solid_tensors_eigen(const double t[6], double value[3], double vector[3][3]);
/* Pseudo-inverse of a positive semi-definite tensor: eigenvalues below `small` times the largest count as zero. */
void solid_tensors_inverse(const vec t[6], double small, vec inverse[6]);
void solid_tensors_largest(int n, double (*t)[6], double *largest); /* the largest principal value of each of n tensors.
                                                                     * Not collective. */
/* All principal values of each of n tensors, largest first. Not collective. */
void solid_tensors_sorted(int n, double (*t)[6], double (*value)[3]);
double solid_tensors_von_mises(const double t[6]);
