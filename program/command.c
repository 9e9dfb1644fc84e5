/* Parses the command line. */
#include "program/command.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/threads.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *command_usage(void) {
    return "usage:\n"
           "  frana run   SCENE.yaml [--out DIR] [--set key.path=value]... [--resume[=FILE] | --resume-or-start]\n"
           "              [--max-wall HH:MM:SS] [--quiet]\n"
           "  frana check SCENE.yaml [--out DIR] [--set key.path=value]...\n"
           "  frana permeability SCENE.yaml [--out DIR] [--set key.path=value]... [--max-wall HH:MM:SS] [--quiet] "
           "[--fresh]\n"
           "  frana calibrate SCENE.yaml [--out DIR] [--set key.path=value]... [--max-wall HH:MM:SS] [--quiet] "
           "[--fresh] [--quick]\n"
           "              [--only PART,...]\n"
           "  frana post  RUNDIR... [--out DIR] [--film[=QUANTITY]] [--slice x=PLACE]... [--level DAMAGE]\n"
           "              [--magnify FACTOR]\n"
           "  frana study STUDY.yaml [--out DIR] [--fresh] [--list | --run NUMBER | --collect]\n"
           "  frana bench [--quick] [--only PART,...] [--sizes 128x64x64,38,...] [--repeats N] [--out DIR]\n"
           "  frana bench --table=performance|growth TABLE.csv... [RUN.json...]\n"
           "  frana --version\n"
           "run, check, permeability, calibrate and bench under mpiexec -n N where they should run in parallel, with\n"
           "[--threads N] on several cores a rank.\n";
}

static const double LONGEST = 1e9; /* of --max-wall, s */

/* Seconds from HH:MM:SS, MM:SS or seconds. */
static double seconds_of(const char *text) {
    double total = 0;
    const char *at = text;
    for (int field = 0; field < 3; field++) {
        char *end;
        const double value = strtod(at, &end);
        if (end == at || value < 0 || (field > 0 && value >= 60)) break;
        total = 60 * total + value;
        if (*end == '\0' && total > 0 && total <= LONGEST) return total;
        if (*end != ':') break;
        at = end + 1;
    }
    die_all(EXIT_CODE_SCENE, "--max-wall %s: must be HH:MM:SS, more than nothing and at most %g s", text, LONGEST);
}

static enum command_verb verb_of(const char *word) {
    static const struct {
        const char *word;
        enum command_verb verb;
    } verb[] = {{"run", COMMAND_RUN},
                {"check", COMMAND_CHECK},
                {"post", COMMAND_POST},
                {"bench", COMMAND_BENCH},
                {"study", COMMAND_STUDY},
                {"--version", COMMAND_VERSION},
                {"permeability", COMMAND_PERMEABILITY},
                {"calibrate", COMMAND_CALIBRATE},
                {"--help", COMMAND_HELP},
                {"-h", COMMAND_HELP},
                {"help", COMMAND_HELP}};
    for (size_t k = 0; k < sizeof verb / sizeof *verb; k++)
        if (!strcmp(word, verb[k].word)) return verb[k].verb;
    die_all(
        EXIT_CODE_SCENE,
        "%s: unknown command; there are run, check, post, bench, study, permeability, calibrate, --version and --help",
        word);
}

/* above/NAME, where NAME is the scene's file name without its ending. */
static void default_out(struct command *c, const char *above) {
    const char *slash = strrchr(c->file[0], '/'), *name = slash ? slash + 1 : c->file[0], *dot = strrchr(name, '.');
    const int length = dot ? (int)(dot - name) : (int)strlen(name);
    snprintf(c->out, sizeof c->out, "%s/%.*s", above, length, name);
}

static int whole(const char *text, const char *name, int least) {
    char *end;
    const long value = strtol(text, &end, 10);
    if (end == text || *end || value < least || value > 1000000)
        die_all(EXIT_CODE_SCENE, "%s %s: must be a whole number, at least %d", name, text, least);
    return (int)value;
}

static enum bench_page table_of(const char *word) {
    if (!strcmp(word, "performance")) return BENCH_PAGE_PERFORMANCE;
    if (!strcmp(word, "growth")) return BENCH_PAGE_GROWTH;
    die_all(EXIT_CODE_SCENE, "--table=%s: must be performance or growth", word);
}

static double number(const char *text, const char *name, double below) {
    char *end;
    const double value = strtod(text, &end);
    if (end == text || *end || !(value > 0) || !(value < below))
        die_all(EXIT_CODE_SCENE, "%s %s: must be a number above 0 and below %g", name, text, below);
    return value;
}

