#include "solid/list.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/family.h"
#include "solid/number.h"
#include "solid/points.h"

#include <math.h>
#include <string.h>

static void *solid_array(long n, size_t size) { return memory_new(MEMORY_SOLID, (size_t)n + 1, size); }

/* What tells the other ends of bonds apart: global id and periodic image, -1, 0 or 1 in each direction. */
enum { IMAGES = 27, NO_IMAGE = 13 };

static long key_of(long id, const int image[3]) {
    return IMAGES * id + NO_IMAGE + image[0] + 3 * image[1] + 9 * image[2];
}

static int image_of(long key, int c) {
    static const int power[3] = {1, 3, 9};
    return (int)(key % IMAGES) / power[c] % 3 - 1;
}

static void arrays_new(struct solid_list *b) {
    const long n = b->bonds + SOLID_LIST_SLACK;
    b->key = solid_array(b->bonds, sizeof *b->key);
    b->record = solid_array(n, sizeof *b->record);
    b->inv_length = solid_array(n, sizeof *b->inv_length);
    b->weight = solid_array(n, sizeof *b->weight);
    b->intact = solid_array(n, 1);
    b->large = solid_array(b->n, 1);
    memset(b->intact, 1, (size_t)b->bonds);
}

/* In which period a site stands. */
static void site_image(const struct solid_sites *t, const int site[3], int image[3]) {
    for (int c = 0; c < 3; c++) {
        image[c] = 0;
        for (int at = site[c]; t->wrap[c] && at < t->base[c]; at += t->wrap[c]) image[c]--;
        for (int at = site[c]; t->wrap[c] && at >= t->base[c] + t->wrap[c]; at -= t->wrap[c]) image[c]++;
    }
}

/* Lattice bodies: the stencil's offsets, in its order. Twice: count, then fill. */
static void from_lattice(struct solid_list *b, const struct solid_sites *t,
                         const struct solid_stencil *stencil, long from, long to) {
    for (int fill = 0; fill < 2; fill++) {
        long j = 0;
        int i = 0;
        for (int q = 0; q < t->filled; q++) {
            const int row = t->order[q];
            if (t->start[row] < from || t->start[row] >= to) continue;
            for (int k = 0; k < 8; k++) {
                if (!(t->bits[row] >> k & 1)) continue;
                const int site[3] = {t->low[0] + 8 * (row % t->rows[0]) + k,
                                     t->low[1] + row / t->rows[0] % t->rows[1],
                                     t->low[2] + row / t->rows[0] / t->rows[1]};
                b->start[i++] = j;
                for (int o = 0; o < stencil->n; o++) {
                    const struct solid_offset *offset = &stencil->offset[o];
                    const int other[3] = {site[0] + offset->step[0], site[1] + offset->step[1],
                                          site[2] + offset->step[2]};
                    const long id = solid_sites_id(t, other);
                    if (id < 0) continue;
                    if (fill) {
                        int image[3];
                        site_image(t, other, image);
                        b->key[j] = key_of(id, image);
                        b->weight[j] = offset->weight;
                    }
                    j++;
                }
            }
        }
        b->start[i] = b->bonds = j;
        if (!fill) arrays_new(b);
    }
}

/* Points: |xi| < delta + spacing/2, delta the mean of the two ends' horizons, Gamma symmetric. */
static void from_points(struct solid_list *b, const struct solid_input *in, const struct solid_body *body,
                        const struct solid_sites *t, const struct solid_stencil *stencil, long low) {
    struct solid_points *points = solid_points_new(in, body, t, stencil->horizon);
    struct solid_points_near *near = memory_new(MEMORY_SOLID, 1, sizeof *near);
    for (int fill = 0; fill < 2; fill++) {
        long j = 0;
        for (int i = 0; i < b->n; i++) {
            b->start[i] = j;
            solid_points_near(points, low - t->first + i, near);
            for (int k = 0; fill && k < near->n; k++) {
                b->key[j + k] = key_of(t->first + near->number[k], near->image[k]);
                b->weight[j + k] = near->weight[k];
            }
            j += near->n;
        }
        b->start[b->n] = b->bonds = j;
        if (!fill) arrays_new(b);
    }
    memory_free(near);
    solid_points_free(points);
}

struct solid_list *solid_list_new(const struct solid_input *in, const struct solid_body *body,
                                  const struct solid_sites *t, const struct solid_stencil *stencil,
                                  struct solid_law law, long from, long to, int first) {
    struct solid_list *b = memory_new(MEMORY_SOLID, 1, sizeof *b);
    b->law = law;
    b->full_volume = stencil->full_volume;
    b->first = first;
    for (int c = 0; c < 3; c++) b->period[c] = in->periodic[c] ? in->length[c] : 0;
    const long low = from > t->first ? from : t->first,
               high = to < t->first + t->count ? to : t->first + t->count;
    b->n = high > low ? (int)(high - low) : 0;
    b->start = solid_array(b->n, sizeof *b->start);
    if (t->is_lattice)
        from_lattice(b, t, stencil, from, to);
    else
        from_points(b, in, body, t, stencil, low);
    return b;
}

void solid_list_free(struct solid_list *b) {
    if (!b) return;
    void *owned[] = {b->start, b->key,       b->record,      b->inv_length, b->weight, b->intact,
                     b->large, b->other_key, b->other_local, b->place,      b->speed,  b};
    for (size_t i = 0; i < sizeof owned / sizeof owned[0]; i++) memory_free(owned[i]);
}

