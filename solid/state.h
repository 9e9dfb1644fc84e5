/* The solid: bond-based peridynamics on material particles.  (001: ch. 3.3)
 *
 * Numbering: each body's particles are numbered by halves of the body, bodies one after another; a rank owns the
 * global ids first[rank] .. first[rank+1]-1 and knows them as 0..n-1. After them come n_ghost ghosts: copies of other
 * ranks' particles that some family here needs. The state is the displacement d = X - X0, never X, so that stretches of
 * 1e-4 keep their digits. */
#pragma once
#include "base/signals.h"
#include "solid/input.h"

struct par_ghost;
struct solid_family; /* opaque: the bonds, solid/bonds/family.h */
struct solid_soft;   /* opaque: solid/bonds/soft.h */
struct solid_breaks; /* opaque: solid/bonds/breaks.h */
struct solid_contact;
struct solid_added_mass;
struct solid_drag;
struct solid_external_loads; /* opaque: the loads of the input, solid/imposed/external_loads.h */
struct solid_reactions;      /* opaque: sums of reactions, solid/imposed/reactions.h */
struct solid_indent;         /* opaque: solid/imposed/indenter.h */
struct solid_walls;          /* opaque: solid/imposed/walls.h */
struct solid_refine;         /* opaque: the state of refinement, solid/refine/refine.h */
struct solid_push;
struct solid_absorbed;   /* opaque: solid/force/absorbed.h */
struct solid_dilatation; /* solid/force/dilatation.h */
struct solid_rk3_loss;   /* opaque: solid/step/rk3_loss.h */

/* Set at the start of each stage of a run. */
struct solid_stage {
    enum solid_integrator integrator;
    int breakage;            /* 0: no bond breaks */
    double damping_relative; /* k_d, N s/m^7 (pairwise, along the bond), 0: off */
    double damping_absolute; /* k_a, 1/s, 0: off */
};

/* What e_damped also contains, for velocity Verlet with pairwise damping (solid/step/balance.h). */
enum solid_balance {
    SOLID_BALANCE_NONE,
    SOLID_BALANCE_BONDS,  /* strain energy and e_fracture */
    SOLID_BALANCE_CONTACT /* these, and the energy of explicit contact */
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
    /* Parameters: set by solid_new, and again by a refinement; read-only otherwise. */
    struct solid_input in;    /* copy of the input; body, material and the other arrays are owned copies */
    int dim;                  /* 2: a plate, component [2] of x0, d, v, a, load, v_old, a_old is NULL; 3 */
    struct solid_stage stage; /* set at the start of a stage */
    long n_global;
    long *first; /* [size+1] */
    int n, n_ghost;
    struct par_ghost *ghost;
    double *x0[3];                        /* [n + n_ghost] m */
    double *volume;                       /* [n + n_ghost] m3 */
    double *family_volume;                /* [n + n_ghost] V_h = sum Gamma V of the unbroken family, m3 */
    uint8_t *body;                        /* [n + n_ghost] */
    uint8_t *material;                    /* [n + n_ghost]; NULL: each body is of one material */
    const struct solid_added_mass *added; /* borrowed, NULL: none (solid/imposed/added_mass.h) */
    const struct solid_drag *drag;        /* borrowed, NULL: none (solid/force/drag.h) */
    const struct solid_push *push;        /* borrowed, NULL: none (solid/step/push.h) */
    int is_quasi_static; /* 1: what softens between two states of rest releases the energy under its law (sweep_soft.c)
                          */
    long bonds_total;    /* undirected, whole solid, of the families as made at the start or by a refinement */

