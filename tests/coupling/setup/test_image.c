/* Bodies of images: the particles that stand in a solid voxel, for every key, format and number of ranks; floating
 * pieces. */
#include "base/par.h"
#include "coupling/setup/image.h"
#include "coupling/setup/setup.h"
#include "base/files/log.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/solid.h"
#include "tests/check.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FOLDER FRANA_BINARY_DIR "/tests/coupling/images"
#include "tests/coupling/setup/image_files.h"

struct particles {
    long n;
    uint64_t sum; /* of a number for each place and id */
};

static uint64_t mixed(uint64_t z) {
    z ^= z >> 30, z *= 0xbf58476d1ce4e5b9u, z ^= z >> 27, z *= 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

/* All particles of the scene's solid; each that stands where is_in says no, and each too many, fails. */
static struct particles particles_of(const char *keys, double spacing, int with_ids) {
    write_scene(keys, spacing);
    struct scene *scene = scene_new(SCENE, 0, NULL);
    struct solid_input *in = setup_solid(scene);
    struct solid *s = solid_new(in);
    struct particles p = {.n = s->n_global};
    uint64_t sum = 0;
    for (int h = 0; h < s->n; h++) {
        uint64_t z = with_ids ? (uint64_t)(s->first[par_rank()] + h) : 0;
        for (int c = 0; c < 3; c++)
            z = mixed(z + (uint64_t)llrint(s->x0[c][h] / (spacing * 1e-3) * 4 + 1000) + 17u * (unsigned)c);
        sum += z;
    }
    p.sum = (uint64_t)par_sum_long((long)sum);
    solid_free(s);
    setup_solid_free(in);
    scene_free(scene);
    return p;
}

/* Those that a rule gives, for a body of n sites from the corner (3, 2, 1). */
static struct particles expected(const int n[3], int (*is_in)(int i, int j, int k)) {
    struct particles p = {0};
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++) {
                if (!is_in(i, j, k)) continue;
                const int at[3] = {i + 3, j + 2, k + 1};
                uint64_t z = 0;
                for (int c = 0; c < 3; c++) z = mixed(z + (uint64_t)(4 * at[c] + 2 + 1000) + 17u * (unsigned)c);
                p.sum += z;
                p.n++;
            }
    return p;
}

static void check_same(struct particles a, struct particles b) {
    check_equal(a.n, b.n);
    assert_true(a.sum == b.sum);
    check_above(a.n, 0);
}

static int plain(int i, int j, int k) { return sample(i, j, k) > 0; }
static int second(int i, int j, int k) { return sample(i, j, k) == 2; }
static int cropped(int i, int j, int k) { return sample(i + 2, j + 1, k + 3) > 0; }
static int flipped(int i, int j, int k) { return sample(NX - 1 - i, j, NZ - 1 - k) > 0; }
static int mirrored(int i, int j, int k) { return sample(i, j < NY ? j : 2 * NY - 1 - j, k) > 0; }
static int rotated(int i, int j, int k) { return sample(j, NY - 1 - i, k) > 0; } /* by 90 degrees about z */
static int refined(int i, int j, int k) { return sample(i / 3, j / 3, k / 3) > 0; }
static int longer(int i, int j, int k) { return sample(i / 3, j, k / 2) > 0; }
static int crop_flip_mirror(int i, int j, int k) {
    i = i < 8 ? i : 15 - i;
    return sample(2 + 7 - i, 1 + j, 3 + 3 - k) > 0;
}
static int coarse(int i, int j, int k) {
    int solid = 0;
    for (int q = 0; q < 8; q++) solid += sample(2 * i + q % 2, 2 * j + q / 2 % 2, 2 * k + q / 4) > 0;
    return solid > 4;
}
static int coarse_flipped(int i, int j, int k) { return coarse(5 - i, j, 2 - k); }

