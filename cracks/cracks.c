/* Creates and frees the fluid in cracks. */
#include "cracks/cracks.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "cracks/aperture.h"
#include "cracks/inject.h"
#include "cracks/outlet.h"
#include "cracks/project.h"
#include "cracks/solve.h"
#include "cracks/struts.h"
#include "solid/imposed/time.h"
#include "solid/law/material.h"

#include <math.h>
#include <string.h>

/* Struts need all particles on one lattice, with one family; the materials of an image have one
 * (solid/bonds/materials.h). */
static void check(const struct solid *s) {
    const struct solid_material *first = &s->in.material[s->in.body[0].material];
    if (s->in.refinement || s->refine)
        die_all(EXIT_CODE_SCENE, "crack_fluid: not with solid.refinement: struts need one spacing");
    for (int b = 0; b < s->in.bodies; b++) {
        const struct solid_body *body = &s->in.body[b];
        const struct solid_material *m = &s->in.material[body->material];
        if (body->shape == SOLID_POINTS)
            die_all(EXIT_CODE_SCENE,
                    "crack_fluid: body %s consists of given points: struts need the lattice, whose "
                    "bonds are alike in all directions",
                    body->name);
        if (body->perturbation > 0)
            die_all(EXIT_CODE_SCENE,
                    "crack_fluid: the particles of body %s are perturbed: struts need the lattice, "
                    "whose bonds are alike in all directions",
                    body->name);
        if (m->horizon_ratio != first->horizon_ratio || m->micromodulus != first->micromodulus)
            die_all(EXIT_CODE_SCENE, "crack_fluid: bodies %s and %s must have one horizon_ratio and one micromodulus",
                    s->in.body[0].name, body->name);
    }
}

/* Of the largest critical stretch of a material that breaks. The bonds between two materials have one in between. */
static double least_aperture(const struct solid *s) {
    double most = 0;
    for (int b = 0; b < s->in.bodies; b++) {
        const struct solid_body *body = &s->in.body[b];
        for (int k = 0; k < (body->image_materials > 1 ? body->image_materials : 1); k++) {
            const struct solid_material *m =
                &s->in.material[body->image_materials > 1 ? body->image_material[k] : body->material];
            const double s0 =
                solid_material_constants(s->in.model, s->in.thickness, m, m->horizon_ratio * s->in.spacing).s0;
            if (isfinite(s0)) most = fmax(most, s0);
        }
    }
    return CRACKS_LEAST_STRETCH * most * s->in.spacing;
}

struct cracks *cracks_new(const struct cracks_input *in, struct solid *s) {
    check(s);
    if (in->porous && in->leak_off > 0)
        die_all(EXIT_CODE_SCENE, "crack_fluid.leak_off: not with pores, which take what leaks off already");
    struct cracks *c = memory_new(MEMORY_SOLID, 1, sizeof *c);
    const size_t injections = (size_t)in->injections + 1;
    c->in = *in;
    c->in.injection = memory_copy(MEMORY_SOLID, in->injection, (size_t)in->injections, sizeof *in->injection);
    for (int q = 0; q < in->injections; q++)
        solid_time_copy(&((struct cracks_injection *)(uintptr_t)c->in.injection)[q].time);
    c->solid = s;
    cracks_table_new(&c->table, &s->in, &s->in.material[s->in.body[0].material]);
    if (in->porous) cracks_table_add_intact(&c->table, in->pores.biot);
    if (in->outside) {
        ENSURE(!in->porous, "pores and a fluid outside");
        c->gap = (s->in.material[s->in.body[0].material].horizon_ratio - 1) * s->in.spacing;
        c->outlets = cracks_outlet_new(s);
    }
    c->least_aperture = in->least_aperture > 0 ? in->least_aperture : least_aperture(s);
    if (!(c->least_aperture > 0))
        die_all(EXIT_CODE_SCENE,
                "crack_fluid.least_aperture: needs a value, because no material has a critical stretch");
    c->push = (struct solid_push){cracks_project, c};
    c->injected = memory_new(MEMORY_SOLID, injections, sizeof *c->injected);
    c->rate = memory_new(MEMORY_SOLID, injections, sizeof *c->rate);
    c->particles = memory_new(MEMORY_SOLID, injections, sizeof *c->particles);
    c->stale = 1;
    cracks_project_end(c);
    cracks_inject_check(c);
    if (in->porous) cracks_aperture_open(c);
    for (int i = 0; i < c->struts.n; i++) {
        if (!(cracks_aperture_cracks(c)[i] > 0))
            c->p[i] = fmax(c->in.least_pressure, 0); /* one that is open is empty */
    }
    return c;
}

void cracks_free(struct cracks *c) {
    if (!c) return;
    for (int q = 0; q < c->in.injections; q++)
        solid_time_free(&((struct cracks_injection *)(uintptr_t)c->in.injection)[q].time);
    MEMORY_FREE((void *)(uintptr_t)c->in.injection, c->p, c->content, c->cavity, c->volume, c->storage, c->share,
                c->since, c->open, c->leak, c->injected, c->rate, c->particles, c->weight);
    cracks_outlet_free(c->outlets);
    cracks_solve_free(c->work);
    cracks_struts_free(&c->struts);
    cracks_table_free(&c->table);
    memory_free(c);
}

void cracks_resume(struct cracks *c, int flows) {
    if (flows)
        c->solid->push = &c->push;
    else
        cracks_begin(c, 0);
}

void cracks_begin(struct cracks *c, int flows) {
    struct solid *s = c->solid;
    const int flowed = s->push != NULL;
    if (flows == flowed) return;
    s->push = flows ? &c->push : NULL;
    if (flows) {
        c->stale = 1;
        return;
    }
    for (int i = 0; i < c->struts.n; i++) {
        for (int k = 0; k < s->dim; k++) s->load[k][c->struts.h[i]] -= c->share[i][k];
        c->share[i] = (cracks_vec){0};
    }
}
