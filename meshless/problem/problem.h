/* Scenes that are solved at once and not stepped through stages. A kind of them is a file of this folder and a line in
 * the table of kinds.h. */
#pragma once
#include "base/files/json.h"
#include "scene/scene.h"

/* A part of the work, timed by its name in run.json. Collective. */
struct meshless_problem_phase {
    const char *name;
    void (*run)(void *problem);
};

struct meshless_problem {
    const char *file[4];                        /* names in the run folder beside solution.csv, up to NULL */
    int (*is_asked)(const struct scene *scene); /* whether the scene asks for this kind. Not collective, pure */
    void *(*new)(const struct scene *scene);    /* its problem, before any phase. Collective */
    /* Phases in turn, up to one without a name. The first `checked` of them find the mistakes of the scene (exit 2) and
     * write nothing: frana check runs these alone, frana run before it makes the folder. */
    const struct meshless_problem_phase *phase;
    int checked;
    /* Prints what is known after these: unknowns, constraints, memory. Lines "  name  value\n". Rank 0 only prints.
     * Collective */
    void (*check)(const void *problem);
    /* Files: solution.csv (solution.h), fields/solution.hdf if output.fields_every is not 0, others. Collective */
    void (*write)(const void *problem, const struct scene *scene, const char *folder);
    void (*write_json)(const void *problem, struct json *j); /* members of run.json. Rank 0 */
    void (*free)(void *problem);
};

/* The names of all files count as those of a run (base/files/folder.h). Not collective. */
void meshless_problem_own_files(void);
/* The kind that the scene asks for; NULL: the scene is stepped. Not collective. */
const struct meshless_problem *meshless_problem_of(const struct scene *scene);
