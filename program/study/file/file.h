/* A study, as its file describes it.  (docs/study.md) */
#pragma once
#include "scene/text/problem.h"

/* Values set in the scene, as --set takes them. */
struct study_sets {
    int n;
    char **text; /* [n] "key.path=value" */
};

/* A method or a level: one value of what is varied. */
struct study_variant {
    char *name;
    int line;    /* line in the study's file */
    double size; /* of a level: the h or dt that orders are computed with; NAN: none */
    double at;   /* of a sweep's point: its place on the axis; NAN: none */
    int ranks;   /* 0: the study's number */
    struct study_sets sets;
};

struct study_variants {
    int n;
    struct study_variant *variant;
};

enum study_reference_kind { STUDY_REFERENCE_NONE, STUDY_REFERENCE_VALUE, STUDY_REFERENCE_FINEST };

struct study_reference {
    enum study_reference_kind kind;
    double value, uncertainty; /* in the quantity's unit */
    double scale;              /* errors are divided by it; NAN: |value|, or 1 where that is zero */
    char *source;              /* source of the value; NULL: not given */
    char *method;              /* the method whose finest run is the reference; NULL: the first method */
    double order;              /* of the extrapolation; NAN: the observed one */
    double formal;             /* the scheme's order: an extrapolation uses no higher one */
};

enum study_at { STUDY_LAST, STUDY_FIRST, STUDY_MAX, STUDY_MIN, STUDY_MEAN, STUDY_TIME, STUDY_TIME_MAX };
enum { STUDY_ATS = STUDY_TIME_MAX + 1 };

/* A number from a run folder: from the series, from a table or JSON file, or the last line that a command prints. */
struct study_quantity {
    char *name, *unit; /* unit "": none */
    int line;
    char *column, *where, *file, *row, *command; /* one of column, row and command; file goes with the first two */
    enum study_at at;
    double after, before; /* window of the table, s */
    double above;         /* STUDY_TIME: the time when the column is first above this value */
    double factor;
    struct study_reference reference;
};

struct study {
    char *path, *folder, *name; /* the file; its folder; its name without its ending */
    char *title, *scene;        /* scene: path relative to the program's working folder */
    char *launcher;             /* with {ranks} */
    int ranks, repeats;
    struct study_sets members; /* of an ensemble: the setting of each repeat, members.n of them = repeats; none: 0 */
    struct study_sets sets;
    struct study_variants methods, levels;
    int is_sweep; /* 1: no reference, no errors: levels are the points of a sweep, or one that is called "all" */
    char *axis;   /* of a sweep: what its values are, with a unit; NULL: no sweep, or an ensemble alone */
    int quantities;
    struct study_quantity *quantity;
};

/* Reads the file. Reports every mistake in one line each, then dies with exit code 2. */
struct study *study_file_new(const char *path);
/* The same from a text; NULL if there are problems. */
struct study *study_file_parse(const char *path, const char *text, size_t bytes, struct scene_problems *problems);
