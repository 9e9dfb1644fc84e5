/* frana check: compares the stress that a scene's loads will about make with that at which its bodies break. */
#include "program/check/parts.h"
#include "base/memory.h"
#include "base/print.h"
#include "base/par.h"
#include "physics/griffith.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/external_loads.h"
#include "solid/imposed/time.h"
#include "solid/law/material.h"
#include "solid/measure/sections.h"
#include "solid/measure/support.h"

#include <math.h>
#include <string.h>

/* The most stretched bonds of a pulled bar, a bent one and a porous block in a flow had 2.0, 1.2 and 3 times the
 * stress of the estimate (tests/program/strength.sh has the first two). Beyond the square of OFF nothing breaks. */
static const double OFF = 5;

/* The time in which the solid moves, s. */
struct span {
    double from, to;
};

static void take_largest(double *most, double value) {
    if (fabs(value) > fabs(*most)) *most = value;
}

/* The largest factor, in size, while the solid moves. */
static double largest(const struct solid_time *time, const struct span *moves) {
    double most = solid_time_factor(time, moves->from);
    take_largest(&most, solid_time_factor(time, moves->to));
    for (int k = 0; k < time->n; k++) {
        const double t = time->origin + time->t[k];
        if (t > moves->from && t < moves->to) take_largest(&most, time->factor[k]);
    }
    return most;
}

/* How far a unit velocity times the factor goes at most, s. */
static double farthest(const struct solid_time *time, const struct span *moves) {
    double most = solid_time_mean(time, moves->from, moves->to) * (moves->to - moves->from);
    for (int k = 0; k < time->n; k++) {
        const double t = time->origin + time->t[k];
        if (t > moves->from && t < moves->to)
            take_largest(&most, solid_time_mean(time, moves->from, t) * (t - moves->from));
    }
    return most;
}

/* Loads at their largest factors, the body force and the flow, N/m3. */
static void forces(struct run *r, const struct flow_load *flow, const struct span *moves, double *const force[3]) {
    struct solid *s = r->solid;
    double *saved = memory_new(MEMORY_OUTPUT, (size_t)s->in.loads + 1, sizeof *saved),
           *most = memory_new(MEMORY_OUTPUT, (size_t)s->in.loads + 1, sizeof *most);
    solid_external_loads_save(s, saved);
    for (int k = 0; k < s->in.loads; k++) most[k] = largest(&s->in.load[k].time, moves);
    solid_external_loads_restore(s, most);
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) {
            const int wet = r->needs.immersed && s->x0[c][h] >= 0 && s->x0[c][h] < r->scene->domain.size[c];
            force[c][h] = solid_external_loads_on(s, h, c) + solid_density(s, h) * s->in.body_force[c] +
                          (wet ? flow->per_volume[c] : 0);
        }
    solid_external_loads_restore(s, saved);
    MEMORY_FREE(saved, most);
}

/* A prescribed motion: mean place of its particles among the chosen bodies, and how far they go. */
struct moved {
    double volume, x[3], by[3];
};

static struct moved moved_by(const struct run *r, const uint8_t *chosen, const struct solid_support_extent *extent,
                             int k, const struct span *moves) {
    const struct solid *s = r->solid;
    const struct solid_time *time = &r->solid->in.constraint[k].time;
    const struct scene_constraint *from = &r->scene->solid->constraint[k];
    struct moved m = {0};
    for (int h = 0; h < s->n; h++) {
        if (!chosen[s->body[h]] || !solid_constraint_inside(s, h, from->low, from->high, &s->in.constraint[k].turn))
            continue;
        m.volume += s->volume[h];
        for (int c = 0; c < s->dim; c++) m.x[c] += s->volume[h] * solid_support_place(s, extent, c, h);
    }
    par_sum_array(&m.volume, 4);
    for (int c = 0; c < 3 && m.volume > 0; c++) {
        m.x[c] /= m.volume;
        m.by[c] = from->has_displacement ? largest(time, moves) * from->displacement[c]
                                         : farthest(time, moves) * from->velocity[c];
    }
    return m;
}

/* Stress between two prescribed motions: of a bar that is stretched, and of a block that is sheared with G = E/2.5. */
static double stretched(const struct scene_constraint *a, const struct moved *m, const struct scene_constraint *b,
                        const struct moved *n, double modulus) {
    double distance2 = 0, by2 = 0, in_line = 0;
    if (!(m->volume > 0) || !(n->volume > 0)) return 0;
    for (int c = 0; c < 3; c++) {
        const double apart = n->x[c] - m->x[c], by = a->direction[c] && b->direction[c] ? n->by[c] - m->by[c] : 0;
        distance2 += apart * apart;
        by2 += by * by;
        in_line += apart * by;
    }
    if (!(distance2 > 0)) return 0;
    const double normal = modulus * in_line / distance2;
    const double shear = modulus / 2.5 * sqrt(fmax(0, by2 / distance2 - pow(in_line / distance2, 2)));
    const double root = hypot(0.5 * normal, shear);
    return physics_griffith_tension((const double[3]){0.5 * normal + root, 0, 0.5 * normal - root});
}

