/* List store of bonds: links the bond lists to local particles and computes weights; access to single bonds. */
#include "solid/bonds/list.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/sort.h"
#include "solid/body/number.h"
#include "solid/bonds/list_find.h"
#include "solid/bonds/list_lanes.h"
#include "solid/bonds/list_rows.h"
#include "solid/law/weight.h"

#include <math.h>
#include <string.h>

void solid_list_free(struct solid_list *list) {
    if (!list) return;
    solid_list_rows_free(list->rows);
    solid_weight_table_free(list->law.table);
    MEMORY_FREE(list->start, list->end, list->at, list->step, list->stiffness, list->large, list->eps_limit, list->soft,
                list->digit, list->power, list->own_volume, list->other_key, list->other_local, list->particle, list->w,
                list->record, list->speed, list->key, list->scaled, list->damage, list->counted, list->pair_cache,
                list->interface, list->interface_of, list->pressure, list->extension_digit, list->extension_power,
                list->plain, list);
}

long solid_list_wanted(const struct solid_list *list, long from, long to, long *id) {
    long wanted = 0;
    for (int i = 0; i < list->n; i++) {
        if (list->scaled[i] == SOLID_LIST_LINKED) continue;
        for (long j = list->start[i]; j < list->end[i]; j++) {
            const long other = list->key[j] < 0 ? from : solid_key_id(list->key[j]);
            if (other >= from && other < to) continue;
            if (id) id[wanted] = other;
            wanted++;
        }
    }
    return wanted;
}

/* Whether the key is that of an owned particle, not of a periodic image; a key below 0 is already linked. */
static int is_own(const struct solid_list *list, const struct solid_numbering *numbering, long key) {
    if (key < 0) return 1;
    const long i = solid_key_id(key) - numbering->from - list->first;
    return solid_key_image(key) == SOLID_NO_IMAGE && i >= 0 && i < list->n;
}

static void others_new(struct solid_list *list, const struct solid_numbering *numbering) {
    long n = 0, capacity = 0;
    for (int i = 0; i < list->n; i++)
        if (list->scaled[i] != SOLID_LIST_LINKED)
            for (long j = list->start[i]; j < list->end[i]; j++) capacity += !is_own(list, numbering, list->key[j]);
    long *all = solid_store_array(capacity, sizeof *all);
    for (int i = 0; i < list->n && n < capacity; i++)
        if (list->scaled[i] != SOLID_LIST_LINKED)
            for (long j = list->start[i]; j < list->end[i]; j++)
                if (!is_own(list, numbering, list->key[j])) all[n++] = list->key[j];
    list->others = (int)sort_unique(all, n);
    list->other_key = solid_store_array(list->others, sizeof *all);
    memcpy(list->other_key, all, (size_t)list->others * sizeof *all);
    memory_free(all);
    list->other_local = solid_store_array(list->others, sizeof *list->other_local);
    for (int i = 0; i < list->others; i++) {
        const long id = solid_key_id(list->other_key[i]);
        list->other_local[i] = solid_number_local(numbering, id);
        ENSURE(list->other_local[i] >= 0, "particle %ld is not known here", id);
    }
}

static void records_new(struct solid_list *list, const struct solid_cloud *cloud) {
    const int records = list->n + list->others;
    list->record = solid_store_array((long)list->width * records, sizeof *list->record);
    list->particle = solid_store_array(records, sizeof *list->particle);
    list->w = solid_store_array(records, sizeof *list->w);
    if (list->interfaces > 0) list->interface_of = solid_store_array(list->others, 1);
    for (int r = 0; r < records; r++) {
        const long id = r < list->n ? list->number + r + list->first_id : solid_key_id(list->other_key[r - list->n]);
        const struct solid_cloud *store = cloud;
        for (int k = 0; k < list->interfaces; k++) {
            const struct solid_cloud *other = list->interface[k].cloud;
            if (id < other->first || id >= other->first + other->n) continue;
            list->interface_of[r - list->n] = (uint8_t)(1 + k);
            store = other;
        }
        list->particle[r] = solid_cloud_end(store, id - store->first);
    }
    for (int k = 0; k < list->interfaces; k++) list->interface[k].cloud = NULL;
}

