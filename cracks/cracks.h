/* Fluid in cracks below the grid: every broken bond is a strut that a pressure acts on.  (docs/design/cracks.md)
 *
 * A wet particle is one with a broken bond; with pores every particle is wet. Each has one pressure. A rank numbers its
 * wet particles 0..n-1 by ascending local index; after them come ghosts: copies of other ranks' wet particles that a
 * strut or a link here needs. */
#pragma once
#include "base/step_status.h"
#include "cracks/rows.h"
#include "solid/input.h"
#include "solid/step/push.h"

struct par_ghost;
struct cracks_outlets; /* cracks/outlet.h */
struct cracks_work;    /* cracks/solve.h */

/* What enters the cracks through the wet particles of a box (X0). */
struct cracks_injection {
    double low[3], high[3];
    int is_pressure;        /* 1: value is the pressure there, Pa; 0: it is the rate, m3/s */
    double value;           /* times the factor of time; of a plate m3/s of its thickness */
    struct solid_time time; /* borrowed during cracks_new */
};

/* The fluid in the intact solid. */
struct cracks_pores {
    double permeability; /* k0, m2 */
    double biot;         /* alpha, 0 to 1 */
    double modulus;      /* Biot's M, Pa; INFINITY: neither the fluid nor the grains are compressible */
};

struct cracks_input {
    double viscosity;       /* Pa s */
    double compressibility; /* 1/Pa */
    double least_pressure;  /* Pa; below it a crack is not full */
    double least_aperture;  /* m, of the conductance; 0: CRACKS_LEAST_STRETCH times the largest critical stretch times
                             * the spacing */
    double leak_off;        /* Carter's coefficient of one face, m/s^(1/2); not with pores */
    int porous;             /* 1: the intact solid holds fluid too */
    struct cracks_pores pores;
    int outside; /* 1: a resolved fluid stands outside the solid, and in cracks that are wide open; not with pores */
    int injections;
    const struct cracks_injection *injection; /* borrowed during cracks_new */
};

#define CRACKS_LEAST_STRETCH 0.3

/* The geometry of the wet particles: rebuilt where bonds have broken. */
struct cracks_struts {
    int n, ghosts;        /* wet particles owned here, and copies of other ranks' */
    int *h;               /* [n + ghosts] local index in the solid, ascending in each of the two parts */
    int *place;           /* [n + ghosts] in the rows */
    int *slot;            /* [n] 8 row + lane */
    cracks_vec *mobility; /* [n + ghosts] 1/mass of each component, 1/kg; 0: held */
    double *rate[3];      /* [by slot] mobility of the rows' owned particles; 0 in other lanes */
    int served;           /* copies that other ranks have of owned wet particles */
    const int *serve;     /* [served] their wet indices, borrowed from the plan */
    cracks_vec *area;     /* [n] a_h, m2 */
    double *area_size; /* [n + ghosts] |a_h|, or where the faces of several cracks cancel the area along the main axis
                        * of the struts, m2 */
    double *diagonal;  /* [n] of B^T M^-1 B, m4/kg */
    struct cracks_rows rows;
    struct par_ghost *plan;
    struct par_ghost *near; /* of the ghosts that a link here ends at, which are fewer */
    int nears;
    int *near_index;    /* [nears] their wet indices */
    long *id;           /* [solid's n + n_ghost] number of a wet particle among those of all ranks, -1: not wet */
    long bonds_version; /* of the solid when they were made */
    long version;       /* counts the times that other particles became wet */
};

struct cracks {
    /* Parameters */
    struct cracks_input in; /* with an owned copy of the injections */
    struct solid *solid;    /* borrowed */
    struct cracks_table table;
    double least_aperture;  /* m */
    double gap;             /* m; with a fluid outside a strut whose ends have moved farther apart is off */
    struct solid_push push; /* for solid->push */

    /* State: what the table in cracks/state_table.c lists. Arrays by wet particle. */
    double *p;         /* [n + ghosts] pressure, Pa */
    double *content;   /* [n] volume of fluid that belongs to the particle, m3 */
    double *cavity;    /* [n] void that is not filled, m3 */
    double *volume;    /* [n] crack volume at the end of the last substep, m3 */
    double *storage;   /* [n] S_h of the last substep, m3/Pa */
    cracks_vec *share; /* [n] the pressure's force per volume in solid->load, N/m3 */
    double *since;     /* [n] when a particle was full for the first time, s; -1: not yet. NULL: nothing leaks off */
    double *injected;  /* [injections] volume so far, m3, the same on all ranks */
    double *rate;      /* [injections] of the last substep, m3/s */

    double leaked; /* volume that leaked off so far, m3, the same on all ranks */
    double filled; /* volume in the pores when the fluid first flowed, m3, the same on all ranks */
    int began;     /* 1: it has flowed */

    /* With a fluid outside. */
    double entered;  /* volume that came in through the outlets so far, m3, the same on all ranks */
    double resolved; /* volume of fluid in struts that were switched off so far, m3, the same on all ranks */
    double handed;   /* volume that the fluid outside has given so far, m3, the same on all ranks */
    struct cracks_outlets *outlets; /* their places and rates; NULL: no fluid outside */

    /* Work */
    struct cracks_struts struts;
    double *open;    /* [n] with pores: the part of the volume that broken bonds hold, m3; else NULL */
    double *leak;    /* [n] volume that leaks off in the substep, m3; NULL: nothing leaks off */
    int restored;    /* 1: the state was restored: the struts must be rebuilt, and new ones contain no void */
    int stale;       /* 1: the struts must be rebuilt although no bond has broken */
    double *weight;  /* [injections][n] part of an injection that a particle takes */
    long *particles; /* [injections] wet particles that take part, of all ranks */
    struct cracks_work *work;
    struct step_status status; /* of the last substeps; failed: no pressures were found */

    /* Counters */
    long steps, solves, iterations, renewals;
};

/* Dies (exit 2) on a solid whose cracks cannot carry fluid, and on an injection that touches no broken bond.
 * Collective.
 */
struct cracks *cracks_new(const struct cracks_input *in, struct solid *s);
void cracks_free(struct cracks *c);
/* Puts the fluid into the solid's steps, or takes it and its load out of them. Collective. */
void cracks_begin(struct cracks *c, int flows);
/* The same in the midst of a stage, after the state was restored: its struts are those of the restored bonds, and to
 * find them again would change the last digits of the volumes. Collective. */
void cracks_resume(struct cracks *c, int flows);
