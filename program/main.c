/* Program entry: calls the command that the command line names. */
#include "base/clock.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/launcher.h"
#include "base/par.h"
#include "base/print.h"
#include "base/signals.h"
#include "program/bench/bench.h"
#include "coupling/setup/setup.h"
#include "meshless/problem/problem.h"
#include "postproc/post.h"
#include "program/calibrate/calibrate.h"
#include "program/check/check.h"
#include "program/command/command.h"
#include "program/init.h"
#include "program/permeability.h"
#include "program/run/run.h"
#include "program/output/build_info.h"
#include "program/output/outputs.h"
#include "program/run/resume.h"
#include "program/run/solve.h"
#include "program/check/speed.h"
#include "program/command/usage.h"
#include "scene/keys/describe.h"
#include "scene/scene.h"
#include "program/study/study.h"

#include <errno.h>
#include <lapacke.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

static int post(const struct command *c) {
    if (par_rank() != 0) return EXIT_CODE_DONE;
    const int quantity = c->film_quantity ? postproc_options_quantity(c->film_quantity) : POSTPROC_DAMAGE;
    if (quantity < 0)
        die(EXIT_CODE_SCENE,
            "--film=%s: must be damage, stretch, energy, displacement_x or displacement_y of a plate; damage, flow, "
            "speed or pressure in space; aperture or crack_pressure of cracks with fluid",
            c->film_quantity);
    const struct postproc_options options = {.film = c->film,
                                             .film_quantity = (enum postproc_quantity)quantity,
                                             .film_named = c->film_quantity != NULL,
                                             .sliced = {c->sliced[0], c->sliced[1], c->sliced[2]},
                                             .slice = {c->slice[0], c->slice[1], c->slice[2]},
                                             .level = c->level,
                                             .magnify = c->magnify,
                                             .before = c->before};
    int code = EXIT_CODE_DONE;
    signals_begin(0);
    signals_at_once(2); /* nothing that is not finished is kept */
    for (int k = 0; k < c->files && code == EXIT_CODE_DONE; k++) code = postproc_post(c->file[k], &options);
    if (c->files > 1 && code == EXIT_CODE_DONE)
        code = postproc_compare(c->files, c->file, c->out[0] ? c->out : "runs/compared");
    signals_at_once(0);
    return code;
}

static int bench(const struct command *c) {
    return bench_run(&(struct bench_input){.quick = c->quick,
                                           .repeats = c->repeats,
                                           .only = c->only,
                                           .sizes = c->sizes,
                                           .out = c->out[0] ? c->out : NULL,
                                           .observe = speed_store_step});
}

static struct scene *scene_of(const struct command *c) {
    struct scene *scene = scene_new(c->file[0], c->sets, c->set);
    setup_check(scene);
    return scene;
}

static int run(const struct command *c) {
    struct scene *scene = scene_of(c);
    struct command it = *c;
    int code = EXIT_CODE_DONE;
    if (!c->resume_or_start || resume_or_start(&it, scene))
        code = solve_is(scene) ? solve_run(&it, scene) : program_run(&it, scene);
    scene_free(scene);
    return code;
}

static int permeability(const struct command *c) {
    struct scene *scene = scene_of(c);
    if (solve_is(scene))
        die_all(EXIT_CODE_SCENE,
                "%s: frana permeability needs a scene that is stepped, with a fluid and a solid; this one "
                "is solved at once",
                c->file[0]);
    const int code = permeability_run(c, scene);
    scene_free(scene);
    return code;
}

static int calibrate(const struct command *c) {
    struct scene *scene = scene_of(c);
    const int code = calibrate_run(c, scene);
    scene_free(scene);
    return code;
}

static int check(const struct command *c) {
    struct scene *scene = scene_of(c);
    const int code = solve_is(scene) ? solve_check(scene) : check_scene(c, scene);
    scene_free(scene);
    return code;
}

static int version(void) {
    char text[2048];
    build_info_text(text, sizeof text);
    print("%s", text);
    return EXIT_CODE_DONE;
}

