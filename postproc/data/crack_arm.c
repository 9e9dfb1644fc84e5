/* The line of a crack's arm, and the path of its tip. */
#include "postproc/data/crack_arm.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* In spacings: grain of a tip's place, at both ends of a path; chord of an arm's length. */
static const double GRAIN = 2, CHORD = 5;
/* By how much a path over neighbours of a square lattice may be longer than the straight line: 1/cos(22.5 degrees). */
static const double OCTAGON = 1.0824;
/* Least number of places in a window, and least share of it that they span. */
enum { PLACES = 3 };
static const double SPAN = 0.5;

static double distance(const double a[2], const double b[2]) { return hypot(a[0] - b[0], a[1] - b[1]); }

static int by_distance(const void *a, const void *b) {
    const struct postproc_crack_member *p = a, *q = b;
    if (p->d != q->d) return p->d < q->d ? -1 : 1;
    const int k = p->x[0] == q->x[0];
    return (p->x[k] > q->x[k]) - (p->x[k] < q->x[k]);
}
static int by_time(const void *a, const void *b) {
    const struct postproc_crack_member *p = a, *q = b;
    if (p->t != q->t) return p->t < q->t ? -1 : 1;
    return by_distance(a, b);
}

/* The direction of the line nearest to particles, from the first to the last.  (total least squares) */
static struct postproc_angle direction_of(const struct postproc_crack_member *m, long n) {
    double c[2] = {0, 0}, xx = 0, xy = 0, yy = 0;
    if (n < 4) return (struct postproc_angle){NAN, NAN};
    for (long i = 0; i < n; i++)
        for (int k = 0; k < 2; k++) c[k] += m[i].x[k] / (double)n;
    for (long i = 0; i < n; i++) {
        const double x = m[i].x[0] - c[0], y = m[i].x[1] - c[1];
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    double angle = 0.5 * atan2(2 * xy, xx - yy), ahead = 0;
    for (long i = 0; i < n; i++)
        ahead += (m[i].d - m[0].d - 0.5 * (m[n - 1].d - m[0].d)) *
                 (cos(angle) * (m[i].x[0] - c[0]) + sin(angle) * (m[i].x[1] - c[1]));
    if (ahead < 0) angle += angle > 0 ? -M_PI : M_PI;
    const double along = xx * cos(angle) * cos(angle) + 2 * xy * cos(angle) * sin(angle) + yy * sin(angle) * sin(angle);
    const double across = fmax(xx + yy - along, 0);
    return (struct postproc_angle){angle * 180 / M_PI, 2 * sqrt(across / along / (double)(n - 2)) * 180 / M_PI};
}

static void mean_of(const struct postproc_crack_member *m, long n, double x[2]) {
    x[0] = x[1] = 0;
    for (long i = 0; i < n; i++)
        for (int k = 0; k < 2; k++) x[k] += m[i].x[k] / (double)n;
}

void postproc_crack_arm_line(struct postproc_arm *a, struct postproc_crack_member *m, long n,
                             const struct postproc_arms_input *in) {
    qsort(m, (size_t)n, sizeof *m, by_distance);
    long first = 0, last = n, near = 0, far = n;
    const double spacing = in->spacing;
    while (first < n && m[first].d <= m[0].d + in->fit * (1 + 1e-9)) first++;
    while (last > 0 && m[last - 1].d >= m[n - 1].d - in->fit * (1 + 1e-9)) last--;
    while (near < n && m[near].d <= m[0].d + 0.5 * spacing) near++;
    while (far > 0 && m[far - 1].d >= m[n - 1].d - 0.5 * spacing) far--;
    a->first = direction_of(m, first);
    mean_of(m, first, a->middle);
    a->last = direction_of(m + last, n - last);
    mean_of(m, near, a->begin);
    mean_of(m + far, n - far, a->end);
    double at[2] = {a->begin[0], a->begin[1]};
    for (long i = 0, from = 0; i < n; i++) {
        if (m[i].d < m[from].d + CHORD * spacing || m[n - 1].d - m[i].d < 0.5 * CHORD * spacing) continue;
        long until = i;
        while (until < n && m[until].d < m[i].d + spacing) until++;
        double x[2];
        mean_of(m + i, until - i, x);
        a->length += distance(at, x);
        memcpy(at, x, sizeof at);
        from = i;
    }
    a->length += distance(at, a->end);
}

/* The speed of the straight motion nearest to a tip's places.  (least squares) */
static double speed_of(const struct postproc_place *p, long n) {
    double t = 0, x[2] = {0, 0}, tt = 0, tx[2] = {0, 0};
    for (long i = 0; i < n; i++) {
        t += p[i].t / (double)n;
        for (int c = 0; c < 2; c++) x[c] += p[i].x[c] / (double)n;
    }
    for (long i = 0; i < n; i++) {
        tt += (p[i].t - t) * (p[i].t - t);
        for (int c = 0; c < 2; c++) tx[c] += (p[i].t - t) * (p[i].x[c] - x[c]);
    }
    return hypot(tx[0], tx[1]) / tt;
}

void postproc_crack_arm_tip(struct postproc_arm *a, struct postproc_crack_member *m, long n,
                            const struct postproc_arms_input *in, struct postproc_place *p) {
    const double h = in->spacing;
    const double whole = m[n - 1].d - m[0].d;
    double far = -INFINITY, before = 0, advance = 0, time = 0;
    qsort(m, (size_t)n, sizeof *m, by_time);
    for (long i = 0, until; i < n && !isnan(m[i].t); i = until) {
        for (until = i; until < n && m[until].t == m[i].t;) until++;
        if (m[until - 1].d <= far + 0.5 * h) continue; /* no farther by half a spacing */
        long from = until;
        while (from > i && m[from - 1].d >= m[until - 1].d - 0.75 * h) from--;
        struct postproc_place *now = &p[a->places];
        *now = (struct postproc_place){m[i].t, {0, 0}, NAN, 0};
        mean_of(m + from, until - from, now->x);
        before = far;
        far = m[until - 1].d;
        if (a->places++ == 0) continue;
        now->jumped = (far - before) / OCTAGON - GRAIN * h > in->rayleigh * (now->t - now[-1].t);
        a->jumps += now->jumped;
        if (now->jumped) continue;
        advance += far - before;
        time += now->t - now[-1].t;
    }
    if (a->places == 0) return;
    if (time > 0 && whole > 0) a->speed = a->length * advance / whole / time;
    a->t_begin = p[0].t;
    a->t_end = p[a->places - 1].t;
    for (long k = 0, from = 0; k < a->places; k++) {
        if (p[k].jumped) from = k;
        while (p[k].t - p[from].t > in->window * (1 + 1e-9)) from++;
        if (k - from + 1 < PLACES || p[k].t - p[from].t < SPAN * in->window) continue;
        p[k].speed = speed_of(p + from, k - from + 1);
        a->windows++;
        a->above += p[k].speed > in->rayleigh;
        if (!(p[k].speed <= a->top)) a->top = p[k].speed, a->top_t = 0.5 * (p[k].t + p[from].t);
    }
}
