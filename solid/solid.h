/* The solid: bond-based peridynamics on material particles.  (001: ch. 3.3)
 *
 * Numbering: each body's particles are numbered along a space-filling curve, bodies one after another; a rank owns the
 * global ids first[rank] .. first[rank+1]-1 and knows them as 0..n-1. Behind them stand n_ghost copies of other ranks'
 * particles that some family here needs. State is displacement d = X - X0, never X: stretches of 1e-4 keep their
 * digits. */
#pragma once
#include "base/error.h"
#include <stddef.h>
#include <stdint.h>

struct par_ghost;
struct solid_family; /* opaque: the bonds, solid/bonds/family.h */
struct solid_contact;
struct solid_added_mass;
struct solid_given;  /* opaque: the loads of the input, solid/imposed/given.h */
struct solid_refine; /* opaque: what refinement needs, solid/refine/refine.h */

/* What the bonds stand for: a solid in three dimensions (nu = 1/4), or a plate in the x-y plane (nu = 1/3 in plane
 * stress, 1/4 in plane strain). A plate has two components of everything, and the third arrays are NULL. */
enum solid_model { SOLID_3D, SOLID_PLANE_STRESS, SOLID_PLANE_STRAIN };

/* c(xi) = c0, or c1 (1 - xi/delta).  (000: eqs 9, 10) */
enum solid_micromodulus_kind { SOLID_CONSTANT, SOLID_CONICAL };

/* Gamma: the exact fraction of a particle's cell inside the horizon, or the linear ramp.  (SPEC 2; 000: eq. 22) */
enum solid_partial { SOLID_PARTIAL_EXACT, SOLID_PARTIAL_RAMP };

/* Bonds between particles of different horizons: both ends' halves (Ren, Zhuang and Rabczuk 2016), or each end by its
 * own horizon alone (000: sec. 1.2.5). */
enum solid_horizons { SOLID_DUAL_HORIZON, SOLID_ONE_SIDED };

struct solid_material {
    double youngs_modulus;  /* Pa */
    double density;         /* kg/m3 */
    double fracture_energy; /* G0, J/m2; INFINITY: never breaks */
    double horizon_ratio;   /* m = delta / spacing */
    enum solid_micromodulus_kind micromodulus;
};

/* One closed curve of a plate's outline: from each corner to the next (from the last to the first) a straight line or
 * an arc. Borrowed. */
struct solid_outline {
    int is_hole;
    int corners;
    const double (*corner)[2]; /* m */
    const double (*centre)[2]; /* m, of the arc from the corner; read where turn is not 0 */
    const signed char *turn;   /* 0: straight, +1: arc counterclockwise, -1: clockwise */
};

/* An initial crack: in a plate a line of points, in 3D a plane quadrilateral of four corners. Bonds that it crosses are
 * broken from the start. Borrowed. */
struct solid_cut {
    int points;
    const double (*point)[3]; /* m; z is 0 in a plate */
};

enum solid_shape { SOLID_BOX, SOLID_SPHERE, SOLID_CYLINDER, SOLID_POINTS, SOLID_POLYGON };

/* A body cut from a cubic lattice whose points stand at origin + (i + 1/2) spacing. */
struct solid_body {
    char name[64];
    enum solid_shape shape;
    double low[3], high[3];   /* box, m */
    double centre[3], radius; /* sphere, cylinder */
    int axis;                 /* cylinder */
    double length;            /* cylinder */
    /* spherical cavities on a cubic array, cut out of any shape; period 0: none */
    double cavity_period, cavity_radius, cavity_centre[3];
    /* SOLID_POINTS: particles as they are, on no lattice; borrowed, [points] */
    long points;
    const double *point[3];      /* of a plate: x, y, NULL */
    const double *point_volume;  /* m3; of a plate the area, m2 */
    const double *point_horizon; /* m; NULL: the material's */
    /* SOLID_POLYGON: pieces and holes of a plate */
    int outlines;
    const struct solid_outline *outline; /* borrowed */
    int material;
    double least_horizon; /* m, of its particles; solid_new sets it */
};

/* A factor that varies in time: straight lines between points, constant before the first and after the last. n = 0: 1.
 * Borrowed. */
struct solid_time {
    int n;
    const double *t, *factor; /* [n] s, ascending; 1 */
};

/* What is imposed on the particles of a region (X0 inside the box): per direction free, or the velocity given, or the
 * displacement, times a factor of time. Over a substep a particle moves at one speed, the mean of the speeds given, so
 * that either integrator brings it where it is to be at the substep's end. */
struct solid_constraint {
    double low[3], high[3];
    int direction[3];   /* 1: held or driven in this direction */
    double velocity[3]; /* 0: held */
    int has_displacement;
    double displacement[3]; /* m, instead of the velocity */
    struct solid_time time;
};

/* A force on the particles of a region, per unit volume, or on those along a piece of a plate's edge, per unit area of
 * the edge; times a factor of time. A substep sees the mean of the factor over it, as a constant. */
