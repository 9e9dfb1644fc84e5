/* Warnings of bodies that contact pushes apart from the start, and of bodies that may pass through one another. */
#pragma once

struct run;

/* Writes one sentence for each warning about the bodies as they are at the start. Returns their number. Collective. */
enum { CONTACT_WARNING_MAX = 2, CONTACT_WARNING_SENTENCE = 400 };
int contact_warning_of(struct run *r, char sentence[CONTACT_WARNING_MAX][CONTACT_WARNING_SENTENCE]);
