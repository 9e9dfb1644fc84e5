/* Tells the voxels inside a closed surface of triangles by how often a line through their centres has crossed it. */
#include "base/files/image/formats.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define STEPS 536870912.0 /* 2^29 along the longest edge: products of differences fit in 64 bits */
static const double WHOLE = 1e-6;
enum { VOXELS_MAX = 1000000 };

typedef int32_t corner[3]; /* in steps, the file's axes */

struct stl {
    int triangles;
    corner (*at)[3];
    double edge[3];      /* of a voxel, in steps */
    int *start, *number; /* [slices + 1] of the triangles that meet the centres of each slice */
    int outward;         /* 1 or -1: the sign of the volume */
};

/* A directed edge, the lower corner first; forward 1 or -1. */
struct edge {
    int low, high, forward;
};

struct place {
    corner x;
    int at;
};

static int by_place(const void *a, const void *b) {
    const struct place *p = a, *q = b;
    for (int c = 0; c < 3; c++)
        if (p->x[c] != q->x[c]) return p->x[c] < q->x[c] ? -1 : 1;
    return 0;
}

static int by_ends(const void *a, const void *b) {
    const struct edge *p = a, *q = b;
    if (p->low != q->low) return p->low < q->low ? -1 : 1;
    return (p->high > q->high) - (p->high < q->high);
}

/* Numbers the corners, equal ones alike: number [3 triangles]. */
static void number_corners(const struct stl *t, int *number) {
    const size_t n = 3 * (size_t)t->triangles;
    struct place *place = image_source_new(n, sizeof *place);
    for (size_t q = 0; q < n; q++) {
        memcpy(place[q].x, t->at[q / 3][q % 3], sizeof place[q].x);
        place[q].at = (int)q;
    }
    qsort(place, n, sizeof *place, by_place);
    for (size_t q = 0, k = 0; q < n; q++) {
        if (q > 0 && by_place(&place[q], &place[q - 1])) k++;
        number[place[q].at] = (int)k;
    }
    free(place);
}

/* Edges that are not passed as often one way as the other. */
static long open_edges(const struct stl *t) {
    const size_t n = 3 * (size_t)t->triangles;
    int *number = image_source_new(n, sizeof *number);
    struct edge *edge = image_source_new(n, sizeof *edge);
    long open = 0;
    number_corners(t, number);
    for (size_t q = 0; q < n; q++) {
        const int from = number[q], to = number[q / 3 * 3 + (q + 1) % 3];
        edge[q] = from < to ? (struct edge){from, to, 1} : (struct edge){to, from, from > to ? -1 : 0};
    }
    qsort(edge, n, sizeof *edge, by_ends);
    for (size_t q = 0, end; q < n; q = end) {
        int sum = 0;
        for (end = q; end < n && by_ends(&edge[end], &edge[q]) == 0; end++) sum += edge[end].forward;
        open += abs(sum);
    }
    free(number);
    free(edge);
    return open;
}

/* Of the centre of voxel i along axis f, in steps. */
static int64_t centre_of(const struct stl *t, int f, long i) { return llrint(((double)i + 0.5) * t->edge[f]); }

/* Rounds the corners to steps from the low corner of the bounding box, and sets the number of voxels. */
static int place_corners(struct image_source *s, struct stl *t, const double (*x)[3][3], const double edge[3]) {
    double low[3], high[3], longest = 0;
    for (int f = 0; f < 3; f++) {
        low[f] = high[f] = x[0][0][f];
        for (long q = 0; q < 3L * t->triangles; q++) {
            low[f] = fmin(low[f], x[q / 3][q % 3][f]);
            high[f] = fmax(high[f], x[q / 3][q % 3][f]);
        }
        longest = fmax(longest, high[f] - low[f]);
    }
    for (int f = 0; f < 3; f++) {
        const double n = ceil((high[f] - low[f]) / edge[f] - WHOLE);
        if (edge[f] > longest || !(n >= 1))
            return image_source_refuse(s, "it is %g x %g x %g in its unit, less than a voxel", high[0] - low[0],
                                       high[1] - low[1], high[2] - low[2]);
        if (n > VOXELS_MAX)
            return image_source_refuse(s, "it is %g x %g x %g in its unit, more than %d voxels along an edge",
                                       high[0] - low[0], high[1] - low[1], high[2] - low[2], VOXELS_MAX);
        s->n[f] = (long)n;
        t->edge[f] = edge[f] * (STEPS / longest);
        for (long q = 0; q < 3L * t->triangles; q++)
            t->at[q / 3][q % 3][f] = (int32_t)lrint((x[q / 3][q % 3][f] - low[f]) * (STEPS / longest));
    }
    return 0;
}

