/* Tables of the commands and their options, and the help that is printed from them. */
#include "program/command/usage.h"
#include "base/text.h"

#include <getopt.h>
#include <stdlib.h>
#include <string.h>

const struct usage_command usage_command[] = {
    {"run", COMMAND_RUN, "SCENE.yaml", "scene", "Runs a scene, and writes a run folder (docs/run-folder.md)."},
    {"check", COMMAND_CHECK, "SCENE.yaml", "scene",
     "Says what a run of the scene will hold, its steps and their limits, its memory, its files and its time. Computes "
     "no step, unless --measure is given."},
    {"post", COMMAND_POST, "RUNDIR...", "run folder",
     "Writes derived quantities, plots and pictures of run folders, and of several a comparison (docs/post.md)."},
    {"bench", COMMAND_BENCH, "", "file", "Measures the speed of each part on this machine (docs/performance.md)."},
    {"study", COMMAND_STUDY, "STUDY.yaml", "study",
     "Runs the variants of a scene, and measures error against run time; judges a case's numbers (docs/study.md)."},
    {"permeability", COMMAND_PERMEABILITY, "SCENE.yaml", "scene",
     "Measures the permeability tensor of a rigid sample, with the error of the grid (docs/permeability.md)."},
    {"calibrate", COMMAND_CALIBRATE, "SCENE.yaml", "scene",
     "Measures the effective fracture energy and strength of the scene's bonds (docs/calibrate.md)."},
    {"init", COMMAND_INIT, "[CASE [FOLDER]]", "case",
     "Copies a case's scene, with comments on its keys, into a folder (default: this one). Without a case: lists the "
     "cases."},
    {"schema", COMMAND_SCHEMA, "", "file",
     "Prints the scene's JSON Schema, by which editors complete and check a scene (docs/scene.md)."},
    {"keys", COMMAND_KEYS, "[BEGINNING]", "beginning",
     "Prints the scene's keys, of which the paths begin so: path, unit, default, range, what, separated by tabs."},
    {"help", COMMAND_HELP, "[COMMAND]", "command", "Prints this, or a command's options."},
    {"--help", COMMAND_HELP, NULL, NULL, NULL},
    {"-h", COMMAND_HELP, NULL, NULL, NULL},
    {"--version", COMMAND_VERSION, "", "file", "Prints version, compiler and libraries."},
    {.word = NULL}};

enum {
    RUN = 1 << COMMAND_RUN,
    CHECK = 1 << COMMAND_CHECK,
    POST = 1 << COMMAND_POST,
    BENCH = 1 << COMMAND_BENCH,
    STUDY = 1 << COMMAND_STUDY,
    PERMEABILITY = 1 << COMMAND_PERMEABILITY,
    CALIBRATE = 1 << COMMAND_CALIBRATE
};
#define RUNS (RUN | PERMEABILITY | CALIBRATE)

const struct usage_option usage_option[] = {
    {"out", required_argument, 'o', "DIR", RUNS | CHECK | POST | STUDY | BENCH, "the folder that is written"},
    {"set", required_argument, 's', "key.path=value", RUNS | CHECK,
     "replaces or adds a value of the scene; repeatable"},
    {"resume", optional_argument, 'r', "FILE", RUN,
     "goes on from the run folder's newest checkpoint, or starts from a checkpoint FILE"},
    {"resume-or-start", no_argument, 'a', NULL, RUN,
     "goes on as --resume does, starts a run that has not begun, and ends at once if it is done"},
    {"threads", required_argument, 'j', "N", RUNS | CHECK | BENCH, "of each rank, which share its largest loops"},
    {"max-wall", required_argument, 'w', "[D-]HH:MM:SS", RUNS,
     "stops with a checkpoint before so much time has passed; permeability: stops when it has, and "
     "keeps nothing but the runs of --stepped"},
    {"quiet", no_argument, 'q', NULL, RUNS, "prints no progress; run.log has it"},
    {"measure", no_argument, 'e', NULL, CHECK,
     "takes some steps of each stage for about 10 s, writes nothing into a run folder, and forecasts the time from "
     "them"},
    {"list", no_argument, 'L', NULL, STUDY, "prints the runs and their numbers"},
    {"run", required_argument, 'u', "NUMBER", STUDY, "makes one run only, as a job of its own"},
    {"collect", no_argument, 'C', NULL, STUDY, "makes the tables and pictures from runs that are there"},
    {"fresh", no_argument, 'f', NULL, STUDY | PERMEABILITY | CALIBRATE, "makes again what is there already"},
    {"results", required_argument, 'R', "DIR", STUDY, "of a file of gates: the folder of summary.csv"},
    {"quick", no_argument, 'k', NULL, STUDY | BENCH | CALIBRATE | PERMEABILITY,
     "few sizes; permeability: on the scene's grid alone, without the error of the grid; a file of gates: what takes "
     "seconds"},
    {"stepped", no_argument, 'd', NULL, PERMEABILITY, "steps the flow in time until it is steady, in three runs"},
    {"fields", no_argument, 'F', NULL, PERMEABILITY,
     "writes velocity and pressure of each axis on the scene's grid for ParaView, and pictures of them"},
    {"only", required_argument, 'n', "PART,...", BENCH | CALIBRATE, "these parts only"},
    {"sizes", required_argument, 'z', "128x64x64,38,...", BENCH, "cells of the fluid, diameters of the solid"},
    {"repeats", required_argument, 'p', "N", BENCH, "of each measurement, at least 5"},
    {"film", optional_argument, 'i', "QUANTITY", POST, "draws a film of the fields"},
    {"level", required_argument, 'l', "DAMAGE", POST, "damage from which a particle counts as cracked"},
    {"magnify", required_argument, 'm', "FACTOR", POST, "displacements are drawn so many times as large"},
    {"slice", required_argument, 'x', "x=PLACE", POST, "draws a slice across x, y or z at a place in m; repeatable"},
    {"before", required_argument, 'b', "RUNDIR", POST,
     "reads the state before the last stage there: the run from whose checkpoint this one was resumed"},
    {"help", no_argument, 'h', NULL, ~0u, "prints the command's options"},
    {.name = NULL}};