/* "y=0.002": the slice across y is there, m. */
static void slice_of(struct command *c, const char *text) {
    const int axis = *text >= 'x' && *text <= 'z' ? *text - 'x' : -1;
    char *end = NULL;
    const double place = axis >= 0 && text[1] == '=' ? strtod(text + 2, &end) : NAN;
    if (!end || end == text + 2 || *end || !isfinite(place))
        die_all(EXIT_CODE_SCENE, "--slice %s: must be a direction and a place in m, as in x=0.002", text);
    c->sliced[axis] = 1;
    c->slice[axis] = place;
}

/* Checks that the option belongs to the command. */
static void check_option(int o, const char *word, enum command_verb verb) {
    const int several = verb == COMMAND_PERMEABILITY || verb == COMMAND_CALIBRATE,
              runs = verb == COMMAND_RUN || several;
    if (strchr("ra", o) && verb != COMMAND_RUN) die_all(EXIT_CODE_SCENE, "%s: goes with frana run only", word);
    if (strchr("wq", o) && !runs)
        die_all(EXIT_CODE_SCENE, "%s: goes with frana run, permeability and calibrate only", word);
    if (o == 's' && !runs && verb != COMMAND_CHECK)
        die_all(EXIT_CODE_SCENE, "%s: goes with frana run, check, permeability and calibrate only", word);
    if (strchr("ilmx", o) && verb != COMMAND_POST) die_all(EXIT_CODE_SCENE, "%s: goes with frana post only", word);
    if (o == 'f' && verb != COMMAND_STUDY && !several)
        die_all(EXIT_CODE_SCENE, "%s: goes with frana study, permeability and calibrate only", word);
    if (o == 'h' && !runs && verb != COMMAND_CHECK && verb != COMMAND_BENCH)
        die_all(EXIT_CODE_SCENE, "%s: goes with frana run, check, permeability, calibrate and bench only", word);
    if (strchr("kn", o) && verb != COMMAND_BENCH && verb != COMMAND_CALIBRATE)
        die_all(EXIT_CODE_SCENE, "%s: goes with frana bench and calibrate only", word);
    if (strchr("uLC", o) && verb != COMMAND_STUDY) die_all(EXIT_CODE_SCENE, "%s: goes with frana study only", word);
    if (strchr("zpt", o) && verb != COMMAND_BENCH) die_all(EXIT_CODE_SCENE, "%s: goes with frana bench only", word);
}

static void start_threads(int threads) {
    if (threads > THREADS_MOST) die_all(EXIT_CODE_SCENE, "--threads %d: at most %d", threads, THREADS_MOST);
    if (!threads_set(threads))
        die_all(EXIT_CODE_SCENE, "--threads %d: this frana was built without OpenMP; its ranks have one thread",
                threads);
}

static void task(struct command *c, enum study_task task) {
    if (c->task != STUDY_ALL && c->task != task)
        die_all(EXIT_CODE_SCENE, "--list, --run and --collect: only one of them");
    c->task = task;
}

