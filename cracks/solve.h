/* The pressures of one substep: conjugate gradients within an active set.
 *
 *     A = S + dt L + dt^2 B^T M^-1 B            symmetric, positive where every wet particle has a link
 *     A p - cavity = b ,   p >= p_cav ,   cavity >= 0 ,   (p - p_cav) cavity = 0 */
#pragma once
#include "cracks/cracks.h"

enum cracks_set {
    CRACKS_FULL,   /* p is free, no cavity */
    CRACKS_CAVITY, /* p = p_cav */
    CRACKS_GIVEN   /* an injection gives p */
};

struct cracks_work {
    int capacity, slot_capacity;
    long link_capacity;
    uint8_t *set;                   /* [n] enum cracks_set */
    double *b;                      /* [n] a volume, m3 */
    double *residual;               /* [n] b - A p, m3; of a cavity the void with a minus sign */
    double *conductance;            /* [links of the rows][8] T_hl, m3/(s Pa) */
    float *smooth;                  /* the same in single precision, for the preconditioner */
    double *outflow;                /* [by slot] the sum of a particle's T */
    double *width;                  /* [n + ghosts] aperture w_h, m */
    double *diagonal;               /* [n] diagonal of the preconditioner's P, m3/Pa */
    double *search;                 /* [n + ghosts] direction of the search */
    double *along;                  /* [n] A search */
    double *z;                      /* [n + ghosts] the preconditioned residual */
    double *left, *weight, *change; /* [by slot] of the preconditioner: residual, inverse, last change */
    double *of_ones;                /* [n] A 1, with 1 at the full particles */
    double ones;                    /* 1.A 1 */
    uint8_t *ones_set;              /* [n] the set that ones_stiff is of */
    double *ones_stiff;             /* [n] dt^2 B^T M^-1 B 1, for the step ones_dt */
    double ones_dt;
    int ones_hold;   /* 1: they are those of the present struts */
    int force_holds; /* 1: force is B p of the present struts and p */
    double span;     /* of the spectrum that the preconditioner's polynomial is made for */
    int terms;       /* of the polynomial */
    int bricks;      /* 1: the preconditioner has the part of the bricks */
    struct cracks_coarse *coarse;
    cracks_vec *force; /* [n] B p, N */
    cracks_vec *u;     /* [n + ghosts] a displacement, m */
};

/* Room for the present struts. Not collective. */
struct cracks_work *cracks_solve_workspace(struct cracks_work *w, const struct cracks_struts *t);
void cracks_solve_free(struct cracks_work *w);
/* From p, set and residual to those of the solution, with force = B p. p of the set CRACKS_GIVEN stays. injected: the
 * sum of dt |Q|; size: volume that rounding is compared to, m3. Returns 1; 0: the set does not settle or the iteration
 * does not converge, and c->status says which. Collective. */
int cracks_solve(struct cracks *c, double dt, double injected, double size);
