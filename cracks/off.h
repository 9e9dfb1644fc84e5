/* Which struts are off: where a crack stands so wide open that the fluid outside is resolved in it.
 *
 * A strut is off while its ends have moved apart by more than c->gap, the same distance at which the crack's faces
 * become a part of the solid's surface. Its kind is then that of an intact bond in the table, whose weight is 0. */
#pragma once
#include "cracks/cracks.h"

/* Whether a strut is off whose ends have moved apart by a vector, m. Not collective. */
int cracks_off_is(const struct cracks *c, cracks_vec jump);
/* The switches of the struts that were there before they were made anew: old_* describe the old ones. Not collective.
 */
void cracks_off_keep(struct cracks *c, int old_n, const int *old_h, const long *old_start, const uint16_t *old_kind);
