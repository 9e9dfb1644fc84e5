/* Writes a run's whole state to a checkpoint and reads it back on any number of ranks. */
#include "program/checkpoint.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "coupling/forcing_guess.h"
#include "files/folder.h"
#include "files/log.h"
#include "files/store.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/imposed/given.h"
#include "solid/refine/refine.h"
#include "solid/surface/state.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct store_block block_of(const struct fluid_grid *g) {
    struct store_block b = {.row = g->row, .plane = g->plane};
    memcpy(b.n, g->n, sizeof b.n);
    memcpy(b.lo, g->lo, sizeof b.lo);
    memcpy(b.m, g->m, sizeof b.m);
    return b;
}

static const char *const fluid_name[4] = {"u", "v", "w", "p"};

static void fluid_arrays(struct run *r, double *array[4]) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const struct fluid_state *q = fluid_state_of(r->fluid);
    double *const all[4] = {q->u, q->v, q->w, q->p};
    for (int f = 0; f < 4; f++) array[f] = all[f] + fluid_grid_at(g, 0, 0, 0);
}

/* The velocities at the low boundary faces belong to the state where the side is open: they are set by its condition,
 * and are not stored. */
static void write_fluid(struct run *r, struct store *s) {
    const struct store_block b = block_of(fluid_grid_of(r->fluid));
    double *array[4];
    fluid_arrays(r, array);
    for (int f = 0; f < 4; f++) store_write_block(s, fluid_name[f], &b, array[f]);
    store_write_double(s, "driving", fluid_state_of(r->fluid)->driving);
}

static int read_fluid(struct run *r, struct store *s) {
    const struct store_block b = block_of(fluid_grid_of(r->fluid));
    double *array[4];
    int bad = 0;
    fluid_arrays(r, array);
    for (int f = 0; f < 4 && !bad; f++) bad = store_read_block(s, fluid_name[f], &b, array[f]);
    if (bad || store_read_double(s, "driving", &fluid_state_of(r->fluid)->driving)) return 1;
    fluid_state_refresh(r->fluid);
    return 0;
}

/* Arrays of three components by particle, two in a plate: displacement, velocity, velocity a step ago, load, Verlet's
 * last sweep. */
enum { VECTORS = 5 };
static const char *const vector_name[VECTORS] = {"displacement", "velocity", "velocity_last", "load", "sweep"};

static int vectors_of(struct run *r, double *const *vector[VECTORS]) {
    vector[0] = r->solid->d;
    vector[1] = r->solid->v;
    vector[2] = r->v_last[0] ? r->v_last : NULL;
    vector[3] = r->solid->load;
    vector[4] = r->solid->v_old;
    return VECTORS;
}

enum { SHARES = 5 };
static const char *const share_name[SHARES] = {"e_damped", "e_fracture", "e_constraint", "work_load", "power_pairwise"};

/* Which particles there are, of a plate that is refined as it goes, and the rates that go with them. */
enum { RATES = 6 };
static const char *const rate_name[RATES] = {"rate_stiffness",  "rate_damping",  "rate_sum",
                                             "rate_difference", "rate_absolute", "rate_bound"};

static void rates_of(struct run *r, double *rate[RATES]) {
    struct solid_rates *of = &r->solid_rates;
    double *const all[RATES] = {&of->stiffness,  &of->damping,  &of->sum,
                                &of->difference, &of->absolute, &r->refined.rate2};
    memcpy(rate, all, sizeof all);
}

static void write_particles(struct run *r, struct store *s) {
    const struct solid *solid = r->solid;
    const long n = solid->n_global, first = solid->first[par_rank()];
    double(*place)[3] = memory_new(MEMORY_OUTPUT, (size_t)solid->n + 1, sizeof *place), *rate[RATES];
    uint8_t *level = memory_new(MEMORY_OUTPUT, (size_t)solid->n + 1, 1);
    for (int h = 0; h < solid->n; h++) solid_refine_restore_save(solid, h, &level[h], place[h]);
    store_write_range(s, "body", STORE_BYTE, 1, n, first, solid->n, solid->body);
    store_write_range(s, "level", STORE_BYTE, 1, n, first, solid->n, level);
    store_write_range(s, "place", STORE_DOUBLE, 3, n, first, solid->n, place);
    store_write_long(s, "rate_level", r->refined.level);
    rates_of(r, rate);
    for (int k = 0; k < RATES; k++) store_write_double(s, rate_name[k], *rate[k]);
    memory_free(level);
    memory_free(place);
}

