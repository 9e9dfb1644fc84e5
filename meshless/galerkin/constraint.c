/* Makes the rows of the constraints, and applies them. */
#include "meshless/galerkin/constraint.h"
#include "base/die.h"
#include "base/memory.h"
#include "meshless/galerkin/cells.h"
#include "meshless/galerkin/cut.h"
#include "meshless/galerkin/mls.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

static void row_begin(struct galerkin_rows *r, enum galerkin_row kind, double given) {
    if (r->rows == r->row_capacity) {
        r->row_capacity = 2 * r->row_capacity + 64;
        r->first = memory_grown(MEMORY_SOLID, r->first, r->rows ? (size_t)r->rows + 1 : 0, (size_t)r->row_capacity + 1,
                                sizeof *r->first);
        r->given = memory_grown(MEMORY_SOLID, r->given, (size_t)r->rows, (size_t)r->row_capacity, sizeof *r->given);
        r->kind = memory_grown(MEMORY_SOLID, r->kind, (size_t)r->rows, (size_t)r->row_capacity, sizeof *r->kind);
    }
    r->given[r->rows] = given;
    r->kind[r->rows] = (int)kind;
    r->first[r->rows] = r->entries;
    r->first[++r->rows] = r->entries;
}

/* Adds to the last row; entries of the same unknown are merged. */
static void row_add(struct galerkin_rows *r, int unknown, double value) {
    for (int k = r->first[r->rows - 1]; k < r->entries; k++)
        if (r->unknown[k] == unknown) {
            r->value[k] += value;
            return;
        }
    if (r->entries == r->entry_capacity) {
        r->entry_capacity = 2 * r->entry_capacity + 1024;
        r->unknown =
            memory_grown(MEMORY_SOLID, r->unknown, (size_t)r->entries, (size_t)r->entry_capacity, sizeof *r->unknown);
        r->value =
            memory_grown(MEMORY_SOLID, r->value, (size_t)r->entries, (size_t)r->entry_capacity, sizeof *r->value);
    }
    r->unknown[r->entries] = unknown;
    r->value[r->entries++] = value;
    r->first[r->rows] = r->entries;
}

static void given_at(const struct galerkin_fixed *f, const double x[2], double u[2]) {
    if (f->value)
        f->value(x, u);
    else
        memcpy(u, f->displacement, sizeof f->displacement);
}

static void fix_point(struct galerkin *g, const struct galerkin_fixed *f) {
    struct galerkin_place at;
    struct galerkin_shape shape;
    double u[2];
    memcpy(at.x, f->from, sizeof at.x);
    memcpy(at.see, f->from, sizeof at.see);
    meshless_mls_need(g, &at, &shape);
    given_at(f, f->from, u);
    for (int c = 0; c < 2; c++) {
        if (!f->direction[c]) continue;
        row_begin(&g->rows, GALERKIN_ROW_FIXED, u[c]);
        for (int i = 0; i < shape.n; i++) row_add(&g->rows, 2 * shape.node[i] + c, shape.phi[i]);
    }
}

/* The mean displacement over an edge of a piece is that given. */
static void fix_edge(struct galerkin *g, const struct galerkin_fixed *f, int piece, int k) {
    struct galerkin_place at[MESHLESS_CELLS_GAUSS];
    double weight[MESHLESS_CELLS_GAUSS], normal[2], length = 0, mean[2] = {0, 0}, u[2];
    const int n = meshless_cells_edge(g, piece, k, at, weight, normal);
    for (int q = 0; q < n; q++) {
        length += weight[q];
        given_at(f, at[q].x, u);
        for (int c = 0; c < 2; c++) mean[c] += weight[q] * u[c];
    }
    for (int c = 0; c < 2; c++) {
        if (!f->direction[c]) continue;
        row_begin(&g->rows, GALERKIN_ROW_FIXED, mean[c] / length);
        for (int q = 0; q < n; q++) {
            struct galerkin_shape shape;
            meshless_mls_need(g, &at[q], &shape);
            for (int i = 0; i < shape.n; i++)
                row_add(&g->rows, 2 * shape.node[i] + c, weight[q] / length * shape.phi[i]);
        }
    }
}

static void fix(struct galerkin *g, int number) {
    const struct galerkin_fixed *f = &g->in.fix[number];
    const int before = g->rows.rows;
    if (f->from[0] == f->to[0] && f->from[1] == f->to[1]) {
        fix_point(g, f);
        return;
    }
    for (int p = 0; p < g->cells.pieces; p++)
        for (int k = 0; k < g->cells.piece[p].corners; k++)
            if (meshless_cells_is_on(g, p, k, f->from, f->to)) fix_edge(g, f, p, k);
    if (g->rows.rows == before && (f->direction[0] || f->direction[1]))
        die_all(EXIT_CODE_SCENE,
                "solid.constraints: between (%.6g, %.6g) and (%.6g, %.6g) there is no edge of a cell on the body's "
                "outline; give a part of the outline, or a point inside the body",
                f->from[0], f->from[1], f->to[0], f->to[1]);
}

/* Jump of displacement and strain between the two sides of a crack's extension. Rows of strain are times the
 * spacing h there: the penalty then has one unit. */
