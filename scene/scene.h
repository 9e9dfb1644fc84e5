/* The scene: the user's input, checked, with every default filled in. Each section of the YAML file is a struct; the
 * members' names are the file's keys. A missing section is NULL: that part is left out of the run. (docs/scene.md) */
#pragma once
#include "base/files/image.h"
#include "physics/bond.h"
#include "physics/choice_flow.h"
#include "physics/choice_points.h"
#include "physics/choice_solid.h"
#include <stddef.h>

/* Stages that times may count from. */
enum { SCENE_TIMED_MAX = 8 };
enum { SCENE_NAME = 64, SCENE_PATH = 256 };

/* Limit of the horizon ratio m: a family holds at most 512 bonds. |xi| < (m + 1/2) spacing gives 484 bonds just below m
 * = 4.5 and 514 just above. */
#define SCENE_HORIZON_MAX 4.5
/* In a plate: 488 bonds at m = 12, the largest allowed value. */
#define SCENE_HORIZON_MAX_PLATE 12

/* In a plate the third component of all vectors is 0. */
struct scene_domain {
    double size[3];  /* m; two numbers in the file make a plate */
    int cells[3];    /* a scene without fluid may leave them out: 0 */
    int periodic[3]; /* with a fluid: the sides tell; without: domain.periodic, default false */
};

/* fluid.sides.x_low ... z_high */
struct scene_side {
    enum fluid_side_type type;
    double velocity[3];              /* wall, general */
    enum fluid_profile profile;      /* inflow: uniform, poiseuille, file */
    double bulk_velocity;            /* inflow, uniform and poiseuille: mean velocity into the domain, m/s; a file holds
                                      * its own */
    char file[SCENE_PATH];           /* inflow, profile: file; made absolute on loading */
    double pressure;                 /* pressure */
    enum fluid_condition u, v, w, p; /* general */
};
enum scene_axes { SCENE_XY, SCENE_XZ, SCENE_YZ, SCENE_XYZ };
int scene_axes_has(enum scene_axes axes, int direction); /* whether the direction is one of them */
enum scene_diffusion { SCENE_DIFFUSION_EXPLICIT, SCENE_DIFFUSION_IMPLICIT };
struct scene_fluid {
    double density, viscosity; /* kg/m3; kinematic, m2/s */
    enum scene_diffusion diffusion;
    enum fluid_projection projection;
    double initial_velocity[3];   /* m/s */
    int initial_poiseuille;       /* initial: {poiseuille: true}: a parabola with the mean initial_velocity */
    int has_taylor_green;         /* initial: {taylor_green: {velocity, axes}}: vortices added to the uniform flow */
    double taylor_green_velocity; /* m/s */
    enum scene_axes taylor_green_axes; /* directions along which they vary: xy (default), xz, yz, xyz */
    struct scene_side side[3][2];      /* YAML keys sides.x_low, sides.x_high, ... */
    enum fluid_driving_type driving;   /* driving.type: none, pressure_gradient, bulk_velocity */
    int driving_direction;             /* driving.direction: x, y or z */
    double driving_along[3];           /* driving.along: of any length; 0: left out, along driving_direction */
    double driving_value;              /* driving.value */
    double driving_frequency; /* driving.frequency, Hz: the gradient is value cos(2 pi frequency t); default 0 */
    double body_force[3];     /* m/s2 */
};

enum scene_breakage { SCENE_BRITTLE, SCENE_BILINEAR };
struct scene_material {
    char name[SCENE_NAME];
    double youngs_modulus, density;
    double poisson_ratio;                   /* default: that of bonds alone, 1/3 in plane stress, else 1/4 */
    double fracture_energy;                 /* J/m2; left out: INFINITY, bonds never break; or that of the toughness, or
                                             * of the strength of brittle bonds */
    double toughness;                       /* K_Ic, Pa m^(1/2); 0: fracture_energy is given, or left out */
    double strength;                        /* tensile_strength, Pa; 0: left out */
    double horizon_ratio;                   /* m, default 3; at least 1; below 4.5 in 3D, at most 12 in a plate */
    enum physics_micromodulus micromodulus; /* constant (default), conical, exponential */
    enum scene_breakage breakage;           /* breakage.law: brittle (default), bilinear */
    double tensile_strength; /* breakage.tensile_strength, or the material's: of the bilinear law, Pa; else 0 */
    double s00, alpha; /* breakage: of the brittle law whose limit follows the other bonds; s00 = 0: it does not */
};