static int read_particles(struct run *r, struct store *s) {
    const long n = store_read_count(s, "level");
    if (n < 0) return 0; /* of a scene without refinement: as they were made */
    double(*place)[3] = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *place), *rate[RATES];
    uint8_t *level = memory_new(MEMORY_OUTPUT, (size_t)n + 1, 1), *body = memory_new(MEMORY_OUTPUT, (size_t)n + 1, 1);
    long finest = -1;
    int bad = store_read_range(s, "body", STORE_BYTE, 1, n, 0, n, body) ||
              store_read_range(s, "level", STORE_BYTE, 1, n, 0, n, level) ||
              store_read_range(s, "place", STORE_DOUBLE, 3, n, 0, n, place) ||
              store_read_long(s, "rate_level", &finest);
    rates_of(r, rate);
    for (int k = 0; k < RATES && !bad; k++) bad = store_read_double(s, rate_name[k], rate[k]);
    r->refined.level = (int)finest;
    bad = bad || solid_refine_restore(r->solid, n, body, level, (const double(*)[3])place);
    memory_free(body);
    memory_free(level);
    memory_free(place);
    return bad;
}

static void write_bonds(struct run *r, struct store *s) {
    struct solid *solid = r->solid;
    const int dim = solid->dim;
    const long n = solid->n_global, first = solid->first[par_rank()];
    if (solid->refine) write_particles(r, s);
    double *work = memory_new(MEMORY_OUTPUT, 3 * (size_t)solid->n + 1, sizeof *work);
    double *const *vector[VECTORS];
    for (int k = 0, all = vectors_of(r, vector); k < all; k++) {
        if (!vector[k]) continue;
        for (int h = 0; h < solid->n; h++)
            for (int c = 0; c < dim; c++) work[dim * h + c] = vector[k][c][h];
        store_write_range(s, vector_name[k], STORE_DOUBLE, dim, n, first, solid->n, work);
    }
    memory_free(work);
    const int bodies = solid->in.bodies;
    if (r->carried)
        store_write_range(s, "carried", STORE_DOUBLE, 3, bodies, 0, par_rank() == 0 ? bodies : 0, r->carried);
    const int bytes = solid_family_bytes(solid);
    uint8_t *bits = memory_new(MEMORY_OUTPUT, (size_t)solid->n * (size_t)bytes + 1, 1);
    for (int h = 0; h < solid->n; h++) solid_family_save(solid, h, bits + (size_t)h * (size_t)bytes);
    store_write_range(s, "bonds", STORE_BYTE, bytes, n, first, solid->n, bits);
    memory_free(bits);
    store_write_range(s, "flag", STORE_BYTE, 1, n, first, solid->n, solid->flag);
    double share[SHARES] = {solid->e_damped, solid->e_fracture, solid->e_constraint, solid->work_load,
                            solid->power_pairwise};
    par_sum_array(share, SHARES);
    for (int k = 0; k < SHARES; k++) store_write_double(s, share_name[k], share[k]);
    if (r->surface) {
        const int comps = solid_surface_state_size();
        double *state = memory_new(MEMORY_OUTPUT, (size_t)solid->n * (size_t)comps + 1, sizeof *state);
        solid_surface_state_save(solid, r->surface, state);
        store_write_range(s, "surface", STORE_DOUBLE, comps, n, first, solid->n, state);
        memory_free(state);
    }
}

/* What is given is a function of time, and is added anew to what the fluid's part of a step writes. */
static void loads_restart(struct run *r) {
    struct solid *solid = r->solid;
    if (!solid->given) return;
    for (int c = 0; c < solid->dim; c++) memset(solid->load[c], 0, (size_t)solid->n * sizeof(double));
    solid_given_forget(solid);
}