enum solid_load_kind { SOLID_LOAD_REGION, SOLID_LOAD_EDGE };
struct solid_load {
    enum solid_load_kind kind;
    double low[3], high[3]; /* region (X0), m */
    double force[3];        /* region, N/m3 */
    double edge[2][2];      /* from, to, m */
    double traction[3];     /* edge, Pa */
    int over_horizon; /* edge, straight: even over all particles within the horizon behind it; 0: over the outermost */
    struct solid_time time;
};

/* The displacement at the start: displacement times exp(-r^2) or sin(2 pi r), r = (x - centre)/width, x the coordinate
 * `along`; several add up. */
enum solid_initial_shape { SOLID_GAUSSIAN, SOLID_SINE };
struct solid_initial {
    enum solid_initial_shape shape;
    int along;
    double centre, width, displacement[3]; /* m */
};

/* Bonds with an end in the region (X0) never break. */
struct solid_region {
    double low[3], high[3];
};

/* Refinement of plates that are polygons: each level halves the spacing.  (000: ch. 2; solid/refine/refine.h) */
struct solid_refined { /* from the start, X0 */
    double low[3], high[3];
    int level;
};
struct solid_refinement {
    int levels;
    double energy;           /* kappa: refine where W >= kappa W_max; 0: off */
    double damage;           /* refine where the damage is above; 0: off */
    double low[3], high[3];  /* only here (X0), m */
    int horizon_kept;        /* 1: all levels have the material's horizon; 0: scaled with the spacing */
    int interface_corrected; /* 1: fine particles next to coarse ones have sqrt(2) times their horizon  (000: eq. 40) */
    int held_refine;         /* 1: particles of constraints and loads are refined too */
    int starts;
    const struct solid_refined *start; /* borrowed during the call */
};

struct solid_input {
    enum solid_model model; /* default SOLID_3D */
    double thickness;       /* of a plate, m */
    enum solid_partial partial;
    enum solid_horizons horizons;
    int cuts;
    const struct solid_cut *cut; /* borrowed during the call */
    double spacing;              /* m */
    double speed;                /* of the fluid it stands in, m/s; 0: none */
    double origin[3];            /* of the lattice */
    int periodic[3];             /* bonded across, with these lengths */
    double length[3];
    int bodies;
    const struct solid_body *body; /* borrowed during the call */
    int materials;
    const struct solid_material *material;
    int constraints;
    const struct solid_constraint *constraint;
    int unbreakables;
    const struct solid_region *unbreakable;
    int loads;
    const struct solid_load *load;
    int initials;
    const struct solid_initial *initial;       /* borrowed during the call */
    const struct solid_refinement *refinement; /* of plates; NULL: none */
    double body_force[3];                      /* per unit mass, m/s2 */
    int surface_correction;                    /* volume method on (default 1) */
    int general_bonds;                         /* 1: lists of bonds even for lattice bodies (tests) */
    int contact;                               /* 1: particles that come near repel; costs nothing before they can */
    double contact_stiffness;                  /* k_c / c0, default 15 */
    double contact_exponent;                   /* n_c, default 1 */
    double contact_radius;                     /* r_c / spacing, default 1 */
    int shape_surface; /* 1: the wetted surface is the shapes' own, not the lattice's (solid/surface/shaped.h) */
};

enum solid_integrator { SOLID_RK3, SOLID_VERLET };

/* Set at the start of each stage of a run. */
struct solid_stage {
    enum solid_integrator integrator;
    int breakage;            /* 0: nothing breaks */
    double damping_relative; /* k_d, N s/m^7 (pairwise, along the bond), 0: off */
    double damping_absolute; /* k_a, 1/s, 0: off */
};

enum solid_flag {
    SOLID_HELD_X = 1,
    SOLID_HELD_Y = 2,
    SOLID_HELD_Z = 4,      /* velocity imposed in the direction */
    SOLID_UNBREAKABLE = 8, /* in an unbreakable region */
    SOLID_BROKEN = 16,     /* has lost a bond */
    SOLID_INTERFACE = 32,
    SOLID_FIRST = 64 /* was on the interface at the start */
};

