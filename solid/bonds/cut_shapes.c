/* Breaks the bonds between the shapes of a body that touch but are not bonded. */
#include "solid/bonds/cut_shapes.h"
#include "base/memory.h"
#include "solid/bonds/family.h"
#include "solid/bonds/store.h"
#include "solid/geometry/compound.h"

/* The shape of every particle of body b, ghosts included. */
static void name_shapes(const struct solid *s, int b, int *shape) {
    struct solid_compound *compound = solid_compound_new(&s->in, &s->in.body[b]);
    for (int h = 0; h < s->n + s->n_ghost; h++) {
        const double x[3] = {s->x0[0][h], s->x0[1][h], s->x0[2][h]};
        if (s->body[h] == b) shape[h] = solid_compound_shape(compound, x);
    }
    solid_compound_free(compound);
}

static void cut_body(struct solid *s, int b, const int *shape) {
    static struct solid_family_view view;
    for (int h = s->family->first[b]; h < s->family->first[b + 1]; h++) {
        solid_family_view(s, h, &view);
        for (int k = 0; k < view.n; k++)
            if (view.intact[k] && shape[view.l[k]] != shape[h]) solid_family_break(s, h, k);
    }
}

void solid_cut_shapes(struct solid *s) {
    int *shape = memory_new(MEMORY_SOLID, (size_t)(s->n + s->n_ghost) + 1, sizeof *shape);
    for (int b = 0; b < s->in.bodies; b++) {
        if (!s->in.body[b].contacts_broken) continue;
        name_shapes(s, b, shape);
        cut_body(s, b, shape);
    }
    memory_free(shape);
}
