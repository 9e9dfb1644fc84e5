/* Measures force sweeps over lattice blocks, with either bond store. */
#include "program/bench/parts.h"
#include "solid/bonds/family.h"
#include "solid/solid.h"
#include "solid/voxels/voxels.h"

#include <math.h>

static const double SPACING = 1.5625e-3; /* m */

/* The image of a solid's particles between two corners of the lattice: a voxel a site, as the ranks read it from a
 * file.
 */
static struct solid_voxels *image_of(const struct solid *s, const int low[3], const int high[3]) {
    struct solid_voxels *v = solid_voxels_new((int[]){high[0] - low[0], high[1] - low[1], high[2] - low[2]}, NULL, low);
    for (int h = 0; h < s->n; h++) {
        int at[3];
        for (int c = 0; c < 3; c++) at[c] = (int)floor(s->x0[c][h] / SPACING) - low[c];
        solid_voxels_join(&v->bits[solid_voxels_line(v, at[1], at[2]) + at[0] / 64], (uint64_t)1 << at[0] % 64);
    }
    par_shared_unite(v->shared_bits);
    return v;
}

struct solid *bench_solid_block_new(const struct bench_block *in) {
    struct solid_body body = {.name = "block", .shape = SOLID_BOX};
    const struct solid_material material = {.youngs_modulus = 1e8,
                                            .density = 3000,
                                            .fracture_energy = 0.05,
                                            .horizon_ratio = in->ratio > 0 ? in->ratio : 3,
                                            .micromodulus = PHYSICS_CONSTANT,
                                            .ratio_excess = in->ratio_excess};
    struct solid_input input = {.spacing = SPACING,
                                .bodies = 1,
                                .body = &body,
                                .materials = 1,
                                .material = &material,
                                .surface_correction = 1,
                                .general_bonds = in->list,
                                .precision = in->mixed ? SOLID_MIXED : SOLID_DOUBLE};
    const double side = in->side, width = in->half ? 32 : 64;
    const double low[3] = {16, -3, 0}, high[3] = {in->half ? 40 : 64, width + 3, width};
    for (int c = 0; c < 3; c++) {
        body.low[c] = in->side ? 0 : low[c] * SPACING;
        body.high[c] = (in->side ? side : high[c]) * SPACING;
    }
    if (!in->side) { /* the main case's block, with its cavities and its periodic span */
        body.cavity_period = 16 * SPACING;
        body.cavity_radius = 9.168 * SPACING;
        body.cavity_centre[0] = 16.15 * SPACING;
        input.periodic[2] = 1;
        input.length[2] = width * SPACING;
    }
    struct solid *s = solid_new(&input);
    if (in->image) {
        int site[2][3];
        for (int c = 0; c < 3; c++) {
            site[0][c] = (int)lrint(body.low[c] / SPACING);
            site[1][c] = (int)lrint(body.high[c] / SPACING);
        }
        struct solid_voxels *v = image_of(s, site[0], site[1]);
        solid_free(s);
        body.shape = SOLID_IMAGE;
        body.cavity_period = 0;
        body.voxels = v;
        s = solid_new(&input);
        solid_voxels_free(v);
    }
    bench_sweep_strain(s);
    return s;
}

/* Each bond is computed once, for both its ends. Flops: the relative displacement 3, eps = eta.(2 xi + eta)/xi^2 9, the
 * stretch's polynomial of degree four 9, weights 4, zeta 3, and the force added at both ends 12: 40 a bond, 20
 * directed. With damping relative velocities 3, their part along zeta 5, 1/(1 + eps) 2, scales 2, the sum 1, and the
 * power 2: 15 more. Particles: displacement in, acceleration in and out (9 doubles), w in (1); damped, velocity in (3).
 * A directed bond on a lattice: one bit. In a list: 4 B for the other end, three singles for its reference vector, and
 * a double.
 * In mixed precision the polynomial is of degree two, 5, and all is in single, of which a machine computes twice as
 * many: 36 count as 18, 15 as 7.5. Particles: 10 singles, damped 13; the rounding of the state is not counted.
 * With another Poisson's ratio a pass of extensions more: the relative displacement 3, eps 9, the stretch's polynomial
 * of degree four 9, K |xi|^2 1, and both sums added at both ends 4: 26 a bond. Forces have 6 more a bond, for
 * (P_h + P_l)(1 - g) K. Particles: displacement in, two sums in and out (7 doubles), and the pressure in (1). */
static void count(struct bench_row *row, double particles, const struct bench_block *block, int damped) {
    const int list = block->list;
    if (block->mixed) {
        row->flops = 9 + (damped ? 3.75 : 0);
        row->bytes = 0.125 + 4 * (damped ? 13 : 10) * particles / row->units;
        return;
    }
    row->flops = 20 + (damped ? 7.5 : 0);
    row->bytes = (list ? 4 + 12 + 8 : 0.125) + 8 * (damped ? 13 : 10) * particles / row->units;
    if (block->ratio_excess == 0) return;
    row->flops += 13 + 3;
    row->bytes += 0.125 + 8 * (7 + 1) * particles / row->units;
}

static struct solid *solid_of(const struct bench_block *block, double damping) {
    struct solid *s = bench_solid_block_new(block);
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .breakage = 1, .damping_relative = damping};
    return s;
}

