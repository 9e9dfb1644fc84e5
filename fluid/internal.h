/* Shared by the files of fluid/ only. */
#pragma once
#include "fluid/fluid.h"

struct fluid_boundary;  /* fluid/grid/boundary.h */
struct fluid_poisson;   /* fluid/poisson/poisson.h */
struct fluid_diffusion; /* fluid/momentum/diffusion.h */
struct fluid_planes;    /* fluid/momentum/planes.h */
struct fluid_volume_source;
struct fluid_side_flux; /* fluid/measure/side_flux.h */

/* The force on the box, summed during a step. */
struct fluid_box_balance {
    int on;
    int has_diffusion;        /* 1: that of the present stage is counted already */
    double flux[3], force[3]; /* N, this rank's share: of the last stage; of the step */
    double size;              /* N, this rank's share: of the pressures on the sides and the sources in the step */
    double flux_couple[3], couple[3]; /* N m, about the domain's centre: the same */
};

/* The coefficients of a step's stages. is_multistep: the next step reads R of the last stage. */
struct fluid_scheme {
    int stages, is_multistep;
    double alpha[3], beta[3], gamma[3], most; /* most: the largest gamma */
};

struct fluid {
    /* parameters */
    struct fluid_input in;
    struct fluid_scheme scheme;
    struct fluid_grid *grid;
    struct fluid_boundary *boundary;
    /* state */
    struct fluid_state state;
    /* work arrays of grid->size */
    double *predicted[3]; /* u*, m/s; the state's own arrays if u is not read after u* is computed */
    double *correction;   /* p-hat, Pa: fluid/momentum/correction.h */
    double *flux; /* scratch of the momentum equation, the same memory as `correction`; the Poisson solver exchanges
                   * values of columns by it */
    struct fluid_planes *planes; /* NULL: the momentum pass ends before its divergence is taken */
    struct fluid_poisson *poisson;
    struct fluid_diffusion *diffusion; /* NULL: explicit */
    struct fluid_box_balance box_balance;
    struct fluid_volume_source *source; /* fluid/volume_source.c; NULL: nothing enters at points */
    double shift[3];                    /* uniform velocity that the bulk driving adds in this stage, m/s */
};

static inline double *fluid_component(const struct fluid_state *s, int c) {
    return c == 0 ? s->u : c == 1 ? s->v : s->w;
}

/* This rank's share of the dissipation between neighbours whose higher end is in plane k = -1 .. m[2], W. Not
 * collective. */
double fluid_dissipation_in(const struct fluid *f, int k);
/* Add this rank's share of the couple about the domain's centre, N m: of the flux of component c through a side, of the
 * fluxes through periodic sides; of the pressure at the sides and of the sources, for a share of the step. Not
 * collective. */
void fluid_box_couple_side(const struct fluid *f, const struct fluid_side_flux *flux, int c, int d, int side,
                           double couple[3]);
void fluid_box_couple_periods(const struct fluid *f, const double *const q[3], double couple[3]);
void fluid_box_couple_pressure(const struct fluid *f, double share, double couple[3]);
void fluid_box_couple_source(const struct fluid *f, double share, double couple[3]);
void fluid_box_force_flux(struct fluid *f, int r);      /* at the start of a stage. Not collective. */
void fluid_box_force_open(struct fluid *f, int r);      /* after the prediction. Not collective. */
void fluid_box_force_diffusion(struct fluid *f, int r); /* of implicit diffusion, once u* is computed. Collective. */
void fluid_box_force_pressure(struct fluid *f, int r);  /* at the end of a stage. Not collective. */
/* Adds sign times the present p: for a change of p that exerts no force in this stage. Not collective. */
void fluid_box_force_pressure_part(struct fluid *f, int r, double sign);
/* Subtracts factor times the divergence that the volume sources prescribe from plane k of a divergence, [m1][m0].
 * Not collective. */
void fluid_volume_source_subtract(const struct fluid *f, int k, double factor, double *plane);
/* Sets the coefficients of a step of length dt that depend on the step before. Not collective. */
void fluid_scheme_begin(struct fluid *f, double dt);
/* The part of a step over which the pressure found after stage r acts: gamma_r; where the last stage alone is projected
 * 0, 0, 1. And that over which the driving acts that this stage leaves. Not collective. */
double fluid_stage_share(const struct fluid *f, int r);
double fluid_stage_share_driven(const struct fluid *f, int r);
/* As fluid_predict, but where f->planes is set the planes of u* are left to fluid_project. Collective. */
void fluid_predict_begin(struct fluid *f, int r, double dt);
void fluid_volume_source_free(struct fluid_volume_source *s);
void fluid_initial_fill(struct fluid *f);  /* the initial velocity. Not collective. */
void fluid_project_start(struct fluid *f); /* makes the initial velocity divergence-free. Collective. */
