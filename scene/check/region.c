/* Checks the data given for a part of the solid: regions, edges, cracks, initial displacements and refinement must
 * reach a body, and must not contradict each other. */
#include "scene/check/check.h"
#include "scene/turn.h"

#include <math.h>
#include <string.h>

/* The bounds of a body's particles, a region or a crack: the whole period in a direction in which it extends beyond a
 * side, as it comes in at the other. */
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
    if (!CLEAN(c, path.text) || !scene_check_body_turn(c, path, turn) || !scene_check_body_box(c, path, low, high))
        return;
    scene_turn_box(turn, low, high, its_low, its_high);
    wrap(&c->scene->domain, its_low, its_high);
    if (CLEAN(c, "solid.bodies") && !holds_body(c, its_low, its_high, 0))
        PROBLEM(c, path.text, "no body reaches into this region");
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
    const struct scene_path path = PATH("%s.time_from", above.text);
    if (!time->from[0] || !CLEAN(c, path.text)) return;
    if (time->stage < 0)
        PROBLEM(c, path.text, "is the name of no stage");
    else if (time->stage > SCENE_TIMED_MAX)
        PROBLEM(c, path.text, "must be one of the first %d stages", SCENE_TIMED_MAX);
}

void scene_check_region_time(const struct scene_check *c, struct scene_path above, const struct scene_time *time) {
    const struct scene_path path = PATH("%s.time", above.text);
    check_from(c, above, time);
    if (!CLEAN(c, path.text)) return;
    for (int i = 1; i < time->n; i++)
        if (time->t[i] <= time->t[i - 1]) {
            PROBLEM(c, AT("%s[%d]", path.text, i), "must be later than the entry before, at %g s", time->t[i - 1]);
            return;
        }
}

/* Reports a prescribed value in a direction that is not constrained. */
static void check_imposed(const struct scene_check *c, int i, const char *key, const double value[3]) {
    const struct scene_constraint *k = &c->scene->solid->constraint[i];
    const struct scene_path path = PATH("solid.constraints[%d].%s", i, key);
    if (!CLEAN(c, path.text)) return;
    for (int d = 0; d < c->scene->dimension; d++)
        if (value[d] != 0 && !k->direction[d]) {
            PROBLEM(c, path.text, "has a part in %c, which is not in directions (%s)", "xyz"[d], k -> directions);
            return;
        }
}

/* Which pieces of an image are loose is found by voxels, in boxes along the axes. */
static void check_image_turn(const struct scene_check *c, struct scene_path above, const struct scene_turn *turn) {
    const struct scene_path path = PATH("%s.rotation", above.text);
    const struct scene_solid *s = c->scene->solid;
    for (int b = 0; b < s->bodies; b++)
        if (turn->is_turned && s->body[b].own.shape == SOLID_IMAGE && CLEAN(c, path.text)) {
            PROBLEM(c, path.text, "cannot go with a body of shape image");
            return;
        }
}

