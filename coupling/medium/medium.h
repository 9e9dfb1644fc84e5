/* Measurements on a porous medium: a box of the domain, the solid fraction of every cell, and the flow through the box.
 * It is measured along a direction, x until another is given (medium_along). Along an axis the front face is the box's
 * low face across it, the back face its high one.  (001: sec. 2.1) */
#pragma once
#include "fluid/fluid.h"

struct medium; /* opaque: the box, the solid fraction, work */

struct medium_values {
    double porosity;           /* 1: void / total volume of the box */
    double porosity_effective; /* 1: void that connects the front and the back / total volume */
    double pressure_drop;      /* Pa, front minus back */
    double mean_velocity[3];   /* m/s, mean over the whole box, solid included (medium_pores_only) */
    double velocity;           /* m/s, its component along the direction: Q/S */
    double permeability;       /* m2, (Q L/S) mu/dp, L the box's extent along the direction e (001: eq. 2.4); NaN while
                                * there is no pressure drop */
    double reynolds;           /* 1: |velocity| sqrt(permeability)/nu */
    double tortuosity;         /* 1, <|u|>/<|u.e|> over the box's pore cells, velocities at centres (001: eq. 2.7); NaN
                                * if there is no mean flow along e beyond round-off */
    double specific_surface;   /* 1/m: immersed area / volume of the box */
};

/* The box is clipped to the domain; g is borrowed. There is no solid until the first deposit. Collective. */
struct medium *medium_new(const struct fluid_grid *g, const double low[3], const double high[3]);
void medium_free(struct medium *m);
/* Frees what only another deposit reads: the solid will not move. Not collective. */
void medium_freeze(struct medium *m);
/* The direction along which the flow is measured, a vector of any length. Of a slanted one, p has no part in the drop,
 * which is the driving's over the box's extent along it: so the box must be a whole period in all directions in which
 * it has a component (medium_is_whole_period). Connected pores are those along its largest component. Not
 * collective. */
void medium_along(struct medium *m, const double along[3]);
int medium_axis(const struct medium *m); /* of its largest component. Not collective. */
/* 1: direction c is periodic, and the box is the whole domain along it. Not collective. */
int medium_is_whole_period(const struct medium *m, int c);
/* The box's extent along that direction, m. Not collective. */
double medium_extent(const struct medium *m);
/* 1: the box is as wide as the domain across the largest component, so that the fluid must go through it. Not
 * collective. */
int medium_is_across(const struct medium *m);
/* From now on only the flow through pore cells counts as the medium's. Not collective. */
void medium_pores_only(struct medium *m);
/* How far the force on the fluid may reach beyond the box's front and back faces, in cells; 1 by default. Not
 * collective. */
void medium_reach(struct medium *m, double cells);

/* Computes the solid fraction of every cell from the particles. Each particle is a cube of its volume about its centre,
 * with its sides along the axes; a cell gets the volume that it has in common with the cube. So the total volume is
 * conserved, and particles on the grid's own lattice give exactly 0 or 1. The particles may be on any rank. They are
 * wrapped in periodic directions; parts outside the domain are dropped. Overlapping cubes add up, also beyond 1. x
 * [3][n] m, volume [n] m3. Collective. */
void medium_deposit(struct medium *m, int n, const double *const x[3], const double *volume);

/* [nz+2h][ny+2h][nx+2h] centres, as fluid/grid/grid.h, one ghost layer filled; 1. Borrowed, until the next deposit. */
const double *medium_fraction(const struct medium *m);

/* The same with each particle's volume spread by the forcing's kernel about its centre, in place of a cube: how a force
 * on its volume acts on the fluid. Borrowed; a second call
 * sets the same array. Collective. */
const double *medium_spread(struct medium *m, int n, const double *const x[3], const double *volume);

/* A cell on the box's boundary counts with its part inside the box. All of these are collective, with the same result
 * on every rank. A pore cell is less than half solid. */

/* 1 - sum(fraction)/sum(1) over the box. */
double medium_measure_porosity(const struct medium *m);
/* Connected porosity: the pore cells connected to both the front and the back face through faces of pore cells within
 * the box (also across periodic sides across the axis). Each counts with its void, 1 - fraction, as in the porosity. */
double medium_connect_porosity(struct medium *m);
/* Fraction of the cells along side d, high that have no path through faces of pore cells to any of the outlets. Paths
 * use the whole domain and its periodic sides; across: those of direction d as well. */
double medium_cut_off(struct medium *m, int d, int high, const int outlets[3][2], int across);
/* Gives the cells that the last deposit fills by half or more the velocity v, m/s.
 * velocity [3] arrays as fluid/grid/grid.h, centres, zero elsewhere; one ghost layer is filled */
void medium_closed_mark(const struct medium *m, const double v[3], double *const velocity[3]);
/* The connected parts of the pore cells that have no path to an outlet: what moving solid at their faces displaces into
 * them. After the solid's deposit. velocity [3] as mark leaves it. Returns their number, the same on every rank;
 * *part is to be freed with memory_free. */
struct medium_part {
    double volume; /* of its cells, m3 */
    double rate;   /* displaced into it, m3/s; < 0: drawn from it */
    double faces;  /* the sum of the faces' magnitudes, m3/s */
};
long medium_closed_parts(struct medium *m, const int outlets[3][2], const double *const velocity[3],
                         struct medium_part **part);
/* Half of the magnitudes of all faces of moving solid, m3/s; *net: the sum with signs, what it displaces less what it
 * draws. */
double medium_closed_fronts(const struct medium *m, const double *const velocity[3], double *net);
/* Whether the solid in the box is connected from its low to its high face along direction d; endless: it goes on
 * through the periodic sides there, and the box is the whole period. */
enum medium_span { MEDIUM_SPAN_NONE, MEDIUM_SPAN_BOX, MEDIUM_SPAN_ENDLESS };
enum medium_span medium_spans(struct medium *m, int d);
/* Mean pressure at the front face minus that at the back face, from means over whole sections of the domain. Each
 * face's pressure is the line through the two nearest places outside the box where it is known, continued to the face.
 * These are the sections that the force on the fluid does not reach (medium_reach), across a periodic end as well, and
 * after the last of them a side of given pressure. One place: its pressure, with the driving. None, and the axis is
 * periodic: the whole period's driving is the drop. None, and the side gives no pressure: the domain's outermost
 * section if it is outside the box; otherwise the line through the outermost two, which is only an estimate, because
 * they are in the medium. The driving along the axis that p does not contain, a gradient and a body force, is added
 * over the box's length. If the axis is periodic and the box is the whole domain along it, only this driving counts. */
double medium_measure_pressure_drop(struct medium *m, struct fluid *f);
double medium_measure_specific_surface(const struct medium *m, double immersed_area);

/* All of these at once. */
struct medium_values medium_measure(struct medium *m, struct fluid *f, double immersed_area);
