/* The fluid: its input, its state, and the calls that a time step consists of.  (001: ch. 3.4, 4.1) */
#pragma once
#include "base/step_status.h"
#include "fluid/grid/grid.h"
#include "physics/choice_flow.h"

struct fluid_side {
    enum fluid_side_type type;
    double velocity[3];         /* wall: its velocity, m/s; general: the values */
    enum fluid_profile profile; /* inflow */
    double bulk_velocity;       /* inflow: mean normal velocity into the domain, m/s */
    char file[256];  /* inflow profile from a file: text, one normal velocity a line, second tangential index fastest */
    double pressure; /* pressure: Pa */
    enum fluid_condition condition[4]; /* general: of u, v, w, p */
};

struct fluid_driving {
    enum fluid_driving_type type;
    int direction;
    double value; /* gradient: -dp/dx, Pa/m; bulk: mean velocity, m/s */
};

/* Taylor-Green vortices, one wave along two axes or all three: with x, y, z in 1/2 pi lengths
 *     u = velocity sin x cos y cos z, v = -velocity cos x sin y cos z, w = 0
 * with two axes the factor of the third is left out. */
struct fluid_vortices {
    double velocity; /* m/s; 0: none */
    int along[3];    /* 1: the vortices vary in this direction */
};

struct fluid_input {
    int n[3];
    double length[3];
    double density;               /* kg/m3 */
    double viscosity;             /* kinematic, m2/s */
    struct fluid_side side[3][2]; /* [direction][low, high] */
    struct fluid_driving driving;
    double driving_along[3];        /* of a gradient: the unit vector that it points along; 0: along its direction */
    double driving_frequency;       /* Hz, of a gradient: the gradient is value cos(2 pi frequency t) */
    double body_force[3];           /* per unit mass, m/s2 */
    double initial_velocity[3];     /* m/s */
    int initial_poiseuille;         /* 1: a parabola between the walls with that mean instead */
    struct fluid_vortices vortices; /* added to the initial velocity */
    int immersed;                   /* 1: three ghost layers, and arrays for the forcing */
    int mean_pressure; /* where p and pi are separate arrays: 1: p is the mean over a step; 0: that of its last stage */
    double speed;      /* of waves in immersed solids, m/s; 0: no solid moves by itself */
    int implicit;      /* 1: implicit diffusion: no viscous limit of the step */
    enum fluid_projection projection; /* FLUID_LAST_STAGE with explicit diffusion only */
    int keeps_rate;                   /* 1: some steps are taken by AB2, so R is part of the state */
    const double *weight[3];          /* borrowed during fluid_new: work by y [n_y] and by z [n_z], for equal pieces
                                       * (fluid_grid_new); NULL: equal numbers of cells */
};

/* Component c of the unit vector along which the driving points. Not collective. */
static inline double fluid_driving_along(const struct fluid_input *in, int c) {
    const double *e = in->driving_along;
    return e[0] != 0 || e[1] != 0 || e[2] != 0 ? e[c] : c == in->driving.direction;
}

/* Arrays as fluid/grid/grid.h; ghosts are rebuilt. From u to driving it is the state: exactly what the table in
 * fluid/state_table.c lists, which tests/coupling/test_state.c checks. */
struct fluid_state {
    double *u, *v, *w; /* faces, m/s */
    double *p;         /* centres, Pa */
    double *pi;        /* predictor pressure, which the momentum equation reads, centres, Pa; p itself unless bodies are
                        * immersed, diffusion is explicit, and every stage ends with a projection */
    double *rate[3];   /* R = -div(uu) + nu lap u of the last stage (implicit: without nu lap u), faces, m/s2; on open
                        * faces, that face's own rate. Work, unless the scheme reads it in the next step */
    double driving;    /* the present pressure gradient, Pa/m; its mean over the stage if it depends on time */
    double rate_dt;    /* length of the step that R is of, s; 0: the next step does not read R */

    /* Work. */
    double driven; /* mean of `driving` over the last step, Pa/m */
    double t;      /* time at the start of the step, s: set by the caller, advanced by fluid_step */
};

struct fluid; /* opaque: grid, parameters, state, work, plans */

struct fluid *fluid_new(const struct fluid_input *in); /* Collective. */
void fluid_free(struct fluid *f);
const struct fluid_grid *fluid_grid_of(const struct fluid *f);
const struct fluid_input *fluid_input_of(const struct fluid *f);
struct fluid_state *fluid_state_of(struct fluid *f);

