/* Reads a plate's particles at one time. */
#include "postproc/data/plate.h"

#include <math.h>
#include <stdlib.h>

/* Edge lengths of the particles' squares: from their volumes, else the spacing. */
static double *sizes_new(struct vtkhdf_source *source, const struct postproc_history *h) {
    double *volume = vtkhdf_read_double(source, "volume");
    double *size = malloc(((size_t)source->points + 1) * sizeof *size);
    for (long i = 0; i < source->points; i++)
        size[i] = volume ? sqrt(volume[i] / h->scene->solid->thickness) : h->spacing;
    free(volume);
    return size;
}

/* Initial positions from the present ones. */
static void places_new(struct postproc_plate *p, struct vtkhdf_source *source) {
    double(*now)[3] = vtkhdf_read_points(source), *u = vtkhdf_read_double(source, "displacement");
    const size_t capacity = (size_t)p->n + 1;
    p->x = malloc(capacity * sizeof *p->x);
    p->u = malloc(capacity * sizeof *p->u);
    for (int c = 0; c < 2; c++) {
        p->low[c] = INFINITY;
        p->high[c] = -INFINITY;
        for (long i = 0; i < p->n; i++) {
            p->u[i][c] = u ? u[3 * i + c] : 0;
            p->x[i][c] = now[i][c] - p->u[i][c];
            p->low[c] = fmin(p->low[c], p->x[i][c] - 0.5 * p->size[i]);
            p->high[c] = fmax(p->high[c], p->x[i][c] + 0.5 * p->size[i]);
        }
    }
    free(now);
    free(u);
}

struct postproc_plate *postproc_plate_new(const struct postproc_history *h, int k) {
    struct vtkhdf_source *source = postproc_history_open(h, &h->solid, h->solid.entry[k].time);
    if (!source) return NULL;
    struct postproc_plate *p = NULL;
    if (source->points > 0) {
        p = calloc(1, sizeof *p);
        p->n = source->points;
        p->time = source->time;
        p->step = source->step;
        p->size = sizes_new(source, h);
        places_new(p, source);
        p->damage = vtkhdf_read_double(source, "damage");
        p->stretch = vtkhdf_read_double(source, "stretch_max");
        p->energy = vtkhdf_read_double(source, "energy_density");
    }
    vtkhdf_read_close(source);
    return p;
}

void postproc_plate_free(struct postproc_plate *p) {
    if (!p) return;
    free(p->x);
    free(p->u);
    free(p->size);
    free(p->damage);
    free(p->stretch);
    free(p->energy);
    free(p);
}

struct postproc_grid *postproc_plate_grid(const struct postproc_plate *p, const struct postproc_history *h,
                                          const double *value, int stride) {
    const double *offset = h->scene->solid->lattice_offset;
    return postproc_grid_new(
        &(struct postproc_grid_input){.n = p->n,
                                      .x = (const double(*)[2])p->x,
                                      .value = value,
                                      .stride = stride,
                                      .spacing = h->spacing,
                                      .first = {(0.5 + offset[0]) * h->spacing, (0.5 + offset[1]) * h->spacing}});
}
