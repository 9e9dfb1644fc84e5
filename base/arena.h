/* Memory of commands that end soon (frana study, frana post): it lives until arena_free gives all of it back. Dies
 * (exit 4) where there is none left. Not collective. */
#pragma once
#include <stddef.h>

char *arena_text(const char *format, ...) __attribute__((format(printf, 1, 2))); /* as printf */
void *arena_new(size_t count, size_t size);                                      /* zeros */
/* A copy of n items with room for one more. old: kept too, or NULL. */
void *arena_grown(const void *old, size_t n, size_t size);
void *arena_keep(void *p); /* keeps what malloc has given; may be NULL. Returns p. */
void arena_free(void);
