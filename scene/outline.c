/* Makes outlines of a plate body from rectangles, discs and polygons, and finds their bounds and area. */
#include "scene/outline.h"
#include "base/die.h"
#include "base/ensure.h"
#include "scene/turn.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct scene_outline curve_new(int corners, const struct scene_corner *corner, int is_hole) {
    struct scene_outline o = {corners, malloc((size_t)(corners + 1) * sizeof *corner), is_hole};
    if (!o.corner) die(EXIT_CODE_FILE, "no memory left for the scene");
    if (corners > 0) memcpy(o.corner, corner, (size_t)corners * sizeof *corner);
    return o;
}

static void turn_corner(const struct scene_turn *turn, struct scene_corner *corner) {
    const double x[3] = {corner->at[0], corner->at[1]};
    double y[3];
    scene_turn_point(turn, x, y);
    corner->at[0] = y[0];
    corner->at[1] = y[1];
}

/* The curve of a shape. Returns 0 for a shape without one; as a part of a plate it is a mistake that is reported. */
static int curve_of(const struct scene_part *p, int is_hole, struct scene_outline *to) {
    const double *low = p->low, *high = p->high, *c = p->centre, r = p->radius;
    struct scene_corner rectangle[4] = {
        {.at = {low[0], low[1]}}, {.at = {high[0], low[1]}}, {.at = {high[0], high[1]}}, {.at = {low[0], high[1]}}};
    const struct scene_corner disc[2] = {{{c[0] - r, c[1]}, {c[0], c[1]}, 1}, {{c[0] + r, c[1]}, {c[0], c[1]}, 1}};
    switch (p->shape) {
    case SOLID_RECTANGLE:
        for (int i = 0; i < 4; i++) turn_corner(&p->turn, &rectangle[i]);
        *to = curve_new(4, rectangle, is_hole);
        return 1;
    case SOLID_DISC:
        *to = curve_new(2, disc, is_hole);
        return 1;
    case SOLID_POLYGON:
        *to = curve_new(p->corners, p->corner, is_hole);
        return 1;
        SOLID_LATTICE_SHAPES(SOLID_SHAPE_CASE)
    case SOLID_POINTS:
    case SOLID_IMAGE:
        return 0;
    }
    ENSURE(0, "shape %d", (int)p->shape);
}

void scene_outline_make(struct scene_body *body) {
    struct scene_outline own;
    if (!curve_of(&body->own, 0, &own)) return;
    body->outline = calloc((size_t)(1 + body->pieces + body->holes), sizeof *body->outline);
    if (!body->outline) die(EXIT_CODE_FILE, "no memory left for the scene");
    body->outline[body->outlines++] = own;
    for (int i = 0; i < body->pieces; i++)
        body->outlines += curve_of(&body->piece[i], 0, &body->outline[body->outlines]);
    for (int i = 0; i < body->holes; i++) body->outlines += curve_of(&body->hole[i], 1, &body->outline[body->outlines]);
}

void scene_outline_free(struct scene_body *body) {
    for (int i = 0; i < body->outlines; i++) free(body->outline[i].corner);
    free(body->outline);
    body->outline = NULL;
    body->outlines = 0;
}

/* Whether an arc from angle a to angle b passes the angle e; angles in quarters of a turn. */
static int passes(double a, double b, int turn, double e) {
    const double sweep = fmod(turn * (b - a) + 8, 4), to = fmod(turn * (e - a) + 8, 4);
    return to <= (sweep > 0 ? sweep : 4);
}

void scene_outline_bounds(const struct scene_outline *o, double low[2], double high[2]) {
    low[0] = low[1] = INFINITY;
    high[0] = high[1] = -INFINITY;
    for (int i = 0; i < o->corners; i++) {
        const struct scene_corner *p = &o->corner[i], *q = &o->corner[(i + 1) % o->corners];
        for (int d = 0; d < 2; d++) {
            low[d] = fmin(low[d], p->at[d]);
            high[d] = fmax(high[d], p->at[d]);
        }
        if (p->turn == 0) continue;
        const double x = p->at[0] - p->centre[0], y = p->at[1] - p->centre[1], r = hypot(x, y);
        const double a = atan2(y, x) / M_PI_2, b = atan2(q->at[1] - p->centre[1], q->at[0] - p->centre[0]) / M_PI_2;
        for (int e = 0; e < 4; e++) {
            const int d = e % 2;
            if (!passes(a, b, p->turn, e)) continue;
            if (e < 2)
                high[d] = fmax(high[d], p->centre[d] + r);
            else
                low[d] = fmin(low[d], p->centre[d] - r);
        }
    }
}

/* Of one curve, either way round: the polygon of its corners, and between each arc and its chord a segment of a disc.
 */
static double area_of(const struct scene_outline *o) {
    double twice = 0;
    for (int i = 0; i < o->corners; i++) {
        const struct scene_corner *p = &o->corner[i], *q = &o->corner[(i + 1) % o->corners];
        twice += p->at[0] * q->at[1] - p->at[1] * q->at[0];
        if (p->turn == 0) continue;
        const double x = p->at[0] - p->centre[0], y = p->at[1] - p->centre[1];
        double sweep = p->turn * (atan2(q->at[1] - p->centre[1], q->at[0] - p->centre[0]) - atan2(y, x));
        if (sweep <= 0) sweep += 2 * M_PI;
        twice += p->turn * (x * x + y * y) * (sweep - sin(sweep));
    }
    return 0.5 * fabs(twice);
}

double scene_outline_area(const struct scene_body *body) {
    double area = 0;
    for (int i = 0; i < body->outlines; i++) area += (body->outline[i].is_hole ? -1 : 1) * area_of(&body->outline[i]);
    return area;
}
