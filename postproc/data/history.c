/* Opens a run folder: scene, series, field files, and the scales that results are divided by. */
#include "postproc/data/history.h"
#include "base/arena.h"
#include "base/files/folder.h"
#include "physics/bond.h"
#include "physics/dilatation.h"
#include "physics/softening.h"
#include "scene/medium.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int by_time(const void *a, const void *b) {
    const double s = ((const struct vtkhdf_series_entry *)a)->time, t = ((const struct vtkhdf_series_entry *)b)->time;
    return (s > t) - (s < t);
}

static struct vtkhdf_source *open_file(const char *folder, const char *file) {
    char path[FOLDER_PATH], inside[FOLDER_PATH];
    const char *why = NULL;
    snprintf(inside, sizeof inside, "fields/%s", file);
    struct vtkhdf_source *source = vtkhdf_read_open(folder_path(path, folder, inside), &why);
    if (!source) fprintf(stderr, "frana: %s: %s; left out\n", path, why ? why : "cannot be read");
    return source;
}

/* The files that the .hdf.series lists and that can be read. */
static struct postproc_fields fields_new(const char *folder, const char *series) {
    struct postproc_fields f = {0};
    char path[FOLDER_PATH];
    const int named = vtkhdf_series_read(folder_path(path, folder, series), &f.entry);
    for (int i = 0; i < named; i++) {
        struct vtkhdf_source *source = open_file(folder, f.entry[i].file);
        if (!source) continue;
        vtkhdf_read_close(source);
        f.entry[f.n++] = f.entry[i];
    }
    if (f.n > 0) qsort(f.entry, (size_t)f.n, sizeof *f.entry, by_time);
    return f;
}

/* The bulk velocity of the inflow, else of the driving, else of the initial flow. */
static double bulk_velocity(const struct scene_fluid *f) {
    for (int c = 0; c < 3; c++)
        for (int side = 0; side < 2; side++)
            if (f->side[c][side].type == FLUID_INFLOW && f->side[c][side].bulk_velocity != 0)
                return fabs(f->side[c][side].bulk_velocity);
    if (f->driving == FLUID_DRIVING_BULK && f->driving_value != 0) return fabs(f->driving_value);
    const double *u = f->initial_velocity, size = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    return size > 0 ? size : NAN;
}

static enum physics_model model_of(const struct scene *s) {
    return s->dimension == 2 ? (enum physics_model)s->solid->model : PHYSICS_3D;
}

int postproc_history_axis(const struct postproc_history *h) {
    struct scene_medium m;
    int axis = 0;
    if (!h->scene->coupling || !h->scene->fluid) return axis;
    scene_medium_of(h->scene, &m);
    for (int c = 1; c < 3; c++)
        if (fabs(m.along[c]) > fabs(m.along[axis])) axis = c;
    return axis;
}

static void scales(struct postproc_history *h) {
    const struct scene *s = h->scene;
    h->length = s->domain.size[1];
    h->density = h->velocity = h->spacing = h->s0 = h->sigma0 = NAN;
    if (s->fluid) {
        h->density = s->fluid->density;
        h->velocity = bulk_velocity(s->fluid);
    }
    h->t0 = h->length / h->velocity;
    h->pressure = h->density * h->velocity * h->velocity;
    if (!s->solid) return;
    h->spacing = s->solid->spacing > 0    ? s->solid->spacing
                 : s->domain.cells[0] > 0 ? s->domain.size[0] / s->domain.cells[0]
                                          : NAN;
    for (int m = 0; m < s->solid->materials; m++) {
        const struct scene_material *a = &s->solid->material[m];
        const double beyond = physics_dilatation_ratio_excess(model_of(s), a->poisson_ratio);
        const double brittle =
            physics_bond_elastic(model_of(s), (enum physics_micromodulus)a->micromodulus, 1, a->youngs_modulus, beyond,
                                 a->fracture_energy, a->horizon_ratio * h->spacing)
                .s0;
        const int softens = a->breakage == SCENE_BILINEAR;
        const double s0 =
            softens ? physics_softening_of(model_of(s), a->youngs_modulus, beyond, a->tensile_strength, brittle).s_e
                    : brittle;
        if (!isfinite(s0) || s0 >= h->s0) continue;
        h->s0 = s0;
        h->sigma0 = softens ? a->tensile_strength : a->youngs_modulus * s0;
    }
}

