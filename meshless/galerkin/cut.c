/* Cuts of weights by cracks and by their extensions, and the way round a tip. */
#include "meshless/galerkin/cut.h"
#include "base/die.h"
#include "base/ensure.h"

#include <math.h>

double meshless_cut_depth(const struct galerkin_input *in, const double x[2]) {
    double depth = INFINITY;
    for (int k = 0; k < in->corners; k++) {
        const double *a = in->corner[k], *b = in->corner[(k + 1) % in->corners];
        const double tx = b[0] - a[0], ty = b[1] - a[1];
        depth = fmin(depth, (tx * (x[1] - a[1]) - ty * (x[0] - a[0])) / hypot(tx, ty));
    }
    return depth;
}

static void local(const struct galerkin_line *line, const double x[2], double *xi, double *eta) {
    const double dx = x[0] - line->origin[0], dy = x[1] - line->origin[1];
    *xi = dx * line->along[0] + dy * line->along[1];
    *eta = dy * line->along[0] - dx * line->along[1];
}

double meshless_cut_from_line(const struct galerkin_line *line, const double x[2]) {
    double xi, eta;
    local(line, x, &xi, &eta);
    return hypot(xi < 0 ? xi : xi > line->length ? xi - line->length : 0, eta);
}

double meshless_cut_nearest(const struct galerkin *g, const double x[2], int *tip) {
    double least = INFINITY;
    int at = -1;
    for (int k = 0; k < g->tips; k++) {
        const double r = hypot(x[0] - g->tip[k].x[0], x[1] - g->tip[k].x[1]);
        if (r < least) least = r, at = k;
    }
    if (tip) *tip = at;
    return least;
}

void meshless_cut_polar(const struct galerkin_tip *tip, const double x[2], const double see[2], double *r,
                        double *angle) {
    const double dx = x[0] - tip->x[0], dy = x[1] - tip->x[1];
    const double sx = see[0] - tip->x[0], sy = see[1] - tip->x[1];
    const double xi = dx * tip->along[0] + dy * tip->along[1];
    const double eta = dy * tip->along[0] - dx * tip->along[1];
    const double side = sy * tip->along[0] - sx * tip->along[1];
    *r = hypot(xi, eta);
    *angle = copysign(atan2(fabs(eta), xi), side < 0 ? -1 : 1);
}

static void add_tip(struct galerkin *g, int line, int end) {
    const struct galerkin_line *l = &g->line[line];
    const double sign = end ? 1 : -1, at = end ? l->length : 0;
    struct galerkin_tip *tip = &g->tip[g->tips++];
    tip->line = line;
    tip->end = end;
    for (int c = 0; c < 2; c++) {
        tip->x[c] = l->origin[c] + at * l->along[c];
        tip->along[c] = sign * l->along[c];
    }
}

void meshless_cut_begin(struct galerkin *g) {
    const struct galerkin_input *in = &g->in;
    if (in->cracks > GALERKIN_CRACKS)
        die_all(EXIT_CODE_SCENE, "solid.cracks: %d cracks; an element-free plate takes at most %d", in->cracks,
                GALERKIN_CRACKS);
    const double slack = 1e-6 * in->spacing;
    for (int k = 0; k < in->cracks; k++) {
        const double(*end)[2] = in->crack[k].end;
        struct galerkin_line *line = &g->line[g->lines++];
        line->length = hypot(end[1][0] - end[0][0], end[1][1] - end[0][1]);
        if (!(line->length > 0.5 * in->spacing))
            die_all(EXIT_CODE_SCENE,
                    "solid.cracks[%d]: %.6g m long; it must be longer than half a nodal spacing, %.6g m", k,
                    line->length, 0.5 * in->spacing);
        for (int c = 0; c < 2; c++) {
            line->origin[c] = end[0][c];
            line->along[c] = (end[1][c] - end[0][c]) / line->length;
        }
        for (int e = 0; e < 2; e++) {
            const double depth = meshless_cut_depth(in, end[e]);
            if (depth < -slack)
                die_all(EXIT_CODE_SCENE,
                        "solid.cracks[%d]: its end (%.6g, %.6g) is %.6g m outside the body: move it to the border or "
                        "inside",
                        k, end[e][0], end[e][1], -depth);
            line->is_tip[e] = depth > slack;
            if (depth > slack && depth < in->spacing)
                die_all(EXIT_CODE_SCENE,
                        "solid.cracks[%d]: its tip (%.6g, %.6g) is %.6g m from the body's border; it must be at least "
                        "a nodal spacing away, %.6g m: move it, or take a smaller solid.spacing",
                        k, end[e][0], end[e][1], depth, in->spacing);
            line->reach[e] = line->is_tip[e] ? 0 : INFINITY;
            if (line->is_tip[e]) add_tip(g, k, e);
        }
    }
}

