/* Reads a plane of a fluid's field file; vorticity and streamlines in it. */
#include "postproc/data/slice.h"
#include "base/memory.h"
#include "base/sort.h"

#include <math.h>
#include <stdlib.h>

/* Three planes of velocity, with the cells and the sides of the whole image. */
struct slab {
    const struct postproc_flow *flow; /* cells, sides */
    int axis;
    double *u[3];   /* planes index - 1, index, index + 1; NULL beyond a side */
    int read[3][3]; /* size of a plane */
};

static size_t cell_of(const struct slab *b, const int i[3]) {
    const int *n = b->flow->n;
    const int m[2] = {b->axis == 0 ? 1 : n[0], b->axis == 1 ? 1 : n[1]};
    const int q[3] = {b->axis == 0 ? 0 : i[0], b->axis == 1 ? 0 : i[1], b->axis == 2 ? 0 : i[2]};
    return ((size_t)q[2] * (size_t)m[1] + (size_t)q[1]) * (size_t)m[0] + (size_t)q[0];
}

/* Velocity component a of the cell's neighbour in direction c, s = -1 or 1. Where there is none, of what stands for it
 * beyond a wall; otherwise returns 0. */
static int neighbour(const struct slab *b, const int i[3], int c, int s, int a, double *u) {
    int q[3] = {i[0], i[1], i[2]};
    const int side = s > 0, n = b->flow->n[c];
    q[c] += s;
    if (q[c] < 0 || q[c] >= n) switch (b->flow->beyond[c][side]) {
        case POSTPROC_BEYOND_WRAP:
            q[c] = (q[c] + n) % n;
            break;
        case POSTPROC_BEYOND_MIRROR:
            *u = 2 * b->flow->wall[c][side][a] - b->u[1][3 * cell_of(b, i) + (size_t)a];
            return 1;
        case POSTPROC_BEYOND_COPY:
            return 0;
        }
    const double *plane = c == b->axis ? b->u[1 + s] : b->u[1];
    *u = plane[3 * cell_of(b, q) + (size_t)a];
    return 1;
}

/* d u_a / d x_c: central, one-sided at an open or a slip side. */
static double slope(const struct slab *b, const int i[3], int c, int a) {
    double low = b->u[1][3 * cell_of(b, i) + (size_t)a], high = low;
    const int wide = neighbour(b, i, c, -1, a, &low) + neighbour(b, i, c, 1, a, &high);
    return wide ? (high - low) / (wide * b->flow->d[c]) : 0;
}

static double curl_size(const struct slab *b, const int i[3]) {
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        const int e = (c + 1) % 3, f = (c + 2) % 3;
        const double w = slope(b, i, e, f) - slope(b, i, f, e);
        sum += w * w;
    }
    return sqrt(sum);
}

static double *plane_of(struct vtkhdf_source *source, const char *name, int axis, int index) {
    int lo[3] = {0, 0, 0}, m[3] = {source->n[0], source->n[1], source->n[2]};
    lo[axis] = index;
    m[axis] = 1;
    return vtkhdf_read_block(source, name, lo, m);
}

static void fill(struct postproc_slice *s, const struct slab *b, const double *pressure, const double *fraction) {
    const size_t all = (size_t)s->n[0] * (size_t)s->n[1];
    s->u = memory_new(MEMORY_OUTPUT, all, sizeof *s->u);
    s->speed = memory_new(MEMORY_OUTPUT, all, sizeof *s->speed);
    s->vorticity = memory_new(MEMORY_OUTPUT, all, sizeof *s->vorticity);
    s->solid = memory_new(MEMORY_OUTPUT, all, 1);
    if (pressure) s->pressure = memory_new(MEMORY_OUTPUT, all, sizeof *s->pressure);
    for (size_t at = 0; at < all; at++) { /* a plane that is read has the order of the slice */
        int i[3];
        i[s->axis] = s->index;
        i[s->across[0]] = (int)(at % (size_t)s->n[0]);
        i[s->across[1]] = (int)(at / (size_t)s->n[0]);
        const double *u = b->u[1] + 3 * at;
        for (int c = 0; c < 2; c++) s->u[at][c] = u[s->across[c]];
        s->solid[at] = fraction && !(fraction[at] < 0.5);
        s->speed[at] = s->solid[at] ? NAN : sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
        s->vorticity[at] = s->solid[at] ? NAN : curl_size(b, i);
        if (pressure) s->pressure[at] = s->solid[at] ? NAN : pressure[at];
    }
}