/* One step is, for all stages r of its scheme (fluid/scheme.h; 001: sec. 3.4.3):
 *     fluid_predict(f, r, dt); [ibm_forcing_stage(... fluid_predicted ...)]; fluid_project(f, r, dt);
 * and with implicit diffusion
 *     fluid_predict(f, r, dt); [ibm_implicit_force_again(..)]; fluid_diffusion_stage(f, r, dt);
 *     [ibm_implicit_force(..)]; fluid_project(f, r, dt); */

/* u* = u + dt (alpha R + beta R_old - gamma grad pi / rho), and the values on the sides' faces. Ghosts are not set;
 * fluid_predicted_refresh does that. Collective. */
void fluid_predict(struct fluid *f, int r, double dt);
/* The driving and the body force along c in the present stage, m/s2. Not collective. */
double fluid_source(const struct fluid *f, int c);
/* Implicit diffusion: solves for u*, from the u* that fluid_predict has computed without a viscous term and a force has
 * changed since. Does nothing with explicit diffusion. Collective. */
void fluid_diffusion_stage(struct fluid *f, int r, double dt);
/* Counts the friction of the diffusion on the domain's sides now: what a force adds to u* from here on does not diffuse
 * in this stage. Otherwise it is counted at the projection. Collective. */
void fluid_box_force_close(struct fluid *f, int r);
/* For a forcing that is implicit too: a field on the faces, [3], borrowed. It is cleared, filled by the forcing, solved
 * for (field <- (I - b_r dt nu lap)^-1 field, zero on the sides), and added to u* times a factor. */
double *const *fluid_diffusion_field(struct fluid *f);
void fluid_diffusion_clear(struct fluid *f);                   /* Not collective. */
void fluid_diffusion_solve(struct fluid *f, int r, double dt); /* Collective. */
void fluid_diffusion_add(struct fluid *f, double factor);      /* Not collective. */
double fluid_limits_explicit_step(const struct fluid *f);      /* viscous limit of explicit diffusion, s */
/* The predicted velocity u*, to which a forcing adds in place (faces inside the domain only). [3] borrowed. */
double *const *fluid_predicted(struct fluid *f);
/* Sets the ghosts of u*, v*, w* after these were changed: boundary values and `layers` exchanged layers. Collective. */
void fluid_predicted_refresh(struct fluid *f, int layers);
/* How a component continues beyond a side, for a reader without ghosts: its first value beyond the side is face * (the
 * value on the side's own face) + inner * (the value mirrored about the side) + constant. Not collective. */
struct fluid_mirror {
    double face, inner, constant;
    int is_free; /* 1: the normal component, whose value on the side's face follows from the momentum equation */
};
struct fluid_mirror fluid_mirror_predicted(const struct fluid *f, int component, int direction, int side);
/* Solves for the pressure and projects: new velocity and pressures. Sets one ghost layer of the velocity, and pi's
 * ghosts that the next stage reads. Where pi is a separate array, p is set in the last stage, and in all stages if the
 * force on the box is summed (fluid_box_force_begin). With FLUID_LAST_STAGE the first two of three stages, except in a
 * step from t = 0, hand u* on as the velocity, with its ghosts, and leave the pressures as they are. Collective. */
void fluid_project(struct fluid *f, int r, double dt);
/* All stages: a step of a fluid without immersed bodies. Collective. */
void fluid_step(struct fluid *f, double dt);
/* Whether the momentum pass of these stages pauses every few planes, so that divergence and transforms read u* from the
 * cache. It does in a fluid without bodies, on one thread, if y is not divided over ranks. Not collective. */
int fluid_is_joined(const struct fluid *f);
/* Fills all `halo` ghost layers of the state's u, v, w, p, and one of pi. Collective. */
void fluid_state_refresh(struct fluid *f);
/* Fills the nearest `layers` ghost layers for a reader of blocks of cells that stay within the global cells low ..
 * high-1 (which may lie beyond a side; the same box on every rank). Ghosts outside the box, and those of pi where it is
 * a separate array, may keep old values. Collective. */
void fluid_state_refresh_near(struct fluid *f, int layers, const int low[3], const int high[3]);

/* Sets whether a moving body of this rank is near an outflow, from the next step on (fluid/grid/outflow.h). Not
 * collective. */
void fluid_outflow_near(struct fluid *f, int direction, int side, int is_near);

/* Sets the points at which volume enters the flow from now on; they replace earlier ones. In the next steps div u in a
 * cell is the sum of the rates of its points, m3/s, over the volume of the cell. x [n] on any rank, m, wrapped in
 * periodic directions. The sum over all ranks must be 0. Collective. */
