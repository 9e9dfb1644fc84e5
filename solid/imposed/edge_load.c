/* Turns a traction on a plate's edge into forces on the particles of the outer layer or of a horizon's depth. */
#include "solid/imposed/edge_load.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/body/cloud.h"
#include "solid/bonds/store.h"
#include "solid/geometry/on_surface.h"
#include "solid/geometry/outline.h"
#include "solid/geometry/shape.h"

#include <math.h>
#include <stdio.h>

struct solid_edges {
    int loads;
    int *body;                              /* [loads] the body of the edge; -1: none */
    struct solid_outline_lengths **lengths; /* [loads] NULL: no load on an edge, or on one of a body of points */
};

/* Finds, for the cells of a body, the boundary under each load on its edges. */
static void find_in_body(struct solid_edges *e, const struct solid_input *in, int b, char *text, size_t size) {
    const struct solid_body *body = &in->body[b];
    struct solid_outline_cells *cells = solid_outline_cells(body->outline, body->outlines, in->origin, in->spacing);
    struct solid_outline_lengths **here =
        memory_new(MEMORY_SOLID, (size_t)e->loads + 1, sizeof(struct solid_outline_lengths *));
    int found = 0;
    for (int k = 0; k < e->loads; k++) {
        const struct solid_load *load = &in->load[k];
        if (load->kind != SOLID_LOAD_EDGE || e->body[k] >= 0) continue;
        e->lengths[k] = solid_outline_lengths(body->outline, body->outlines, in->origin, in->spacing, cells,
                                              load->edge[0], load->edge[1], text, size);
        if (!e->lengths[k]) continue;
        e->body[k] = b;
        here[found++] = e->lengths[k];
    }
    solid_outline_symmetry_lengths(cells, in->spacing, here, found);
    memory_free(here);
    solid_outline_cells_free(cells);
}

/* The same for points inside an outline. They have no cells that share the boundary, so the load must be spread over
 * the depth of a horizon. */
static void find_in_points(struct solid_edges *e, const struct solid_input *in, int b, char *text, size_t size) {
    const struct solid_body *body = &in->body[b];
    for (int k = 0; k < e->loads; k++) {
        const struct solid_load *load = &in->load[k];
        if (load->kind != SOLID_LOAD_EDGE || e->body[k] >= 0) continue;
        struct solid_outline_lengths *lengths = solid_outline_lengths(
            body->outline, body->outlines, in->origin, in->spacing, NULL, load->edge[0], load->edge[1], text, size);
        if (lengths && load->over_horizon)
            e->body[k] = b;
        else if (lengths)
            snprintf(text, size, "the particles of body %s stand on no lattice, so the load needs depth: horizon",
                     body->name);
        solid_outline_lengths_free(lengths);
    }
}

struct solid_edges *solid_edge_load_new(const struct solid_input *in) {
    struct solid_edges *e = memory_new(MEMORY_SOLID, 1, sizeof *e);
    char text[256] = "no body is a polygon";
    e->loads = in->loads;
    e->body = memory_new(MEMORY_SOLID, (size_t)in->loads + 1, sizeof *e->body);
    e->lengths = memory_new(MEMORY_SOLID, (size_t)in->loads + 1, sizeof(struct solid_outline_lengths *));
    int wanted = 0;
    for (int k = 0; k < in->loads; k++) {
        wanted += in->load[k].kind == SOLID_LOAD_EDGE;
        e->body[k] = -1;
    }
    for (int b = 0; wanted && b < in->bodies; b++)
        if (solid_shape_of(&in->body[b])->places == SOLID_PLACES_CELLS)
            find_in_body(e, in, b, text, sizeof text);
        else if (in->body[b].outlines)
            find_in_points(e, in, b, text, sizeof text);
    for (int k = 0; k < in->loads; k++) {
        const struct solid_load *load = &in->load[k];
        if (load->kind == SOLID_LOAD_EDGE && e->body[k] < 0)
            die_all(EXIT_CODE_SCENE, "solid.loads[%d].edge from (%g, %g) to (%g, %g) m: %s", k, load->edge[0][0],
                    load->edge[0][1], load->edge[1][0], load->edge[1][1], text);
    }
    return e;
}

