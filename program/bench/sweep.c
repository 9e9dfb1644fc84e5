/* The plate, the strained state and the force sweep that the solid's benches time. */
#include "program/bench/parts.h"
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/solid.h"

#include <math.h>

void bench_sweep_strain(struct solid *s) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < s->dim; c++) s->d[c][h] = 2e-4 * s->in.spacing * sin(300 * s->x0[(c + 1) % s->dim][h] + c);
    solid_ghosts_update(s);
}

void bench_sweep(void *solid) {
    struct solid *s = solid;
    solid_ghosts_update(s);
    solid_force(s, 1);
}

struct bench_row bench_sweep_row(const char *part, const struct solid *s, struct bench_sample time) {
    struct bench_row row = {
        .part = part, .time = time, .units = (double)par_sum_long(solid_family_directed(s)), .unit = "directed bond"};
    snprintf(row.size, sizeof row.size, "%ld", s->n_global);
    return row;
}

struct solid *bench_sweep_plate(int outlines, const struct solid_outline *outline,
                                const struct solid_material *material, const struct solid_refinement *refinement) {
    const struct solid_body body = {.name = "plate", .shape = SOLID_POLYGON, .outlines = outlines, .outline = outline};
    struct solid *s = solid_new(&(struct solid_input){.model = PHYSICS_PLANE_STRESS,
                                                      .thickness = 1e-3,
                                                      .spacing = 1e-3,
                                                      .bodies = 1,
                                                      .body = &body,
                                                      .materials = 1,
                                                      .material = material,
                                                      .refinement = refinement,
                                                      .surface_correction = 1});
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .breakage = 1};
    bench_sweep_strain(s);
    return s;
}
