/* Fuzz target: a point file of a plate and of a body in space. */
#include "coupling/setup/parts.h"
#include "scene/scene.h"
#include "tests/fuzz/fuzz.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct points {
    struct scene_body from;
    struct solid_body to;
    int dim;
};

static const struct scene_domain unit = {.size = {1, 1, 1}, .periodic = {1, 0, 0}};

static void read_points(void *what) {
    struct points *p = what;
    setup_points(&p->from, &unit, p->dim, 0.01, &p->to);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t bytes) {
    const char *path = fuzz_file(data, bytes);
    for (int dim = 2; dim <= 3; dim++) {
        struct points p = {.dim = dim, .from.name = "grains"};
        snprintf(p.from.own.file, sizeof p.from.own.file, "%s", path);
        if (fuzz_read(read_points, &p)) continue;
        fuzz_expect(p.to.points > 0, "no points are accepted");
        for (long i = 0; i < p.to.points; i++) {
            for (int c = 0; c < dim; c++) fuzz_expect(isfinite(p.to.point[c][i]), "a place that is none");
            fuzz_expect(p.to.point_volume[i] > 0 && isfinite(p.to.point_volume[i]), "a volume that is none");
            if (p.to.point_horizon) fuzz_expect(p.to.point_horizon[i] > 0, "a horizon that is none");
        }
        setup_body_free(&p.to);
    }
    return 0;
}