/* The voxels first .. last whose centres are between two corners of a triangle along an axis. */
static void reach(const struct image_source *s, const struct stl *t, int triangle, int f, long *first, long *last) {
    int32_t low = t->at[triangle][0][f], high = low;
    for (int q = 1; q < 3; q++) {
        const int32_t x = t->at[triangle][q][f];
        low = x < low ? x : low;
        high = x > high ? x : high;
    }
    *first = (long)floor(low / t->edge[f] - 0.5) - 1;
    *last = (long)ceil(high / t->edge[f] - 0.5) + 1;
    *first = *first < 0 ? 0 : *first;
    *last = *last >= s->n[f] ? s->n[f] - 1 : *last;
}

/* Lists the triangles of each slice; nonzero with a sentence. */
static int list_triangles(struct image_source *s, struct stl *t) {
    long first, last;
    long long all = 0;
    t->start = image_source_new((size_t)s->n[2] + 2, sizeof *t->start);
    for (int k = 0; k < t->triangles; k++) {
        reach(s, t, k, 2, &first, &last);
        for (long z = first; z <= last; z++) t->start[z + 2]++;
        all += last - first + 1;
    }
    if (all > INT32_MAX) return image_source_refuse(s, "its triangles meet more slices of voxels than can be listed");
    t->number = image_source_new((size_t)all + 1, sizeof *t->number);
    for (long z = 2; z < s->n[2] + 2; z++) t->start[z] += t->start[z - 1];
    for (int k = 0; k < t->triangles; k++) {
        reach(s, t, k, 2, &first, &last);
        for (long z = first; z <= last; z++) t->number[t->start[z + 1]++] = k;
    }
    return 0;
}

/* Twice the area between an edge from a to b and the line along x through (y, z), seen along x; where the line is on
 * the edge, the sign that it has a little lower in y, and less so in z. */
static int64_t side_of(const int32_t *a, const int32_t *b, int64_t y, int64_t z, int *sign) {
    const int64_t dy = (int64_t)b[1] - a[1], dz = (int64_t)b[2] - a[2];
    const int64_t area = dy * (z - a[2]) - dz * (y - a[1]);
    *sign = area ? (area > 0 ? 1 : -1) : dz ? (dz > 0 ? 1 : -1) : dy ? (dy > 0 ? -1 : 1) : 0;
    return area;
}

/* The first voxel whose centre is beyond the triangle on the line through (y, z), up to n; its sign, 0: the line does
 * not meet it. */
static long crossing(const struct stl *t, const corner *x, int64_t y, int64_t z, long n, int *sign) {
    int64_t part[3], area = 0;
    int side[3];
    for (int q = 0; q < 3; q++) {
        part[q] = side_of(x[(q + 1) % 3], x[(q + 2) % 3], y, z, &side[q]);
        area += part[q];
    }
    *sign = side[0] == side[1] && side[1] == side[2] ? side[0] : 0;
    if (!*sign || area == 0) return *sign = 0;
    double at = 0;
    __int128 sum = 0;
    for (int q = 0; q < 3; q++) {
        sum += (__int128)part[q] * x[q][0];
        at += (double)part[q] / (double)area * x[q][0];
    }
#define IS_BEYOND(i) (*sign * ((__int128)area * centre_of(t, 0, i) - sum) > 0)
    long i = (long)fmax(0, fmin((double)n, floor(at / t->edge[0])));
    while (i > 0 && IS_BEYOND(i - 1)) i--;
    while (i < n && !IS_BEYOND(i)) i++;
#undef IS_BEYOND
    return i;
}

