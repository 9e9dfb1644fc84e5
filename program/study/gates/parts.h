/* Parts of the work on a file of gates. */
#pragma once
#include "program/study/gates/gates.h"
#include "scene/text/node.h"

struct study_gates {
    const char *path, *folder; /* the file; its folder */
    const char *program;       /* this program */
    char *runs, *results;      /* folders; the same if only one is given */
    char *measured;            /* the file measured.csv */
    int quick, collects, fresh;
    int (*study)(const struct study_options *o, const char *program);
    const struct scene_node *root;
};

/* Makes the studies and the runs and measures, in this order. Dies where one fails. */
void study_gates_make(const struct study_gates *g);
/* Writes summary.csv (quick.csv with --quick) and shown.csv, and prints them. Returns the number of misses that count:
 * into another folder than results beside the file, or with --quick, those that results/summary.csv does not have. */
int study_gates_judge(const struct study_gates *g);
