/* Markers that stand beside their particles: place, velocity and force by the same weights of near particles. */
#pragma once

struct solid;

/* Marker i of the interface particle h stands at a shift from it. Its place and velocity are
 *
 *     X_m = X_h + sum_l g_l (X_l - X_h) ,   V_m = V_h + sum_l g_l (V_l - V_h) = (N V)_m ,
 *
 * over the near particles l that intact bonds join to h. A force F on the marker is given to l as g_l F and to h as
 * (1 - sum_l g_l) F, which is N^T F. So force, couple and power are the same for the markers and for the particles,
 * whatever the weights are, and a body that turns carries its markers with it. */
enum { SOLID_ATTACHMENT_MAX = 18 }; /* near particles of a marker */

/* The weights of one marker, and what they were found from. */
struct solid_attachment_weights {
    double own;                         /* 1 - sum of g_l */
    double share[SOLID_ATTACHMENT_MAX]; /* [n] g_l */
    int other[SOLID_ATTACHMENT_MAX];    /* [n] l, owned or ghost */
    int n;
    int intact; /* bonds of h then; -1: nothing has been found yet */
    int faces, open;
    double shift; /* m */
};

struct solid_attachment {
    int n;        /* markers */
    const int *h; /* [n] owned particles, each at most once; borrowed from the surface */
    const struct solid_attachment_weights **weights; /* [n] in `pool` */
    double *inverse_mass; /* [n] D, 1/kg: at least the sum over a row of |N M^-1 N^T|, with the masses M */
    double *given[3];     /* [s->n + s->n_ghost] N^T force of the last solid_attachment_spread */
    /* Work of all impulses since the last check: J.(N V) and (N^T J).V, which are equal when summed over all ranks, and
     * the sum of |J.(N V)| by components, J */
    double work_at_markers, work_at_particles, work_size;
    double work_of_drag; /* of the impulses on this rank's particles, with those that are held, since it was set, J */
    int capacity;        /* of `weights` and `inverse_mass` */
    /* the weights of all particles that have been on the interface (solid/surface/attach.c) */
    struct solid_attachment_weights **pool; /* [chunks] */
    int pooled, chunks;
    int *place; /* [s->n] in the pool, -1: none */
    long bonds_version;
};

/* X_m - X_h, m. Ghosts must be current. Not collective. */
void solid_attachment_arm(const struct solid_attachment *a, const struct solid *s, int i, double arm[3]);
/* V_m, m/s. The velocities of ghosts must be current. Not collective. */
void solid_attachment_velocity(const struct solid_attachment *a, const struct solid *s, int i, double v[3]);
/* given <- N^T force: force [n][3], N. Collective. */
void solid_attachment_spread(struct solid_attachment *a, const struct solid *s, const double (*force)[3]);
/* Sends the velocities of ghosts. Collective. */
void solid_attachment_refresh(struct solid *s);