static int read_box(struct image_source *s, const long low[3], const long high[3], double *value) {
    const struct stl *t = s->file;
    const long n = high[0] - low[0], rows = high[1] - low[1];
    memset(value, 0, (size_t)(n * rows * (high[2] - low[2])) * sizeof *value);
    for (long k = low[2]; k < high[2]; k++, value += rows * n) {
        for (int q = t->start[k]; q < t->start[k + 1]; q++) {
            long first, last;
            reach(s, t, t->number[q], 1, &first, &last);
            for (long j = first > low[1] ? first : low[1]; j <= last && j < high[1]; j++) {
                int sign;
                const long i = crossing(t, (const corner *)t->at[t->number[q]], centre_of(t, 1, j), centre_of(t, 2, k),
                                        s->n[0], &sign);
                if (sign && i < high[0]) value[(j - low[1]) * n + (i > low[0] ? i - low[0] : 0)] += sign;
            }
        }
        for (long q = 0; q < rows * n; q++) {
            if (q % n) value[q] += value[q - 1] * t->outward;
            value[q] *= t->outward;
            if (value[q] != 0 && value[q] != 1)
                return image_source_refuse(s,
                                           "parts of its surface overlap, or are inside out, near %g, %g, %g of its "
                                           "bounding box: join them in the program that made it",
                                           ((double)(low[0] + q % n) + 0.5) / (double)s->n[0],
                                           ((double)(low[1] + q / n) + 0.5) / (double)s->n[1],
                                           ((double)k + 0.5) / (double)s->n[2]);
        }
    }
    return 0;
}

static void close_file(struct image_source *s) {
    struct stl *t = s->file;
    if (!t) return;
    free(t->at);
    free(t->start);
    free(t->number);
    free(t);
}

/* The sign of the volume that the surface encloses. */
static int outward_of(const struct stl *t) {
    double volume = 0;
    for (int k = 0; k < t->triangles; k++) {
        const int32_t *a = t->at[k][0], *b = t->at[k][1], *c = t->at[k][2];
        volume += a[0] * ((double)b[1] * c[2] - (double)b[2] * c[1]) +
                  a[1] * ((double)b[2] * c[0] - (double)b[0] * c[2]) +
                  a[2] * ((double)b[0] * c[1] - (double)b[1] * c[0]);
    }
    return volume > 0 ? -1 : 1; /* along x a line comes in where the triangle turns the other way */
}

int image_stl_open(struct image_source *s, const struct files_image_input *input) {
    double edge[3];
    for (int f = 0; f < 3; f++) edge[f] = input->edge[s->axis[f]];
    if (!(edge[0] > 0 && edge[1] > 0 && edge[2] > 0))
        return image_source_refuse(s, "an STL has no unit: the key unit is needed, 1.0e-3 where it is in mm");
    struct stl *t = image_source_new(1, sizeof *t);
    s->file = t;
    s->close = close_file;
    s->read = read_box;
    s->type = FILES_IMAGE_UINT8;
    double(*x)[3][3] = image_stl_read(s, input->file, &t->triangles);
    if (!x) return 1;
    t->at = image_source_new((size_t)t->triangles, sizeof *t->at);
    const int fault = place_corners(s, t, (const double(*)[3][3])x, edge);
    free(x);
    if (fault) return 1;
    const long open = open_edges(t);
    if (open > 0)
        return image_source_refuse(s,
                                   "its surface is not closed: it has %ld open edge%s, that is such as are not "
                                   "shared by two triangles of the same turn: repair it",
                                   open, open == 1 ? "" : "s");
    t->outward = outward_of(t);
    image_source_block(s);
    return list_triangles(s, t);
}
