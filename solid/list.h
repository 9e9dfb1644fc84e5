/* The general store: for each owned particle a list of bonds. Nothing is assumed of where particles stand; volume and
 * horizon may differ from one to the next. Order of a family: by offset on a lattice, by global id otherwise. */
#pragma once
#include "solid/store.h"

struct solid_list {
    struct solid_law law;
    double full_volume; /* V0, m3 */
    int first, n;       /* local indices first .. first+n-1 */
    long bonds;
    long *start;         /* [n+1] */
    long *id;            /* [bonds] global id of the other end, while being set up */
    int *l;              /* [bonds] local index of the other end */
    double *xi[3];       /* [bonds] m */
    double *inv_length2; /* [bonds] 1/|xi|^2 */
    double *weight;      /* [bonds] Gamma V_l, m3 */
    double *alpha;       /* [bonds] */
    uint8_t *intact;     /* [bonds] */
};

struct solid_list *solid_list_new(const struct solid_input *in, const struct solid_body *body,
                                  const struct solid_sites *sites, const struct solid_stencil *stencil,
                                  struct solid_law law, long from, long to, int first);
void solid_list_free(struct solid_list *list);
long solid_list_wanted(const struct solid_list *list, long from, long to, long *id);
void solid_list_link(struct solid_list *list, const struct solid_numbering *numbering);
void solid_list_volumes(const struct solid_list *list, double *family_volume);
void solid_list_weights(struct solid_list *list, const double *family_volume, int surface_correction);
int solid_list_longest(const struct solid_list *list);
/* The bond opposite to bond j of particle h, whose other end is owned here, or -1. */
long solid_list_reverse(const struct solid_list *list, int h, long j);

/* As solid_lattice_force. */
double solid_list_force(struct solid *s, struct solid_list *list, const struct solid_sweep *sweep);
