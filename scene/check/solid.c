/* Checks the materials against the model, and that the lattice fits periodic sides. */
#include "physics/bond.h"
#include "physics/dilatation.h"
#include "physics/softening.h"
#include "scene/check/check.h"

#include <math.h>
#include <string.h>

/* What the dilatation of a material does not go with, and why; NULL: nothing of the scene. */
static const char *clashes(const struct scene *s, const struct scene_material *k, const char **why) {
    const struct scene_solid *solid = s->solid;
    if (k->s00 > 0) {
        *why = "limits that follow the other bonds are tested after the forces, and do not see the dilatation";
        return "breakage.s00";
    }
    if (k->micromodulus != PHYSICS_CONSTANT && isfinite(k->fracture_energy)) {
        *why = "the critical stretch is known for a constant one only; without a fracture energy both go together";
        return "a micromodulus that is not constant";
    }
    if (solid->horizons == SOLID_ONE_SIDED) {
        *why = "the dilatations of both ends act on a bond with one stiffness";
        return "solid.horizons: one_sided";
    }
    return NULL;
}

/* Bonds alone have one Poisson's ratio; any other needs the dilatation of the families. */
static void check_poisson(const struct scene_check *c, int m) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_path path = PATH("solid.materials[%d].poisson_ratio", m);
    if (s->method == SCENE_ELEMENT_FREE) return;
    if (!CLEAN(c, path.text) || !CLEAN(c, "domain.size") || (c->scene->dimension == 2 && !CLEAN(c, "solid.model")))
        return;
    const enum physics_model model = (enum physics_model)s->model;
    const double ratio = s->material[m].poisson_ratio;
    const char *const own = model == PHYSICS_PLANE_STRESS ? "1/3" : "0.25", *other, *why;
    if (physics_dilatation_ratio_excess(model, ratio) == 0) return;
    if (ratio < PHYSICS_DILATATION_MIN || ratio > PHYSICS_DILATATION_MAX)
        PROBLEM(c, path.text, "must be from %g to %g", PHYSICS_DILATATION_MIN, PHYSICS_DILATATION_MAX);
    else if (CLEAN(c, "solid") && (other = clashes(c->scene, &s->material[m], &why)))
        PROBLEM(c, path.text, "does not go with %s, which needs %s, that of bonds alone: %s", other, own, why);
}

/* The bilinear law needs a fracture energy, one horizon, and a horizon narrow enough for its strength. */
static void check_softening(const struct scene_check *c, int m) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_material *k = &s->material[m];
    const struct scene_path law = PATH("solid.materials[%d].breakage.law", m),
                            strength = PATH(k->strength > 0 ? "solid.materials[%d].tensile_strength"
                                                            : "solid.materials[%d].breakage.tensile_strength",
                                            m);
    if (k->breakage != SCENE_BILINEAR || !CLEAN(c, "solid") || !CLEAN(c, "domain.size")) return;
    if (!isfinite(k->fracture_energy)) {
        PROBLEM(c, law.text, "needs a fracture_energy");
        return;
    }
    if (!(k->tensile_strength > 0)) {
        PROBLEM(c, strength.text, "missing; law bilinear needs it, here or as the material's tensile_strength (Pa)");
        return;
    }
    if (s->refinement) PROBLEM(c, law.text, "does not go with solid.refinement");
    const enum physics_model model = (enum physics_model)s->model;
    const double delta = k->horizon_ratio * s->spacing;
    const double beyond = physics_dilatation_ratio_excess(model, k->poisson_ratio);
    const double s0 = physics_bond_elastic(model, (enum physics_micromodulus)k->micromodulus, s->thickness,
                                           k->youngs_modulus, beyond, k->fracture_energy, delta)
                          .s0;
    const double widest = physics_softening_widest(model, k->youngs_modulus, beyond, k->tensile_strength, s0, delta);
    if (!(delta < widest))
        PROBLEM(c, strength.text,
                "needs a horizon below %.6g m with this fracture energy, and it is %.6g m: take a spacing "
                "below %.6g m, or a brittle law, whose strength at this horizon is %.6g Pa",
                widest, delta, widest / k->horizon_ratio, k->tensile_strength * sqrt(widest / delta));
}

/* The strength of brittle bonds changes with their horizon. */
static void check_strength(const struct scene_check *c, int m) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_path path = PATH("solid.materials[%d].tensile_strength", m);
    if (s->material[m].strength > 0 && s->refinement && CLEAN(c, path.text))
        PROBLEM(c, path.text, "does not go with solid.refinement: brittle bonds of a finer spacing are stronger");
}

/* A limit that follows the other bonds stands instead of a fracture energy, and is a law of steps. */
static void check_limit(const struct scene_check *c, int m) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_path path = PATH("solid.materials[%d].breakage.s00", m);
    if (!(s->material[m].s00 > 0) || !CLEAN(c, path.text)) return;
    if (isfinite(s->material[m].fracture_energy))
        PROBLEM(c, path.text, "stands instead of fracture_energy: give one of the two");
    if (s->refinement) PROBLEM(c, path.text, "does not go with solid.refinement");
    for (int i = 0; i < s->interfaces; i++)
        for (int e = 0; e < 2; e++)
            if (s->interface[i].body[e] >= 0 && s->body[s->interface[i].body[e]].material_index == m) {
                PROBLEM(c, path.text, "does not go with solid.interfaces[%d]", i);
                return;
            }
    for (int i = 0; i < c->scene->stages; i++)
        if (c->scene->stage[i].relax) {
            PROBLEM(c, path.text, "does not go with stages[%d].relax: the limits are those of the step before", i);
            return;
        }
}

