/* Fills in defaults that follow from other values: spacing, Poisson's ratio, integrators, retraction, measurement box.
 */
#include "scene/default.h"
#include "base/text.h"
#include "physics/crack_tip.h"
#include "physics/dilatation.h"
#include "physics/retraction.h"
#include "physics/softening.h"
#include "physics/waves.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The shortest text that reads back as the same number. */
static char *number_text(double value) {
    for (int digits = 15; digits < 17; digits++) {
        char *text = text_new("%.*g", digits, value);
        if (strtod(text, NULL) == value) return text;
        free(text);
    }
    return text_new("%.17g", value);
}

static struct scene_node *scalar(const struct scene_node *parent, const char *key, const char *value) {
    struct scene_node *node = scene_node_new(SCENE_NODE_SCALAR, key, value);
    node->line = parent->line;
    return node;
}

static struct scene_node *number(const struct scene_node *parent, const char *key, double value) {
    char *text = number_text(value);
    struct scene_node *node = scalar(parent, key, text);
    free(text);
    return node;
}

static struct scene_node *vector(const struct scene_node *parent, const char *key, const double value[3]) {
    struct scene_node *list = scene_node_new(SCENE_NODE_LIST, key, NULL);
    list->line = parent->line;
    for (int c = 0; c < 3; c++) scene_node_append(list, number(list, NULL, value[c]));
    return list;
}

/* After the key; at the end, if it is not there. */
static void insert_after(struct scene_node *parent, const char *key, struct scene_node *node) {
    int at = 0;
    while (at < parent->n && strcmp(parent->child[at]->key, key) != 0) at++;
    scene_node_insert(parent, at < parent->n ? at + 1 : at, node);
}

/* The cell size if it is the same in all directions, else 0. */
static double cell_of(const struct scene_domain *d) {
    double cell = 0;
    for (int c = 0; c < 3; c++) {
        if (d->cells[c] == 0) return 0;
        const double width = d->size[c] / d->cells[c];
        if (c == 0) cell = width;
        if (fabs(width - cell) > 1e-9 * cell) return 0;
    }
    return cell;
}

/* The most accurate load: docs/accuracy.md. */
static void fill_load(struct scene *s, struct scene_node *root) {
    struct scene_node *coupling = scene_node_find(root, "coupling");
    if (scene_node_child(coupling, "load")) return;
    s->coupling->load = SCENE_LOAD_REACTION;
    insert_after(coupling, "probe_length", scalar(coupling, "load", "reaction"));
}

static void fill_poisson(struct scene *s, struct scene_node *root, int m) {
    struct scene_node *node = scene_node_find(root, AT("solid.materials[%d]", m));
    if (s->solid->method == SCENE_ELEMENT_FREE || scene_node_child(node, "poisson_ratio")) return;
    s->solid->material[m].poisson_ratio = physics_model_poisson_ratio((enum physics_model)s->solid->model);
    insert_after(node, "density", number(node, "poisson_ratio", s->solid->material[m].poisson_ratio));
}

/* G0 = K^2/E', E' = E in plane stress, else E/(1 - nu^2). */
static void fill_energy(struct scene *s, int m) {
    struct scene_material *k = &s->solid->material[m];
    const enum physics_model model = (enum physics_model)s->solid->model;
    const double ratio =
        s->solid->method == SCENE_ELEMENT_FREE ? k->poisson_ratio : physics_dilatation_ratio(model, k->poisson_ratio);
    const struct physics_crack_tip tip = {k->youngs_modulus, ratio, model != PHYSICS_PLANE_STRESS};
    if (k->toughness > 0) k->fracture_energy = k->toughness * k->toughness / physics_crack_tip_modulus(&tip);
}

/* The tensile strength is the bilinear law's; of brittle bonds it gives G0 at their horizon. */
static void fill_strength(struct scene *s, struct scene_node *root, struct scene_problems *problems, int m) {
    struct scene_material *k = &s->solid->material[m];
    const enum physics_model model = (enum physics_model)s->solid->model;
    const double delta = k->horizon_ratio * s->solid->spacing;
    const struct scene_path path = PATH("solid.materials[%d].tensile_strength", m);
    if (k->strength > 0 && k->breakage == SCENE_BILINEAR && k->tensile_strength > 0) {
        scene_problem_at(problems, root, path.text, "not with breakage.tensile_strength: give one of the two");
    } else if (k->strength > 0 && k->breakage == SCENE_BILINEAR) {
        k->tensile_strength = k->strength;
    } else if (k->strength > 0 && delta > 0) {
        const double energy = physics_softening_brittle_energy(
            model, (enum physics_micromodulus)k->micromodulus, k->youngs_modulus,
            physics_dilatation_ratio_excess(model, k->poisson_ratio), k->strength, delta);
        if (isfinite(k->fracture_energy))
            scene_problem_at(problems, root, path.text,
                             "brittle bonds of this strength have the fracture energy %.6g J/m2 at the horizon %.6g m, "
                             "and %.6g J/m2 are given: leave one of the two out, or take breakage: {law: bilinear}",
                             energy, delta, k->fracture_energy);
        else
            k->fracture_energy = energy;
    }
}

