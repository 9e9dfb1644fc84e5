/* Loads a scene and reports its number of stages; scene_leave.sh runs it on several ranks. */
#include "base/par.h"
#include "scene/scene.h"

#include <stdio.h>

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    struct scene *s = scene_new(argv[1], argc - 2, (const char *const *)argv + 2);
    if (par_rank() == 0) fprintf(stderr, "frana: %d stages\n", s->stages);
    scene_free(s);
    par_end();
    return 0;
}
