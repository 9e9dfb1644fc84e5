/* The form in which each bond was computed last, which the next sweep begins with. Sweeps between steps leave no trace
 * if it is kept before them and restored after. For solid/ only. */
#pragma once
#include "solid/state.h"

struct solid_forms; /* opaque */
/* restore also frees. Not collective. */
struct solid_forms *solid_forms_save(const struct solid *s);
void solid_forms_restore(struct solid *s, struct solid_forms *forms);
