/* Tells whether two runs began with the same domain, particles, held particles and bonds. */
#include "coupling/setup/beginning.h"
#include "base/memory.h"
#include "base/par.h"
#include "scene/scene.h"
#include "solid/bonds/family.h"
#include "solid/state.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>

/* Sums over particles of smooth functions of their places in spacings do not depend on ids, which differ between
 * numbers of ranks in a refined plate, and change by no more than rounding if places do. No lattice repeats in these
 * waves.
 * Rounding leaves some 1e-13 of the number of particles; one particle changes a sum by about 1. */
#define ROUNDING 1e-11

static double wave(const struct solid *s, int h, const double k[3]) {
    double phase = 0.3;
    for (int c = 0; c < s->dim; c++) phase += k[c] * s->x0[c][h] / s->in.spacing;
    return cos(phase);
}

/* Intact bonds of a particle, by their places in its family. */
static double bonds_of(const struct solid *s, int h, uint8_t *bits, int bytes) {
    double sum = 0;
    solid_family_save(s, h, bits);
    for (int k = 0; k < 8 * bytes; k++)
        if (bits[k / 8] >> k % 8 & 1) sum += 1 + 0.01 * k;
    return sum;
}

struct beginning beginning_of(const struct scene *scene, const struct solid *s) {
    static const double across[2][3] = {{0.7311, 1.1319, 0.5713}, {1.9073, 0.4137, 1.3171}};
    struct beginning b = {0};
    for (int c = 0; c < 3; c++)
        if (scene->fluid || (s && s->in.periodic[c])) b.size[c] = scene->domain.size[c];
    if (!s) return b;
    double sum[6] = {0};
    const int bytes = solid_family_bytes(s);
    uint8_t *bits = memory_new(MEMORY_OUTPUT, (size_t)bytes + 1, 1);
    for (int h = 0; h < s->n; h++) {
        const double w = wave(s, h, across[0]);
        sum[0] += w;
        sum[1] += wave(s, h, across[1]);
        sum[2] += w * (s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z));
        sum[3] += w * !!(s->flag[h] & SOLID_UNBREAKABLE);
        sum[4] += w * bonds_of(s, h, bits, bytes);
        sum[5] += 1;
    }
    memory_free(bits);
    par_sum_array(sum, 6);
    b.place[0] = sum[0], b.place[1] = sum[1];
    b.held = sum[2], b.unbreakable = sum[3], b.bonds = sum[4], b.particles = sum[5];
    return b;
}

void beginning_write(const struct beginning *a, char *text, size_t size) {
    snprintf(text, size,
             "size %.17g %.17g %.17g particles %.17g places %.17g %.17g held %.17g unbreakable %.17g bonds %.17g",
             a->size[0], a->size[1], a->size[2], a->particles, a->place[0], a->place[1], a->held, a->unbreakable,
             a->bonds);
}

static int is_other(double a, double b, double scale) { return !(fabs(a - b) <= ROUNDING * scale); }

int beginning_differs(const struct beginning *now, const char *text, char *why, size_t size) {
    struct beginning was;
    const double n = now->particles;
    if (sscanf(text, "size %lf %lf %lf particles %lf places %lf %lf held %lf unbreakable %lf bonds %lf", &was.size[0],
               &was.size[1], &was.size[2], &was.particles, &was.place[0], &was.place[1], &was.held, &was.unbreakable,
               &was.bonds) != 9)
        return 0; /* of a later frana */
    for (int c = 0; c < 3; c++)
        if (was.size[c] * now->size[c] > 0 && is_other(was.size[c], now->size[c], now->size[c])) {
            snprintf(why, size, "has a domain of %g m along %c, the scene of %g m", was.size[c], "xyz"[c],
                     now -> size[c]);
            return 1;
        }
    if (is_other(was.particles, n, 1) || is_other(was.place[0], now->place[0], n) ||
        is_other(was.place[1], now->place[1], n))
        snprintf(why, size,
                 "has particles elsewhere than the scene: solid.bodies must be those of the run that wrote it");
    else if (is_other(was.held, now->held, 8 * n))
        snprintf(why, size,
                 "holds other particles than the scene: the regions and directions of solid.constraints must be those "
                 "of the run that wrote it; velocity, displacement and time may change");
    else if (is_other(was.unbreakable, now->unbreakable, n))
        snprintf(why, size,
                 "has other unbreakable particles than the scene: solid.unbreakable must be that of the run "
                 "that wrote it");
    else if (is_other(was.bonds, now->bonds, 1000 * n))
        snprintf(why, size,
                 "began with other bonds than the scene: horizons, solid.cracks, contacts and interfaces "
                 "must be those of the run that wrote it");
    else
        return 0;
    return 1;
}
