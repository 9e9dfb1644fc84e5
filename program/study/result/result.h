/* Results of a study: errors, orders and run times by quantity. */
#pragma once
#include "program/study/result/richardson.h"
#include "program/study/runs/plan.h"

enum { STUDY_LEAST, STUDY_LOWER, STUDY_UPPER, STUDY_MOST, STUDY_BAND_ENDS }; /* LOWER, UPPER: quartiles */

/* A quantity by a method at a level. NAN: no such number. */
struct study_point {
    enum study_state state;       /* state of the repeats: done if one of them is */
    int exit_code;                /* of a failed repeat */
    int repeats;                  /* number of repeats that gave a value */
    double value, spread;         /* median; largest minus smallest; of an ensemble mean; deviation */
    double band[STUDY_BAND_ENDS]; /* of the repeats' values */
    double mean, deviation;
    int failed, unmade;                     /* number of repeats that failed; that were not made */
    double error, relative;                 /* |value - reference|; the same divided by the scale */
    int resolved;                           /* 1: the error is larger than the reference's uncertainty */
    double order;                           /* between this level and the one before */
    double wall, wall_min, wall_iqr, setup; /* s: median, smallest, interquartile range; median */
    double cell_step, bond_sweep;           /* ns on one core, medians */
    double memory;                          /* bytes, all ranks, largest */
    long steps;
    int ranks;
};

/* The results of a method for a quantity. */
struct study_curve {
    double order;                       /* fitted: slope of the error over the size */
    double gain;                        /* fitted: slope of the error over the wall time */
    int finest;                         /* level of the finest finished run, -1: none */
    struct study_richardson richardson; /* of its finest levels */
};

struct study_table {
    const struct study_quantity *quantity; /* borrowed */
    double reference, uncertainty, scale;  /* reference NAN: the run of the reference has not finished */
    int has_scale;                         /* 0: errors are absolute, scale is 1 */
    int method;                            /* finest: the method of the reference; -1: the reference is a given value */
    int extrapolated;                      /* finest: 1: the reference is the Richardson extrapolation */
    struct study_curve *curve;             /* [methods] */
    struct study_point *point;             /* [methods][levels] */
    int plotted;                           /* 1: its plot exists */
};

struct study_result {
    const struct study_plan *plan; /* borrowed */
    int tables;
    struct study_table *table;
};

struct study_result *study_result_new(const struct study_plan *plan);
/* The point of a table for a method at a level. */
const struct study_point *study_result_point(const struct study_result *r, const struct study_table *t, int method,
                                             int level);
/* A method's error (relative, in units of the scale) and wall time for all levels; NAN: none. */
void study_result_curve(const struct study_result *r, const struct study_table *t, int method, double *error,
                        double *time);
