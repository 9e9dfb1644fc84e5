/* The scene: what the user wrote, checked, with every default filled in. One struct a section of the YAML file; names
 * here are the file's keys. Sections that are missing are NULL: what a scene lacks is left out of the run.
 * (docs/scene.md) */
#pragma once
#include <stddef.h>

enum { SCENE_NAME = 64, SCENE_PATH = 256 };

/* The default retraction of the markers, in cells: from the lattice's faces; from shapes' own surfaces.  (Breugem 2012)
 */
#define SCENE_RETRACTION 0.6
#define SCENE_RETRACTION_SHAPE 0.3
/* A family holds at most 512 bonds: |xi| < (m + 1/2) spacing gives 484 just below m = 4.5 and 514 just above. */
#define SCENE_HORIZON_MAX 4.5
/* In a plate 488 at m = 12; the largest that is allowed there. */
#define SCENE_HORIZON_MAX_PLATE 12

/* In a plate the third component of everything is 0. */
struct scene_domain {
    double size[3];  /* m; two numbers in the file make a plate */
    int cells[3];    /* a scene without fluid may leave them out: 0 */
    int periodic[3]; /* with a fluid: as its sides; without: domain.periodic, default false */
};

/* fluid.sides.x_low ... z_high */
enum scene_side_type {
    SCENE_PERIODIC,
    SCENE_WALL,
    SCENE_SLIP,
    SCENE_INFLOW,
    SCENE_OUTFLOW,
    SCENE_PRESSURE,
    SCENE_GENERAL
};
enum scene_profile { SCENE_UNIFORM, SCENE_POISEUILLE, SCENE_PROFILE_FILE };
enum scene_condition { SCENE_DIRICHLET, SCENE_NEUMANN };
struct scene_side {
    enum scene_side_type type;
    double velocity[3];              /* wall, general */
    enum scene_profile profile;      /* inflow: uniform, poiseuille, file */
    double bulk_velocity;            /* inflow: into the domain, m/s; uniform and poiseuille, a file has its own */
    char file[SCENE_PATH];           /* inflow, profile: file; made absolute on loading */
    double pressure;                 /* pressure */
    enum scene_condition u, v, w, p; /* general */
};
enum scene_axes { SCENE_XY, SCENE_XZ, SCENE_YZ, SCENE_XYZ };
int scene_varies_along(enum scene_axes axes, int direction); /* whether the direction is one of them */
enum scene_driving { SCENE_DRIVING_NONE, SCENE_DRIVING_GRADIENT, SCENE_DRIVING_BULK };
enum scene_diffusion { SCENE_DIFFUSION_EXPLICIT, SCENE_DIFFUSION_IMPLICIT };
struct scene_fluid {
    double density, viscosity; /* kg/m3; kinematic, m2/s */
    enum scene_diffusion diffusion;
    double initial_velocity[3];   /* m/s */
    int initial_poiseuille;       /* initial: {poiseuille: true}: a parabola with that mean */
    int has_taylor_green;         /* initial: {taylor_green: {velocity, axes}}: vortices, added to the uniform flow */
    double taylor_green_velocity; /* m/s */
    enum scene_axes taylor_green_axes; /* along which they vary: xy (default), xz, yz, xyz */
    struct scene_side side[3][2];      /* YAML keys sides.x_low, sides.x_high, ... */
    enum scene_driving driving;        /* driving.type: none, pressure_gradient, bulk_velocity */
    int driving_direction;             /* driving.direction: x, y or z */
    double driving_value;              /* driving.value */
    double driving_frequency; /* driving.frequency, Hz: the gradient is value cos(2 pi frequency t); default 0 */
    double body_force[3];     /* m/s2 */
};

enum scene_model { SCENE_3D, SCENE_PLANE_STRESS, SCENE_PLANE_STRAIN };
enum { SCENE_MODELS = SCENE_PLANE_STRAIN + 1 };
enum scene_partial { SCENE_PARTIAL_EXACT, SCENE_PARTIAL_RAMP };
enum scene_horizons { SCENE_HORIZONS_DUAL, SCENE_HORIZONS_ONE_SIDED };
enum scene_micromodulus { SCENE_CONSTANT, SCENE_CONICAL, SCENE_EXPONENTIAL };
struct scene_material {
    char name[SCENE_NAME];
    double youngs_modulus, density;
    double poisson_ratio;                 /* the one that the model has: 1/3 in plane stress, else 1/4 */
    double fracture_energy;               /* J/m2; left out: never breaks (INFINITY) */
    double horizon_ratio;                 /* m, default 3; from 1 to below, in a plate up to the numbers above */
    enum scene_micromodulus micromodulus; /* constant (default), conical, exponential */
};

/* A factor that goes with time: straight between the given times, constant before the first and after the last. n =
 * 0: 1. */
struct scene_time {
    int n;
    double *t, *factor; /* [n] s, ascending; 1 */
    double (*point)[2]; /* [n] both, as the file has them: [[t, factor], ...] */
};

