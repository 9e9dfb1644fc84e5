/* Held and driven layers: flags, imposed velocities and displacements, reactions.  (001: sec. 3.3.11) */
#include "solid/imposed/constraint.h"
#include "base/die.h"
#include "base/par.h"
#include "solid/body/sites_image.h"
#include "solid/geometry/on_surface.h"
#include "solid/geometry/turn.h"
#include "solid/imposed/time.h"
#include "solid/voxels/voxels.h"

#include <math.h>

/* Depth of a particle in a region, or in the part of it that comes in at the opposite side where it reaches beyond a
 * periodic one, as bodies and cracks do. A turned region is looked at in all periods next to the domain. */
static double depth_of(const struct solid *s, int h, const double low[3], const double high[3],
                       const struct solid_turn *turn) {
    double depth = -INFINITY;
    int from[3] = {0}, to[3] = {0}, k[3];
    for (int c = 0; c < s->dim; c++) {
        if (!s->in.periodic[c]) continue;
        from[c] = -(turn->is_turned || low[c] < 0);
        to[c] = turn->is_turned || high[c] > s->in.length[c];
    }
    for (k[2] = from[2]; k[2] <= to[2]; k[2]++)
        for (k[1] = from[1]; k[1] <= to[1]; k[1]++)
            for (k[0] = from[0]; k[0] <= to[0]; k[0]++) {
                double x[3] = {0}, own[3];
                for (int c = 0; c < s->dim; c++) x[c] = s->x0[c][h] + (k[c] ? k[c] * s->in.length[c] : 0);
                solid_turn_place_into(turn, x, own);
                depth = fmax(depth, solid_on_surface_depth(own, low, high, s->dim));
            }
    return depth;
}

int solid_constraint_inside(const struct solid *s, int h, const double low[3], const double high[3],
                            const struct solid_turn *turn) {
    return solid_on_surface_is_inside(depth_of(s, h, low, high, turn), s->in.spacing);
}

long solid_constraint_on_border(const struct solid *s, const double low[3], const double high[3],
                                const struct solid_turn *turn) {
    long on = 0;
    for (int h = 0; h < s->n; h++) on += solid_on_surface_is_on(depth_of(s, h, low, high, turn), s->in.spacing);
    return par_sum_long(on);
}

/* Tested first: most particles are free. */
static int is_held(const struct solid *s, int h, int c) { return s->flag[h] >> c & SOLID_HELD_X; }

/* The velocity of a constraint from t to t + dt; if a displacement is given, the velocity that leads to it. */
static double velocity_of(const struct solid_constraint *k, int c, double t, double dt) {
    if (!k->has_displacement) return k->velocity[c] * solid_time_mean(&k->time, t, t + dt);
    if (!(dt > 0)) return 0;
    return k->displacement[c] * ((solid_time_factor(&k->time, t + dt) - solid_time_factor(&k->time, t)) / dt);
}

void solid_constraint_velocity(struct solid *s, double t, double dt) {
    for (int q = 0; q < s->in.constraints; q++) {
        const struct solid_constraint *k = &s->in.constraint[q];
        for (int c = 0; c < s->dim; c++) {
            const double velocity = velocity_of(k, c, t, dt);
            double *v = s->v[c];
            for (int h = 0; k->direction[c] && h < s->n; h++) {
                if (!is_held(s, h, c) || !solid_constraint_inside(s, h, k->low, k->high, &k->turn)) continue;
                const double mass = solid_density(s, h) * s->volume[h];
                s->e_constraint += 0.5 * mass * (velocity + v[h]) * (velocity - v[h]);
                v[h] = velocity;
            }
        }
    }
}

int solid_constraint_varies(const struct solid *s) {
    int n = 0;
    for (int q = 0; q < s->in.constraints; q++) n += s->in.constraint[q].time.n;
    return n > 0;
}

/* Whether a later constraint holds the particle in the direction too: that one moves it. */
static int is_overruled(const struct solid *s, int q, int h, int c) {
    int overruled = 0;
    for (int p = q + 1; p < s->in.constraints && !overruled; p++) {
        const struct solid_constraint *k = &s->in.constraint[p];
        overruled = k->direction[c] && solid_constraint_inside(s, h, k->low, k->high, &k->turn);
    }
    return overruled;
}

