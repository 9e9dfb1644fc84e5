/* Where a run's time went: wall seconds by span, part and rank, waiting told from working. A span is the set-up, a
 * stage, or the end.  (docs/timeline.md) */
#pragma once
#include "base/files/json.h"

struct timeline; /* opaque, owned by the caller */

struct timeline *timeline_new(void); /* Begins with the set-up. Not collective. */
void timeline_free(struct timeline *t);
/* The present span ends and the named one begins. name: borrowed. Not collective. */
void timeline_span(struct timeline *t, const char *name, long step);
/* Gathers the seconds of all ranks up to now, of which the others below speak. Collective. */
void timeline_collect(struct timeline *t, long step);
double timeline_seconds(const struct timeline *t, int part); /* mean over the ranks. Not collective. */
double timeline_wall(const struct timeline *t);              /* since clock_clear, of the rank that began first */
double timeline_last(const struct timeline *t);              /* of the last span, mean over the ranks */
/* Members of run.json. Not collective: rank 0 alone may call it. */
void timeline_write(const struct timeline *t, struct json *j);
