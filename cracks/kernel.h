/* Sums over struts and links, by rows of eight particles (cracks/rows.h). Pure.
 *
 * first  [rows]  place of lane 0             start, end  [rows]  entries of a row
 * Arrays "by place" are read at first + lane and at entry.at + lane, for lanes without a strut too: there they hold any
 * number. Arrays "by slot" have 8 row + lane as index. */
#pragma once
#include <stdint.h>

/* x, y, z and 0; z of a plate is 0. */
typedef double cracks_vec __attribute__((vector_size(32)));

enum { CRACKS_LANES = 8 };

/* Struts of one kind, or links in one direction, of a row's particles: where bit k of lanes is set, from lane k to the
 * place at + k. Struts that are switched off (cracks/resolved.h) have their bits in off instead; no sum reads them. */
struct cracks_entry {
    int at;
    uint16_t kind;
    uint8_t lanes, off;
};

static inline double cracks_kernel_sum(cracks_vec v) { return (v[0] + v[1]) + (v[2] + v[3]); }

/* F = B p: the force on each wet particle.
 *     F_h = -sum over struts of omega (p_h + p_l)/2 xi/|xi|
 * half  [kinds]     omega xi/(2 |xi|)  m2
 * p     [by place]  Pa                    force  [3][by slot]  N, written */
void cracks_kernel_force(int rows, const int *first, const long *start, const long *end,
                         const struct cracks_entry *entry, const cracks_vec *half, const double *p,
                         double *const force[3]);
/* u = factor M^-1 B p, the same force as a displacement of the rows' lanes; factor s2
 * mobility  [3][by slot]  1/kg, 0 in lanes without an owned wet particle          u  [3][by place]  m, written */
void cracks_kernel_push(int rows, const int *first, const long *start, const long *end,
                        const struct cracks_entry *entry, const cracks_vec *half, double factor,
                        double *const mobility[3], const double *p, double *const u[3]);
/* v = B^T u: the crack volume of each wet particle.
 *     v_h = sum over struts of omega/2 (u_l - u_h).xi/|xi|
 * u     [3][by place]  m                  volume  [by slot]  m3, written */
void cracks_kernel_volume(int rows, const int *first, const long *start, const long *end,
                          const struct cracks_entry *entry, const cracks_vec *half, double *const u[3], double *volume);
/* T_hl = both + factor (A_h + A_l) ((w_h + w_l)/2)^3 of the links, and its sum over a particle's links.
 * area, width  [by place]  m2, m
 * conductance  [links][8]  m3/(s Pa), written; 0 in lanes without a link           total  [by slot], written */
void cracks_kernel_conductance(int rows, const int *first, const long *start, const long *end,
                               const struct cracks_entry *link, double both, double factor, const double *area,
                               const double *width, double *conductance, double *total);
/* T_hl = min(T_hl, most_h + most_l), and 0 unless both ends are open; recomputes its sum over a particle's links.
 * most, open  [by place]  m3/(s Pa); 1 or 0        conductance, total  as above */
void cracks_kernel_bound(int rows, const int *first, const long *start, const long *end,
                         const struct cracks_entry *link, const double *most, const double *open, double *conductance,
                         double *total);
/* y_h = sum over links of T_hl (p_h - p_l).  p [by place] finite;  y [by slot], written */
void cracks_kernel_flow(int rows, const int *first, const long *start, const long *end, const struct cracks_entry *link,
                        const double *conductance, const double *p, double *y);
/* The first term of Chebyshev's iteration from 0:  change = z = factor D^-1 residual.  Arrays as below. */
void cracks_kernel_scale(int rows, const int *first, double factor, const double *residual, const double *inverse,
                         double *change, double *z);
/* A term of Chebyshev's iteration for (D - dt T) z = r:
 *     change = keep change + gain (D^-1 (r + dt T z) - z),   next = z + change
 * residual, inverse = D^-1, change  [by slot]; where they are 0, z stays 0
 * conductance  [links][8]  in single precision          z, next  [by place], next of the rows' lanes */
void cracks_kernel_relax(int rows, const int *first, const long *start, const long *end,
                         const struct cracks_entry *link, const float *conductance, double dt, double keep, double gain,
                         const double *residual, const double *inverse, const double *z, double *change, double *next);
