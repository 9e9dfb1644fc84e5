/* Writes the fields of an element-free plate at its nodes and over its cells. */
#include "meshless/problem/plate_fields.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/table_columns.h"
#include "base/files/vtkhdf.h"
#include "meshless/galerkin/cells.h"
#include "meshless/galerkin/field.h"

#include <string.h>

/* This rank's places, with the solution there. */
struct places {
    long n;
    double (*x)[3], (*u)[3], (*stress)[6], (*strain)[6];
};

static void places_new(struct places *p, long capacity) {
    *p = (struct places){0};
    p->x = memory_new(MEMORY_OUTPUT, (size_t)capacity + 1, sizeof *p->x);
    p->u = memory_new(MEMORY_OUTPUT, (size_t)capacity + 1, sizeof *p->u);
    p->stress = memory_new(MEMORY_OUTPUT, (size_t)capacity + 1, sizeof *p->stress);
    p->strain = memory_new(MEMORY_OUTPUT, (size_t)capacity + 1, sizeof *p->strain);
}

static void places_free(struct places *p) { MEMORY_FREE(p->x, p->u, p->stress, p->strain); }

/* Adds a place, seen from `see`. */
static void add(struct places *p, const struct galerkin *g, const double x[2], const double see[2]) {
    const double nu = g->in.poisson_ratio;
    struct galerkin_place at;
    double grad[2][2], s[3];
    const long k = p->n++;
    for (int c = 0; c < 2; c++) {
        p->x[k][c] = at.x[c] = x[c];
        at.see[c] = see[c];
    }
    meshless_field_at(g, &at, p->u[k], grad);
    meshless_field_stress(g, grad, s);
    const double across = g->in.plane_strain ? nu * (s[0] + s[1]) : 0;
    const double stress[6] = {s[0], s[1], across, s[2], 0, 0};
    const double strain[6] = {grad[0][0],
                              grad[1][1],
                              g->in.plane_strain ? 0 : -nu * (s[0] + s[1]) / g->in.youngs_modulus,
                              0.5 * (grad[0][1] + grad[1][0]),
                              0,
                              0};
    memcpy(p->stress[k], stress, sizeof stress);
    memcpy(p->strain[k], strain, sizeof strain);
}

static struct vtkhdf *begin(const struct places *p, const char *folder, const char *name) {
    char path[FOLDER_PATH];
    return vtkhdf_points_begin(&(struct vtkhdf_points_input){
        .path = folder_path(path, folder, name), .n = p->n, .x = (const double(*)[3])p->x, .wide = 1});
}

/* The rank's part of n things. */
static void share(long n, long *from, long *to) {
    *from = n * par_rank() / par_size();
    *to = n * (par_rank() + 1) / par_size();
}

static void write_nodes(const struct galerkin *g, const char *folder) {
    struct places p;
    long from, to;
    share(g->in.nodes, &from, &to);
    places_new(&p, to - from);
    double *size = memory_new(MEMORY_OUTPUT, (size_t)(to - from) + 1, sizeof *size);
    for (long i = from; i < to; i++) {
        size[p.n] = g->radius[i] / g->in.support;
        add(&p, g, g->in.node[i], g->in.node[i]);
    }
    struct vtkhdf *f = begin(&p, folder, "fields/solution.hdf");
    vtkhdf_add(f, "displacement", 3, p.u[0]);
    vtkhdf_add(f, "stress", 6, p.stress[0]);
    vtkhdf_add(f, "strain", 6, p.strain[0]);
    vtkhdf_add(f, "spacing", 1, size);
    vtkhdf_end(f);
    memory_free(size);
    places_free(&p);
}

/* Each piece as quadrilaterals, one a corner: its middle, the middle of the edge before the corner, the corner, the
 * middle of the edge behind it. Values are seen from inside the piece. */
