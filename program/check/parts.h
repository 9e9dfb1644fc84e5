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

/* Prints a sentence for each size that is less than docs/choosing.md asks for: walls, holes, cracks, bodies that
 * collide, the horizon of the bilinear law; and for a sphere that starts from rest in a fluid whose viscous layer stays
 * below a cell. Prints nothing where all are large enough or the solid does not deform. seconds: simulated time of the
 * run, as far as it is known. Not collective: rank 0 prints. */
void check_sizes_print(const struct run *r, double seconds);

/* Prints how much of the fluid beside bodies on the lattice, images apart, is in gaps of fewer than three cells, if
 * that is a twentieth or more. Collective. */
void check_gaps_print(const struct scene *scene);

/* For each body, or bodies that interfaces join: prints the estimated stress by its loads and prescribed motions, the
 * stress at which it breaks, and their ratio. from, to: the time in which the solid moves, s, as far as it is known;
 * loads and motions count with what they are in it. Prints nothing if bonds do not break. Rank 0 prints. Collective. */
void check_strength_print(struct run *r, double from, double to);

enum { FLOW_LOAD_SENTENCE = 160 };
struct flow_load {
    double per_volume[3];              /* on the solid in the domain, N/m3 */
    double force;                      /* on all of it, N; 0: none can be estimated */
    double pressure;                   /* force over the frontal area of the solid, Pa */
    char sentence[FLOW_LOAD_SENTENCE]; /* what the estimate is based on */
};
/* The greater of two estimates: the pressure difference or body force that drives the flow along a direction, times the
 * domain's cross-section, which is an upper bound; and the drag at the scene's velocity, of grains
 * (physics/packed_drag.h) or of a blunt body in the remaining cross-section. Collective. */
struct flow_load flow_load_of(const struct run *r);

/* Prints the number of samples and solutions, their memory and time, and warns if that is much of the run's time.
 * seconds: time of the run without them, 0: not known; measured: takes the first sample. Prints nothing without
 * output.permeability_every. Collective. */
void check_intrinsic_print(struct run *r, double seconds, int measured);
/* Prints memory and time of frana permeability for so many pore cells: on the scene's grid, and on one twice as fine.
 */
void check_intrinsic_print_at_once(double pores, const char *others);
/* The same for a run with a rigid solid, from the particles' volume. Collective. */
void check_intrinsic_print_rigid(const struct run *r);

/* Prints what the scene's images hold, and writes pictures of their slices. Returns the particles of the bodies of
 * images. Collective. */
double check_image(const struct command *c, const struct scene *scene);
