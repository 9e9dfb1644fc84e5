/* Times the interface update on the main case's block: intact, moving, broken, breaking. */
/* Milliseconds a step of the surface's update on the main case's block: intact, at rest or moving; with bonds broken,
 * and while a few break in every step; and of a detection from scratch.  [mpiexec -n N] bench_surface Best and median
 * of the repeats, the slowest rank's. */
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/solid.h"
#include "solid/surface/surface.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { REPEATS = 25 };
static const double SPACING = 1.5625e-3;

static struct solid *block(void) {
    const struct solid_body body = {.name = "block",
                                    .shape = SOLID_BOX,
                                    .low = {16 * SPACING, -3 * SPACING, 0},
                                    .high = {64 * SPACING, 67 * SPACING, 64 * SPACING},
                                    .cavity_period = 16 * SPACING,
                                    .cavity_radius = 9.168 * SPACING,
                                    .cavity_centre = {16.15 * SPACING, 0, 0}};
    const struct solid_material material = {1e8, 3000, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
    const struct solid_input in = {.spacing = SPACING,
                                   .bodies = 1,
                                   .body = &body,
                                   .materials = 1,
                                   .material = &material,
                                   .surface_correction = 1,
                                   .periodic = {0, 0, 1},
                                   .length = {128 * SPACING, 64 * SPACING, 64 * SPACING}};
    return solid_new(&in);
}

/* A number in [0, 1), the same for both ends of a bond. */
static double chance(const double x[3], const double y[3], int round) {
    uint64_t sum = (uint64_t)round * 0x9E3779B97F4A7C15u;
    for (int c = 0; c < 3; c++) {
        const uint64_t i = (uint64_t)llround(x[c] / SPACING * 2 + 1000),
                       j = (uint64_t)llround(y[c] / SPACING * 2 + 1000);
        sum = (sum ^ ((i + j) << 20 | i * j)) * 0xBF58476D1CE4E5B9u;
        sum ^= sum >> 29;
    }
    return (double)(sum >> 11) / 9007199254740992.0;
}

/* Breaks about that part of the bonds, from both ends. */
static void crush(struct solid *s, double part, int round) {
    struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            double x[3], y[3];
            for (int c = 0; c < 3; c++) {
                x[c] = s->x0[c][h];
                y[c] = s->x0[c][h] + view.xi[b][c];
                if (s->in.periodic[c]) y[c] -= s->in.length[c] * floor(y[c] / s->in.length[c]);
            }
            if (view.intact[b] && chance(x, y, round) < part) solid_family_break(s, h, b);
        }
    }
}

static void shake(struct solid *s, double by, int k) {
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < s->n; h++) s->d[c][h] = by * SPACING * sin(300 * s->x0[(c + 1) % 3][h] + c + k);
}

static int rising(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* by: amplitude of the motion, in spacings; breaking: part of the bonds lost in every step. */
static void measure(const char *name, struct solid *s, struct solid_surface *f, double by, double breaking) {
    double seconds[REPEATS];
    solid_surface_update(s, f);
    for (int k = 0; k < REPEATS; k++) {
        shake(s, by, k % 2);
        if (breaking > 0) crush(s, breaking, 100 + k);
        par_barrier();
        const double start = par_seconds();
        solid_surface_update(s, f);
        seconds[k] = par_max(par_seconds() - start);
    }
    qsort(seconds, REPEATS, sizeof *seconds, rising);
    solid_family_count(s);
    if (par_rank() == 0)
        printf("%-34s %8.3f %8.3f ms, %6ld of interface, %5.2f %% broken\n", name, 1e3 * seconds[0],
               1e3 * seconds[REPEATS / 2], f->total, 100. * (double)s->bonds_broken / (double)s->bonds_total);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    struct solid *s = block();
    const double start = par_seconds();
    struct solid_surface *f = solid_surface_new(s);
    const double scratch = par_max(par_seconds() - start);
    if (par_rank() == 0)
        printf("%ld particles, %d ranks\n%-34s %8.3f ms\n", s->n_global, par_size(), "from scratch", 1e3 * scratch);
    const double part[] = {0.001, 0.05, 0.25};
    measure("intact, at rest", s, f, 0, 0);
    measure("intact, moving", s, f, 1e-3, 0);
    measure("intact, turning", s, f, 0.05, 0);
    for (int k = 0; k < 3; k++) {
        crush(s, part[k], k);
        measure("broken, moving", s, f, 1e-3, 0);
        if (k < 2) measure("broken, 1e-5 more a step", s, f, 1e-3, 1e-5);
    }
    solid_surface_free(f);
    solid_free(s);
    par_end();
    return 0;
}
