/* How fast the tips of cracks run that a fluid drives: by the cracks' area, at the samples of the series. */
#pragma once
#include "coupling/run.h"

struct crack_speed; /* opaque: what was sampled */

struct crack_speed *crack_speed_new(const struct run *r); /* NULL: cracks carry no fluid. Not collective. */
void crack_speed_free(struct crack_speed *c);
/* area: of the cracks, m2. The first speed above 0.05 sqrt(E/rho_s) is a warning in the log. Nothing for NULL. Not
 * collective. */
void crack_speed_sample(struct crack_speed *c, const struct run *r, double area);
/* A line in the log on the largest speed, if the tips have run five spacings. Nothing for NULL. Not collective. */
void crack_speed_say(const struct crack_speed *c, const char *stage);