/* A corner of a plate's outline: `at`, or [x, y] alone. */
struct scene_corner {
    double at[2];     /* m */
    double centre[2]; /* m, of the arc from here to the next corner; only where turn is not 0 */
    int turn;         /* to the next: 0 straight (default), 1 an arc left (counterclockwise), -1 right */
};
/* A closed curve: from each corner to the next, from the last to the first. */
struct scene_outline {
    int corners;
    struct scene_corner *corner;
    int is_hole;
};

enum scene_shape {
    SCENE_BOX,
    SCENE_SPHERE,
    SCENE_CYLINDER,
    SCENE_ELLIPSOID,
    SCENE_POINTS,
    SCENE_RECTANGLE,
    SCENE_DISC,
    SCENE_POLYGON
};
struct scene_part {           /* a further piece of a plate's body, or a hole in it */
    enum scene_shape shape;   /* rectangle, disc, polygon */
    double low[3], high[3];   /* rectangle */
    double centre[3], radius; /* disc */
    int corners;
    struct scene_corner *corner; /* polygon: outline */
};
struct scene_body {
    char name[SCENE_NAME], material[SCENE_NAME];
    int material_index;
    enum scene_shape shape;
    double low[3], high[3];           /* box */
    double centre[3], radius, length; /* sphere, cylinder */
    double radii[3];                  /* ellipsoid, along x, y, z */
    int axis;                         /* cylinder: x, y or z */
    char file[SCENE_PATH];            /* points: text, x y z volume [horizon] a line; in a plate x y area [horizon] */
    int has_cavities;                 /* cavities: {period, radius, centre} */
    double cavity_period, cavity_radius, cavity_centre[3];
    int corners, pieces, holes;
    struct scene_corner *corner;     /* polygon: outline: [...] */
    struct scene_part *piece, *hole; /* rectangle, disc, polygon: pieces: [...], holes: [...] */
    /* of a rectangle, disc or polygon all curves: its own, its pieces', its holes' */
    int outlines;
    struct scene_outline *outline;
};
struct scene_crack { /* a line of points; in 3D a plane quadrilateral of four corners */
    char name[SCENE_NAME];
    int points;
    double (*point)[3]; /* m */
};
struct scene_constraint {
    double low[3], high[3];
    char directions[4];     /* directions: xyz (a word of the letters x, y, z), default all */
    int direction[3];       /* 1: held or driven in it */
    double velocity[3];     /* default 0: held */
    int has_displacement;   /* displacement is given, instead of velocity */
    double displacement[3]; /* m */
    struct scene_time time; /* of the velocity or displacement */
};
struct scene_region {
    double low[3], high[3];
};
enum scene_load_kind { SCENE_LOAD_REGION, SCENE_LOAD_EDGE };
struct scene_load {
    enum scene_load_kind kind; /* edge where `edge` is given */
    double low[3], high[3];    /* region: force per unit volume on its particles */
    double force[3];           /* N/m3 */
    double edge[2][2];         /* m, edge of a plate: {from, to} */
    double traction[3];        /* Pa, on the edge */
    int over_horizon;          /* depth: over one layer of particles (0, default) or over the horizon (1) */
    struct scene_time time;
};
/* Displacement at the start: displacement exp(-((x - centre)/width)^2) or displacement sin(2 pi (x - centre)/width), x
 * the coordinate `along`. */
enum scene_initial_shape { SCENE_GAUSSIAN, SCENE_SINE };
struct scene_initial {
    enum scene_initial_shape shape;
    int along;
    double centre, width;   /* m */
    double displacement[3]; /* m */
};
struct scene_refined { /* refined from the start */
    double low[3], high[3];
    int level; /* 1 ... levels */
};
struct scene_refinement {
    int levels;              /* default 1 */
    double energy;           /* refine where W >= energy W_max; default 0.4, 0: off */
    double damage;           /* refine where the damage is above; 0: off (default) */
    double from;             /* s, default 0 */
    double low[3], high[3];  /* only here; default everywhere (-INFINITY, INFINITY) */
    int every;               /* steps between looks, default 10 */
    int horizon_kept;        /* horizon: scaled with the spacing (0, default), kept (1) */
    int interface_corrected; /* interface: plain (0, default), corrected (1; 000: eq. 40) */
    int held_refine;         /* held: particles of constraints and loads: keep (0, default), refine (1) */
    int starts;
    struct scene_refined *start; /* start: [...] */
};
struct scene_solid {
    double spacing;                    /* m; default the fluid's cell */
    enum scene_model model;            /* of a plate: plane_stress, plane_strain */
    double thickness;                  /* of a plate, m, default 1 */
    double lattice_offset[3];          /* spacings: points stand at (i + 1/2 + offset) spacing; default 0 */
    enum scene_partial partial_volume; /* exact (default), ramp */
    enum scene_horizons horizons;      /* dual (default), one_sided */
    int materials, bodies, cracks, constraints, unbreakables, loads, initials;
    struct scene_material *material;                            /* materials: [...] */
    struct scene_body *body;                                    /* bodies: [...] */
    struct scene_crack *crack;                                  /* cracks: [...] */
    struct scene_constraint *constraint;                        /* constraints: [...] */
    struct scene_region *unbreakable;                           /* unbreakable: [...] */
    struct scene_load *load;                                    /* loads: [...] */
    struct scene_initial *initial;                              /* initial: [...] */
    struct scene_refinement *refinement;                        /* NULL: none */
    int surface_correction;                                     /* default true */
    double body_force[3];                                       /* m/s2 */
    int contact;                                                /* contact: {enabled, stiffness, exponent, radius} */
    double contact_stiffness, contact_exponent, contact_radius; /* k_c/c0 = 15, n_c = 1, r_c/spacing = 1 */
};

