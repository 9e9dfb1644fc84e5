/* Builds the bond list of each particle from a cloud: finds the family, computes stiffness and limit. */
#include "solid/bonds/list_find.h"
#include "base/memory.h"
#include "solid/law/weight.h"

#include <math.h>
#include <string.h>

struct solid_list *solid_list_find_begin(const struct solid_cloud *cloud, long from, long to, int first) {
    struct solid_list *list = memory_new(MEMORY_SOLID, 1, sizeof *list);
    list->law = cloud->law;
    list->law.table = solid_weight_table_new();
    list->dim = cloud->dim;
    list->width = cloud->dim == 2 ? 2 : 4;
    list->spacing = cloud->spacing;
    list->unit = cloud->unit;
    for (int c = 0; c < 3; c++) list->period[c] = cloud->period[c];
    list->first_id = cloud->first;
    list->first = first;
    const long low = from > cloud->first ? from : cloud->first,
               high = to < cloud->first + cloud->n ? to : cloud->first + cloud->n;
    list->n = high > low ? (int)(high - low) : 0;
    list->number = low - cloud->first;
    list->start = solid_store_array(list->n, sizeof *list->start);
    list->end = solid_store_array(list->n, sizeof *list->end);
    list->large = solid_store_array(list->n, 1);
    list->eps_limit = solid_store_array(list->n, sizeof *list->eps_limit);
    list->digit = solid_store_array(list->n, sizeof *list->digit);
    list->power = solid_store_array(list->n, sizeof *list->power);
    list->own_volume = solid_store_array(list->n, sizeof *list->own_volume);
    list->damage = solid_store_array(list->n, sizeof *list->damage);
    list->counted = solid_store_array(list->n, sizeof *list->counted);
    list->scaled = solid_store_array(list->n, 1);
    if (list->dim == 2) list->pair_cache = memory_new(MEMORY_SOLID, 1, sizeof *list->pair_cache);
    return list;
}

void solid_list_find_allocate(struct solid_list *list) {
    list->capacity = list->bonds = 0;
    for (int i = 0; i < list->n; i++) {
        const long n = list->end[i] - list->start[i];
        list->start[i] = list->capacity;
        list->end[i] = list->capacity + n;
        list->bonds += n;
        list->capacity += (n + SOLID_LIST_BLOCK - 1) / SOLID_LIST_BLOCK * SOLID_LIST_BLOCK;
    }
    list->key = solid_store_array(list->capacity, sizeof *list->key);
    list->at = solid_store_array(list->capacity, sizeof *list->at);
    list->step = solid_store_array(list->capacity * list->dim, sizeof *list->step);
    list->stiffness = solid_store_array(list->capacity, sizeof *list->stiffness);
    if (list->law.s_c > 0) list->soft = solid_store_array(list->capacity / SOLID_LIST_BLOCK, 1);
    for (int i = 0; i < list->n; i++)
        for (long j = list->end[i]; j % SOLID_LIST_BLOCK; j++) { /* padding */
            list->stiffness[j] = -0.;
            for (int c = 0; c < list->dim; c++) *solid_list_step(list, j, c) = 1; /* |xi| is not 0 */
        }
}

/* solid_pair_of in a plate, with a cache: most pairs are equal to an earlier one. */
static struct solid_pair pair_of(struct solid_list *list, const double xi[3], const struct solid_end *h,
                                 const struct solid_end *l) {
    const double input[6] = {xi[0], xi[1], h->horizon, h->size, l->horizon, l->size};
    uint64_t bits[6], hash = 0;
    if (list->dim == 3) return solid_pair_of(&list->law, xi, h, l);
    memcpy(bits, input, sizeof bits);
    for (int k = 0; k < 6; k++) hash = (hash ^ bits[k]) * UINT64_C(0x9e3779b97f4a7c15) ^ hash >> 29;
    const unsigned slot = (unsigned)(hash >> 40) % SOLID_PAIR_CACHE;
    if (memcmp(list->pair_cache->slot[slot].input, input, sizeof input) != 0) {
        memcpy(list->pair_cache->slot[slot].input, input, sizeof input);
        list->pair_cache->slot[slot].pair = solid_pair_of(&list->law, xi, h, l);
    }
    return list->pair_cache->slot[slot].pair;
}

/* Computes the numbers of bond j between h and the other end at xi; interface: to another body, NULL: within this one.
 * Returns its contribution to V_h. */
