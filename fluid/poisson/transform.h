/* Fast transforms of one direction in which the discrete second difference of cell-centred values is diagonal.
 * Kinds by the pair of conditions at the low and high end (FFTW's names, forward / backward):
 *     periodic R2HC / HC2R;  NN REDFT10 / 01;  DD RODFT10 / 01;  ND REDFT11;  DN RODFT11.     (001: sec. 4.1)
 * For values on the direction's own faces, with zero on both sides' faces: RODFT00 of the n-1 inner ones. A line still
 * has n values; the last one is on the high side: it is zero on input and not written. */
#pragma once

enum fluid_end { FLUID_END_PERIODIC, FLUID_END_NEUMANN, FLUID_END_DIRICHLET, FLUID_END_FACE };

/* FFTW's planning: plans are chosen by measurement. */
#define FLUID_TRANSFORM_PLAN "measure"

struct fluid_transform; /* opaque: a pair of plans for many lines */

/* Eigenvalues [n] of (q[i-1] - 2 q[i] + q[i+1])/d^2 in the order of the transform's output, 1/m2. */
void fluid_transform_eigenvalues(int n, double d, enum fluid_end low, enum fluid_end high, double *lambda);
/* Forward followed by backward multiplies by this. */
double fluid_transform_scale(int n, enum fluid_end low, enum fluid_end high);

struct fluid_transform_input {
    int n; /* values of a line */
    enum fluid_end low, high;
    int lines;
    int stride, distance;         /* between values of a line, between lines; of the array transformed in place */
    int out_stride, out_distance; /* of the array that the backward transform writes; 0: in place */
};

/* Plans by measurement, on scratch memory of its own. Not collective. */
struct fluid_transform *fluid_transform_new(const struct fluid_transform_input *in);
void fluid_transform_free(struct fluid_transform *t);
void fluid_transform_forward(const struct fluid_transform *t, double *in_place);
/* to = from for a transform in place; otherwise from is not changed. */
void fluid_transform_backward(const struct fluid_transform *t, const double *from, double *to);
