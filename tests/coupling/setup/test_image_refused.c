/* Images that are refused, each with one sentence. */
#include "base/die.h"
#include "coupling/setup/setup.h"

#include <stdarg.h>
#include <stdlib.h>
#include <unistd.h>

#define FOLDER FRANA_BINARY_DIR "/tests/coupling/refused"
#include "tests/coupling/setup/image_files.h"
#include "tests/leaves.h"

/* Of a child process, which must not end the parent's MPI: it says its sentence and ends. */
static int is_child;
void __wrap_par_end(void);
void __real_par_end(void);
void __wrap_par_end(void) {
    if (!is_child) __real_par_end();
}
_Noreturn void __wrap_die_all(enum exit_code code, const char *format, ...) __attribute__((format(printf, 2, 3)));
_Noreturn void __wrap_die_all(enum exit_code code, const char *format, ...) {
    va_list args;
    va_start(args, format);
    vfprintf(stderr, format, args);
    va_end(args);
    fputc('\n', stderr);
    fflush(stderr);
    _exit(code);
}

static void make_solid(void *with) {
    const struct leaves_scene *r = with;
    is_child = 1;
    setup_solid(scene_new(r->path, r->n, r->set));
}

/* The scene whose body has these keys is refused with one sentence. */
static void check_refused(const char *keys, double spacing, const char *sentence) {
    char said[4096];
    write_scene(keys, spacing);
    assert_int_equal(leaves(make_solid, &(struct leaves_scene){SCENE, 0, NULL}, said, sizeof said), EXIT_CODE_SCENE);
    if (!strstr(said, sentence)) fail_msg("%s\nshould say: %s\nand says: %s", keys, sentence, said);
    if (strchr(said, '\n') != said + strlen(said) - 1) fail_msg("%s\nis not one sentence: %s", keys, said);
}

