/* Cuts of weights by cracks and by their extensions, and the way round a tip. */
#include "meshless/galerkin/cut.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"

#include <math.h>

/* A support that touches a crack does not meet it, whatever the rounding says, over its radius. */
static const double TOUCH = 1e-9;

double meshless_cut_depth(const struct galerkin_input *in, const double x[2]) {
    double depth = INFINITY;
    for (int k = 0; k < in->corners; k++) {
        const double *a = in->corner[k], *b = in->corner[(k + 1) % in->corners];
        const double tx = b[0] - a[0], ty = b[1] - a[1];
        depth = fmin(depth, (tx * (x[1] - a[1]) - ty * (x[0] - a[0])) / hypot(tx, ty));
    }
    for (int h = 0; h < in->holes; h++) {
        const struct galerkin_hole *hole = &in->hole[h];
        double outside = -INFINITY;
        for (int k = 0; k < hole->corners; k++) {
            const double *a = hole->corner[k], *b = hole->corner[(k + 1) % hole->corners];
            const double tx = b[0] - a[0], ty = b[1] - a[1];
            outside = fmax(outside, (ty * (x[0] - a[0]) - tx * (x[1] - a[1])) / hypot(tx, ty));
        }
        depth = fmin(depth, outside);
    }
    return depth;
}

static void local(const struct galerkin_part *part, const double x[2], double *xi, double *eta) {
    const double dx = x[0] - part->origin[0], dy = x[1] - part->origin[1];
    *xi = dx * part->along[0] + dy * part->along[1];
    *eta = dy * part->along[0] - dx * part->along[1];
}

static double from_part(const struct galerkin_part *part, const double x[2]) {
    double xi, eta;
    local(part, x, &xi, &eta);
    return hypot(xi < 0 ? xi : xi > part->length ? xi - part->length : 0, eta);
}

double meshless_cut_from_line(const struct galerkin_line *line, const double x[2]) {
    double least = INFINITY;
    for (int p = 0; p < line->parts; p++) least = fmin(least, from_part(&line->part[p], x));
    return least;
}

const struct galerkin_part *meshless_cut_part(const struct galerkin *g, const struct galerkin_tip *tip) {
    const struct galerkin_line *line = &g->line[tip->line];
    return &line->part[tip->end ? line->parts - 1 : 0];
}

double meshless_cut_from_bends(const struct galerkin *g, const struct galerkin_tip *tip, const double x[2]) {
    const struct galerkin_line *line = &g->line[tip->line];
    double least = INFINITY;
    for (int p = 0; p < line->parts; p++)
        if (&line->part[p] != meshless_cut_part(g, tip)) least = fmin(least, from_part(&line->part[p], x));
    return least;
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
    struct galerkin_tip *tip = &g->tip[g->tips++];
    tip->line = line;
    tip->end = end;
    const struct galerkin_part *l = meshless_cut_part(g, tip);
    const double sign = end ? 1 : -1, at = end ? l->length : 0;
    for (int c = 0; c < 2; c++) {
        tip->x[c] = l->origin[c] + at * l->along[c];
        tip->along[c] = sign * l->along[c];
    }
}

static void set_parts(struct galerkin *g, int number) {
    const struct galerkin_crack *crack = &g->in.crack[number];
    struct galerkin_line *line = &g->line[number];
    line->parts = 1 + crack->bends;
    line->part = memory_new(MEMORY_SOLID, (size_t)line->parts, sizeof *line->part);
    for (int p = 0; p < line->parts; p++) {
        const double *from = p ? crack->bend[p - 1] : crack->end[0];
        const double *to = p < crack->bends ? crack->bend[p] : crack->end[1];
        struct galerkin_part *part = &line->part[p];
        part->length = hypot(to[0] - from[0], to[1] - from[1]);
        if (!(part->length > 0.5 * g->in.spacing) && line->parts == 1)
            die_all(EXIT_CODE_SCENE,
                    "solid.cracks[%d]: %.6g m long; it must be longer than half a nodal spacing, %.6g m", number,
                    part->length, 0.5 * g->in.spacing);
        if (!(part->length > 0))
            die_all(EXIT_CODE_SCENE, "solid.cracks[%d]: its points %d and %d are at the same place, (%.6g, %.6g)",
                    number, p, p + 1, to[0], to[1]);
        for (int c = 0; c < 2; c++) {
            part->origin[c] = from[c];
            part->along[c] = (to[c] - from[c]) / part->length;
        }
        if (p < crack->bends && meshless_cut_depth(&g->in, to) <= 0)
            die_all(EXIT_CODE_SCENE, "solid.cracks[%d]: its point %d, (%.6g, %.6g), is not inside the body", number,
                    p + 1, to[0], to[1]);
    }
}

double meshless_cut_reach(const struct galerkin *g, const struct galerkin_line *line, int end) {
    return isfinite(line->reach[end]) ? line->reach[end] : 2 * g->widest;
}