/* Of prescribed motions: between any two of them; and of one that begins at once, behind its wave's front. */
static double prescribed(const struct run *r, const uint8_t *chosen, double modulus, double density,
                         const struct span *moves) {
    const struct scene_solid *scene = r->scene->solid;
    const struct solid_support_extent extent = solid_support_extent_of(r->solid, chosen);
    double most = 0;
    struct moved *m = memory_new(MEMORY_OUTPUT, (size_t)scene->constraints + 1, sizeof *m);
    for (int k = 0; k < scene->constraints; k++) {
        const struct scene_constraint *a = &scene->constraint[k];
        double speed = 0;
        m[k] = moved_by(r, chosen, &extent, k, moves);
        for (int c = 0; c < 3 && !a->has_displacement; c++) speed = hypot(speed, a->velocity[c]);
        if (m[k].volume > 0)
            most = fmax(most, speed * fabs(largest(&r->solid->in.constraint[k].time, moves)) * sqrt(modulus * density));
        for (int l = 0; l < k; l++) most = fmax(most, stretched(a, &m[k], &scene->constraint[l], &m[l], modulus));
    }
    memory_free(m);
    return most;
}

/* Of the initial displacements: the steepest slope of each, times E. */
static double initial(const struct scene_solid *s, double modulus) {
    double sum = 0;
    for (int k = 0; k < s->initials; k++) {
        const double steepest = s->initial[k].shape == SOLID_SINE ? 2 * 3.141592653589793 : sqrt(2 / exp(1));
        double size = 0;
        for (int c = 0; c < 3; c++) size = hypot(size, s->initial[k].displacement[c]);
        sum += modulus * steepest * size / s->initial[k].width;
    }
    return sum;
}

/* At what stress a body breaks, and by what. */
struct limit {
    double stress, modulus, density; /* INFINITY: it does not break */
    const char *what;
};

/* sigma of a crack of some length under tension across it: K_Ic/(Y sqrt(pi a)), a half the length; the whole length and
 * Y = 1.12 if one of its ends lies outside the body's particles. */
static double of_crack(const struct scene_crack *crack, const struct solid_support_extent *e, int dim, double toughness,
                       double spacing) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, length2 = 0;
    int apart = 0, open = 0;
    for (int p = 0; p < crack->points; p++)
        for (int c = 0; c < dim; c++) {
            low[c] = fmin(low[c], crack->point[p][c]);
            high[c] = fmax(high[c], crack->point[p][c]);
        }
    for (int c = 0; c < dim; c++) {
        const double shift = high[c] < e->low[c] ? e->period[c] : 0;
        low[c] += shift;
        high[c] += shift;
        apart |= low[c] > e->high[c] || high[c] < e->low[c];
        open |= low[c] < e->low[c] + 0.5 * spacing || high[c] > e->high[c] - 0.5 * spacing;
        const double within = fmin(high[c], e->high[c] + 0.5 * spacing) - fmax(low[c], e->low[c] - 0.5 * spacing);
        length2 = fmax(length2, within * within);
    }
    const double a = (open ? 1 : 0.5) * sqrt(length2);
    return apart || !(a > 0) ? INFINITY : toughness / ((open ? 1.12 : 1) * sqrt(3.141592653589793 * a));
}

static struct limit limit_of(const struct run *r, const uint8_t *chosen) {
    const struct scene_solid *s = r->scene->solid;
    const struct solid_input *in = &r->solid->in;
    const struct solid_support_extent e = solid_support_extent_of(r->solid, chosen);
    struct limit least = {.stress = INFINITY, .what = "sigma0"};
    double present[256] = {0};
    for (int h = 0; h < r->solid->n; h++)
        if (chosen[r->solid->body[h]]) present[solid_particle_material(r->solid, h)] = 1;
    par_max_array(present, 256);
    for (int m = 0; m < s->materials; m++) {
        const struct scene_material *k = &s->material[m];
        const double s0 = k->s00 > 0 ? k->s00
                                     : solid_material_constants(in->model, in->thickness, &in->material[m],
                                                                k->horizon_ratio * in->spacing)
                                           .s0;
        const int soft = k->breakage == SCENE_BILINEAR;
        const double sigma = soft ? k->tensile_strength : k->youngs_modulus * s0;
        if (!present[m] || !isfinite(sigma)) continue;
        if (sigma < least.stress)
            least = (struct limit){sigma, k->youngs_modulus, k->density, soft ? "tensile_strength" : "sigma0"};
        for (int q = 0; q < s->cracks && isfinite(k->fracture_energy); q++) {
            const double stress =
                of_crack(&s->crack[q], &e, r->solid->dim, sqrt(k->youngs_modulus * k->fracture_energy), in->spacing);
            if (stress < least.stress)
                least = (struct limit){stress, k->youngs_modulus, k->density, "Griffith's, of a crack"};
        }
    }
    return least;
}

