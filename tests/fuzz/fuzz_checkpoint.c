/* Fuzz target: a changed checkpoint must be detected, an unchanged one must be read. */
/* A damaged checkpoint. The first byte chooses a scene and the meaning of the others: the file itself, its bytes after
 * a good file's end, or inverted bits, with three bytes of position and one of bits each. Every change must be
 * detected, and an unchanged file must be read. */
#include "coupling/step.h"
#include "base/files/folder.h"
#include "program/output/checkpoint.h"
#include "scene/read.h"
#include "tests/fuzz/fuzz.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const text[] = {
    "domain: {size: [0.008, 0.008, 0.008], cells: [8, 8, 8]}\n"
    "fluid: {density: 1000, viscosity: 1.0e-4, sides: {y_low: {type: wall}, y_high: {type: wall}, x_low: "
    "{type: periodic}, "
    "x_high: {type: periodic}, z_low: {type: periodic}, z_high: {type: periodic}}}\n"
    "solid:\n  materials: [{name: m, youngs_modulus: 1.0e6, density: 2000, horizon_ratio: 2}]\n"
    "  bodies: [{shape: box, low: [0.002, 0, 0], high: [0.004, 0.002, 0.002]}]\n"
    "stages: [{name: settle, steps: 9, time_step: 1.0e-6}]\n",
    "domain: {size: [0.006, 0.006]}\n"
    "solid:\n  spacing: 0.001\n  model: plane_stress\n  thickness: 0.001\n"
    "  materials: [{name: m, youngs_modulus: 1.0e9, density: 2000, fracture_energy: 10}]\n"
    "  bodies: [{shape: rectangle, low: [0, 0], high: [0.006, 0.006]}]\n"
    "  refinement: {levels: 1, damage: 0.1, start: [{low: [0, 0], high: [0.002, 0.002], level: 1}]}\n"
    "stages: [{name: pull, steps: 9, time_step: 1.0e-8}]\n"};

enum { SCENES = 2 };

struct written {
    struct scene *scene;
    struct run *run;
    uint8_t *file;
    size_t bytes;
    int was_read; /* as it is: once is enough */
};

static struct written written[SCENES];

static void keep_file(struct written *w, const char *path) {
    FILE *in = fopen(path, "rb");
    fuzz_expect(in && !fseek(in, 0, SEEK_END), "there is no checkpoint");
    w->bytes = (size_t)ftell(in);
    w->file = malloc(w->bytes);
    rewind(in);
    fuzz_expect(w->file && fread(w->file, 1, w->bytes, in) == w->bytes, "the checkpoint cannot be read");
    fclose(in);
}

static void write_one(struct written *w, const char *scene, const char *folder) {
    char path[FOLDER_PATH];
    struct scene_problems problems = {0};
    w->scene = scene_read("scene.yaml", scene, strlen(scene), 0, NULL, 0, &problems);
    fuzz_expect(w->scene != NULL, problems.n ? problems.text[0] : "");
    w->run = run_new(w->scene);
    step_begin_stage(w->run);
    for (int k = 0; k < 2; k++) step_advance(w->run);
    checkpoint_write(w->run, folder);
    keep_file(w, folder_path(path, folder, "checkpoint/step_00000002.h5"));
    folder_clear(folder);
}

static void write_good(void) {
    char folder[] = "/tmp/fuzz_checkpoint_XXXXXX", path[FOLDER_PATH];
    static const char *const in[] = {"checkpoint/latest", "checkpoint", "fields", "."};
    fuzz_expect(mkdtemp(folder) != NULL, "no folder can be made in /tmp");
    folder_make(folder);
    for (int k = 0; k < SCENES; k++) write_one(&written[k], text[k], folder);
    for (int k = 0; k < 4; k++) remove(k < 3 ? folder_path(path, folder, in[k]) : folder);
}

struct reading {
    struct run *run;
    const char *path;
};

static void read_one(void *what) {
    struct reading *r = what;
    checkpoint_read(r->run, NULL, r->path);
}

/* The file that the input means; malloc'ed. */
static uint8_t *file_of(const struct written *w, int mode, const uint8_t *data, size_t bytes, size_t *size) {
    *size = mode == 0 ? bytes : w->bytes;
    uint8_t *file = malloc(*size + 1);
    memcpy(file, mode == 0 ? data : w->file, *size);
    for (; mode > 0 && bytes >= 4; data += 4, bytes -= 4) {
        const size_t at = (size_t)(data[0] | data[1] << 8 | data[2] << 16) % w->bytes;
        if (mode == 1) *size = at;
        if (mode == 2) file[at] ^= data[3];
    }
    return file;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t bytes) {
    if (!written[0].run) write_good();
    if (bytes == 0) return 0;
    struct written *w = &written[data[0] & 1];
    size_t size;
    uint8_t *file = file_of(w, (data[0] >> 1) % 3, data + 1, bytes - 1, &size);
    const int same = size == w->bytes && !memcmp(file, w->file, size);
    if (same && w->was_read++) {
        free(file);
        return 0;
    }
    struct reading r = {w->run, fuzz_file(file, size)};
    free(file);
    const int code = fuzz_read(read_one, &r);
    fuzz_expect(same || code != 0, "a changed checkpoint is taken for good");
    fuzz_expect(!same || code == 0, "a good checkpoint is refused");
    return 0;
}
