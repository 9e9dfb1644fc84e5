/* Finds the directions of turned boxes and regions from axis and angle or from two directions, and their bounds. */
#include "scene/turn.h"
#include "scene/text/path.h"

#include <math.h>
#include <string.h>

static const double RIGHT_ANGLE = 1e-6; /* cosine that counts as 0 */

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const double a[3], const double b[3], double c[3]) {
    for (int d = 0; d < 3; d++) c[d] = a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
}

/* Returns the length that it had. */
static double normalize(double a[3]) {
    const double length = sqrt(dot(a, a));
    for (int d = 0; d < 3 && length > 0; d++) a[d] /= length;
    return length;
}

/* Exact at multiples of a right angle. */
static void sine_cosine(double degrees, double *sine, double *cosine) {
    static const double sines[4] = {0, 1, 0, -1};
    const double quarters = fmod(degrees, 360) / 90;
    const int k = (int)quarters & 3;
    const int is_whole = quarters == rint(quarters);
    *sine = is_whole ? sines[k] : sin(quarters * M_PI_2);
    *cosine = is_whole ? sines[(k + 1) & 3] : cos(quarters * M_PI_2);
}

/* Rodrigues' formula, for the three unit vectors. */
static void edges_of_angle(struct scene_turn *t, const double axis[3]) {
    double a[3], s, c;
    memcpy(a, axis, sizeof a);
    normalize(a);
    sine_cosine(t->angle, &s, &c);
    for (int k = 0; k < 3; k++) {
        double e[3] = {0}, across[3];
        e[k] = 1;
        cross(a, e, across);
        for (int d = 0; d < 3; d++) t->edge[k][d] = c * e[d] + s * across[d] + (1 - c) * a[k] * a[d];
    }
}

static void edges_of_axes(struct scene_turn *t) {
    memcpy(t->edge[0], t->axes[0], sizeof t->edge[0]);
    memcpy(t->edge[1], t->axes[1], sizeof t->edge[1]);
    normalize(t->edge[0]);
    const double along = dot(t->edge[0], t->edge[1]);
    for (int d = 0; d < 3; d++) t->edge[1][d] -= along * t->edge[0][d];
    normalize(t->edge[1]);
    cross(t->edge[0], t->edge[1], t->edge[2]);
}

static int is_given(const struct scene_node *root, const char *path, const char *key) {
    return scene_node_find(root, AT("%s.rotation%s", path, key)) != NULL;
}

const char *scene_turn_fault(const struct scene_turn *t, const struct scene_node *root, const char *path,
                             const char **key) {
    double a[3], b[3];
    if (is_given(root, path, ".axes")) {
        *key = "axes";
        memcpy(a, t->axes[0], sizeof a);
        memcpy(b, t->axes[1], sizeof b);
        if (!(normalize(a) > 0) || !(normalize(b) > 0)) return "must be two directions, and one of them is 0";
        return fabs(dot(a, b)) > RIGHT_ANGLE ? "must be two directions that are perpendicular to each other" : NULL;
    }
    *key = "axis";
    return is_given(root, path, ".axis") && !(dot(t->axis, t->axis) > 0) ? "must not be 0 in every direction" : NULL;
}

/* centre: of what is turned. */
static void derive(struct scene_turn *t, const struct scene_node *root, struct scene_path path,
                   const double centre[3]) {
    static const double z[3] = {0, 0, 1};
    const char *key;
    t->is_turned = is_given(root, path.text, "") && !scene_turn_fault(t, root, path.text, &key);
    if (!t->is_turned) return;
    if (!is_given(root, path.text, ".about")) memcpy(t->about, centre, sizeof t->about);
    if (is_given(root, path.text, ".axes"))
        edges_of_axes(t);
    else
        edges_of_angle(t, is_given(root, path.text, ".axis") ? t->axis : z);
}

static void derive_box(struct scene_turn *t, const struct scene_node *root, struct scene_path path, const double low[3],
                       const double high[3]) {
    double centre[3];
    for (int d = 0; d < 3; d++) centre[d] = (low[d] + high[d]) / 2;
    derive(t, root, path, centre);
}

/* Of a body or a part of it; boxes and rectangles have no key centre. */
static void derive_shape(struct scene_turn *t, const struct scene_node *root, struct scene_path path,
                         enum solid_shape shape, const double low[3], const double high[3], const double centre[3]) {
    if (shape == SOLID_BOX || shape == SOLID_RECTANGLE)
        derive_box(t, root, path, low, high);
    else
        derive(t, root, path, centre);
}

static void derive_body(struct scene_body *body, const struct scene_node *root, int b) {
    derive_shape(&body->own.turn, root, PATH("solid.bodies[%d]", b), body->own.shape, body->own.low, body->own.high,
                 body->own.centre);
    for (int i = 0; i < body->pieces; i++) {
        struct scene_part *p = &body->piece[i];
        derive_shape(&p->turn, root, PATH("solid.bodies[%d].pieces[%d]", b, i), p->shape, p->low, p->high, p->centre);
    }
    for (int i = 0; i < body->holes; i++) {
        struct scene_part *p = &body->hole[i];
        derive_shape(&p->turn, root, PATH("solid.bodies[%d].holes[%d]", b, i), p->shape, p->low, p->high, p->centre);
    }
}

void scene_turn_derive(struct scene *scene, const struct scene_node *root) {
    struct scene_solid *s = scene->solid;
    if (!s) return;
    for (int b = 0; b < s->bodies; b++) derive_body(&s->body[b], root, b);
    for (int k = 0; k < s->constraints; k++)
        derive_box(&s->constraint[k].turn, root, PATH("solid.constraints[%d]", k), s->constraint[k].low,
                   s->constraint[k].high);
    for (int k = 0; k < s->unbreakables; k++)
        derive_box(&s->unbreakable[k].turn, root, PATH("solid.unbreakable[%d]", k), s->unbreakable[k].low,
                   s->unbreakable[k].high);
    for (int k = 0; k < s->loads; k++)
        derive_box(&s->load[k].turn, root, PATH("solid.loads[%d]", k), s->load[k].low, s->load[k].high);
    struct scene_refinement *r = s->refinement;
    if (!r) return;
    derive_box(&r->turn, root, PATH("solid.refinement"), r->low, r->high);
    for (int k = 0; k < r->starts; k++)
        derive_box(&r->start[k].turn, root, PATH("solid.refinement.start[%d]", k), r->start[k].low, r->start[k].high);
}

void scene_turn_point(const struct scene_turn *t, const double x[3], double y[3]) {
    double from[3];
    memcpy(y, x, sizeof from);
    if (!t->is_turned) return;
    for (int d = 0; d < 3; d++) from[d] = x[d] - t->about[d];
    for (int d = 0; d < 3; d++)
        y[d] = from[0] * t->edge[0][d] + from[1] * t->edge[1][d] + from[2] * t->edge[2][d] + t->about[d];
}

void scene_turn_box(const struct scene_turn *t, const double low[3], const double high[3], double its_low[3],
                    double its_high[3]) {
    double centre[3];
    if (!t->is_turned) {
        memcpy(its_low, low, sizeof centre);
        memcpy(its_high, high, sizeof centre);
        return;
    }
    for (int d = 0; d < 3; d++) centre[d] = (low[d] + high[d]) / 2;
    scene_turn_point(t, centre, its_low);
    memcpy(its_high, its_low, sizeof centre);
    for (int d = 0; d < 3; d++)
        for (int k = 0; k < 3; k++) {
            const double half = fabs(t->edge[k][d]) * ((high[k] - low[k]) / 2);
            its_low[d] -= half;
            its_high[d] += half;
        }
}