static void refused(void **state) {
    (void)state;
    static const struct {
        const char *keys;
        double spacing;
        const char *sentence;
    } table[] = {
        {RAW "file: sample.raw, solid: [1, 7]", 1,
         "solid.bodies[0].solid: label 7 does not occur in " FOLDER "/sample.raw, whose values are 0 to 2 (0, 1, 2)"},
        {RAW "file: sample.raw, threshold: 2.5", 1, "solid.bodies[0].threshold: leaves no solid in"},
        {RAW "file: sample.raw, threshold: 0", 1, "solid.bodies[0].threshold: leaves no pore in"},
        {RAW "file: sample.raw", 1, "scene.yaml:5: solid.bodies[0].solid: missing; shape image needs it"},
        {RAW "file: sample.raw, solid: [1], threshold: 1", 1,
         "solid.bodies[0].solid = [1]: not together with threshold"},
        {RAW "file: sample.raw, threshold: 1, materials: {1: quartz}", 1,
         "scene.yaml:5: solid.bodies[0].materials: not together with threshold"},
        {"shape: box, low: [0, 0, 0], high: [0.01, 0.01, 0.01], materials: {1: quartz}", 1,
         "solid.bodies[0].materials: only with shape image, here it is box"},
        {RAW "file: sample.raw, solid: [1]", 0.7, "solid.bodies[0].voxel = 1.0e-3: must be solid.spacing (0.0007 m)"},
        {"shape: image, size: [13, 9, 7], type: uint8, voxel: [1.0e-3, 2.0e-3], low: [0, 0, 0], solid: [1], file: "
         "sample.raw",
         1, "solid.bodies[0].voxel = [1.0e-3, 2.0e-3]: must be a list of 3 numbers (m), or one that counts for all"},
        {"shape: image, size: [13, 9, 7], type: uint8, voxel: [1.0e-3, 0, 1.0e-3], low: [0, 0, 0], solid: [1], file: "
         "sample.raw",
         1, "solid.bodies[0].voxel[1] = 0: must be greater than 0"},
        {"shape: image, size: [13, 9, 7], type: uint8, voxel: [1.0e-3, 1.0e-3, 1.5e-3], low: [0, 0, 0], solid: [1], "
         "file: sample.raw",
         1,
         "solid.bodies[0].voxel = [1.0e-3, 1.0e-3, 1.5e-3]: edges that differ must each be solid.spacing (0.001 m) "
         "times 1, 2, 3 ... 64; solid.spacing: 0.0005 fits"},
        {RAW "file: sample.raw, solid: [1]", 2,
         "13 voxels along x do not make whole cells of 2 voxels; crop the image to 12"},
        {RAW "file: sample.raw, solid: [1], crop: {low: [0, 0, 0], high: [13, 10, 7]}", 1,
         "solid.bodies[0].crop.high = [13, 10, 7]: must be at most 9 in y: the image has no more voxels"},
        {RAW "file: sample.raw, solid: [1], crop: {low: [0, 5, 0], high: [13, 5, 7]}", 1,
         "solid.bodies[0].crop.low = [0, 5, 0]: must be below high in every direction, y is not"},
        {RAW "file: sample.raw, solid: [1], flip: xx", 1,
         "solid.bodies[0].flip = xx: must be a word of the letters x, y and z, each at most once"},
        {RAW "file: sample.raw, solid: [1], mirror: a", 1, "solid.bodies[0].mirror = a: must be a word of the letters"},
        {"shape: image, size: [13, 9, 7], type: uint8, voxel: 1.0e-3, low: [0.0033, 0.002, 0.001], solid: [1], file: "
         "sample.raw",
         1,
         "solid.bodies[0].low = [0.0033, 0.002, 0.001]: must be on a corner of the lattice's cells; along x the "
         "nearest "
         "are at 0.003 and 0.004 m"},
        {"shape: image, size: [13, 9, 8], type: uint8, voxel: 1.0e-3, low: [0, 0, 0], solid: [1], file: sample.raw", 1,
         "it has 819 bytes, but 13 x 9 x 8 voxels of uint8 take 936"},
        {"shape: image, size: [8, 8, 8], type: uint8, voxel: 1.0e-3, low: [0, 0, 0], solid: [1], file: short.raw", 1,
         "it has 511 bytes, but 8 x 8 x 8 voxels of uint8 take 512"},
        {"shape: image, size: [8, 8, 8], type: uint8, voxel: 1.0e-3, low: [0, 0, 0], solid: [1], file: pore.raw", 1,
         "solid.bodies[0].solid: label 1 does not occur in " FOLDER "/pore.raw, whose values are 0 to 0 (0)"},
        {"shape: image, voxel: 1.0e-3, low: [0, 0, 0], solid: [1], file: sample.raw", 1,
         "a raw file has no header: its size is needed"},
        {"shape: box, low: [0, 0, 0], high: [0.01, 0.01, 0.01], flip: x", 1,
         "solid.bodies[0].flip = x: only with shape image, here it is box"}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        check_refused(table[i].keys, table[i].spacing, table[i].sentence);
}

#define TWO RAW "file: sample.raw, solid: [1, 2], "
static void refused_materials(void **state) {
    (void)state;
    static const struct {
        const char *keys, *more, *sentence;
    } table[] = {
        {TWO "materials: {1: quartz}", "",
         "scene.yaml:5: solid.bodies[0].solid = [1, 2]: label 2 has no material in solid.bodies[0].materials"},
        {TWO "materials: {1: quartz, 2: clai}", "",
         "scene.yaml:5: solid.bodies[0].materials[1].material = clai: is not a name in solid.materials; did you mean "
         "clay?"},
        {TWO "materials: {1: quartz, 2: clay, 1: clay}", "",
         "scene.yaml:5: solid.bodies[0].materials[2].label = 1: has a material already, quartz"},
        {TWO "materials: {1: quartz, 2: clay, 3: clay}", "",
         "solid.bodies[0].materials[2].label = 3: is not among the labels of the solid, solid.bodies[0].solid"},
        {TWO "materials: {1: quartz, two: clay}", "",
         "solid.bodies[0].materials[1].label = two: must be a whole number"},
        {TWO "materials: {1: quartz, 2: [clay]}", "", "solid.bodies[0].materials[1].material = [clay]: must be a text"},
        {TWO "materials: quartz", "", "solid.bodies[0].materials = quartz: must be a list of mappings"},
        {TWO "materials: {1: quartz, 2: clay}, material: clay", "",
         "solid.bodies[0].material = clay: not together with materials"},
        {TWO "materials: {1: quartz, 2: ore}", "",
         "materials[1].material = ore: in a body of several materials each needs micromodulus: constant"},
        {TWO "materials: {1: quartz, 2: wide}", "",
         "materials[1].material = wide: has a horizon_ratio of 4, and quartz of 3: a body of several materials needs "
         "one"},
        {TWO "materials: {1: paste, 2: quartz}", "",
         "materials[0].material = paste: in a body of several materials each must be brittle; it has the bilinear law"},
        {TWO "materials: {1: quartz, 2: grain}", "",
         "materials[1].material = grain: in a body of several materials each must have a constant limit of the "
         "stretch"},
        {TWO "materials: {1: quartz, 2: clay}", "  partial_volume: ramp_cut\n",
         "several materials need solid.partial_volume: exact"},
        {TWO
         "materials: {1: quartz, 2: clay}}, {name: base, material: clay, shape: box, low: [0.003, 0.002, 0.008], high: "
         "[0.016, 0.011, 0.009]",
         "  interfaces: [{between: [body1, base], fracture_energy: 3}]\n",
         "several materials do not go with an interface of the body, solid.interfaces[0]"},
        {RAW "file: sample.raw, solid: [1, 7], materials: {1: quartz, 7: clay}", "",
         "solid.bodies[0].solid: label 7 does not occur in"}};
    materials = MINERALS;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        more = table[i].more;
        check_refused(table[i].keys, 1, table[i].sentence);
    }
    materials = QUARTZ;
    more = "";
}

