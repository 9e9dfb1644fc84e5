/* The commands and their options: names, values, one sentence each. */
#pragma once
#include "program/command/command.h"

#include <stdio.h>

struct usage_command {
    const char *word; /* NULL ends the table */
    enum command_verb verb;
    const char *arguments; /* "SCENE.yaml" */
    const char *file;      /* what a command reads: "scene" */
    const char *what;      /* sentences */
};
extern const struct usage_command usage_command[];

struct usage_option {
    const char *name; /* without --; NULL ends the table */
    int argument;     /* of getopt: no_argument, required_argument, optional_argument */
    int letter;       /* by which command.c knows it */
    const char *value;
    unsigned commands; /* bits 1 << enum command_verb: the commands that take it */
    const char *what;
};
extern const struct usage_option usage_option[];

/* The command of a word, NULL: there is none. */
const struct usage_command *usage_command_of(const char *word);
/* "run, check and post": the commands of these bits; malloc'ed. */
char *usage_commands(unsigned commands);
/* Prints what all commands are, or, with a verb, one command with its options. */
void usage_print(FILE *to);
void usage_print_command(FILE *to, enum command_verb verb);
