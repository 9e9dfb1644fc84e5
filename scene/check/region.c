/* Checks constraints, loads, cracks, initial displacements and refinement regions: whether they reach a body. */
/* Checks the data given for a part of the solid: regions, edges, cracks, initial displacements and refinement must
 * reach a body, and must not contradict each other. */
#include "scene/check/check.h"
#include "scene/turn.h"

#include <math.h>
#include <string.h>

/* The bounds of a body's particles: the whole period in a direction in which it extends beyond a side, as it comes in
 * at the other. */
static void wrap(const struct scene_domain *domain, double low[3], double high[3]) {
    for (int d = 0; d < 3; d++) {
        const double slack = 1e-9 * domain->size[d];
        if (!domain->periodic[d] || (low[d] >= -slack && high[d] <= domain->size[d] + slack)) continue;
        low[d] = 0;
        high[d] = domain->size[d];
    }
}

/* Whether some body, as far as its bounds are known, overlaps the box, or (touching) touches it. */
static int holds_body(const struct scene_check *c, const double low[3], const double high[3], int touching) {
    const struct scene_solid *s = c->scene->solid;
    const int dim = c->scene->dimension;
    for (int b = 0; b < s->bodies; b++) {
        double body_low[3], body_high[3];
        if (!scene_check_body_bounds(&s->body[b], body_low, body_high)) return 1;
        int d = 0;
        for (int e = 0; e < dim; e++)
            if (body_low[e] >= body_high[e]) return 1; /* reported with the body */
        wrap(&c->scene->domain, body_low, body_high);
        while (d < dim && (touching ? low[d] <= body_high[d] && high[d] >= body_low[d]
                                    : low[d] < body_high[d] && high[d] > body_low[d]))
            d++;
        if (d == dim) return 1;
    }
    return 0;
}

static void check_region(const struct scene_check *c, struct scene_path path, const double low[3], const double high[3],
                         const struct scene_turn *turn) {
    double its_low[3], its_high[3];
    if (!scene_check_parts_clean(c, path) || !scene_check_body_turn(c, path, turn) ||
        !scene_check_body_box(c, path, low, high))
        return;
    scene_turn_box(turn, low, high, its_low, its_high);
    if (scene_node_is_clean(c->root, "solid.bodies") && !holds_body(c, its_low, its_high, 0))
        scene_problem_at(c->problems, c->root, path.text, "no body reaches into this region");
}

/* The bounds of a set of points. */
static void bounds_of(int n, const double (*point)[3], double low[3], double high[3]) {
    for (int d = 0; d < 3; d++) {
        low[d] = INFINITY;
        high[d] = -INFINITY;
        for (int i = 0; i < n; i++) {
            low[d] = fmin(low[d], point[i][d]);
            high[d] = fmax(high[d], point[i][d]);
        }
    }
}

/* The name of a stage, one of the first ones, of which the run keeps when they began. */
static void check_from(const struct scene_check *c, struct scene_path above, const struct scene_time *time) {
    const struct scene_path path = scene_check_parts_path("%s.time_from", above.text);
    if (!time->from[0] || !scene_check_parts_clean(c, path)) return;
    if (time->stage < 0)
        scene_problem_at(c->problems, c->root, path.text, "is the name of no stage");
    else if (time->stage > SCENE_TIMED_MAX)
        scene_problem_at(c->problems, c->root, path.text, "must be one of the first %d stages", SCENE_TIMED_MAX);
}

void scene_check_region_time(const struct scene_check *c, struct scene_path above, const struct scene_time *time) {
    const struct scene_path path = scene_check_parts_path("%s.time", above.text);
    check_from(c, above, time);
    if (!scene_check_parts_clean(c, path)) return;
    for (int i = 1; i < time->n; i++)
        if (time->t[i] <= time->t[i - 1]) {
            scene_problem_at(c->problems, c->root, scene_check_parts_path("%s[%d]", path.text, i).text,
                             "must be later than the entry before, at %g s", time->t[i - 1]);
            return;
        }
}

/* Reports a prescribed value in a direction that is not constrained. */
static void check_imposed(const struct scene_check *c, int i, const char *key, const double value[3]) {
    const struct scene_constraint *k = &c->scene->solid->constraint[i];
    const struct scene_path path = scene_check_parts_path("solid.constraints[%d].%s", i, key);
    if (!scene_check_parts_clean(c, path)) return;
    for (int d = 0; d < c->scene->dimension; d++)
        if (value[d] != 0 && !k->direction[d]) {
            scene_problem_at(c->problems, c->root, path.text, "has a part in %c, which is not in directions (%s)",
                             "xyz"[d], k -> directions);
            return;
        }
}