void solid_list_link(struct solid_list *list, const struct solid_cloud *cloud,
                     const struct solid_numbering *numbering) {
    others_new(list, numbering);
    const struct solid_numbering others = {0, 0, list->others, list->other_key};
    for (int i = 0; i < list->n; i++) {
        const long next = i + 1 < list->n ? list->start[i + 1] : list->capacity;
        if (list->scaled[i] == SOLID_LIST_LINKED) continue;
        for (long j = list->start[i]; j < list->end[i]; j++) {
            const long key = list->key[j];
            if (key < 0) continue;
            const int record = is_own(list, numbering, key) ? (int)(solid_key_id(key) - numbering->from) - list->first
                                                            : list->n + solid_number_local(&others, key);
            list->at[j] = list->width * record;
        }
        for (long j = list->end[i]; j < next; j++) list->at[j] = list->width * i;
    }
    MEMORY_FREE(list->key, list->pair_cache);
    list->key = NULL;
    list->pair_cache = NULL;
    records_new(list, cloud);
}

void solid_list_volumes(const struct solid_list *list, double *family_volume) {
    for (int i = 0; i < list->n; i++) family_volume[list->first + i] = list->own_volume[i] * list->unit;
}

void solid_list_ratios(const struct solid_list *list, const double *family_volume, double *ratio) {
    struct solid_end last = {0};
    double full = 1;
    for (int i = 0; i < list->n; i++) {
        const struct solid_end *p = &list->particle[i];
        if (p->size != last.size || p->horizon != last.horizon) {
            full = solid_pair_full_volume(&list->law, p->horizon, p->size) * list->unit;
            last = *p;
        }
        ratio[list->first + i] = family_volume[list->first + i] / full;
    }
}

/* The digit to which bond forces are rounded. A component of a bond force is at most k |xi| g |zeta|/|xi| = k |xi| |s|
 * <= k |xi| |eps|; the digit has k |xi| rounded up to a power of two, and leaves room for the sum over the family. The
 * same of a force times |xi|, by `power` = 2. */
static double digit_of(const struct solid_list *list, int i, const double *stiffness, int power) {
    double most = 0, xi[3];
    for (long j = list->start[i]; j < list->end[i]; j++) {
        const double length = solid_list_steps(list, j, xi);
        most = fmax(most, fabs(stiffness[j]) * (power == 2 ? length * length : length));
    }
    return most > 0 && isfinite(most) ? ldexp(1, ilogb(most) + 1) * solid_list_headroom(list, i) : 0;
}

void solid_list_weights(struct solid_list *list, const double *w) {
    for (int r = 0; r < list->n + list->others; r++) list->w[r] = w[solid_list_local(list, r)];
    for (int i = 0; i < list->n; i++) {
        if (list->scaled[i]) continue;
        for (long j = list->start[i]; j < list->end[i]; j++)
            list->stiffness[j] *= solid_list_alpha(list, list->first + i, j);
        list->digit[i] = digit_of(list, i, list->stiffness, 1);
    }
}

void solid_list_pressure_new(struct solid_list *list) {
    const size_t n = (size_t)list->n;
    list->pressure = solid_store_array(n + (size_t)list->others, sizeof *list->pressure);
    list->extension_digit = solid_store_array(n, sizeof *list->extension_digit);
    list->extension_power = solid_store_array(n, sizeof *list->extension_power);
    list->plain = solid_store_array((size_t)list->capacity, sizeof *list->plain);
    for (int i = 0; i < list->n; i++) {
        for (long j = list->start[i]; j < list->end[i]; j++)
            list->plain[j] = fabs(list->stiffness[j]) / solid_list_alpha(list, list->first + i, j);
        list->extension_digit[i] = digit_of(list, i, list->plain, 2);
    }
}