static void check_material(const struct scene_check *c, int m) {
    const struct scene_material *material = c->scene->solid->material;
    check_poisson(c, m);
    check_softening(c, m);
    check_strength(c, m);
    check_limit(c, m);
    for (int k = 0; k < m; k++)
        if (!strcmp(material[k].name, material[m].name) && CLEAN(c, AT("solid.materials[%d].name", m)) &&
            CLEAN(c, AT("solid.materials[%d].name", k))) {
            PROBLEM(c, AT("solid.materials[%d].name", m), "is the name of solid.materials[%d] too", k);
            return;
        }
}

/* Across a periodic direction the lattice must continue, and no family may overlap its own periodic image. */
static void check_period(const struct scene_check *c, int d) {
    const struct scene_solid *s = c->scene->solid;
    const double size = c->scene->domain.size[d], n = size / s->spacing;
    double widest = 0;
    for (int m = 0; m < s->materials; m++) widest = fmax(widest, 2 * (s->material[m].horizon_ratio + 0.5) * s->spacing);
    if (fabs(n - round(n)) > 1e-6) {
        PROBLEM(c, "solid.spacing", "the periodic direction %c (%g m) must hold a whole number of particles, not %.6g",
                "xyz"[d], size, n);
    } else if (!scene_check_parts_is_rigid(c->scene) && size < widest * (1 + 1e-9)) { /* a rigid one has no bonds */
        PROBLEM(c, "domain.size",
                "a particle's family would meet itself across the periodic direction %c: more than "
                "%g m are needed, two horizons and a spacing",
                "xyz"[d], widest);
    }
}

/* Cracks that grow need a toughness, and a cut that follows their bends. */
static void check_growth(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_growth *growth = s->element_free->growth;
    static const char path[] = "solid.element_free.growth";
    if (!growth) return;
    if (s->cracks == 0) PROBLEM(c, path, "the scene has no crack");
    if (s->element_free->crack == GALERKIN_DIFFRACTION)
        PROBLEM(c, path, "not with crack: diffraction, which is for straight cracks: take virtual or visibility");
    if (!(growth->toughness > 0) && !isfinite(s->material[s->body[0].material_index].fracture_energy))
        PROBLEM(c, path, "needs a toughness, or the material's fracture_energy");
    if (c->scene->output.intensity)
        PROBLEM(c, "output.intensity", "not with solid.element_free.growth, whose growth.csv has K at every step");
}

/* What an element-free plate can be: one convex body with straight sides. */
static void check_element_free(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_body *body = s->body;
    if (s->method != SCENE_ELEMENT_FREE || !CLEAN(c, "solid")) return;
    if (s->bodies != 1) PROBLEM(c, "solid.bodies", "an element-free plate is one body, here are %d", s->bodies);
    if (body->own.shape != SOLID_RECTANGLE && body->own.shape != SOLID_POLYGON)
        PROBLEM(c, "solid.bodies[0].shape", "must be rectangle or polygon with solid.method: element_free");
    double turned = 0;
    for (int k = 0; k < body->own.corners && body->own.shape == SOLID_POLYGON; k++) {
        const double *p = body->own.corner[k].at, *q = body->own.corner[(k + 1) % body->own.corners].at,
                     *r = body->own.corner[(k + 2) % body->own.corners].at;
        const double turn = (q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0]);
        if (body->own.corner[k].turn != 0 || turn * turned < 0) {
            PROBLEM(c, AT("solid.bodies[0].outline[%d]", k), "an element-free plate is convex and has straight sides");
            break;
        }
        turned = turn != 0 ? turn : turned;
    }
    for (int d = 0; d < 2; d++)
        if (c->scene->domain.periodic[d])
            PROBLEM(c, "domain.periodic", "an element-free plate has no periodic directions");
    for (int k = 0; k < s->cracks; k++)
        if (s->crack[k].points != 2 &&
            (s->element_free->basis == GALERKIN_TIP || s->element_free->crack == GALERKIN_DIFFRACTION))
            PROBLEM(c, AT("solid.cracks[%d].points", k),
                    "basis: tip and crack: diffraction are for straight cracks, two points; here are %d",
                    s->crack[k].points);
    check_growth(c);
    if (c->scene->output.intensity && s->cracks == 0) PROBLEM(c, "output.intensity", "the scene has no crack");
}

/* Which bodies of a scene in 3D can be swept in mixed precision is known once they are made: solid/solid.c. */
static void check_precision(const struct scene_check *c) {
    if (c->scene->solid->precision != SOLID_DOUBLE && c->scene->dimension == 2)
        PROBLEM(c, "solid.precision",
                "must be double in a plate: the lists of bonds that plates have are not swept in mixed "
                "precision");
}

void scene_check_solid(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    if (!s) return;
    check_precision(c);
    for (int m = 0; m < s->materials; m++) check_material(c, m);
    for (int b = 0; b < s->bodies; b++) scene_check_body(c, b);
    scene_check_region(c);
    check_element_free(c);
    scene_check_interface(c);
    scene_check_indenter(c);
    const int known = CLEAN(c, "domain.size") && CLEAN(c, "solid.spacing") && CLEAN(c, "solid.materials");
    for (int d = 0; d < 3; d++)
        if (known && c->scene->domain.periodic[d]) check_period(c, d);
}