void meshless_cut_end(struct galerkin *g) {
    for (int k = 0; k < g->lines; k++) memory_free(g->line[k].part);
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
        set_parts(g, k);
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
            if (meshless_cut_from_line(&g->line[c], g->in.node[i]) < (1 - TOUCH) * g->radius[i])
                g->near_line[i] |= (unsigned char)(1U << c);
    if (g->in.method != GALERKIN_VIRTUAL) return;
    for (int t = 0; t < g->tips; t++) /* the extension ends where no cut node reaches it  (002: sec. 4) */
        for (int i = 0; i < g->in.nodes; i++) {
            const struct galerkin_tip *tip = &g->tip[t];
            if (!(g->near_line[i] & 1U << tip->line)) continue;
            const double ahead =
                (g->in.node[i][0] - tip->x[0]) * tip->along[0] + (g->in.node[i][1] - tip->x[1]) * tip->along[1];
            double *reach = &g->line[tip->line].reach[tip->end];
            const double lateral =
                (g->in.node[i][1] - tip->x[1]) * tip->along[0] - (g->in.node[i][0] - tip->x[0]) * tip->along[1];
            if (g->line[tip->line].parts > 1 && fabs(lateral) >= g->radius[i]) continue; /* past a bend */
            *reach = fmax(*reach, ahead + g->radius[i]);
        }
}

static double turn(const double a[2], const double b[2], const double c[2]) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* The ends of a part of a crack, the crack's first and last ones with the extension. They end a little short of it: a
 * line that touches the end does not cross. */
static void part_ends(const struct galerkin *g, const struct galerkin_line *line, int p, double a[2], double b[2]) {
    const struct galerkin_part *part = &line->part[p];
    const double from = p ? 0 : 1e-9 * g->widest - meshless_cut_reach(g, line, 0);
    const double to = part->length + meshless_cut_reach(g, line, 1) - 1e-9 * g->widest;
    for (int c = 0; c < 2; c++) {
        a[c] = part->origin[c] + from * part->along[c];
        /* the next part's first point to the bit, so that a line through a bend crosses one of the two */
        b[c] = p + 1 < line->parts ? line->part[p + 1].origin[c] : part->origin[c] + to * part->along[c];
    }
}

/* Whether the line from the place to the node crosses the crack and its extensions an odd number of times: the crack
 * divides the body, and twice across it is back on the same side. Only a place on the crack is taken beside it: both
 * pieces at an edge see the same nodes. */
static int is_across(const struct galerkin *g, const struct galerkin_line *line, const struct galerkin_place *at,
                     const double node[2]) {
    const double *x = at->x;
    double a[2], b[2];
    int odd = 0;
    for (int p = 0; p < line->parts && x == at->x; p++) {
        part_ends(g, line, p, a, b);
        const double tx = b[0] - a[0], ty = b[1] - a[1], along = (x[0] - a[0]) * tx + (x[1] - a[1]) * ty;
        const double length = hypot(tx, ty);
        if (fabs(turn(a, b, x)) < 1e-9 * g->widest * length && along > 0 && along < length * length) x = at->see;
    }
    for (int p = 0; p < line->parts; p++) {
        part_ends(g, line, p, a, b);
        if ((turn(x, node, a) >= 0) == (turn(x, node, b) >= 0)) continue;
        odd ^= (turn(a, b, x) >= 0) != (turn(a, b, node) >= 0);
    }
    return odd;
}

/* Whether the line from the place to the node crosses the crack or its extension. */
static int is_hidden(const struct galerkin *g, const struct galerkin_line *line, const struct galerkin_place *at,
                     const double node[2]) {
    double xi, eta, xi_see, eta_see, xi_node, eta_node;
    if (line->parts > 1) return is_across(g, line, at, node);
    const struct galerkin_part *part = line->part;
    local(part, at->x, &xi, &eta);
    local(part, at->see, &xi_see, &eta_see);
    local(part, node, &xi_node, &eta_node);
    if ((eta_see >= 0) == (eta_node >= 0)) return 0;
    const double height = fabs(eta) + fabs(eta_node);
    const double crossing = height > 0 ? xi + (xi_node - xi) * fabs(eta) / height : xi;
    return crossing > -line->reach[0] && crossing < part->length + line->reach[1];
}

/* The shortest way round the tips of the crack. */
static double round_tip(const struct galerkin *g, int line, const double x[2], const double node[2],
                        double gradient[2]) {
    double least = INFINITY;
    for (int k = 0; k < g->tips; k++) {
        if (g->tip[k].line != line) continue;
        const double dx = x[0] - g->tip[k].x[0], dy = x[1] - g->tip[k].x[1], there = hypot(dx, dy);
        const double length = there + hypot(node[0] - g->tip[k].x[0], node[1] - g->tip[k].x[1]);
        if (!(length < least)) continue;
        least = length;
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
        if (!(g->near_line[node] & 1U << c) || !is_hidden(g, &g->line[c], at, x)) continue;
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
