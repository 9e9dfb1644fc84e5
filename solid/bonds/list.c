/* List store of bonds: links the bond lists to local particles and computes weights; access to single bonds. */
#include "solid/bonds/list.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "solid/body/number.h"
#include "solid/bonds/list_find.h"
#include "solid/law/weight.h"

#include <math.h>
#include <string.h>

void solid_list_free(struct solid_list *b) {
    if (!b) return;
    solid_weight_table_free(b->law.table);
    void *const own[] = {b->start,  b->end,   b->at,         b->step,      b->stiffness,   b->large,    b->limit,
                         b->digit,  b->power, b->own_volume, b->other_key, b->other_local, b->particle, b->w,
                         b->record, b->speed, b->key,        b->scaled,    b->damage,      b->counted,  b->kept,
                         b};
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) memory_free(own[i]);
}

long solid_list_wanted(const struct solid_list *b, long from, long to, long *id) {
    long wanted = 0;
    for (int i = 0; i < b->n; i++) {
        if (b->scaled[i] == SOLID_LIST_LINKED) continue;
        for (long j = b->start[i]; j < b->end[i]; j++) {
            const long other = b->key[j] < 0 ? from : solid_key_id(b->key[j]);
            if (other >= from && other < to) continue;
            if (id) id[wanted] = other;
            wanted++;
        }
    }
    return wanted;
}

/* Whether the key is that of an owned particle, not of a periodic image; a key below 0 is already linked. */
static int is_home(const struct solid_list *b, const struct solid_numbering *numbering, long key) {
    if (key < 0) return 1;
    const long i = solid_key_id(key) - numbering->from - b->first;
    return solid_key_image(key) == SOLID_NO_IMAGE && i >= 0 && i < b->n;
}

static void others_new(struct solid_list *b, const struct solid_numbering *numbering) {
    long n = 0, room = 0;
    for (int i = 0; i < b->n; i++)
        if (b->scaled[i] != SOLID_LIST_LINKED)
            for (long j = b->start[i]; j < b->end[i]; j++) room += !is_home(b, numbering, b->key[j]);
    long *all = solid_store_array(room, sizeof *all);
    for (int i = 0; i < b->n && n < room; i++)
        if (b->scaled[i] != SOLID_LIST_LINKED)
            for (long j = b->start[i]; j < b->end[i]; j++)
                if (!is_home(b, numbering, b->key[j])) all[n++] = b->key[j];
    b->others = solid_number_unique(all, n);
    b->other_key = solid_store_array(b->others, sizeof *all);
    memcpy(b->other_key, all, (size_t)b->others * sizeof *all);
    memory_free(all);
    b->other_local = solid_store_array(b->others, sizeof *b->other_local);
    for (int i = 0; i < b->others; i++) {
        const long id = solid_key_id(b->other_key[i]);
        b->other_local[i] = solid_number_local(numbering, id);
        ENSURE(b->other_local[i] >= 0, "particle %ld is not known here", id);
    }
}

static void records_new(struct solid_list *b, const struct solid_cloud *cloud) {
    const int records = b->n + b->others;
    b->record = solid_store_array((long)b->width * records, sizeof *b->record);
    b->speed = solid_store_array((long)SOLID_LIST_SPEED * records, sizeof *b->speed);
    b->particle = solid_store_array(records, sizeof *b->particle);
    b->w = solid_store_array(records, sizeof *b->w);
    for (int r = 0; r < records; r++)
        b->particle[r] =
            solid_cloud_end(cloud, r < b->n ? b->number + r : solid_key_id(b->other_key[r - b->n]) - b->first_id);
}

void solid_list_link(struct solid_list *b, const struct solid_cloud *cloud, const struct solid_numbering *numbering) {
    others_new(b, numbering);
    const struct solid_numbering others = {0, 0, b->others, b->other_key};
    for (int i = 0; i < b->n; i++) {
        const long next = i + 1 < b->n ? b->start[i + 1] : b->room;
        if (b->scaled[i] == SOLID_LIST_LINKED) continue;
        for (long j = b->start[i]; j < b->end[i]; j++) {
            const long key = b->key[j];
            if (key < 0) continue;
            const int record = is_home(b, numbering, key) ? (int)(solid_key_id(key) - numbering->from) - b->first
                                                          : b->n + solid_number_local(&others, key);
            b->at[j] = b->width * record;
        }
        for (long j = b->end[i]; j < next; j++) b->at[j] = b->width * i;
    }
    memory_free(b->key);
    memory_free(b->kept);
    b->key = NULL;
    b->kept = NULL;
    records_new(b, cloud);
}

void solid_list_volumes(const struct solid_list *b, double *family_volume) {
    for (int i = 0; i < b->n; i++) family_volume[b->first + i] = b->own_volume[i] * b->unit;
}

