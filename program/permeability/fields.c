/* Writes creeping flows as fields, and draws them. */
#include "program/permeability/fields.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_exchange.h"
#include "base/par_piece.h"
#include "base/files/folder.h"
#include "base/files/vtkhdf.h"
#include "postproc/charts/slice.h"
#include "postproc/draw/legend.h"

#include <math.h>
#include <stdio.h>

enum { SQUARES = 30, LEAST = 4 /* cells: a plane of fewer is not drawn */ };

/* A cell on its way to the rank that writes it. */
struct cell {
    int at[3];
    float u[3], p;
};

/* A rank's sections along z of the box, as the file has them. */
struct block {
    int n[3], first, sections;
    double *velocity, *pressure, *solid; /* [sections][n1][n0], of velocity [3] */
};

void permeability_fields_begin(const char *out) {
    char path[FOLDER_PATH];
    int failed = 0;
    if (par_rank() == 0)
        failed =
            folder_make_path(folder_path(path, out, "fields")) || folder_make_path(folder_path(path, out, "pictures"));
    par_bcast(&failed, sizeof failed, 0);
    if (failed) die_all(EXIT_CODE_FILE, "%s: fields and pictures cannot be made in it", out);
}

/* Which rank writes a section. */
static int rank_of(int n, int k) {
    int rank = 0;
    while (par_piece_low(n, par_size(), rank + 1) <= k) rank++;
    return rank;
}

/* This rank's pore cells with their values. Returns how many. */
static int collect(const struct stokes *s, const struct block *b, int axis, double gradient, double viscosity,
                   struct cell *cell, int *dest) {
    const struct stokes_cells *c = s->cells;
    int at[3], n = 0;
    if (c->n > 0) stokes_mask_find(s->mask, c->first[par_rank()], at);
    for (int i = 0; i < c->n; i++) {
        if (i > 0) stokes_mask_next(s->mask, at);
        if (stokes_grid_is_outside(&s->g, at)) continue;
        for (int d = 0; d < 3; d++) {
            const double mean = 0.5 * (s->u[i][d] + s->u[c->next[i][2 * d]][d]);
            cell[n].at[d] = at[d] - (d == s->g.axis);
            cell[n].u[d] = (float)(mean * gradient / viscosity);
        }
        cell[n].p = (float)(gradient * (s->p[i] - (cell[n].at[axis] + 0.5) * s->g.in.d[axis]));
        dest[n] = rank_of(b->n[2], cell[n].at[2]);
        n++;
    }
    return n;
}

static void place(const struct block *b, const struct cell *c) {
    const size_t at =
        ((size_t)(c->at[2] - b->first) * (size_t)b->n[1] + (size_t)c->at[1]) * (size_t)b->n[0] + (size_t)c->at[0];
    for (int d = 0; d < 3; d++) b->velocity[3 * at + (size_t)d] = (double)c->u[d];
    b->pressure[at] = (double)c->p;
    b->solid[at] = 0;
}

/* What is not a pore that leads through: solid, with no velocity and no pressure. */
static struct block block_new(const struct stokes *s) {
    struct block b = {.first = 0};
    for (int d = 0; d < 3; d++) b.n[d] = s->mask->n[d] - 2 * (d == s->g.axis);
    b.first = par_piece_low(b.n[2], par_size(), par_rank());
    b.sections = par_piece_low(b.n[2], par_size(), par_rank() + 1) - b.first;
    const size_t cells = (size_t)b.n[0] * (size_t)b.n[1] * (size_t)b.sections;
    b.velocity = memory_new(MEMORY_OUTPUT, 3 * cells + 1, sizeof *b.velocity);
    b.pressure = memory_new(MEMORY_OUTPUT, cells + 1, sizeof *b.pressure);
    b.solid = memory_new(MEMORY_OUTPUT, cells + 1, sizeof *b.solid);
    for (size_t k = 0; k < cells; k++) b.pressure[k] = NAN, b.solid[k] = 1;
    return b;
}

static void block_free(struct block *b) { MEMORY_FREE(b->velocity, b->pressure, b->solid); }

static void fill(const struct stokes *s, const struct block *b, int axis, double gradient, double viscosity) {
    const size_t n = (size_t)s->cells->n + 1;
    struct cell *mine = memory_new(MEMORY_OUTPUT, n, sizeof *mine);
    int *dest = memory_new(MEMORY_OUTPUT, n, sizeof *dest);
    struct par_exchange *x = par_exchange_new(collect(s, b, axis, gradient, viscosity, mine, dest), dest);
    const int served = par_exchange_count(x);
    struct cell *here = memory_new(MEMORY_OUTPUT, (size_t)served + 1, sizeof *here);
    par_exchange_forward(x, mine, here, sizeof *mine);
    for (int k = 0; k < served; k++) place(b, &here[k]);
    par_exchange_free(x);
    MEMORY_FREE(here, dest, mine);
}