static void check_constraint(const struct scene_check *c, int i) {
    const struct scene_constraint *k = &c->scene->solid->constraint[i];
    const struct scene_path above = PATH("solid.constraints[%d]", i), path = PATH("%s.directions", above.text);
    const int in_plate = c->scene->dimension == 2 && CLEAN(c, "domain.size");
    check_region(c, above, k->low, k->high, &k->turn);
    check_image_turn(c, above, &k->turn);
    scene_check_region_time(c, above, &k->time);
    if (!CLEAN(c, path.text)) return;
    int good = 1;
    for (const char *at = k->directions; *at; at++)
        good &= strchr(in_plate ? "xy" : "xyz", *at) != NULL && !strchr(at + 1, *at);
    if (!good) {
        PROBLEM(c, path.text, "must be a word of the letters %s, each at most once",
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
    const struct scene_path path = PATH("solid.loads[%d]", i), edge = PATH("%s.edge", path.text);
    scene_check_region_time(c, path, &k->time);
    if (k->kind == SOLID_LOAD_REGION) {
        check_region(c, path, k->low, k->high, &k->turn);
        return;
    }
    if (!CLEAN(c, edge.text)) return;
    const double end[2][3] = {{k->edge[0][0], k->edge[0][1]}, {k->edge[1][0], k->edge[1][1]}};
    double low[3], high[3];
    bounds_of(2, end, low, high);
    if (low[0] == high[0] && low[1] == high[1])
        PROBLEM(c, edge.text, "from and to are the same point");
    else if (CLEAN(c, "solid.bodies") && !holds_body(c, low, high, 1))
        PROBLEM(c, edge.text, "no body reaches to this edge");
    else if (CLEAN(c, "solid.bodies") && c->scene->solid->method == SCENE_PERIDYNAMIC && !k->over_horizon &&
             !has_cells(c->scene->solid))
        PROBLEM(c, edge.text, "needs depth: horizon, or a body on the lattice");
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
    const struct scene_path path = PATH("solid.cracks[%d].points", i);
    const int closed = c->scene->dimension == 3;
    double low[3], high[3];
    if (!CLEAN(c, path.text) || !CLEAN(c, "domain.size")) return;
    if (closed && (k->points != 4 || !is_plane((const double(*)[3])k->point))) {
        PROBLEM(c, path.text, "must be the four corners of a plane quadrilateral%s",
                k->points != 4 ? " in 3D" : ", these lie in no plane");
        return;
    }
    for (int p = 0; p + !closed < k->points; p++) {
        const int q = (p + 1) % k->points;
        if (!memcmp(k->point[p], k->point[q], sizeof *k->point)) {
            PROBLEM(c, AT("%s[%d]", path.text, q), "is the same point as the one %s", q > p ? "before" : "at the end");
            return;
        }
    }
    bounds_of(k->points, (const double(*)[3])k->point, low, high);
    wrap(&c->scene->domain, low, high);
    if (CLEAN(c, "solid.bodies") && !holds_body(c, low, high, 1))
        PROBLEM(c, path.text, "no body reaches to this crack");
}

/* A family must have capacity for the bonds to refined neighbours: those of the next level if the horizon is scaled,
 * those of all levels if it is kept. */
static void check_levels(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_refinement *r = s->refinement;
    if (!CLEAN(c, "solid.refinement.levels") || !CLEAN(c, "solid.refinement.horizon") || !CLEAN(c, "solid.materials"))
        return;
    for (int m = 0; m < s->materials; m++) {
        const double finer = r->horizon_kept ? 1 << r->levels : 2;
        if (s->material[m].horizon_ratio * finer <= SCENE_HORIZON_MAX_PLATE) continue;
        PROBLEM(c, "solid.refinement.levels",
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
        const struct scene_path path = PATH("solid.bodies[%d].arrangement", b);
        if (c->scene->solid->body[b].arrangement.kind != MESHLESS_LATTICE && CLEAN(c, path.text))
            PROBLEM(c, AT("%s.kind", path.text),
                    "cannot go with solid.refinement, which divides the cells of a lattice");
    }
    if (isfinite(r->low[0])) check_region(c, PATH("solid.refinement"), r->low, r->high, &r->turn);
    for (int i = 0; i < r->starts; i++) {
        const struct scene_path path = PATH("solid.refinement.start[%d]", i);
        check_region(c, path, r->start[i].low, r->start[i].high, &r->start[i].turn);
        if (CLEAN(c, path.text) && CLEAN(c, "solid.refinement.levels") && r->start[i].level > r->levels)
            PROBLEM(c, AT("%s.level", path.text), "must be at most solid.refinement.levels, %d", r->levels);
    }
    if (CLEAN(c, "solid.refinement") && r->energy == 0 && r->damage == 0 && r->starts == 0)
        PROBLEM(c, "solid.refinement",
                "refines nothing: energy and damage are off, and nothing is refined from the start");
}

static void check_initial(const struct scene_check *c, int i) {
    const struct scene_path path = PATH("solid.initial[%d].displacement", i);
    if (CLEAN(c, path.text) && scene_check_parts_is_zero(c->scene->solid->initial[i].displacement))
        PROBLEM(c, path.text, "displaces nothing: must not be 0 in every direction");
}

void scene_check_region(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    for (int i = 0; i < s->cracks; i++) check_crack(c, i);
    for (int i = 0; i < s->constraints; i++) check_constraint(c, i);
    for (int i = 0; i < s->unbreakables; i++)
        check_region(c, PATH("solid.unbreakable[%d]", i), s->unbreakable[i].low, s->unbreakable[i].high,
                     &s->unbreakable[i].turn);
    for (int i = 0; i < s->loads; i++) check_load(c, i);
    for (int i = 0; i < s->initials; i++) check_initial(c, i);
    check_refinement(c);
}
