/* Materials, bodies and regions that fit together and into the domain. */
#include "base/scene_check.h"

#include <math.h>
#include <string.h>

int scene_check_bounds(const struct scene_body *body, double low[3], double high[3]) {
    for (int d = 0; d < 3; d++) {
        const double half =
            body->shape == SCENE_CYLINDER && d == body->axis ? body->length / 2 : body->radius;
        low[d] = body->shape == SCENE_BOX ? body->low[d] : body->centre[d] - half;
        high[d] = body->shape == SCENE_BOX ? body->high[d] : body->centre[d] + half;
    }
    return body->shape != SCENE_POINTS;
}

static void check_material(const struct scene_check *c, int m) {
    const struct scene_material *material = c->scene->solid->material;
    if (scene_check_clean(c, scene_path("solid.materials[%d].poisson_ratio", m)) &&
        fabs(material[m].poisson_ratio - 0.25) > 1e-9)
        scene_problem_at(c->problems, c->root, scene_path("solid.materials[%d].poisson_ratio", m).text,
                         "must be 0.25: the bond-based model in 3D has Poisson's ratio 1/4");
    for (int k = 0; k < m; k++)
        if (!strcmp(material[k].name, material[m].name) &&
            scene_check_clean(c, scene_path("solid.materials[%d].name", m)) &&
            scene_check_clean(c, scene_path("solid.materials[%d].name", k))) {
            scene_problem_at(c->problems, c->root, scene_path("solid.materials[%d].name", m).text,
                             "is the name of solid.materials[%d] too", k);
            return;
        }
}

static void check_body_material(const struct scene_check *c, int b) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_path path = scene_path("solid.bodies[%d].material", b);
    if (!scene_check_clean(c, path) || !scene_check_clean(c, scene_path("solid.materials"))) return;
    const char *name[255];
    for (int m = 0; m < s->materials; m++) {
        name[m] = s->material[m].name;
        if (!strcmp(name[m], s->body[b].material)) return;
    }
    const char *nearest = scene_problem_nearest(s->body[b].material, s->materials, name);
    scene_problem_at(c->problems, c->root, path.text, "is no name in solid.materials%s%s%s",
                     nearest ? "; did you mean " : "", nearest ? nearest : "", nearest ? "?" : "");
}

/* A body that is partly in the domain, and in periodic directions wholly: its particles would stand there twice. */
static void check_body_place(const struct scene_check *c, int b, const double low[3], const double high[3]) {
    const struct scene_domain *domain = &c->scene->domain;
    for (int d = 0; d < 3; d++) {
        const double slack = 1e-9 * domain->size[d];
        if (high[d] <= 0 || low[d] >= domain->size[d]) {
            scene_problem_at(c->problems, c->root, scene_path("solid.bodies[%d]", b).text,
                             "lies outside the domain: %g to %g m in %c, the domain has 0 to %g", low[d],
                             high[d], "xyz"[d], domain -> size[d]);
            return;
        }
        if (domain->periodic[d] && (low[d] < -slack || high[d] > domain->size[d] + slack)) {
            scene_problem_at(
                c->problems, c->root, scene_path("solid.bodies[%d]", b).text,
                "leaves the domain in the periodic direction %c: %g to %g m, the domain has 0 to %g",
                "xyz"[d], low[d], high[d], domain -> size[d]);
            return;
        }
    }
}

static void check_body(const struct scene_check *c, int b) {
    const struct scene_body *body = &c->scene->solid->body[b];
    double low[3], high[3];
    check_body_material(c, b);
    for (int k = 0; k < b; k++)
        if (!strcmp(c->scene->solid->body[k].name, body->name)) {
            scene_problem_at(c->problems, c->root, scene_path("solid.bodies[%d].name", b).text,
                             "is the name of solid.bodies[%d] too", k);
            break;
        }
    if (!scene_check_clean(c, scene_path("solid.bodies[%d]", b)) ||
        !scene_node_is_clean(c->root, "domain.size"))
        return;
    if (body->has_cavities && body->cavity_radius >= sqrt(0.75) * body->cavity_period)
        scene_problem_at(c->problems, c->root, scene_path("solid.bodies[%d].cavities.radius", b).text,
                         "leaves nothing of the body: must be less than %.4g m, sqrt(3)/2 periods",
                         sqrt(0.75) * body->cavity_period);
    if (!scene_check_bounds(body, low, high)) return;
    for (int d = 0; d < 3; d++)
        if (low[d] >= high[d]) {
            scene_problem_at(c->problems, c->root, scene_path("solid.bodies[%d].low", b).text,
                             "must be below high in every direction, %c is not", "xyz"[d]);
            return;
        }
    check_body_place(c, b, low, high);
}