/* The time of a step: from the nearest row of the series and its time step. */
static double time_of_step(const struct table_data *d, long step) {
    const int cs = table_read_column(d, "step"), ct = table_read_column(d, "t"), cdt = table_read_column(d, "dt");
    double best = INFINITY, t = NAN;
    for (long i = 0; cs >= 0 && ct >= 0 && i < d->rows; i++) {
        const double *row = d->value + i * d->columns, off = (double)step - row[cs];
        if (fabs(off) >= best) continue;
        best = fabs(off);
        t = row[ct] + (off == 0 || cdt < 0 ? 0 : off * row[cdt]);
    }
    return t;
}

/* The stage in which the record was written; -1: it says none. A stage may have ended before all its steps
 * (stages[].until), so steps of the scene do not tell where later ones began. */
static int stage_of_record(const struct postproc_history *h) {
    const char *name = json_read_text(h->record, "stage");
    for (int k = 0; name && k < h->scene->stages; k++)
        if (!strcmp(h->scene->stage[k].name, name)) return isnan(json_read_number(h->record, "stage_step")) ? -1 : k;
    return -1;
}

static void find_origin(struct postproc_history *h) {
    const struct scene *s = h->scene;
    const struct table_data *d = h->series;
    const double *last = d && d->rows ? d->value + (d->rows - 1) * d->columns : NULL;
    double last_step = last && table_read_column(d, "step") >= 0 ? last[table_read_column(d, "step")] : -1;
    h->end = last && table_read_column(d, "t") >= 0 ? last[table_read_column(d, "t")] : NAN;
    for (int f = 0; f < 2; f++) {
        const struct postproc_fields *fields = f ? &h->fluid : &h->solid;
        if (fields->n) h->end = fmax(isnan(h->end) ? 0 : h->end, fields->entry[fields->n - 1].time);
    }
    if (last_step < 0) last_step = json_read_number(h->record, "steps");
    const int known = stage_of_record(h);
    long step = 0;
    double t = 0; /* from the time steps of the stages, as far as they are given */
    h->stage = s->stages > 0 ? s->stage[0].name : "";
    for (int k = 0; k + 1 < s->stages; k++) {
        step += s->stage[k].steps;
        t = s->stage[k].duration > 0    ? t + s->stage[k].duration
            : s->stage[k].time_step > 0 ? t + (double)s->stage[k].steps * s->stage[k].time_step
                                        : NAN;
        if (k + 1 == known) {
            step = (long)(json_read_number(h->record, "steps") - json_read_number(h->record, "stage_step"));
            t = json_read_number(h->record, "stage_began");
        }
        if (k + 1 > known && last_step <= (double)step) break; /* the next stage has not begun yet */
        h->stage = s->stage[k + 1].name;
        h->origin_step = step;
        h->origin = d ? time_of_step(d, step) : t;
        if (isnan(h->origin)) h->origin = isnan(t) ? 0 : t;
    }
}

struct postproc_history *postproc_history_new(const char *folder, char *error, int size) {
    char path[FOLDER_PATH];
    if (access(folder_path(path, folder, "scene.resolved.yaml"), R_OK) != 0) {
        snprintf(error, (size_t)size, "%s: %s: it is not a run folder of frana's", path, strerror(errno));
        return NULL;
    }
    struct postproc_history *h = calloc(1, sizeof *h);
    h->folder = folder;
    h->solid = fields_new(folder, "fields/solid.hdf.series");
    h->fluid = fields_new(folder, "fields/fluid.hdf.series");
    const char *why = NULL;
    const int written = access(folder_path(path, folder, "series.csv"), F_OK) == 0;
    h->series = written ? table_read(path, &why) : NULL;
    if (written && !h->series) {
        snprintf(error, (size_t)size, "%s: %s", path, why);
        postproc_history_free(h);
        return NULL;
    }
    const int solved = access(folder_path(path, folder, "solution.csv"), F_OK) == 0;
    if (!written && !solved && h->solid.n + h->fluid.n == 0) {
        snprintf(error, (size_t)size, "%s: it has neither a series.csv nor fields: nothing has run in it yet", folder);
        postproc_history_free(h);
        return NULL;
    }
    h->crack = table_read(folder_path(path, folder, "crack.csv"), NULL);
    h->particles = table_read(folder_path(path, folder, "crack_particles.csv"), NULL);
    h->fragments = table_read(folder_path(path, folder, "fragments.csv"), NULL);
    h->reactions = table_read(folder_path(path, folder, "reactions.csv"), NULL);
    h->events = table_read(folder_path(path, folder, "events.csv"), NULL);
    h->slices = table_read(folder_path(path, folder, "slices.csv"), NULL);
    h->modes = table_read(folder_path(path, folder, "modes.csv"), NULL);
    h->rev = table_read(folder_path(path, folder, "rev.csv"), NULL);
    h->intrinsic = table_read(folder_path(path, folder, "intrinsic.csv"), NULL);
    h->record = json_read_new(folder_path(path, folder, "run.json"));
    h->scene = scene_new(folder_path(path, folder, "scene.resolved.yaml"), 0, NULL);
    scales(h);
    find_origin(h);
    return h;
}

