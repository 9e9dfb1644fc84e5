/* Arrays that grow by doubling, for contact. */
#include "solid/contact/room.h"

#include "base/memory.h"

#include <string.h>

void *solid_contact_room(void *list, int *capacity, int n, size_t size) {
    if (list && n <= *capacity) return list;
    const int larger = 2 * n + 64;
    void *room = memory_new(MEMORY_SOLID, (size_t)larger, size);
    if (list) memcpy(room, list, (size_t)*capacity * size);
    memory_free(list);
    *capacity = larger;
    return room;
}