static void join(struct galerkin *g, const double x[2], const double normal[2], double h) {
    struct galerkin_shape shape[2];
    const double step = 1e-6 * h;
    for (int side = 0; side < 2; side++) {
        struct galerkin_place at;
        for (int c = 0; c < 2; c++) {
            at.x[c] = x[c];
            at.see[c] = x[c] + (side ? -step : step) * normal[c];
        }
        meshless_mls_need(g, &at, &shape[side]);
    }
    for (int c = 0; c < 2; c++) {
        row_begin(&g->rows, GALERKIN_ROW_JUMP, 0);
        for (int side = 0; side < 2; side++)
            for (int i = 0; i < shape[side].n; i++)
                row_add(&g->rows, 2 * shape[side].node[i] + c, (side ? -1 : 1) * shape[side].phi[i]);
    }
    for (int c = 0; c < 3; c++) { /* xx, yy, 2 xy */
        row_begin(&g->rows, GALERKIN_ROW_STRAIN, 0);
        for (int side = 0; side < 2; side++)
            for (int i = 0; i < shape[side].n; i++) {
                const double *d = shape[side].d[i], sign = side ? -h : h;
                const int node = shape[side].node[i];
                if (c < 2) {
                    row_add(&g->rows, 2 * node + c, sign * d[c]);
                } else {
                    row_add(&g->rows, 2 * node, sign * d[1]);
                    row_add(&g->rows, 2 * node + 1, sign * d[0]);
                }
            }
    }
}

/* The nodal spacing at the node that is nearest to x. */
static double size_at(const struct galerkin *g, const double x[2]) {
    double least = INFINITY, size = g->in.spacing;
    for (int i = 0; i < g->in.nodes; i++) {
        const double r = hypot(x[0] - g->in.node[i][0], x[1] - g->in.node[i][1]);
        if (r >= least) continue;
        least = r;
        size = g->radius[i] / g->in.support;
    }
    return size;
}

static void join_ahead(struct galerkin *g, const struct galerkin_tip *tip) {
    const struct galerkin_line *line = &g->line[tip->line];
    const double *along = meshless_cut_part(g, tip)->along, normal[2] = {-along[1], along[0]};
    for (double from = 0;;) {
        const double begin[2] = {tip->x[0] + from * tip->along[0], tip->x[1] + from * tip->along[1]};
        const double h = size_at(g, begin), step = g->in.interface_spacing * h, ahead = from + 0.5 * step;
        const double x[2] = {tip->x[0] + ahead * tip->along[0], tip->x[1] + ahead * tip->along[1]};
        if (ahead > line->reach[tip->end] || meshless_cut_depth(&g->in, x) < -1e-9 * g->in.spacing) return;
        for (int t = 0; t < g->tips; t++)
            if (g->tip[t].line != tip->line && meshless_cut_from_line(&g->line[g->tip[t].line], x) < g->widest)
                die_all(EXIT_CODE_SCENE,
                        "solid.element_free.crack = virtual: the extension of the tip (%.6g, %.6g) comes nearer than a "
                        "support, %.6g m, to another crack; take visibility, or a smaller spacing",
                        tip->x[0], tip->x[1], g->widest);
        join(g, x, normal, h);
        from += step;
    }
}

/* Dies if the constraints leave a motion of the body as a rigid one free. */
static void check_rigid(const struct galerkin *g) {
    static const char *const name[] = {"move along x", "move along y", "turn"};
    const struct galerkin_input *in = &g->in;
    double s[9] = {0}, w[3], size = 0;
    for (int k = 0; k < in->corners; k++)
        size = fmax(size, hypot(in->corner[k][0] - in->corner[0][0], in->corner[k][1] - in->corner[0][1]));
    for (int r = 0; r < g->rows.rows; r++) {
        double motion[3] = {0, 0, 0};
        if (g->rows.kind[r] != GALERKIN_ROW_FIXED) continue;
        for (int k = g->rows.first[r]; k < g->rows.first[r + 1]; k++) {
            const int node = g->rows.unknown[k] / 2, c = g->rows.unknown[k] % 2;
            motion[c] += g->rows.value[k];
            motion[2] += g->rows.value[k] *
                         (c ? in->node[node][0] - in->corner[0][0] : in->corner[0][1] - in->node[node][1]) / size;
        }
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) s[3 * i + j] += motion[i] * motion[j];
    }
    const int failed = LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'V', 'U', 3, s, 3, w);
    if (failed == 0 && w[0] > 1e-8 * fmax(w[2], 1e-300)) return;
    int most = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(s[3 * i]) > fabs(s[3 * most])) most = i;
    die_all(
        EXIT_CODE_SCENE,
        "solid.constraints: %d rows of given displacements leave the body free to %s; hold it at a further point or "
        "along an edge",
        g->rows.rows, name[most]);
}

void meshless_constraint_new(struct galerkin *g) {
    for (int k = 0; k < g->in.fixed; k++) fix(g, k);
    check_rigid(g);
    if (g->in.method != GALERKIN_VIRTUAL) return;
    for (int t = 0; t < g->tips; t++) join_ahead(g, &g->tip[t]);
}

void meshless_constraint_free(struct galerkin *g) {
    MEMORY_FREE(g->rows.first, g->rows.unknown, g->rows.value, g->rows.given, g->rows.kind);
}

void meshless_constraint_apply(const struct galerkin *g, const double *u, double *y) {
    const struct galerkin_rows *r = &g->rows;
    for (int i = 0; i < r->rows; i++) {
        y[i] = 0;
        for (int k = r->first[i]; k < r->first[i + 1]; k++) y[i] += r->value[k] * u[r->unknown[k]];
    }
}

void meshless_constraint_add(const struct galerkin *g, double factor, const double *y, double *u) {
    const struct galerkin_rows *r = &g->rows;
    for (int i = 0; i < r->rows; i++)
        for (int k = r->first[i]; k < r->first[i + 1]; k++) u[r->unknown[k]] += factor * r->value[k] * y[i];
}
