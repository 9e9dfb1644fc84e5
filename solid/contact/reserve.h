/* Arrays that grow and are reused. For solid/ only. */
#pragma once
#include <stddef.h>

/* Returns `list`, or a larger copy of it if it has no room for n items of `size` bytes; *capacity: number of items it
 * has room for. Grows by doubling, so that a list stops growing long before the end of a run. Not collective. */
void *solid_contact_reserve(void *list, int *capacity, int n, size_t size);