struct solid {
    struct solid_input in; /* the copied numbers; body, material and the like point to owned copies */
    int dim;               /* 2: a plate, [2] of x0, d, v, a, load, v_old, a_old are NULL; 3 */
    struct solid_stage stage;
    long n_global;
    long *first; /* [size+1] */
    int n, n_ghost;
    struct par_ghost *ghost;
    /* parameters, [n + n_ghost] */
    double *x0[3];         /* m */
    double *volume;        /* m3 */
    double *family_volume; /* V_h = sum Gamma V of the unbroken family, m3 (ghosts too) */
    uint8_t *body;
    uint8_t *flag; /* enum solid_flag; SOLID_HELD_* and UNBREAKABLE valid on ghosts */
    /* state, [n + n_ghost]; with the bonds' lambda and t, what a checkpoint stores */
    double t;     /* s; moved on by the integrators, set by who knows better */
    double *d[3]; /* displacement X - X0, m */
    double *v[3]; /* velocity, m/s */
    /* work, [n] */
    double *a[3];    /* acceleration of the last force sweep, m/s2 */
    double *load[3]; /* external force per unit volume F_h, N/m3: the given loads, and what the coupling writes */
    struct solid_given *given;            /* NULL: none */
    const struct solid_added_mass *added; /* borrowed, NULL: none (solid/force/added_mass.h) */
    struct solid_family *family;
    struct solid_contact *contact; /* NULL until something can touch */
    struct solid_refine *refine;   /* NULL: nothing is refined */
    /* counters and energies, this rank's share */
    long bonds_total;    /* undirected, whole solid, of the families as made, or remade by a refinement */
    long bonds_broken;   /* undirected, whole solid; valid after solid_family_count */
    int broke;           /* 1: a bond of an owned particle broke since the flag was last cleared */
    double e_damped;     /* J taken out by damping so far */
    double e_fracture;   /* J released by broken bonds so far: sum of (1/2) c s^2 |xi| Gamma V V at breaking */
    double e_constraint; /* J put in by driven layers so far */
    double work_load;    /* J put in by load and body force so far */
    /* of the last force sweep, this rank's share, W */
    double power_damped, power_load, power_constraint;
    double power_added; /* the part of power_load that is the added mass's */
    long sweeps;        /* force sweeps so far */
    long versions;      /* numbers given so far to states of the bonds and of contact's record (solid/keep.h) */
    long bonds_version; /* another one whenever kept bonds are put back */
    /* work of the integrators, [n]: rates of the stage before (RK3); bonds' and contact's part of a, a before (Verlet)
     */
    double *v_old[3], *a_old[3];
    int a_holds; /* 1: a is of the present d, v and bonds (Verlet); whoever changes one of them clears it */
    struct solid_stage stage_of_a;
    double power_pairwise; /* of the sweep that v_old belongs to, W (Verlet) */
};

static inline int solid_dim(const struct solid_input *in) { return in->model == SOLID_3D ? 3 : 2; }
/* Depth of a plate, m; 1 in 3D: a particle's volume is spacing^dim times it. */
static inline double solid_depth(const struct solid_input *in) { return in->model == SOLID_3D ? 1 : in->thickness; }

struct solid *solid_new(const struct solid_input *in); /* Collective. Dies (exit 2) on an empty or impossible body. */
void solid_free(struct solid *s);
/* For a solid that stays rigid, once its surface is known: keeps the particles, gives back what bonds and motion need.
 * Not collective. */
void solid_forget_bonds(struct solid *s);

/* c0 and s0 of a material in 3D.  (001: eqs 3.21, 3.28) */
double solid_material_micromodulus(const struct solid_material *m, double spacing);
double solid_material_critical_stretch(const struct solid_material *m, double spacing);

/* One force sweep at the present d, v: a = (bonds + load + contact + damping)/rho, constraints applied; breaks bonds
 * when asked to and the stage allows it. The integrators ask in the first stage of a substep only, so that a bond is
 * judged on the state of a full step, never on an inner Runge-Kutta stage. Ghosts must be current. Collective only
 * through contact. */
void solid_force(struct solid *s, int may_break);
void solid_ghosts_update(struct solid *s); /* d (and v when damping needs it). Collective. */
void solid_ghosts_begin(struct solid *s);  /* The same, ended by the next force sweep. Collective. */

/* Substeps of the stage's integrator from t on, each under constant load and with constant imposed velocities: where
 * these are given as functions of time, their means over the substep. The energies are integrated by the integrator's
 * own quadrature, so that kinetic + strain + e_damped + e_fracture = work_load + e_constraint holds to its order
 * (contact stores energy that is not counted; what it takes to change an imposed velocity is part of e_constraint).
 * Collective. */
void solid_integrate(struct solid *s, double dt, int substeps);
/* Goes on in the middle of a stage, from a checkpoint's d, v, v_old (for Verlet: the accelerations of the last sweep,
 * which saw the velocity predicted then) and power_pairwise. Once the stage is set. Not collective. */
void solid_verlet_resume(struct solid *s);
/* The largest stable step of the assembled, intact solid with the stage's damping, by the rates of solid/step/stable.h:
 * without damping sqrt(3)/omega_max (RK3), 2/omega_max (Verlet). Once contact has lists, with a particle squeezed
 * between two pairs of others on top. Collective. */
double solid_rates_stable_step(struct solid *s, enum solid_integrator integrator);
/* Adaptive dynamic relaxation to static equilibrium under the present load: steps taken, or -1 if not converged to
 * |residual| <= tolerance * |load|. Breakage off. Collective. */
int solid_relax(struct solid *s, double tolerance, int max_steps);

/* NaN, or a speed of more than a hundred times sqrt(E/rho) and what is imposed. Not collective. */
struct step_status solid_integrate_check(const struct solid *s);

/* The current position X0 + d; z of a plate is 0. */
static inline void solid_position(const struct solid *s, int h, double x[3]) {
    x[2] = 0;
    for (int c = 0; c < s->dim; c++) x[c] = s->x0[c][h] + s->d[c][h];
}
