/* Sums over struts and links. Pure. */
#pragma once
#include <stdint.h>

/* x, y, z and 0; z of a plate is 0. */
typedef double cracks_vec __attribute__((vector_size(32)));

static inline double cracks_kernel_sum(cracks_vec v) { return (v[0] + v[1]) + (v[2] + v[3]); }

/* F = B p: the force on each wet particle.
 *     F_h = -sum over struts of omega (p_h + p_l)/2 xi/|xi|
 * half  [kinds]  omega xi/(2 |xi|)  m2
 * p     [all]    Pa                      force  [n]  N, written */
void cracks_kernel_force(int n, const long *start, const int *other, const uint16_t *kind, const cracks_vec *half,
                         const double *p, cracks_vec *force);
/* v = B^T u: the crack volume of each wet particle.
 *     v_h = sum over struts of omega/2 (u_l - u_h).xi/|xi|
 * u     [all]    m                       volume  [n]  m3, written */
void cracks_kernel_volume(int n, const long *start, const int *other, const uint16_t *kind, const cracks_vec *half,
                          const cracks_vec *u, double *volume);
/* The same with the struts start[i] .. end[i]-1. */
void cracks_kernel_volume_part(int n, const long *start, const long *end, const int *other, const uint16_t *kind,
                               const cracks_vec *half, const cracks_vec *u, double *volume);
/* y_h += factor sum over links of T_hl (p_h - p_l).  conductance [links] m3/(s Pa) */
void cracks_kernel_flow(int n, const int *start, const int *link, const double *conductance, double factor,
                        const double *p, double *y);
