/* The scene: what the user wrote, checked, with every default filled in. One struct a section of the YAML file; names here
 * are the file's keys. Sections that are missing are NULL: what a scene lacks is left out of the run.  (docs/scene.md) */
#pragma once
#include <stddef.h>

enum { SCENE_NAME = 64, SCENE_PATH = 256 };

/* The default retraction of the markers, in cells.  (Breugem 2012) */
#define SCENE_RETRACTION 0.6
/* A family holds at most 512 bonds: |xi| < (m + 1/2) spacing gives 484 just below m = 4.5 and 514 just above. */
#define SCENE_HORIZON_MAX 4.5

struct scene_domain {
    double size[3];  /* m */
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
    double velocity[3];         /* wall, general */
    enum scene_profile profile; /* inflow: uniform, poiseuille, file */
    double bulk_velocity;       /* inflow: into the domain, m/s; uniform and poiseuille, a file has its own */
    char file[SCENE_PATH];      /* inflow, profile: file; made absolute on loading */
    double pressure;            /* pressure */
    enum scene_condition u, v, w, p; /* general */
};
enum scene_driving { SCENE_DRIVING_NONE, SCENE_DRIVING_GRADIENT, SCENE_DRIVING_BULK };
struct scene_fluid {
    double density, viscosity;    /* kg/m3; kinematic, m2/s */
    double initial_velocity[3];   /* m/s */
    int initial_poiseuille;       /* initial: {poiseuille: true}: a parabola with that mean */
    struct scene_side side[3][2]; /* YAML keys sides.x_low, sides.x_high, ... */
    enum scene_driving driving;   /* driving.type: none, pressure_gradient, bulk_velocity */
    int driving_direction;        /* driving.direction: x, y or z */
    double driving_value;         /* driving.value */
    double body_force[3];         /* m/s2 */
};

enum scene_shape { SCENE_BOX, SCENE_SPHERE, SCENE_CYLINDER, SCENE_POINTS };
struct scene_material {
    char name[SCENE_NAME];
    double youngs_modulus, density;
    double poisson_ratio;   /* must be 0.25 for bond-based 3D; default 0.25 */
    double fracture_energy; /* J/m2; left out: never breaks (INFINITY) */
    double horizon_ratio;   /* m, default 3; 1 <= m < SCENE_HORIZON_MAX */
};
struct scene_body {
    char name[SCENE_NAME], material[SCENE_NAME];
    int material_index;
    enum scene_shape shape;
    double low[3], high[3];           /* box */
    double centre[3], radius, length; /* sphere, cylinder */
    int axis;                         /* cylinder: x, y or z */
    char file[SCENE_PATH];            /* points: text, x y z volume a line */
    int has_cavities;                 /* cavities: {period, radius, centre} */
    double cavity_period, cavity_radius, cavity_centre[3];
};
struct scene_constraint {
    double low[3], high[3];
    char directions[4]; /* directions: xyz (a word of the letters x, y, z), default xyz */
    int direction[3];   /* 1: held or driven in it */
    double velocity[3]; /* default 0: held */
};
struct scene_region {
    double low[3], high[3];
};
struct scene_load { /* a given force per unit volume on the particles of a region (scenes without fluid) */
    double low[3], high[3];
    double force[3]; /* N/m3 */
};
struct scene_solid {
    double spacing; /* m; default the fluid's cell */
    int materials, bodies, constraints, unbreakables, loads;
    struct scene_material *material;     /* materials: [...] */
    struct scene_body *body;             /* bodies: [...] */
    struct scene_constraint *constraint; /* constraints: [...] */
    struct scene_region *unbreakable;    /* unbreakable: [...] */
    struct scene_load *load;             /* loads: [...] */
    int surface_correction;              /* default true */
    double body_force[3];                /* m/s2 */
    int contact;                         /* contact: {enabled, stiffness, exponent, radius} */
    double contact_stiffness, contact_exponent, contact_radius; /* k_c/c0 = 15, n_c = 1, r_c/spacing = 1 */
};

struct scene_coupling {
    int forcing_iterations; /* N_s, default 2 */
    double retraction;      /* r_d / dx, default the calibrated value */
    double probe_length;    /* / dx, default 2 */
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

struct scene_output {
    long series_every, fields_every, checkpoint_every; /* steps; 0: never. Defaults 10, 0, 1000 */
    long log_every;                                    /* lines in a log, default 100 */
    int stress;                                        /* tensors into solid fields, default true */
};

struct scene {
    char path[SCENE_PATH]; /* of the file */
    char title[256];
    struct scene_domain domain;
    struct scene_fluid *fluid;       /* NULL: no fluid */
    struct scene_solid *solid;       /* NULL: no solid */
    struct scene_coupling *coupling; /* NULL unless both */
    int stages;
    struct scene_stage *stage;
    struct scene_output output;
    char *resolved; /* the scene as YAML with every default, re-runnable */
};

/* Reads, overrides (n settings "key.path=value"), validates. Every mistake gives one line: file, line, key, value, what is
 * allowed, and the nearest key; all of them are said before leaving with exit code 2. Collective: rank 0 reads. */
struct scene *scene_new(const char *path, int n, const char *const *set);
void scene_free(struct scene *s);
