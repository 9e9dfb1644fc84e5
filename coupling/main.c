#include "base/error.h"
#include "base/par.h"
#include "base/scene.h"
#include "bench/bench.h"
#include "coupling/command.h"
#include "coupling/program.h"
#include "coupling/record.h"
#include "postproc/post.h"

#include <stdio.h>

static int post(const struct command *c) {
    if (par_rank() != 0) return EXIT_CODE_DONE;
    int code = EXIT_CODE_DONE;
    for (int k = 0; k < c->files && code == EXIT_CODE_DONE; k++) code = postproc_run(c->file[k]);
    if (c->files > 1 && code == EXIT_CODE_DONE)
        code = postproc_compare(c->files, c->file, c->out[0] ? c->out : "runs/compared");
    return code;
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    struct command *c = command_new(argc, argv);
    int code = EXIT_CODE_DONE;
    if (c->verb == COMMAND_RUN || c->verb == COMMAND_CHECK) {
        struct scene *scene = scene_new(c->file[0], c->sets, c->set);
        code = c->verb == COMMAND_RUN ? program_run(c, scene) : program_check(scene);
        scene_free(scene);
    } else if (c->verb == COMMAND_POST) {
        code = post(c);
    } else if (c->verb == COMMAND_BENCH) {
        code = bench_run(c);
    } else if (par_rank() == 0) {
        char text[2048];
        record_version(text, sizeof text);
        fputs(c->verb == COMMAND_VERSION ? text : command_usage(), stdout);
    }
    command_free(c);
    par_end();
    return code;
}
