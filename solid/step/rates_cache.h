/* A cache of rates that earlier runs have computed, in the user's cache folder (docs/run-folder.md). A solid is
 * recognised by the first numbers of its Lanczos iterations, which depend on every bond, particle and held direction.
 * They are compared to the last bit, so a rate from the cache is the one that the iteration would give again. */
#pragma once
#include "solid/step/stable.h"

enum { SOLID_RATES_MARK = 4 }; /* the first two diagonal numbers and the first two beside the diagonal */

struct solid_rates_mark {
    double stiffness[SOLID_RATES_MARK], damping[SOLID_RATES_MARK]; /* of Lanczos's matrices; 0 without damping */
    double particles, ranks, threads;                              /* sums round differently on other ranks */
};

/* 1: the cache has a solid with this stiffness, perhaps with another damping. Collective. */
int solid_rates_cache_like(const struct solid_rates_mark *mark);
/* 1: the cache has the solid; sets *rates except `absolute`. Collective. */
int solid_rates_cache_find(const struct solid_rates_mark *mark, struct solid_rates *rates);
/* Adds the solid's rates to the file, which holds the newest 100. Without a cache folder nothing happens. Collective.
 */
void solid_rates_cache_add(const struct solid_rates_mark *mark, const struct solid_rates *rates);
