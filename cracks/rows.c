/* Rows of eight wet particles: their places, struts and links. */
#include "cracks/rows.h"
#include "base/memory.h"
#include "solid/bonds/family.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A particle's site on the lattice, numbered along the axis of the places. */
struct site {
    long key;
    int h;
};

static int by_key(const void *a, const void *b) {
    const struct site *x = a, *y = b;
    return x->key != y->key ? (x->key > y->key) - (x->key < y->key) : (x->h > y->h) - (x->h < y->h);
}

/* The axis along which most broken particles have a broken neighbour: it lies in the cracks. */
static int axis_of(const struct solid *s) {
    long found[3] = {0};
    int nearest[6], axis = 0;
    for (int h = 0; h < s->n; h++) {
        if (!(s->flag[h] & SOLID_BROKEN)) continue;
        solid_family_nearest(s, h, nearest);
        for (int f = 0; f < 6; f++)
            found[f / 2] += nearest[f] >= 0 && nearest[f] < s->n && s->flag[nearest[f]] & SOLID_BROKEN;
    }
    for (int c = 1; c < s->dim; c++)
        if (found[c] > found[axis] + found[axis] / 8) axis = c;
    return axis;
}

static struct site *sites_new(const struct solid *s, int axis) {
    const int n = s->n + s->n_ghost;
    struct site *site = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *site);
    long low[3] = {0}, high[3] = {0};
    for (int turn = 0; turn < 2; turn++)
        for (int h = 0; h < n; h++) {
            long key = 0;
            for (int k = 2; k >= 0; k--) {
                const int c = (axis + k) % 3;
                if (c >= s->dim) continue;
                const long x = lrint(floor(s->x0[c][h] / s->in.spacing + 0.25));
                if (turn == 0) {
                    low[c] = h == 0 || x < low[c] ? x : low[c];
                    high[c] = h == 0 || x > high[c] ? x : high[c];
                }
                key = key * (high[c] - low[c] + 2) + x - low[c];
            }
            site[h] = (struct site){key, h};
        }
    qsort(site, (size_t)n, sizeof *site, by_key);
    return site;
}

void cracks_rows_place(struct cracks_rows *r, const struct solid *s, const struct cracks_table *table) {
    const int n = s->n + s->n_ghost;
    struct site *site = sites_new(s, axis_of(s));
    r->place = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *r->place);
    int at = CRACKS_LANES;
    for (int k = 0; k < n; k++, at++) {
        if (k > 0 && site[k].key != site[k - 1].key + 1) at += CRACKS_LANES - at % CRACKS_LANES;
        r->place[site[k].h] = at;
    }
    memory_free(site);
    r->places = at + CRACKS_LANES - at % CRACKS_LANES;
    const size_t capacity = (size_t)r->places + CRACKS_LANES;
    r->row_of = memory_new(MEMORY_SOLID, capacity / CRACKS_LANES, sizeof *r->row_of);
    r->wet = memory_new(MEMORY_SOLID, capacity, sizeof *r->wet);
    r->x = memory_new(MEMORY_SOLID, capacity, sizeof *r->x);
    for (int c = 0; c < 3; c++) r->u[c] = memory_new(MEMORY_SOLID, capacity, sizeof *r->u[c]);
    r->last = memory_new(MEMORY_SOLID, 2 * (size_t)table->kinds, sizeof *r->last);
    cracks_rows_clear(r);
}

void cracks_rows_clear(struct cracks_rows *r) {
    const size_t capacity = (size_t)r->places + CRACKS_LANES;
    memset(r->row_of, 0xff, capacity / CRACKS_LANES * sizeof *r->row_of);
    memset(r->wet, 0, capacity);
    memset(r->x, 0, capacity * sizeof *r->x); /* a step that failed may have left numbers that are none */
    memset(r->u[0], 0, capacity * sizeof *r->u[0]);
    r->n = 0;
    r->struts = r->struts_dead = 0;
}

void cracks_rows_mark_stale(struct cracks_rows *r) {
    const size_t capacity = (size_t)r->places + CRACKS_LANES;
    memset(r->wet, 0, capacity);
    if (r->n > 0) memset(r->intact, 0xfe, (size_t)r->n * sizeof *r->intact); /* not read yet */
}

