/* Checks which parts a scene has, its output requests, and that fluid and solid fit together. */
#include "scene/check/check.h"
#include "scene/medium.h"

#include <math.h>
#include <string.h>

int scene_check_parts_is_zero(const double v[3]) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

int scene_check_parts_name(const struct scene_check *c, struct scene_path path, const char *word, const char *list,
                           int n, const char *const *name) {
    for (int i = 0; i < n; i++)
        if (!strcmp(name[i], word)) return 1;
    PROBLEM(c, path.text, "is not a name in %s%s", list, scene_problem_hint(word, n, name).text);
    return 0;
}

int scene_check_parts_is_rigid(const struct scene *s) {
    int rigid = s->stages > 0;
    for (int k = 0; k < s->stages; k++) rigid &= s->stage[k].solid == SCENE_SOLID_RIGID;
    return rigid;
}

/* A solid that is rigid in all stages may stand in other cells: its creeping flow is solved without time steps. */
static void check_cells(const struct scene_check *c) {
    const struct scene_domain *d = &c->scene->domain;
    if (!c->scene->fluid || !c->scene->solid || !CLEAN(c, "domain")) return;
    if (scene_check_parts_is_rigid(c->scene)) return;
    const double x = d->size[0] / d->cells[0], y = d->size[1] / d->cells[1], z = d->size[2] / d->cells[2];
    if (fabs(y - x) > 1e-9 * x || fabs(z - x) > 1e-9 * x)
        PROBLEM(c, "domain.cells",
                "a solid in a fluid needs cells of the same size in all directions, these are %g x %g x %g m", x, y, z);
}

/* The reaction is found within the stages of the scheme, with at least one substep in each: there are three,
 * of Adams and Bashforth's scheme one. */
static void check_load(const struct scene_check *c) {
    const struct scene *s = c->scene;
    if (!s->coupling || s->coupling->load != SCENE_LOAD_REACTION || !CLEAN(c, "coupling.load")) return;
    for (int i = 0; i < s->stages; i++) {
        const struct scene_path path = PATH("stages[%d].substeps", i);
        if (s->stage[i].fluid_integrator == FLUID_RK3 && s->stage[i].solid == SCENE_SOLID_ELASTIC &&
            s->stage[i].substeps > 0 && s->stage[i].substeps < 3 && CLEAN(c, path.text))
            PROBLEM(c, path.text, "must be at least 3 with coupling.load: reaction, unless fluid_integrator is ab2");
    }
}

/* What cannot be measured is refused where it is asked for: by a direction, or by a stage that waits for it. */
static void check_measured(const struct scene_check *c) {
    const struct scene *s = c->scene;
    struct scene_medium m;
    if (!s->coupling || !s->fluid || !CLEAN(c, "fluid") || !CLEAN(c, "coupling.medium") || !CLEAN(c, "domain.size"))
        return;
    scene_medium_of(s, &m);
    if (!m.why[0]) return;
    if (s->coupling->medium_direction != SCENE_MEDIUM_AUTO) PROBLEM(c, "coupling.medium.direction", "%s", m.why);
    for (int i = 0; i < s->stages && s->coupling->medium_direction == SCENE_MEDIUM_AUTO; i++)
        if (s->stage[i].has_until && s->stage[i].until_quantity == SCENE_UNTIL_PERMEABILITY)
            PROBLEM(c, AT("stages[%d].until.quantity", i), "%s", m.why);
}

static void check_medium(const struct scene_check *c) {
    const struct scene_coupling *k = c->scene->coupling;
    const struct scene_domain *d = &c->scene->domain;
    const int low = scene_node_find(c->root, "coupling.medium.low") != NULL,
              high = scene_node_find(c->root, "coupling.medium.high") != NULL;
    if (k && low != high) PROBLEM(c, low ? "coupling.medium.high" : "coupling.medium.low", "missing (m)");
    if (!k || !k->has_box || !CLEAN(c, "coupling.medium") || !CLEAN(c, "domain.size")) return;
    for (int i = 0; i < 3; i++) {
        const double slack = 1e-9 * d->size[i];
        if (k->box_low[i] >= k->box_high[i]) {
            PROBLEM(c, "coupling.medium.low", "must be below high in every direction, %c is not", "xyz"[i]);
            return;
        }
        if (k->box_low[i] < -slack || k->box_high[i] > d->size[i] + slack) {
            PROBLEM(c, k->box_low[i] < -slack ? "coupling.medium.low" : "coupling.medium.high",
                    "must be within the domain, 0 to %g m in %c", d->size[i], "xyz"[i]);
            return;
        }
    }
}

