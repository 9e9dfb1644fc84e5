/* Writes the state that tables of state list to a checkpoint, and reads it back on any number of ranks. */
#pragma once
#include "base/files/state_list.h"

/* The sums of the ranks' shares continue on rank 0 afterwards, as in a run that reads the file. Collective. */
void state_file_write(struct store *s, const struct state_list *list);
/* Bytes of the arrays that such a checkpoint holds. Collective. */
double state_file_bytes(const struct state_list *list);
/* Returns 1 if an item is missing, damaged or does not fit the scene, with the reason in why, or in store_read_error()
 * if why is empty. head: the item was a single value. Arrays by particle may be allocated again during the call
 * (STATE_SET). Collective. */
int state_file_read(struct store *s, const struct state_list *list, int *head, char *why, size_t size);
