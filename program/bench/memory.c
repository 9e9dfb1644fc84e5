/* Measures the memory held for each cell, bond and marker. */
#include "base/memory.h"
#include "base/par.h"
#include "program/bench/parts.h"
#include "program/bench/scene.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "solid/bonds/family.h"
#include "solid/solid.h"

static double held(enum memory_part part) { return par_sum((double)memory_bytes(part)); }

static void of_fluid(struct bench *bench, const int n[3]) {
    char size[32];
    const double before = held(MEMORY_FLUID);
    struct fluid *f = bench_fluid_new(n, 0);
    snprintf(size, sizeof size, "%dx%dx%d", n[0], n[1], n[2]);
    bench_row_memory(&bench->table, "memory_fluid", size, held(MEMORY_FLUID) - before, (double)fluid_cells(f), "cell");
    fluid_free(f);
}

struct holding {
    double bytes, bonds;
    long particles;
};

static struct holding holding_of(const struct bench_block *block) {
    struct holding h = {.bytes = -held(MEMORY_SOLID)};
    struct solid *s = bench_solid_block_new(block);
    h.bytes += held(MEMORY_SOLID);
    h.bonds = (double)par_sum_long(solid_family_directed(s));
    h.particles = s->n_global;
    solid_free(s);
    return h;
}

/* Memory of a bond: difference of two families in the same block, with horizons of 3 and of 2 spacings, divided by the
 * number of added bonds. The rest is the particles' state, work arrays and indices. */
static void of_block(struct bench *bench, const char *of_bond, const char *of_particle, struct bench_block block) {
    char size[32];
    block.half = bench->quick;
    const struct holding many = holding_of(&block);
    block.ratio = 2;
    const struct holding few = holding_of(&block);
    const double bond = (many.bytes - few.bytes) / (many.bonds - few.bonds);
    snprintf(size, sizeof size, "%ld", many.particles);
    bench_row_memory(&bench->table, of_bond, size, bond * many.bonds, many.bonds, "directed bond");
    bench_row_memory(&bench->table, of_particle, size, many.bytes - bond * many.bonds, (double)many.particles,
                     "particle");
}

static void of_run(struct bench *bench) {
    char size[32];
    struct scene *scene = bench_scene_new(&(struct bench_scene){.half = bench->quick});
    const double before = held(MEMORY_IBM) + held(MEMORY_COUPLING);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    step_advance(r);
    r->stage = 1;
    step_begin_stage(r);
    step_advance(r);
    const int *n = fluid_grid_of(r->fluid)->n;
    snprintf(size, sizeof size, "%dx%dx%d", n[0], n[1], n[2]);
    bench_row_memory(&bench->table, "memory_marker", size, held(MEMORY_IBM) + held(MEMORY_COUPLING) - before,
                     (double)r->surface->total, "marker");
    bench_row_memory(&bench->table, "memory_run", size,
                     held(MEMORY_FLUID) + held(MEMORY_SOLID) + held(MEMORY_IBM) + held(MEMORY_COUPLING),
                     (double)fluid_cells(r->fluid), "cell");
    run_free(r);
    scene_free(scene);
}

void bench_memory(struct bench *bench) {
    of_fluid(bench, bench->quick ? (int[]){32, 16, 16} : (int[]){128, 64, 64});
    of_block(bench, "memory_lattice_bond", "memory_lattice_particle", (struct bench_block){0});
    of_block(bench, "memory_list_bond", "memory_list_particle", (struct bench_block){.list = 1});
    of_run(bench);
}

void bench_memory_image(struct bench *bench) {
    of_block(bench, "memory_image_bond", "memory_image_particle", (struct bench_block){.image = 1});
}