/* Whether some body, as far as its bounds are known, reaches into the box. */
static int holds_body(const struct scene_solid *s, const double low[3], const double high[3]) {
    for (int b = 0; b < s->bodies; b++) {
        double body_low[3], body_high[3];
        if (!scene_check_bounds(&s->body[b], body_low, body_high)) return 1;
        int d = 0;
        for (int e = 0; e < 3; e++)
            if (body_low[e] >= body_high[e]) return 1; /* said of the body */
        while (d < 3 && low[d] < body_high[d] && high[d] > body_low[d]) d++;
        if (d == 3) return 1;
    }
    return 0;
}

static void check_region(const struct scene_check *c, const char *list, int i, const double low[3],
                         const double high[3]) {
    const struct scene_path path = scene_path("solid.%s[%d]", list, i);
    if (!scene_check_clean(c, path)) return;
    for (int d = 0; d < 3; d++)
        if (low[d] >= high[d]) {
            scene_problem_at(c->problems, c->root, scene_path("solid.%s[%d].low", list, i).text,
                             "must be below high in every direction, %c is not", "xyz"[d]);
            return;
        }
    if (scene_node_is_clean(c->root, "solid.bodies") && !holds_body(c->scene->solid, low, high))
        scene_problem_at(c->problems, c->root, path.text, "no body reaches into this region");
}

static void check_constraint(const struct scene_check *c, int i) {
    const struct scene_constraint *k = &c->scene->solid->constraint[i];
    check_region(c, "constraints", i, k->low, k->high);
    if (!scene_check_clean(c, scene_path("solid.constraints[%d].directions", i))) return;
    const char *word = k->directions;
    int good = 1;
    for (const char *at = word; *at; at++) good &= strchr("xyz", *at) != NULL && !strchr(at + 1, *at);
    if (!good)
        scene_problem_at(c->problems, c->root, scene_path("solid.constraints[%d].directions", i).text,
                         "must be a word of the letters x, y and z, each at most once");
    for (int d = 0; good && d < 3; d++)
        if (k->velocity[d] != 0 && !k->direction[d]) {
            scene_problem_at(c->problems, c->root, scene_path("solid.constraints[%d].velocity", i).text,
                             "has a part in %c, which is not in directions (%s)", "xyz"[d], word);
            return;
        }
}

/* Across a periodic direction the lattice must go on, and no family may meet itself. */
static void check_period(const struct scene_check *c, int d) {
    const struct scene_solid *s = c->scene->solid;
    const double size = c->scene->domain.size[d], n = size / s->spacing;
    double widest = 0;
    for (int m = 0; m < s->materials; m++)
        widest = fmax(widest, 2 * (s->material[m].horizon_ratio + 0.5) * s->spacing);
    if (fabs(n - round(n)) > 1e-6) {
        scene_problem_at(c->problems, c->root, "solid.spacing",
                         "the periodic direction %c (%g m) must hold a whole number of particles, not %.6g",
                         "xyz"[d], size, n);
    } else if (size < widest * (1 + 1e-9)) {
        scene_problem_at(c->problems, c->root, "domain.size",
                         "a particle's family would meet itself across the periodic direction %c: more than "
                         "%g m are needed",
                         "xyz"[d], widest);
    }
}

void scene_check_solid(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    if (!s) return;
    for (int m = 0; m < s->materials; m++) check_material(c, m);
    for (int b = 0; b < s->bodies; b++) check_body(c, b);
    for (int i = 0; i < s->constraints; i++) check_constraint(c, i);
    for (int i = 0; i < s->unbreakables; i++)
        check_region(c, "unbreakable", i, s->unbreakable[i].low, s->unbreakable[i].high);
    for (int i = 0; i < s->loads; i++) check_region(c, "loads", i, s->load[i].low, s->load[i].high);
    const int known = scene_node_is_clean(c->root, "domain.size") &&
                      scene_node_is_clean(c->root, "solid.spacing") &&
                      scene_node_is_clean(c->root, "solid.materials");
    for (int d = 0; d < 3; d++)
        if (known && c->scene->domain.periodic[d]) check_period(c, d);
}
