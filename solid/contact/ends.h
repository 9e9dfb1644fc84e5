/* Copies of the particles in contact's lists, so that the forces on few pairs do not read a whole solid. For solid/
 * only. */
#pragma once
#include "solid/contact/list.h"

struct solid_contact_end {
    double d[3];    /* displacement now, m; third 0 in a plate */
    double push[3]; /* work of solid_contact_force: acceleration, m/s2 */
    double volume;  /* m3 */
    int particle;   /* local index; of a served particle SOLID_CONTACT_SERVED_END - its number */
    uint8_t body, material;
};
enum { SOLID_CONTACT_SERVED_END = -1, SOLID_CONTACT_END_DOUBLES = sizeof(struct solid_contact_end) / sizeof(double) };

/* Constants of the listed pairs: r_c, m, and k_c V_l/rho_h, k_c V_h/rho_l (0: l is not owned), m/s2. */
struct solid_contact_constants {
    double *radius, *on_h, *on_l;
    int capacity[3];
};

struct solid_contact_ends {
    int n, capacity, particle_capacity;
    struct solid_contact_end *end; /* [n] */
    int *particle; /* [n] copy of the end's `particle`, for loops over all ends that read nothing else */
    int *end_of;   /* [s->n + s->n_ghost] 1 + the end of a particle; 0: none */
    int *of_served, served_capacity; /* [ghosts.served] */
    int pairs[SOLID_CONTACT_KINDS];  /* number of pairs whose ends are known */
    int *h[SOLID_CONTACT_KINDS], *l[SOLID_CONTACT_KINDS],
        pairs_capacity[2][SOLID_CONTACT_KINDS];                  /* [pairs] their ends */
    struct solid_contact_constants of_pair[SOLID_CONTACT_KINDS]; /* [pairs]; these, too, are read a vec at a time */
};

struct solid_contact_ends *solid_contact_ends_new(const struct solid *s);
void solid_contact_ends_free(struct solid_contact_ends *ends);
/* To be called when lists are rebuilt or exchanged. */
void solid_contact_ends_invalidate(struct solid_contact_ends *ends);
/* Adds the ends of new pairs, and updates the served particles. Ends of lists that are made again are in the order of
 * the particles. Collective. */
void solid_contact_ends_list(const struct solid *s, struct solid_contact *c);
/* The same, and updates d of all ends. Ghosts must be current. Collective. */
void solid_contact_ends_update(const struct solid *s, struct solid_contact *c);
