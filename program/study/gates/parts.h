/* Parts of the work on a file of gates. */
#pragma once
#include "program/study/gates/gates.h"
#include "program/study/gates/items.h"

#include <stdio.h>

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

/* Where values stand that gates compare: cells of the tables of studies, and measured numbers. */
struct study_gates_values {
    const char *path;     /* of the file of gates, for messages */
    const char *tables;   /* folder of the tables of studies */
    const char *measured; /* measured.csv */
};

/* [STUDY|METHOD|LEVEL|QUANTITY], with |COLUMN for another column than value, is a cell of STUDY.csv; [KEY] a line of
 * measured.csv. A text that is one of these is that cell's text; another is arithmetic (study_expression_value)
 * with twelve digits. Dies where a cell is missing. */
char *study_gates_values_text(const struct study_gates_values *v, const char *text, int line);

/* The item's number: file in the folder of the runs, and either column of a table such as series.csv, reduced as a
 * study's quantity is, or in the row of a number; or quantity of a table with columns quantity and value; times factor.
 * 15 digits. Dies where there is none. */
char *study_gates_cell_text(const struct study_gates *g, const struct scene_node *item,
                            const struct study_gates_name *names);

/* Whether a row that misses its tolerance stays in the range that the table of known misses gives it. line: of
 * summary.csv; table: the text of misses.csv, with the columns quantity, low, high, tested and reason
 * (docs/study.md#gates). A row that the table does not have is not held. */
int study_gates_misses_hold(const char *table, const char *line);

/* A gate, a line of summary.csv, or a number without a tolerance, a line of shown.csv. */
enum study_gates_rule {
    STUDY_GATES_SHOWN,    /* no tolerance */
    STUDY_GATES_RELATIVE, /* |ours/reference - 1| <= limit */
    STUDY_GATES_BETWEEN,  /* low <= ours <= high */
    STUDY_GATES_AT_LEAST, /* ours >= limit */
    STUDY_GATES_AT_MOST,  /* |ours| <= limit */
    STUDY_GATES_SAME      /* the text of ours is that of the reference */
};

struct study_gates_gate {
    const char *quantity, *unit, *ours, *reference, *source; /* "" where there is none */
    enum study_gates_rule rule;
    const char *limit, *high; /* as written; of BETWEEN the bounds, of SHOWN and SAME NULL */
    int digits;               /* of ours, and of the reference of RELATIVE; 0: as they are */
};

/* Writes the line. Returns whether the number keeps its tolerance; one without a tolerance does. */
int study_gates_verdict_put(FILE *f, const struct study_gates_gate *g);
