/* Families being found. Inside the room only. */
#pragma once
#include "solid/bonds/key.h"
#include "solid/bonds/list.h"

/* Pairs that have been computed, by what they are computed from: on a lattice of levels there are few. */
enum { SOLID_PAIRS_KEPT = 1024 };
struct solid_pairs_kept {
    struct {
        double of[6]; /* xi and, of both ends, horizon and size; 0: nothing */
        struct solid_pair pair;
    } slot[SOLID_PAIRS_KEPT];
};

/* An empty list for the cloud's particles among the ids from .. to-1. */
struct solid_list *solid_list_find_begin(const struct solid_cloud *cloud, long from, long to, int first);
/* Places for the bonds, once end[i] - start[i] are known: sets start, end and room. */
void solid_list_find_room(struct solid_list *list);
/* Writes the family of the i-th particle (number in the cloud), intact; returns its size. near: scratch. */
int solid_list_find(struct solid_list *list, const struct solid_cloud *cloud, int i, long number,
                    struct solid_cloud_near *near);
/* Numbers of the i-th particle's bonds from their keys: lengths, stiffnesses without alpha, limit, V_h. */
void solid_list_find_number(struct solid_list *list, const struct solid_cloud *cloud, int i, long number);