void postproc_history_free(struct postproc_history *h) {
    if (h) postproc_history_free(h->earlier);
    if (!h) return;
    if (h->scene) scene_free(h->scene);
    json_read_free(h->record);
    table_read_free(h->series);
    table_read_free(h->particles);
    table_read_free(h->crack);
    table_read_free(h->fragments);
    table_read_free(h->reactions);
    table_read_free(h->events);
    table_read_free(h->slices);
    table_read_free(h->modes);
    table_read_free(h->rev);
    table_read_free(h->intrinsic);
    free(h->solid.entry);
    free(h->fluid.entry);
    free(h);
}

struct physics_waves postproc_history_waves(const struct postproc_history *h) {
    const struct scene_solid *s = h->scene->solid;
    if (!s) return (struct physics_waves){NAN, NAN, NAN};
    const struct scene_material *m = &s->material[s->bodies > 0 ? s->body[0].material_index : 0];
    return physics_waves_of(model_of(h->scene), m->youngs_modulus, m->poisson_ratio, m->density);
}

double postproc_history_when(const struct postproc_history *h, double t) {
    return (t - h->origin) / (h->t0 > 0 ? h->t0 : 1);
}

const char *postproc_history_when_name(const struct postproc_history *h) { return h->t0 > 0 ? "t/t_0" : "t [s]"; }

double *postproc_history_column(const struct postproc_history *h, const char *name) {
    return postproc_history_values(h->series, name);
}

double *postproc_history_values(const struct table_data *d, const char *name) {
    const int c = d ? table_read_column(d, name) : -1;
    if (c < 0) return NULL;
    double *value = arena_new((size_t)d->rows, sizeof *value);
    for (long i = 0; i < d->rows; i++) value[i] = d->value[i * d->columns + c];
    return value;
}

double postproc_history_value(const struct postproc_history *h, const char *name, double t) {
    const struct table_data *d = h->series;
    const int time = d ? table_read_column(d, "t") : -1, column = d ? table_read_column(d, name) : -1;
    double at = NAN;
    for (long i = 0; time >= 0 && column >= 0 && i < d->rows; i++) {
        const double *row = d->value + i * d->columns;
        if (!(row[time] <= t * (1 + 1e-9))) break;
        at = row[column];
    }
    return at;
}

double postproc_history_mean(const struct postproc_history *h, const char *name, double from, double to) {
    double *time = postproc_history_column(h, "t"), *value = postproc_history_column(h, name), sum = 0;
    long n = 0;
    for (long i = 0; time && value && i < h->series->rows; i++) {
        if (!(time[i] > from && time[i] <= to * (1 + 1e-9)) || isnan(value[i])) continue;
        sum += value[i];
        n++;
    }
    return n ? sum / (double)n : NAN;
}

struct vtkhdf_source *postproc_history_open(const struct postproc_history *h, const struct postproc_fields *fields,
                                            double t) {
    if (fields->n == 0) return NULL;
    int k = 0;
    while (k + 1 < fields->n && fields->entry[k + 1].time <= t * (1 + 1e-9)) k++;
    return open_file(h->folder, fields->entry[k].file);
}
