/* The contents of a run folder, and the scales of its results. */
#pragma once
#include "base/files/json_read.h"
#include "base/files/table.h"
#include "base/files/vtkhdf.h"
#include "physics/waves.h"
#include "scene/scene.h"

struct postproc_fields {
    int n;                             /* files that exist, in order of time */
    struct vtkhdf_series_entry *entry; /* owned */
};

struct postproc_history {
    const char *folder;           /* borrowed */
    struct scene *scene;          /* scene.resolved.yaml */
    struct json_read *record;     /* run.json, or NULL */
    struct table_data *series;    /* series.csv, or NULL */
    struct table_data *crack;     /* crack.csv, or NULL */
    struct table_data *particles; /* crack_particles.csv, or NULL */
    struct table_data *fragments; /* fragments.csv, or NULL */
    struct table_data *reactions; /* reactions.csv, or NULL */
    struct table_data *events;    /* events.csv, or NULL */
    struct table_data *modes;     /* modes.csv, or NULL */
    struct table_data *slices;    /* slices.csv, or NULL */
    struct table_data *rev;       /* rev.csv, or NULL */
    struct table_data *intrinsic; /* intrinsic.csv, or NULL */
    struct postproc_fields solid, fluid;
    /* The time origin: the start of the last stage that the run has reached.  (001: sec. 6.4.1) */
    const char *stage; /* its name */
    long origin_step;
    double origin; /* s */
    double end;    /* the last time of series or fields, s */
    /* Scales; NAN if the scene has none. */
    double density, velocity, length, t0; /* rho_f, U_b, height of the domain, t0 = length / velocity */
    double pressure;                      /* rho_f U_b^2, Pa */
    double spacing;                       /* of the particles, m */
    struct postproc_history *earlier; /* the run from whose checkpoint this one was resumed, if it was named; owned */
    double s0, sigma0;                /* least critical stretch of the materials, and E s0, Pa; of a bilinear law s_e
                                       * and the tensile strength */
};

/* NULL, with a sentence in error [size], if the folder contains no run. */
struct postproc_history *postproc_history_new(const char *folder, char *error, int size);
void postproc_history_free(struct postproc_history *h);

/* Of the first body's material; NAN without a solid. */
struct physics_waves postproc_history_waves(const struct postproc_history *h);
/* 0, 1, 2: the axis of the stream, nearest to the direction along which the medium is measured; 0 without fluid. */
int postproc_history_axis(const struct postproc_history *h);
/* (t - origin) / t0, or t - origin in s without t0. */
double postproc_history_when(const struct postproc_history *h, double t);
const char *postproc_history_when_name(const struct postproc_history *h); /* "t/t_0" or "t [s]" */
/* The values of a column of the series: [rows], kept (base/arena.h); NULL if there is no such column. */
double *postproc_history_column(const struct postproc_history *h, const char *name);
/* The column's value in the last row not later than the time; NAN if there is none. */
double postproc_history_value(const struct postproc_history *h, const char *name, double t);
/* The values of a column of a table: [rows], kept; NULL if there is no such column or no table. */
double *postproc_history_values(const struct table_data *d, const char *name);
/* Mean over the rows of from < t <= to. */
double postproc_history_mean(const struct postproc_history *h, const char *name, double from, double to);
/* Opens the last file not later than the time, or the first; NULL if there is none. */
struct vtkhdf_source *postproc_history_open(const struct postproc_history *h, const struct postproc_fields *fields,
                                            double t);
