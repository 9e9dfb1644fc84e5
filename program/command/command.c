/* Parses the command line. */
#include "program/command/command.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/text.h"
#include "base/threads.h"
#include "program/command/usage.h"
#include "scene/text/problem.h"

#include <getopt.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORDS = 32 };               /* commands, options of a command */
static const double LONGEST = 1e9; /* of --max-wall, s */

/* Days from "D-", hours, minutes and seconds of one to three numbers between colons. Returns 0, or 1 if the text is
 * something else. Behind days the first number is hours, as in Slurm's times. */
static int read_time(const char *at, double *seconds) {
    const size_t days = strspn(at, "0123456789");
    const int has_days = days > 0 && at[days] == '-';
    int fields = 0;
    *seconds = has_days ? 24 * strtod(at, NULL) : 0;
    if (has_days) at += days + 1;
    for (char *end = NULL; fields < 3; at = end + 1) {
        const double value = *at == '-' ? -1 : strtod(at, &end);
        if (value < 0 || end == at || (fields > 0 && value >= 60) || (has_days && fields == 0 && value >= 24)) return 1;
        *seconds = (fields > 0 ? 60 : 1) * *seconds + value;
        fields++;
        if (*end == '\0') break;
        if (*end != ':' || fields == 3) return 1;
    }
    for (; has_days && fields < 3; fields++) *seconds *= 60;
    return 0;
}

static double seconds_of(const char *text) {
    double seconds;
    if (read_time(text, &seconds) || !(seconds > 0) || seconds > LONGEST)
        die_all(EXIT_CODE_SCENE,
                "--max-wall %s: must be D-HH:MM:SS (as in 1-12:00:00), HH:MM:SS, MM:SS or seconds, more than nothing "
                "and at most %g s",
                text, LONGEST);
    return seconds;
}

static const struct usage_command *find_command(const char *word) {
    const struct usage_command *c = usage_command_of(word);
    if (c) return c;
    const char *name[WORDS];
    unsigned all = 0;
    int n = 0;
    for (const struct usage_command *k = usage_command; k->word; k++) {
        all |= 1u << k->verb;
        if (n < WORDS) name[n++] = k->word;
    }
    const char *nearest = scene_problem_nearest(word, n, name);
    if (nearest) die_all(EXIT_CODE_SCENE, "%s: unknown command; did you mean %s? frana help lists all", word, nearest);
    die_all(EXIT_CODE_SCENE, "%s: unknown command; there are %s", word, usage_commands(all));
}

/* above/NAME, where NAME is the scene's file name without its ending. */
static void default_out(struct command *c, const char *above) {
    const char *slash = strrchr(c->file[0], '/'), *name = slash ? slash + 1 : c->file[0], *dot = strrchr(name, '.');
    const int length = dot ? (int)(dot - name) : (int)strlen(name);
    snprintf(c->out, sizeof c->out, "%s/%.*s", above, length, name);
}

static int whole_number(const char *text, const char *name, int least) {
    char *end;
    const long value = strtol(text, &end, 10);
    if (end == text || *end || value < least || value > 1000000)
        die_all(EXIT_CODE_SCENE, "%s %s: must be a whole number, at least %d", name, text, least);
    return (int)value;
}

static double positive_number(const char *text, const char *name, double below) {
    char *end;
    const double value = strtod(text, &end);
    if (end == text || *end || !(value > 0) || !(value < below))
        die_all(EXIT_CODE_SCENE, "%s %s: must be a number above 0 and below %g", name, text, below);
    return value;
}

/* "y=0.002": the slice across y is there, m. */
static void add_slice(struct command *c, const char *text) {
    const int axis = *text >= 'x' && *text <= 'z' ? *text - 'x' : -1;
    char *end = NULL;
    const double place = axis >= 0 && text[1] == '=' ? strtod(text + 2, &end) : NAN;
    if (!end || end == text + 2 || *end || !isfinite(place))
        die_all(EXIT_CODE_SCENE, "--slice %s: must be a direction and a place in m, as in x=0.002", text);
    c->sliced[axis] = 1;
    c->slice[axis] = place;
}

/* Checks that the option belongs to the command. */
static void check_option(const struct usage_option *o, enum command_verb verb) {
    if (o->commands & 1u << verb) return;
    die_all(EXIT_CODE_SCENE, "--%s: goes with frana %s only", o->name, usage_commands(o->commands));
}

static void start_threads(int threads) {
    if (threads > THREADS_MAX) die_all(EXIT_CODE_SCENE, "--threads %d: at most %d", threads, THREADS_MAX);
    if (!threads_set(threads))
        die_all(EXIT_CODE_SCENE, "--threads %d: this frana was built without OpenMP; its ranks have one thread",
                threads);
}

static void set_task(struct command *c, enum study_task task) {
    if (c->task != STUDY_ALL && c->task != task)
        die_all(EXIT_CODE_SCENE, "--list, --run and --collect: only one of them");
    c->task = task;
}

/* An option that is not known, or the beginning of several. */
static _Noreturn void unknown_option(const char *word, const struct usage_command *usage) {
    const char *name[WORDS], *start = word + strspn(word, "-");
    int n = 0;
    for (const struct usage_option *o = usage_option; o->name; o++)
        if (o->commands & 1u << usage->verb && n < WORDS) name[n++] = o->name;
    char *stem = text_new("%.*s", (int)strcspn(start, "="), start);
    const char *nearest = scene_problem_nearest(stem, n, name);
    free(stem);
    die_all(EXIT_CODE_SCENE, "%s: unknown option; %s%s%sfrana help %s lists them", word,
            nearest ? "did you mean --" : "", nearest ? nearest : "", nearest ? "? " : "", usage->word);
}