/* Which pieces of an image are loose is found by voxels, in boxes along the axes. */
static void check_image_turn(const struct scene_check *c, struct scene_path above, const struct scene_turn *turn) {
    const struct scene_path path = scene_check_parts_path("%s.rotation", above.text);
    const struct scene_solid *s = c->scene->solid;
    for (int b = 0; b < s->bodies; b++)
        if (turn->is_turned && s->body[b].own.shape == SOLID_IMAGE && scene_check_parts_clean(c, path)) {
            scene_problem_at(c->problems, c->root, path.text, "cannot go with a body of shape image");
            return;
        }
}

static void check_constraint(const struct scene_check *c, int i) {
    const struct scene_constraint *k = &c->scene->solid->constraint[i];
    const struct scene_path above = scene_check_parts_path("solid.constraints[%d]", i),
                            path = scene_check_parts_path("%s.directions", above.text);
    const int in_plate = c->scene->dimension == 2 && scene_node_is_clean(c->root, "domain.size");
    check_region(c, above, k->low, k->high, &k->turn);
    check_image_turn(c, above, &k->turn);
    scene_check_region_time(c, above, &k->time);
    if (!scene_check_parts_clean(c, path)) return;
    int good = 1;
    for (const char *at = k->directions; *at; at++)
        good &= strchr(in_plate ? "xy" : "xyz", *at) != NULL && !strchr(at + 1, *at);
    if (!good) {
        scene_problem_at(c->problems, c->root, path.text, "must be a word of the letters %s, each at most once",
                         in_plate ? "x and y" : "x, y and z");
        return;
    }
    check_imposed(c, i, "velocity", k->velocity);
    check_imposed(c, i, "displacement", k->displacement);
}

/* Whether some body has cells of a lattice, of which loads on an edge with the depth of a layer take the outermost. */
static int has_cells(const struct scene_solid *s) {
    for (int b = 0; b < s->bodies; b++)
        if (s->body[b].own.shape != SOLID_POINTS &&
            (s->body[b].arrangement.kind == MESHLESS_LATTICE || s->body[b].arrangement.kind == MESHLESS_PERTURBED))
            return 1;
    return 0;
}

static void check_load(const struct scene_check *c, int i) {
    const struct scene_load *k = &c->scene->solid->load[i];
    const struct scene_path path = scene_check_parts_path("solid.loads[%d]", i),
                            edge = scene_check_parts_path("%s.edge", path.text);
    scene_check_region_time(c, path, &k->time);
    if (k->kind == SOLID_LOAD_REGION) {
        check_region(c, path, k->low, k->high, &k->turn);
        return;
    }
    if (!scene_check_parts_clean(c, edge)) return;
    const double end[2][3] = {{k->edge[0][0], k->edge[0][1]}, {k->edge[1][0], k->edge[1][1]}};
    double low[3], high[3];
    bounds_of(2, end, low, high);
    if (low[0] == high[0] && low[1] == high[1])
        scene_problem_at(c->problems, c->root, edge.text, "from and to are the same point");
    else if (scene_node_is_clean(c->root, "solid.bodies") && !holds_body(c, low, high, 1))
        scene_problem_at(c->problems, c->root, edge.text, "no body reaches to this edge");
    else if (scene_node_is_clean(c->root, "solid.bodies") && c->scene->solid->method == SCENE_PERIDYNAMIC &&
             !k->over_horizon && !has_cells(c->scene->solid))
        scene_problem_at(c->problems, c->root, edge.text, "needs depth: horizon, or a body on the lattice");
}

/* Whether four points lie in a plane, with a tolerance of 1e-6 of their extent. */
static int is_plane(const double (*p)[3]) {
    double e[3][3], extent = 0;
    for (int i = 0; i < 3; i++)
        for (int d = 0; d < 3; d++) {
            e[i][d] = p[i + 1][d] - p[0][d];
            extent = fmax(extent, fabs(e[i][d]));
        }
    const double volume = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
                          e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
                          e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    return fabs(volume) <= 1e-6 * extent * extent * extent;
}