static void fill_spacing(struct scene *s, struct scene_node *root, struct scene_problems *problems) {
    struct scene_node *solid = scene_node_find(root, "solid");
    if (scene_node_child(solid, "spacing")) return;
    s->solid->spacing = cell_of(&s->domain);
    if (s->solid->spacing > 0) {
        scene_node_insert(solid, 0, number(solid, "spacing", s->solid->spacing));
    } else if (s->dimension == 2 && scene_node_is_clean(root, "domain")) {
        scene_problem_at(problems, root, "solid.spacing", "missing (m)");
    } else if (scene_node_is_clean(root, "domain") && !s->fluid) { /* a fluid with unequal cells is reported
                                                                    * elsewhere */
        scene_problem_at(problems, root, "solid.spacing",
                         "missing (m); without domain.cells, the same in all directions, there is no default");
    }
}

static void fill_body(struct scene *s, struct scene_node *root, struct scene_problems *problems, int b) {
    struct scene_body *body = &s->solid->body[b];
    struct scene_node *node = scene_node_find(root, AT("solid.bodies[%d]", b));
    if (!scene_node_child(node, "name")) {
        snprintf(body->name, sizeof body->name, "body%d", b + 1);
        scene_node_insert(node, 0, scalar(node, "name", body->name));
    }
    if (!scene_node_child(node, "material") && !scene_node_child(node, "materials")) {
        if (s->solid->materials == 1) {
            memcpy(body->material, s->solid->material[0].name, sizeof body->material);
            scene_node_insert(node, 1, scalar(node, "material", body->material));
        } else {
            scene_problem_at(problems, root, AT("solid.bodies[%d].material", b),
                             "missing: solid.materials has %d to choose from", s->solid->materials);
        }
    }
}

static void fill_retraction(struct scene *s, struct scene_node *root) {
    struct scene_node *coupling = scene_node_find(root, "coupling");
    if (scene_node_child(coupling, "retraction")) return;
    s->coupling->retraction = PHYSICS_RETRACTION;
    insert_after(coupling, "surface", number(coupling, "retraction", s->coupling->retraction));
}

/* Sets the box to the bounds of all bodies within the domain; in a periodic direction to the whole period where a body
 * extends beyond the sides, and to the whole domain where all sides are periodic: there the bodies are an array. */
static void fill_medium(struct scene *s, struct scene_node *root) {
    struct scene_coupling *c = s->coupling;
    struct scene_node *coupling = scene_node_find(root, "coupling");
    struct scene_node *medium = scene_node_find(root, "coupling.medium");
    c->has_box = medium && scene_node_child(medium, "low") && scene_node_child(medium, "high");
    if (medium && (scene_node_child(medium, "low") || scene_node_child(medium, "high"))) return;
    if (!s->fluid || !scene_node_is_clean(root, "domain.size") || !scene_node_is_clean(root, "fluid") ||
        !scene_node_is_clean(root, "solid.bodies"))
        return;
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    int periodic[3], known = 1;
    for (int d = 0; d < 3; d++) periodic[d] = s->fluid->side[d][0].type == FLUID_PERIODIC;
    const int is_array = periodic[0] && periodic[1] && periodic[2];
    for (int b = 0; b < s->solid->bodies; b++) {
        double body_low[3] = {0}, body_high[3] = {0};
        known &= scene_check_body_bounds(&s->solid->body[b], body_low, body_high);
        for (int d = 0; d < 3; d++) {
            const double size = s->domain.size[d], slack = 1e-9 * size;
            const int is_beyond = periodic[d] && (body_low[d] < -slack || body_high[d] > size + slack);
            low[d] = is_array || is_beyond ? 0 : fmin(low[d], fmax(body_low[d], 0));
            high[d] = is_array || is_beyond ? size : fmax(high[d], fmin(body_high[d], size));
        }
    }
    if (!known && !is_array) return;
    for (int d = 0; d < 3; d++)
        if (!(low[d] < high[d])) return; /* the bodies are outside, which is said of them */
    memcpy(c->box_low, low, sizeof low);
    memcpy(c->box_high, high, sizeof high);
    c->has_box = 1;
    if (!medium) {
        medium = scene_node_new(SCENE_NODE_MAPPING, "medium", NULL);
        medium->line = coupling->line;
        scene_node_append(medium, scalar(medium, "direction", "auto"));
        scene_node_append(coupling, medium);
    }
    scene_node_insert(medium, 0, vector(medium, "low", low));
    scene_node_insert(medium, 1, vector(medium, "high", high));
}

