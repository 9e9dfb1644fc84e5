/* Measures the pressures of a crack that a fluid is pumped into, beside the substeps of the same body without it. */
#include "base/ensure.h"
#include "base/par.h"
#include "bench/parts.h"
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
    struct cracks *c;         /* NULL: dry */
    struct solid_push inner;  /* the fluid's */
    struct solid_push timed;  /* calls it */
    double seconds;           /* in it */
    double dt;
    int substeps; /* a call */
};

static void stopwatch(struct solid *s, double dt, void *with) {
    struct block *b = with;
    const double begin = par_seconds();
    b->inner.before(s, dt, b->inner.with);
    b->seconds += par_seconds() - begin;
}

static struct solid *solid_of(int side, double radius) {
    const struct solid_material material = {YOUNG, DENSITY, FRACTURE_ENERGY, 3, SOLID_CONSTANT, 0};
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

/* The whole crack is filled to a pressure near the one at which it grows, V = 5 p a^3/E and p = 0.915 sqrt(E G/a), in
 * `fill` seconds. Then the same rate goes on in its middle: it grows. */
static void pump(struct block *b, int side, double radius, double fill, double viscosity) {
    const double middle = 0.5 * side * SPACING, a = radius * SPACING, z = (side / 2) * SPACING,
                 p = 0.915 * sqrt(YOUNG * FRACTURE_ENERGY / a), volume = 5 * p * a * a * a / YOUNG;
    const double time[4] = {0, 0.1 * fill, 0.9 * fill, fill}, whole[4] = {0, 1, 1, 0}, centre[4] = {0, 0, 0, 1};
    const struct cracks_injection injection[2] = {
        {.low = {0, 0, z - 3 * SPACING},
         .high = {2 * middle, 2 * middle, z + 3 * SPACING},
         .value = volume / (0.9 * fill),
         .time = {4, time, whole}},
        {.low = {middle - 3 * SPACING, middle - 3 * SPACING, z - 3 * SPACING},
         .high = {middle + 3 * SPACING, middle + 3 * SPACING, z + 3 * SPACING},
         .value = volume / (0.9 * fill),
         .time = {4, time, centre}}};
    b->c = cracks_new(&(struct cracks_input){.viscosity = viscosity, .injections = 2, .injection = injection}, b->s);
    cracks_begin(b->c, 1);
    b->inner = *b->s->push;
    b->timed = (struct solid_push){stopwatch, b};
    b->s->push = &b->timed;
}

static void advance(void *block) {
    struct block *b = block;
    solid_integrate(b->s, b->dt, b->substeps);
}

#include <stdlib.h>
void bench_cracks(struct bench *bench) {
    const int side = bench->sizes ? bench->size[0].side : bench->quick ? 14 : 100;
    const double radius = 0.4 * side;
    struct block b = {.s = solid_of(side, radius), .dt = 0.4 * SPACING / sqrt(YOUNG / DENSITY), .substeps = 1};
    const int fill = (getenv("FILL") ? atof(getenv("FILL")) : 3.) * side;
    pump(&b, side, radius, fill * b.dt, getenv("VISC") ? atof(getenv("VISC")) : 1e-6);
    if (getenv("QUIET")) { for (int k = 0; k < 2 * fill; k++) advance(&b); printf("total its %ld solves %ld wet %d\n", b.c->iterations, b.c->solves, b.c->struts.n); return; }
    long it = 0, so = 0, re = 0;
    for (int k = 0; k < 2 * fill; k++) {
        double t0 = par_seconds();
        advance(&b);
        ENSURE(!b.c->status.failed, "%s", b.c->status.field);
        static double total; total += par_seconds() - t0;
        if (k % (fill / 8) == fill / 8 - 1 && par_rank() == 0) {
            double pm = 0;
            for (int i = 0; i < b.c->struts.n; i++) pm += b.c->p[i] / b.c->struts.n;
            printf("%4d wet %d entries %ld p %.4g its %.2f solves %.2f renewals %.2f project %.3f of total %.3f\n", k,
                   b.c->struts.n, b.c->struts.rows.struts - b.c->struts.rows.struts_dead, pm, (b.c->iterations - it) / (fill / 8.),
                   (b.c->solves - so) / (fill / 8.), (b.c->renewals - re) / (fill / 8.), b.seconds / (fill / 8.),
                   total / (fill / 8.));
            it = b.c->iterations, so = b.c->solves, re = b.c->renewals, b.seconds = total = 0;
            fflush(stdout);
        }
    }

}
