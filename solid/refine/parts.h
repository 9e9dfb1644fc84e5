/* Refinement's own state and steps. For solid/ only. */
#pragma once
#include "solid/refine/area.h"
#include "solid/refine/refine.h"

struct solid_refine {
    struct solid_refinement in;       /* the start regions are owned */
    struct solid_refine_cells *cells; /* [bodies] area NULL: not a polygon, or not computed yet */
    int bodies, cuts;
    const struct solid_body *body; /* of the input, borrowed; outlines are owned */
    const struct solid_cut *cut;   /* owned */
    int capacity;                  /* of the arrays of struct solid, in particles, owned and ghosts */
    long events;
    int criteria_capacity; /* of mark and energy, work of solid_refine_criteria */
    uint8_t *mark;
    double *energy; /* J/m3 */
};

/* 1: the body is a polygon, whose particles may be refined. */
int solid_refine_plan_is_possible(const struct solid *s, int body);
/* A plan of the body's present particles. locked [cloud->n] or NULL. Not collective. */
struct solid_refine_plan *solid_refine_plan_of(const struct solid *s, int body, const uint8_t *locked);
/* The new cloud of a plan. New particles are on the ranks of their parents; a rank's old particles keep their order,
 * and its new ones come after them. was [n] (owned by the caller): numbers in the plan; count [size]: number of
 * particles by rank. Not collective. */
struct solid_cloud *solid_refine_cloud(const struct solid *s, int body, const struct solid_refine_plan *plan,
                                       long first, long **was, long *count);
/* Applies the plans of the solid's bodies (NULL: an unchanged body). Collective. */
void solid_refine_apply(struct solid *s, struct solid_refine_plan *const *plan);
/* Makes arrays for n particles, owned and ghosts; the owned particles' values are kept. Not collective. */
void solid_refine_apply_reserve(struct solid *s, int n);

/* Broken bonds with an end that is a parent, or a parent's parent and so on, of a new particle. Numbers in the cloud
 * before. */
struct solid_refine_broken;
struct solid_refine_broken *solid_refine_broken_new(const struct solid *s, int body,
                                                    const struct solid_refine_plan *plan);
void solid_refine_broken_free(struct solid_refine_broken *broken);
/* Breaks the bonds of new particles, and bonds to them, if the bonds between their parents were broken. was: numbers in
 * the plan. Not collective. */
struct solid_list;
void solid_refine_broken_inherit(const struct solid_refine_broken *broken, struct solid_list *list,
                                 const struct solid_cloud *cloud, const long *was);

/* Adds the boundary between two points to the particles, by number in the body's cloud, m. Returns 0 if no boundary
 * joins the points. Not collective. */
int solid_refine_area_lengths(const struct solid *s, int body, const double from[2], const double to[2],
                              double *length);
