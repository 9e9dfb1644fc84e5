/* Scenes that are solved at once and not stepped through stages. A kind of them is a file program/solve_NAME.c and a
 * line in the table of program/solve.c. */
#pragma once
#include "base/files/json.h"
#include "program/command.h"
#include "scene/scene.h"

/* A part of the work, timed by its name in run.json. Collective. */
struct solve_phase {
    const char *name;
    void (*run)(void *problem);
};

struct solve_kind {
    int (*is_of)(const struct scene *scene); /* whether the scene asks for this kind. Not collective, pure */
    void *(*new)(const struct scene *scene); /* its problem, before any phase. Collective */
    /* Phases in turn, up to one without a name. The first `before` of them find the mistakes of the scene (exit 2) and
     * write nothing: frana check runs these alone, frana run before it makes the folder. */
    const struct solve_phase *phase;
    int before;
    /* What is known after these: unknowns, constraints, memory. Lines "  name  value\n". Rank 0 only prints. Collective
     */
    void (*check)(const void *problem);
    /* Files: solution.csv (program/solution.h), fields/solution.hdf if output.fields_every is not 0, others. Collective
     */
    void (*write)(const void *problem, const struct scene *scene, const char *folder);
    void (*record)(const void *problem, struct json *j); /* members of run.json. Rank 0 */
    void (*free)(void *problem);
};

extern const struct solve_kind solve_nonlocal, solve_element_free;

int solve_is(const struct scene *scene); /* Not collective. */
/* frana run and frana check of such a scene; the exit code. Collective. */
int solve_run(const struct command *c, const struct scene *scene);
int solve_check(const struct scene *scene);
