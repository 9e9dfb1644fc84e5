/* Memory of commands that end soon (frana study, frana post): it lives until kept_free gives all of it back. Dies (exit
 * 4) where there is none left. Not collective. */
#pragma once
#include <stddef.h>

char *kept_text(const char *format, ...) __attribute__((format(printf, 1, 2))); /* as printf */
void *kept_new(size_t count, size_t size);                                      /* zeros */
/* A copy of n items with room for one more. old: kept too, or NULL. */
void *kept_grown(const void *old, size_t n, size_t size);
void *kept(void *p); /* keeps what malloc has given; may be NULL. Returns p. */
void kept_free(void);
