/* Builds the bond list of each particle from a cloud: finds the family, computes stiffness and limit. */
#include "solid/bonds/list_find.h"
#include "base/memory.h"
#include "solid/law/weight.h"

#include <math.h>
#include <string.h>

struct solid_list *solid_list_find_begin(const struct solid_cloud *cloud, long from, long to, int first) {
    struct solid_list *b = memory_new(MEMORY_SOLID, 1, sizeof *b);
    b->law = cloud->law;
    b->law.table = solid_weight_table_new();
    b->dim = cloud->dim;
    b->width = cloud->dim == 2 ? 2 : 4;
    b->spacing = cloud->spacing;
    b->unit = cloud->unit;
    for (int c = 0; c < 3; c++) b->period[c] = cloud->period[c];
    b->first_id = cloud->first;
    b->first = first;
    const long low = from > cloud->first ? from : cloud->first,
               high = to < cloud->first + cloud->n ? to : cloud->first + cloud->n;
    b->n = high > low ? (int)(high - low) : 0;
    b->number = low - cloud->first;
    b->start = solid_store_array(b->n, sizeof *b->start);
    b->end = solid_store_array(b->n, sizeof *b->end);
    b->large = solid_store_array(b->n, 1);
    b->limit = solid_store_array(b->n, sizeof *b->limit);
    b->digit = solid_store_array(b->n, sizeof *b->digit);
    b->power = solid_store_array(b->n, sizeof *b->power);
    b->own_volume = solid_store_array(b->n, sizeof *b->own_volume);
    b->damage = solid_store_array(b->n, sizeof *b->damage);
    b->counted = solid_store_array(b->n, sizeof *b->counted);
    b->scaled = solid_store_array(b->n, 1);
    if (b->dim == 2) b->kept = memory_new(MEMORY_SOLID, 1, sizeof *b->kept);
    return b;
}

void solid_list_find_room(struct solid_list *b) {
    b->room = b->bonds = 0;
    for (int i = 0; i < b->n; i++) {
        const long n = b->end[i] - b->start[i];
        b->start[i] = b->room;
        b->end[i] = b->room + n;
        b->bonds += n;
        b->room += (n + SOLID_LIST_BLOCK - 1) / SOLID_LIST_BLOCK * SOLID_LIST_BLOCK;
    }
    b->key = solid_store_array(b->room, sizeof *b->key);
    b->at = solid_store_array(b->room, sizeof *b->at);
    b->step = solid_store_array(b->room * b->dim, sizeof *b->step);
    b->stiffness = solid_store_array(b->room, sizeof *b->stiffness);
    for (int i = 0; i < b->n; i++)
        for (long j = b->end[i]; j % SOLID_LIST_BLOCK; j++) { /* padding */
            b->stiffness[j] = -0.;
            for (int c = 0; c < b->dim; c++) *solid_list_step(b, j, c) = 1; /* |xi| is not 0 */
        }
}

/* solid_pair_of in a plate, with a cache: most pairs are equal to an earlier one. */
static struct solid_pair pair_of(struct solid_list *b, const double xi[3], const struct solid_end *h,
                                 const struct solid_end *l) {
    const double of[6] = {xi[0], xi[1], h->horizon, h->size, l->horizon, l->size};
    uint64_t bits[6], hash = 0;
    if (b->dim == 3) return solid_pair_of(&b->law, xi, h, l);
    memcpy(bits, of, sizeof bits);
    for (int k = 0; k < 6; k++) hash = (hash ^ bits[k]) * UINT64_C(0x9e3779b97f4a7c15) ^ hash >> 29;
    const unsigned slot = (unsigned)(hash >> 40) % SOLID_PAIRS_KEPT;
    if (memcmp(b->kept->slot[slot].of, of, sizeof of) != 0) {
        memcpy(b->kept->slot[slot].of, of, sizeof of);
        b->kept->slot[slot].pair = solid_pair_of(&b->law, xi, h, l);
    }
    return b->kept->slot[slot].pair;
}

/* Computes the numbers of bond j between h and the other end at xi. Returns its contribution to V_h. */
static double number_bond(struct solid_list *b, const double xi[3], const struct solid_end *h,
                          const struct solid_end *l, long j, double *limit) {
    double xi2 = 0;
    for (int c = 0; c < b->dim; c++) {
        *solid_list_step(b, j, c) = (float)xi[c];
        xi2 += xi[c] * xi[c];
    }
    const struct solid_pair pair = pair_of(b, xi, h, l);
    b->stiffness[j] = pair.stiffness * (l->volume * b->unit / b->law.density) / sqrt(xi2);
    *limit = fmin(*limit, pair.limit);
    return solid_pair_rounded(&b->law, h->horizon, pair.gamma * l->volume);
}

int solid_list_find(struct solid_list *b, const struct solid_cloud *cloud, int i, long number,
                    struct solid_cloud_near *near) {
    const struct solid_end here = solid_cloud_end(cloud, number);
    const long start = b->start[i];
    double limit = INFINITY, volume = 0;
    solid_cloud_near_find(cloud, number, near);
    for (int k = 0; k < near->n; k++) {
        const struct solid_end there = solid_cloud_end(cloud, near->number[k]);
        volume += number_bond(b, near->xi[k], &here, &there, start + k, &limit);
        b->key[start + k] = solid_key_of(cloud->first + near->number[k], near->image[k]);
    }
    b->limit[i] = limit;
    b->own_volume[i] = volume;
    return near->n;
}

void solid_list_find_number(struct solid_list *b, const struct solid_cloud *cloud, int i, long number) {
    const struct solid_end here = solid_cloud_end(cloud, number);
    double limit = INFINITY, volume = 0;
    for (long j = b->start[i]; j < b->end[i]; j++) {
        const long l = solid_key_id(b->key[j]) - cloud->first;
        const int image = solid_key_image(b->key[j]);
        const struct solid_end there = solid_cloud_end(cloud, l);
        double xi[3] = {0};
        for (int c = 0; c < b->dim; c++)
            xi[c] = (cloud->place[c][l] - cloud->place[c][number]) + solid_cloud_image_of(image, c) * b->period[c];
        volume += number_bond(b, xi, &here, &there, j, &limit);
    }
    b->limit[i] = limit;
    b->own_volume[i] = volume;
}

struct solid_list *solid_list_find_new(const struct solid_cloud *cloud, long from, long to, int first) {
    struct solid_list *b = solid_list_find_begin(cloud, from, to, first);
    struct solid_cloud_near *near = memory_new(MEMORY_SOLID, 1, sizeof *near);
    for (int i = 0; i < b->n; i++) b->end[i] = solid_cloud_near_count(cloud, b->number + i);
    solid_list_find_room(b);
    for (int i = 0; i < b->n; i++) solid_list_find(b, cloud, i, b->number + i, near);
    memory_free(near);
    return b;
}
