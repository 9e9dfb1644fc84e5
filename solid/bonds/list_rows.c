/* Finds the rows of a plate's lattice in the list store, and keeps track of bonds that break there. */
#include "solid/bonds/list_rows.h"
#include "base/memory.h"
#include "base/sort.h"
#include "base/vec.h"
#include "solid/bonds/key.h"
#include "solid/body/cloud.h"

#include <limits.h>
#include <math.h>
#include <string.h>

enum {
    SAMPLES = 64, /* particles whose families are compared to find the commonest */
    SPARSE = 4    /* the box has at most so many sites for each record */
};

/* Whether two particles have equal families, corrections and limits, to the bit. */
static int are_alike(const struct solid_list *list, int a, int b) {
    const long from = list->start[a], n = list->end[a] - from, to = list->start[b];
    if (n == 0 || list->end[b] - to != n || list->w[a] != list->w[b] || list->eps_limit[a] != list->eps_limit[b])
        return 0;
    for (long j = 0; j < n; j++) {
        if (fabs(list->stiffness[from + j]) != fabs(list->stiffness[to + j])) return 0;
        for (int c = 0; c < 2; c++)
            if (*solid_list_step(list, from + j, c) != *solid_list_step(list, to + j, c)) return 0;
        if (list->w[solid_list_record(list, to + j)] != list->w[b]) return 0;
    }
    return 1;
}

/* A particle with the commonest family of some that are looked at; -1: all differ. */
static int commonest(const struct solid_list *list) {
    int most = 1, found = -1;
    for (int a = 0; a < SAMPLES; a++) {
        const int i = (int)((long)list->n * a / SAMPLES);
        int alike = 0;
        for (int b = 0; b < SAMPLES; b++) alike += are_alike(list, i, (int)((long)list->n * b / SAMPLES));
        if (alike > most) most = alike, found = i;
    }
    return found;
}

struct place {
    int x, y; /* spacings from the reference particle; x is NOWHERE off the lattice */
};
enum { NOWHERE = INT_MIN };

static struct place place_of(const struct solid_list *list, const struct solid_cloud *cloud, int record,
                             int reference) {
    const long key = record < list->n ? solid_key_of(cloud->first + list->number + record, SOLID_NO_IMAGE)
                                      : list->other_key[record - list->n];
    const long i = solid_key_id(key) - cloud->first;
    const struct place nowhere = {NOWHERE, 0};
    double x[2];
    if (i < 0 || i >= cloud->n) return nowhere; /* of another body */
    for (int c = 0; c < 2; c++) {
        const double period = solid_cloud_image_of(solid_key_image(key), c) * list->period[c];
        x[c] = (cloud->place[c][i] - cloud->place[c][list->number + reference]) + period;
        if (x[c] != rint(x[c]) || fabs(x[c]) > INT_MAX / 4) return nowhere;
    }
    return (struct place){(int)x[0], (int)x[1]};
}

/* The box around the members, and the sites of records in it. Returns its width, 0: too many sites. */
static int box_find(struct solid_list *list, const struct place *place, int reach) {
    struct solid_list_rows *rows = list->rows;
    const int records = list->n + list->others;
    struct place low = {INT_MAX, INT_MAX}, high = {INT_MIN, INT_MIN};
    for (int i = 0; i < list->n; i++) {
        if (!rows->complete[i]) continue;
        low.x = place[i].x < low.x ? place[i].x : low.x;
        low.y = place[i].y < low.y ? place[i].y : low.y;
        high.x = place[i].x > high.x ? place[i].x : high.x;
        high.y = place[i].y > high.y ? place[i].y : high.y;
    }
    low.x -= reach, low.y -= reach, high.x += reach, high.y += reach;
    const long width = (long)high.x - low.x + SOLID_LIST_BLOCK, height = (long)high.y - low.y + 1;
    if (width * height > SPARSE * (long)records + 4096) return 0;
    rows->sites = (int)(width * height);
    for (int r = 0; r < records; r++) {
        const struct place p = place[r];
        const int inside = p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
        rows->site[r] = inside ? (p.y - low.y) * (int)width + (p.x - low.x) : -1;
    }
    return (int)width;
}