void solid_constraint_displacement(struct solid *s, double t) {
    for (int q = 0; q < s->in.constraints; q++) {
        const struct solid_constraint *k = &s->in.constraint[q];
        const double factor = solid_time_factor(&k->time, t);
        for (int c = 0; c < s->dim; c++)
            for (int h = 0; k->has_displacement && k->direction[c] && h < s->n; h++)
                if (is_held(s, h, c) && solid_constraint_inside(s, h, k->low, k->high, &k->turn) &&
                    !is_overruled(s, q, h, c))
                    s->d[c][h] = k->displacement[c] * factor;
    }
}

void solid_constraint_flags(struct solid *s) {
    for (int q = 0; q < s->in.constraints; q++) {
        const struct solid_constraint *k = &s->in.constraint[q];
        for (int h = 0; h < s->n; h++)
            if (solid_constraint_inside(s, h, k->low, k->high, &k->turn))
                for (int c = 0; c < s->dim; c++)
                    if (k->direction[c]) s->flag[h] |= (uint8_t)(SOLID_HELD_X << c);
    }
    for (int q = 0; q < s->in.unbreakables; q++)
        for (int h = 0; h < s->n; h++)
            if (solid_constraint_inside(s, h, s->in.unbreakable[q].low, s->in.unbreakable[q].high,
                                        &s->in.unbreakable[q].turn))
                s->flag[h] |= SOLID_UNBREAKABLE;
}

/* Dies if no particle of any rank is in the region of the scene's key. */
static void region_check(const struct solid *s, const char *key, int k, const double low[3], const double high[3],
                         const struct solid_turn *turn) {
    long inside = 0;
    for (int h = 0; h < s->n; h++) inside += solid_constraint_inside(s, h, low, high, turn);
    if (par_sum_long(inside) == 0)
        die_all(EXIT_CODE_SCENE, "solid.%s[%d]: no particle stands between low and high; they are %g m apart", key, k,
                s->in.spacing);
}

void solid_constraint_check(const struct solid *s) {
    for (int k = 0; k < s->in.constraints; k++)
        region_check(s, "constraints", k, s->in.constraint[k].low, s->in.constraint[k].high, &s->in.constraint[k].turn);
    for (int k = 0; k < s->in.unbreakables; k++)
        region_check(s, "unbreakable", k, s->in.unbreakable[k].low, s->in.unbreakable[k].high,
                     &s->in.unbreakable[k].turn);
    for (int k = 0; k < s->in.loads; k++)
        if (s->in.load[k].kind == SOLID_LOAD_REGION)
            region_check(s, "loads", k, s->in.load[k].low, s->in.load[k].high, &s->in.load[k].turn);
}

/* Holds the particles in voxels that an image holds. */
static void hold_voxels(struct solid *s) {
    for (int h = 0; h < s->n; h++) {
        const struct solid_voxels *v = s->in.body[s->body[h]].voxels;
        if (!v || !v->held) continue;
        int site[3];
        for (int c = 0; c < 3; c++) {
            const int period = s->in.periodic[c] ? (int)lrint(s->in.length[c] / s->in.spacing) : 0;
            site[c] = (int)floor((s->x0[c][h] - s->in.origin[c]) / s->in.spacing);
            while (period > 0 && site[c] < v->corner[c]) site[c] += period;
            while (period > 0 && site[c] >= v->corner[c] + period) site[c] -= period;
        }
        if (solid_sites_image_is(v, v->held, site)) s->flag[h] |= SOLID_HELD_X | SOLID_HELD_X << 1 | SOLID_HELD_X << 2;
    }
}

void solid_constraint_mark(struct solid *s) {
    solid_constraint_flags(s);
    hold_voxels(s);
    solid_constraint_displacement(s, s->t);
    solid_constraint_velocity(s, s->t, 0);
    s->e_constraint = 0; /* the velocity at the start is not work of the constraints */
}

double solid_constraint_apply(struct solid *s) {
    double power = 0, reaction2 = 0;
    for (int h = 0; h < s->n; h++) {
        if (!(s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z))) continue;
        const double mass = solid_density(s, h) * s->volume[h];
        for (int c = 0; c < s->dim; c++) {
            if (!(s->flag[h] & SOLID_HELD_X << c)) continue;
            const double reaction = -mass * s->a[c][h];
            power += reaction * s->v[c][h];
            reaction2 += reaction * reaction;
            s->a[c][h] = 0;
        }
    }
    s->power_constraint = power;
    return reaction2;
}
