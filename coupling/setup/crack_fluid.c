/* Translates the fluid of cracks from the scene to its input. */
#include "coupling/setup/crack_fluid.h"
#include "base/ensure.h"

#include <stdlib.h>
#include <string.h>

struct cracks *setup_crack_fluid(const struct scene *scene, struct solid *s) {
    const struct scene_crack_fluid *f = scene->crack_fluid;
    if (!f) return NULL;
    struct cracks_injection *to = calloc((size_t)f->injections + 1, sizeof *to);
    ENSURE(to, "no memory for %d injections", f->injections);
    for (int q = 0; q < f->injections; q++) {
        const struct scene_injection *from = &f->injection[q];
        to[q] = (struct cracks_injection){.is_pressure = from->is_pressure,
                                          .value = from->is_pressure ? from->pressure : from->rate,
                                          .time = {from->time.n, from->time.t, from->time.factor, 0}};
        memcpy(to[q].low, from->low, sizeof to[q].low);
        memcpy(to[q].high, from->high, sizeof to[q].high);
    }
    const struct cracks_input in = {
        .viscosity = f->viscosity,
        .compressibility = f->compressibility,
        .least_pressure = f->least_pressure,
        .least_aperture = f->least_aperture,
        .leak_off = f->leak_off,
        .outside = scene->fluid != NULL,
        .porous = f->pores != NULL,
        .pores = f->pores ? (struct cracks_pores){f->pores->permeability, f->pores->biot, f->pores->modulus}
                          : (struct cracks_pores){0},
        .injections = f->injections,
        .injection = to};
    struct cracks *c = cracks_new(&in, s);
    free(to);
    return c;
}
