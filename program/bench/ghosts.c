/* Counts the ghosts of bodies over the ranks, which follow from the order of the particles (solid/geometry/bisect.c).
 */
#include "base/par.h"
#include "base/par_ghost.h"
#include "program/bench/parts.h"
#include "solid/solid.h"

#include <math.h>

static const double SPACING = 1e-3; /* m */
enum { SPHERES = 120 };

/* A body; lengths in spacings. */
struct block {
    const char *name;
    enum solid_shape shape;
    double size[3];        /* of the box; of a sphere or a disc the diameter */
    int periodic[3];       /* 1: as long as the domain, and wrapped */
    double period, radius; /* of cavities, 0: none */
};

static const struct block block[] = {
    {.name = "cube of 38", .shape = SOLID_BOX, .size = {38, 38, 38}},
    {.name = "cube of 47", .shape = SOLID_BOX, .size = {47, 47, 47}},
    {.name = "cube of 100", .shape = SOLID_BOX, .size = {100, 100, 100}},
    {.name = "block 40 x 44 x 42", .shape = SOLID_BOX, .size = {40, 44, 42}},
    {.name = "block 48 x 70 x 64, z periodic", .shape = SOLID_BOX, .size = {48, 70, 64}, .periodic = {0, 0, 1}},
    {"porous block, z periodic", SOLID_BOX, {48, 70, 64}, {0, 0, 1}, 16, 9.168},
    {"porous block, y and z periodic", SOLID_BOX, {48, 64, 64}, {0, 1, 1}, 16, 9.168},
    {"porous block, small cavities", SOLID_BOX, {48, 70, 64}, {0, 0, 1}, 16, 5.3},
    {.name = "bar 200 x 20 x 20", .shape = SOLID_BOX, .size = {200, 20, 20}},
    {.name = "slab 100 x 100 x 8", .shape = SOLID_BOX, .size = {100, 100, 8}},
    {.name = "sphere, 60 across", .shape = SOLID_SPHERE, .size = {60}},
    {.name = "overlapping spheres", .shape = SOLID_SPHERES, .size = {80, 80, 80}},
};

static double next(unsigned long *seed) {
    *seed = *seed * 6364136223846793005ul + 1442695040888963407ul;
    return (double)(*seed >> 33) / 2147483648.0;
}

static void body_set(const struct block *b, struct solid_body *body, double (*entry)[6], struct solid_input *in) {
    unsigned long seed = 1;
    body->shape = b->shape;
    body->radius = 0.5 * b->size[0] * SPACING;
    for (int k = 0; k < SPHERES && b->shape == SOLID_SPHERES; k++) {
        for (int c = 0; c < 3; c++) entry[k][c] = next(&seed) * b->size[c] * SPACING;
        entry[k][3] = entry[k][4] = entry[k][5] = (5 + 6 * next(&seed)) * SPACING;
    }
    body->entries = SPHERES;
    body->entry = (const double(*)[6])entry;
    for (int c = 0; c < 3; c++) {
        body->high[c] = b->size[c] * SPACING;
        in->periodic[c] = b->periodic[c];
        if (b->periodic[c]) in->length[c] = body->high[c];
    }
    body->low[1] = b->period > 0 && !b->periodic[1] ? -3 * SPACING : 0; /* as the main case's: cavities begin 3 above */
    body->high[1] += body->low[1];
    body->cavity_period = b->period * SPACING;
    body->cavity_radius = b->radius * SPACING;
    body->cavity_centre[0] = 0.15 * SPACING;
}

static void count(const char *name, const struct solid_input *in) {
    struct solid *s = solid_new(in);
    const double ghosts = par_sum((double)s->n_ghost);
    if (par_rank() == 0)
        printf("%-32s %8ld particles %8.0f ghosts, %5.1f %%\n", name, s->n_global, ghosts,
               100 * ghosts / (double)s->n_global);
    solid_free(s);
}

/* A plate, and a disc whose circle is two arcs. */
static void count_plates(const struct solid_material *material, int disc) {
    static const signed char straight[4] = {0}, round[2] = {1, 1};
    const double w = (disc ? 200 : 300) * SPACING, h = 100 * SPACING, r = 0.5 * w;
    const double corner[4][2] = {{0, 0}, {w, 0}, {w, h}, {0, h}}, end[2][2] = {{-r, 0}, {r, 0}}, none[4][2] = {{0}};
    const struct solid_outline outline = {0, disc ? 2 : 4, disc ? end : corner, none, disc ? round : straight};
    struct solid_body body = {.name = "plate", .shape = SOLID_POLYGON, .outlines = 1, .outline = &outline};
    count(disc ? "disc, 200 across" : "plate 300 x 100", &(struct solid_input){.model = PHYSICS_PLANE_STRESS,
                                                                               .thickness = SPACING,
                                                                               .spacing = SPACING,
                                                                               .bodies = 1,
                                                                               .body = &body,
                                                                               .materials = 1,
                                                                               .material = material});
}

void bench_ghosts(struct bench *bench) {
    const struct solid_material material = {1e8, 3000, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
    static double entry[SPHERES][6];
    for (size_t k = 0; k < sizeof block / sizeof *block; k++) {
        struct solid_body body = {.name = "body"};
        struct solid_input in = {.spacing = SPACING, .bodies = 1, .body = &body, .materials = 1, .material = &material};
        if (bench->quick && block[k].size[0] > 40) continue;
        body_set(&block[k], &body, entry, &in);
        count(block[k].name, &in);
    }
    for (int disc = 0; disc < 2; disc++) count_plates(&material, disc);
}