/* A factor as a function of time: linear between the given times, constant before the first and after the last. n = 0:
 * the factor is 1. */
struct scene_time {
    int n;
    double *t, *factor;    /* [n] times, s, ascending; [n] factors */
    double (*point)[2];    /* [n] both, as the file has them: [[t, factor], ...] */
    char from[SCENE_NAME]; /* time_from: the stage from whose start the times count; default the start of the run */
    int stage;             /* its index + 1; 0: the run; -1: there is no such stage */
};

/* A corner of a plate's outline: `at`, or [x, y] alone. */
struct scene_corner {
    double at[2];     /* m */
    double centre[2]; /* m, of the arc from here to the next corner; only where turn is not 0 */
    int turn;         /* way to the next corner: 0 straight (default), 1 an arc to the left (counterclockwise), -1 to
                       * the right */
};
/* A closed curve: from each corner to the next, from the last to the first. */
struct scene_outline {
    int corners;
    struct scene_corner *corner;
    int is_hole;
};

/* rotation: of a box, a rectangle, a cylinder, an ellipsoid or a region. Its other numbers are those before it is
 * turned (scene/turn.h). */
struct scene_turn {
    double axis[3], angle; /* about the direction axis, in a plate z, by the right-hand rule; degrees */
    double axes[2][3];     /* instead: where its x and its y direction point to */
    double about[3];       /* m, the point that stays; default its centre */
    int is_turned;         /* 0: the key is left out */
    double edge[3][3];     /* unit vectors of its x, y and z direction */
};

