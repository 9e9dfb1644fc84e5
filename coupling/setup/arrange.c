/* Particles of a body that stand on no lattice of its spacing: puts points into its shape (meshless/arrange). */
#include "base/die.h"
#include "base/ensure.h"
#include "coupling/setup/parts.h"
#include "meshless/arrange/arrange.h"
#include "solid/geometry/compound.h"
#include "solid/geometry/on_surface.h"
#include "solid/geometry/outline.h"

#include <stdlib.h>
#include <string.h>

/* What says whether a place is in the body: a plate's outlines, or the surface of a body in space. */
struct place {
    const struct solid_body *body;
    double spacing;
    struct solid_compound *compound; /* NULL: a plate */
};

static int is_inside(const void *with, const double x[3]) {
    const struct place *p = with;
    if (!p->compound) return solid_outline_contains(p->body->outline, p->body->outlines, x, p->spacing);
    return solid_on_surface_is_inside(solid_compound_depth(p->compound, x), p->spacing);
}

int setup_arrange_is_on(const struct scene *scene, int b) {
    const struct scene_body *body = &scene->solid->body[b];
    switch (body->arrangement.kind) {
    case MESHLESS_LATTICE:
        return 0;
    case MESHLESS_PERTURBED: /* a plate's cells and given points are moved by the solid itself */
        return scene->dimension == 3 && body->own.shape != SOLID_POINTS;
    case MESHLESS_HEXAGONAL:
    case MESHLESS_CENTROIDAL:
    case MESHLESS_RANDOM:
        return 1;
    }
    ENSURE(0, "arrangement %d of the scene", (int)body->arrangement.kind);
}

static struct meshless_domain domain_of(const struct scene *scene, struct place *place) {
    const struct solid_body *body = place->body;
    struct meshless_domain d = {.dim = scene->dimension, .is_inside = is_inside, .with = place};
    if (scene->dimension == 2) {
        solid_outline_bounds(body->outline, body->outlines, d.low, d.high);
        d.measure = solid_outline_area(body->outline, body->outlines);
        return d;
    }
    struct solid_input in = {.spacing = place->spacing};
    memcpy(in.periodic, scene->domain.periodic, sizeof in.periodic);
    memcpy(in.length, scene->domain.size, sizeof in.length);
    place->compound = solid_compound_new(&in, body);
    for (int c = 0; c < 3; c++) {
        if (place->compound->is_wrapped[c])
            die_all(EXIT_CODE_SCENE,
                    "solid body %s goes on across the periodic side in %c: only a lattice does so; leave out its "
                    "arrangement, or keep it within the domain",
                    body->name, "xyz"[c]);
        d.low[c] = place->compound->low[c];
        d.high[c] = place->compound->high[c];
    }
    return d;
}

void setup_arrange(const struct scene *scene, int b, struct solid_body *to) {
    const struct scene_body *from = &scene->solid->body[b];
    const double *offset = scene->solid->lattice_offset, spacing = scene->solid->spacing;
    struct place place = {.body = to, .spacing = spacing};
    struct meshless_arrange_input in = {.kind = from->arrangement.kind,
                                        .volume = from->arrangement.volume,
                                        .domain = domain_of(scene, &place),
                                        .spacing = spacing,
                                        .perturbation = from->arrangement.perturbation,
                                        .seed = from->arrangement.seed};
    for (int c = 0; c < in.domain.dim; c++)
        in.origin[c] = in.kind == MESHLESS_HEXAGONAL ? (in.domain.low[c] + in.domain.high[c]) / 2 : offset[c] * spacing;
    struct meshless_points *p = meshless_arrange_new(&in);
    const int dim = p->dim;
    double *column = malloc((size_t)p->n * (size_t)(dim + 1) * sizeof *column);
    ENSURE(column, "no memory for %ld points", p->n);
    for (int c = 0; c <= dim; c++)
        memcpy(column + c * p->n, c < dim ? p->x[c] : p->volume, (size_t)p->n * sizeof *column);
    to->shape = SOLID_POINTS;
    to->points = p->n;
    for (int c = 0; c < dim; c++) to->point[c] = column + c * p->n;
    to->point_volume = column + dim * p->n;
    to->perturbation = 0; /* the points are moved already */
    meshless_arrange_free(p);
    solid_compound_free(place.compound);
}