/* The lanes of a row whose struts are off, by kind. Returns whether there are some. */
static int find_off(const struct cracks_rows *r, int row, uint8_t off[SOLID_FAMILY_MAX]) {
    int some = 0;
    memset(off, 0, SOLID_FAMILY_MAX);
    for (long k = r->start[row]; k < r->end[row]; k++) {
        if (!r->strut[k].off) continue;
        off[r->strut[k].kind] |= r->strut[k].off;
        some = 1;
    }
    return some;
}

/* Switches those off again. A strut is one of a particle and a kind. */
static void switch_off(struct cracks_rows *r, int row, const uint8_t off[SOLID_FAMILY_MAX]) {
    for (long k = r->start[row]; k < r->end[row]; k++) {
        struct cracks_entry *e = &r->strut[k];
        e->off = e->lanes & off[e->kind];
        e->lanes &= (uint8_t)~e->off;
    }
}

/* Entries for the struts of one particle, which is at the lane of the row that begins at the entry `start`. */
static void add_struts(struct cracks_rows *r, long start, int lane, int n, const int *other,
                       signed char (*const step)[3], const struct cracks_table *table, int kinds) {
    for (int k = 0; k < n; k++) {
        const int kind = kinds + cracks_table_number(table, step[k]), at = r->place[other[k]] - lane;
        const long last = r->last[kind];
        if (last >= start && last < r->struts && r->strut[last].kind == kind && r->strut[last].at == at) {
            r->strut[last].lanes |= (uint8_t)(1u << lane);
        } else {
            r->last[kind] = r->struts;
            r->strut[r->struts++] = (struct cracks_entry){at, (uint16_t)kind, (uint8_t)(1u << lane), 0};
        }
    }
}

int cracks_rows_read(struct cracks_rows *r, const struct solid *s, const struct cracks_table *table, const int *h,
                     int porous, int row) {
    int other[SOLID_FAMILY_MAX], same = 1;
    signed char step[SOLID_FAMILY_MAX][3];
    for (int k = 0; k < CRACKS_LANES; k++) {
        const int i = r->index[row][k], intact = i >= 0 ? solid_family_intact_bonds(s, h[i]) : 0xffff;
        same &= intact == r->intact[row][k];
        r->intact[row][k] = (uint16_t)intact;
    }
    if (same) return 0;
    if (r->struts + 2 * CRACKS_LANES * SOLID_FAMILY_MAX > r->struts_capacity) {
        const size_t capacity = 2 * (size_t)r->struts_capacity + 2 * CRACKS_LANES * SOLID_FAMILY_MAX;
        r->strut = memory_grown(MEMORY_SOLID, r->strut, (size_t)r->struts, capacity, sizeof *r->strut);
        r->struts_capacity = (long)capacity;
    }
    uint8_t off[SOLID_FAMILY_MAX];
    const int some_off = find_off(r, row, off);
    r->struts_dead += r->end[row] - r->start[row];
    r->start[row] = r->struts;
    for (int k = 0; k < CRACKS_LANES; k++) {
        const int i = r->index[row][k];
        if (i < 0) continue;
        const int n = solid_family_struts(s, h[i], other, step);
        add_struts(r, r->start[row], k, n, other, step, table, 0);
    }
    r->middle[row] = r->struts;
    for (int k = 0; k < CRACKS_LANES && porous; k++) {
        const int i = r->index[row][k];
        if (i < 0) continue;
        const int n = solid_family_intact(s, h[i], other, step);
        add_struts(r, r->middle[row], k, n, other, step, table, table->kinds);
    }
    r->end[row] = r->struts;
    if (some_off) switch_off(r, row, off);
    return 1;
}

void cracks_rows_compact(struct cracks_rows *r) {
    if (r->struts_dead < 65536 || r->struts_dead < r->struts / 2) return;
    struct cracks_entry *strut = memory_new(MEMORY_SOLID, (size_t)r->struts_capacity, sizeof *strut);
    long struts = 0;
    for (int i = 0; i < r->n; i++) {
        const long shift = struts - r->start[i];
        memcpy(strut + struts, r->strut + r->start[i], (size_t)(r->end[i] - r->start[i]) * sizeof *strut);
        r->start[i] += shift;
        r->middle[i] += shift;
        r->end[i] += shift;
        struts = r->end[i];
    }
    memory_free(r->strut);
    r->strut = strut;
    r->struts = struts;
    r->struts_dead = 0;
}

