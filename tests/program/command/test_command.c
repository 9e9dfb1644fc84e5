/* Each option of the command line is read, and each mistake ends with code 2 and one sentence. */
#include "base/die.h"
#include "program/command/command.h"
#include "tests/check.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>

enum { WORDS = 20 };

static jmp_buf back;
static int is_expected;
static char sentence[400];

/* Instead of the end of the program. */
_Noreturn void __wrap_die_all(enum exit_code code, const char *format, ...);
void __wrap_die_all(enum exit_code code, const char *format, ...) {
    va_list args;
    va_start(args, format);
    vsnprintf(sentence, sizeof sentence, format, args);
    va_end(args);
    if (!is_expected) print_error("frana: %s\n", sentence), exit(1);
    longjmp(back, 1000 + (int)code);
}

/* The words of a line, of which the first is the program's name; they must outlive the command. */
static struct command *command_of(const char *line) {
    static char text[800];
    static char *word[WORDS + 1];
    int n = 0;
    snprintf(text, sizeof text, "frana %s", line);
    for (char *at = strtok(text, " "); at && n < WORDS; at = strtok(NULL, " ")) word[n++] = at;
    word[n] = NULL;
    optind = 0; /* a new line */
    return command_new(n, word);
}

static void each_command_by_its_word(void **state) {
    (void)state;
    static const struct {
        const char *line;
        enum command_verb verb;
    } row[] = {{"run a.yaml", COMMAND_RUN},
               {"check a.yaml", COMMAND_CHECK},
               {"post runs/a", COMMAND_POST},
               {"bench", COMMAND_BENCH},
               {"study a.yaml", COMMAND_STUDY},
               {"permeability a.yaml", COMMAND_PERMEABILITY},
               {"calibrate a.yaml", COMMAND_CALIBRATE},
               {"init", COMMAND_INIT},
               {"init bar folder", COMMAND_INIT},
               {"schema", COMMAND_SCHEMA},
               {"keys solid.", COMMAND_KEYS},
               {"run --help", COMMAND_HELP},
               {"check a.yaml b.yaml -h", COMMAND_HELP},
               {"help run", COMMAND_HELP},
               {"--version", COMMAND_VERSION},
               {"--help", COMMAND_HELP},
               {"-h", COMMAND_HELP},
               {"help", COMMAND_HELP},
               {"", COMMAND_HELP}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        struct command *c = command_of(row[k].line);
        assert_int_equal(c->verb, row[k].verb);
        assert_int_equal(c->is_missing, !*row[k].line);
        command_free(c);
    }
}

static void options_of_run(void **state) {
    (void)state;
    struct command *c = command_of("run folder/long.name.yaml");
    assert_int_equal(c->files, 1);
    assert_string_equal(c->file[0], "folder/long.name.yaml");
    assert_string_equal(c->out, "runs/long.name"); /* the default */
    assert_int_equal(c->sets + c->resume + c->quiet, 0);
    assert_null(c->resume_file);
    check_equal(c->max_wall, 0);
    command_free(c);

    c = command_of("run --set a.b=1 it.yaml --out here --set c=2 --resume --quiet --max-wall 1:02:03");
    assert_string_equal(c->file[0], "it.yaml");
    assert_string_equal(c->out, "here");
    assert_int_equal(c->sets, 2);
    assert_string_equal(c->set[0], "a.b=1");
    assert_string_equal(c->set[1], "c=2");
    assert_true(c->resume && c->quiet && !c->resume_file);
    check_equal(c->max_wall, 3723);
    command_free(c);

    c = command_of("run it.yaml --resume-or-start");
    assert_true(c->resume_or_start && !c->resume);
    command_free(c);
    c = command_of("run it.yaml --resume=old.h5 --max-wall 90:00");
    assert_string_equal(c->resume_file, "old.h5");
    check_equal(c->max_wall, 5400);
    command_free(c);
    c = command_of("run it.yaml --max-wall 7.5");
    check_equal(c->max_wall, 7.5);
    command_free(c);
}

static void times_of_a_limit(void **state) {
    (void)state;
    static const struct {
        const char *line;
        double seconds;
    } is[] = {{"run s --max-wall 1-00:00:00", 86400}, {"run s --max-wall 0-01:30:00", 5400},
              {"run s --max-wall 2-6", 194400},       {"run s --max-wall 1-06:30", 109800},
              {"run s --max-wall 00:00:20", 20},      {"run s --max-wall 0.5", 0.5}};
    for (size_t k = 0; k < sizeof is / sizeof *is; k++) {
        struct command *c = command_of(is[k].line);
        check_equal(c->max_wall, is[k].seconds);
        command_free(c);
    }
}