struct postproc_slice *postproc_slice_new(const struct postproc_history *h, int k, int axis, double place) {
    struct vtkhdf_source *source = postproc_history_open(h, &h->fluid, h->fluid.entry[k].time);
    if (!source) return NULL;
    if (!source->image || source->points == 0 || vtkhdf_read_comps(source, "velocity") != 3) {
        vtkhdf_read_close(source);
        return NULL;
    }
    const int n = source->n[axis];
    const double q = place / source->spacing[axis];
    struct postproc_slice *s = memory_new(MEMORY_OUTPUT, 1, sizeof *s);
    *s = (struct postproc_slice){.axis = axis, .time = source->time, .step = source->step};
    s->index = isnan(place) ? (n - 1) / 2 : (int)fmin(fmax(floor(q), 0), n - 1);
    s->place = (s->index + 0.5) * source->spacing[axis];
    struct postproc_flow flow = {0};
    postproc_flow_sides(&flow, h->scene);
    for (int c = 0, a = 0; c < 3; c++) {
        flow.n[c] = source->n[c];
        flow.d[c] = source->spacing[c];
        if (c == axis) continue;
        s->n[a] = source->n[c];
        s->d[a] = source->spacing[c];
        s->across[a++] = c;
    }
    for (int a = 0; a < 2; a++)
        for (int side = 0; side < 2; side++) {
            s->beyond[a][side] = flow.beyond[s->across[a]][side];
            for (int c = 0; c < 2; c++) s->wall[a][side][c] = flow.wall[s->across[a]][side][s->across[c]];
        }
    struct slab b = {.flow = &flow, .axis = axis};
    int whole = 1;
    for (int p = -1; p <= 1; p++) {
        int i = s->index + p;
        if (flow.beyond[axis][p > 0] == POSTPROC_BEYOND_WRAP) i = (i + n) % n;
        if (i < 0 || i >= n) continue;
        b.u[1 + p] = plane_of(source, "velocity", axis, i);
        whole = whole && b.u[1 + p];
    }
    double *pressure = plane_of(source, "pressure", axis, s->index);
    double *fraction = plane_of(source, "solid_fraction", axis, s->index);
    if (whole) fill(s, &b, pressure, fraction);
    for (int p = 0; p < 3; p++) free(b.u[p]);
    free(pressure);
    free(fraction);
    vtkhdf_read_close(source);
    if (whole) return s;
    postproc_slice_free(s);
    return NULL;
}

void postproc_slice_free(struct postproc_slice *s) {
    if (!s) return;
    MEMORY_FREE(s->u, s->speed, s->pressure, s->vorticity, s->solid, s);
}

double postproc_slice_quantile(const struct postproc_slice *s, const double *value, double q) {
    const size_t all = (size_t)s->n[0] * (size_t)s->n[1];
    double *sorted = memory_new(MEMORY_OUTPUT, all + 1, sizeof *sorted);
    size_t m = 0;
    for (size_t at = 0; at < all; at++)
        if (isfinite(value[at])) sorted[m++] = value[at];
    sort_ascending(sorted, m);
    const double found = m ? sorted[(size_t)(q * (double)(m - 1))] : NAN;
    memory_free(sorted);
    return found;
}

/* The row that stands for row i of direction c; *side: the wall that it is mirrored at, -1 for none. */
static int row_of(const struct postproc_slice *s, int c, int i, int *side) {
    const int n = s->n[c], high = i >= n;
    *side = -1;
    if (i >= 0 && i < n) return i;
    switch (s->beyond[c][high]) {
    case POSTPROC_BEYOND_WRAP:
        return high ? 0 : n - 1;
    case POSTPROC_BEYOND_MIRROR:
        *side = high;
        break;
    case POSTPROC_BEYOND_COPY:
        break;
    }
    return high ? n - 1 : 0;
}