static int read_bonds(struct run *r, struct store *s) {
    struct solid *solid = r->solid;
    const int dim = solid->dim;
    solid->t = r->t;
    if (solid->refine && read_particles(r, s)) return 1;
    const long n = solid->n_global, first = solid->first[par_rank()];
    double *work = memory_new(MEMORY_OUTPUT, 3 * (size_t)solid->n + 1, sizeof *work);
    double *const *vector[VECTORS];
    int bad = 0;
    for (int k = 0, all = vectors_of(r, vector); k < all && !bad; k++) {
        if (!vector[k]) continue;
        bad = store_read_range(s, vector_name[k], STORE_DOUBLE, dim, n, first, solid->n, work);
        for (int h = 0; h < solid->n && !bad; h++)
            for (int c = 0; c < dim; c++) vector[k][c][h] = work[dim * h + c];
    }
    memory_free(work);
    const int bodies = solid->in.bodies;
    if (r->carried && !bad &&
        store_read_count(s, "carried") == bodies) /* else of a run whose loads were not balanced */
        bad = store_read_range(s, "carried", STORE_DOUBLE, 3, bodies, 0, bodies, r->carried);
    const int bytes = solid_family_bytes(solid);
    uint8_t *bits = memory_new(MEMORY_OUTPUT, (size_t)solid->n * (size_t)bytes + 1, 1);
    bad = bad || store_read_range(s, "bonds", STORE_BYTE, bytes, n, first, solid->n, bits) ||
          store_read_range(s, "flag", STORE_BYTE, 1, n, first, solid->n, solid->flag);
    for (int h = 0; h < solid->n && !bad; h++) solid_family_load(solid, h, bits + (size_t)h * (size_t)bytes);
    memory_free(bits);
    double share[SHARES] = {0};
    for (int k = 0; k < SHARES && !bad; k++) bad = store_read_double(s, share_name[k], &share[k]);
    if (bad) return bad;
    const int keep = par_rank() == 0; /* sums are carried on by rank 0 */
    solid->e_damped = keep * share[0];
    solid->e_fracture = keep * share[1];
    solid->e_constraint = keep * share[2];
    solid->work_load = keep * share[3];
    solid->power_pairwise = keep * share[4];
    solid->t = r->t;
    loads_restart(r);
    par_ghost_update_bytes(solid->ghost, solid->flag, solid->n);
    solid_ghosts_update(solid);
    solid_family_count(solid);
    if (r->surface) {
        const int comps = solid_surface_state_size();
        double *state = memory_new(MEMORY_OUTPUT, (size_t)solid->n * (size_t)comps + 1, sizeof *state);
        bad = store_read_range(s, "surface", STORE_DOUBLE, comps, n, first, solid->n, state);
        if (!bad) solid_surface_state_load(solid, r->surface, state);
        memory_free(state);
    }
    return bad;
}

static void write_demand(struct run *r, struct store *s) {
    const struct solid *solid = r->solid;
    double(*all)[3] = memory_new(MEMORY_OUTPUT, (size_t)solid->n + 1, sizeof *all);
    forcing_guess_take(r, all);
    store_write_range(s, "demand", STORE_DOUBLE, 3, solid->n_global, solid->first[par_rank()], solid->n, all);
    memory_free(all);
}

/* A checkpoint without it: the force is found anew. */
static int read_demand(struct run *r, struct store *s) {
    const struct solid *solid = r->solid;
    if (store_read_count(s, "demand") < 0) return 0;
    double(*all)[3] = memory_new(MEMORY_OUTPUT, (size_t)solid->n + 1, sizeof *all);
    const int bad =
        store_read_range(s, "demand", STORE_DOUBLE, 3, solid->n_global, solid->first[par_rank()], solid->n, all);
    if (!bad) forcing_guess_put(r, (const double(*)[3])all);
    memory_free(all);
    return bad;
}