struct scene_part {         /* a shape: of a body itself, of a further piece of it, or of a hole in it */
    enum solid_shape shape; /* plate: rectangle, disc, polygon; 3D: box, sphere, cylinder, ellipsoid, spheres */
    double low[3], high[3]; /* rectangle, box */
    double centre[3], radius, length; /* disc, sphere, cylinder */
    double radii[3];                  /* ellipsoid, along x, y, z */
    int axis;                         /* cylinder: x, y or z */
    struct scene_turn turn;           /* rotation; rectangle, box, cylinder, ellipsoid */
    int corners;
    struct scene_corner *corner; /* polygon: outline */
    char file[SCENE_PATH];       /* spheres: text, x y z radius or x y z and three radii a line */
    int spheres;
    double (*sphere)[4]; /* spheres: [[x, y, z, radius], ...], if no file is given */
};
enum scene_image_axes {
    SCENE_IMAGE_XYZ,
    SCENE_IMAGE_XZY,
    SCENE_IMAGE_YXZ,
    SCENE_IMAGE_YZX,
    SCENE_IMAGE_ZXY,
    SCENE_IMAGE_ZYX
};
enum scene_floating { SCENE_FLOATING_KEEP, SCENE_FLOATING_REMOVE, SCENE_FLOATING_HOLD };
enum { SCENE_KINDS_MAX = 16 }; /* materials of one image */
struct scene_image_material {  /* of the voxels with a label */
    int label;
    char material[SCENE_NAME];
    int index; /* in solid.materials */
};
/* The voxels of a body of shape image (docs/images.md). Directions are those of the scene. */
struct scene_image {
    enum files_image_format format;    /* default auto */
    char dataset[SCENE_PATH];          /* hdf5 */
    int size[3];                       /* voxels; the default is what the file's header says */
    enum files_image_type type;        /* default header */
    enum files_image_order byte_order; /* default header */
    enum scene_image_axes axes;        /* direction that varies first, second, third in the file; default xyz */
    int header_bytes;                  /* raw: bytes before the first voxel, default 0 */
    double voxel[3];                   /* its edges along x, y, z, m */
    double unit;                       /* stl: m, the length that 1 stands for */
    int has_crop;                      /* crop: {low, high}: voxels low <= i < high; default all */
    int crop_low[3], crop_high[3];
    int labels;
    int *label; /* solid: [...]: values of the solid's voxels */
    int materials;
    struct scene_image_material *material; /* materials: {label: name}; none: the body's material */
    int kinds;                             /* different ones among them; 0: the body's material */
    int kind[SCENE_KINDS_MAX];             /* their indices in solid.materials, in the order of the list */
    int has_threshold;
    double threshold; /* instead of labels: solid where the value is not below */
    char flip[4];     /* directions in which the image is turned round; default none */
    char mirror[4];   /* directions in which its mirror image follows it; default none */
    int flips[3], mirrors[3];
    enum scene_floating floating; /* pieces of solid that nothing connects to the largest one; default keep */
};
/* How a body's particles, or the points of `nonlocal`, stand. */
struct scene_arranged {
    enum meshless_arrangement kind; /* lattice (default), ... */
    double perturbation;            /* spacings: each particle is moved by at most this in each direction */
    int seed;                       /* default 1 */
    enum meshless_volume volume;    /* of each point: equal (default), cell: its Voronoi cell */
};
struct scene_body {
    char name[SCENE_NAME], material[SCENE_NAME];
    int material_index;
    struct scene_part own;    /* keys of the body itself: shape, low, high, ...; `low` of an image too. file of points:
                               * text, x y z volume [horizon] a line; in a plate x y area [horizon] */
    struct scene_image image; /* image */
    int contacts_broken;      /* contacts: bonded (0, default), broken (1: no bond between the body's shapes) */
    double velocity[3];       /* at the start, m/s, default 0 */
    int has_cavities;         /* cavities: {period, radius, centre} */
    double cavity_period, cavity_radius, cavity_centre[3];
    struct scene_arranged arrangement;
    int pieces, holes;
    struct scene_part *piece, *hole; /* further pieces, holes */
    /* of a rectangle, disc or polygon all curves: its own, its pieces', its holes' */
    int outlines;
    struct scene_outline *outline;
};
struct scene_crack { /* A crack: a line of points in a plate, a plane quadrilateral of four corners in 3D. */
    char name[SCENE_NAME];
    int points;
    double (*point)[3]; /* m */
};
struct scene_interface { /* Two bodies whose particles are bonded. */
    char between[2][SCENE_NAME];
    int body[2];            /* their indices */
    double fracture_energy; /* J/m2, INFINITY: never breaks */
};
struct scene_constraint {
    double low[3], high[3];
    char directions[4];     /* directions: a word of the letters x, y, z; default all */
    int direction[3];       /* 1: prescribed in this direction */
    double velocity[3];     /* default 0 */
    int has_displacement;   /* displacement is prescribed instead of velocity */
    double displacement[3]; /* m */
    struct scene_time time; /* of the velocity or displacement */
    struct scene_turn turn; /* rotation of the region, here and below */
};
struct scene_region {
    double low[3], high[3];
    struct scene_turn turn;
};
struct scene_load {
    enum solid_load_kind kind; /* edge if `edge` is given */
    double low[3], high[3];    /* region: force per unit volume on its particles */
    double force[3];           /* N/m3 */
    double edge[2][2];         /* m, edge of a plate: {from, to} */
    double traction[3];        /* Pa, on the edge */
    int over_horizon;          /* depth of the loaded layer: one layer of particles (0, default) or the horizon (1) */
    struct scene_time time;
    struct scene_turn turn; /* region */
};
/* Displacement at the start: displacement exp(-((x - centre)/width)^2) or displacement sin(2 pi (x - centre)/width),
 * with x along the direction `along`. */
