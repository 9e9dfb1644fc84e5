/* The items of several tables of state that a scene has, in the order of a checkpoint. */
#pragma once
#include "base/files/state_item.h"

enum { STATE_LIST_MAX = 160 };

struct state_list {
    int n, parts;
    const struct state_part *part; /* [parts] borrowed */
    struct {
        const struct state_item *item;
        const struct state_part *part;
    } at[STATE_LIST_MAX];
};

/* Lists the tables one after another. An item with `after`, together with the items below it in its table, follows the
 * item of that name, or comes at the end if there is none. Not collective. */
void state_list_make(struct state_list *list, const struct state_part *part, int parts);