    /* State: exactly what the table in solid/state_table.c lists; tests/coupling/test_state.c checks that it has every
     * member from d to stage_of_a. */
    double *d[3];     /* [n + n_ghost] displacement X - X0, m */
    double *v[3];     /* [n + n_ghost] velocity, m/s */
    double *load[3];  /* [n] external force per unit volume F_h, N/m3: that of solid/imposed/external_loads.h, and what
                         the coupling writes */
    double *v_old[3]; /* [n] bonds' part of the last sweep's a (Verlet), with contact's where a push needs it; RK3:
                         work, the stage's before v */
    uint8_t *flag;    /* [n + n_ghost] enum solid_flag; SOLID_HELD_* and UNBREAKABLE valid on ghosts */
    struct solid_family *family;   /* the bonds' lambda; the rest of it are parameters and work */
    struct solid_soft *soft;       /* softening bonds and their histories; NULL: all materials are brittle */
    struct solid_contact *contact; /* NULL until something can touch */
    double *stretch_limit;         /* [n + n_ghost] the stretch at which a particle's bonds break in the next step; work
                                    * on ghosts; NULL: no material's limit follows the other bonds */
    struct solid_external_loads *external_loads; /* the factors of the loads now in `load`; NULL: none */
    struct solid_refine *refine;                 /* the particles' levels; NULL: nothing is refined */
    long *fragment;              /* [n] number of the fragment at the last update, -1: none yet; NULL: they
                                  * are not followed (solid/measure/detachment.h) */
    double *fragment_since;      /* [n] when that fragment came off, s */
    struct solid_breaks *breaks; /* the bonds that broke and wait to be read; NULL: nobody asks for them */
    double t;                    /* s; advanced by the integrators; a caller may set it */
    /* energies, this rank's share */
    double e_damped;       /* dissipated by damping so far plus `balance`, J; solid_energy_measure: without it */
    double e_fracture;     /* energy released by broken bonds so far, J: sum of (1/2) c s^2 |xi| Gamma V V at
                            * breaking, with velocity Verlet s times the stretch of the substep before for s^2
                            * (solid/force/absorbed.h); by softening bonds the same times the part of the stiffness that
                            * they lose */
    double crack_area;     /* of the bonds broken so far, m2: the energy that each holds at its critical stretch, over
                            * the fracture energy; initial cracks do not count */
    double e_constraint;   /* work of driven layers so far, J */
    double work_load;      /* work of load and body force so far, J */
    double e_integrator;   /* what the integrator has taken from kinetic, strain and contact energy so far, J
                            * (solid/step/verlet.c, rk3_loss.c) */
    long balance;          /* enum solid_balance; the same on all ranks */
    double power_pairwise; /* power_damped of the sweep that v_old belongs to, W (Verlet) */
    long bonds_broken;     /* undirected, whole solid; valid after solid_family_count */
    int broke;   /* bits: readers that have not yet processed the newly broken bonds (solid/bonds/broken_tracker.h) */
    int a_holds; /* 1: a belongs to the present d, v and bonds (Verlet); code that changes one of them clears
                  * it */
    struct solid_stage stage_of_a;

    /* Work: found again in each sweep. */
    double *a[3];     /* [n] acceleration of the last force sweep, m/s2 */
    double *a_old[3]; /* [n] a before (Verlet); rate of v of the stage before (RK3) */
    /* of the last force sweep, this rank's share, W */
    double power_damped, power_load, power_constraint;
    double damped_missed; /* what absolute damping has taken since the program began, less what e_damped has of it, J,
                           * this rank's share (solid/step/absolute.h) */
    struct solid_absolute *absolute; /* NULL: no substep with absolute damping yet */
    /* force of absolute damping on all particles, in the last sweep and the one before, N, and its impulse so far in
     * the step, N s; this rank's share (solid/imposed/damping.h) */
    double damping_now[3], damping_then[3], damping_impulse[3];
    double power_indented;               /* the part of power_load due to the indenters */
    struct solid_dilatation *dilatation; /* NULL: bonds alone have each material's Poisson's ratio */
    struct solid_absorbed *absorbed;     /* NULL: no bond has broken with velocity Verlet (solid/force/absorbed.h) */
    double *stretch_limit_next;          /* [n] stretch_limit of the next step; NULL as stretch_limit */
    struct solid_indent *indent;         /* NULL: no indenter */
    struct solid_walls *walls;           /* NULL: no side of the domain stops particles */
    struct solid_reactions *reactions;   /* of the last step; NULL: nobody asks for them */
    enum signals_reason stops;           /* why a relaxation, or a step of many substeps, was given up; 0: it was not */
    struct solid_rk3_loss *rk3_loss;     /* NULL: no step of RK3 yet (solid/step/rk3_loss.h) */

    /* Counters: they only rise, and no step depends on their values. */
    long sweeps;   /* force sweeps so far */
    long versions; /* version numbers given so far to states of the bonds and of contact's record (solid/snapshot.h) */
    long bonds_version; /* version of the bonds; changes whenever kept bonds are restored */
};

/* The present position X0 + d; z is 0 in a plate. */
static inline void solid_position(const struct solid *s, int h, double x[3]) {
    x[2] = 0;
    for (int c = 0; c < s->dim; c++) x[c] = s->x0[c][h] + s->d[c][h];
}

/* The shortest of x and its images across periodic sides. */
static inline double solid_shortest(const struct solid *s, int c, double x) {
    return s->in.periodic[c] ? x - s->in.length[c] * __builtin_rint(x / s->in.length[c]) : x;
}

/* The present X_l - X_h, to the nearest periodic image, m. */
static inline void solid_relative(const struct solid *s, int h, int l, double zeta[3]) {
    for (int c = 0; c < 3; c++) {
        zeta[c] = solid_shortest(s, c, (s->x0[c][l] - s->x0[c][h]) + (s->d[c][l] - s->d[c][h]));
    }
}

/* The index of its material. */
static inline int solid_particle_material(const struct solid *s, int h) {
    return s->material ? s->material[h] : s->in.body[s->body[h]].material;
}

/* Of the particle's material, kg/m3. */
static inline double solid_density(const struct solid *s, int h) {
    return s->in.material[solid_particle_material(s, h)].density;
}

/* The end of those particles h, h + 1, ... below `to`, all of one body, that have the density of h. */
static inline int solid_density_end(const struct solid *s, int h, int to) {
    if (!s->material) return to;
    const double density = solid_density(s, h);
    while (h < to && solid_density(s, h) == density) h++;
    return h;
}
