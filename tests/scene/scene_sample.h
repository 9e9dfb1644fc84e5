/* The sample scenes of tests/scene/scenes, as texts, with one piece of them exchanged for another. */
#pragma once
#include "base/text.h"
#include "scene/read.h"
#include "tests/check.h"

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SCENES FRANA_SOURCE_DIR "/tests/scene/scenes/"

static inline char *sample_text(const char *path) {
    FILE *in = fopen(path, "rb");
    assert_non_null(in);
    char *text = calloc(1, 1 << 18);
    check_above(fread(text, 1, (1 << 18) - 1, in), 0);
    fclose(in);
    return text;
}

/* The text with the first `find` (which must be there) replaced. */
static inline char *sample_with(const char *text, const char *find, const char *replace) {
    const char *at = strstr(text, find);
    if (!at) fail_msg("the sample has no \"%s\"", find);
    return text_new("%.*s%s%s", (int)(at - text), text, replace, at + strlen(find));
}

/* Reads the text as if its file were in the folder of samples. */
static inline struct scene *sample_read(const char *text, int n, const char *const *set,
                                        struct scene_problems *problems) {
    *problems = (struct scene_problems){0};
    return scene_read(SCENES "it.yaml", text, strlen(text), n, set, 1, problems);
}

/* A sample scene by its name, with settings. */
static inline struct scene *read_or_fail(const char *name, int n, const char *const *set) {
    char *path = text_new("%s%s", SCENES, name);
    struct scene *s = scene_new(path, n, set);
    free(path);
    return s;
}

static inline void assert_vector(const double *v, double x, double y, double z) {
    check_equal(v[0], x);
    check_equal(v[1], y);
    check_equal(v[2], z);
}

/* A problem's line with the samples' folder as @/, and without it in front: "it.yaml:3: ..."; malloc'ed. */
static inline char *sample_problem(const struct scene_problems *problems, int i) {
    const char *text = problems->text[i];
    if (!strncmp(text, SCENES, strlen(SCENES))) text += strlen(SCENES);
    return strstr(text, SCENES) ? sample_with(text, SCENES, "@/") : text_new("%s", text);
}

/* Each setting of the sample has its one problem. Settings and problems [n]. */
static inline void sample_check_settings(const char *path, size_t n, const char *const said[][2]) {
    char *text = sample_text(path);
    for (size_t i = 0; i < n; i++) {
        struct scene_problems problems;
        assert_null(sample_read(text, 1, &said[i][0], &problems));
        assert_string_equal(problems.text[0], said[i][1]);
        assert_int_equal(problems.n, 1);
        scene_problem_free(&problems);
    }
    free(text);
}

/* A sample with one piece replaced, and the line that must be reported. */
struct sample_broken {
    const char *sample, *find, *replace, *line;
};

/* Number of samples that do not report exactly their line; these are printed. */
static inline int sample_check_broken(size_t n, const struct sample_broken *table) {
    int wrong = 0;
    for (const struct sample_broken *b = table; b < table + n; b++) {
        char *path = text_new("%s%s.yaml", SCENES, b->sample), *sample = sample_text(path);
        char *text = sample_with(sample, b->find, b->replace);
        struct scene_problems problems;
        struct scene *s = sample_read(text, 0, NULL, &problems);
        char *said = problems.n ? sample_problem(&problems, 0) : text_new("nothing");
        if (problems.n != 1 || strcmp(said, b->line) != 0) {
            fprintf(stderr, "%s: \"%s\" -> \"%s\": %d mistakes:\n", b->sample, b->find, b->replace, problems.n);
            for (int k = 0; k < problems.n; k++) fprintf(stderr, "    %s\n", problems.text[k]);
            fprintf(stderr, "  should be exactly:\n    %s\n", b->line);
            wrong++;
        }
        free(said);
        assert_null(s);
        scene_problem_free(&problems);
        free(text);
        free(sample);
        free(path);
    }
    return wrong;
}
