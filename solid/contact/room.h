/* Lists that grow and are kept. Inside the room only. */
#pragma once
#include <stddef.h>

/* `list`, or a larger copy of it where it has no room for n items of `size` bytes; *capacity: how many it has room for.
 * By doubling, so that a list stops growing long before a run ends. Not collective. */
void *solid_contact_room(void *list, int *capacity, int n, size_t size);