static void keys(void **state) {
    (void)state;
    static const struct {
        const char *keys;
        double spacing;
        int n[3];
        int (*is_in)(int i, int j, int k);
    } table[] = {
        {RAW "file: sample.raw, solid: [1, 2]", 1, {13, 9, 7}, plain},
        {RAW "file: sample.raw, threshold: 0.5", 1, {13, 9, 7}, plain},
        {RAW "file: sample.raw, solid: [2]", 1, {13, 9, 7}, second},
        {RAW "file: turned.raw, axes: zyx, solid: [1, 2]", 1, {13, 9, 7}, plain},
        {RAW "file: sample.raw, solid: [1, 2], crop: {low: [2, 1, 3], high: [10, 9, 7]}", 1, {8, 8, 4}, cropped},
        {RAW "file: sample.raw, solid: [1, 2], flip: xz", 1, {13, 9, 7}, flipped},
        {RAW "file: turned.raw, axes: zyx, solid: [1, 2], flip: xz", 1, {13, 9, 7}, flipped},
        {RAW "file: sample.raw, solid: [1, 2], mirror: y", 1, {13, 18, 7}, mirrored},
        {"shape: image, size: [9, 13, 7], axes: yxz, type: uint8, voxel: 1.0e-3, low: [0.003, 0.002, 0.001], "
         "file: sample.raw, flip: x, solid: [1, 2]",
         1,
         {9, 13, 7},
         rotated},
        {"shape: image, size: [13, 9, 7], type: uint8, voxel: 1.5e-3, low: [0.0015, 0.001, 0.0005], file: sample.raw, "
         "solid: [1, 2]",
         0.5,
         {39, 27, 21},
         refined},
        {"shape: image, size: [13, 9, 7], type: uint8, voxel: [3.0e-3, 1.0e-3, 2.0e-3], low: [0.003, 0.002, 0.001], "
         "file: sample.raw, solid: [1, 2]",
         1,
         {39, 9, 14},
         longer},
        {RAW "file: sample.raw, solid: [1, 2], crop: {low: [2, 1, 3], high: [10, 9, 7]}, flip: xz, mirror: x",
         1,
         {16, 8, 4},
         crop_flip_mirror},
        {"shape: image, size: [13, 9, 7], type: uint8, voxel: 0.5e-3, low: [0.003, 0.002, 0.001], file: sample.raw, "
         "solid: [1, 2], crop: {low: [0, 0, 0], high: [12, 8, 6]}",
         1,
         {6, 4, 3},
         coarse},
        {"shape: image, size: [13, 9, 7], type: uint8, voxel: 0.5e-3, low: [0.003, 0.002, 0.001], file: turned.raw, "
         "solid: [1, 2], crop: {low: [0, 0, 0], high: [12, 8, 6]}, axes: zyx, flip: xz",
         1,
         {6, 4, 3},
         coarse_flipped}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        check_same(particles_of(table[i].keys, table[i].spacing, 0), expected(table[i].n, table[i].is_in));
}

/* The label of a cell of 2 x 2 x 2 voxels: the one with the most voxels, of equals that of clay. */
static int label_of_cell(int i, int j, int k) {
    int votes[3] = {0};
    for (int q = 0; q < 8; q++) votes[sample(2 * i + q % 2, 2 * j + q / 2 % 2, 2 * k + q / 4)]++;
    return votes[1] > votes[2] ? 1 : 2;
}
static int label_plain(int i, int j, int k) { return sample(i, j, k); }
static int label_flipped(int i, int j, int k) { return sample(NX - 1 - i, j, NZ - 1 - k); }
static int label_mirrored(int i, int j, int k) { return sample(i, j < NY ? j : 2 * NY - 1 - j, k); }
static int label_refined(int i, int j, int k) { return sample(i / 3, j / 3, k / 3); }

/* Each particle is of the material that the map gives the label of its voxel. Label 1 is quartz, 2 clay. A solid that
 * is rigid in every stage has the same particles and nothing for sweeps. */
static void minerals(void **state) {
    (void)state;
    static const struct {
        const char *keys;
        double spacing;
        int (*label)(int i, int j, int k);
    } table[] = {
        {RAW "file: sample.raw, solid: [1, 2], materials: {2: clay, 1: quartz}", 1, label_plain},
        {RAW "file: sample.tif, solid: [1, 2], materials: [{label: 1, material: quartz}, {label: 2, material: clay}]",
         1, label_plain},
        {RAW "file: turned.raw, axes: zyx, solid: [1, 2], materials: {1: quartz, 2: clay}, flip: xz", 1, label_flipped},
        {RAW "file: sample.raw, solid: [1, 2], materials: {1: quartz, 2: clay}, mirror: y", 1, label_mirrored},
        {"shape: image, size: [13, 9, 7], type: uint8, voxel: 1.5e-3, low: [0.0015, 0.001, 0.0005], file: sample.raw, "
         "solid: [1, 2], materials: {1: quartz, 2: clay}",
         0.5, label_refined},
        {"shape: image, size: [13, 9, 7], type: uint8, voxel: 0.5e-3, low: [0.003, 0.002, 0.001], file: sample.raw, "
         "solid: [1, 2], crop: {low: [0, 0, 0], high: [12, 8, 6]}, materials: {2: clay, 1: quartz}",
         1, label_of_cell}};
    materials = MINERALS;
    for (size_t t = 0; t < 2 * sizeof table / sizeof *table; t++) {
        const int rigid = t % 2;
        write_scene(table[t / 2].keys, table[t / 2].spacing);
        struct scene *scene = scene_new(SCENE, 0, NULL);
        struct solid_input *in = setup_solid(scene);
        in->rigid = rigid;
        struct solid *s = solid_new(in);
        long count[2] = {0};
        check_equal(s->family->lattice[0]->materials == NULL, rigid);
        for (int h = 0; h < s->n + s->n_ghost; h++) {
            int at[3];
            for (int c = 0; c < 3; c++) at[c] = (int)floor(s->x0[c][h] / (1e-3 * table[t / 2].spacing) - 3 + c);
            const int label = table[t / 2].label(at[0], at[1], at[2]), m = solid_particle_material(s, h);
            assert_true(label == 1 || label == 2);
            assert_string_equal(scene->solid->material[m].name, label == 1 ? "quartz" : "clay");
            if (h < s->n) count[label - 1]++;
        }
        for (int l = 0; l < 2; l++) check_above(par_sum_long(count[l]), 10);
        solid_free(s);
        setup_solid_free(in);
        scene_free(scene);
    }
    materials = QUARTZ;
}

/* Two labels of one material are one label. */
static void one_material(void **state) {
    (void)state;
    check_same(particles_of(RAW "file: sample.raw, solid: [1, 2], materials: {1: quartz, 2: quartz}", 1, 1),
               particles_of(RAW "file: sample.raw, solid: [1, 2]", 1, 1));
    struct scene *scene;
    write_scene(RAW "file: sample.raw, solid: [1, 2], materials: {1: quartz, 2: quartz}", 1);
    scene = scene_new(SCENE, 0, NULL);
    struct solid_input *in = setup_solid(scene);
    struct solid *s = solid_new(in);
    check_equal(in->body[0].voxels->planes, 0);
    assert_null(s->material);
    solid_free(s);
    setup_solid_free(in);
    scene_free(scene);
}

static int every(int i, int j, int k) { return i >= 0 && j >= 0 && k >= 0; }

/* A rock without pores, of a solid alone. */
static void dense(void **state) {
    (void)state;
    static const int n[3] = {NX, NY, NZ};
    const struct particles all = expected(n, every);
    check_same(particles_of(RAW "file: sample.raw, solid: [0, 1, 2]", 1, 0), all);
    materials = MINERALS;
    check_same(particles_of(RAW "file: sample.raw, solid: [0, 1, 2], materials: {0: clay, 1: quartz, 2: clay}", 1, 0),
               all);
    materials = QUARTZ;
}

/* The same sample in all formats gives the same particles with the same numbers. */
static void formats(void **state) {
    (void)state;
    static const char *const file[] = {"sample.mha", "sample.nrrd", "sample.tif", "sample.h5"};
    const struct particles raw = particles_of(RAW "file: sample.raw, solid: [1, 2]", 1, 1);
    for (size_t i = 0; i < sizeof file / sizeof *file; i++) {
        char text[256];
        snprintf(text, sizeof text, "shape: image, voxel: 1.0e-3, low: [0.003, 0.002, 0.001], solid: [1, 2], file: %s",
                 file[i]);
        check_same(particles_of(text, 1, 1), raw);
    }
}

/* An image of a ball, and the ball; a block of voxels, and the box. Sites stand in the voxels' centres. */
static void shapes(void **state) {
    (void)state;
    check_same(
        particles_of("shape: image, file: ball.raw, size: [16, 16, 16], type: uint8, voxel: 1.0e-3, low: [0.002, "
                     "0.003, 0.004], solid: [1]",
                     1, 0),
        particles_of("shape: sphere, centre: [0.01, 0.011, 0.012], radius: 0.0063", 1, 0));
    check_same(particles_of("shape: image, file: pieces.raw, size: [8, 8, 8], type: uint8, voxel: 2.0e-3, low: [0.002, "
                            "0.003, 0.004], solid: [1], floating: remove",
                            1, 0),
               particles_of("shape: box, low: [0.002, 0.003, 0.004], high: [0.018, 0.019, 0.012]", 1, 0));
}

#define PIECES                                                                                                         \
    "shape: image, file: pieces.raw, size: [8, 8, 8], type: uint8, voxel: 1.0e-3, low: [0.002, 0.003, 0.004], solid: " \
    "[1]"

static void floating(void **state) {
    (void)state;
    check_equal(particles_of(PIECES, 1, 0).n, 256 + 3);
    check_equal(particles_of(PIECES ", floating: keep", 1, 0).n, 256 + 3);
    check_equal(particles_of(PIECES ", floating: remove", 1, 0).n, 256);
    check_equal(particles_of(PIECES ", floating: remove, mirror: z", 1, 0).n, 2 * 256 - 256);
    write_scene(PIECES ", floating: hold", 1);
    struct scene *scene = scene_new(SCENE, 0, NULL);
    struct solid_input *in = setup_solid(scene);
    struct solid *s = solid_new(in);
    long held = 0;
    for (int h = 0; h < s->n; h++) {
        const int is = (s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z)) != 0;
        check_equal(is, s->x0[2][h] > 0.0095);
        held += is;
    }
    check_equal(par_sum_long(held), 3);
    solid_free(s);
    setup_solid_free(in);
    scene_free(scene);
}