/* Runs the command that the command line names; the exit code. Collective. */
static int run_command(const struct command *c) {
    switch (c->verb) {
    case COMMAND_RUN:
        return run(c);
    case COMMAND_CHECK:
        return check(c);
    case COMMAND_POST:
        return post(c);
    case COMMAND_BENCH:
        return bench(c);
    case COMMAND_STUDY:
        return study_run(&(struct study_options){c->file[0], c->out[0] ? c->out : NULL, c->fresh, c->task, c->number,
                                                 c->results, c->quick});
    case COMMAND_PERMEABILITY:
        return permeability(c);
    case COMMAND_CALIBRATE:
        return calibrate(c);
    case COMMAND_VERSION:
        return version();
    case COMMAND_INIT:
        return init_scene(c->files > 0 ? c->file[0] : NULL, c->files > 1 ? c->file[1] : ".");
    case COMMAND_SCHEMA:
        scene_describe_schema(stdout);
        return EXIT_CODE_DONE;
    case COMMAND_KEYS:
        if (scene_describe_keys(stdout, c->files > 0 ? c->file[0] : "") == 0)
            die_all(EXIT_CODE_SCENE, "keys %s: no key begins so; frana keys lists all", c->file[0]);
        return EXIT_CODE_DONE;
    case COMMAND_HELP:
        if (c->is_missing) {
            usage_print(stderr);
            return EXIT_CODE_SCENE;
        }
        if (par_rank() == 0 && c->about == COMMAND_HELP) usage_print(stdout);
        if (par_rank() == 0 && c->about != COMMAND_HELP) usage_print_command(stdout, c->about);
        return EXIT_CODE_DONE;
    }
    ENSURE(0, "no command of number %d", (int)c->verb);
    return EXIT_CODE_SCENE;
}

/* Whether the command needs MPI: a study starts mpiexec, which a process that is itself an MPI rank cannot do; others
 * only print, for a shell's completion also. */
static int needs_ranks(int argc, char **argv) {
    static const char *const alone[] = {"study", "init", "schema", "keys", "help", "--help", "-h"};
    for (size_t k = 0; argc > 1 && k < sizeof alone / sizeof *alone; k++)
        if (!strcmp(argv[1], alone[k])) return 0;
    return argc > 1;
}

/* MPI crashes on a stack of 128 kB. */
static void check_stack(void) {
    enum { LEAST = 1 << 20 };
    struct rlimit stack;
    if (getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur == RLIM_INFINITY || stack.rlim_cur >= LEAST) return;
    die_all(EXIT_CODE_SCENE, "the stack is limited to %lu kB, at least %d are needed: ulimit -s 8192",
            (unsigned long)stack.rlim_cur >> 10, LEAST >> 10);
}

/* MPI takes some 150 MB of addresses. OpenBLAS takes 128 MB at its first product, and tries for ever if the process may
 * not have them (ulimit -v): with such a limit it takes them at once. */
static void check_memory(void) {
    enum { LEAST = 3 << 27 };
    struct rlimit space;
    if (getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY) return;
    void *all = malloc(LEAST);
    if (!all)
        die_all(EXIT_CODE_FILE, "no memory left for %d MB of the libraries: the limit is %lu kB (ulimit -v)",
                LEAST >> 20, (unsigned long)space.rlim_cur >> 10);
    free(all);
    double matrix[] = {4, 2, 2, 3};
    ENSURE(LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'U', 2, matrix, 2) == 0, "two rows");
}

/* A run goes on when its screen is gone; a command that only prints has then failed. */
static int end_print(const struct command *c, int code) {
    const enum command_verb verb = c->verb;
    const int fault = fflush(stdout) != 0 ? errno : ferror(stdout) ? EIO : 0;
    const int prints = verb == COMMAND_CHECK || verb == COMMAND_SCHEMA || verb == COMMAND_KEYS ||
                       verb == COMMAND_VERSION || verb == COMMAND_HELP || verb == COMMAND_INIT ||
                       (verb == COMMAND_STUDY && c->task == STUDY_LIST);
    if (!fault || !prints || code != EXIT_CODE_DONE) return code;
    fprintf(stderr, "frana: the output cannot be written: %s\n", strerror(fault));
    return EXIT_CODE_FILE;
}

int main(int argc, char **argv) {
    clock_phase(CLOCK_PHASE_LAUNCH);
    if (needs_ranks(argc, argv)) {
        check_stack();
        check_memory();
        par_begin(&argc, &argv);
        launcher_check();
    }
    clock_phase(CLOCK_PHASE_SCENE);
    struct command *c = command_new(argc, argv);
    outputs_own_files();
    meshless_problem_own_files();
    const int code = end_print(c, run_command(c));
    command_free(c);
    par_end();
    return code;
}