static void set_folder(struct command *c, const char *path) {
    if (*path == '\0') die_all(EXIT_CODE_SCENE, "--out: needs a value");
    if (strlen(path) >= sizeof c->out)
        die_all(EXIT_CODE_SCENE, "--out: a path of %zu bytes; at most %zu are possible", strlen(path),
                sizeof c->out - 1);
    snprintf(c->out, sizeof c->out, "%s", path);
}

static void read_options(struct command *c, const struct usage_command *usage, int argc, char **argv) {
    struct option option[32] = {{0}};
    for (int k = 0; usage_option[k].name; k++)
        option[k] = (struct option){usage_option[k].name, usage_option[k].argument, NULL, usage_option[k].letter};
    opterr = 0;
    for (int o, which = 0; (o = getopt_long(argc, argv, ":h", option, &which)) != -1;) {
        const char *word = argv[optind - 1];
        if (o == ':') die_all(EXIT_CODE_SCENE, "%s: needs a value", word);
        if (o == '?') unknown_option(word, usage);
        if (o != 'h') check_option(&usage_option[which], c->verb);
        switch (o) {
        case 'o':
            set_folder(c, optarg);
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
            set_task(c, STUDY_LIST);
            break;
        case 'u':
            set_task(c, STUDY_ONE);
            c->number = whole_number(optarg, "--run", 1);
            break;
        case 'C':
            set_task(c, STUDY_COLLECT);
            break;
        case 'R':
            c->results = optarg;
            break;
        case 'j':
            start_threads(whole_number(optarg, "--threads", 1));
            break;
        case 'w':
            c->max_wall = seconds_of(optarg);
            break;
        case 'q':
            c->quiet = 1;
            break;
        case 'e':
            c->measure = 1;
            break;
        case 'h':
            c->help = 1;
            break;
        case 'f':
            c->fresh = 1;
            break;
        case 'i':
            c->film = 1, c->film_quantity = optarg;
            break;
        case 'l':
            c->level = positive_number(optarg, "--level", 1);
            break;
        case 'm':
            c->magnify = positive_number(optarg, "--magnify", 1e9);
            break;
        case 'b':
            c->before = optarg;
            break;
        case 'x':
            add_slice(c, optarg);
            break;
        case 'k':
            c->quick = 1;
            break;
        case 'd':
            c->stepped = 1;
            break;
        case 'F':
            c->fields = 1;
            break;
        case 'n':
            c->only = optarg;
            break;
        case 'z':
            c->sizes = optarg;
            break;
        case 'p':
            c->repeats = whole_number(optarg, "--repeats", 5);
            break;
        default:
            ENSURE(0, "no case for the option %s, letter %c", word, o);
        }
    }
}

/* Checks the arguments after the options. */
static void check_files(const struct command *c, const struct usage_command *usage) {
    const int most = c->verb == COMMAND_POST                                 ? INT_MAX
                     : c->verb == COMMAND_INIT                               ? 2
                     : c->verb == COMMAND_SCHEMA || c->verb == COMMAND_BENCH ? 0
                                                                             : 1;
    if (c->files == 0 && *usage->arguments && *usage->arguments != '[')
        die_all(EXIT_CODE_SCENE, "%s: which %s?", usage->word, usage->file);
    if (c->files <= most) return;
    if (most == 0) die_all(EXIT_CODE_SCENE, "%s %s: takes no arguments", usage->word, c->file[0]);
    if (most == 2) die_all(EXIT_CODE_SCENE, "%s: takes a case and a folder", usage->word);
    die_all(EXIT_CODE_SCENE, "%s %s %s: takes one %s", usage->word, c->file[0], c->file[1], usage->file);
}

struct command *command_new(int argc, char **argv) {
    struct command *c = calloc(1, sizeof *c);
    c->repeats = 7;
    if (argc < 2) {
        c->verb = c->about = COMMAND_HELP;
        c->is_missing = 1;
        return c;
    }
    const struct usage_command *usage = find_command(argv[1]);
    c->verb = c->about = usage->verb;
    c->set = calloc((size_t)argc, sizeof *c->set);
    if (c->verb == COMMAND_HELP && argc > 2) c->about = find_command(argv[2])->verb;
    if (c->verb == COMMAND_VERSION || c->verb == COMMAND_HELP) return c;
    read_options(c, usage, argc - 1, argv + 1);
    if (c->fresh && (c->task == STUDY_LIST || c->task == STUDY_COLLECT))
        die_all(EXIT_CODE_SCENE, "--fresh: does not go with --list or --collect, which make no run");
    if (c->resume && c->resume_or_start) die_all(EXIT_CODE_SCENE, "--resume-or-start: does not go with --resume");
    c->file = (const char *const *)(argv + 1 + optind);
    c->files = argc - 1 - optind;
    if (c->help) {
        c->verb = COMMAND_HELP;
        return c;
    }
    check_files(c, usage);
    if ((c->verb == COMMAND_RUN || c->verb == COMMAND_PERMEABILITY) && !c->out[0]) default_out(c, "runs");
    if (c->verb == COMMAND_CALIBRATE && !c->out[0]) default_out(c, "calibrations");
    if (c->verb == COMMAND_CHECK && !c->out[0]) default_out(c, "checks");
    return c;
}

void command_free(struct command *c) {
    free(c->set);
    free(c);
}
