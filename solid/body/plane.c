/* The particles of a polygonal plate as a cloud, and the check that no two plates overlap. */
#include "solid/body/plane.h"
#include "base/die.h"
#include "base/memory.h"
#include "solid/body/perturb.h"
#include "solid/geometry/outline.h"

#include <math.h>
#include <stdlib.h>

struct solid_cloud *solid_plane_cloud(const struct solid_input *in, const struct solid_body *body,
                                      const struct solid_sites *sites) {
    struct solid_cloud_input cloud = {.name = body->name,
                                      .n = sites->count,
                                      .first = sites->first,
                                      .spacing = in->spacing,
                                      .thickness = in->thickness,
                                      .volume = sites->area,
                                      .law = solid_pair_law(in, &in->material[body->material])};
    const size_t n = (size_t)sites->count + 1;
    double *place[2] = {memory_new(MEMORY_SOLID, n, sizeof(double)), memory_new(MEMORY_SOLID, n, sizeof(double))};
    double *size = memory_new(MEMORY_SOLID, n, sizeof *size);
    for (int c = 0; c < 2; c++) {
        cloud.origin[c] = in->origin[c] + sites->base[c] * in->spacing;
        cloud.period[c] = in->periodic[c] ? in->length[c] : 0;
        for (long i = 0; i < sites->count; i++)
            place[c][i] =
                sites->cell[i][c] - sites->base[c] + 0.5 + solid_perturb(body, sites->cell[i][0], sites->cell[i][1], c);
        cloud.place[c] = place[c];
    }
    for (long i = 0; i < sites->count; i++) size[i] = 1;
    cloud.size = size;
    struct solid_cloud *made = solid_cloud_new(&cloud);
    MEMORY_FREE(place[0], place[1], size);
    return made;
}

struct owner {
    int i, j, body;
};

static int by_cell(const void *a, const void *b) {
    const struct owner *x = a, *y = b;
    return x->j != y->j ? (x->j > y->j) - (x->j < y->j) : (x->i > y->i) - (x->i < y->i);
}

void solid_plane_overlap_check(const struct solid_input *in, struct solid_sites *const *sites) {
    size_t n = 0, all = 0;
    for (int b = 0; b < in->bodies; b++) all += sites[b]->cell ? (size_t)sites[b]->count : 0;
    struct owner *owner = memory_new(MEMORY_SOLID, all + 1, sizeof *owner);
    for (int b = 0; b < in->bodies; b++)
        for (long i = 0; sites[b]->cell && i < sites[b]->count; i++)
            owner[n++] = (struct owner){sites[b]->cell[i][0], sites[b]->cell[i][1], b};
    qsort(owner, n, sizeof *owner, by_cell);
    for (size_t k = 1; k < n; k++)
        if (by_cell(&owner[k - 1], &owner[k]) == 0)
            die_all(EXIT_CODE_SCENE, "solid bodies %s and %s overlap at (%g, %g) m", in->body[owner[k - 1].body].name,
                    in->body[owner[k].body].name, in->origin[0] + (owner[k].i + 0.5) * in->spacing,
                    in->origin[1] + (owner[k].j + 0.5) * in->spacing);
    memory_free(owner);
}
