/* frana check: estimates the force of a flow on the solid from what drives it, or from its velocity. */
#include "program/check/parts.h"
#include "base/memory.h"
#include "base/par.h"
#include "physics/packed_drag.h"

#include <math.h>
#include <stdio.h>

/* Drag coefficient of blunt bodies: plates across a flow have 1.2 to 2, long cylinders 1.2, spheres 0.4. */
static const double BLUNT = 1.2;
/* Least open part of a section or a bed. */
static const double LEAST_OPEN = 0.05;

static int is_inside(const struct run *r, int h) {
    int is = 1;
    for (int c = 0; c < 3; c++) is &= r->solid->x0[c][h] >= 0 && r->solid->x0[c][h] < r->scene->domain.size[c];
    return is;
}

/* Drop along c of what drives the flow, Pa. */
static double drop_of(const struct scene *scene, int c) {
    const struct scene_fluid *f = scene->fluid;
    const struct scene_side *side = f->side[c];
    const int is_open = side[0].type == FLUID_PRESSURE && side[1].type == FLUID_PRESSURE;
    double drop = is_open ? side[0].pressure - side[1].pressure : 0, norm = 0;
    if (!is_open && side[0].type != FLUID_PERIODIC) return 0;
    for (int k = 0; k < 3; k++) norm = hypot(norm, f->driving_along[k]);
    if (f->driving == FLUID_DRIVING_GRADIENT)
        drop += f->driving_value * scene->domain.size[c] *
                (norm > 0 ? f->driving_along[c] / norm : c == f->driving_direction);
    return drop + f->density * f->body_force[c] * scene->domain.size[c];
}

static void take(double *most, double value) {
    if (fabs(value) > fabs(*most)) *most = value;
}

/* The largest velocity of the scene in each direction, as seen from the body that differs most. */
static void velocity_of(const struct scene *scene, double u[3]) {
    const struct scene_fluid *f = scene->fluid;
    for (int c = 0; c < 3; c++) {
        u[c] = f->initial_velocity[c];
        for (int d = 0; d < 3; d++)
            for (int e = 0; e < 2; e++) {
                const struct scene_side *side = &f->side[d][e];
                if (side->type == FLUID_INFLOW && d == c) take(&u[c], e ? -side->bulk_velocity : side->bulk_velocity);
                if (side->type == FLUID_WALL || side->type == FLUID_GENERAL) take(&u[c], side->velocity[c]);
            }
        if (f->driving == FLUID_DRIVING_BULK && c == f->driving_direction) take(&u[c], f->driving_value);
        if (f->has_taylor_green && scene_axes_has(f->taylor_green_axes, c)) take(&u[c], f->taylor_green_velocity);
        const double stream = u[c];
        for (int b = 0; b < scene->solid->bodies; b++) take(&u[c], stream - scene->solid->body[b].velocity[c]);
    }
}

/* Of the solid in the domain: its volume, its extent along an axis, its area as seen along it, and the mean over its
 * layers of the inverse cube of what each leaves open of the section. */
struct seen {
    double volume, extent, area, narrowed;
};

/* Layers along an axis. layer: [n] volume of each, m3; whole: of a layer of the domain. */
static double narrowed(double *layer, int n, double whole) {
    double sum = 0, layers = 0;
    par_sum_array(layer, n);
    for (int k = 0; k < n; k++) {
        if (!(layer[k] > 0)) continue;
        sum += pow(fmax(LEAST_OPEN, 1 - layer[k] / whole), -3);
        layers++;
    }
    return layers > 0 ? sum / layers : 1;
}

