/* The items of several tables of state that a scene has, in the order of a checkpoint. */
#pragma once
#include "files/state_item.h"

enum { STATE_LIST_MAX = 96 };

struct state_list {
    int n, parts;
    const struct state_part *part; /* [parts] borrowed */
    struct {
        const struct state_item *item;
        const struct state_part *part;
    } at[STATE_LIST_MAX];
};

/* The tables one after another. An item with `after`, and the items below it in its table, stand behind the item that
 * it names, or at the end where there is none of that name. Not collective. */
void state_list_make(struct state_list *list, const struct state_part *part, int parts);
