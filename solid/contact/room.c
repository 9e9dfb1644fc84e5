/* Arrays that grow by doubling, for contact. */
#include "solid/contact/room.h"

#include "base/memory.h"

void *solid_contact_room(void *list, int *capacity, int n, size_t size) {
    if (list && n <= *capacity) return list;
    const int larger = 2 * n + 64;
    void *room = memory_grown(MEMORY_SOLID, list, (size_t)*capacity, (size_t)larger, size);
    *capacity = larger;
    return room;
}