/* Bilinear between the cells' centres; without a value outside the plane and in cells of solid. */
static int in_plane(const void *field, const double x[3], double u[3]) {
    const struct postproc_slice *s = field;
    int i[2][2], side[2][2], here[2];
    double part[2];
    for (int c = 0; c < 2; c++) {
        const double q = x[c] / s->d[c];
        if (!(q >= 0 && q <= s->n[c])) return 0;
        const double low = floor(q - 0.5);
        part[c] = q - 0.5 - low;
        here[c] = (int)fmin(floor(q), s->n[c] - 1);
        for (int k = 0; k < 2; k++) i[c][k] = row_of(s, c, (int)low + k, &side[c][k]);
    }
    if (s->solid[(size_t)here[1] * (size_t)s->n[0] + (size_t)here[0]]) return 0;
    u[0] = u[1] = u[2] = 0;
    for (int k = 0; k < 4; k++) {
        const int at[2] = {k & 1, k >> 1};
        const double weight = (at[0] ? part[0] : 1 - part[0]) * (at[1] ? part[1] : 1 - part[1]);
        const size_t cell = (size_t)i[1][at[1]] * (size_t)s->n[0] + (size_t)i[0][at[0]];
        for (int a = 0; a < 2; a++) {
            double value = s->u[cell][a];
            for (int c = 0; c < 2; c++)
                if (side[c][at[c]] >= 0) value = 2 * s->wall[c][side[c][at[c]]][a] - value;
            u[a] += weight * value;
        }
    }
    return 1;
}

/* Which squares a line has passed: a line ends where it enters one that another has passed. */
struct squares {
    int n[2], *owner; /* [n1][n0] 0: none */
    double side;
    int line, seed, last; /* the line that is being drawn, the square of its seed, and the one that it is in */
};

static int square_of(const struct squares *q, const double x[3]) {
    const int i = (int)fmin(fmax(x[0] / q->side, 0), q->n[0] - 1), j = (int)fmin(fmax(x[1] / q->side, 0), q->n[1] - 1);
    return j * q->n[0] + i;
}

static void at_seed(void *with) {
    struct squares *q = with;
    q->last = q->seed;
}

static int taken(void *with, const double x[3]) {
    struct squares *q = with;
    const int here = square_of(q, x);
    if (here == q->last) return 0;
    q->last = here;
    if (q->owner[here] != 0) return 1; /* also its own: a line round a vortex ends where it began */
    q->owner[here] = q->line;
    return 0;
}

struct postproc_stream postproc_slice_lines(const struct postproc_slice *s, int squares) {
    struct postproc_stream lines = {0};
    const double size[2] = {s->n[0] * s->d[0], s->n[1] * s->d[1]}, fastest = postproc_slice_quantile(s, s->speed, 1);
    struct squares q = {.side = fmax(size[0], size[1]) / squares};
    for (int c = 0; c < 2; c++) q.n[c] = (int)fmax(1, ceil(size[c] / q.side - 1e-9));
    q.owner = memory_new(MEMORY_OUTPUT, (size_t)q.n[0] * (size_t)q.n[1], sizeof *q.owner);
    const struct postproc_stream_input in = {.at = in_plane,
                                             .field = s,
                                             .step = 0.1 * fmin(fmin(s->d[0], s->d[1]), q.side),
                                             .slowest = 1e-3 * fastest,
                                             .longest = 3 * (size[0] + size[1]),
                                             .begin = at_seed,
                                             .enough = taken,
                                             .with = &q};
    for (int k = 0; fastest > 0 && k < q.n[0] * q.n[1]; k++) {
        if (q.owner[k] != 0) continue;
        const double seed[3] = {(k % q.n[0] + 0.5) * q.side, (k / q.n[0] + 0.5) * q.side, 0};
        q.line = lines.lines + 1;
        q.seed = k;
        q.owner[k] = q.line;
        const long points = postproc_stream_add(&lines, &in, seed, 1);
        if (points > 0 && (double)points * in.step < 2.5 * q.side) { /* too short to be seen: its squares stay free */
            postproc_stream_drop(&lines);
            for (int i = 0; i < q.n[0] * q.n[1]; i++)
                if (q.owner[i] == q.line) q.owner[i] = 0;
        }
        if (points == 0) q.owner[k] = 0;
    }
    memory_free(q.owner);
    return lines;
}