/* is_all: 1: the estimate has all loads of the scene. */
static void print_limit(const char *name, const struct solid_section *section, double flow, double moved,
                        const struct limit *limit, int is_all) {
    const double stress = fmax(section->stress, flow) + moved, missing = limit->stress / stress;
    print("  %s: a stress of about %.3g Pa", name, stress);
    if (moved >= fmax(section->stress, flow))
        print(" by prescribed motions");
    else if (flow > section->stress)
        print(", the flow's force over the area that it meets");
    else
        print(" on the section %c = %.4g m of %.3g m2", "xyz"[section->axis], section -> at, section -> area);
    print("; breaks at %.3g Pa (%s): ", limit->stress, limit->what);
    if (missing > 1)
        print("%.3g times as much load is missing\n", missing);
    else
        print("%.3g times what breaks it\n", 1 / missing);
    if (is_all && missing > OFF * OFF)
        print("  warning: %s will not break: its loads are %.3g times too small, far beyond the estimate's error\n",
              name, missing);
}

/* Body b with all that interfaces join to it, if it is the first of them. */
static int group_of(const struct solid_input *in, int b, uint8_t *chosen) {
    int grows = 1;
    memset(chosen, 0, (size_t)in->bodies);
    chosen[b] = 1;
    while (grows) {
        grows = 0;
        for (int k = 0; k < in->interfaces; k++) {
            const int *pair = in->interface[k].body;
            grows |= chosen[pair[0]] != chosen[pair[1]];
            if (chosen[pair[0]] || chosen[pair[1]]) chosen[pair[0]] = chosen[pair[1]] = 1;
        }
    }
    for (int k = 0; k < b; k++)
        if (chosen[k]) return 0;
    return 1;
}

/* Prints the loads that the estimate does not have. Returns their number. */
static int print_left_out(const struct run *r) {
    const struct scene_solid *s = r->scene->solid;
    const char *what[3] = {s->bodies > 1 ? "collisions" : NULL, s->indenters > 0 ? "indenters" : NULL,
                           r->cracks ? "pressure in cracks" : NULL};
    int n = 0;
    for (int k = 0; k < 3; k++)
        if (what[k]) print("%s%s", n++ ? ", " : "  not in it: ", what[k]);
    if (n > 0) print("\n");
    return n;
}

void check_strength_print(struct run *r, double from, double to) {
    const struct span moves = {from, isfinite(to) ? to : from};
    struct solid *s = r->solid;
    if (!r->needs.bonds || !r->needs.breakage) return;
    uint8_t *chosen = memory_new(MEMORY_OUTPUT, (size_t)s->in.bodies, 1);
    double *force[3] = {NULL};
    for (int c = 0; c < s->dim; c++) force[c] = memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof **force);
    const struct flow_load flow = flow_load_of(r);
    print(
        "\nstrength: an estimate by sections, within a factor of %g for compact bodies; slender grains and necks of a "
        "pore structure bear more\n",
        OFF);
    if (flow.force > 0) print("  flow: about %.3g N on the solid (%s)\n", flow.force, flow.sentence);
    const int is_all = print_left_out(r) == 0;
    for (int b = 0; b < s->in.bodies; b++) {
        if (!group_of(&s->in, b, chosen)) continue;
        const struct limit limit = limit_of(r, chosen);
        if (!isfinite(limit.stress)) continue;
        forces(r, &flow, &moves, force);
        const struct solid_section worst = solid_sections_worst(s, chosen, force);
        const double moved =
            prescribed(r, chosen, limit.modulus, limit.density, &moves) + initial(r->scene->solid, limit.modulus);
        if (fmax(worst.stress, flow.pressure) + moved > 0)
            print_limit(s->in.body[b].name, &worst, flow.pressure, moved, &limit, is_all);
        else
            print("  %s: no load that can be foreseen\n", s->in.body[b].name);
    }
    for (int c = 0; c < s->dim; c++) memory_free(force[c]);
    memory_free(chosen);
}
