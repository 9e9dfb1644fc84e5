/* Checks the scene's bodies: materials and names, closed outlines, position in the domain. */
#include "base/ensure.h"
#include "physics/limits.h"
#include "scene/check/check.h"
#include "scene/outline.h"
#include "scene/shape.h"
#include "scene/turn.h"

#include <math.h>
#include <string.h>

/* The bounds of all outlines that are not holes. */
static void bounds_of_outlines(const struct scene_body *body, double low[3], double high[3]) {
    for (int i = 0; i < body->outlines; i++) {
        double its_low[2], its_high[2];
        scene_outline_bounds(&body->outline[i], its_low, its_high);
        for (int d = 0; d < 2 && !body->outline[i].is_hole; d++) {
            low[d] = i == 0 ? its_low[d] : fmin(low[d], its_low[d]);
            high[d] = i == 0 ? its_high[d] : fmax(high[d], its_high[d]);
        }
    }
    low[2] = high[2] = 0;
}

int scene_check_body_bounds(const struct scene_body *body, double low[3], double high[3]) {
    int known = 1;
    switch (body->own.shape) {
        SOLID_LATTICE_SHAPES(SOLID_SHAPE_CASE)
        for (int d = 0; d < 3; d++) low[d] = INFINITY, high[d] = -INFINITY;
        known = scene_shape_of(body->own.shape)->bounds(&body->own, low, high);
        for (int i = 0; i < body->pieces; i++)
            known &= scene_shape_of(body->piece[i].shape)->bounds(&body->piece[i], low, high);
        return known;
    case SOLID_RECTANGLE:
    case SOLID_DISC:
    case SOLID_POLYGON:
        bounds_of_outlines(body, low, high);
        return 1;
    case SOLID_IMAGE:
        return scene_check_image_bounds(body, low, high);
    case SOLID_POINTS:
        return 0;
    }
    ENSURE(0, "shape %d", (int)body->own.shape);
}

int scene_check_body_box(const struct scene_check *c, struct scene_path path, const double low[3],
                         const double high[3]) {
    for (int d = 0; d < c->scene->dimension; d++)
        if (low[d] >= high[d]) {
            PROBLEM(c, AT("%s.low", path.text), "must be below high in every direction, %c is not", "xyz"[d]);
            return 0;
        }
    return 1;
}

static void check_body_material(const struct scene_check *c, int b) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_path path = PATH("solid.bodies[%d].material", b);
    if (!CLEAN(c, path.text) || !CLEAN(c, "solid.materials")) return;
    const char *name[PHYSICS_BODIES_MAX];
    for (int m = 0; m < s->materials; m++) name[m] = s->material[m].name;
    scene_check_parts_name(c, path, s->body[b].material, "solid.materials", s->materials, name);
}

/* A body so many lengths of the domain away is probably given in another unit. */
static const double FAR = 10;

/* Checks that a body is at least partly in the domain; a plate must lie in it wholly in periodic directions, because
 * outlines are not continued at the other side. */
static void check_body_place(const struct scene_check *c, int b, const double low[3], const double high[3]) {
    const struct scene_domain *domain = &c->scene->domain;
    for (int d = 0; d < c->scene->dimension; d++) {
        const double slack = 1e-9 * domain->size[d];
        if (high[d] <= 0 || low[d] >= domain->size[d]) {
            const int is_far = low[d] > FAR * domain->size[d] || -high[d] > FAR * domain->size[d];
            PROBLEM(c, AT("solid.bodies[%d]", b),
                    "lies outside the domain: %g to %g m in %c, the domain has 0 to %g m%s", low[d], high[d], "xyz"[d],
                    domain -> size[d], is_far ? "; are all lengths in m?" : "");
            return;
        }
        if (domain->periodic[d] && c->scene->dimension == 2 && (low[d] < -slack || high[d] > domain->size[d] + slack)) {
            PROBLEM(c, AT("solid.bodies[%d]", b),
                    "leaves the domain in the periodic direction %c: %g to %g m, the domain has 0 to %g", "xyz"[d],
                    low[d], high[d], domain -> size[d]);
            return;
        }
    }
}

int scene_check_body_turn(const struct scene_check *c, struct scene_path path, const struct scene_turn *turn) {
    const char *key, *fault = scene_turn_fault(turn, c->root, path.text, &key);
    if (!fault || !CLEAN(c, AT("%s.rotation", path.text))) return 1;
    PROBLEM(c, AT("%s.rotation.%s", path.text, key), "%s", fault);
    return 0;
}

/* Checks that consecutive corners differ and that both ends of an arc are equally far from its centre. */
static int check_corners(const struct scene_check *c, struct scene_path outline, int corners,
                         const struct scene_corner *corner) {
    int arcs = 0;
    for (int i = 0; i < corners; i++) {
        const struct scene_corner *p = &corner[i], *q = &corner[(i + 1) % corners];
        arcs += p->turn != 0;
        if (corners > 1 && p->at[0] == q->at[0] && p->at[1] == q->at[1]) {
            PROBLEM(c, AT("%s[%d].at", outline.text, i), "the next corner is the same");
            return 0;
        }
        const double from = hypot(p->at[0] - p->centre[0], p->at[1] - p->centre[1]),
                     to = hypot(q->at[0] - p->centre[0], q->at[1] - p->centre[1]);
        if (p->turn != 0 && (from == 0 || fabs(from - to) > 1e-6 * from)) {
            PROBLEM(c, AT("%s[%d].centre", outline.text, i),
                    "must be as far from this corner as from the next: %g and %g m", from, to);
            return 0;
        }
    }
    if (corners < 2 || (corners < 3 && arcs == 0)) {
        PROBLEM(c, outline.text, "encloses nothing: needs three corners, or two and an arc");
        return 0;
    }
    return 1;
}

