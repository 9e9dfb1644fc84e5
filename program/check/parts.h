/* The parts of frana check. */
#pragma once
#include "coupling/run.h"
#include "program/command/command.h"

struct costs;

/* Prints the stable steps of fluid and solid and, for each stage, its steps and parts; adds its costs. Collective. */
void check_limits_print(struct run *r, struct costs *costs);

/* Prints what a run holds and leaves out, with warnings on lattice points on surfaces, particles that are too near and
 * bodies outside the domain. Collective. */
void check_holdings_print(struct run *r);

/* Warns of bodies that stand close before a side through which the flow leaves. Collective. */
void check_outlet_print(const struct run *r);

/* Prints a sentence for each size that is less than docs/choosing.md asks for: walls, holes, cracks, bodies that
 * collide, the horizon of the bilinear law. Prints nothing where all are large enough or the solid does not deform. Not
 * collective: rank 0 prints. */
void check_sizes_print(const struct run *r);

/* For each body, or bodies that interfaces join: the stress that its loads and prescribed motions will about make, the
 * stress at which it breaks, and the factor between them. seconds: of the run, as far as they are known. Nothing in a
 * run in which bonds do not break. Rank 0 prints. Collective. */
void check_strength_print(struct run *r, double seconds);

enum { FLOW_LOAD_SENTENCE = 160 };
struct flow_load {
    double per_volume[3];              /* on the solid in the domain, N/m3 */
    double force;                      /* on all of it, N; 0: there is none that can be foreseen */
    double pressure;                   /* over the area of the solid as the flow sees it, Pa */
    char sentence[FLOW_LOAD_SENTENCE]; /* from what it follows */
};
/* The greater of two: what drives the flow along a direction (pressures of its two sides, a gradient, a body force)
 * times the domain's section, which the solid takes at most; the drag at the scene's velocity, as of grains
 * (physics/packed_drag.h) or of a blunt body in what is left of the section. Collective. */
struct flow_load flow_load_of(const struct run *r);

/* Prints the regime of the injection, and a warning for each of these that the scene has: a notch through a row of
 * particles, a tip that runs with inertia, a net pressure that breaks the notch's faces, a confining stress, a lag that
 * the spacing does not resolve. Prints nothing without crack_fluid. Collective. */
void check_injection_print(const struct run *r);

/* Prints samples, solutions, memory and time, and warns where that is much of the run's time. seconds: of the run
 * without it, 0: not known; measured: the first sample is taken here. Nothing without output.permeability_every.
 * Collective. */
void check_intrinsic_print(struct run *r, double seconds, int measured);
/* Prints what frana permeability would take of so many pore cells: on the scene's grid, and on one twice as fine. */
void check_intrinsic_print_at_once(double pores, const char *others);
/* The same of a run whose solid is rigid, by the particles' volume. Collective. */
void check_intrinsic_print_rigid(const struct run *r);

/* Prints what the scene's images hold, and writes pictures of their slices. Returns the particles of the bodies of
 * images. Collective. */
double check_image(const struct command *c, const struct scene *scene);
