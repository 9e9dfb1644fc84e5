/* Loads the scene on rank 0, reports its mistakes, and gives the resolved text to all ranks. */
#include "scene/scene.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/par.h"
#include "scene/read.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { BYTES_MAX = 16 << 20 };

/* The whole file, malloc'ed; NULL and a problem if it cannot be read. */
static char *text_of(const char *path, size_t *bytes, struct scene_problems *problems) {
    struct stat info;
    problems->file = path;
    *bytes = 0;
    if (stat(path, &info) == 0 && !S_ISREG(info.st_mode)) { /* one would wait for a pipe */
        scene_problem_line(problems, 0, "the scene cannot be read: %s",
                           S_ISDIR(info.st_mode) ? strerror(EISDIR) : "it is not a file");
        return NULL;
    }
    FILE *in = fopen(path, "rb");
    char *text = in ? malloc(BYTES_MAX + 1) : NULL;
    const int fault = errno;
    errno = 0;
    if (text) *bytes = fread(text, 1, BYTES_MAX + 1, in);
    if (!text || errno != 0)
        scene_problem_line(problems, 0, "the scene cannot be read: %s",
                           !in     ? strerror(fault)
                           : !text ? "no memory left"
                                   : strerror(errno));
    else if (*bytes > BYTES_MAX)
        scene_problem_line(problems, 0, "the scene is larger than %d MB", BYTES_MAX >> 20);
    if (in) fclose(in);
    if (problems->n == 0) return text;
    free(text);
    return NULL;
}

/* Rank 0 reads the file and resolves it; the other ranks read the resolved text, with all defaults and absolute
 * paths. */
struct scene *scene_new(const char *path, int n, const char *const *set) {
    struct scene_problems problems = {0};
    struct scene *s = NULL;
    long bytes = -1; /* of the resolved text; -1: the scene has mistakes */
    if (par_rank() == 0) {
        size_t file_bytes;
        char *text = text_of(path, &file_bytes, &problems);
        if (text) s = scene_read(path, text, file_bytes, n, set, 1, &problems);
        free(text);
        scene_problem_print(&problems);
        if (s) bytes = (long)strlen(s->resolved);
    }
    par_bcast(&bytes, sizeof bytes, 0);
    if (bytes < 0) {
        scene_problem_free(&problems);
        par_end();
        exit(EXIT_CODE_SCENE);
    }
    char *resolved = s ? s->resolved : malloc((size_t)bytes + 1);
    if (!resolved) die(EXIT_CODE_FILE, "no memory left for the scene");
    par_bcast(resolved, (size_t)bytes + 1, 0);
    if (!s) {
        s = scene_read(path, resolved, (size_t)bytes, 0, NULL, 0, &problems);
        ENSURE(s, "the resolved scene is refused: %s", problems.n ? problems.text[0] : "");
        free(resolved);
    }
    scene_problem_free(&problems);
    return s;
}

void scene_free(struct scene *s) { scene_read_free(s); }
