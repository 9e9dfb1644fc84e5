/* Clips background cells by the outline and the cracks, and gives their Gauss points. */
#include "meshless/galerkin/cells.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "meshless/galerkin/cut.h"
#include "meshless/galerkin/nodes.h"

#include <math.h>
#include <string.h>

struct polygon {
    int n;
    double x[MESHLESS_CELLS_CORNERS][2];
};

void meshless_cells_gauss(int n, double *x, double *w) {
    ENSURE(n >= 1 && n <= MESHLESS_CELLS_GAUSS, "%d Gauss points", n);
    const double pi = acos(-1);
    for (int k = 0; k < n; k++) { /* roots of the Legendre polynomial P_n by Newton's method */
        double z = cos(pi * (k + 0.75) / (n + 0.5)), slope = 1;
        for (int turn = 0; turn < 20; turn++) {
            double p = 1, before = 0;
            for (int j = 1; j <= n; j++) {
                const double next = ((2 * j - 1) * z * p - (j - 1) * before) / j;
                before = p;
                p = next;
            }
            slope = n * (z * p - before) / (z * z - 1);
            z -= p / slope;
        }
        x[k] = 0.5 * (1 - z);
        w[k] = 1 / ((1 - z * z) * slope * slope);
    }
}

static double area_of(int n, const double (*x)[2]) {
    double twice = 0;
    for (int k = 1; k + 1 < n; k++)
        twice += (x[k][0] - x[0][0]) * (x[k + 1][1] - x[0][1]) - (x[k + 1][0] - x[0][0]) * (x[k][1] - x[0][1]);
    return 0.5 * twice;
}

/* The part of a convex polygon to the left of the line through a along t (unit). Corners within `slack` of the line
 * are on it. */
static struct polygon left_of(const struct polygon *p, const double a[2], const double t[2], double slack) {
    struct polygon out = {0};
    double side[MESHLESS_CELLS_CORNERS];
    for (int k = 0; k < p->n; k++) {
        side[k] = t[0] * (p->x[k][1] - a[1]) - t[1] * (p->x[k][0] - a[0]);
        if (fabs(side[k]) < slack) side[k] = 0;
    }
    for (int k = 0; k < p->n; k++) {
        const int next = (k + 1) % p->n;
        ENSURE(out.n + 2 <= MESHLESS_CELLS_CORNERS, "a piece of a cell has more than %d corners",
               MESHLESS_CELLS_CORNERS);
        if (side[k] >= 0) memcpy(out.x[out.n++], p->x[k], sizeof p->x[k]);
        if ((side[k] > 0 && side[next] < 0) || (side[k] < 0 && side[next] > 0)) {
            const double f = side[k] / (side[k] - side[next]);
            for (int c = 0; c < 2; c++) out.x[out.n][c] = p->x[k][c] + f * (p->x[next][c] - p->x[k][c]);
            out.n++;
        }
    }
    if (out.n < 3 || area_of(out.n, out.x) < slack * slack) out.n = 0;
    return out;
}

/* Makes a tip on an edge a corner. Returns whether the tip is a corner now. */
static int insert_tip(struct polygon *p, const double tip[2], double slack) {
    for (int k = 0; k < p->n; k++)
        if (hypot(p->x[k][0] - tip[0], p->x[k][1] - tip[1]) < slack) {
            memcpy(p->x[k], tip, sizeof p->x[k]);
            return 1;
        }
    for (int k = 0; k < p->n; k++) {
        const double *a = p->x[k], *b = p->x[(k + 1) % p->n];
        const double tx = b[0] - a[0], ty = b[1] - a[1], length = hypot(tx, ty);
        const double along = ((tip[0] - a[0]) * tx + (tip[1] - a[1]) * ty) / length;
        const double across = ((tip[1] - a[1]) * tx - (tip[0] - a[0]) * ty) / length;
        if (fabs(across) > slack || along < 0 || along > length) continue;
        ENSURE(p->n < MESHLESS_CELLS_CORNERS, "a piece of a cell has more than %d corners", MESHLESS_CELLS_CORNERS);
        memmove(p->x[k + 2], p->x[k + 1], (size_t)(p->n - k - 1) * sizeof p->x[0]);
        memcpy(p->x[k + 1], tip, sizeof p->x[0]);
        p->n++;
        return 1;
    }
    return 0;
}

