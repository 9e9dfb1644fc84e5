/* A body's particles after a refinement, with their levels. The same on all ranks. For solid/ only. */
#pragma once
#include "solid/body/cloud.h"

/* Coordinates are in 1/64 of the spacing, from the cloud's origin: exact at all levels. */
enum { SOLID_REFINE_UNIT = 64, SOLID_REFINE_PARENTS = 4 };

/* A new particle: its values are the weighted sum over its sources, sum of weight value(source). */
struct solid_refine_interpolated {
    int parents;
    long parent[SOLID_REFINE_PARENTS];
    long source[SOLID_REFINE_PARENTS]; /* weight 0: none */
    double weight[SOLID_REFINE_PARENTS];
};

struct solid_refine_plan {
    const struct solid_cloud *cloud;                /* borrowed: the present cloud */
    const struct solid_body *body;                  /* borrowed */
    const struct solid_refinement *in;              /* borrowed */
    double ratio;                                   /* the material's m */
    int period[2];                                  /* 0: not periodic */
    long before, n, capacity;                       /* particles of the cloud; with new ones; capacity */
    int (*at)[2];                                   /* [n] */
    uint8_t *level, *locked;                        /* [n]; locked: 1: must not be refined */
    struct solid_refine_interpolated *interpolated; /* [n - before] */
    long refined;                                   /* number of particles that were refined */
    long mask, *slot; /* hash table from positions to numbers, open addressing: [mask + 1] number +
                       * 1 */
};

void solid_refine_plan_free(struct solid_refine_plan *plan);
/* Refines the marked particles; on request all of their families (000: criterion of visibility); the particles that
 * must be refined so that neighbours differ by at most one level; and those with particles on more than five of the
 * eight positions around them (000: "incolla"). */
void solid_refine_plan_close(struct solid_refine_plan *plan, const long *marked, long n, int families);

/* The new particle of a level at an empty position, from the present particles. */
struct solid_refine_interpolated solid_refine_interpolate_at(const struct solid_refine_plan *plan, const int at[2],
                                                             int level);

static inline int solid_refine_plan_spacing(int level) { return SOLID_REFINE_UNIT >> level; }
/* delta of a particle, spacings. */
double solid_refine_plan_horizon(const struct solid_refine_plan *plan, long i);
/* Level of a cloud's particle. */
int solid_refine_plan_level(double size);
