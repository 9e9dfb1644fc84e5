/* The solid: bond-based peridynamics on material particles.  (001: ch. 3.3)
 *
 * Numbering: each body's particles are numbered along a space-filling curve, bodies one after another; a rank owns the
 * global ids first[rank] .. first[rank+1]-1 and knows them as 0..n-1. After them come n_ghost ghosts: copies of other
 * ranks' particles that some family here needs. The state is the displacement d = X - X0, never X, so that stretches of
 * 1e-4 keep their digits. */
#pragma once
#include "solid/input.h"

struct par_ghost;
struct solid_family; /* opaque: the bonds, solid/bonds/family.h */
struct solid_contact;
struct solid_added_mass;
struct solid_given;  /* opaque: the loads of the input, solid/imposed/given.h */
struct solid_refine; /* opaque: the state of refinement, solid/refine/refine.h */

enum solid_integrator { SOLID_RK3, SOLID_VERLET };

/* Set at the start of each stage of a run. */
struct solid_stage {
    enum solid_integrator integrator;
    int breakage;            /* 0: no bond breaks */
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
    struct solid_input in; /* copy of the input; body, material and the other arrays are owned copies */
    int dim;               /* 2: a plate, component [2] of x0, d, v, a, load, v_old, a_old is NULL; 3 */
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
    /* state, [n + n_ghost]; with the bonds' lambda and t, the content of a checkpoint */
    double t;     /* s; advanced by the integrators; a caller may set it */
    double *d[3]; /* displacement X - X0, m */
    double *v[3]; /* velocity, m/s */
    /* work, [n] */
    double *a[3];    /* acceleration of the last force sweep, m/s2 */
    double *load[3]; /* external force per unit volume F_h, N/m3: the input's loads, and those of the coupling */
    struct solid_given *given;            /* NULL: none */
    const struct solid_added_mass *added; /* borrowed, NULL: none (solid/force/added_mass.h) */
    struct solid_family *family;
    struct solid_contact *contact; /* NULL until something can touch */
    struct solid_refine *refine;   /* NULL: no refinement */
    /* counters and energies, this rank's share */
    long bonds_total;    /* undirected, whole solid, of the families as made at the start or by a refinement */
    long bonds_broken;   /* undirected, whole solid; valid after solid_family_count */
    int broke;           /* set of enum solid_broke bits: a bond of an owned particle broke since each reader last
                          * asked */
    double e_damped;     /* energy dissipated by damping so far, J */
    double e_fracture;   /* energy released by broken bonds so far, J: sum of (1/2) c s^2 |xi| Gamma V V at breaking */
    double e_constraint; /* work of driven layers so far, J */
    double work_load;    /* work of load and body force so far, J */
    /* of the last force sweep, this rank's share, W */
    double power_damped, power_load, power_constraint;
    double power_added; /* the part of power_load due to the added mass */
    long sweeps;        /* force sweeps so far */
    long versions;      /* version numbers given so far to states of the bonds and of contact's record (solid/keep.h) */
    long bonds_version; /* version of the bonds; changes whenever kept bonds are restored */
    /* work of the integrators, [n]: rates of the last stage (RK3); the bonds' and contact's part of a, the last a
     * (Verlet) */
    double *v_old[3], *a_old[3];
    int a_holds; /* 1: a belongs to the present d, v and bonds (Verlet); code that changes one of them clears it */
    struct solid_stage stage_of_a;
    double power_pairwise; /* of the sweep that v_old comes from, W (Verlet) */
};

/* The present position X0 + d; z is 0 in a plate. */
static inline void solid_position(const struct solid *s, int h, double x[3]) {
    x[2] = 0;
    for (int c = 0; c < s->dim; c++) x[c] = s->x0[c][h] + s->d[c][h];
}