static double from_segment(const double x[2], const double a[2], const double b[2]) {
    const double tx = b[0] - a[0], ty = b[1] - a[1], square = tx * tx + ty * ty;
    double f = square > 0 ? ((x[0] - a[0]) * tx + (x[1] - a[1]) * ty) / square : 0;
    f = fmin(fmax(f, 0), 1);
    return hypot(x[0] - a[0] - f * tx, x[1] - a[1] - f * ty);
}

static void add_polygon(struct galerkin *g, struct polygon *p, int cell) {
    struct galerkin_cells *c = &g->cells;
    const double slack = 1e-7 * g->in.spacing;
    int its = -1, is_near = 0;
    for (int t = 0; t < g->tips; t++) {
        if (insert_tip(p, g->tip[t].x, slack)) its = t;
        for (int k = 0; k < p->n; k++) is_near |= from_segment(g->tip[t].x, p->x[k], p->x[(k + 1) % p->n]) < c->near;
    }
    c->piece = memory_grown(MEMORY_SOLID, c->piece, (size_t)c->pieces, (size_t)c->pieces + 1, sizeof *c->piece);
    c->corner =
        memory_grown(MEMORY_SOLID, c->corner, (size_t)c->corners, (size_t)(c->corners + p->n), sizeof *c->corner);
    c->piece[c->pieces++] = (struct galerkin_piece){.corners = p->n,
                                                    .first = c->corners,
                                                    .tip = its,
                                                    .points = is_near ? g->in.gauss_tip : g->in.gauss,
                                                    .cell = cell};
    memcpy(c->corner[c->corners], p->x, (size_t)p->n * sizeof p->x[0]);
    c->corners += p->n;
}

/* Whether more than the slack of the line from a to b is inside the polygon. */
static int meets(const struct polygon *p, const double a[2], const double b[2], double slack) {
    const double tx = b[0] - a[0], ty = b[1] - a[1];
    double first = 0, last = 1;
    for (int k = 0; k < p->n; k++) {
        const double *x = p->x[k], *y = p->x[(k + 1) % p->n], ex = y[0] - x[0], ey = y[1] - x[1];
        const double depth = ex * (a[1] - x[1]) - ey * (a[0] - x[0]), rate = ex * ty - ey * tx;
        if (depth <= slack * hypot(ex, ey) && depth + rate <= slack * hypot(ex, ey)) return 0;
        if (depth < 0) first = fmax(first, -depth / rate);
        if (depth + rate < 0) last = fmin(last, -depth / rate);
    }
    return (last - first) * hypot(tx, ty) > slack;
}

/* Whether a part of a crack cuts the polygon: a straight crack does from side to side of the body. */
static int is_cut(const struct galerkin *g, const struct galerkin_line *line, int number, const struct polygon *p,
                  double slack) {
    const struct galerkin_part *part = &line->part[number];
    if (line->parts == 1) return 1;
    const double from = number ? 0 : -meshless_cut_reach(g, line, 0);
    const double to = part->length + (number + 1 < line->parts ? 0 : meshless_cut_reach(g, line, 1));
    double end[2][2];
    for (int c = 0; c < 2; c++) {
        end[0][c] = part->origin[c] + from * part->along[c];
        end[1][c] = part->origin[c] + to * part->along[c];
    }
    return meets(p, end[0], end[1], slack);
}

/* Cuts the polygon by the parts of the cracks from these on, and keeps the pieces. */
static void cut(struct galerkin *g, const struct polygon *p, int line, int part, int cell) {
    const double slack = 1e-7 * g->in.spacing;
    if (p->n == 0) return;
    while (line < g->lines && (part == g->line[line].parts || !is_cut(g, &g->line[line], part, p, slack))) {
        const int is_last = part >= g->line[line].parts - 1;
        line += is_last;
        part = is_last ? 0 : part + 1;
    }
    if (line == g->lines) {
        struct polygon whole = *p;
        add_polygon(g, &whole, cell);
        return;
    }
    const struct galerkin_part *l = &g->line[line].part[part];
    const struct polygon left = left_of(p, l->origin, l->along, slack);
    const struct polygon right = left_of(p, l->origin, (const double[2]){-l->along[0], -l->along[1]}, slack);
    cut(g, &left, line, part + 1, cell);
    cut(g, &right, line, part + 1, cell);
}

