/* Keeps a table's state in memory and restores it. */
#include "base/files/state_copy.h"
#include "base/ensure.h"
#include "base/memory.h"

#include <string.h>

/* An item's copy; comps 0: the item is not kept, has its own functions, or is kept by its values. */
struct copied {
    int comps, is_copied;
    size_t bytes; /* of each component */
    void *value[STATE_COMPS_MAX];
    /* by its values, as a checkpoint has them */
    void *row;
    long rows, capacity;
};

static int is_by_values(const struct state_item *item) {
    return !item->snapshot && (item->by_values || item->shape == STATE_ROWS);
}

static void values_take(struct copied *to, const struct state_item *item, const struct state_part *part) {
    struct state_size size = {0};
    part->size(part->owner, &size);
    to->rows = item->shape == STATE_ROWS ? item->rows_of(part->owner) : size.n;
    if (to->rows > to->capacity || !to->row) {
        const size_t each = state_item_value_bytes(item->kind) * (size_t)state_item_comps(item, part);
        to->capacity = to->rows + to->rows / 4 + 1;
        to->row = memory_renew(MEMORY_OUTPUT, to->row, (size_t)to->capacity, each);
    }
    item->save(part->owner, to->row);
}

static void values_restore(const struct copied *from, const struct state_item *item, const struct state_part *part) {
    char why[1];
    if (item->restore_rows)
        item->restore_rows(part->owner, from->rows, from->row);
    else if (item->load_rows)
        item->load_rows(part->owner, from->rows, from->row);
    else
        item->load(part->owner, from->row, why, sizeof why);
}

struct state_copy {
    const struct state_item *item;
    int items;
    struct copied *at; /* [items] */
};

/* Bytes of each array of an item, or of the value. */
static size_t bytes_of(const struct state_item *item, const struct state_size *size) {
    const size_t value = state_item_value_bytes(item->kind);
    switch (item->shape) {
    case STATE_ONE:
    case STATE_SHARE:
        return item->bytes;
    case STATE_PARTICLE:
    case STATE_SET:
        return value * (size_t)(size->n + (item->ghosts ? size->n_ghost : 0));
    case STATE_CELL:
        return value * size->cells;
    case STATE_ROWS: /* by its values, or has its own functions */
        break;
    }
    ENSURE(0, "shape %d", (int)item->shape);
    return 0;
}

struct state_copy *state_copy_new(const struct state_part *part, void *snapshot) {
    struct state_copy *copy = memory_new(MEMORY_OUTPUT, 1, sizeof *copy);
    struct state_size size = {0};
    part->size(part->owner, &size);
    copy->item = part->item;
    copy->items = part->items;
    copy->at = memory_new(MEMORY_OUTPUT, (size_t)part->items, sizeof *copy->at);
    for (int i = 0; i < part->items; i++) {
        const struct state_item *item = &part->item[i];
        struct copied *to = &copy->at[i];
        to->is_copied = (item->in & STATE_SNAPSHOT) && state_item_is_part(item, part);
        if (!to->is_copied) continue;
        if (item->snapshot) {
            item->snapshot->make(snapshot, part->owner);
            continue;
        }
        if (is_by_values(item)) continue;
        to->comps = state_item_comps(item, part);
        to->bytes = bytes_of(item, &size);
        ENSURE(to->comps <= STATE_COMPS_MAX, "%s of %d components", item->name, to->comps);
        for (int c = 0; c < to->comps; c++) to->value[c] = memory_new(MEMORY_OUTPUT, to->bytes + 1, 1);
    }
    return copy;
}

void state_copy_free(struct state_copy *copy, void *snapshot) {
    if (!copy) return;
    for (int i = 0; i < copy->items; i++) {
        struct copied *copied = &copy->at[i];
        if (copied->is_copied && copy->item[i].snapshot) copy->item[i].snapshot->drop(snapshot);
        for (int c = 0; c < copied->comps; c++) memory_free(copied->value[c]);
        memory_free(copied->row);
    }
    MEMORY_FREE(copy->at, copy);
}

void state_copy_take(struct state_copy *copy, const struct state_part *part, void *snapshot) {
    for (int last = 0; last < 2; last++)
        for (int i = 0; i < copy->items; i++) {
            const struct state_item *item = &copy->item[i];
            struct copied *to = &copy->at[i];
            if (!to->is_copied || item->last != last) continue;
            if (item->snapshot) item->snapshot->take(snapshot, part->owner);
            if (is_by_values(item)) values_take(to, item, part);
            for (int c = 0; c < to->comps; c++) memcpy(to->value[c], state_item_array(item, part, c), to->bytes);
        }
}

void state_copy_restore(struct state_copy *copy, const struct state_part *part, void *snapshot) {
    for (int last = 0; last < 2; last++)
        for (int i = 0; i < copy->items; i++) {
            const struct state_item *item = &copy->item[i];
            const struct copied *from = &copy->at[i];
            if (!from->is_copied || item->last != last) continue;
            if (item->snapshot) item->snapshot->restore(snapshot, part->owner);
            if (is_by_values(item)) values_restore(from, item, part);
            for (int c = 0; c < from->comps; c++) memcpy(state_item_array(item, part, c), from->value[c], from->bytes);
        }
}

const void *state_copy_of(const struct state_copy *copy, const char *name) {
    for (int i = 0; i < copy->items; i++)
        if (copy->at[i].comps > 0 && strcmp(copy->item[i].name, name) == 0) return copy->at[i].value[0];
    ENSURE(0, "no copy of %s is kept", name);
    return NULL;
}