static double number_bond(struct solid_list *list, const struct solid_interface_side *interface, const double xi[3],
                          const struct solid_end *h, const struct solid_end *l, long j, double *limit) {
    double xi2 = 0;
    for (int c = 0; c < list->dim; c++) {
        *solid_list_step(list, j, c) = (float)xi[c];
        xi2 += xi[c] * xi[c];
    }
    const struct solid_pair pair =
        interface ? solid_pair_across(&interface->law, &interface->other, xi, h, l) : pair_of(list, xi, h, l);
    list->stiffness[j] = pair.stiffness * (l->volume * list->unit / list->law.density) / sqrt(xi2);
    *limit = fmin(*limit, pair.eps_limit);
    return solid_pair_rounded(&list->law, h->horizon, pair.gamma * l->volume);
}

int solid_list_find(struct solid_list *list, const struct solid_cloud *cloud, int i, long number,
                    struct solid_cloud_near *near) {
    const struct solid_end here = solid_cloud_end(cloud, number);
    const long start = list->start[i];
    double limit = INFINITY, volume = 0;
    solid_cloud_near_find(cloud, number, near);
    for (int k = 0; k < near->n; k++) {
        const struct solid_end there = solid_cloud_end(cloud, near->number[k]);
        volume += number_bond(list, NULL, near->xi[k], &here, &there, start + k, &limit);
        list->key[start + k] = solid_key_of(cloud->first + near->number[k], near->image[k]);
    }
    int n = near->n;
    for (int q = 0; q < list->interfaces; q++) {
        const struct solid_interface_side *interface = &list->interface[q];
        solid_interface_find(interface, cloud, number, SOLID_FAMILY_MAX - n, near);
        for (int k = 0; k < near->n; k++, n++) {
            const struct solid_end there = solid_cloud_end(interface->cloud, near->number[k]);
            volume += number_bond(list, interface, near->xi[k], &here, &there, start + n, &limit);
            list->key[start + n] = solid_key_of(interface->cloud->first + near->number[k], near->image[k]);
        }
    }
    list->eps_limit[i] = limit;
    list->own_volume[i] = volume;
    return n;
}

void solid_list_find_number(struct solid_list *list, const struct solid_cloud *cloud, int i, long number) {
    const struct solid_end here = solid_cloud_end(cloud, number);
    double limit = INFINITY, volume = 0;
    for (long j = list->start[i]; j < list->end[i]; j++) {
        const long l = solid_key_id(list->key[j]) - cloud->first;
        const int image = solid_key_image(list->key[j]);
        const struct solid_end there = solid_cloud_end(cloud, l);
        double xi[3] = {0};
        for (int c = 0; c < list->dim; c++)
            xi[c] = (cloud->place[c][l] - cloud->place[c][number]) + solid_cloud_image_of(image, c) * list->period[c];
        volume += number_bond(list, NULL, xi, &here, &there, j, &limit);
    }
    list->eps_limit[i] = limit;
    list->own_volume[i] = volume;
}

/* Number of bonds of the i-th particle to other bodies. */
static int count_interface(const struct solid_list *list, const struct solid_cloud *cloud, int i,
                           struct solid_cloud_near *near) {
    int n = 0;
    for (int q = 0; q < list->interfaces; q++) {
        solid_interface_find(&list->interface[q], cloud, list->number + i, SOLID_FAMILY_MAX, near);
        n += near->n;
    }
    return n;
}

struct solid_list *solid_list_find_new(const struct solid_cloud *cloud, struct solid_interface_side *interface,
                                       int interfaces, long from, long to, int first) {
    struct solid_list *list = solid_list_find_begin(cloud, from, to, first);
    list->interface = interface;
    list->interfaces = interfaces;
    for (int q = 0; q < interfaces; q++) interface[q].law.table = interface[q].other.table = list->law.table;
    struct solid_cloud_near *near = memory_new(MEMORY_SOLID, 1, sizeof *near);
    for (int i = 0; i < list->n; i++)
        list->end[i] = solid_cloud_near_count(cloud, list->number + i) + count_interface(list, cloud, i, near);
    solid_list_find_allocate(list);
    for (int i = 0; i < list->n; i++) solid_list_find(list, cloud, i, list->number + i, near);
    memory_free(near);
    return list;
}