/* The node's memory cannot be shared while this is set. */
static int cannot_share;
int __wrap_memfd_create(const char *name, unsigned flags);
int __real_memfd_create(const char *name, unsigned flags);
int __wrap_memfd_create(const char *name, unsigned flags) {
    if (!cannot_share) return __real_memfd_create(name, flags);
    errno = ENOSPC;
    return -1;
}

/* As on several nodes, each of which has a copy of the bits: the same particles. */
static void nodes(void **state) {
    par_shared_limit(par_size() > 2 ? 2 : 1);
    keys(state);
    par_shared_limit(1);
    floating(state);
    par_shared_limit(0);
}

static void minerals_on_nodes(void **state) {
    par_shared_limit(1);
    minerals(state);
    par_shared_limit(0);
}

static void without_shared_memory(void **state) {
    static const char *const sentence =
        "ball: the ranks of a node cannot share memory (memfd_create: No space left on device): each of them holds 0.0 "
        "MB of bits of the image";
    char text[4096] = "";
    cannot_share = 1;
    floating(state);
    minerals(state);
    log_begin(FOLDER, 1, 0);
    particles_of(PIECES ", name: ball", 1, 0);
    log_end();
    if (par_rank() == 0) {
        FILE *file = fopen(FOLDER "/run.log", "r");
        assert_non_null(file);
        check_above(fread(text, 1, sizeof text - 1, file), 0);
        fclose(file);
        check_equal(strstr(text, sentence) != NULL, par_size() > 1);
    }
    cannot_share = 0;
    par_barrier();
}

