/* Constants of bonds between several materials of a lattice body, and the segments that hold such bonds. */
#include "solid/bonds/kinds.h"
#include "base/memory.h"
#include "solid/bonds/segments.h"

#include <math.h>
#include <string.h>

/* The kernels' eps may differ from the one that decides in its last digits, so bonds are looked at a little earlier. */
static const double EARLIER = 1 - 1e-9;

static double stretch2_of(double eps) {
    const double s = eps / (1 + sqrt(1 + eps));
    return s * s;
}

/* The same in either order. */
static struct solid_law law_between(const struct solid_law *a, const struct solid_law *b) {
    struct solid_law law = *a;
    if (a->c0 < b->c0 || (a->c0 == b->c0 && a->eps_limit < b->eps_limit)) {
        const struct solid_law *t = a;
        a = b;
        b = t;
    }
    law.c0 = 0.5 * (a->c0 + b->c0);
    law.fracture_energy = 0.5 * (a->fracture_energy + b->fracture_energy);
    if (a->eps_limit == b->eps_limit) return law;
    const double s0 = sqrt((a->c0 * stretch2_of(a->eps_limit) + b->c0 * stretch2_of(b->eps_limit)) / (a->c0 + b->c0));
    law.eps_limit = isinf(a->eps_limit) || isinf(b->eps_limit) ? INFINITY : s0 * (2 + s0);
    return law;
}

static void laws_new(struct solid_kinds *kinds, const struct solid_law *law, const int *kind) {
    kinds->least = INFINITY;
    kinds->is_even = 1;
    for (int a = 0; a < kinds->n; a++) {
        for (int b = 0; b < kinds->n; b++) kinds->pair[a][b] = a == b ? law[a] : law_between(&law[a], &law[b]);
        kinds->stiffer[a] = law[a].c0 / law[0].c0;
        kinds->lighter[a] = law[0].density / law[a].density;
        kinds->is_even &= law[a].density == law[0].density;
        kinds->least = fmin(kinds->least, law[a].eps_limit);
        kinds->of_material[kind[a]] = (uint8_t)a;
    }
}

/* Their offsets within a page go on behind those of the other arrays (solid/bonds/lattice.c). */
static void fields_new(struct solid_kinds *kinds, const struct solid_lattice *lattice) {
    enum { LINE = 8, PAGE = 64 * LINE, PLACE = 5 * LINE, BEFORE = 10 * PLACE };
    size_t step = (size_t)lattice->places + 2 * SOLID_ROW;
    step += (PAGE + PLACE - step % PAGE) % PAGE;
    kinds->memory = solid_store_array(BEFORE + 2 * step, sizeof *kinds->memory);
    kinds->half = kinds->memory + BEFORE;
    kinds->look = kinds->half + step;
    for (int i = 0; i < lattice->copies; i++) {
        const int k = solid_kinds_of(kinds, lattice->copy_local[i]);
        kinds->half[lattice->copy_at[i]] = 0.5 * kinds->stiffer[k];
        kinds->look[lattice->copy_at[i]] = kinds->pair[k][k].eps_limit * EARLIER;
    }
}

/* The kind of all particles of a segment and of their families, or SOLID_KINDS_SEVERAL. */
static uint8_t kind_of_segment(const struct solid_kinds *kinds, const struct solid_lattice *lattice, int g) {
    const struct solid_segments *segments = lattice->segments;
    int kind = -1;
    for (int k = 0; k < SOLID_ROW; k++) {
        const long cell = segments->cell[g] + k;
        if (!(segments->owned[g] >> k & 1)) continue;
        for (int o = -1; o < lattice->stencil->n; o++) {
            const int l = lattice->local[o < 0 ? cell : cell + lattice->offset[o].shift];
            if (l < 0) continue;
            if (kind < 0) kind = solid_kinds_of(kinds, l);
            if (kind != solid_kinds_of(kinds, l)) return SOLID_KINDS_SEVERAL;
        }
    }
    return (uint8_t)kind;
}

struct solid_kinds *solid_kinds_new(const struct solid_lattice *lattice, const struct solid_law *law, int n,
                                    const int *kind, const uint8_t *material) {
    struct solid_kinds *kinds = memory_new(MEMORY_SOLID, 1, sizeof *kinds);
    kinds->n = n;
    kinds->material = material;
    laws_new(kinds, law, kind);
    fields_new(kinds, lattice);
    kinds->segment = solid_store_array((size_t)lattice->segments->n, 1);
    for (int g = 0; g < lattice->segments->n; g++) kinds->segment[g] = kind_of_segment(kinds, lattice, g);
    kinds->table = solid_store_array(2 * (size_t)n * (size_t)lattice->stencil->n, sizeof *kinds->table);
    return kinds;
}

void solid_kinds_free(struct solid_kinds *kinds) {
    if (!kinds) return;
    memory_free(kinds->memory);
    memory_free(kinds->segment);
    memory_free(kinds->table);
    memory_free(kinds);
}
