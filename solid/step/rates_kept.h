/* Rates that earlier runs have found, in the user's cache folder (docs/run-folder.md). A solid is known by the first
 * numbers of its iterations: they depend on every bond, particle and held direction. They are compared to the last bit,
 * so what is taken is what the iteration would give again. */
#pragma once
#include "solid/step/stable.h"

enum { SOLID_RATES_MARK = 4 }; /* the first two diagonal numbers and the first two beside the diagonal */

struct solid_rates_mark {
    double stiffness[SOLID_RATES_MARK], damping[SOLID_RATES_MARK]; /* of Lanczos's matrices; 0 without damping */
    double particles, ranks, threads;                              /* sums round differently on other ranks */
};

/* 1: some solid with this stiffness is known; its damping may be another one. Collective. */
int solid_rates_kept_like(const struct solid_rates_mark *mark);
/* 1: the solid is known, and *rates are set but for `absolute`. Collective. */
int solid_rates_kept_find(const struct solid_rates_mark *mark, struct solid_rates *rates);
/* Adds the solid's rates to the file, which holds the newest 100. Without a cache folder nothing happens. Collective.
 */
void solid_rates_kept_add(const struct solid_rates_mark *mark, const struct solid_rates *rates);