static void check_crack_output(const struct scene_check *c) {
    const struct scene_crack_output *k = c->scene->output.crack;
    if (k && CLEAN(c, "output.crack.direction") && scene_check_parts_is_zero(k->direction))
        PROBLEM(c, "output.crack.direction", "must not be 0 in every direction");
}

/* Whether a bond may break in some stage. */
static int may_break(const struct scene *s) {
    int may = 0;
    for (int k = 0; k < s->stages; k++) may |= scene_stage_may_break(s, k);
    return may;
}

static void check_events(const struct scene_check *c) {
    const struct scene *s = c->scene;
    if (!s->output.events || !s->solid || c->problems->n > 0 || may_break(s)) return;
    PROBLEM(c, "output.events",
            "no bond can break: a material with a fracture energy is needed, and a stage of an elastic solid "
            "with breakage");
}

static void check_modes(const struct scene_check *c) {
    const struct scene_modes *m = c->scene->output.modes;
    if (!m) return;
    if (CLEAN(c, "output.modes.axis") && c->scene->dimension == 3 && scene_check_parts_is_zero(m->axis))
        PROBLEM(c, "output.modes.axis", "must not be 0 in every direction");
    if (!CLEAN(c, "output.modes.radii")) return;
    for (int k = 0; k + 1 < m->radii; k++)
        if (m->radius[k + 1] <= m->radius[k])
            PROBLEM(c, AT("output.modes.radii[%d]", k + 1), "must be larger than the radius before it, %g m",
                    m->radius[k]);
}

static void check_place(const struct scene_check *c, struct scene_path path, const double place[3]) {
    const double *size = c->scene->domain.size;
    for (int d = 0; d < 3 && CLEAN(c, path.text); d++)
        if (place[d] < 0 || place[d] > size[d]) {
            PROBLEM(c, path.text, "must be within the domain, 0 to %g m in %c", size[d], "xyz"[d]);
            return;
        }
}

static void check_fluid_probes(const struct scene_check *c) {
    const struct scene_fluid_probes *p = c->scene->output.fluid_probes;
    if (!p || !CLEAN(c, "domain.size")) return;
    if (p->places + p->lines == 0) PROBLEM(c, "output.fluid_probes", "needs at, lines or both");
    for (int k = 0; k < p->places; k++) check_place(c, PATH("output.fluid_probes.at[%d]", k), p->at[k]);
    for (int k = 0; k < p->lines; k++) {
        check_place(c, PATH("output.fluid_probes.lines[%d].from", k), p->line[k].from);
        check_place(c, PATH("output.fluid_probes.lines[%d].to", k), p->line[k].to);
    }
}

/* The given values must reach a horizon beyond the points that are solved for; the kernel must be integrable with
 * |x|^2, or the right-hand side is infinite. */
static void check_nonlocal(const struct scene_check *c) {
    const struct scene_nonlocal *n = c->scene->nonlocal;
    if (!n || !CLEAN(c, "nonlocal")) return;
    if (n->outer_radius < (n->inner_radius + n->horizon) * (1 - 1e-12))
        PROBLEM(c, "nonlocal.outer_radius",
                "must be at least inner_radius + horizon, %.15g m: u is given as far as the horizon reaches",
                n->inner_radius + n->horizon);
    if (n->exponent >= n->dimension + 2)
        PROBLEM(c, "nonlocal.exponent", "must be less than dimension + 2, here %d", n->dimension + 2);
    if (n->dimension == 1 && n->arrangement.kind == MESHLESS_HEXAGONAL)
        PROBLEM(c, "nonlocal.arrangement.kind", "needs 2 or 3 dimensions: in one dimension it is the lattice");
}

void scene_check_parts(const struct scene_check *c) {
    if (!c->scene->fluid && !c->scene->solid && !c->scene->nonlocal && c->problems->n == 0)
        scene_problem_line(c->problems, 0,
                           c->scene->dimension == 2 ? "there is nothing to run: give the plate a section solid"
                                                    : "there is nothing to run: give a section fluid, solid or both");
    check_nonlocal(c);
    check_crack_output(c);
    check_events(c);
    check_modes(c);
    check_fluid_probes(c);
    check_cells(c);
    check_load(c);
    check_medium(c);
    check_measured(c);
}