enum scene_surface { SCENE_SURFACE_LATTICE, SCENE_SURFACE_SHAPE };
enum scene_load_form { SCENE_LOAD_PROBE, SCENE_LOAD_WALL, SCENE_LOAD_BALANCED };
enum scene_scheme { SCENE_EXPLICIT, SCENE_STRONG };
enum scene_relaxation { SCENE_QUASI_NEWTON, SCENE_AITKEN };
struct scene_coupling {
    int forcing_iterations;     /* N_s, default 2 */
    enum scene_surface surface; /* where bodies are wetted: the lattice's faces (default), their shapes' surfaces */
    double retraction;          /* r_d / dx, default the calibrated value of that surface */
    double probe_length;        /* / dx, default 2 */
    enum scene_load_form load;  /* as the probes read it (default), carried to the wall, or that with each body's sum
                                   made the forcing's */
    enum scene_scheme scheme;
    /* strong: how the next guess is made, the residual relative to the step's change of velocity, the most iterations
     * of a step */
    enum scene_relaxation relaxation;
    double tolerance;
    int iterations;
    /* medium: {low, high}: the box in which porosity and permeability are measured; default: all bodies' bounds within
     * the domain */
    double box_low[3], box_high[3];
    int has_box; /* 0: not given, and a body of points has bounds that only its particles know */
};

enum scene_solid_mode { SCENE_SOLID_RIGID, SCENE_SOLID_ELASTIC };
enum scene_integrator { SCENE_RK3, SCENE_VERLET };
struct scene_stage {
    char name[SCENE_NAME];
    long steps;
    double time_step;            /* s; 0: automatic (key left out or "auto") */
    double cfl;                  /* automatic: fraction of the limits, default 0.9 */
    enum scene_solid_mode solid; /* rigid, elastic; default elastic where there is a solid */
    int relax; /* solid alone, true: to static equilibrium by adaptive dynamic relaxation, no stepping */
    enum scene_integrator integrator; /* rk3 (default), verlet */
    int substeps;                     /* 0: auto, from the stable step */
    double safety;                    /* of the stable step for auto, default 0.95 */
    int breakage;                     /* default true; false: nothing breaks in this stage */
    double damping_relative, damping_absolute;
};

struct scene_crack_output {
    double damage;       /* the tip is the farthest particle with damage above this; default 0.35 */
    double direction[3]; /* farthest along this; default x */
    double window;       /* s, of the tip's speed, default 2e-6 */
    long every;          /* steps, default 10 */
};
struct scene_probes {
    int places;
    double (*at)[3]; /* m */
    long every;      /* steps, default 10 */
};
struct scene_probe_line {
    double from[3], to[3]; /* m */
    int points;            /* evenly from end to end, both included */
};
struct scene_fluid_probes {
    int places, lines;
    double (*at)[3];               /* m */
    struct scene_probe_line *line; /* lines: [...] */
    long every;                    /* steps, default 10 */
};
struct scene_output {
    long series_every, fields_every, checkpoint_every; /* steps; 0: never. Defaults 10, 0, 1000 */
    long log_every;                                    /* lines in a log, default 100 */
    int stress;                                        /* tensors into solid fields, default true */
    struct scene_crack_output *crack;                  /* NULL: no crack is followed */
    struct scene_probes *probes;                       /* NULL: none */
    struct scene_fluid_probes *fluid_probes;           /* NULL: none */
};

struct scene {
    char path[SCENE_PATH]; /* of the file */
    char title[256];
    int dimension; /* 2: a plate in the x-y plane; 3 */
    struct scene_domain domain;
    struct scene_fluid *fluid;       /* NULL: no fluid */
    struct scene_solid *solid;       /* NULL: no solid */
    struct scene_coupling *coupling; /* NULL unless both */
    int stages;
    struct scene_stage *stage;
    struct scene_output output;
    char *resolved; /* the scene as YAML with every default, re-runnable */
};

/* Reads, overrides (n settings "key.path=value"), validates. Every mistake gives one line: file, line, key, value, what
 * is allowed, and the nearest key; all of them are said before leaving with exit code 2. Collective: rank 0 reads. */
struct scene *scene_new(const char *path, int n, const char *const *set);
void scene_free(struct scene *s);