struct scene_initial {
    enum solid_initial_shape shape;
    int along;
    double centre, width;   /* m */
    double displacement[3]; /* m */
};
/* A rigid body that pushes the particles inside it outward; at `centre` at t = 0. */
enum scene_indenter_shape { SCENE_INDENTER_SPHERE };
struct scene_indenter {
    enum scene_indenter_shape shape;
    double centre[3], radius; /* m; in a plate a disc */
    double velocity[3];       /* m/s, default 0 */
    double stiffness;         /* N/m5: force per volume over the square of the depth */
};
struct scene_refined { /* A region that is refined from the start. */
    double low[3], high[3];
    int level; /* 1 ... levels */
    struct scene_turn turn;
};
struct scene_refinement {
    int levels;              /* default 1 */
    double energy;           /* refine if W >= energy W_max; default 0.4, 0: off */
    double damage;           /* refine if the damage is above this value; 0: off (default) */
    double from;             /* s, default 0 */
    double low[3], high[3];  /* refine only in this box; default everywhere (-INFINITY, INFINITY) */
    struct scene_turn turn;  /* of that box */
    int every;               /* steps between checks, default 10 */
    int horizon_kept;        /* horizon: scaled with the spacing (0, default), kept (1) */
    int interface_corrected; /* interface: plain (0, default), corrected (1; 000: eq. 40) */
    int held_refine;         /* held: particles with constraints and loads: keep (0, default), refine (1) */
    int starts;
    struct scene_refined *start; /* start: [...] */
};
/* Element-free Galerkin instead of bonds: meshless/galerkin/galerkin.h has the same members.  (002) */
enum scene_method { SCENE_PERIDYNAMIC, SCENE_ELEMENT_FREE };
struct scene_growth { /* Quasi-static growth of the cracks by the maximum hoop stress. */
    double step;      /* m */
    int steps;        /* at most, default 1000 */
    double until;     /* length that a tip has grown by, m, default INFINITY */
    double radius;    /* of the ring of the interaction integral, m; 0: the step */
    double toughness; /* Pa m^1/2; 0: by the material's fracture energy */
};
struct scene_element_free {
    enum galerkin_basis basis;   /* linear (default), sqrt_r, tip */
    enum galerkin_weight weight; /* cubic (default), quartic */
    double support;              /* spacings, default 2.5 */
    double tip_radius;           /* spacings, default INFINITY */
    int tip_levels;              /* nodes are finer by so many halvings about a tip, default 3 */
    double tip_patch;            /* half width of a level, spacings of the level before, default 2 */
    int cells[2];                /* along x and y; 0: one a spacing */
    int gauss, gauss_tip;        /* points along each direction of a cell, default 4; near a tip, default 6 */
    enum galerkin_method crack;  /* virtual (default), diffraction, visibility */
    double interface_spacing;    /* spacings, default 1 */
    double penalty;              /* over E times the thickness, default 100 */
    double tolerance;            /* default 1e-10 */
    int iterations;              /* at most, default 1000 */
    enum galerkin_update update; /* conjugate (default), hestenes_powell */
    struct scene_growth *growth; /* NULL: the cracks stand still */
};
struct scene_solid {
    double spacing;                          /* m; default the fluid's cell */
    enum physics_model model;                /* of a plate: plane_stress, plane_strain */
    enum scene_method method;                /* of a plate: peridynamic (default), element_free */
    struct scene_element_free *element_free; /* NULL unless the method is element_free */
    double thickness;                        /* of a plate, m, default 1 */
    double lattice_offset[3];                /* in spacings: points are at (i + 1/2 + offset) spacing; default 0 */
    enum solid_partial partial_volume;       /* exact (default), ramp, ramp_cut */
    enum solid_horizons horizons;            /* dual (default), one_sided */
    int materials, bodies, interfaces, cracks, constraints, unbreakables, loads, initials, indenters;
    struct scene_material *material;                            /* materials: [...] */
    struct scene_body *body;                                    /* bodies: [...] */
    struct scene_interface *interface;                          /* interfaces: [...] */
    struct scene_crack *crack;                                  /* cracks: [...] */
    struct scene_constraint *constraint;                        /* constraints: [...] */
    struct scene_region *unbreakable;                           /* unbreakable: [...] */
    struct scene_load *load;                                    /* loads: [...] */
    struct scene_initial *initial;                              /* initial: [...] */
    struct scene_indenter *indenter;                            /* indenters: [...] */
    struct scene_refinement *refinement;                        /* NULL: none */
    enum solid_correction surface_correction;                   /* none, volume, energy (default) */
    enum solid_precision precision;                             /* of the bonds' sweep: double (default), mixed */
    double body_force[3];                                       /* m/s2 */
    int contact;                                                /* contact: {enabled, stiffness, exponent, radius} */
    double contact_stiffness, contact_exponent, contact_radius; /* k_c/c0 = 15, n_c = 1, r_c/spacing = 1 */
};