static struct seen seen_along(const struct run *r, int axis) {
    const struct solid *s = r->solid;
    const int p = (axis + 1) % 3, q = (axis + 2) % 3;
    const double *size = r->scene->domain.size, d = s->in.spacing;
    const int n[2] = {(int)ceil(size[p] / d), (int)ceil(size[q] / d)};
    const int layers = (int)ceil(size[axis] / d);
    double *mark = memory_new(MEMORY_OUTPUT, (size_t)n[0] * (size_t)n[1] + 1, sizeof *mark),
           *layer = memory_new(MEMORY_OUTPUT, (size_t)layers + 1, sizeof *layer), volume = 0, columns = 0;
    double low = INFINITY, high = -INFINITY;
    for (int h = 0; h < s->n; h++) {
        if (!is_inside(r, h)) continue;
        volume += s->volume[h];
        layer[(int)fmin(layers - 1, s->x0[axis][h] / d)] += s->volume[h];
        low = fmin(low, s->x0[axis][h] - 0.5 * d);
        high = fmax(high, s->x0[axis][h] + 0.5 * d);
        mark[(size_t)fmin(n[0] - 1, s->x0[p][h] / d) * (size_t)n[1] + (size_t)fmin(n[1] - 1, s->x0[q][h] / d)] = 1;
    }
    par_max_array(mark, n[0] * n[1]);
    for (int k = 0; k < n[0] * n[1]; k++) columns += mark[k];
    const double cubes = narrowed(layer, layers, size[p] * size[q] * d);
    MEMORY_FREE(mark, layer);
    return (struct seen){par_sum(volume), par_max(high) - par_min(low), columns * d * d, cubes};
}

static void along(struct flow_load *load, const double e[3], double force, const struct seen *seen) {
    double norm = 0;
    for (int c = 0; c < 3; c++) norm = hypot(norm, e[c]);
    load->force = force;
    load->pressure = force / seen->area;
    for (int c = 0; c < 3; c++) load->per_volume[c] = force / seen->volume * e[c] / norm;
}

static int largest(const double v[3]) {
    int axis = 0;
    for (int c = 1; c < 3; c++)
        if (fabs(v[c]) > fabs(v[axis])) axis = c;
    return axis;
}

static void by_velocity(const struct run *r, struct flow_load *load) {
    const struct scene_fluid *f = r->scene->fluid;
    double u[3], speed = 0, section = 1;
    velocity_of(r->scene, u);
    for (int c = 0; c < 3; c++) speed = hypot(speed, u[c]);
    const int axis = largest(u);
    const struct seen seen = seen_along(r, axis);
    for (int c = 0; c < 3; c++) section *= c == axis ? 1 : r->scene->domain.size[c];
    if (!(speed > 0) || !(seen.volume > 0) || !(r->surface->immersed_area > 0)) return;
    const double box = section * seen.extent, porosity = fmax(LEAST_OPEN, 1 - seen.volume / box);
    double packed = box * physics_packed_drag(porosity, speed, 6 * seen.volume / r->surface->immersed_area, f->density,
                                              f->density * f->viscosity);
    if (porosity <= PHYSICS_PACKED) packed *= pow(porosity, 3) * seen.narrowed; /* a bed with windows and chambers */
    const double open = 1 - seen.area / section;
    const double blunt = open > 0.1 ? 0.5 * BLUNT * f->density * pow(speed / open, 2) * seen.area : 0;
    along(load, u, fmax(packed, blunt), &seen);
    snprintf(load->sentence, FLOW_LOAD_SENTENCE, "drag of %s at %.3g m/s, porosity %.3g",
             blunt > packed ? "a blunt body" : "grains", speed, porosity);
}

static void by_drop(const struct run *r, struct flow_load *load) {
    double drop[3], force[3], sum = 0;
    for (int c = 0; c < 3; c++) {
        drop[c] = force[c] = drop_of(r->scene, c);
        for (int k = 0; k < 3; k++) force[c] *= k == c ? 1 : r->scene->domain.size[k];
        sum = hypot(sum, force[c]);
    }
    const int axis = largest(force);
    if (!(sum > load->force)) return;
    const struct seen seen = seen_along(r, axis);
    if (!(seen.volume > 0)) return;
    along(load, force, sum, &seen);
    snprintf(load->sentence, FLOW_LOAD_SENTENCE, "a drop of %.3g Pa along %c over the whole section, at most",
             fabs(drop[axis]), "xyz"[axis]);
}

struct flow_load flow_load_of(const struct run *r) {
    struct flow_load load = {.force = 0};
    if (!r->needs.immersed) return load;
    by_velocity(r, &load);
    by_drop(r, &load);
    return load;
}