static int check_spheres(const struct scene_check *c, struct scene_path path, const struct scene_part *part) {
    for (int k = 0; k < part->spheres; k++)
        if (!(part->sphere[k][3] > 0)) {
            PROBLEM(c, AT("%s.spheres[%d]", path.text, k), "the radius, its fourth number, must be greater than 0");
            return 0;
        }
    return 1;
}

/* Whether the numbers of a shape, of a body or a part of it, bound anything. */
static int check_own(const struct scene_check *c, struct scene_path path, const struct scene_part *part) {
    if (!scene_check_body_turn(c, path, &part->turn)) return 0;
    switch (part->shape) {
    case SOLID_BOX:
    case SOLID_RECTANGLE:
        return scene_check_body_box(c, path, part->low, part->high);
    case SOLID_POLYGON:
        return check_corners(c, PATH("%s.outline", path.text), part->corners, part->corner);
    case SOLID_SPHERES:
        return check_spheres(c, path, part);
    case SOLID_SPHERE: /* their rules say that radius, radii and length are above 0 */
    case SOLID_CYLINDER:
    case SOLID_ELLIPSOID:
    case SOLID_DISC:
    case SOLID_POINTS:
    case SOLID_IMAGE: /* of a body: scene_check_image */
        return 1;
    }
    ENSURE(0, "shape %d", (int)part->shape);
}

static int check_part(const struct scene_check *c, const char *list, int b, int i, const struct scene_part *part) {
    const struct scene_path path = PATH("solid.bodies[%d].%s[%d]", b, list, i);
    return check_own(c, path, part);
}

/* Whether a body's shape, its pieces and its holes bound anything. */
static int check_shape(const struct scene_check *c, int b) {
    const struct scene_body *body = &c->scene->solid->body[b];
    int good = check_own(c, PATH("solid.bodies[%d]", b), &body->own);
    if (body->own.shape == SOLID_IMAGE) good &= scene_check_image(c, b);
    for (int i = 0; i < body->pieces; i++) good &= check_part(c, "pieces", b, i, &body->piece[i]);
    for (int i = 0; i < body->holes; i++) good &= check_part(c, "holes", b, i, &body->hole[i]);
    return good;
}

/* A velocity at the start needs a stage that begins with it. */
static void check_velocity(const struct scene_check *c, int b) {
    const struct scene_path path = PATH("solid.bodies[%d].velocity", b);
    const double *v = c->scene->solid->body[b].velocity;
    if (scene_check_parts_is_zero(v) || !CLEAN(c, path.text) || c->scene->stages == 0 || !CLEAN(c, "stages")) return;
    const struct scene_stage *first = &c->scene->stage[0];
    if (first->solid == SCENE_SOLID_RIGID)
        PROBLEM(c, path.text, "the first stage, %s, is rigid: the body stands still in it", first->name);
    else if (first->relax)
        PROBLEM(c, path.text, "the first stage, %s, relaxes: it ends with the solid at rest", first->name);
}

/* Which shapes and keys go with particles that stand on no lattice. */
static void check_arrangement(const struct scene_check *c, int b) {
    const struct scene_body *body = &c->scene->solid->body[b];
    const struct scene_path path = PATH("solid.bodies[%d].arrangement", b);
    if (body->arrangement.kind == MESHLESS_LATTICE || !CLEAN(c, path.text)) return;
    if (body->own.shape == SOLID_POINTS && body->arrangement.kind != MESHLESS_PERTURBED)
        PROBLEM(c, AT("%s.kind", path.text),
                "the particles are the points of the file: lattice leaves them where they are, perturbed moves them");
    if (body->contacts_broken)
        PROBLEM(c, AT("%s.kind", path.text), "does not go with contacts: broken, which needs the lattice");
}

void scene_check_body(const struct scene_check *c, int b) {
    const struct scene_body *body = &c->scene->solid->body[b];
    double low[3], high[3];
    if (body->image.materials == 0) check_body_material(c, b);
    check_velocity(c, b);
    check_arrangement(c, b);
    for (int k = 0; k < b; k++)
        if (!strcmp(c->scene->solid->body[k].name, body->name)) {
            PROBLEM(c, AT("solid.bodies[%d].name", b), "is the name of solid.bodies[%d] too", k);
            break;
        }
    if (!CLEAN(c, AT("solid.bodies[%d]", b)) || !CLEAN(c, "domain.size")) return;
    if (body->has_cavities && body->cavity_radius >= sqrt(0.75) * body->cavity_period)
        PROBLEM(c, AT("solid.bodies[%d].cavities.radius", b),
                "leaves nothing of the body: must be less than %.4g m, sqrt(3)/2 periods",
                sqrt(0.75) * body->cavity_period);
    if (!check_shape(c, b) || !scene_check_body_bounds(body, low, high)) return;
    check_body_place(c, b, low, high);
}