/* The links of all rows. */
static void read_links(struct cracks_rows *r, const struct solid *s, const int *h) {
    int nearest[CRACKS_LANES][6];
    long links = 0;
    for (int row = 0; row < r->n; row++) {
        if (links + 6 * CRACKS_LANES > r->links_capacity) {
            const size_t capacity = 2 * (size_t)r->links_capacity + 6 * CRACKS_LANES;
            r->link = memory_grown(MEMORY_SOLID, r->link, (size_t)links, capacity, sizeof *r->link);
            r->links_capacity = (long)capacity;
        }
        r->link_start[row] = links;
        memset(nearest, 0xff, sizeof nearest);
        for (int k = 0; k < CRACKS_LANES; k++)
            if (r->index[row][k] >= 0) solid_family_nearest(s, h[r->index[row][k]], nearest[k]);
        for (int f = 0; f < 6; f++) {
            const long begin = links;
            for (int k = 0; k < CRACKS_LANES; k++) {
                if (nearest[k][f] < 0 || !r->wet[r->place[nearest[k][f]]]) continue;
                const int at = r->place[nearest[k][f]] - k;
                if (links > begin && r->link[links - 1].at == at)
                    r->link[links - 1].lanes |= (uint8_t)(1u << k);
                else
                    r->link[links++] = (struct cracks_entry){at, (uint16_t)f, (uint8_t)(1u << k), 0};
            }
        }
    }
    r->link_start[r->n] = links;
}

/* Room for the rows, which move from their old numbers to their new ones. of: of new rows -2. */
static void rows_renumber(struct cracks_rows *r) {
    struct cracks_rows old = *r;
    const int ends = r->places / CRACKS_LANES;
    int rows = 0;
    for (int q = 0; q < ends; q++) rows += r->row_of[q] != -1;
    const size_t capacity = (size_t)rows + 1;
    r->first = memory_new(MEMORY_SOLID, capacity, sizeof *r->first);
    r->index = memory_new(MEMORY_SOLID, capacity, sizeof *r->index);
    r->intact = memory_new(MEMORY_SOLID, capacity, sizeof *r->intact);
    long **const array[] = {&r->start, &r->middle, &r->end}, *const was[] = {old.start, old.middle, old.end};
    r->link_start = memory_new(MEMORY_SOLID, capacity, sizeof *r->link_start);
    for (int a = 0; a < 3; a++) *array[a] = memory_new(MEMORY_SOLID, capacity, sizeof **array[a]);
    for (int c = 0; c < 3; c++) {
        memory_free(r->y[c]);
        r->y[c] = memory_new(MEMORY_SOLID, CRACKS_LANES * capacity, sizeof *r->y[c]);
    }
    r->n = 0;
    for (int q = 0; q < ends; q++) {
        const int from = r->row_of[q];
        if (from == -1) continue;
        r->first[r->n] = CRACKS_LANES * q;
        if (from < 0) {
            memset(r->intact[r->n], 0xfe, sizeof r->intact[r->n]); /* not read yet */
        } else {
            memcpy(r->intact[r->n], old.intact[from], sizeof *r->intact);
            for (int a = 0; a < 3; a++) (*array[a])[r->n] = was[a][from];
        }
        r->row_of[q] = r->n++;
    }
    MEMORY_FREE(old.first, old.index, old.intact, old.start, old.middle, old.end, old.link_start);
}

void cracks_rows_renew(struct cracks_rows *r, const struct solid *s, int n, int ghosts, const int *h) {
    for (int i = 0; i < n + ghosts; i++) {
        const int at = r->place[h[i]];
        r->wet[at] = 1;
        if (i < n && r->row_of[at / CRACKS_LANES] == -1) r->row_of[at / CRACKS_LANES] = -2;
    }
    rows_renumber(r);
    memset(r->index, 0xff, (size_t)r->n * sizeof *r->index);
    for (int i = 0; i < n; i++) r->index[r->row_of[r->place[h[i]] / CRACKS_LANES]][r->place[h[i]] % CRACKS_LANES] = i;
    read_links(r, s, h);
}

void cracks_rows_free(struct cracks_rows *r) {
    MEMORY_FREE(r->place, r->row_of, r->wet, r->x, r->u[0], r->u[1], r->u[2], r->first, r->index, r->intact, r->start,
                r->middle, r->end, r->strut, r->last, r->link_start, r->link, r->y[0], r->y[1], r->y[2]);
    *r = (struct cracks_rows){0};
}
