/* The weights of struts by their offset on the lattice. */
#include "cracks/table.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "solid/law/pair.h"
#include "solid/law/stencil.h"

#include <math.h>
#include <string.h>

static size_t place_of(const struct cracks_table *t, const signed char step[3]) {
    const size_t side = 2 * (size_t)t->reach + 1;
    size_t at = 0;
    for (int c = 2; c >= 0; c--) at = at * side + (size_t)(step[c] + t->reach);
    return at;
}

int cracks_table_number(const struct cracks_table *t, const signed char step[3]) {
    const int number = t->number[place_of(t, step)];
    ENSURE(number >= 0, "no strut along (%d, %d, %d)", step[0], step[1], step[2]);
    return number;
}

/* Gamma of a step, -1: not in the family. In space the fractions of the lattice's stencil, which are the same for all
 * permutations of a step; stencil NULL: those of the pair, in closed form. */
static double gamma_of(const struct solid_bond_law *law, const struct solid_stencil *stencil,
                       const signed char step[3]) {
    const double xi[3] = {step[0], step[1], step[2]}, size = 1;
    if ((!step[0] && !step[1] && !step[2]) || !solid_pair_holds(law, xi, law->horizon, size)) return -1;
    if (!stencil) return solid_pair_gamma(law, xi, law->horizon, size);
    for (int o = 0; o < stencil->n; o++) {
        const int *s = stencil->offset[o].step;
        if (s[0] == step[0] && s[1] == step[1] && s[2] == step[2])
            return stencil->offset[o].weight / (stencil->spacing * stencil->spacing * stencil->spacing);
    }
    return -1;
}

/* Adds the step to the table, omega without omega0. */
static void add(struct cracks_table *t, const signed char step[3], double spacing, double gamma) {
    const int k = t->kinds++;
    double length2 = 0;
    memcpy(t->step[k], step, sizeof t->step[k]);
    for (int c = 0; c < 3; c++) length2 += step[c] * step[c];
    t->length[k] = sqrt(length2) * spacing;
    t->omega[k] = gamma;
    t->number[place_of(t, step)] = (short)k;
}

void cracks_table_new(struct cracks_table *t, const struct solid_input *in, const struct solid_material *material) {
    const struct solid_bond_law law = solid_pair_law(in, material);
    const int dim = solid_dim(in), reach = (int)floor(law.horizon + 1), flat = dim == 2;
    const int exact = dim == 3 && in->partial == SOLID_PARTIAL_EXACT;
    struct solid_stencil *stencil = exact ? solid_stencil_new(in->spacing, material->horizon_ratio) : NULL;
    const double volume = pow(in->spacing, dim) * solid_depth(in);
    const size_t side = 2 * (size_t)reach + 1, places = side * side * side;
    *t = (struct cracks_table){.dim = dim, .reach = reach};
    t->omega = memory_new(MEMORY_SOLID, 2 * (size_t)SOLID_FAMILY_MAX, sizeof *t->omega);
    t->length = memory_new(MEMORY_SOLID, 2 * (size_t)SOLID_FAMILY_MAX, sizeof *t->length);
    t->step = memory_new(MEMORY_SOLID, 2 * (size_t)SOLID_FAMILY_MAX, sizeof *t->step);
    t->half = memory_new(MEMORY_SOLID, 2 * (size_t)SOLID_FAMILY_MAX, sizeof *t->half);
    t->number = memory_new(MEMORY_SOLID, places, sizeof *t->number);
    memset(t->number, 0xff, places * sizeof *t->number);
    double sum = 0;
    for (int k = flat ? 0 : -reach; k <= (flat ? 0 : reach); k++)
        for (int j = -reach; j <= reach; j++)
            for (int i = -reach; i <= reach; i++) {
                const signed char step[3] = {(signed char)i, (signed char)j, (signed char)k};
                const double gamma = gamma_of(&law, stencil, step);
                if (gamma < 0) continue;
                ENSURE(t->kinds < SOLID_FAMILY_MAX, "more than %d struts", t->kinds);
                add(t, step, in->spacing, gamma);
                sum += gamma * t->length[t->kinds - 1];
            }
    t->omega0 = 2 * dim * volume / sum;
    for (int k = 0; k < t->kinds; k++) {
        t->omega[k] *= t->omega0;
        for (int c = 0; c < 3; c++) t->half[k][c] = 0.5 * t->omega[k] * (t->step[k][c] * in->spacing / t->length[k]);
    }
    solid_stencil_free(stencil);
}

void cracks_table_add_intact(struct cracks_table *t, double biot) {
    for (int k = 0; k < t->kinds; k++) {
        const int to = t->kinds + k;
        t->omega[to] = biot * t->omega[k];
        t->length[to] = t->length[k];
        t->half[to] = biot * t->half[k];
        memcpy(t->step[to], t->step[k], sizeof t->step[to]);
    }
}

void cracks_table_free(struct cracks_table *t) {
    MEMORY_FREE(t->omega, t->length, t->step, t->half, t->number);
    *t = (struct cracks_table){0};
}
