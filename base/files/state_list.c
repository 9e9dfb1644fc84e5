/* Puts the items of several tables of state into the order of a checkpoint. */
#include "base/files/state_list.h"
#include "base/ensure.h"

#include <string.h>

static int place_of(const struct state_list *list, const char *name) {
    int k = 0;
    while (k < list->n && strcmp(list->at[k].item->name, name) != 0) k++;
    return k;
}

static void insert(struct state_list *list, int k, const struct state_item *item, const struct state_part *part) {
    ENSURE(list->n < STATE_LIST_MAX, "more than %d items of state", STATE_LIST_MAX);
    memmove(&list->at[k + 1], &list->at[k], (size_t)(list->n - k) * sizeof list->at[0]);
    list->at[k].item = item;
    list->at[k].part = part;
    list->n++;
}

/* Inserts the item `from` and those below it up to the next one with `after`. Returns the index of that one. */
static int insert_block(struct state_list *list, int k, const struct state_part *part, int from) {
    int i = from;
    do insert(list, k++, &part->item[i], part);
    while (++i < part->items && !part->item[i].after);
    return i;
}

void state_list_make(struct state_list *list, const struct state_part *part, int parts) {
    int next[8];
    ENSURE(parts <= 8, "%d tables of state", parts);
    *list = (struct state_list){.part = part, .parts = parts};
    for (int p = 0; p < parts; p++) next[p] = insert_block(list, list->n, &part[p], 0);
    for (int p = 0; p < parts; p++)
        while (next[p] < part[p].items) {
            const int k = place_of(list, part[p].item[next[p]].after);
            next[p] = insert_block(list, k < list->n ? k + 1 : k, &part[p], next[p]);
        }
    int n = 0; /* number of items that the scene has */
    for (int k = 0; k < list->n; k++)
        if (state_item_is_part(list->at[k].item, list->at[k].part)) list->at[n++] = list->at[k];
    list->n = n;
}
