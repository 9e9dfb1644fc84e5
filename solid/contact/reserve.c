/* Arrays that grow by doubling, for contact. */
#include "solid/contact/reserve.h"

#include "base/memory.h"

void *solid_contact_reserve(void *list, int *capacity, int n, size_t size) {
    if (list && n <= *capacity) return list;
    const int larger = 2 * n + 64;
    void *grown = memory_grown(MEMORY_SOLID, list, (size_t)*capacity, (size_t)larger, size);
    *capacity = larger;
    return grown;
}