/* Takes the holes from this one on out of the polygon: what is outside one of its edges stays. */
static void take_out(struct galerkin *g, const struct polygon *p, int number, int cell) {
    const double slack = 1e-7 * g->in.spacing;
    if (p->n == 0) return;
    if (number == g->in.holes) {
        cut(g, p, 0, 0, cell);
        return;
    }
    const struct galerkin_hole *hole = &g->in.hole[number];
    struct polygon common = *p;
    double along[2];
    for (int turn = 0; turn < 2; turn++) {
        struct polygon rest = *p;
        for (int k = 0; k < hole->corners && rest.n > 0; k++) {
            const double *a = hole->corner[k], *b = hole->corner[(k + 1) % hole->corners];
            const double length = hypot(b[0] - a[0], b[1] - a[1]);
            for (int c = 0; c < 2; c++) along[c] = (b[c] - a[c]) / length;
            if (turn == 1) {
                const struct polygon out = left_of(&rest, a, (const double[2]){-along[0], -along[1]}, slack);
                take_out(g, &out, number + 1, cell);
            }
            rest = left_of(&rest, a, along, slack);
        }
        if (turn == 0) common = rest;
        if (turn == 0 && common.n == 0) {
            take_out(g, p, number + 1, cell);
            return;
        }
    }
}

/* Corners of pieces that lie on an edge of another piece become corners of that one too, so that both integrate the
 * same parts of the edge. */
static void fit(struct galerkin *g) {
    struct galerkin_cells *c = &g->cells;
    const double slack = 1e-7 * g->in.spacing;
    const struct galerkin_cells old = *c;
    c->corner = NULL;
    c->corners = 0;
    for (int k = 0; k < c->pieces; k++) {
        struct galerkin_piece *piece = &c->piece[k];
        struct polygon p = {.n = piece->corners};
        memcpy(p.x, old.corner[piece->first], (size_t)p.n * sizeof p.x[0]);
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int i = 0; i < p.n; i++)
            for (int d = 0; d < 2; d++) {
                low[d] = fmin(low[d], p.x[i][d] - slack);
                high[d] = fmax(high[d], p.x[i][d] + slack);
            }
        for (int i = 0; i < old.corners; i++) {
            const double *x = old.corner[i];
            if (x[0] >= low[0] && x[0] <= high[0] && x[1] >= low[1] && x[1] <= high[1]) insert_tip(&p, x, slack);
        }
        c->corner =
            memory_grown(MEMORY_SOLID, c->corner, (size_t)c->corners, (size_t)(c->corners + p.n), sizeof *c->corner);
        piece->first = c->corners;
        piece->corners = p.n;
        memcpy(c->corner[c->corners], p.x, (size_t)p.n * sizeof p.x[0]);
        c->corners += p.n;
    }
    memory_free(old.corner);
}

/* Lines between the cells along a direction: even ones, halved next to the tips level by level. Returns the cells. */
static int lines_of(const struct galerkin *g, int c, double low, double high, double **lines) {
    int n = g->in.cells[c];
    double *line = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *line);
    for (int i = 0; i <= n; i++) line[i] = low + (high - low) * i / n;
    for (int level = 0; level < g->in.levels; level++) {
        const double reach = (g->in.turned ? sqrt(2) : 1) * g->in.patch * ldexp(g->in.spacing, -level);
        double *finer = memory_new(MEMORY_SOLID, 2 * (size_t)n + 1, sizeof *finer);
        int m = 0;
        for (int i = 0; i <= n; i++) {
            finer[m++] = line[i];
            int is_near = 0;
            for (int t = 0; t < g->tips && i < n; t++)
                is_near |= line[i + 1] > g->tip[t].x[c] - reach && line[i] < g->tip[t].x[c] + reach &&
                           line[i + 1] - line[i] > 0.75 * ldexp((high - low) / g->in.cells[c], -level);
            if (is_near) finer[m++] = 0.5 * (line[i] + line[i + 1]);
        }
        memory_free(line);
        line = finer;
        n = m - 1;
    }
    *lines = line;
    return n;
}