static void options_of_the_others(void **state) {
    (void)state;
    struct command *c = command_of("post runs/a runs/b --film=stress --level 0.4 --magnify 20 --out both");
    assert_int_equal(c->files, 2);
    assert_string_equal(c->file[1], "runs/b");
    assert_string_equal(c->out, "both");
    assert_int_equal(c->film, 1);
    assert_string_equal(c->film_quantity, "stress");
    check_equal(c->level, 0.4);
    check_equal(c->magnify, 20);
    assert_false(c->sliced[0] || c->sliced[1] || c->sliced[2]);
    command_free(c);
    c = command_of("post runs/a --slice z=0 --slice x=2.5e-4");
    assert_true(c->sliced[0] && !c->sliced[1] && c->sliced[2]);
    check_equal(c->slice[0], 2.5e-4);
    check_equal(c->slice[2], 0);
    command_free(c);
    c = command_of("post runs/s2 --before runs/s1");
    assert_string_equal(c->before, "runs/s1");
    command_free(c);
    c = command_of("post runs/a --film");
    assert_true(c->film && !c->film_quantity);
    assert_string_equal(c->out, "");
    command_free(c);
    c = command_of("bench --quick --only fluid,solid --sizes 16x8x8,12 --repeats 5");
    assert_int_equal(c->quick, 1);
    assert_int_equal(c->repeats, 5);
    assert_int_equal(c->files, 0);
    assert_string_equal(c->only, "fluid,solid");
    assert_string_equal(c->sizes, "16x8x8,12");
    command_free(c);
    c = command_of("study s.yaml --fresh");
    assert_int_equal(c->fresh, 1);
    command_free(c);
    c = command_of("permeability folder/rock.yaml --set a=1 --max-wall 7 --quiet --fresh");
    assert_string_equal(c->out, "runs/rock");
    assert_true(c->sets == 1 && c->quiet && c->fresh && c->max_wall == 7);
    command_free(c);
    c = command_of("calibrate folder/rock.yaml --set a=1 --max-wall 7 --quiet --fresh --quick --only bar,notch");
    assert_string_equal(c->out, "calibrations/rock");
    assert_true(c->sets == 1 && c->quiet && c->fresh && c->quick && c->max_wall == 7);
    assert_string_equal(c->only, "bar,notch");
    command_free(c);
    c = command_of("check s.yaml --set a=1");
    assert_int_equal(c->sets, 1);
    assert_string_equal(c->out, "checks/s"); /* written by scenes with an image only */
    assert_false(c->measure);
    command_free(c);
    c = command_of("check s.yaml --measure");
    assert_true(c->measure);
    command_free(c);
    c = command_of("post --help");
    assert_int_equal(c->about, COMMAND_POST);
    command_free(c);
    c = command_of("help");
    assert_int_equal(c->about, COMMAND_HELP);
    command_free(c);
}