static void check_crack(const struct scene_check *c, int i) {
    const struct scene_crack *k = &c->scene->solid->crack[i];
    const struct scene_path path = scene_check_parts_path("solid.cracks[%d].points", i);
    const int closed = c->scene->dimension == 3;
    double low[3], high[3];
    if (!scene_check_parts_clean(c, path) || !scene_node_is_clean(c->root, "domain.size")) return;
    if (closed && (k->points != 4 || !is_plane((const double(*)[3])k->point))) {
        scene_problem_at(c->problems, c->root, path.text, "must be the four corners of a plane quadrilateral%s",
                         k->points != 4 ? " in 3D" : ", these lie in no plane");
        return;
    }
    for (int p = 0; p + !closed < k->points; p++) {
        const int q = (p + 1) % k->points;
        if (!memcmp(k->point[p], k->point[q], sizeof *k->point)) {
            scene_problem_at(c->problems, c->root, scene_check_parts_path("%s[%d]", path.text, q).text,
                             "is the same point as the one %s", q > p ? "before" : "at the end");
            return;
        }
    }
    bounds_of(k->points, (const double(*)[3])k->point, low, high);
    if (scene_node_is_clean(c->root, "solid.bodies") && !holds_body(c, low, high, 1))
        scene_problem_at(c->problems, c->root, path.text, "no body reaches to this crack");
}

/* A family must have capacity for the bonds to refined neighbours: those of the next level if the horizon is scaled,
 * those of all levels if it is kept. */
static void check_levels(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_refinement *r = s->refinement;
    if (!scene_node_is_clean(c->root, "solid.refinement.levels") ||
        !scene_node_is_clean(c->root, "solid.refinement.horizon") || !scene_node_is_clean(c->root, "solid.materials"))
        return;
    for (int m = 0; m < s->materials; m++) {
        const double finer = r->horizon_kept ? 1 << r->levels : 2;
        if (s->material[m].horizon_ratio * finer <= SCENE_HORIZON_MAX_PLATE) continue;
        scene_problem_at(c->problems, c->root, "solid.refinement.levels",
                         "a family of %s would have more than 512 bonds: its horizon_ratio can be %g at most "
                         "where the horizon is %s",
                         s->material[m].name, SCENE_HORIZON_MAX_PLATE / finer, r->horizon_kept ? "kept" : "scaled");
        return;
    }
}

static void check_refinement(const struct scene_check *c) {
    const struct scene_refinement *r = c->scene->solid->refinement;
    if (!r) return;
    check_levels(c);
    for (int b = 0; b < c->scene->solid->bodies; b++) {
        const struct scene_path path = scene_check_parts_path("solid.bodies[%d].arrangement", b);
        if (c->scene->solid->body[b].arrangement.kind != MESHLESS_LATTICE && scene_check_parts_clean(c, path))
            scene_problem_at(c->problems, c->root, scene_check_parts_path("%s.kind", path.text).text,
                             "cannot go with solid.refinement, which divides the cells of a lattice");
    }
    if (isfinite(r->low[0])) check_region(c, scene_check_parts_path("solid.refinement"), r->low, r->high, &r->turn);
    for (int i = 0; i < r->starts; i++) {
        const struct scene_path path = scene_check_parts_path("solid.refinement.start[%d]", i);
        check_region(c, path, r->start[i].low, r->start[i].high, &r->start[i].turn);
        if (scene_check_parts_clean(c, path) && scene_node_is_clean(c->root, "solid.refinement.levels") &&
            r->start[i].level > r->levels)
            scene_problem_at(c->problems, c->root, scene_check_parts_path("%s.level", path.text).text,
                             "must be at most solid.refinement.levels, %d", r->levels);
    }
    if (scene_node_is_clean(c->root, "solid.refinement") && r->energy == 0 && r->damage == 0 && r->starts == 0)
        scene_problem_at(c->problems, c->root, "solid.refinement",
                         "refines nothing: energy and damage are off, and nothing is refined from the start");
}

static void check_initial(const struct scene_check *c, int i) {
    const struct scene_path path = scene_check_parts_path("solid.initial[%d].displacement", i);
    const double *d = c->scene->solid->initial[i].displacement;
    if (scene_check_parts_clean(c, path) && d[0] == 0 && d[1] == 0 && d[2] == 0)
        scene_problem_at(c->problems, c->root, path.text, "displaces nothing: must not be 0 in every direction");
}

void scene_check_region(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    for (int i = 0; i < s->cracks; i++) check_crack(c, i);
    for (int i = 0; i < s->constraints; i++) check_constraint(c, i);
    for (int i = 0; i < s->unbreakables; i++)
        check_region(c, scene_check_parts_path("solid.unbreakable[%d]", i), s->unbreakable[i].low,
                     s->unbreakable[i].high, &s->unbreakable[i].turn);
    for (int i = 0; i < s->loads; i++) check_load(c, i);
    for (int i = 0; i < s->initials; i++) check_initial(c, i);
    check_refinement(c);
}
