/* Properties of a line of the table of state: whether the scene has the variable, its size, its address. */
#include "base/files/state_item.h"
#include "base/ensure.h"

#include <string.h>

static int is_value(const struct state_item *item) { return item->shape == STATE_ONE || item->shape == STATE_SHARE; }

/* Number of pointers of a member: one, or one for each component. */
static int pointers_of(const struct state_item *item) { return (int)(item->bytes / sizeof(void *)); }

void *state_item_array(const struct state_item *item, const struct state_part *part, int c) {
    char *const member = (char *)part->base + item->offset;
    void *array;
    ENSURE(item->bytes > 0, "%s has no member", item->name);
    if (is_value(item)) return member;
    memcpy(&array, member + (size_t)c * sizeof array, sizeof array);
    return array;
}

int state_item_is_part(const struct state_item *item, const struct state_part *part) {
    if (item->is_part) return item->is_part(part->owner);
    return is_value(item) || item->bytes == 0 || state_item_array(item, part, 0) != NULL;
}

int state_item_comps(const struct state_item *item, const struct state_part *part) {
    if (item->comps_of) return item->comps_of(part->owner);
    if (item->comps > 0 || is_value(item)) return item->comps > 0 ? item->comps : 1;
    int comps = 0;
    while (comps < pointers_of(item) && state_item_array(item, part, comps)) comps++;
    return comps;
}

size_t state_item_value_bytes(enum state_kind kind) {
    static const size_t bytes[] = {sizeof(double), sizeof(long), sizeof(int), 1, STATE_TEXT_BYTES};
    return bytes[kind];
}