/* Velocity Verlet keeps the energy of the waves that breaking bonds release, with one sweep a step; pressures in cracks
 * need it. Elsewhere RK3 (docs/choosing.md). */
static void fill_integrator(struct scene *s, struct scene_node *node, int k) {
    struct scene_stage *stage = &s->stage[k];
    if (!s->solid || scene_node_child(node, "integrator")) return;
    const int verlet = (scene_stage_may_break(s, k) && !stage->relax) || stage->crack_fluid;
    stage->integrator = verlet ? SOLID_VERLET : SOLID_RK3;
    insert_after(node, scene_node_child(node, "tolerance") ? "tolerance" : "solid",
                 scalar(node, "integrator", verlet ? "verlet" : "rk3"));
}

/* The longest stable step reads the drag of a porous block 3.5 % wrong; 0.4 of it reads 0.5 %
 * (cases/verification/cost). */
static void fill_cfl(struct scene *s, struct scene_node *node, int k) {
    struct scene_stage *stage = &s->stage[k];
    if (scene_node_child(node, "cfl")) return;
    stage->cfl = s->fluid && s->solid && stage->solid == SCENE_SOLID_ELASTIC ? 0.36 : 0.9;
    insert_after(node, "time_step", number(node, "cfl", stage->cfl));
}

/* The change of a steady permeability; or of energies and load at rest. */
static void fill_until(struct scene *s, struct scene_node *node, int k) {
    struct scene_node *until = scene_node_child(node, "until");
    struct scene_stage *stage = &s->stage[k];
    if (!until || until->kind != SCENE_NODE_MAPPING || scene_node_child(until, "change")) return;
    stage->until_change = stage->until_quantity == SCENE_UNTIL_REST ? 0.01 : 1e-4;
    insert_after(until, "quantity", number(until, "change", stage->until_change));
}

/* Critical where the solid is to come to rest and the scene gives no other. */
static void fill_damping(struct scene *s, struct scene_node *node, int k) {
    struct scene_stage *stage = &s->stage[k];
    if (!s->solid || scene_node_child(node, "damping_absolute")) return;
    const int rests = scene_node_child(node, "until") && stage->until_quantity == SCENE_UNTIL_REST;
    const int damps = rests && stage->solid == SCENE_SOLID_ELASTIC && stage->damping_relative == 0;
    stage->damping_absolute = damps ? -1 : 0;
    insert_after(node, "damping_relative", scalar(node, "damping_absolute", damps ? "auto" : "0"));
}

static void fill_stage(struct scene *s, struct scene_node *root, int k) {
    struct scene_node *node = scene_node_find(root, AT("stages[%d]", k));
    if (!node || node->kind != SCENE_NODE_MAPPING) return;
    fill_cfl(s, node, k);
    fill_integrator(s, node, k);
    fill_until(s, node, k);
    fill_damping(s, node, k);
}

/* The time in which the slowest Rayleigh wave runs ten spacings: a tip at half its speed passes five in a window. */
static void fill_crack_window(struct scene *s, struct scene_node *root) {
    static const double SPACINGS = 10;
    struct scene_node *node = scene_node_find(root, "output.crack");
    if (!node || node->kind != SCENE_NODE_MAPPING || scene_node_child(node, "window")) return;
    const enum physics_model model = s->dimension == 3 ? PHYSICS_3D : (enum physics_model)s->solid->model;
    double slowest = INFINITY;
    for (int m = 0; m < s->solid->materials; m++) {
        const struct scene_material *k = &s->solid->material[m];
        slowest = fmin(slowest, physics_waves_of(model, k->youngs_modulus,
                                                 physics_dilatation_ratio(model, k->poisson_ratio), k->density)
                                    .rayleigh);
    }
    if (!(slowest > 0 && isfinite(slowest))) return; /* a value is wrong, which is said of it */
    s->output.crack->window = SPACINGS * s->solid->spacing / slowest;
    insert_after(node, "direction", number(node, "window", s->output.crack->window));
}

void scene_default_fill(struct scene *s, struct scene_node *root, struct scene_problems *problems) {
    if (s->solid) {
        fill_spacing(s, root, problems);
        for (int m = 0; m < s->solid->materials; m++) fill_poisson(s, root, m);
        for (int m = 0; m < s->solid->materials; m++) fill_energy(s, m);
        for (int m = 0; m < s->solid->materials; m++) fill_strength(s, root, problems, m);
        for (int b = 0; b < s->solid->bodies; b++) fill_body(s, root, problems, b);
    }
    if (s->solid && s->output.crack) fill_crack_window(s, root);
    for (int k = 0; k < s->stages; k++) fill_stage(s, root, k);
    if (s->coupling) fill_load(s, root);
    if (s->coupling) fill_retraction(s, root);
    if (s->coupling && s->solid) fill_medium(s, root);
}