long solid_list_wanted(const struct solid_list *b, long from, long to, long *id) {
    long wanted = 0;
    for (long j = 0; j < b->bonds; j++) {
        const long other = b->key[j] / IMAGES;
        if (other >= from && other < to) continue;
        if (id) id[wanted] = other;
        wanted++;
    }
    return wanted;
}

/* The owned particle itself, without its periodic images. */
static int is_home(const struct solid_list *b, const struct solid_numbering *numbering, long key) {
    const long i = key / IMAGES - numbering->from - b->first;
    return key % IMAGES == NO_IMAGE && i >= 0 && i < b->n;
}

static void others_new(struct solid_list *b, const struct solid_numbering *numbering) {
    long n = 0;
    for (long j = 0; j < b->bonds; j++) n += !is_home(b, numbering, b->key[j]);
    b->other_key = solid_array(n, sizeof *b->other_key);
    n = 0;
    for (long j = 0; j < b->bonds; j++)
        if (!is_home(b, numbering, b->key[j])) b->other_key[n++] = b->key[j];
    b->others = solid_number_unique(b->other_key, n);
    long *all = b->other_key;
    b->other_key = solid_array(b->others, sizeof *all);
    memcpy(b->other_key, all, (size_t)b->others * sizeof *all);
    memory_free(all);
    b->other_local = solid_array(b->others, sizeof *b->other_local);
    for (int i = 0; i < b->others; i++) {
        b->other_local[i] = solid_numbering_local(numbering, b->other_key[i] / IMAGES);
        ENSURE(b->other_local[i] >= 0, "particle %ld is not known here", b->other_key[i] / IMAGES);
    }
}

void solid_list_link(struct solid_list *b, const struct solid_numbering *numbering) {
    others_new(b, numbering);
    const struct solid_numbering others = {0, 0, b->others, b->other_key};
    for (long j = 0; j < b->bonds; j++) {
        const long key = b->key[j];
        b->record[j] = is_home(b, numbering, key) ? (int)(key / IMAGES - numbering->from) - b->first
                                                  : b->n + solid_numbering_local(&others, key);
    }
    memory_free(b->key);
    b->key = NULL;
    const long records = b->n + b->others;
    b->place = solid_array(SOLID_LIST_PLACE * records, sizeof *b->place);
    b->speed = solid_array(SOLID_LIST_SPEED * records, sizeof *b->speed);
}

void solid_list_volumes(const struct solid_list *b, double *family_volume) {
    for (int i = 0; i < b->n; i++) {
        double sum = 0;
        for (long j = b->start[i]; j < b->start[i + 1]; j++) sum += b->weight[j];
        family_volume[b->first + i] = sum;
    }
}

/* The digit that places are rounded to: 2^-52 of a power of two above all of them, so that differences are exact. */
static double last_digit(const struct solid_list *b, double *const x0[3]) {
    double most = 0;
    for (int r = 0; r < b->n + b->others; r++)
        for (int c = 0; c < 3; c++) {
            const double here = fabs(x0[c][solid_list_local(b, r)]) + b->period[c];
            if (here > most) most = here;
        }
    return ldexp(1, ilogb(par_max(most)) - 51);
}

static void places_set(struct solid_list *b, double *const x0[3], double digit) {
    for (int r = 0; r < b->n + b->others; r++)
        for (int c = 0; c < 3; c++) {
            const int l = solid_list_local(b, r), image = r < b->n ? 0 : image_of(b->other_key[r - b->n], c);
            b->place[(long)SOLID_LIST_PLACE * r + c] =
                digit * (rint(x0[c][l] / digit) + image * rint(b->period[c] / digit));
        }
}

void solid_list_weights(struct solid_list *b, double *const x0[3], const double *family_volume,
                        int surface_correction) {
    places_set(b, x0, last_digit(b, x0));
    for (int r = 0; r < b->n + b->others; r++)
        b->place[(long)SOLID_LIST_PLACE * r + 3] =
            surface_correction ? family_volume[solid_list_local(b, r)] / b->full_volume : 1;
    for (int i = 0; i < b->n; i++)
        for (long j = b->start[i]; j < b->start[i + 1]; j++) {
            double xi[3];
            solid_list_xi(b, b->first + i, j, xi);
            b->inv_length[j] = 1 / sqrt(xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2]);
        }
}

int solid_list_longest(const struct solid_list *b) {
    long longest = 0;
    for (int i = 0; i < b->n; i++)
        if (b->start[i + 1] - b->start[i] > longest) longest = b->start[i + 1] - b->start[i];
    return (int)longest;
}

long solid_list_reverse(const struct solid_list *b, int h, long j) {
    const int l = solid_list_local(b, b->record[j]);
    if (l < b->first || l >= b->first + b->n) return -1;
    double xi[3], back[3];
    solid_list_xi(b, h, j, xi);
    for (long k = b->start[l - b->first]; k < b->start[l - b->first + 1]; k++) {
        if (solid_list_local(b, b->record[k]) != h) continue;
        solid_list_xi(b, l, k, back);
        if (back[0] == -xi[0] && back[1] == -xi[1] && back[2] == -xi[2]) return k;
    }
    return -1;
}