/* The line, and how its sentence begins. */
static void each_mistake_ends_with_code_2(void **state) {
    (void)state;
    static const char *const table[][2] = {
        {"runs a.yaml", "runs: unknown command; did you mean run? frana help lists all"},
        {"help runs", "runs: unknown command; did you mean run?"},
        {"tomography a", "tomography: unknown command; there are run, check"},
        {"schema a", "schema a: takes no arguments"},
        {"keys a b", "keys a b: takes one beginning"},
        {"init a b c", "init: takes a case and a folder"},
        {"run a --measure", "--measure: goes with frana check only"},
        {"run", "run: which scene?"},
        {"post", "post: which run folder?"},
        {"permeability", "permeability: which scene?"},
        {"permeability a b", "permeability a b: takes one scene"},
        {"permeability a --resume", "--resume: goes with frana run only"},
        {"calibrate", "calibrate: which scene?"},
        {"calibrate a --resume", "--resume: goes with frana run only"},
        {"calibrate a --repeats 7", "--repeats: goes with frana bench only"},
        {"study", "study: which study?"},
        {"run a b", "run a b: takes one scene"},
        {"study a b", "study a b: takes one study"},
        {"bench a.csv", "bench a.csv: takes no arguments"},
        {"run a --outt b", "--outt: unknown option; did you mean --out? frana help run lists them"},
        {"run a --resum", "--resum: unknown option; did you mean --resume? frana help run"},
        {"check a --threds=2", "--threds=2: unknown option; did you mean --threads? frana help check"},
        {"run a --tomography", "--tomography: unknown option; frana help run lists them"},
        {"run a --films", "--films: unknown option; frana help run lists them"},
        {"run a -x", "-x: unknown option"},
        {"run a --out", "--out: needs a value"},
        {"run a --out=", "--out: needs a value"},
        {"run a --max-wall 1:60:00", "--max-wall 1:60:00: must be D-HH:MM:SS"},
        {"run a --max-wall 1e400",
         "--max-wall 1e400: must be D-HH:MM:SS (as in 1-12:00:00), HH:MM:SS, MM:SS or seconds, more than "
         "nothing and at most 1e+09 s"},
        {"run a --max-wall 0",
         "--max-wall 0: must be D-HH:MM:SS (as in 1-12:00:00), HH:MM:SS, MM:SS or seconds, more than nothing"},
        {"run a --max-wall 1:2:3:4", "--max-wall 1:2:3:4: must be D-HH:MM:SS"},
        {"run a --max-wall -5", "--max-wall -5: must be D-HH:MM:SS"},
        {"run a --max-wall 1-", "--max-wall 1-: must be D-HH:MM:SS"},
        {"run a --max-wall 1--5", "--max-wall 1--5: must be D-HH:MM:SS"},
        {"run a --max-wall 1-2:60", "--max-wall 1-2:60: must be D-HH:MM:SS"},
        {"run a --max-wall 1-99:00:00", "--max-wall 1-99:00:00: must be D-HH:MM:SS"},
        {"run a --max-wall 1-24", "--max-wall 1-24: must be D-HH:MM:SS"},
        {"run a --max-wall nan", "--max-wall nan: must be D-HH:MM:SS"},
        {"run a --max-wall 5s", "--max-wall 5s: must be D-HH:MM:SS"},
        {"check a --quiet", "--quiet: goes with frana run, permeability and calibrate only"},
        {"check a --resume", "--resume: goes with frana run only"},
        {"run a --resume --resume-or-start", "--resume-or-start: does not go with --resume"},
        {"study a --resume-or-start", "--resume-or-start: goes with frana run only"},
        {"post a --set b=1", "--set: goes with frana run, check, permeability and calibrate only"},
        {"run a --film", "--film: goes with frana post only"},
        {"run a --fresh", "--fresh: goes with frana study, permeability and calibrate only"},
        {"run a --fields", "--fields: goes with frana permeability only"},
        {"run a --quick", "--quick: goes with frana bench, study, permeability and calibrate only"},
        {"post a --level 1", "--level 1: must be a number above 0 and below 1"},
        {"post a --slice 0.1", "--slice 0.1: must be a direction and a place in m"},
        {"post a --slice w=0.1", "--slice w=0.1: must be a direction and a place in m"},
        {"post a --slice x=", "--slice x=: must be a direction and a place in m"},
        {"post a --slice x=1mm", "--slice x=1mm: must be a direction and a place in m"},
        {"post a --slice x=nan", "--slice x=nan: must be a direction and a place in m"},
        {"run a.yaml --slice=x=1", "--slice: goes with frana post only"},
        {"post a --level nan", "--level nan: must be a number above 0"},
        {"post a --magnify 0", "--magnify 0: must be a number above 0"},
        {"post a --magnify 2x", "--magnify 2x: must be a number above 0"},
        {"bench --repeats 4", "--repeats 4: must be a whole number, at least 5"},
        {"bench --repeats 5.5", "--repeats 5.5: must be a whole number"},
        {"bench --repeats 99999999999", "--repeats 99999999999: must be a whole number"}};
    is_expected = 1;
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        const int code = setjmp(back);
        if (code == 0) {
            command_of(table[k][0]);
            fail_msg("frana %s: is not refused", table[k][0]);
        }
        assert_int_equal(code - 1000, EXIT_CODE_SCENE);
        if (strncmp(sentence, table[k][1], strlen(table[k][1])) != 0)
            fail_msg("frana %s\n  says \"%s\"\n  and not \"%s\"", table[k][0], sentence, table[k][1]);
    }
}

/* A path that the program could not hold is refused, and not cut off. */
static void a_long_folder_is_refused(void **state) {
    (void)state;
    char line[700] = "run a --out ";
    const size_t start = strlen(line), capacity = sizeof((struct command *)0)->out;
    memset(line + start, 'x', capacity - 1);
    struct command *c = command_of(line);
    assert_int_equal(strlen(c->out), capacity - 1);
    command_free(c);
    line[start + capacity - 1] = 'x';
    is_expected = 1;
    const int code = setjmp(back);
    if (code == 0) {
        command_of(line);
        fail_msg("a path of %zu bytes is not refused", capacity);
    }
    assert_int_equal(code - 1000, EXIT_CODE_SCENE);
    assert_string_equal(sentence, "--out: a path of 512 bytes; at most 511 are possible");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_command_by_its_word), cmocka_unit_test(options_of_run),
        cmocka_unit_test(times_of_a_limit),         cmocka_unit_test(options_of_the_others),
        cmocka_unit_test(a_long_folder_is_refused), cmocka_unit_test(each_mistake_ends_with_code_2)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
