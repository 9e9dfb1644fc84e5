/* Least memory of a scene's fluid and bodies, from their numbers in the scene alone. */
#include "coupling/setup/forecast.h"
#include "base/die.h"
#include "base/machine.h"
#include "base/par.h"
#include "base/par_shared.h"
#include "coupling/setup/setup.h"
#include "scene/outline.h"
#include "scene/shape.h"

#include <math.h>

/* Bytes that no scene goes below: the fluid's u, v, w, p and their right-hand sides; of a particle its places,
 * displacements, velocities and loads, and with bonds two accelerations, volumes and the bits of its bonds. */
enum { CELL = 64, AT_REST = 80, WITH_BONDS = 150 };

static const double MOST = 1e100; /* of particles: no number above it is said */

double forecast_share(void) { return (double)machine_memory() / par_shared_ranks(); }

/* m3, in a plate m2; 0: not known. */
static double volume_of(const struct scene_body *b) {
    const struct scene_shape_kind *kind = scene_shape_of(b->own.shape);
    if (b->outlines > 0) return scene_outline_area(b);
    if (b->holes > 0 || b->has_cavities) return 0;
    return kind && kind->volume ? kind->volume(&b->own) : 0;
}

void forecast_check(const struct scene *scene) {
    const double has = par_sum(forecast_share());
    double cells = scene->fluid ? 1 : 0;
    for (int c = 0; c < 3; c++) cells *= scene->domain.cells[c];
    if (cells * CELL > has)
        die_all(EXIT_CODE_SCENE, "domain.cells: %.3g cells take %.3g GB of memory at least, and there are %.3g GB",
                cells, 1e-9 * cells * CELL, 1e-9 * has);
    const double each = setup_needs_of(scene).bonds ? WITH_BONDS : AT_REST;
    for (int b = 0; scene->solid && b < scene->solid->bodies; b++) {
        const struct scene_body *body = &scene->solid->body[b];
        const double n = fmin(volume_of(body) / pow(scene->solid->spacing, scene->dimension), MOST);
        if (n * each > has)
            die_all(EXIT_CODE_SCENE,
                    "solid.bodies.%s: %.3g particles of spacing %g m take %.3g GB of memory at least, and there are "
                    "%.3g GB",
                    body->name, n, scene->solid->spacing, 1e-9 * n * each, 1e-9 * has);
    }
}
