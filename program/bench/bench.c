/* frana bench: chooses the parts to measure and runs them. */
#include "program/bench/bench.h"
#include "base/die.h"
#include "program/bench/parts.h"

#include <stdlib.h>
#include <string.h>

static void growth(struct bench *bench) {
    bench_fluid_growth(bench);
    bench_solid_growth(bench);
}

static void image(struct bench *bench) {
    bench_solid_image(bench);
    bench_memory_image(bench);
}

static const struct {
    const char *name;
    void (*measure)(struct bench *b);
    int asked_only; /* 1: measured only if named by --only */
} part[] = {{"limits", bench_limits, 0},
            {"fluid", bench_fluid, 0},
            {"solid", bench_solid, 0},
            {"image", image, 0},
            {"immersed", bench_immersed, 0},
            {"memory", bench_memory, 0},
            {"growth", growth, 0},
            {"cracks", bench_cracks, 0},
            {"precision", bench_solid_precision, 0},
            {"dilated", bench_solid_dilated, 0},
            {"peer", bench_solid_peer, 1}};
enum { PARTS = sizeof part / sizeof *part };

/* Whether the comma-separated list contains the word. */
static int holds(const char *list, const char *word) {
    const size_t length = strlen(word);
    for (const char *at = list; at; at = strchr(at, ','), at = at ? at + 1 : NULL)
        if (!strncmp(at, word, length) && (at[length] == ',' || at[length] == '\0')) return 1;
    return 0;
}

/* Checks that every word of --only is the name of a part. */
static void check_only(const char *list) {
    for (const char *at = list; at; at = strchr(at, ','), at = at ? at + 1 : NULL) {
        const int length = (int)strcspn(at, ",");
        int found = 0;
        for (int k = 0; k < PARTS; k++)
            found |= (int)strlen(part[k].name) == length && !strncmp(at, part[k].name, (size_t)length);
        if (!found)
            die_all(EXIT_CODE_SCENE,
                    "--only %.*s: must be of limits, fluid, solid, image, immersed, memory, growth, cracks, precision, "
                    "dilated and peer",
                    length, at);
    }
}

/* Parses "128x64x64,38": cells of a channel, particles along a side of a block. */
static struct bench_size *sizes_of(const char *list, int *n) {
    struct bench_size *size = calloc(strlen(list) + 1, sizeof *size);
    *n = 0;
    for (const char *at = list; at; at = strchr(at, ','), at = at ? at + 1 : NULL) {
        const int length = (int)strcspn(at, ",");
        struct bench_size s = {0};
        int used = 0, cells[3];
        if (sscanf(at, "%dx%dx%d%n", &cells[0], &cells[1], &cells[2], &used) == 3 && used == length)
            memcpy(s.cells, cells, sizeof cells);
        else if (sscanf(at, "%d%n", &s.side, &used) != 1 || used != length)
            s.side = 0;
        const int is_box = s.cells[0] > 1 && s.cells[1] > 1 && s.cells[2] > 1;
        if (!is_box && (s.side < 1 || s.cells[0] || s.side > 1000))
            die_all(EXIT_CODE_SCENE,
                    "--sizes %.*s: must be cells like 128x64x64, or particles along a block's side like 38", length,
                    at);
        size[(*n)++] = s;
    }
    return size;
}

int bench_run(const struct bench_input *in) {
    struct bench b = {.quick = in->quick,
                      .repetition = {in->repeats, in->quick ? 0.005 : 0.15},
                      .observe = in->quick ? NULL : in->observe};
    struct bench_size *size = NULL;
    if (b.repetition.repeats > BENCH_REPEATS_MAX)
        die_all(EXIT_CODE_SCENE, "--repeats %d: must be 5 to %d", in->repeats, BENCH_REPEATS_MAX);
    if (in->only) check_only(in->only);
    if (in->sizes) b.size = size = sizes_of(in->sizes, &b.sizes);
    bench_row_begin(&b.table, in->out);
    b.table.limits = bench_limits_measure(&b.repetition, b.quick ? 1 << 20 : 1 << 23);
    for (int k = 0; k < PARTS; k++)
        if (in->only ? holds(in->only, part[k].name) : !part[k].asked_only) part[k].measure(&b);
    bench_row_end(&b.table);
    free(size);
    return EXIT_CODE_DONE;
}
