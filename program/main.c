/* Program entry: calls the command that the command line names. */
#include "base/die.h"
#include "base/par.h"
#include "bench/bench.h"
#include "coupling/setup/setup.h"
#include "postproc/post.h"
#include "program/command.h"
#include "program/program.h"
#include "program/record.h"
#include "scene/scene.h"
#include "study/study.h"

#include <stdio.h>
#include <string.h>

static int post(const struct command *c) {
    if (par_rank() != 0) return EXIT_CODE_DONE;
    const int quantity = c->film_quantity ? postproc_options_quantity(c->film_quantity) : POSTPROC_DAMAGE;
    if (quantity < 0)
        die(EXIT_CODE_SCENE, "--film=%s: must be damage, stretch, energy, displacement_x or displacement_y",
            c->film_quantity);
    const struct postproc_options options = {
        .film = c->film, .film_quantity = (enum postproc_quantity)quantity, .level = c->level, .magnify = c->magnify};
    int code = EXIT_CODE_DONE;
    for (int k = 0; k < c->files && code == EXIT_CODE_DONE; k++) code = postproc_post(c->file[k], &options);
    if (c->files > 1 && code == EXIT_CODE_DONE)
        code = postproc_compare(c->files, c->file, c->out[0] ? c->out : "runs/compared");
    return code;
}

static void say_version(void) {
    char text[2048];
    record_version(text, sizeof text);
    fputs(text, stdout);
}

static int with_scene(const struct command *c) {
    struct scene *scene = scene_new(c->file[0], c->sets, c->set);
    setup_check(scene);
    const int code = c->verb == COMMAND_RUN ? program_run(c, scene) : check_scene(scene);
    scene_free(scene);
    return code;
}

int main(int argc, char **argv) {
    /* a study starts mpiexec, which a process that is a rank itself cannot */
    if (argc < 2 || strcmp(argv[1], "study")) par_begin(&argc, &argv);
    struct command *c = command_new(argc, argv);
    int code = EXIT_CODE_DONE;
    switch (c->verb) {
    case COMMAND_RUN:
    case COMMAND_CHECK:
        code = with_scene(c);
        break;
    case COMMAND_POST:
        code = post(c);
        break;
    case COMMAND_BENCH:
        code = bench_run(c);
        break;
    case COMMAND_STUDY:
        code = study_run(&(struct study_options){c->file[0], c->out[0] ? c->out : NULL, c->fresh});
        break;
    case COMMAND_VERSION:
        if (par_rank() == 0) say_version();
        break;
    case COMMAND_HELP:
        if (par_rank() == 0) fputs(command_usage(), stdout);
        break;
    }
    command_free(c);
    par_end();
    return code;
}