/* A piece that a constraint holds does not float. */
static void constrained(void **state) {
    (void)state;
    const char *const set[] = {"solid.constraints=[{low: [0.004, 0.005, 0.0101], high: [0.0072, 0.0072, 0.0108]}]"};
    write_scene(PIECES ", floating: remove", 1);
    struct scene *scene = scene_new(SCENE, 1, set);
    struct setup_image *image = setup_image_read(scene, 0);
    struct solid_components *c = setup_image_solid(scene, image);
    check_equal(c->pieces, 3);
    check_equal(c->floating_pieces, 1);
    check_equal(c->floating_voxels, 1);
    check_equal(image->labels, 2);
    check_equal(image->label[0].voxels, 512 - 259);
    check_equal(image->label[1].voxels, 259);
    solid_components_free(c);
    setup_image_free(image);
    scene_free(scene);
}

/* Voxels beyond a periodic side come in at the opposite one: their particles stand within the domain, pieces there are
 * held, and a region there holds a piece. The layers of pieces are 6 and 7. */
static void beyond_sides(void **state) {
    (void)state;
    static const struct {
        const char *low, *region;
        double pieces[2]; /* that stand between these z */
    } table[] = {{"[0.002, 0.003, 0.034]", "low: [0.004, 0.005, 0.0001], high: [0.0072, 0.0072, 0.0008]", {0, 0.002}},
                 {"[0.036, -0.005, -0.004]", "low: [0.038, 0.037, 0.0021], high: [0.04, 0.04, 0.0028]", {0.002, 0.004}},
                 {"[-0.007, 0.038, -0.007]", "low: [0.035, 0.0, 0.0391], high: [0.038, 0.002, 0.0398]", {-1, 1}}};
    for (size_t t = 0; t < sizeof table / sizeof *table; t++) {
        char keys[512], constraints[128];
        const char *const set[] = {"domain.periodic=[true, true, true]", constraints};
        snprintf(keys, sizeof keys,
                 "shape: image, file: pieces.raw, size: [8, 8, 8], type: uint8, voxel: 1.0e-3, low: %s, solid: [1], "
                 "floating: hold",
                 table[t].low);
        snprintf(constraints, sizeof constraints, "solid.constraints=[{%s}]", table[t].region);
        write_scene(keys, 1);
        struct scene *scene = scene_new(SCENE, 1, set);
        struct solid_input *in = setup_solid(scene);
        struct solid *s = solid_new(in);
        long held = 0;
        for (int h = 0; h < s->n; h++) {
            for (int c = 0; c < 3; c++) check_close(s->x0[c][h], 0.02, 0.02);
            if (!(s->flag[h] & SOLID_HELD_X)) continue;
            check_close(s->x0[2][h], (table[t].pieces[0] + table[t].pieces[1]) / 2,
                        (table[t].pieces[1] - table[t].pieces[0]) / 2);
            held++;
        }
        check_equal(par_sum_long(held), 3);
        solid_free(s);
        setup_solid_free(in);
        scene_free(scene);
        scene = scene_new(SCENE, 2, set);
        struct setup_image *image = setup_image_read(scene, 0);
        struct solid_components *c = setup_image_solid(scene, image);
        check_equal(c->floating_pieces, 1);
        solid_components_free(c);
        setup_image_free(image);
        scene_free(scene);
    }
}

int main(int argc, char **argv) {
    const struct CMUnitTest all[] = {cmocka_unit_test(keys),         cmocka_unit_test(formats),
                                     cmocka_unit_test(shapes),       cmocka_unit_test(floating),
                                     cmocka_unit_test(nodes),        cmocka_unit_test(without_shared_memory),
                                     cmocka_unit_test(constrained),  cmocka_unit_test(beyond_sides),
                                     cmocka_unit_test(minerals),     cmocka_unit_test(minerals_on_nodes),
                                     cmocka_unit_test(one_material), cmocka_unit_test(dense)};
    par_begin(&argc, &argv);
    const int failed = par_size() == 1 ? cmocka_run_group_tests(all, write_all, NULL)
                                       : _cmocka_run_group_tests("ranks", all, 7, write_all, NULL);
    par_end();
    return failed;
}
