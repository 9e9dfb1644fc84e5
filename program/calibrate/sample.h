/* What is calibrated: a material's bonds without units, and the small scenes that measure them.
 *
 * The effective fracture energy over G0, and a strength over sigma_t or E s0, depend on the model, the horizon over the
 * spacing, the bond law, the micromodulus, the surface correction, the partial volume, Poisson's ratio and E
 * G0/sigma_t^2 over the spacing. So all scenes have E = 1, density = 1, spacing = 1. */
#pragma once
#include "scene/scene.h"

struct calibrate_sample {
    enum physics_model model;
    enum physics_micromodulus micromodulus;
    enum solid_correction correction;
    enum solid_partial partial;
    double m;            /* horizon over spacing */
    double ratio_excess; /* Poisson's ratio less that of bonds alone */
    double length;       /* E G0/sigma_t^2 over spacing; 0: brittle bonds */
    int quick;           /* smaller strips */
};

enum calibrate_kind {
    CALIBRATE_RUNNING,  /* a crack runs through a strained strip between clamps */
    CALIBRATE_DAMPED,   /* the same, slowed by absolute damping: bonds that soften */
    CALIBRATE_CREEPING, /* clamps open a strip as a wedge, in increments of equilibrium: brittle bonds */
    CALIBRATE_SHORTER,  /* a notched plate, relaxed: its strain energy with a notch that is shorter by a spacing */
    CALIBRATE_LONGER,   /* the same, longer by a spacing */
    CALIBRATE_NOTCHED,  /* the notched plate is opened until the notch runs */
    CALIBRATE_BAR       /* a smooth bar is pulled apart */
};

/* One small scene. */
struct calibrate_scene {
    const struct calibrate_sample *sample; /* borrowed */
    enum calibrate_kind kind;
    double degrees; /* of the crack's path from [100] in the plane of [100] and [010]; strips only */
    /* Strips: elastic energy stored ahead of the crack, over G0; of a wedge (1) at the time factor 1. A notch that is
     * opened: the factor of the opening at which the energy release rate is G0. Else 1. */
    double stored;
};

/* Fracture energy of the sample's bonds, with E = spacing = 1: s0 is 2e-3 at any m. */
double calibrate_sample_g0(const struct calibrate_sample *k);

/* Lengths of a scene, in spacings; crack, from and to are along the strip from its left end. */
struct calibrate_sizes {
    int length, height, depth; /* depth: 1 in a plate */
    int clamp;                 /* thickness of the clamped layers, at each side or end */
    double crack, from, to;    /* end of the cut; between from and to the crack is measured */
    double half_opening;       /* of the clamps, at the end or at the time factor 1 */
    double step, damping;      /* of time, spacing/sqrt(E/density), and its inverse */
    int steps, every;          /* between samples */
    double first, increment;   /* time factor at the start, and by which it grows in an increment */
};
struct calibrate_sizes calibrate_sample_sizes(const struct calibrate_scene *c);