void solid_list_pressure_set(struct solid_list *list, const double *pressure) {
    for (int r = 0; r < list->n + list->others; r++) list->pressure[r] = pressure[solid_list_local(list, r)];
}

int solid_list_longest(const struct solid_list *list) {
    long longest = 0;
    for (int i = 0; i < list->n; i++)
        if (list->end[i] - list->start[i] > longest) longest = list->end[i] - list->start[i];
    return (int)longest;
}

long solid_list_intact(const struct solid_list *list) {
    long count = 0;
    for (int i = 0; i < list->n; i++)
        for (long j = list->start[i]; j < list->end[i]; j += SOLID_LIST_BLOCK)
            count += __builtin_popcount(solid_list_lanes_block_intact(list, j));
    return count;
}

void solid_list_swap(struct solid_list *list, uint8_t *intact) {
    for (int i = 0; i < list->n; i++)
        for (long j = list->start[i]; j < list->end[i]; j++) {
            const int was = solid_list_is_swept(list, j);
            solid_list_set(list, j, intact[j]);
            intact[j] = (uint8_t)was;
        }
}

long solid_list_reverse(const struct solid_list *list, const struct solid_list *other, int h, long j) {
    const int i = solid_list_other(list, j) - other->first;
    if (i < 0 || i >= other->n) return -1;
    double xi[3], back[3];
    solid_list_steps(list, j, xi);
    for (long k = other->start[i]; k < other->end[i]; k++) {
        if (solid_list_other(other, k) != h) continue;
        solid_list_steps(other, k, back);
        if (back[0] == -xi[0] && back[1] == -xi[1] && back[2] == -xi[2]) return k;
    }
    return -1;
}

double solid_list_micromodulus(const struct solid_list *list, int h, long j) {
    double xi[3];
    solid_list_steps(list, j, xi);
    const struct solid_interface_side *interface = solid_list_interface(list, j);
    const struct solid_end *here = &list->particle[h - list->first],
                           *there = &list->particle[solid_list_record(list, j)];
    return interface ? solid_pair_across_micromodulus(&interface->law, &interface->other, xi, here, there)
                     : solid_pair_micromodulus(&list->law, xi, here, there);
}

double solid_list_weight(const struct solid_list *list, int h, long j, double micromodulus) {
    double xi[3];
    const double length = solid_list_steps(list, j, xi);
    const double kv = fabs(list->stiffness[j]) * list->law.density * length / solid_list_alpha(list, h, j);
    return kv / micromodulus;
}

/* The damage computed last is valid until a bond of the family breaks. */
double solid_list_damage(struct solid_list *list, int h) {
    const int i = h - list->first;
    int intact = 0;
    for (long j = list->start[i]; j < list->end[i]; j += SOLID_LIST_BLOCK)
        intact += __builtin_popcount(solid_list_lanes_block_intact(list, j));
    if (list->counted[i] == intact + 1) return list->damage[i];
    double left = 0, all = 0;
    for (long j = list->start[i]; j < list->end[i]; j++) {
        const double weight = solid_list_weight(list, h, j, solid_list_micromodulus(list, h, j));
        all += weight;
        if (solid_list_is_intact(list, j)) left += weight;
    }
    list->counted[i] = intact + 1;
    list->damage[i] = all > 0 ? 1 - left / all : 0;
    return list->damage[i];
}

double solid_list_limit(const struct solid_list *list, int h, long j) {
    double xi[3];
    solid_list_steps(list, j, xi);
    const struct solid_interface_side *interface = solid_list_interface(list, j);
    const struct solid_end *here = &list->particle[h - list->first],
                           *there = &list->particle[solid_list_record(list, j)];
    return interface ? solid_pair_across(&interface->law, &interface->other, xi, here, there).eps_limit
                     : solid_pair_limit(&list->law, xi, here, there);
}

double solid_list_bonds_energy(const struct solid_list *list, long j) {
    const struct solid_interface_side *interface = solid_list_interface(list, j);
    return interface ? 0.5 * (interface->law.bonds_energy + interface->other.bonds_energy) : list->law.bonds_energy;
}