/* auto: the axis along which the scene drives the fluid, or else slanted as `driving` (scene/medium.h) */
enum scene_medium_direction { SCENE_MEDIUM_AUTO, SCENE_MEDIUM_X, SCENE_MEDIUM_Y, SCENE_MEDIUM_Z, SCENE_MEDIUM_DRIVING };
enum scene_load_form { SCENE_LOAD_REACTION, SCENE_LOAD_PROBE };
struct scene_coupling {
    int forcing_iterations;    /* N_s, default 2 */
    enum solid_depth surface;  /* wetted surface of the bodies: found from the lattice (default), surfaces of the
                                * shapes */
    double retraction;         /* r_d / dx; the default is the calibrated value */
    double probe_length;       /* / dx, default 2 */
    enum scene_load_form load; /* load on the solid: the reaction to the forcing (default where it can be), or from
                                * probes: their values, or these carried to the wall */
    /* medium: {low, high}: the box in which porosity and permeability are measured; default: all bodies' bounds within
     * the domain, the whole period in directions in which a body extends beyond a periodic side, and the whole domain
     * if all its sides are periodic */
    double box_low[3], box_high[3];
    int has_box; /* 0: not given; a body of points has bounds that only its particles know */
    enum scene_medium_direction medium_direction; /* medium.direction: auto (default), x, y, z, driving */
};

/* A boundary-value problem that is solved, not stepped: the sum over |x_j - x_i| <= horizon of (u_j - u_i) V_j /
 * |x_j - x_i|^exponent is given in |x| <= inner_radius, and u in inner_radius < |x| <= outer_radius.  (004: eq. 10) */
struct scene_nonlocal {
    int dimension;                              /* 1, 2, 3 */
    double exponent;                            /* at least 0, below dimension + 2 */
    double horizon, inner_radius, outer_radius; /* m */
    double spacing;                             /* m; or points */
    long points;                                /* their number; 0: from the spacing */
    struct scene_arranged arrangement;          /* as a body's */
    int condition;                              /* the matrix's condition number is computed, default true */
};

enum scene_solid_mode { SCENE_SOLID_RIGID, SCENE_SOLID_ELASTIC };
/* Fluid in cracks below the grid. */
struct scene_injection {
    double low[3], high[3]; /* m */
    int is_pressure;        /* pressure is given instead of rate */
    double rate, pressure;  /* m3/s; Pa */
    struct scene_time time; /* of the rate or the pressure */
};
struct scene_pores {
    double permeability; /* m2 */
    double biot;         /* 1 */
    double modulus;      /* Pa; INFINITY by default */
};
struct scene_crack_fluid {
    double viscosity;          /* Pa s; of the section fluid, if there is one */
    double compressibility;    /* 1/Pa, default 0 */
    double least_pressure;     /* Pa, default 0 */
    double least_aperture;     /* m; 0: auto */
    double leak_off;           /* m/s^(1/2), default 0 */
    struct scene_pores *pores; /* NULL: none */
    int injections;
    struct scene_injection *injection; /* injections: [...] */
};

enum scene_until_quantity { SCENE_UNTIL_PERMEABILITY, SCENE_UNTIL_REST };
struct scene_stage {
    char name[SCENE_NAME];
    long steps;                  /* the most, if it has a duration or `until` */
    double duration;             /* s, after which the stage ends; 0: none */
    double time_step;            /* s; 0: automatic (key left out or "auto") */
    double cfl;                  /* automatic: fraction of the stability limits, default 0.9, 0.36 if a solid moves */
    enum scene_solid_mode solid; /* rigid, elastic; default elastic if there is a solid */
    int relax;        /* true, for a solid alone: static equilibrium by adaptive dynamic relaxation, no time stepping */
    double increment; /* relax: by which the loads' time goes on in each step, s; 0: only one relaxation */
    double tolerance; /* relax: residual over load or reaction, default 1e-6 */
    enum solid_integrator integrator;       /* verlet (default where bonds may break), rk3 (default elsewhere) */
    enum fluid_integrator fluid_integrator; /* rk3 (default), ab2 */
    int substeps;                           /* 0: auto, from the stable step */
    double safety;                          /* auto: fraction of the stable step, default 0.95 */
    int breakage;                           /* default true; false: no bond breaks in this stage */
    double damping_relative;
    double damping_absolute; /* -1: automatic, critical for the slowest motion */
    int crack_fluid;         /* true: the fluid of the section crack_fluid flows in this stage */
    int has_until;           /* until: {...}: the stage ends once the quantity is steady */
    enum scene_until_quantity until_quantity;
    double until_change;  /* relative, over a window and in all that is left */
    double until_kinetic; /* rest: largest kinetic over strain energy */
    int until_window;     /* steps */
};
/* 1: the stage goes on until all is at rest. */
int scene_stage_rests(const struct scene_stage *s);

