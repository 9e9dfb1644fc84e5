/* The measurements, by subject. For program/bench/ only. Each is collective. */
#pragma once
#include "program/bench/bench.h"
#include "program/bench/row.h"
#include "fluid/fluid.h"
#include "solid/state.h"

struct bench {
    struct bench_repetition repetition;
    int quick; /* 1: small problems, a test that all measurements work */
    int sizes; /* number of sizes given by the user; 0: the standard ones */
    const struct bench_size *size;
    struct bench_table table;
    bench_observer *observe; /* or NULL */
};

/* An element of --sizes: cells of a channel, or particles along the sides of a full block. */
struct bench_size {
    int cells[3]; /* 0: not cells */
    int side;     /* 0: not a block */
};

void bench_limits(struct bench *bench);
void bench_fluid(struct bench *bench);           /* steps, and their parts */
void bench_solid(struct bench *bench);           /* force sweeps */
void bench_plate(struct bench *bench);           /* force sweeps over a plate */
void bench_refine(struct bench *bench);          /* searches for particles to refine, and refinements of a plate */
void bench_solid_peer(struct bench *bench);      /* the sweep that bench/lammps compares */
void bench_immersed(struct bench *bench);        /* the main case: forcing, probe, interface, contact, whole steps */
void bench_cracks(struct bench *bench);          /* fluid that is pumped into a crack */
void bench_memory(struct bench *bench);          /* bytes a cell, a bond, a marker */
void bench_solid_image(struct bench *bench);     /* force sweeps over bodies of images */
void bench_solid_precision(struct bench *bench); /* force sweeps in double and mixed precision */
void bench_solid_dilated(struct bench *bench);   /* force sweeps with the dilatation of any Poisson's ratio */
void bench_memory_image(struct bench *bench);    /* bytes a bond of such a body */
void bench_fluid_growth(struct bench *bench);
void bench_solid_growth(struct bench *bench);

/* A channel with inflow, outflow, walls in y and a periodic span; or periodic along x with a bulk velocity held. */
struct fluid *bench_fluid_new(const int cells[3], int channel);

/* A cubic lattice block in the main case's material. */
struct bench_block {
    int side;            /* sites along each side of a full block; 0: the main case's porous block */
    int half;            /* the porous block's small version */
    int image;           /* the same particles as an image of one site a voxel */
    int list;            /* lists of bonds instead of the lattice store */
    int mixed;           /* in mixed precision */
    double ratio;        /* horizon / spacing, 0: 3 */
    double ratio_excess; /* Poisson's ratio less that of bonds alone */
};
struct solid *bench_solid_block_new(const struct bench_block *in);

/* Sets displacements with stretches of about 1e-4, which break no bond. */
void bench_sweep_strain(struct solid *s);
/* A force sweep with its exchange of ghosts; solid: a struct solid. */
void bench_sweep(void *solid);
/* A row of times for each directed bond of a solid. Collective. */
struct bench_row bench_sweep_row(const char *part, const struct solid *s, struct bench_sample time);
/* A strained plate in plane stress, 1 mm thick, of particles 1 mm apart. Collective. */
struct solid *bench_sweep_plate(int outlines, const struct solid_outline *outline,
                                const struct solid_material *material, const struct solid_refinement *refinement);