static void options(struct command *c, int argc, char **argv) {
    static const struct option option[] = {{"out", required_argument, NULL, 'o'},
                                           {"set", required_argument, NULL, 's'},
                                           {"resume", optional_argument, NULL, 'r'},
                                           {"max-wall", required_argument, NULL, 'w'},
                                           {"quiet", no_argument, NULL, 'q'},
                                           {"fresh", no_argument, NULL, 'f'},
                                           {"quick", no_argument, NULL, 'k'},
                                           {"only", required_argument, NULL, 'n'},
                                           {"sizes", required_argument, NULL, 'z'},
                                           {"repeats", required_argument, NULL, 'p'},
                                           {"table", required_argument, NULL, 't'},
                                           {"film", optional_argument, NULL, 'i'},
                                           {"level", required_argument, NULL, 'l'},
                                           {"magnify", required_argument, NULL, 'm'},
                                           {"slice", required_argument, NULL, 'x'},
                                           {"resume-or-start", no_argument, NULL, 'a'},
                                           {"list", no_argument, NULL, 'L'},
                                           {"run", required_argument, NULL, 'u'},
                                           {"collect", no_argument, NULL, 'C'},
                                           {"threads", required_argument, NULL, 'h'},
                                           {NULL, 0, NULL, 0}};
    opterr = 0;
    for (int o, which; (o = getopt_long(argc, argv, ":", option, &which)) != -1;) {
        const char *word = argv[optind - 1];
        char name[32];
        if (o == ':') die_all(EXIT_CODE_SCENE, "%s: needs a value", word);
        if (o == '?') die_all(EXIT_CODE_SCENE, "%s: unknown option; frana --help lists them", word);
        snprintf(name, sizeof name, "--%s", option[which].name);
        check_option(o, name, c->verb);
        switch (o) {
        case 'o':
            snprintf(c->out, sizeof c->out, "%s", optarg);
            break;
        case 's':
            c->set[c->sets++] = optarg;
            break;
        case 'r':
            c->resume = 1, c->resume_file = optarg;
            break;
        case 'a':
            c->resume_or_start = 1;
            break;
        case 'L':
            task(c, STUDY_LIST);
            break;
        case 'u':
            task(c, STUDY_ONE);
            c->number = whole(optarg, "--run", 1);
            break;
        case 'C':
            task(c, STUDY_COLLECT);
            break;
        case 'w':
            c->max_wall = seconds_of(optarg);
            break;
        case 'q':
            c->quiet = 1;
            break;
        case 'f':
            c->fresh = 1;
            break;
        case 'i':
            c->film = 1, c->film_quantity = optarg;
            break;
        case 'l':
            c->level = number(optarg, "--level", 1);
            break;
        case 'm':
            c->magnify = number(optarg, "--magnify", 1e9);
            break;
        case 'x':
            slice_of(c, optarg);
            break;
        case 'k':
            c->quick = 1;
            break;
        case 'n':
            c->only = optarg;
            break;
        case 'h':
            start_threads(whole(optarg, "--threads", 1));
            break;
        case 'z':
            c->sizes = optarg;
            break;
        case 'p':
            c->repeats = whole(optarg, "--repeats", 5);
            break;
        case 't':
            c->table = table_of(optarg);
            break;
        default:
            ENSURE(0, "no case for the option %s, letter %c", word, o);
        }
    }
}

/* What a command reads. */
static const char *file_of(enum command_verb verb) {
    switch (verb) {
    case COMMAND_RUN:
    case COMMAND_CHECK:
    case COMMAND_PERMEABILITY:
    case COMMAND_CALIBRATE:
        return "scene";
    case COMMAND_POST:
        return "run folder";
    case COMMAND_STUDY:
        return "study";
    case COMMAND_BENCH:
        return "measured table";
    case COMMAND_VERSION:
    case COMMAND_HELP:
        break;
    }
    return "file";
}

/* Checks the arguments after the options. */
static void check_files(const struct command *c, const char *word) {
    if (c->verb == COMMAND_BENCH) {
        if (c->table && c->files == 0) die_all(EXIT_CODE_SCENE, "frana bench --table: of which measured tables?");
        if (!c->table && c->files > 0)
            die_all(EXIT_CODE_SCENE, "frana bench %s: takes files with --table only", c->file[0]);
        return;
    }
    if (c->files == 0) die_all(EXIT_CODE_SCENE, "frana %s: which %s?", word, file_of(c->verb));
    if (c->files > 1 && c->verb != COMMAND_POST)
        die_all(EXIT_CODE_SCENE, "frana %s %s %s: takes one %s", word, c->file[0], c->file[1], file_of(c->verb));
}

struct command *command_new(int argc, char **argv) {
    struct command *c = calloc(1, sizeof *c);
    c->repeats = 7;
    if (argc < 2) {
        c->verb = COMMAND_HELP;
        return c;
    }
    c->verb = verb_of(argv[1]);
    c->set = calloc((size_t)argc, sizeof *c->set);
    if (c->verb == COMMAND_VERSION || c->verb == COMMAND_HELP) return c;
    options(c, argc - 1, argv + 1);
    if (c->fresh && (c->task == STUDY_LIST || c->task == STUDY_COLLECT))
        die_all(EXIT_CODE_SCENE, "--fresh: does not go with --list or --collect, which make no run");
    if (c->resume && c->resume_or_start) die_all(EXIT_CODE_SCENE, "--resume-or-start: does not go with --resume");
    c->file = (const char *const *)(argv + 1 + optind);
    c->files = argc - 1 - optind;
    check_files(c, argv[1]);
    if ((c->verb == COMMAND_RUN || c->verb == COMMAND_PERMEABILITY) && !c->out[0]) default_out(c, "runs");
    if (c->verb == COMMAND_CALIBRATE && !c->out[0]) default_out(c, "calibrations");
    if (c->verb == COMMAND_CHECK && !c->out[0]) default_out(c, "checks");
    return c;
}

void command_free(struct command *c) {
    free(c->set);
    free(c);
}
