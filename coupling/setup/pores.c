/* Finds the cells whose centres are in no body. */
#include "coupling/setup/pores.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_piece.h"
#include "coupling/setup/parts.h"
#include "solid/geometry/compound.h"
#include "solid/geometry/on_surface.h"
#include "solid/voxels/voxels.h"

#include <math.h>

const char *setup_pores_why(const struct scene *scene) {
    for (int k = 0; k < scene->stages; k++)
        if (scene->stage[k].solid != SCENE_SOLID_RIGID) return "the solid is not rigid in all stages";
    for (int b = 0; b < scene->solid->bodies; b++) {
        const struct scene_body *body = &scene->solid->body[b];
        if (body->own.shape == SOLID_POINTS || body->arrangement.kind != MESHLESS_LATTICE)
            return "a body's particles are not on the lattice";
        for (int c = 0; c < 3; c++)
            if (body->velocity[c] != 0) return "a body moves";
    }
    for (int k = 0; k < scene->solid->constraints; k++)
        for (int c = 0; c < 3; c++)
            if (scene->solid->constraint[k].velocity[c] != 0) return "a constraint moves the solid";
    return NULL;
}

int setup_pores_are_voxels(const struct scene *scene) {
    for (int b = 0; b < scene->solid->bodies; b++)
        if (scene->solid->body[b].own.shape != SOLID_IMAGE) return 0;
    return 1;
}

/* A body, and the cells' lattice in it. */
struct shape {
    const struct solid_input *in;
    const struct solid_body *body;
    struct solid_compound *compound; /* NULL: an image */
};

/* Whether a place is in a voxel of the image, or in one of its images across periodic sides. */
static int is_in_image(const struct shape *s, const double x[3]) {
    const struct solid_voxels *v = s->body->voxels;
    int at[3];
    for (int c = 0; c < 3; c++) {
        const double edge = v->sites[c] * s->in->spacing;
        double q = (x[c] - s->in->origin[c]) / edge - (double)v->corner[c] / v->sites[c];
        const double period = s->in->length[c] / edge;
        if (s->in->periodic[c]) q -= period * floor(q / period);
        at[c] = (int)floor(q);
        if (at[c] < 0 || at[c] >= v->n[c]) return 0;
    }
    return solid_voxels_is(v, v->bits, at[0], at[1], at[2]);
}

static int is_in(const struct shape *s, const double x[3]) {
    if (!s->compound) return is_in_image(s, x);
    return solid_on_surface_is_inside(solid_compound_depth(s->compound, x), s->in->spacing);
}

static int is_solid(const struct shape *shape, int shapes, const double x[3]) {
    for (int b = 0; b < shapes; b++)
        if (is_in(&shape[b], x)) return 1;
    return 0;
}

struct stokes_mask *setup_pores(const struct scene *scene, int finer) {
    struct solid_input *in = setup_solid(scene);
    struct shape *shape = memory_new(MEMORY_COUPLING, (size_t)in->bodies + 1, sizeof *shape);
    int n[3];
    double d[3];
    for (int c = 0; c < 3; c++) {
        n[c] = scene->domain.cells[c] * finer;
        d[c] = scene->domain.size[c] / n[c];
    }
    for (int b = 0; b < in->bodies; b++)
        shape[b] = (struct shape){in, &in->body[b], in->body[b].voxels ? NULL : solid_compound_new(in, &in->body[b])};
    struct stokes_mask *m = stokes_mask_new(n);
    const int first = par_piece_low(n[2], par_size(), par_rank()),
              last = par_piece_low(n[2], par_size(), par_rank() + 1);
    for (int k = first; k < last; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++) {
                const double x[3] = {(i + 0.5) * d[0], (j + 0.5) * d[1], (k + 0.5) * d[2]};
                if (!is_solid(shape, in->bodies, x)) stokes_mask_set(m, i, j, k);
            }
    stokes_mask_count(m);
    for (int b = 0; b < in->bodies; b++) solid_compound_free(shape[b].compound);
    memory_free(shape);
    setup_solid_free(in);
    return m;
}