/* The bonds of the common family; returns the largest |xi| along an axis, spacings. */
static int bonds_set(struct solid_list *list, int reference) {
    struct solid_list_rows *rows = list->rows;
    int reach = 0;
    rows->w = list->w[reference];
    rows->digit = list->digit[reference];
    rows->eps_limit = list->eps_limit[reference];
    rows->family = (int)(list->end[reference] - list->start[reference]);
    rows->bond = solid_store_array((size_t)rows->family, sizeof *rows->bond);
    for (int o = 0; o < rows->family; o++) {
        struct solid_list_rows_bond *bond = &rows->bond[o];
        const long j = list->start[reference] + o;
        for (int c = 0; c < 2; c++) {
            bond->xi[c] = *solid_list_step(list, j, c);
            reach = (int)fmax(reach, ceil(fabs(bond->xi[c])));
        }
        const vec inverse = vec_reciprocal(vec_set(bond->xi[0] * bond->xi[0] + bond->xi[1] * bond->xi[1]));
        bond->inverse = inverse[0]; /* as in the sweep over lists, to the bit */
        bond->stiffness = fabs(list->stiffness[j]);
        bond->per_length = bond->stiffness * vec_sqrt(inverse)[0];
    }
    return reach;
}

/* Whether the other ends of the i-th particle's bonds are where the family has them. */
static int is_placed(const struct solid_list *list, int i) {
    const struct solid_list_rows *rows = list->rows;
    for (int o = 0; o < rows->family; o++)
        if (rows->site[solid_list_record(list, list->start[i] + o)] != rows->site[i] + rows->bond[o].shift) return 0;
    return 1;
}

static int is_complete(const struct solid_list *list, int i) {
    for (long j = list->start[i]; j < list->end[i]; j++)
        if (!solid_list_is_swept(list, j)) return 0;
    return 1;
}

/* The row of eight sites from `site` on; at [sites]: the member on a site, -1: none. Returns its members' number. */
static int row_of(const struct solid_list *list, const int *at, int site, struct solid_list_row *row) {
    *row = (struct solid_list_row){.site = site};
    for (int k = 0; k < SOLID_LIST_BLOCK; k++) {
        const int i = row->particle[k] = at[site + k];
        if (i < 0) continue;
        row->member |= (uint8_t)(1u << k);
        if (is_complete(list, i)) row->complete |= (uint8_t)(1u << k);
    }
    for (int k = 0; k < SOLID_LIST_BLOCK && row->member; k++)
        if (!(row->member >> k & 1)) row->particle[k] = row->particle[__builtin_ctz(row->member)];
    return __builtin_popcount(row->member);
}

/* Joins the members to rows; those that stand alone are swept by their lists. */
static void rows_set(struct solid_list *list) {
    struct solid_list_rows *rows = list->rows;
    int *at = memory_new(MEMORY_SOLID, (size_t)rows->sites + SOLID_LIST_BLOCK, sizeof *at);
    for (int k = 0; k < rows->sites + SOLID_LIST_BLOCK; k++) at[k] = -1;
    for (int i = 0; i < list->n; i++) {
        if (rows->complete[i]) at[rows->site[i]] = i;
        rows->complete[i] = 0;
    }
    for (int pass = 0; pass < 2; pass++) { /* counts them first */
        rows->rows = 0;
        for (int k = 0; k < rows->sites; k++) {
            struct solid_list_row row;
            if (at[k] < 0 || row_of(list, at, k, &row) < SOLID_LIST_ROW_FEWEST) continue;
            if (pass > 0) rows->row[rows->rows] = row;
            rows->rows++;
            k += SOLID_LIST_BLOCK - 1;
        }
        if (pass == 0) rows->row = solid_store_array((size_t)rows->rows, sizeof *rows->row);
    }
    memory_free(at);
    for (int r = 0; r < rows->rows; r++)
        for (int k = 0; k < SOLID_LIST_BLOCK; k++)
            if (rows->row[r].complete >> k & 1) rows->complete[rows->row[r].particle[k]] = 1;
}