void fluid_volume_source_set(struct fluid *f, int n, const double (*x)[3], const double *rate);
void fluid_volume_source_clear(struct fluid *f); /* Not collective. */
/* Whether volume can enter at a point: it must lie in the domain, and not in a cell next to a side. Other points are
 * left out. Not collective. */
int fluid_volume_source_holds(const struct fluid *f, const double x[3]);

/* The largest stable step by its convective and its viscous limit, each INFINITY if there is none. With implicit
 * diffusion `viscous` is no limit of stability; it is the longest step with which the transient to a steady state is
 * accurate. Collective. */
struct fluid_limits {
    double convective, viscous, step;
};
struct fluid_limits fluid_limits_stable_step(struct fluid *f);
/* The same, with the velocities that sides give and a held bulk velocity as well, before these have set the fluid in
 * motion. A pressure or a body force gives no velocity. Collective. */
struct fluid_limits fluid_limits_foreseen(const struct fluid *f);
/* The same for a caller that does the reduction: this rank's largest sum of |velocity|/d over its cells, from the faces
 * of each, 1/s (INFINITY if one is NaN), and the centre of that cell, m (x may be NULL); then the limits from the
 * largest sum of all ranks. Not collective. */
double fluid_limits_convection_rate(const struct fluid *f, double x[3]);
struct fluid_limits fluid_limits_of(const struct fluid *f, double rate);

/* Checks for NaN and for unreasonably large velocities; returns field and position. Not collective (agree with
 * step_status_agree). */
struct step_status fluid_limits_check(struct fluid *f);

/* A velocity scale, m/s: the largest of those of sides, initial flow, driving, body force and diffusion over a cell.
 * Not collective. */
double fluid_limits_speed(const struct fluid *f);
double fluid_measures_kinetic_energy(struct fluid *f); /* J. Collective. */
/* u, v, w, p at a point of the domain, linear in each direction; 0 on ranks that do not hold the point. Reads ghosts
 * (fluid_state_refresh). Not collective. */
void fluid_value_at(struct fluid *f, const double x[3], double value[4]);
/* The same at n points, with current ghosts. The state keeps its own, which differ in the last digits, so that looking
 * at a flow does not change it. Collective. */
void fluid_value_at_points(struct fluid *f, int n, const double (*x)[3], double (*value)[4]);
void fluid_measures_mean_pressure(struct fluid *f, int direction,
                                  double *mean); /* [n[direction]] section means, Pa, on every rank */
/* The force on the fluid in the box, with the momentum that flows through its sides; in steady flow the forcing
 * balances it. Collective. out[3]: -(net momentum outflow) + pressure and viscous forces of the sides on the fluid +
 * driving, N. */
void fluid_box_force(struct fluid *f, double out[3]);
/* The same force as the scheme adds it up over one step, stage by stage: begin before the step, end after it. Then
 * (momentum after - momentum before)/dt = this + the forcing's mean, to round-off. Collective. */
void fluid_box_force_begin(struct fluid *f);
void fluid_box_force_end(struct fluid *f, double out[3]);
/* The sum of the sizes of the pressures on the sides and of the sources in that step, which may cancel, N; to be called
 * after fluid_box_force_end. Collective. */
double fluid_box_force_size(const struct fluid *f);
/* The moment of the same forces about the domain's centre, N m; to be called after fluid_box_force_end. Through a
 * periodic side the flux has the length of the period as its arm. With implicit diffusion and with AB2 it is not
 * available: returns 0. Collective. */
int fluid_box_couple_end(struct fluid *f, double out[3]);
/* rho int u dV, kg m/s, and rho int x u dV about the domain's centre, kg m2/s; either may be NULL. Collective. */
void fluid_measures_momentum(struct fluid *f, double momentum[3], double angular[3]);

/* With one pass over the velocity. Collective. */
struct fluid_measures {
    double divergence_max;  /* 1/s, without the volume that enters at points */
    double convection_rate; /* largest sum of |velocity|/d, 1/s: times dt the Courant number */
    double bulk_velocity;   /* along x, m/s */
    double kinetic_energy;  /* J */
    double dissipation;     /* rho nu int |grad u|^2 dV, W */
    double momentum[3];     /* kg m/s */
    double angular[3];      /* angular momentum about the domain's centre, kg m2/s */
};
struct fluid_measures fluid_measures_of(struct fluid *f);

size_t fluid_cells(const struct fluid *f); /* of the whole domain */
