/* Files that a run writes to its folder while it steps: what an output is, the table of all, and those of a run.
 * (docs/design/program.md; docs/extending.md says how to add one) */
#pragma once
#include "base/signals.h"
#include "base/files/table.h"
#include "coupling/run.h"
#include "program/output/series.h"

/* The table: a line for each file of this folder that defines a struct output. They are sampled in this order. */
#define OUTPUTS(LINE)                                                                                                  \
    LINE(fragments)    /* fragments.csv; its numbers are in series.csv too */                                          \
    LINE(series)       /* series.csv */                                                                                \
    LINE(crack_speed)  /* sentences in the log, from numbers of series.csv */                                          \
    LINE(reactions)    /* reactions.csv */                                                                             \
    LINE(bodies)       /* bodies.csv */                                                                                \
    LINE(events)       /* events.csv */                                                                                \
    LINE(crack_series) /* crack.csv, crack_particles.csv */                                                            \
    LINE(intensity)    /* intensity.csv */                                                                             \
    LINE(modes)        /* modes.csv */                                                                                 \
    LINE(probes)       /* probes.csv */                                                                                \
    LINE(fluid_probes) /* fluid_probes.csv */                                                                          \
    LINE(fields)       /* fields/fluid_*.hdf, fields/solid_*.hdf */                                                    \
    LINE(intrinsic)    /* intrinsic.csv */                                                                             \
    LINE(texture)      /* slices.csv, rev.csv */

/* What an output has measured for those after it in the table, and for the log. */
struct outputs_found {
    double fragments, largest_fragment; /* by fragments: their number, particles of the largest; -1: not measured */
    struct series_sample series;        /* by series: the last row */
    enum signals_reason stopped;        /* why a long sample was given up; SIGNALS_NONE: none was */
};

/* An accepted step, after which outputs are sampled. */
struct outputs_moment {
    long step;
    int series_due, fields_due; /* by output.series_every, output.fields_every, or at the end of a stage */
    int stage_ends;             /* with this step */
    int first;                  /* instead: before the first step of this folder */
    struct outputs_found *found;
};

/* When an output is sampled. */
enum {
    OUTPUTS_SERIES = 1, /* whenever the series is due */
    OUTPUTS_FIELDS = 2, /* whenever the fields are due */
    OUTPUTS_STAGE = 4,  /* at a stage's end */
    OUTPUTS_EVERY = 8   /* after its own number of steps */
};

/* The first member of each output's own struct, whose name is `base`. */
struct outputs_base {
    long every;          /* steps, of OUTPUTS_EVERY */
    double rows;         /* that a sample appends to the table, for the forecast of frana check; 0: not known */
    int columns;         /* of the table; set before `begin` is called, by output.columns */
    struct table *table; /* .file[0], once it is open; NULL without output.columns */
};

/* A kind of output. self: its own struct, of `bytes`, zeros at first. Functions that may be NULL say so. Collective.
 * Sampling does not change the state. */
struct output {
    const char *file[3]; /* names in the run folder, up to NULL; without those in fields/ */
    const char *columns; /* of the table .file[0], as in base/files/table_columns.h, step and t first; NULL: there is no
                            such table */
    size_t bytes;
    int when;  /* OUTPUTS_SERIES | ...; 0: OUTPUTS_SERIES */
    int first; /* sampled before the first step too, unless the folder's files are continued */
    /* Returns 0: the scene does not ask for it. Called before a checkpoint is read. Dies (exit 2) where the scene asks
     * for what the run does not have. */
    int (*begin)(void *self, struct run *r);
    /* Begins other files (resume_step < 0), or cuts them back to that step; after the table. folder: borrowed. NULL */
    void (*open)(void *self, struct run *r, const char *folder, long resume_step);
    /* Appends rows by outputs_row; the table is flushed afterwards. */
    void (*sample)(void *self, struct run *r, const struct outputs_moment *m);
    void (*free)(void *self); /* what it owns beside its table and itself, which may not be open; NULL: nothing */
    /* Before a step after which the series may be due, and after such a step if it is not. NULL: nothing. */
    void (*prepare)(void *self, struct run *r);
    void (*cancel)(void *self, struct run *r);
    void (*flush)(void *self, struct run *r);              /* before a checkpoint; NULL: nothing */
    void (*report)(const void *self, const struct run *r); /* to the log, at a stage's end; NULL */
};
#define OUTPUTS_DECLARE(name) extern const struct output output_##name;
OUTPUTS(OUTPUTS_DECLARE)
#undef OUTPUTS_DECLARE

/* The names of all files count as those of a run: it deletes and moves them (base/files/folder.h). Not collective. */
void outputs_own_files(void);

/* Appends a row to the output's table, with step and t as its first two numbers. */
static inline void outputs_row(const struct outputs_base *self, const struct run *r, double *row) {
    row[0] = (double)r->step;
    row[1] = r->t;
    table_add(self->table, row);
}

struct outputs; /* opaque: those that a scene asks for */

struct outputs *outputs_new(struct run *r);
void outputs_open(struct outputs *o, struct run *r, const char *folder, long resume_step);
void outputs_prepare(struct outputs *o, struct run *r);
/* Samples those that are due. series_due, fields_due, stage_ends: as in struct outputs_moment. */
void outputs_sample(struct outputs *o, struct run *r, int series_due, int fields_due, int stage_ends);
/* Why a long sample was given up since the run began: it is taken when the run is resumed. */
enum signals_reason outputs_stopped(const struct outputs *o);
void outputs_flush(struct outputs *o, struct run *r);
void outputs_report(const struct outputs *o, const struct run *r);
/* Numbers in all tables after so many steps, of those whose rows are known. Not collective. */
double outputs_numbers(const struct outputs *o, const struct run *r, long steps);
const struct series_sample *outputs_last(const struct outputs *o); /* the last row of the series; zeros: none yet */
void outputs_free(struct outputs *o);
