/* Follows a crack's tips in time: speed over a window and length of all branches.  (000: eq. 41) */
#include "solid/measure/crack_track.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

/* Length of a chord in particles: longer than a tip's jumps from row to row, shorter than the bends of a crack. */
static const double CHORD = 5;
/* Tolerance in comparisons: distances in a lattice are often equal, and the last digit, which a table does not store,
 * must not decide. */
static const double TIE = 1e-9;
enum { SIDES = SOLID_CRACK_SIDES };

struct sample {
    double t, side[SIDES][2];
};

struct solid_crack_track {
    double window, chord;
    long samples, sample_capacity, knots, knot_capacity;
    struct sample *sample; /* samples of the last window, the oldest first */
    double (*knot)[2];     /* [knots] m */
    double length;         /* total length of the chords between knots, m */
};

struct solid_crack_track *solid_crack_track_new(double window, double spacing) {
    struct solid_crack_track *k = memory_new(MEMORY_OUTPUT, 1, sizeof *k);
    k->window = window;
    k->chord = CHORD * spacing * (1 - TIE);
    return k;
}

void solid_crack_track_free(struct solid_crack_track *k) {
    if (!k) return;
    MEMORY_FREE(k->sample, k->knot, k);
}

static double distance_between(const double a[2], const double b[2]) { return hypot(a[0] - b[0], a[1] - b[1]); }

/* Index and distance of the nearest knot, -1: none. */
static long nearest(const struct solid_crack_track *k, const double x[2], double *distance) {
    long best = -1;
    *distance = INFINITY;
    for (long i = 0; i < k->knots; i++) {
        const double d = distance_between(k->knot[i], x);
        if (best < 0 || d < *distance - TIE * k->chord) *distance = d, best = i;
    }
    return best;
}

/* The present ends of the crack: of both sides, or one in the middle if these are nearer than a chord. */
static int fronts_of(const struct solid_crack_track *k, const double side[SIDES][2], double front[SIDES][2]) {
    int n = 0;
    if (distance_between(side[0], side[1]) < k->chord) {
        for (int c = 0; c < 2; c++) front[0][c] = 0.5 * (side[0][c] + side[1][c]);
        return 1;
    }
    for (int i = 0; i < SIDES; i++)
        if (!isnan(side[i][0])) memcpy(front[n++], side[i], sizeof *front);
    return n;
}

/* Adds chords up to the fronts; each front of the first sample begins a crack. Returns the length, with the parts
 * beyond the last knots. */
static double lengthen(struct solid_crack_track *k, const double side[SIDES][2]) {
    const int begins = k->knots == 0;
    double front[SIDES][2], rest[SIDES] = {0, 0};
    long knot[SIDES] = {-1, -1};
    const int n = fronts_of(k, side, front);
    for (int i = 0; i < n; i++) {
        nearest(k, front[i], &rest[i]);
        if (rest[i] < k->chord) continue;
        if (!begins) k->length += rest[i];
        MEMORY_MORE(MEMORY_OUTPUT, k->knot, k->knots, k->knot_capacity);
        memcpy(k->knot[k->knots++], front[i], sizeof *k->knot);
    }
    for (int i = 0; i < n; i++) knot[i] = nearest(k, front[i], &rest[i]);
    return k->length + (knot[0] == knot[1] ? fmax(rest[0], rest[1]) : rest[0] + rest[1]);
}

/* Removes samples older than the newest one that is at least a window old. Returns that one, or else the first. */
static const struct sample *window_ago(struct solid_crack_track *k, double t) {
    long first = 0;
    if (k->samples == 0) return NULL;
    while (first + 1 < k->samples && k->sample[first + 1].t <= t - k->window * (1 - TIE)) first++;
    k->samples -= first;
    memmove(k->sample, k->sample + first, (size_t)k->samples * sizeof *k->sample);
    return k->sample;
}

struct solid_crack_motion solid_crack_track_add(struct solid_crack_track *k, double t,
                                                const struct solid_crack_tips *tips, const double direction[2]) {
    struct solid_crack_motion m = {NAN, {NAN, NAN}, k->length};
    if (!tips->found) return m;
    const struct sample *old = window_ago(k, t);
    double far[SIDES];
    for (int i = 0; i < SIDES; i++) {
        const double *x = tips->side[i];
        far[i] = direction[0] * x[0] + direction[1] * x[1];
        if (old) m.side[i] = fmin(distance_between(x, old->side[0]), distance_between(x, old->side[1])) / (t - old->t);
    }
    const double tip = direction[0] * tips->tip[0] + direction[1] * tips->tip[1];
    for (int i = 0; i < SIDES; i++)
        if (far[i] >= tip - 1e-3 * k->chord) m.speed = fmax(m.speed, m.side[i]);
    m.length = lengthen(k, tips->side);
    MEMORY_MORE(MEMORY_OUTPUT, k->sample, k->samples, k->sample_capacity);
    struct sample *now = &k->sample[k->samples++];
    now->t = t;
    memcpy(now->side, tips->side, sizeof now->side);
    return m;
}
