/* Fuzz target: a study's file. */
#include "base/arena.h"
#include "program/study/file/file.h"
#include "tests/fuzz/fuzz.h"

static const char path[] = FRANA_SOURCE_DIR "/cases/bar/study.yaml"; /* scene.yaml is there */

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t bytes) {
    struct scene_problems problems = {0};
    struct study *s = study_file_parse(path, (const char *)data, bytes, &problems);
    fuzz_expect((s == NULL) == (problems.n > 0), "refused without a sentence, or accepted with one");
    if (s) {
        fuzz_expect(s->methods.n > 0 && s->levels.n > 0 && s->quantities > 0, "an empty study is accepted");
        fuzz_expect(s->ranks > 0 && s->repeats > 0, "a study of nothing is accepted");
    }
    scene_problem_free(&problems);
    arena_free();
    return 0;
}