struct scene_crack_output {
    double damage;       /* the tip is the farthest particle along `direction` with damage above this; default 0.35 */
    double direction[3]; /* default x */
    double window;       /* s, for the tip's speed */
    long every;          /* steps, default 10 */
};
struct scene_intensity { /* Stress-intensity factors of the tips, by domains of these radii. */
    int radii;
    double *radius; /* m */
    /* of a plate with bonds */
    int crack, tip; /* index of the crack, and of its point: the first or the last, 0 or 1; -1: all (default) */
    long every;     /* steps, default 10 */
};
struct scene_probes {
    int places;
    double (*at)[3]; /* m */
    long every;      /* steps, default 10 */
};
struct scene_probe_line {
    double from[3], to[3]; /* m */
    int points;            /* evenly spaced from end to end, both ends included */
};
struct scene_fluid_probes {
    int places, lines;
    double (*at)[3];               /* m */
    struct scene_probe_line *line; /* lines: [...] */
    long every;                    /* steps, default 10 */
};
struct scene_modes {           /* Azimuthal modes of the damage in rings about an axis. */
    double centre[3], axis[3]; /* m, a point of the axis; its direction, default z; a plate's is across it */
    int radii;
    double *radius; /* m, of the rings' borders, ascending */
    int highest;    /* mode, default 12 */
    long every;     /* steps, default 10 */
};
struct scene_output {
    long series_every, fields_every, checkpoint_every; /* steps; 0: never. Defaults 10, auto, 1000; auto: a twentieth
                                                        * of all stages' steps */
    long log_every;                                    /* steps between lines in the log, default 100 */
    long permeability_every;                 /* steps between two rows of intrinsic.csv; 0, the default: none */
    int stress;                              /* stress and strain tensors in solid fields, default true */
    int fragments;                           /* fragments.csv where bonds may break, default true */
    int reactions;                           /* reactions.csv of constraints and loads, default true */
    int bodies;                              /* bodies.csv of several bodies, default true */
    int events;                              /* events.csv of the bonds that break, default false */
    struct scene_crack_output *crack;        /* NULL: no crack is tracked */
    struct scene_intensity *intensity;       /* NULL: none */
    struct scene_modes *modes;               /* NULL: none */
    struct scene_probes *probes;             /* NULL: none */
    struct scene_fluid_probes *fluid_probes; /* NULL: none */
};

struct scene {
    char path[SCENE_PATH]; /* of the file */
    char title[256];
    int dimension; /* 2: a plate in the x-y plane; 3; that of `nonlocal` */
    struct scene_domain domain;
    struct scene_fluid *fluid;             /* NULL: no fluid */
    struct scene_solid *solid;             /* NULL: no solid */
    struct scene_coupling *coupling;       /* NULL unless both */
    struct scene_crack_fluid *crack_fluid; /* NULL: cracks carry no fluid */
    struct scene_nonlocal *nonlocal;       /* NULL: no such problem */
    int stages;                            /* 0: the scene is solved at once */
    struct scene_stage *stage;
    struct scene_output output;
    char *resolved; /* the scene as YAML with every default, itself a valid scene */
};

/* Reads the scene, applies n settings "key.path=value", validates. Every mistake gives one line: file, line, key,
 * value, what is allowed, and the nearest key. All mistakes are reported before the program exits with code 2.
 * Collective: rank 0 reads. */
struct scene *scene_new(const char *path, int n, const char *const *set);
void scene_free(struct scene *s);
/* 1: bonds may break in stage k: it moves a solid, and a material or an interface of it has a limit. */
int scene_stage_may_break(const struct scene *s, int k);