static void write_cells(const struct galerkin *g, const char *folder) {
    struct places p;
    long from, to, corners = 0;
    share(g->cells.pieces, &from, &to);
    for (long k = from; k < to; k++) corners += g->cells.piece[k].corners;
    places_new(&p, 4 * corners);
    double *piece = memory_new(MEMORY_OUTPUT, 4 * (size_t)corners + 1, sizeof *piece);
    for (long k = from; k < to; k++) {
        const int n = g->cells.piece[k].corners;
        const double(*x)[2] = (const double(*)[2])(g->cells.corner + g->cells.piece[k].first);
        double middle[2] = {0, 0};
        for (int i = 0; i < n; i++)
            for (int c = 0; c < 2; c++) middle[c] += x[i][c] / n;
        for (int i = 0; i < n; i++) {
            const double *before = x[(i + n - 1) % n], *next = x[(i + 1) % n];
            double at[4][2];
            for (int c = 0; c < 2; c++) {
                at[0][c] = middle[c];
                at[1][c] = 0.5 * (before[c] + x[i][c]);
                at[2][c] = x[i][c];
                at[3][c] = 0.5 * (next[c] + x[i][c]);
            }
            for (int q = 0; q < 4; q++) {
                double see[2];
                for (int c = 0; c < 2; c++) see[c] = at[q][c] + 1e-6 * (middle[c] - at[q][c]);
                piece[p.n] = (double)k;
                add(&p, g, at[q], see);
            }
        }
    }
    struct vtkhdf *f = begin(&p, folder, "fields/cells.hdf");
    vtkhdf_add(f, "displacement", 3, p.u[0]);
    vtkhdf_add(f, "stress", 6, p.stress[0]);
    vtkhdf_add(f, "piece", 1, piece);
    vtkhdf_end(f);
    memory_free(piece);
    places_free(&p);
}

static void write_gauss_points(const struct galerkin *g, const char *folder) {
    enum { INSIDE = MESHLESS_CELLS_CORNERS * MESHLESS_CELLS_GAUSS * MESHLESS_CELLS_GAUSS };
    struct places p = {0};
    long from, to, capacity = 0;
    share(g->cells.pieces, &from, &to);
    double *weight = NULL;
    for (long k = from; k < to; k++) {
        struct galerkin_place at[INSIDE];
        double its[INSIDE];
        const int n = meshless_cells_inside(g, (int)k, at, its);
        if (p.n + n > capacity) {
            const size_t old = (size_t)capacity;
            capacity = 2 * (p.n + n);
            p.x = memory_grown(MEMORY_OUTPUT, p.x, old, (size_t)capacity, sizeof *p.x);
            weight = memory_grown(MEMORY_OUTPUT, weight, old, (size_t)capacity, sizeof *weight);
        }
        for (int i = 0; i < n; i++) {
            p.x[p.n][0] = at[i].x[0];
            p.x[p.n][1] = at[i].x[1];
            p.x[p.n][2] = 0;
            weight[p.n++] = its[i];
        }
    }
    struct vtkhdf *f = begin(&p, folder, "fields/gauss_points.hdf");
    vtkhdf_add(f, "weight", 1, weight);
    vtkhdf_end(f);
    MEMORY_FREE(weight, p.x);
}

/* Straight parts of the cracks, and the extensions of the tips. */
static void write_lines(const struct galerkin *g, const char *folder) {
    struct table *table =
        table_columns_new(folder, "crack_lines.csv", "crack 1|extension 1|x0 m|y0 m|x1 m|y1 m", 2, -1);
    for (int k = 0; k < g->lines; k++)
        for (int p = 0; p < g->line[k].parts; p++) {
            const struct galerkin_part *part = &g->line[k].part[p];
            table_row(table, (const double[]){k, 0, part->origin[0], part->origin[1],
                                              part->origin[0] + part->length * part->along[0],
                                              part->origin[1] + part->length * part->along[1]});
        }
    for (int t = 0; t < g->tips; t++) {
        const struct galerkin_tip *tip = &g->tip[t];
        const double reach = g->line[tip->line].reach[tip->end];
        table_row(table, (const double[]){tip->line, 1, tip->x[0], tip->x[1], tip->x[0] + reach * tip->along[0],
                                          tip->x[1] + reach * tip->along[1]});
    }
    table_free(table);
}

void meshless_plate_fields_write(const struct galerkin *g, const char *folder) {
    write_nodes(g, folder);
    write_cells(g, folder);
    write_gauss_points(g, folder);
    write_lines(g, folder);
}