static void write_row(struct bench *bench, const char *part, const struct bench_block *block, double damping,
                      struct solid *s, struct bench_sample time) {
    struct bench_row row = bench_sweep_row(part, s, time);
    count(&row, (double)s->n_global, block, damping > 0);
    bench_row_write(&bench->table, &row);
    if (!block->list) bench_row_traffic(&bench->table, part, row.size, bench_sweep, s, 4);
}

static void measure(struct bench *bench, const char *part, const struct bench_block *block, double damping) {
    struct solid *s = solid_of(block, damping);
    write_row(bench, part, block, damping, s, bench_measure_one(&bench->repetition, bench_sweep, s));
    solid_free(s);
}

/* Two kinds of the same block, in turn. The second one differs as `second` says; word: their names in the table. */
static void measure_pair(struct bench *bench, const char *const word[2], struct bench_block block,
                         struct bench_block second, double damping) {
    struct bench_sample sample[2][BENCH_CHANNELS];
    struct bench_block kind[2] = {block, block};
    struct solid *s[2];
    kind[1].image = second.image;
    kind[1].mixed = second.mixed;
    kind[1].ratio_excess = second.ratio_excess;
    for (int k = 0; k < 2; k++) s[k] = solid_of(&kind[k], damping);
    bench_measure(&bench->repetition, bench_sweep, 2, (void *[]){s[0], s[1]}, sample);
    for (int k = 0; k < 2; k++) {
        char part[64];
        snprintf(part, sizeof part, "sweep_%s_%s%s", block.side ? "full" : "porous", word[k],
                 damping > 0 ? "_damped" : "");
        write_row(bench, part, &kind[k], damping, s[k], sample[k][BENCH_WALL]);
        solid_free(s[k]);
    }
}

static void measure_pairs(struct bench *bench, const char *const word[2], struct bench_block second) {
    if (bench->sizes) {
        for (int k = 0; k < bench->sizes; k++)
            if (bench->size[k].side)
                measure_pair(bench, word, (struct bench_block){.side = bench->size[k].side}, second, 0);
        return;
    }
    const int side = bench->quick ? 12 : 38;
    for (int porous = 0; porous < 2; porous++)
        for (int damped = 0; damped < 2; damped++)
            measure_pair(bench, word, (struct bench_block){.side = porous ? 0 : side, .half = bench->quick}, second,
                         damped ? 1e15 : 0);
}

void bench_solid_image(struct bench *bench) { /* a lattice block and an image of the same particles */
    measure_pairs(bench, (const char *const[]){"box", "image"}, (struct bench_block){.image = 1});
}

void bench_solid_precision(struct bench *bench) {
    measure_pairs(bench, (const char *const[]){"double", "mixed"}, (struct bench_block){.mixed = 1});
}

void bench_solid_dilated(struct bench *bench) { /* bonds alone, and nu = 0.2 */
    measure_pairs(bench, (const char *const[]){"bonds", "dilated"}, (struct bench_block){.ratio_excess = -0.05});
}

void bench_solid(struct bench *bench) {
    static const char *const name[2][2][2] = {
        {{"sweep_full", "sweep_full_damped"}, {"sweep_porous", "sweep_porous_damped"}},
        {{"sweep_full_list", "sweep_full_list_damped"}, {"sweep_porous_list", "sweep_porous_list_damped"}}};
    if (bench->sizes) {
        for (int k = 0; k < bench->sizes; k++)
            if (bench->size[k].side)
                measure(bench, name[0][0][0], &(struct bench_block){.side = bench->size[k].side}, 0);
        return;
    }
    for (int list = 0; list < 2; list++)
        for (int porous = 0; porous < 2; porous++)
            for (int damped = 0; damped < 2; damped++)
                measure(bench, name[list][porous][damped],
                        &(struct bench_block){.side = porous         ? 0
                                                      : bench->quick ? 12
                                                                     : 38,
                                              .half = bench->quick,
                                              .list = list},
                        damped ? 1e15 : 0);
    bench_plate(bench);
    bench_refine(bench);
}

/* With a horizon of 2.5 spacings the family is |xi| < 3 spacings plus a little, 122 bonds: the family of codes that
 * bond particles by the distance of their centres only. Then the horizon of 3 spacings, with 178 bonds. */
void bench_solid_peer(struct bench *bench) {
    const int side = bench->quick ? 12 : 38;
    measure(bench, "sweep_122", &(struct bench_block){.side = side, .ratio = 2.5 + 1e-4}, 0);
    measure(bench, "sweep_178", &(struct bench_block){.side = side}, 0);
    measure(bench, "sweep_122_mixed", &(struct bench_block){.side = side, .ratio = 2.5 + 1e-4, .mixed = 1}, 0);
    measure(bench, "sweep_178_mixed", &(struct bench_block){.side = side, .mixed = 1}, 0);
    measure(bench, "sweep_178_dilated", &(struct bench_block){.side = side, .ratio_excess = -0.05}, 0);
}

void bench_solid_growth(struct bench *bench) {
    static const int side[] = {22, 38, 47, 100};
    for (int k = 0; k < (bench->quick ? 1 : 4); k++)
        measure(bench, "sweep_full", &(struct bench_block){.side = side[k]}, 0);
}