/* Of a fluid's scene: the surface of an image is found from the lattice only. */
static void surface(void **state) {
    (void)state;
    static const char *const set[] = {
        "solid.bodies.ball={name: ball, material: glass, shape: image, file: " FOLDER
        "/ball.raw, size: [16, 16, 16], type: uint8, voxel: 1.0e-3, low: [0, 0, 0], solid: [1]}",
        "coupling.surface=shape"};
    char said[4096];
    assert_int_equal(leaves(make_solid,
                            &(struct leaves_scene){FRANA_SOURCE_DIR "/tests/scene/scenes/coupled.yaml", 2, set}, said,
                            sizeof said),
                     EXIT_CODE_SCENE);
    assert_non_null(strstr(said, "coupling.surface = shape: does not go with a body of shape image"));
}

/* Of a fluid's scene: a body of one material that is all solid has the wrong labels. Named minerals may be dense. */
static void dense(void **state) {
    (void)state;
    static const char *const set[] = {
        "solid.bodies.ball={name: ball, material: glass, shape: image, file: " FOLDER
        "/sample.raw, size: [13, 9, 7], type: uint8, voxel: 1.0e-3, low: [0, 0, 0], solid: [0, 1, 2]}",
        "solid.bodies.ball={name: ball, shape: image, file: " FOLDER
        "/sample.raw, size: [13, 9, 7], type: uint8, voxel: 1.0e-3, low: [0, 0, 0], solid: [0, 1, 2], materials: {0: "
        "glass, 1: glass, 2: glass}}"};
    static const char *const said_of[] = {"solid.bodies[1].solid: leaves no pore in", ""};
    for (int i = 0; i < 2; i++) {
        char said[4096];
        const int code =
            leaves(make_solid, &(struct leaves_scene){FRANA_SOURCE_DIR "/tests/scene/scenes/coupled.yaml", 1, &set[i]},
                   said, sizeof said);
        if (!strstr(said, said_of[i]) || (code == 0) != (i == 1)) fail_msg("%d: %s", code, said);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(refused), cmocka_unit_test(refused_materials),
                                       cmocka_unit_test(surface), cmocka_unit_test(dense)};
    const int failed = cmocka_run_group_tests(tests, write_all, NULL);
    par_end();
    return failed;
}
