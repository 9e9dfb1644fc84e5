/* The notch that a scene injects into, as the start of a similarity solution (physics/hydraulic_fracture.h). */
#pragma once
#include "physics/hydraulic_fracture.h"
#include "scene/scene.h"

struct scene_notch {
    int injection;                        /* the first of a rate that puts fluid in */
    struct physics_hydraulic_fracture in; /* KGD of a plate, penny in space; with G0, no leak-off, the largest rate */
    double length;      /* half the length of the initial cracks that meet the injection, in space the radius of a
                         * circle of their area; m */
    double start;       /* when a similarity solution has that length, by the regime in which that is later, s */
    double number;      /* dimensionless toughness then */
    double speed;       /* of the tip then, m/s: the smaller one of both regimes */
    double pressure;    /* net, then, Pa: the larger one of both regimes; of a penny at half its radius */
    double over[2];     /* the numbers below which viscosity and above which toughness rules */
    double wave, limit; /* of the first body's material: sqrt(E/rho), m/s; scene_notch_limit, Pa */
};

/* 0: the scene has no crack fluid, injects no rate, or injects it where no initial crack is; or nothing breaks. */
int scene_notch_of(const struct scene *s, struct scene_notch *notch);
/* E s0 of the first body's material, of the bilinear law its tensile strength; INFINITY: nothing breaks. Pa. */
double scene_notch_limit(const struct scene *s);
/* "toughness", "viscosity" or "between the regimes". */
const char *scene_notch_regime(const struct scene_notch *notch);
