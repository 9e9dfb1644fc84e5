/* Constants of bonds between several materials of a lattice body, and the segments that hold such bonds. */
#include "solid/bonds/materials.h"
#include "base/memory.h"
#include "solid/bonds/segments.h"

#include <math.h>
#include <string.h>

/* The kernels' eps may differ in the last digits from the one that decides whether a bond breaks, so bonds are tested
 * from a slightly smaller eps on. */
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
    law.bonds_energy = 0.5 * (a->bonds_energy + b->bonds_energy);
    if (a->eps_limit == b->eps_limit) return law;
    const double s0 = sqrt((a->c0 * stretch2_of(a->eps_limit) + b->c0 * stretch2_of(b->eps_limit)) / (a->c0 + b->c0));
    law.eps_limit = isinf(a->eps_limit) || isinf(b->eps_limit) ? INFINITY : s0 * (2 + s0);
    return law;
}

static void laws_new(struct solid_materials *materials, const struct solid_law *law, const int *kind) {
    materials->least = INFINITY;
    materials->is_even = 1;
    for (int a = 0; a < materials->n; a++) {
        for (int b = 0; b < materials->n; b++) materials->pair[a][b] = a == b ? law[a] : law_between(&law[a], &law[b]);
        materials->stiffer[a] = law[a].c0 / law[0].c0;
        materials->lighter[a] = law[0].density / law[a].density;
        materials->is_even &= law[a].density == law[0].density;
        materials->least = fmin(materials->least, law[a].eps_limit);
        materials->of_material[kind[a]] = (uint8_t)a;
    }
}

/* Their offsets within a page go on behind those of the other arrays (solid/bonds/lattice.c). */
static void fields_new(struct solid_materials *materials, const struct solid_lattice *lattice) {
    enum { LINE = 8, PAGE = 64 * LINE, PLACE = 5 * LINE, BEFORE = 10 * PLACE };
    size_t step = (size_t)lattice->places + 2 * SOLID_ROW;
    step += (PAGE + PLACE - step % PAGE) % PAGE;
    materials->memory = solid_store_array(BEFORE + 2 * step, sizeof *materials->memory);
    materials->half = materials->memory + BEFORE;
    materials->threshold = materials->half + step;
    for (int i = 0; i < lattice->copies; i++) {
        const int k = solid_materials_of(materials, lattice->copy_local[i]);
        materials->half[lattice->copy_at[i]] = 0.5 * materials->stiffer[k];
        materials->threshold[lattice->copy_at[i]] = materials->pair[k][k].eps_limit * EARLIER;
    }
}

/* The material of all particles of a segment and of their families, or SOLID_MATERIALS_SEVERAL. */
static uint8_t kind_of_segment(const struct solid_materials *materials, const struct solid_lattice *lattice, int g) {
    const struct solid_segments *segments = lattice->segments;
    int kind = -1;
    for (int k = 0; k < SOLID_ROW; k++) {
        const long cell = segments->cell[g] + k;
        if (!(segments->owned[g] >> k & 1)) continue;
        for (int o = -1; o < lattice->stencil->n; o++) {
            const int l = lattice->local[o < 0 ? cell : cell + lattice->offset[o].shift];
            if (l < 0) continue;
            if (kind < 0) kind = solid_materials_of(materials, l);
            if (kind != solid_materials_of(materials, l)) return SOLID_MATERIALS_SEVERAL;
        }
    }
    return (uint8_t)kind;
}

struct solid_materials *solid_materials_new(const struct solid_lattice *lattice, const struct solid_law *law, int n,
                                            const int *kind, const uint8_t *material) {
    struct solid_materials *materials = memory_new(MEMORY_SOLID, 1, sizeof *materials);
    materials->n = n;
    materials->material = material;
    laws_new(materials, law, kind);
    fields_new(materials, lattice);
    materials->segment = solid_store_array((size_t)lattice->segments->n, 1);
    for (int g = 0; g < lattice->segments->n; g++) materials->segment[g] = kind_of_segment(materials, lattice, g);
    materials->table = solid_store_array(2 * (size_t)n * (size_t)lattice->stencil->n, sizeof *materials->table);
    return materials;
}

void solid_materials_free(struct solid_materials *materials) {
    if (!materials) return;
    MEMORY_FREE(materials->memory, materials->segment, materials->table, materials);
}