void meshless_cells_new(struct galerkin *g) {
    const struct galerkin_input *in = &g->in;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < in->corners; k++)
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], in->corner[k][c]);
            high[c] = fmax(high[c], in->corner[k][c]);
        }
    g->cells.near = g->widest;
    double *line[2];
    int cells[2];
    for (int c = 0; c < 2; c++) cells[c] = lines_of(g, c, low[c], high[c], &line[c]);
    for (int j = 0; j < cells[1]; j++)
        for (int i = 0; i < cells[0]; i++) {
            const double x0 = line[0][i], x1 = line[0][i + 1], y0 = line[1][j], y1 = line[1][j + 1];
            struct polygon p = {4, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
            for (int k = 0; k < in->corners && p.n > 0; k++) {
                const double *a = in->corner[k], *b = in->corner[(k + 1) % in->corners];
                const double length = hypot(b[0] - a[0], b[1] - a[1]);
                const double t[2] = {(b[0] - a[0]) / length, (b[1] - a[1]) / length};
                p = left_of(&p, a, t, 1e-7 * in->spacing);
            }
            take_out(g, &p, 0, j * cells[0] + i);
        }
    for (int c = 0; c < 2; c++) memory_free(line[c]);
    int unfit = in->holes;
    for (int k = 0; k < g->lines; k++) unfit += g->line[k].parts > 1;
    if (unfit) fit(g);
    double area = 0;
    for (int k = 0; k < g->cells.pieces; k++) {
        struct galerkin_place at[MESHLESS_CELLS_CORNERS * MESHLESS_CELLS_GAUSS * MESHLESS_CELLS_GAUSS];
        double weight[sizeof at / sizeof *at];
        area += meshless_cells_area(g, k);
        g->cells.points += meshless_cells_inside(g, k, at, weight);
    }
    double whole = area_of(in->corners, in->corner);
    for (int k = 0; k < in->holes; k++) whole -= area_of(in->hole[k].corners, in->hole[k].corner);
    ENSURE(fabs(area - whole) < 1e-6 * whole, "the cells cover %g m2 of %g m2", area, whole);
}

void meshless_cells_free(struct galerkin *g) { MEMORY_FREE(g->cells.piece, g->cells.corner); }

double meshless_cells_area(const struct galerkin *g, int piece) {
    const struct galerkin_piece *p = &g->cells.piece[piece];
    return area_of(p->corners, (const double(*)[2])(g->cells.corner + p->first));
}

static void add(struct galerkin_place *at, double *weight, int *n, double x, double y, double w) {
    at[*n].x[0] = at[*n].see[0] = x;
    at[*n].x[1] = at[*n].see[1] = y;
    weight[(*n)++] = w;
}

/* A triangle collapsed at its corner a: x = a + s (b - a + t (c - b)), Jacobian 2 A s. */
static void triangle(const double a[2], const double b[2], const double c[2], int points, struct galerkin_place *at,
                     double *weight, int *n) {
    double s[MESHLESS_CELLS_GAUSS], w[MESHLESS_CELLS_GAUSS];
    const double corner[3][2] = {{a[0], a[1]}, {b[0], b[1]}, {c[0], c[1]}};
    const double twice = 2 * area_of(3, corner);
    meshless_cells_gauss(points, s, w);
    for (int i = 0; i < points; i++)
        for (int j = 0; j < points; j++)
            add(at, weight, n, a[0] + s[i] * (b[0] - a[0] + s[j] * (c[0] - b[0])),
                a[1] + s[i] * (b[1] - a[1] + s[j] * (c[1] - b[1])), twice * s[i] * w[i] * w[j]);
}

