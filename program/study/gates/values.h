/* Values that gates compare: cells of the tables of studies, measured numbers, and arithmetic with them. */
#pragma once

struct study_gates_values {
    const char *path;     /* of the file of gates, for messages */
    const char *tables;   /* folder of the tables of studies */
    const char *measured; /* measured.csv */
};

/* [STUDY|METHOD|LEVEL|QUANTITY], with |COLUMN for another column than value, is a cell of STUDY.csv; [KEY] a line of
 * measured.csv. A text that is one of these is that cell's text; another is arithmetic (study_expression_value)
 * with twelve digits. Dies where a cell is missing. */
char *study_gates_values_text(const struct study_gates_values *v, const char *text, int line);
/* The text of a key in measured.csv; NULL: there is none. */
char *study_gates_values_measured(const char *file, const char *key);
