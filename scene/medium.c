/* Finds the direction along which a scene drives its fluid through the medium. */
#include "scene/medium.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int is_periodic(const struct scene_fluid *f, int d) { return f->side[d][0].type == FLUID_PERIODIC; }

/* 1: fluid can pass the side. */
static int is_open(const struct scene_side *s, int d) {
    const enum fluid_condition normal = d == 0 ? s->u : d == 1 ? s->v : s->w;
    switch (s->type) {
    case FLUID_INFLOW:
    case FLUID_OUTFLOW:
    case FLUID_PRESSURE:
        return 1;
    case FLUID_GENERAL:
        return normal == FLUID_NEUMANN || s->velocity[d] != 0;
    case FLUID_PERIODIC:
    case FLUID_WALL:
    case FLUID_SLIP:
        break;
    }
    return 0;
}

/* Force per volume on the fluid in the periodic directions, Pa/m; a held bulk velocity counts as itself. */
static void push_of(const struct scene_fluid *f, double push[3]) {
    const double *e = f->driving_along, length = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
    for (int d = 0; d < 3; d++) {
        const double part = length > 0 ? e[d] / length : d == f->driving_direction;
        push[d] = f->density * f->body_force[d];
        if (f->driving != FLUID_DRIVING_NONE) push[d] += part * f->driving_value;
        if (!is_periodic(f, d)) push[d] = 0;
    }
}

/* Why nothing drives the fluid along d; an empty text if something does. */
static const char *idle(const struct scene_fluid *f, const double push[3], int d) {
    const struct scene_side *low = &f->side[d][0], *high = &f->side[d][1];
    if (is_periodic(f, d)) return push[d] != 0 ? "" : "no gradient and no body force points along it";
    if (!is_open(low, d) || !is_open(high, d)) return "its sides let nothing through";
    if (low->type == FLUID_PRESSURE && high->type == FLUID_PRESSURE && low->pressure == high->pressure &&
        f->body_force[d] == 0)
        return "its sides have the same pressure";
    return "";
}

/* sides: 1: sides that are not periodic come first. */
static void automatic(const struct scene_fluid *f, int sides, const double push[3], double along[3]) {
    for (int d = 0; d < 3 && sides; d++)
        if (!is_periodic(f, d) && !*idle(f, push, d)) {
            along[d] = 1;
            return;
        }
    if (f->driving == FLUID_DRIVING_BULK && f->driving_value != 0)
        along[f->driving_direction] = 1;
    else
        memcpy(along, push, 3 * sizeof *along);
    const int axes = (along[0] != 0) + (along[1] != 0) + (along[2] != 0);
    for (int d = 0; d < 3 && axes == 1; d++) along[d] = along[d] != 0; /* its axis, whichever way the force acts */
    if (axes == 0) along[0] = 1;
}

/* Whether the box is the domain along d. */
static int is_whole(const struct scene *s, int d) {
    const double slack = 1e-9 * s->domain.size[d];
    return s->coupling->box_low[d] <= slack && s->coupling->box_high[d] >= s->domain.size[d] - slack;
}

void scene_medium_of(const struct scene *s, struct scene_medium *m) {
    const struct scene_fluid *f = s->fluid;
    const enum scene_medium_direction given = s->coupling->medium_direction;
    double push[3];
    int axis = 0, axes = 0;
    *m = (struct scene_medium){0};
    push_of(f, push);
    if (given == SCENE_MEDIUM_AUTO || given == SCENE_MEDIUM_DRIVING)
        automatic(f, given == SCENE_MEDIUM_AUTO, push, m->along);
    else
        m->along[given - SCENE_MEDIUM_X] = 1;
    for (int d = 0; d < 3; d++) {
        axes += m->along[d] != 0;
        if (m->along[d] != 0) axis = d;
    }
    if (axes == 1 && *idle(f, push, axis)) {
        snprintf(m->why, sizeof m->why, "nothing drives the fluid along %c: %s", "xyz"[axis], idle(f, push, axis));
        return;
    }
    for (int d = 0; d < 3; d++) {
        if (axes == 1 && d != axis && push[d] != 0) {
            snprintf(m->why, sizeof m->why,
                     "the fluid is driven along %c too: a permeability along %c alone cannot be measured", "xyz"[d],
                     "xyz"[axis]);
            return;
        }
        if (axes > 1 && m->along[d] != 0 && s->coupling->has_box && !is_whole(s, d)) {
            snprintf(m->why, sizeof m->why,
                     "the fluid is driven along (%g, %g, %g): the medium's box must be the whole period along %c",
                     m->along[0], m->along[1], m->along[2], "xyz"[d]);
            return;
        }
    }
}

int scene_medium_is_wanted(const struct scene *s) {
    int waits = 0;
    for (int i = 0; i < s->stages; i++) waits |= s->stage[i].has_until && !scene_stage_rests(&s->stage[i]);
    return s->coupling && (waits || s->coupling->medium_direction != SCENE_MEDIUM_AUTO);
}
