/* Says that contact will not do what a scene expects of it: bodies that burst at rest, or pass through one another. */
#pragma once

struct run;

/* Sentences on the bodies as they are at the start. Returns how many. Collective. */
enum { CONTACT_WARNING_MAX = 2, CONTACT_WARNING_SENTENCE = 400 };
int contact_warning_of(struct run *r, char sentence[CONTACT_WARNING_MAX][CONTACT_WARNING_SENTENCE]);