static void write(struct run *r, const char *folder, const char *name, int keep) {
    clock_begin(CLOCK_OUTPUT);
    strong_forget(r->strong);
    struct store *s = store_begin(folder, name, keep);
    store_write_double(s, "t", r->t);
    store_write_double(s, "dt", r->dt);
    store_write_long(s, "step", r->step);
    store_write_long(s, "stage_step", r->stage_step);
    store_write_long(s, "substeps", r->substeps);
    store_write_double(s, "approach", r->adapt.approach);
    store_write_text(s, "stage", r->scene->stage[r->stage].name);
    store_write_double(s, "spacing", r->solid ? r->solid->in.spacing : 0);
    if (r->fluid) write_fluid(r, s);
    if (r->needs.bonds) write_bonds(r, s);
    if (forcing_guess_is_part_of(r)) write_demand(r, s);
    store_end(s);
    clock_end(CLOCK_OUTPUT);
}

void checkpoint_write(struct run *r, const char *folder) {
    char name[64];
    snprintf(name, sizeof name, "step_%08ld", r->step);
    write(r, folder, name, 2);
}

void checkpoint_write_stage(struct run *r, const char *folder) {
    char name[128];
    snprintf(name, sizeof name, "stage_%s", r->scene->stage[r->stage].name);
    write(r, folder, name, 0);
}

static int stage_of(const struct scene *scene, const char *name) {
    for (int k = 0; k < scene->stages; k++)
        if (!strcmp(scene->stage[k].name, name)) return k;
    return -1;
}

/* Reads the whole of it; 0, or 1 and a sentence. */
static int read_state(struct run *r, struct store *s, char *why, size_t size) {
    long substeps = 0; /* a checkpoint without it: found anew */
    char stage[SCENE_NAME];
    double spacing;
    int bad = store_read_double(s, "t", &r->t) || store_read_double(s, "dt", &r->dt) ||
              store_read_long(s, "step", &r->step) || store_read_long(s, "stage_step", &r->stage_step) ||
              store_read_text(s, "stage", stage, sizeof stage) || store_read_double(s, "spacing", &spacing);
    if (bad) {
        snprintf(why, size, "%s", store_read_error());
        return 1;
    }
    r->substeps = store_read_long(s, "substeps", &substeps) ? 0 : (int)substeps;
    if (store_read_double(s, "approach", &r->adapt.approach)) r->adapt.approach = 0;
    r->stage = stage_of(r->scene, stage);
    if (r->stage < 0) {
        snprintf(why, size, "%s: was written in stage %s, which the scene does not have", store_read_path(s), stage);
        return 1;
    }
    if (r->solid && spacing != r->solid->in.spacing) {
        snprintf(why, size, "%s: has particles %g m apart, the scene %g m", store_read_path(s), spacing,
                 r->solid->in.spacing);
        return 1;
    }
    bad = (r->fluid && read_fluid(r, s)) || (r->needs.bonds && read_bonds(r, s)) ||
          (forcing_guess_is_part_of(r) && read_demand(r, s));
    if (bad && store_read_is_damaged(s))
        snprintf(why, size, "%s", store_read_error());
    else if (bad)
        snprintf(why, size, "%s does not fit the scene: %s", store_read_path(s), store_read_error());
    return bad;
}

/* Says why a checkpoint cannot be gone on from, and what can. */
static _Noreturn void refuse(enum exit_code code, const char *path, const char *why) {
    const char *other = path && code == EXIT_CODE_FILE ? store_read_other(path) : NULL;
    if (other) die_all(code, "%s; --resume=%s is whole", why, other);
    die_all(code, "%s", why);
}

void checkpoint_read(struct run *r, const char *folder, const char *file) {
    struct store *s = file ? store_read_open(file) : store_read_open_latest(folder);
    if (!s) refuse(EXIT_CODE_FILE, file, store_read_error());
    char why[2048], path[FOLDER_PATH];
    snprintf(path, sizeof path, "%s", store_read_path(s));
    const int bad = read_state(r, s, why, sizeof why), damaged = store_read_is_damaged(s);
    store_read_close(s);
    if (!bad) log_line("resumed from %s", path);
    if (bad) refuse(damaged ? EXIT_CODE_FILE : EXIT_CODE_CHECKPOINT, path, why);
    if (r->stage_step >= r->scene->stage[r->stage].steps && r->stage + 1 < r->scene->stages) {
        r->stage++;
        r->stage_step = 0;
    }
    r->deposited = -1;
}
