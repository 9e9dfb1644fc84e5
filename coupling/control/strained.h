/* How much stiffer stretched bonds have made the solid since its stable step was found. */
#pragma once

struct run;

/* At the start of a stage with a solid that deforms, or of a resumed run in its middle: looks at the bonds. Collective.
 */
void strained_begin(struct run *r);
/* Before the choice of a number of substeps: looks at the bonds every few substeps, and where they are stretched
 * further than when it was last found, finds the factor by which they raise the largest rate. Collective. */
void strained_update(struct run *r);
/* The stable step of a strained solid, s, from that of the unstrained one. An automatic substep may be as long as the
 * stable one of a hardly strained solid. Not collective. */
double strained_step(const struct run *r, double stable);