static void quadrilateral(const double (*x)[2], int points, struct galerkin_place *at, double *weight, int *n) {
    double s[MESHLESS_CELLS_GAUSS], w[MESHLESS_CELLS_GAUSS];
    meshless_cells_gauss(points, s, w);
    for (int i = 0; i < points; i++)
        for (int j = 0; j < points; j++) {
            double place[2], ds[2], dt[2];
            for (int c = 0; c < 2; c++) {
                const double below = x[0][c] + s[i] * (x[1][c] - x[0][c]), above = x[3][c] + s[i] * (x[2][c] - x[3][c]);
                place[c] = below + s[j] * (above - below);
                ds[c] = (1 - s[j]) * (x[1][c] - x[0][c]) + s[j] * (x[2][c] - x[3][c]);
                dt[c] = above - below;
            }
            add(at, weight, n, place[0], place[1], (ds[0] * dt[1] - ds[1] * dt[0]) * w[i] * w[j]);
        }
}

int meshless_cells_inside(const struct galerkin *g, int piece, struct galerkin_place *at, double *weight) {
    const struct galerkin_piece *p = &g->cells.piece[piece];
    const double(*x)[2] = (const double(*)[2])(g->cells.corner + p->first);
    int n = 0, from = 0;
    if (p->tip < 0 && p->corners == 4) {
        quadrilateral(x, p->points, at, weight, &n);
        return n;
    }
    for (int k = 0; k < p->corners && p->tip >= 0; k++)
        if (x[k][0] == g->tip[p->tip].x[0] && x[k][1] == g->tip[p->tip].x[1]) from = k;
    for (int k = 1; k + 1 < p->corners; k++) {
        const double *b = x[(from + k) % p->corners], *c = x[(from + k + 1) % p->corners];
        triangle(x[from], b, c, p->points, at, weight, &n);
    }
    return n;
}

int meshless_cells_edge(const struct galerkin *g, int piece, int k, struct galerkin_place *at, double *weight,
                        double normal[2]) {
    const struct galerkin_piece *p = &g->cells.piece[piece];
    const double(*x)[2] = (const double(*)[2])(g->cells.corner + p->first);
    const double *a = x[k], *b = x[(k + 1) % p->corners];
    double s[MESHLESS_CELLS_GAUSS], w[MESHLESS_CELLS_GAUSS], centre[2] = {0, 0};
    const double tx = b[0] - a[0], ty = b[1] - a[1], length = hypot(tx, ty);
    int tip;
    const double middle[2] = {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
    const int n = meshless_cut_nearest(g, middle, &tip) < g->cells.near ? g->in.gauss_tip : g->in.gauss;
    normal[0] = ty / length;
    normal[1] = -tx / length;
    for (int i = 0; i < p->corners; i++)
        for (int c = 0; c < 2; c++) centre[c] += x[i][c] / p->corners;
    meshless_cells_gauss(n, s, w);
    const int from_tip = tip >= 0 && a[0] == g->tip[tip].x[0] && a[1] == g->tip[tip].x[1];
    const int to_tip = tip >= 0 && b[0] == g->tip[tip].x[0] && b[1] == g->tip[tip].x[1];
    for (int i = 0; i < n; i++) {
        /* s^2 from a tip: there the functions are smooth in the root of the distance */
        const double f = from_tip ? s[i] * s[i] : to_tip ? 1 - s[i] * s[i] : s[i];
        at[i].x[0] = a[0] + f * tx;
        at[i].x[1] = a[1] + f * ty;
        weight[i] = length * w[i] * (from_tip || to_tip ? 2 * s[i] : 1);
        for (int c = 0; c < 2; c++) at[i].see[c] = at[i].x[c] + 1e-6 * (centre[c] - at[i].x[c]);
    }
    return n;
}

int meshless_cells_is_on(const struct galerkin *g, int piece, int k, const double a[2], const double b[2]) {
    const struct galerkin_piece *p = &g->cells.piece[piece];
    const double *from = g->cells.corner[p->first + k], *to = g->cells.corner[p->first + (k + 1) % p->corners];
    const double middle[2] = {0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])}, slack = 1e-6 * g->in.spacing;
    if (from_segment(middle, a, b) > slack) return 0;
    const double tx = b[0] - a[0], ty = b[1] - a[1], length = hypot(tx, ty);
    const double across = (to[1] - from[1]) * tx - (to[0] - from[0]) * ty;
    return fabs(across) <= 2 * slack * length;
}
