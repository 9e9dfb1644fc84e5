/* Fuzz target: a file with a list of spheres, read and cut from a small lattice. */
#include "coupling/setup/parts.h"
#include "scene/scene.h"
#include "solid/geometry/compound.h"
#include "tests/fuzz/fuzz.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct list {
    struct scene_part from;
    struct solid_body to;
};

static void read_list(void *what) {
    struct list *p = what;
    setup_spheres(&p->from, "grains", &p->to);
}

struct surface {
    struct solid_input in;
    struct solid_compound *compound;
};

static void make_surface(void *what) {
    struct surface *s = what;
    s->compound = solid_compound_new(&s->in, s->in.body);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t bytes) {
    struct list p = {.from.shape = SOLID_SPHERES, .to = {.name = "grains", .shape = SOLID_SPHERES}};
    snprintf(p.from.file, sizeof p.from.file, "%s", fuzz_file(data, bytes));
    if (fuzz_read(read_list, &p)) return 0;
    fuzz_expect(p.to.entries > 0, "no spheres are accepted");
    for (long k = 0; k < p.to.entries; k++)
        for (int c = 0; c < 3; c++) {
            fuzz_expect(isfinite(p.to.entry[k][c]), "a centre that is none");
            fuzz_expect(p.to.entry[k][3 + c] > 0 && isfinite(p.to.entry[k][3 + c]), "a radius that is none");
        }
    struct surface s = {.in = {.spacing = 1e-3, .bodies = 1, .body = &p.to}};
    if (!fuzz_read(make_surface, &s)) {
        for (int c = 0; c < 3; c++) fuzz_expect(isfinite(s.compound->low[c]), "bounds that are none");
        const double *x = p.to.entry[0]; /* its centre is inside it */
        fuzz_expect(solid_compound_depth(s.compound, x) > 0, "a sphere's centre is outside");
        solid_compound_free(s.compound);
    }
    setup_body_free(&p.to);
    return 0;
}
