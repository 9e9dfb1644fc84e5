/* The wet particles, their struts and links: found from the solid's broken bonds. */
#pragma once
#include "cracks/cracks.h"

/* Makes the struts again. The arrays of the state follow: a particle that is wet now and was not before has the least
 * pressure and no fluid. Collective. */
void cracks_struts_renew(struct cracks *c);
/* Whether bonds have broken, or were restored, since the struts were made; the same on all ranks. Clears the solid's
 * mark. Collective. */
int cracks_struts_changed(struct cracks *c);
/* Areas and diagonals of a row's particles, from their struts that are on. The rows' u holds the mobilities: the first
 * puts them there. Not collective. */
void cracks_struts_areas_begin(const struct cracks_struts *t);
void cracks_struts_areas(struct cracks *c, int row);
/* The wet index of the solid's particle h, which is owned here; -1: not wet. Not collective. */
static inline int cracks_struts_wet(const struct cracks_struts *t, int h) {
    return t->n > 0 && t->id[h] >= 0 ? (int)(t->id[h] - t->id[t->h[0]]) : -1;
}
void cracks_struts_free(struct cracks_struts *t);
/* Copies records of so many bytes from the owners to the ghosts; record [n + ghosts]. Collective. */
void cracks_struts_update(const struct cracks_struts *t, size_t bytes, void *record);
/* The same of a number by place, for the ghosts that a link here ends at; work [n + ghosts]. Collective. */
void cracks_struts_update_near(const struct cracks_struts *t, double *work, double *x);