void solid_edge_load_free(struct solid_edges *e) {
    for (int k = 0; k < e->loads; k++) solid_outline_lengths_free(e->lengths[k]);
    MEMORY_FREE(e->lengths, e->body, e);
}

/* On the outermost particles of a body, by number, from id first on: length thickness/volume. */
static void over_layer(const struct solid *s, int body, long first, const double *length, double *per_volume) {
    const long from = s->first[par_rank()];
    for (int h = 0; h < s->n; h++) {
        if (s->body[h] != body) continue;
        per_volume[h] = length[from + h - first] * s->in.thickness / s->volume[h];
    }
}

/* Distance of x from the straight edge into the body, in spacings; -1 if its foot is off the edge. Rounded to 2^-20, so
 * that mirror images agree. */
static double depth_of(const struct solid *s, const struct solid_load *load, const double x[2]) {
    const double along[2] = {load->edge[1][0] - load->edge[0][0], load->edge[1][1] - load->edge[0][1]};
    const double at[2] = {x[0] - load->edge[0][0], x[1] - load->edge[0][1]};
    const double length = hypot(along[0], along[1]), tiny = SOLID_ON_SURFACE * s->in.spacing;
    const double position = (at[0] * along[0] + at[1] * along[1]) / length;
    if (position < -tiny || position > length + tiny) return -1;
    return 0x1p-20 * rint(0x1p20 * fabs(at[0] * along[1] - at[1] * along[0]) / (length * s->in.spacing));
}

/* Evenly on the volume within the horizon behind the edge. Collective. */
static void over_horizon(const struct solid *s, int body, const struct solid_load *load, double *per_volume) {
    const double horizon = s->in.material[s->in.body[body].material].horizon_ratio;
    const double length = hypot(load->edge[1][0] - load->edge[0][0], load->edge[1][1] - load->edge[0][1]);
    const double unit = s->in.spacing * s->in.spacing * s->in.thickness;
    long cells = 0; /* volume as an integer multiple of 2^-40 cells: sums are the same in any order */
    double sum = 0;
    for (int pass = 0; pass < 2; pass++) {
        if (pass) sum = unit * (0x1p-40 * (double)par_sum_long(cells));
        for (int h = 0; h < s->n; h++) {
            const double x[2] = {s->x0[0][h], s->x0[1][h]};
            if (s->body[h] != body) continue;
            const double depth = depth_of(s, load, x);
            if (depth < 0 || depth > horizon + SOLID_ON_SURFACE) continue;
            if (!pass) cells += lrint(0x1p40 * (s->volume[h] / unit));
            if (pass) per_volume[h] = length * s->in.thickness / sum;
        }
    }
}

void solid_edge_load_per_volume(const struct solid *s, struct solid_sites *const *sites, const struct solid_edges *e,
                                int k, double *per_volume) {
    const struct solid_load *load = &s->in.load[k];
    const struct solid_sites *t = sites[e->body[k]];
    const struct solid_outline_lengths *lengths = e->lengths[k];
    if (load->over_horizon) {
        over_horizon(s, e->body[k], load, per_volume);
        return;
    }
    double *by_cell = memory_new(MEMORY_SOLID, (size_t)t->count + 1, sizeof *by_cell);
    double *length = memory_new(MEMORY_SOLID, (size_t)t->count + 1, sizeof *length);
    for (long i = 0; i < lengths->n; i++) by_cell[lengths->share[i].cell] = lengths->share[i].length;
    for (long i = 0; i < t->count; i++) length[i] = by_cell[t->point[i]];
    over_layer(s, e->body[k], t->first, length, per_volume);
    MEMORY_FREE(by_cell, length);
}

void solid_edge_load_per_volume_refined(const struct solid *s, solid_edge_load_lengths *of_cloud, int k,
                                        double *per_volume) {
    const struct solid_load *load = &s->in.load[k];
    int found = 0;
    for (int b = 0; b < s->in.bodies && !found; b++) {
        const struct solid_cloud *cloud = s->family->cloud[b];
        double *length = memory_new(MEMORY_SOLID, (size_t)cloud->n + 1, sizeof *length);
        found = of_cloud(s, b, load->edge[0], load->edge[1], length);
        if (found && load->over_horizon)
            over_horizon(s, b, load, per_volume);
        else if (found)
            over_layer(s, b, cloud->first, length, per_volume);
        memory_free(length);
    }
}
