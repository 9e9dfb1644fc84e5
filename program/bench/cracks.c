/* Measures the pressures of a crack that a fluid is pumped into, beside the substeps of the same body without it. */
#include "base/ensure.h"
#include "base/par.h"
#include "base/sort.h"
#include "program/bench/parts.h"
#include "cracks/cracks.h"
#include "solid/bonds/family.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"

#include <math.h>

static const double SPACING = 1e-3, YOUNG = 2e10, DENSITY = 2500, FRACTURE_ENERGY = 50; /* m, Pa, kg/m3, J/m2 */
enum { FAN = 12 }; /* quadrilaterals of the crack */

/* A block with a penny-shaped crack between two layers in its middle, and the fluid's step in a stopwatch. */
struct block {
    struct solid *s;
    struct cracks *c;        /* NULL: dry */
    struct solid_push inner; /* the fluid's */
    struct solid_push timed; /* calls it */
    double seconds;          /* in it */
    double dt;
};

static void stopwatch(struct solid *s, double dt, void *with) {
    struct block *b = with;
    const double begin = par_seconds();
    b->inner.before(s, dt, b->inner.with);
    b->seconds += par_seconds() - begin;
}

static struct solid *solid_of(int side, double radius) {
    const struct solid_material material = {YOUNG, DENSITY, FRACTURE_ENERGY, 3, PHYSICS_CONSTANT, 0, 0};
    const double middle = 0.5 * side * SPACING, height = (side / 2) * SPACING;
    struct solid_body body = {.name = "block", .shape = SOLID_BOX};
    double point[FAN][4][3];
    struct solid_cut cut[FAN];
    for (int k = 0; k < FAN; k++) {
        cut[k] = (struct solid_cut){4, point[k]};
        for (int q = 0; q < 4; q++) {
            const double angle = M_PI * (2 * k + q - 1) / FAN, r = q ? radius * SPACING : 0;
            point[k][q][0] = middle + r * cos(angle);
            point[k][q][1] = middle + r * sin(angle);
            point[k][q][2] = height;
        }
    }
    for (int c = 0; c < 3; c++) body.high[c] = side * SPACING;
    struct solid *s = solid_new(&(struct solid_input){.spacing = SPACING,
                                                      .bodies = 1,
                                                      .body = &body,
                                                      .materials = 1,
                                                      .material = &material,
                                                      .cuts = FAN,
                                                      .cut = cut,
                                                      .surface_correction = SOLID_CORRECTION_VOLUME});
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .breakage = 1};
    return s;
}

/* The whole crack is filled to 0.8 of the pressure at which it grows, V = 5 p a^3/E and p = 0.915 sqrt(E G/a), in
 * `fill` seconds. Then a fifth of the rate goes on in its middle. */
static void pump(struct block *b, int side, double radius, double fill) {
    const double end = side * SPACING, middle = 0.5 * end, a = radius * SPACING, z = (side / 2) * SPACING,
                 near = 3 * SPACING, p = 0.8 * 0.915 * sqrt(YOUNG * FRACTURE_ENERGY / a),
                 rate = 5 * p * a * a * a / YOUNG / (0.9 * fill);
    const double time[4] = {0, 0.1 * fill, 0.9 * fill, fill}, whole[4] = {0, 1, 1, 0}, centre[4] = {0, 0, 0, 0.2};
    const struct cracks_injection injection[2] = {
        {.low = {0, 0, z - near}, .high = {end, end, z + near}, .value = rate, .time = {4, time, whole, 0}},
        {.low = {middle - near, middle - near, z - near},
         .high = {middle + near, middle + near, z + near},
         .value = rate,
         .time = {4, time, centre, 0}}};
    b->c = cracks_new(&(struct cracks_input){.viscosity = 1e-6, .injections = 2, .injection = injection}, b->s);
    cracks_begin(b->c, 1);
    b->inner = *b->s->push;
    b->timed = (struct solid_push){stopwatch, b};
    b->s->push = &b->timed;
}

static void advance(struct block *b, int substeps) {
    solid_integrate(b->s, b->dt, substeps);
    ENSURE(!b->c || !b->c->status.failed, "%s", b->c->status.field);
}

/* What is measured, by repeat: seconds a substep. */
enum { SWEEP, DRY, WET, PRESSURES, THINGS };

static double seconds_of(struct block *b, int thing, int substeps) {
    par_barrier();
    const double begin = par_seconds();
    if (thing == SWEEP)
        for (int k = 0; k < substeps; k++) bench_sweep(b->s);
    else
        advance(b, substeps);
    return (par_seconds() - begin) / substeps;
}

static void write(struct bench *bench, const char *part, const struct solid *s, int substeps, double *seconds,
                  double units, const char *unit) {
    const int repeats = bench->repetition.repeats;
    const double median = sort_median(seconds, (size_t)repeats);
    struct bench_row row = {.part = part,
                            .time = {.calls = substeps,
                                     .repeats = repeats,
                                     .median = median,
                                     .low = seconds[0],
                                     .high = seconds[repeats - 1]},
                            .units = units,
                            .unit = unit};
    snprintf(row.size, sizeof row.size, "%ld", s->n_global);
    bench_row_write(&bench->table, &row);
}

/* A sweep of the dry body, its substeps, and those of the wet one are taken in turn. */
static void measure(struct bench *bench, int side) {
    const double radius = 0.4 * side, dt = 0.4 * SPACING / sqrt(YOUNG / DENSITY);
    const int fill = 2 * side, substeps = bench->quick ? 2 : 5, repeats = bench->repetition.repeats;
    static double seconds[THINGS][BENCH_REPEATS_MAX];
    struct block dry = {.s = solid_of(side, radius), .dt = dt}, wet = {.s = solid_of(side, radius), .dt = dt};
    pump(&wet, side, radius, fill * dt);
    advance(&wet, fill);
    advance(&dry, 2);
    const long iterations = wet.c->iterations, solves = wet.c->solves, steps = wet.c->steps;
    for (int r = 0; r < repeats; r++) {
        seconds[SWEEP][r] = seconds_of(&dry, SWEEP, substeps);
        seconds[DRY][r] = seconds_of(&dry, DRY, substeps);
        wet.seconds = 0;
        seconds[WET][r] = seconds_of(&wet, WET, substeps);
        seconds[PRESSURES][r] = wet.seconds / substeps;
        for (int k = 0; k < THINGS; k++) par_max_array(&seconds[k][r], 1);
    }
    const double bonds = (double)par_sum_long(solid_family_directed(dry.s)), taken = (double)(wet.c->steps - steps);
    write(bench, "crack_sweep", dry.s, substeps, seconds[SWEEP], bonds, "directed bond");
    write(bench, "crack_substep_dry", dry.s, substeps, seconds[DRY], bonds, "directed bond");
    write(bench, "crack_substep_wet", wet.s, substeps, seconds[WET], bonds, "directed bond");
    write(bench, "crack_pressures", wet.s, substeps, seconds[PRESSURES],
          (double)(wet.c->iterations - iterations) / taken, "iteration");
    write(bench, "crack_solves", wet.s, substeps, seconds[PRESSURES], (double)(wet.c->solves - solves) / taken,
          "solve");
    cracks_free(wet.c);
    solid_free(wet.s);
    solid_free(dry.s);
}

void bench_cracks(struct bench *bench) {
    for (int k = 0; k < bench->sizes; k++)
        if (bench->size[k].side) measure(bench, bench->size[k].side);
    if (!bench->sizes) measure(bench, bench->quick ? 14 : 100);
}