/* V_h/V0 of all records. */
static void ratios_set(struct solid_list *b, const double *family_volume, int surface_correction) {
    struct solid_end last = {0};
    double full = 1;
    for (int r = 0; r < b->n + b->others; r++) {
        const struct solid_end *p = &b->particle[r];
        if (surface_correction && (p->size != last.size || p->horizon != last.horizon)) {
            full = solid_pair_full_volume(&b->law, p->horizon, p->size) * b->unit;
            last = *p;
        }
        b->w[r] = surface_correction ? family_volume[solid_list_local(b, r)] / full : 1;
        b->speed[(long)SOLID_LIST_SPEED * r + SOLID_LIST_SPEED - 1] = b->w[r];
    }
}

/* The digit to which bond forces are rounded. A component of a bond force is at most k |xi| g |zeta|/|xi| = k |xi| |s|
 * <= k |xi| |eps|; the digit has k |xi| rounded up to a power of two, and leaves room for the sum over the family. */
static double digit_of(const struct solid_list *b, int i) {
    double most = 0, xi[3];
    for (long j = b->start[i]; j < b->end[i]; j++)
        most = fmax(most, fabs(b->stiffness[j]) * solid_list_steps(b, j, xi));
    return most > 0 && isfinite(most) ? ldexp(1, ilogb(most) + 1) * solid_list_room(b, i) : 0;
}

void solid_list_weights(struct solid_list *b, const double *family_volume, int surface_correction) {
    ratios_set(b, family_volume, surface_correction);
    for (int i = 0; i < b->n; i++) {
        if (b->scaled[i]) continue;
        for (long j = b->start[i]; j < b->end[i]; j++) b->stiffness[j] *= solid_list_alpha(b, b->first + i, j);
        b->digit[i] = digit_of(b, i);
    }
}

int solid_list_longest(const struct solid_list *b) {
    long longest = 0;
    for (int i = 0; i < b->n; i++)
        if (b->end[i] - b->start[i] > longest) longest = b->end[i] - b->start[i];
    return (int)longest;
}

long solid_list_intact(const struct solid_list *b) {
    long count = 0;
    for (int i = 0; i < b->n; i++)
        for (long j = b->start[i]; j < b->end[i]; j += SOLID_LIST_BLOCK)
            count += __builtin_popcount(solid_list_block_intact(b, j));
    return count;
}

void solid_list_swap(struct solid_list *b, uint8_t *intact) {
    for (int i = 0; i < b->n; i++)
        for (long j = b->start[i]; j < b->end[i]; j++) {
            const int was = solid_list_is_intact(b, j);
            solid_list_set(b, j, intact[j]);
            intact[j] = (uint8_t)was;
        }
}

long solid_list_reverse(const struct solid_list *b, int h, long j) {
    const int i = solid_list_other(b, j) - b->first;
    if (i < 0 || i >= b->n) return -1;
    double xi[3], back[3];
    solid_list_steps(b, j, xi);
    for (long k = b->start[i]; k < b->end[i]; k++) {
        if (solid_list_other(b, k) != h) continue;
        solid_list_steps(b, k, back);
        if (back[0] == -xi[0] && back[1] == -xi[1] && back[2] == -xi[2]) return k;
    }
    return -1;
}

double solid_list_micromodulus(const struct solid_list *b, int h, long j) {
    double xi[3];
    solid_list_steps(b, j, xi);
    return solid_pair_micromodulus(&b->law, xi, &b->particle[h - b->first], &b->particle[solid_list_record(b, j)]);
}

double solid_list_weight(const struct solid_list *b, int h, long j, double micromodulus) {
    double xi[3];
    const double length = solid_list_steps(b, j, xi);
    const double kv = fabs(b->stiffness[j]) * b->law.density * length / solid_list_alpha(b, h, j);
    return kv / micromodulus;
}

/* The damage computed last is valid until a bond of the family breaks. */
double solid_list_damage(struct solid_list *b, int h) {
    const int i = h - b->first;
    int intact = 0;
    for (long j = b->start[i]; j < b->end[i]; j += SOLID_LIST_BLOCK)
        intact += __builtin_popcount(solid_list_block_intact(b, j));
    if (b->counted[i] == intact + 1) return b->damage[i];
    double left = 0, all = 0;
    for (long j = b->start[i]; j < b->end[i]; j++) {
        const double weight = solid_list_weight(b, h, j, solid_list_micromodulus(b, h, j));
        all += weight;
        if (solid_list_is_intact(b, j)) left += weight;
    }
    b->counted[i] = intact + 1;
    b->damage[i] = all > 0 ? 1 - left / all : 0;
    return b->damage[i];
}

double solid_list_limit(const struct solid_list *b, int h, long j) {
    double xi[3];
    solid_list_steps(b, j, xi);
    return solid_pair_limit(&b->law, xi, &b->particle[h - b->first], &b->particle[solid_list_record(b, j)]);
}