/* Sets the bonds' shifts in a box of this width, and the rows of those members that stand in it as the family does. */
static void members_place(struct solid_list *list, int width) {
    struct solid_list_rows *rows = list->rows;
    for (int o = 0; o < rows->family; o++)
        rows->bond[o].shift = (int)rows->bond[o].xi[1] * width + (int)rows->bond[o].xi[0];
    for (int i = 0; i < list->n; i++) rows->complete[i] = rows->complete[i] && is_placed(list, i);
    rows_set(list);
}

void solid_list_rows_find(struct solid_list *list, const struct solid_cloud *cloud) {
    const int reference = list->dim == 2 && list->n >= SAMPLES ? commonest(list) : -1, records = list->n + list->others;
    if (reference < 0) return;
    struct solid_list_rows *rows = list->rows = memory_new(MEMORY_SOLID, 1, sizeof *rows);
    struct place *place = memory_new(MEMORY_SOLID, (size_t)records + 1, sizeof *place);
    rows->site = solid_store_array((size_t)records, sizeof *rows->site);
    rows->complete = solid_store_array((size_t)list->n, 1); /* meanwhile: the members */
    for (int r = 0; r < records; r++) place[r] = place_of(list, cloud, r, reference);
    for (int i = 0; i < list->n; i++) rows->complete[i] = place[i].x != NOWHERE && are_alike(list, reference, i);
    const int reach = bonds_set(list, reference), width = box_find(list, place, reach);
    memory_free(place);
    if (width > 0) members_place(list, width);
    if (rows->rows == 0) {
        list->rows = NULL;
        solid_list_rows_free(rows);
        return;
    }
    for (int c = 0; c < 2; c++) rows->d[c] = solid_store_array((size_t)rows->sites, sizeof *rows->d[c]);
}

void solid_list_rows_free(struct solid_list_rows *rows) {
    if (!rows) return;
    MEMORY_FREE(rows->bond, rows->site, rows->d[0], rows->d[1], rows->v[0], rows->v[1], rows->row, rows->complete,
                rows);
}

void solid_list_rows_fill(const struct solid_list *list, int damped) {
    struct solid_list_rows *rows = list->rows;
    for (int c = 0; c < 2 && damped; c++)
        if (!rows->v[c]) rows->v[c] = solid_store_array((size_t)rows->sites, sizeof *rows->v[c]);
    for (int r = 0; r < list->n + list->others; r++) {
        if (rows->site[r] < 0) continue;
        for (int c = 0; c < 2; c++) {
            rows->d[c][rows->site[r]] = list->record[2 * r + c];
            if (damped) rows->v[c][rows->site[r]] = list->speed[(long)SOLID_LIST_SPEED * r + c];
        }
    }
}

/* The row of a site, or the last one before it. */
static struct solid_list_row *row_before(const struct solid_list_rows *rows, int site) {
    int low = 0, high = rows->rows;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        *(rows->row[middle].site <= site ? &low : &high) = middle;
    }
    return &rows->row[low];
}

void solid_list_rows_changed(struct solid_list *list, long j) {
    struct solid_list_rows *rows = list->rows;
    const int i = (int)sort_find(list->start, list->n, j), site = rows->site[i];
    if (site < 0) return;
    struct solid_list_row *row = row_before(rows, site);
    const int k = site - row->site;
    if (k < 0 || k >= SOLID_LIST_BLOCK || !(row->member >> k & 1)) return;
    rows->complete[i] = (uint8_t)is_complete(list, i);
    row->complete = (uint8_t)((row->complete & ~(1u << k)) | (unsigned)rows->complete[i] << k);
}

long solid_list_rows_bonds(const struct solid_list *list) {
    long complete = 0;
    for (int r = 0; list->rows && r < list->rows->rows; r++)
        complete += __builtin_popcount(list->rows->row[r].complete);
    return complete > 0 ? complete * list->rows->family : 0;
}
