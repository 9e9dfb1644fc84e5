/* Checks the fluid of cracks against the bodies and the stages. */
#include "scene/check/check.h"

#include <math.h>

/* Struts stand for the broken bonds of a lattice. */
static void check_bodies(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    if (s->method != SCENE_PERIDYNAMIC) {
        scene_problem_at(c->problems, c->root, "crack_fluid",
                         "needs solid.method: peridynamic, whose cracks are broken "
                         "bonds");
        return;
    }
    if (s->refinement)
        scene_problem_at(c->problems, c->root, "crack_fluid",
                         "cannot go with solid.refinement: struts need one spacing");
    for (int b = 0; b < s->bodies; b++) {
        const struct scene_body *body = &s->body[b];
        if (body->own.shape == SOLID_POINTS || body->arrangement.kind != MESHLESS_LATTICE) {
            scene_problem_at(
                c->problems, c->root, "crack_fluid",
                "needs particles on the lattice, whose bonds are alike in all directions: solid.bodies[%d] "
                "has others",
                b);
            return;
        }
        if (body->material_index < 0 || s->body[0].material_index < 0) return; /* reported with the body */
        const struct scene_material *m = &s->material[body->material_index],
                                    *first = &s->material[s->body[0].material_index];
        if (m->horizon_ratio != first->horizon_ratio || m->micromodulus != first->micromodulus) {
            scene_problem_at(c->problems, c->root, "crack_fluid",
                             "needs one horizon_ratio and one micromodulus: those of solid.bodies[%d] are not those of "
                             "solid.bodies[0]",
                             b);
            return;
        }
    }
}

/* With a resolved flow outside the cracks. */
static void check_outside(const struct scene_check *c) {
    static const double EQUAL = 1e-6;
    const struct scene_crack_fluid *f = c->scene->crack_fluid;
    const struct scene_fluid *outside = c->scene->fluid;
    if (!outside || !scene_node_is_clean(c->root, "fluid") || !scene_node_is_clean(c->root, "coupling")) return;
    const double viscosity = outside->density * outside->viscosity;
    if (fabs(f->viscosity - viscosity) > EQUAL * viscosity)
        scene_problem_at(c->problems, c->root, "crack_fluid.viscosity",
                         "must be that of the section fluid, density times viscosity = %g Pa s, or be left out",
                         viscosity);
    if (f->pores) scene_problem_at(c->problems, c->root, "crack_fluid.pores", "cannot go with the section fluid");
}

static void check_stage(const struct scene_check *c, int i) {
    const struct scene_stage *s = &c->scene->stage[i];
    const struct scene_path path = scene_check_parts_path("stages[%d].crack_fluid", i);
    if (!s->crack_fluid || !scene_check_parts_clean(c, path)) return;
    if (!c->scene->crack_fluid)
        scene_problem_at(c->problems, c->root, path.text, "needs the section crack_fluid");
    else if (s->relax)
        scene_problem_at(c->problems, c->root, path.text, "cannot go with relax: the fluid flows in time steps only");
    else if (s->solid == SCENE_SOLID_RIGID)
        scene_problem_at(c->problems, c->root, path.text, "needs solid: elastic");
    else if (s->integrator != SOLID_VERLET)
        scene_problem_at(c->problems, c->root, path.text,
                         "needs integrator: verlet, whose step the pressures are projected in");
}

void scene_check_crack_fluid(const struct scene_check *c) {
    const struct scene_crack_fluid *f = c->scene->crack_fluid;
    int flows = 0;
    for (int i = 0; i < c->scene->stages; i++) {
        check_stage(c, i);
        flows |= c->scene->stage[i].crack_fluid;
    }
    if (!f || !c->scene->solid || !scene_node_is_clean(c->root, "crack_fluid") ||
        !scene_node_is_clean(c->root, "solid.bodies") || !scene_node_is_clean(c->root, "solid.materials"))
        return;
    if (!flows && scene_node_is_clean(c->root, "stages"))
        scene_problem_at(c->problems, c->root, "crack_fluid", "flows in no stage: none has crack_fluid: true");
    check_bodies(c);
    check_outside(c);
    for (int i = 0; i < f->injections; i++) {
        const struct scene_path path = scene_check_parts_path("crack_fluid.injections[%d]", i);
        scene_check_region_time(c, path, &f->injection[i].time);
        scene_check_body_box(c, path, f->injection[i].low, f->injection[i].high);
    }
}
