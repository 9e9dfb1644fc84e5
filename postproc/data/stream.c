/* Integrates streamlines. */
#include "postproc/data/stream.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

enum { POINTS_MAX = 200000 };

/* The direction of the flow, of length 1 and the sign `sign`; returns the speed, or -1 where a line ends. */
static double direction(const struct postproc_stream_input *in, const double x[3], int sign, double e[3]) {
    double u[3];
    if (!in->at(in->field, x, u)) return -1;
    const double size = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    if (!(size > in->slowest)) return -1;
    for (int c = 0; c < 3; c++) e[c] = sign * u[c] / size;
    return size;
}

/* One step of fourth order. Returns 0 where a stage meets no flow. */
static int advance(const struct postproc_stream_input *in, int sign, double x[3]) {
    double e[4][3], y[3] = {x[0], x[1], x[2]};
    static const double part[4] = {0.5, 0.5, 1, 0};
    for (int stage = 0; stage < 4; stage++) {
        if (direction(in, y, sign, e[stage]) < 0) return 0;
        for (int c = 0; c < 3; c++) y[c] = x[c] + part[stage] * in->step * e[stage][c];
    }
    for (int c = 0; c < 3; c++) x[c] += in->step / 6 * (e[0][c] + 2 * e[1][c] + 2 * e[2][c] + e[3][c]);
    return 1;
}

static void put(struct postproc_stream *s, long at, const double x[3], double speed) {
    if (at >= s->capacity) {
        const long capacity = 2 * s->capacity + 1024;
        s->x = memory_grown(MEMORY_OUTPUT, s->x, (size_t)s->capacity, (size_t)capacity, sizeof *s->x);
        s->speed = memory_grown(MEMORY_OUTPUT, s->speed, (size_t)s->capacity, (size_t)capacity, sizeof *s->speed);
        s->capacity = capacity;
    }
    memcpy(s->x[at], x, sizeof s->x[at]);
    s->speed[at] = speed;
}

/* Points from the seed on, without it, from index `at` on; returns the index after the last. */
static long follow(struct postproc_stream *s, const struct postproc_stream_input *in, const double seed[3], int sign,
                   long at) {
    double x[3] = {seed[0], seed[1], seed[2]}, e[3];
    if (in->begin) in->begin(in->with);
    const double steps = fmin(in->longest / in->step, POINTS_MAX);
    for (long k = 0; (double)k < steps && advance(in, sign, x); k++) {
        const double speed = direction(in, x, sign, e);
        if (speed < 0) break;
        put(s, at++, x, speed);
        if (in->enough && in->enough(in->with, x)) break;
    }
    return at;
}

static void reverse(struct postproc_stream *s, long from, long to) {
    for (to--; from < to; from++, to--) {
        double x[3];
        const double speed = s->speed[from];
        memcpy(x, s->x[from], sizeof x);
        memcpy(s->x[from], s->x[to], sizeof x);
        memcpy(s->x[to], x, sizeof x);
        s->speed[from] = s->speed[to];
        s->speed[to] = speed;
    }
}

long postproc_stream_add(struct postproc_stream *s, const struct postproc_stream_input *in, const double seed[3],
                         int both) {
    double e[3];
    const double speed = direction(in, seed, 1, e);
    if (speed < 0) return 0;
    if (s->lines + 2 > s->lines_capacity) {
        const int capacity = 2 * s->lines_capacity + 64;
        s->first = memory_grown(MEMORY_OUTPUT, s->first, (size_t)s->lines_capacity, (size_t)capacity, sizeof *s->first);
        s->lines_capacity = capacity;
    }
    const long begin = s->first[s->lines];
    long at = begin;
    if (both) at = follow(s, in, seed, -1, at);
    reverse(s, begin, at);
    put(s, at++, seed, speed);
    at = follow(s, in, seed, 1, at);
    s->first[++s->lines] = at;
    return at - begin;
}

/* The share of the way from a to b that lies between low and high. */
static double part_between(double a, double b, double low, double high) {
    const double first = fmin(a, b), last = fmax(a, b);
    if (last <= low || first >= high) return 0;
    return last > first ? (fmin(last, high) - fmax(first, low)) / (last - first) : 1;
}

double postproc_stream_tortuosity(const struct postproc_stream *s, int axis, double low, double high) {
    double weights = 0, sum = 0;
    for (int line = 0; line < s->lines; line++) {
        const long end = s->first[line + 1];
        double length = 0, time = 0, least = INFINITY, most = -INFINITY;
        for (long i = s->first[line]; i < end; i++) {
            least = fmin(least, s->x[i][axis]);
            most = fmax(most, s->x[i][axis]);
            if (i + 1 == end) break;
            double sign = 0;
            for (int c = 0; c < 3; c++) sign += pow(s->x[i + 1][c] - s->x[i][c], 2);
            sign = sqrt(sign) * part_between(s->x[i][axis], s->x[i + 1][axis], low, high);
            length += sign;
            time += 2 * sign / (s->speed[i] + s->speed[i + 1]);
        }
        if (least > low || most < high) continue;
        weights += 1 / time;
        sum += length / time;
    }
    return weights > 0 ? sum / weights / (high - low) : NAN;
}

void postproc_stream_drop(struct postproc_stream *s) {
    if (s->lines > 0) s->lines--;
}

void postproc_stream_free(struct postproc_stream *s) {
    MEMORY_FREE(s->first, s->x, s->speed);
    *s = (struct postproc_stream){0};
}
