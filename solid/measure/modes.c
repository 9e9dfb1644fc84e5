/* Azimuthal modes of a field on the particles, in rings about an axis. */
#include "solid/measure/modes.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"

#include <math.h>

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

void solid_modes_across(const double axis[3], double across[2][3]) {
    const double length = sqrt(dot(axis, axis));
    double unit[3];
    int most = 2;
    for (int c = 0; c < 3; c++) {
        unit[c] = axis[c] / length;
        if (fabs(axis[c]) > fabs(axis[most])) most = c;
    }
    double *first = across[0], *second = across[1];
    for (int c = 0; c < 3; c++) first[c] = (c == (most + 1) % 3) - unit[(most + 1) % 3] * unit[c];
    const double size = sqrt(dot(first, first));
    for (int c = 0; c < 3; c++) first[c] /= size;
    for (int c = 0; c < 3; c++)
        second[c] = unit[(c + 1) % 3] * first[(c + 2) % 3] - unit[(c + 2) % 3] * first[(c + 1) % 3];
}

/* The ring that a particle stands in, -1: none; the cosine and sine of its angle. */
static int ring_of(const struct solid *s, const struct solid_rings *in, int h, double turn[2]) {
    double p[3] = {0};
    for (int c = 0; c < s->dim; c++) p[c] = s->x0[c][h] - in->centre[c];
    const double x = dot(p, in->across[0]), y = dot(p, in->across[1]), r = hypot(x, y);
    turn[0] = r > 0 ? x / r : 1;
    turn[1] = r > 0 ? y / r : 0;
    if (!(r >= in->radius[0])) return -1;
    for (int q = 0; q < in->rings; q++)
        if (r < in->radius[q + 1]) return q;
    return -1;
}

/* Adds a particle's part of the sums of cos(k theta) and sin(k theta), k from 1. */
static void add(double *sum, int highest, const double turn[2], double value) {
    double c = turn[0], s = turn[1];
    for (int k = 1; k <= highest; k++) {
        sum[2 * k] += value * c;
        sum[2 * k + 1] += value * s;
        const double next = c * turn[0] - s * turn[1];
        s = s * turn[0] + c * turn[1];
        c = next;
    }
}

void solid_modes_measure(const struct solid *s, const struct solid_rings *in, const double *field, long *particles,
                         struct solid_mode *mode) {
    enum { VOLUME, FIELD, COUNT, SUMS };
    const int width = in->highest + 1;
    double *sum = memory_new(MEMORY_OUTPUT, (size_t)(in->rings * SUMS), sizeof *sum);
    double *wave = memory_new(MEMORY_OUTPUT, (size_t)(in->rings * 2 * width), sizeof *wave), turn[2];
    ENSURE(in->highest <= SOLID_MODES_MAX, "%d modes", in->highest);
    for (int h = 0; h < s->n; h++) {
        const int q = ring_of(s, in, h, turn);
        if (q < 0) continue;
        sum[q * SUMS + VOLUME] += s->volume[h];
        sum[q * SUMS + FIELD] += field[h] * s->volume[h];
        sum[q * SUMS + COUNT] += 1;
    }
    par_sum_array(sum, in->rings * SUMS);
    for (int h = 0; h < s->n; h++) {
        const int q = ring_of(s, in, h, turn);
        if (q < 0) continue;
        const double mean = sum[q * SUMS + FIELD] / sum[q * SUMS + VOLUME];
        add(wave + (long)q * 2 * width, in->highest, turn, (field[h] - mean) * s->volume[h]);
    }
    par_sum_array(wave, in->rings * 2 * width);
    for (int q = 0; q < in->rings; q++) {
        const double volume = sum[q * SUMS + VOLUME];
        particles[q] = lrint(sum[q * SUMS + COUNT]);
        mode[q * width] = (struct solid_mode){sum[q * SUMS + FIELD] / volume, 0};
        for (int k = 1; k <= in->highest; k++) {
            const double *w = wave + (long)q * 2 * width + 2 * k;
            mode[q * width + k] =
                (struct solid_mode){2 * hypot(w[0], w[1]) / volume, atan2(w[1], w[0]) / k * (180 / M_PI)};
        }
    }
    MEMORY_FREE(sum, wave);
}
