/* How much stiffer stretched bonds have made the solid since its stable step was found. */
#pragma once

struct run;

/* At the start of a stage with a solid that deforms, or when a run is resumed within it: measures the stretch of the
 * bonds. Collective. */
void strained_begin(struct run *r);
/* Before the number of substeps is chosen: measures the stretch of the bonds every few substeps. If it has grown,
 * finds again the factor by which stretched bonds raise the largest rate. Collective. */
void strained_update(struct run *r);
/* The stable step of a strained solid, s, from that of the unstrained one. An automatic substep may be as long as the
 * stable one of a hardly strained solid. Not collective. */
double strained_step(const struct run *r, double stable);
/* What short waves hold beyond velocity Verlet's sums (solid/step/shadow.h), J, where bonds are stretched so much that
 * the step follows them; else, and with RK3, 0. Collective. */
double strained_waves(struct run *r);
