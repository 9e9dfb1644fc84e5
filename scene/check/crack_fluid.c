/* Checks the fluid of cracks against the bodies and the stages. */
#include "scene/check/check.h"

#include <math.h>

/* Struts stand for the broken bonds of a lattice. */
static void check_bodies(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    if (s->method != SCENE_PERIDYNAMIC) {
        PROBLEM(c, "crack_fluid",
                "needs solid.method: peridynamic, whose cracks are broken "
                "bonds");
        return;
    }
    if (s->refinement) PROBLEM(c, "crack_fluid", "cannot go with solid.refinement: struts need one spacing");
    for (int b = 0; b < s->bodies; b++) {
        const struct scene_body *body = &s->body[b];
        if (body->own.shape == SOLID_POINTS || body->arrangement.kind != MESHLESS_LATTICE) {
            PROBLEM(c, "crack_fluid",
                    "needs particles on the lattice, whose bonds are alike in all directions: solid.bodies[%d] "
                    "has others",
                    b);
            return;
        }
        if (body->material_index < 0 || s->body[0].material_index < 0) return; /* reported with the body */
        const struct scene_material *m = &s->material[body->material_index],
                                    *first = &s->material[s->body[0].material_index];
        if (m->horizon_ratio != first->horizon_ratio || m->micromodulus != first->micromodulus) {
            PROBLEM(c, "crack_fluid",
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
    if (!outside || !CLEAN(c, "fluid") || !CLEAN(c, "coupling")) return;
    const double viscosity = outside->density * outside->viscosity;
    if (fabs(f->viscosity - viscosity) > EQUAL * viscosity)
        PROBLEM(c, "crack_fluid.viscosity",
                "must be that of the section fluid, density times viscosity = %g Pa s, or be left out", viscosity);
    if (f->pores) PROBLEM(c, "crack_fluid.pores", "cannot go with the section fluid");
}

static void check_stage(const struct scene_check *c, int i) {
    const struct scene_stage *s = &c->scene->stage[i];
    const struct scene_path path = PATH("stages[%d].crack_fluid", i);
    if (!s->crack_fluid || !CLEAN(c, path.text)) return;
    if (!c->scene->crack_fluid)
        PROBLEM(c, path.text, "needs the section crack_fluid");
    else if (s->relax)
        PROBLEM(c, path.text, "cannot go with relax: the fluid flows in time steps only");
    else if (s->solid == SCENE_SOLID_RIGID)
        PROBLEM(c, path.text, "needs solid: elastic");
    else if (s->integrator != SOLID_VERLET)
        PROBLEM(c, path.text, "needs integrator: verlet, whose step the pressures are projected in");
}

void scene_check_crack_fluid(const struct scene_check *c) {
    const struct scene_crack_fluid *f = c->scene->crack_fluid;
    int flows = 0;
    for (int i = 0; i < c->scene->stages; i++) {
        check_stage(c, i);
        flows |= c->scene->stage[i].crack_fluid;
    }
    if (!f || !c->scene->solid || !CLEAN(c, "crack_fluid") || !CLEAN(c, "solid.bodies") || !CLEAN(c, "solid.materials"))
        return;
    if (!flows && CLEAN(c, "stages")) PROBLEM(c, "crack_fluid", "flows in no stage: none has crack_fluid: true");
    check_bodies(c);
    check_outside(c);
    for (int i = 0; i < f->injections; i++) {
        const struct scene_path path = PATH("crack_fluid.injections[%d]", i);
        scene_check_region_time(c, path, &f->injection[i].time);
        scene_check_body_box(c, path, f->injection[i].low, f->injection[i].high);
    }
}