void meshless_cut_mark(struct galerkin *g) {
    for (int i = 0; i < g->in.nodes; i++)
        for (int c = 0; c < g->lines; c++)
            if (meshless_cut_from_line(&g->line[c], g->in.node[i]) < g->radius[i])
                g->near_line[i] |= (unsigned char)(1U << c);
    if (g->in.method != GALERKIN_VIRTUAL) return;
    for (int t = 0; t < g->tips; t++) /* the extension ends where no cut node reaches it  (002: sec. 4) */
        for (int i = 0; i < g->in.nodes; i++) {
            const struct galerkin_tip *tip = &g->tip[t];
            if (!(g->near_line[i] & 1U << tip->line)) continue;
            const double ahead =
                (g->in.node[i][0] - tip->x[0]) * tip->along[0] + (g->in.node[i][1] - tip->x[1]) * tip->along[1];
            double *reach = &g->line[tip->line].reach[tip->end];
            *reach = fmax(*reach, ahead + g->radius[i]);
        }
}

/* Whether the line from the place to the node crosses the crack or its extension. */
static int is_hidden(const struct galerkin_line *line, const struct galerkin_place *at, const double node[2]) {
    double xi, eta, xi_see, eta_see, xi_node, eta_node;
    local(line, at->x, &xi, &eta);
    local(line, at->see, &xi_see, &eta_see);
    local(line, node, &xi_node, &eta_node);
    if ((eta_see >= 0) == (eta_node >= 0)) return 0;
    const double apart = fabs(eta) + fabs(eta_node);
    const double crossing = apart > 0 ? xi + (xi_node - xi) * fabs(eta) / apart : xi;
    return crossing > -line->reach[0] && crossing < line->length + line->reach[1];
}

/* The shortest way round the tips of the crack. */
static double round_tip(const struct galerkin *g, int line, const double x[2], const double node[2],
                        double gradient[2]) {
    double least = INFINITY;
    for (int k = 0; k < g->tips; k++) {
        if (g->tip[k].line != line) continue;
        const double dx = x[0] - g->tip[k].x[0], dy = x[1] - g->tip[k].x[1], there = hypot(dx, dy);
        const double way = there + hypot(node[0] - g->tip[k].x[0], node[1] - g->tip[k].x[1]);
        if (!(way < least)) continue;
        least = way;
        gradient[0] = there > 0 ? dx / there : 0;
        gradient[1] = there > 0 ? dy / there : 0;
    }
    return least;
}

double meshless_cut_distance(const struct galerkin *g, const struct galerkin_place *at, int node, double gradient[2]) {
    const double *x = g->in.node[node], dx = at->x[0] - x[0], dy = at->x[1] - x[1], direct = hypot(dx, dy);
    gradient[0] = direct > 0 ? dx / direct : 0;
    gradient[1] = direct > 0 ? dy / direct : 0;
    if (!(direct < g->radius[node])) return INFINITY;
    for (int c = 0; c < g->lines; c++) {
        if (!(g->near_line[node] & 1U << c) || !is_hidden(&g->line[c], at, x)) continue;
        switch (g->in.method) {
        case GALERKIN_VIRTUAL:
        case GALERKIN_VISIBILITY:
            return INFINITY;
        case GALERKIN_DIFFRACTION:
            return round_tip(g, c, at->x, x, gradient);
        }
        ENSURE(0, "method %d", (int)g->in.method);
    }
    return direct;
}
