/* The kinds of scenes that are solved at once. */
#include "meshless/problem/problem.h"
#include "base/files/folder.h"
#include "meshless/problem/kinds.h"

#include <stddef.h>

static const struct meshless_problem *const kind[] = {
#define LINE(name) &meshless_problem_##name,
    MESHLESS_PROBLEMS(LINE)
#undef LINE
};

void meshless_problem_own_files(void) {
    for (size_t k = 0; k < sizeof kind / sizeof *kind; k++)
        for (const char *const *file = kind[k]->file; *file; file++) folder_own(*file);
}

const struct meshless_problem *meshless_problem_of(const struct scene *scene) {
    for (size_t k = 0; k < sizeof kind / sizeof *kind; k++)
        if (kind[k]->is_asked(scene)) return kind[k];
    return NULL;
}
