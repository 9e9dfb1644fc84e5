/* Symmetric tensors [6] as xx yy zz xy yz zx. */
#pragma once

/* value[3], largest first; vector[k] is the unit eigenvector of value[k]. By Jacobi's rotations. */
void solid_tensors_eigen(const double t[6], double value[3], double vector[3][3]);
/* Pseudo-inverse of a positive semi-definite tensor: eigenvalues below `small` times the largest count as none. */
void solid_tensors_inverse(const double t[6], double small, double inverse[6]);