const struct usage_command *usage_command_of(const char *word) {
    for (const struct usage_command *c = usage_command; c->word; c++)
        if (!strcmp(word, c->word)) return c;
    return NULL;
}

char *usage_commands(unsigned commands) {
    const char *word[32];
    int n = 0;
    for (const struct usage_command *c = usage_command; c->word; c++)
        if (commands & 1u << c->verb && c->what) word[n++] = c->word;
    char *text = text_new("%s", n ? word[0] : "");
    for (int k = 1; k < n; k++) {
        char *longer = text_new("%s%s%s", text, k + 1 < n ? ", " : " and ", word[k]);
        free(text);
        text = longer;
    }
    return text;
}

/* Prints a text in lines of at most 100 columns, each after so many blanks. The first line has begun in column `at`. */
static void print_lines(FILE *to, const char *text, int indent, int at) {
    enum { WIDTH = 100 };
    for (const char *word = text; *word;) {
        const int n = (int)strcspn(word, " ");
        if (at + 1 + n > WIDTH) fprintf(to, "\n%*s", indent, ""), at = indent;
        at += fprintf(to, "%s%.*s", at > indent ? " " : "", n, word);
        word += n + (word[n] == ' ');
    }
    fputc('\n', to);
}

/* What stands for a command's options, if it has any but --help. */
static const char *options_of(const struct usage_command *c) {
    for (const struct usage_option *o = usage_option; o->name; o++)
        if (o->commands & 1u << c->verb && o->commands != ~0u) return " [options]";
    return "";
}

void usage_print(FILE *to) {
    fputs("usage: frana COMMAND ...\n", to);
    for (const struct usage_command *c = usage_command; c->word; c++) {
        if (!c->what) continue;
        fprintf(to, "  frana %s%s%s%s\n      ", c->word, *c->arguments ? " " : "", c->arguments, options_of(c));
        print_lines(to, c->what, 6, 6);
    }
    fputs("frana help COMMAND prints a command's options. run, check, permeability, calibrate and bench under mpiexec "
          "-n N\n"
          "where they should run in parallel.\n",
          to);
}

void usage_print_command(FILE *to, enum command_verb verb) {
    const struct usage_command *c = usage_command;
    while (c->verb != verb) c++;
    fprintf(to, "usage: frana %s%s%s%s\n\n", c->word, *c->arguments ? " " : "", c->arguments, options_of(c));
    print_lines(to, c->what, 0, 0);
    fputs("\noptions\n", to);
    for (const struct usage_option *o = usage_option; o->name; o++) {
        if (!(o->commands & 1u << verb)) continue;
        const int optional = o->argument == optional_argument;
        char *word = text_new("--%s%s%s%s", o->name,
                              optional   ? "[="
                              : o->value ? " "
                                         : "",
                              o->value ? o->value : "", optional ? "]" : "");
        fprintf(to, "  %-26s ", word);
        print_lines(to, o->what, 29, 29);
        free(word);
    }
}