static void file_of(char name[32], int axis) { snprintf(name, 32, "flow_%c.hdf", "xyz"[axis]); }

void permeability_fields_write(const char *out, const struct scene *scene, const struct stokes *s, int axis,
                               double gradient) {
    char path[FOLDER_PATH], name[32], file[64];
    struct block b = block_new(s);
    fill(s, &b, axis, gradient, scene->fluid->density * scene->fluid->viscosity);
    file_of(name, axis);
    snprintf(file, sizeof file, "fields/%s", name);
    struct vtkhdf_image_input in = {.path = folder_path(path, out, file), .lo = {0, 0, b.first}};
    for (int d = 0; d < 3; d++) {
        in.n[d] = b.n[d];
        in.spacing[d] = s->g.in.d[d];
        in.origin[d] = 0.5 * in.spacing[d];
        in.m[d] = d == 2 ? b.sections : b.n[d];
    }
    struct vtkhdf *f = vtkhdf_image_begin(&in);
    vtkhdf_add(f, "velocity", 3, b.velocity);
    vtkhdf_add(f, "pressure", 1, b.pressure);
    vtkhdf_add(f, "solid_fraction", 1, b.solid);
    vtkhdf_end(f);
    block_free(&b);
}

/* Draws one quantity of a plane. */
static enum postproc_plot_status draw(const char *out, const struct postproc_slice *s, int axis, int is_pressure) {
    char folder[FOLDER_PATH], name[32], title[96], where[96], length[32];
    const double *value = is_pressure ? s->pressure : s->speed;
    struct postproc_stream lines = {0};
    if (!is_pressure) lines = postproc_slice_lines(s, SQUARES);
    snprintf(name, sizeof name, "flow_%c_%s", "xyz"[axis], is_pressure ? "pressure" : "speed");
    snprintf(title, sizeof title, "%s of the creeping flow along %c%s", is_pressure ? "Pressure" : "Speed", "xyz"[axis],
             is_pressure ? ", its mean gradient included" : ", lines along the velocity in the plane");
    postproc_legend_length(s->place, length);
    snprintf(where, sizeof where, "%c = %s; solid and pores that lead nowhere are grey", "xyz"[s->axis], length);
    const enum postproc_plot_status status = postproc_slice_draw(
        &(struct postproc_slice_plot){.folder = folder_path(folder, out, "pictures"),
                                      .name = name,
                                      .all = 1,
                                      .title = title,
                                      .subtitle = where,
                                      .label = is_pressure ? "p  [Pa]" : "|u|  [m/s]",
                                      .slice = s,
                                      .value = value,
                                      .lines = is_pressure ? NULL : &lines,
                                      .low = is_pressure ? postproc_slice_quantile(s, value, 0) : 0,
                                      .high = postproc_slice_quantile(s, value, is_pressure ? 1 : 0.999),
                                      .map = POSTPROC_VIRIDIS});
    postproc_stream_free(&lines);
    return status;
}

const char *permeability_fields_draw(const char *out, const struct scene *scene, const int written[3]) {
    enum postproc_plot_status worst = POSTPROC_PLOT_DONE;
    for (int axis = 0; axis < 3; axis++) {
        if (!written[axis]) continue;
        struct vtkhdf_series_entry entry = {.time = 0};
        file_of(entry.file, axis);
        struct postproc_history h = {
            .folder = out, .scene = (struct scene *)(size_t)scene, .fluid = {.n = 1, .entry = &entry}};
        struct postproc_slice *s = postproc_slice_new(&h, 0, axis == 2 ? 0 : 2, NAN);
        for (int q = 0; s && s->n[0] >= LEAST && s->n[1] >= LEAST && q < 2; q++) {
            const double *value = q ? s->pressure : s->speed;
            if (!(postproc_slice_quantile(s, value, 1) > postproc_slice_quantile(s, value, 0))) continue;
            const enum postproc_plot_status status = draw(out, s, axis, q);
            worst = status > worst ? status : worst;
        }
        postproc_slice_free(s);
    }
    postproc_gnuplot_end();
    return worst == POSTPROC_PLOT_DONE ? NULL
           : worst == POSTPROC_PLOT_NO_GNUPLOT
               ? "no pictures: gnuplot was not found; their scripts are in pictures (*.gp)"
               : "some pictures are missing: they could not be drawn";
}
