/* Fuzz target: a scene's text with --set values; an accepted scene must be accepted again as resolved. */
/* A scene's text; after a byte 1 its settings (--set), each ended by a byte 1. An accepted scene must also be accepted
 * in its resolved form, which the other ranks and a resumed run read. */
#include "scene/read.h"
#include "tests/fuzz/fuzz.h"

#include <stdlib.h>
#include <string.h>

enum { SETS = 8 };

static const char path[] = FRANA_SOURCE_DIR "/tests/scene/scenes/scene.yaml"; /* files it names are there */

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t bytes) {
    char *text = malloc(bytes + 1), *set[SETS] = {0};
    int n = 0;
    memcpy(text, data, bytes);
    text[bytes] = '\0';
    char *end = memchr(text, 1, bytes);
    const size_t length = end ? (size_t)(end - text) : bytes;
    while (end && n < SETS) {
        *end = '\0';
        set[n] = end + 1;
        end = memchr(set[n], 1, bytes - (size_t)(set[n] - text));
        n++;
    }
    if (end) *end = '\0';
    struct scene_problems problems = {0};
    struct scene *s = scene_read(path, text, length, n, (const char *const *)set, 1, &problems);
    fuzz_expect((s == NULL) == (problems.n > 0), "refused without a sentence, or accepted with one");
    scene_problem_free(&problems);
    if (s) {
        problems = (struct scene_problems){0};
        struct scene *again = scene_read(path, s->resolved, strlen(s->resolved), 0, NULL, 0, &problems);
        fuzz_expect(again != NULL, problems.n ? problems.text[0] : "the resolved scene is refused");
        fuzz_expect(!strcmp(again->resolved, s->resolved), "the resolved scene is resolved to another");
        scene_problem_free(&problems);
        scene_free(again);
    }
    scene_free(s);
    free(text);
    return 0;
}
