/* Families while they are found. For solid/ only. */
#pragma once
#include "solid/bonds/key.h"
#include "solid/bonds/list.h"

/* Cache of computed pairs; on a lattice with levels there are few different ones. */
enum { SOLID_PAIR_CACHE = 1024 };
struct solid_pair_cache {
    struct {
        double input[6]; /* the pair's input: xi, and horizon and size of both ends; 0: empty */
        struct solid_pair pair;
    } slot[SOLID_PAIR_CACHE];
};

/* An empty list for the cloud's particles with ids from .. to-1. */
struct solid_list *solid_list_find_begin(const struct solid_cloud *cloud, long from, long to, int first);
/* Allocates the bonds, once end[i] - start[i] are known: sets start, end and capacity. */
void solid_list_find_allocate(struct solid_list *list);
/* Writes the family of the i-th particle (number in the cloud), all bonds intact. Returns its size. near: scratch. */
int solid_list_find(struct solid_list *list, const struct solid_cloud *cloud, int i, long number,
                    struct solid_cloud_near *near);
/* Computes the numbers of the i-th particle's bonds from their keys: lengths, stiffnesses without alpha, limit, V_h. */
void solid_list_find_number(struct solid_list *list, const struct solid_cloud *cloud, int i, long number);
