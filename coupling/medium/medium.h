/* What is measured on a porous medium: a box of the domain, the solid's share of every cell, and the flow through it.
 * The mean flow is along x; the front face is the box's x_low, the back face its x_high.  (001: sec. 2.1) */
#pragma once
#include "fluid/fluid.h"

struct medium; /* opaque: the box, the solid fraction, work */

struct medium_values {
    double porosity;           /* 1: void / total volume of the box */
    double porosity_effective; /* 1: void that joins the front to the back / total volume */
    double pressure_drop;      /* Pa, front minus back */
    double velocity;           /* m/s, mean of u over the whole box, solid included: Q/S */
    double permeability;       /* m2, NaN while there is no pressure drop */
    double tortuosity;         /* 1, NaN while nothing flows */
    double specific_surface;   /* 1/m: immersed area / volume of the box */
};

/* The box is cut to the domain; g is borrowed. The medium is empty until something is deposited. Collective. */
struct medium *medium_new(const struct fluid_grid *g, const double low[3], const double high[3]);
void medium_free(struct medium *m);

/* The solid's share of every cell, anew, from the particles: each is a cube of its volume about its centre, its sides
 * along the axes, and gives each cell their common volume. So the volume is kept, and particles on the grid's own
 * lattice give exactly 0 or 1. Particles may be any rank's; they are wrapped in periodic directions; what stands out of
 * the domain is dropped. Cubes that overlap add up, beyond 1 if they must. x [3][n] m, volume [n] m3. Collective. */
void medium_deposit(struct medium *m, int n, const double *const x[3], const double *volume);

/* [nz+2h][ny+2h][nx+2h] centres, as fluid/grid/grid.h, one ghost layer filled; 1. Borrowed, until the next deposit. */
const double *medium_fraction(const struct medium *m);

/* A cell on the box's boundary counts with the part of it that is inside. All of these are collective, and the same on
 * every rank. A pore cell is one that is less than half solid. */

/* 1 - sum(fraction)/sum(1) over the box. */
double medium_measure_porosity(const struct medium *m);
/* Connected porosity: pore cells joined to both the front and the back face through faces of pore cells within the box
 * (across periodic sides in y and z too), each counted with its void, 1 - fraction, as porosity counts it. */
double medium_connect_porosity(struct medium *m);
/* Part of the cells along side d, high from which no path through faces of pore cells comes to any of the outlets: in
 * the whole domain, and across its periodic sides; across: those of d too. */
double medium_cut_off(struct medium *m, int d, int high, const int outlets[3][2], int across);
/* Mean pressure at the front face less that at the back face. Means are over whole sections of the domain. At the
 * front, the straight line through the two nearest sections of cells that lie wholly before the box is drawn on to the
 * face; at the back likewise from behind; where the domain has fewer there, through its last two. What drives the fluid
 * along x without standing in p, a given gradient and a body force, is added over the box's length. If x is periodic
 * and the box is all of it, only that counts. */
double medium_measure_pressure_drop(struct medium *m, struct fluid *f);
/* k = (Q L/S) mu/dp, Q/S = mean of u over the box  (001: eq. 2.4). */
double medium_measure_permeability(struct medium *m, struct fluid *f);
/* <|u|>/<u_x> over the box's pore cells, velocities at centres  (001: eq. 2.7). */
double medium_measure_tortuosity(const struct medium *m, struct fluid *f);
double medium_measure_specific_surface(const struct medium *m, double immersed_area);

/* All of them at once. */
struct medium_values medium_measure(struct medium *m, struct fluid *f, double immersed_area);
