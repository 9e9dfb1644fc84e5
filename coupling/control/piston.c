/* Finds bodies whose imposed motion, or whose motion under loads, displaces fluid that has no open path out. */
#include "coupling/control/piston.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/interface/deposit.h"
#include "fluid/grid/side.h"
#include "solid/imposed/constraint.h"

#include <math.h>
#include <stdio.h>

/* What a part must take, of what the faces towards it displace and draw, and of what the fronts of all bodies displace:
 * the fluid around a body takes nothing in all. */
static const double PART_OF_FACES = 0.25, PART_OF_FRONTS = 0.1;
/* How far the bodies are moved on, in cells, so that fluid can come behind those that stand at a side. */
static const double ON = 1;
static const double TIE = 1e-9;

/* What is imposed on a body. */
struct imposed {
    int is_rigid; /* one velocity on parts of it, or none on all of it; else it gives way */
    int is_free;  /* nothing on any part of it */
    double velocity[3], speed;
};

/* The fastest imposed velocity along c, m/s, with its sign. */
static double fastest(const struct solid_constraint *k, int c) {
    const struct solid_time *time = &k->time;
    double most = k->has_displacement || time->n > 0 ? 0 : k->velocity[c];
    for (int p = 0; p < time->n; p++) {
        double v = k->velocity[c] * time->factor[p];
        if (k->has_displacement) {
            if (p == 0 || !(time->t[p] > time->t[p - 1])) continue;
            v = k->displacement[c] * ((time->factor[p] - time->factor[p - 1]) / (time->t[p] - time->t[p - 1]));
        }
        if (fabs(v) > fabs(most)) most = v;
    }
    return most;
}

/* The constraint of a particle in a direction, the last of several; NULL: held by an image, or free. */
static const struct solid_constraint *constraint_of(const struct solid *s, int h, int c) {
    for (int q = s->in.constraints - 1; q >= 0; q--) {
        const struct solid_constraint *k = &s->in.constraint[q];
        if (k->direction[c] && solid_constraint_inside(s, h, k->low, k->high, &k->turn)) return k;
    }
    return NULL;
}

static struct imposed imposed_on(const struct solid *s, int b) {
    struct imposed m = {0};
    double least[3] = {INFINITY, INFINITY, INFINITY}, most[3] = {-INFINITY, -INFINITY, -INFINITY};
    long free = 0, held = 0;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3 && s->body[h] == b; c++) {
            if (!(s->flag[h] & SOLID_HELD_X << c)) {
                free++;
                continue;
            }
            held++;
            const struct solid_constraint *k = constraint_of(s, h, c);
            const double v = k ? fastest(k, c) : 0;
            least[c] = fmin(least[c], v);
            most[c] = fmax(most[c], v);
        }
    par_min_array(least, 3);
    par_max_array(most, 3);
    free = par_sum_long(free);
    m.is_free = par_sum_long(held) == 0;
    int is_one = 1;
    for (int c = 0; c < 3; c++) {
        if (least[c] > most[c]) continue; /* free */
        is_one &= least[c] == most[c];
        m.velocity[c] = least[c];
        m.speed += least[c] * least[c];
    }
    m.speed = sqrt(m.speed);
    m.is_rigid = is_one && (m.speed > 0 || free == 0);
    return m;
}

/* The particles to deposit: their positions, and their volumes or 0. */
struct deposit {
    double *x[3], *volume;
};

static struct deposit deposit_new(const struct solid *s) {
    struct deposit l;
    for (int c = 0; c < 3; c++) l.x[c] = memory_new(MEMORY_COUPLING, (size_t)s->n + 1, sizeof(double));
    l.volume = memory_new(MEMORY_COUPLING, (size_t)s->n + 1, sizeof(double));
    return l;
}

static void deposit_free(struct deposit *l) {
    for (int c = 0; c < 3; c++) memory_free(l->x[c]);
    memory_free(l->volume);
}

static int is_same(const struct imposed *a, const struct imposed *b) {
    int is = a->is_rigid == b->is_rigid;
    for (int c = 0; c < 3; c++) is &= a->velocity[c] == b->velocity[c];
    return is;
}

/* Deposits the volume of all rigid bodies that have the motion, or any (NULL), in the cells. */
static void deposit_bodies(struct run *r, const struct imposed *body, const struct deposit *l,
                           const struct imposed *motion) {
    const struct solid *s = r->solid;
    for (int h = 0; h < s->n; h++) {
        const struct imposed *m = &body[s->body[h]];
        l->volume[h] = m->is_rigid && (!motion || is_same(m, motion)) ? s->volume[h] : 0;
    }
    medium_deposit(r->medium, s->n, (const double *const *)l->x, l->volume);
}

/* Moves the bodies on by so many cells, and finds the part of the fluid without a way out that takes or gives most.
 * is_between: and only if all bodies together displace as much as they draw, so that none leans on a wall or a body. */
static struct medium_part largest_part_of(struct run *r, const struct imposed *body, const struct deposit *l, double on,
                                          int is_between) {
    const struct solid *s = r->solid;
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const struct fluid_input *in = fluid_input_of(r->fluid);
    const double way = on * fmax(g->d[0], fmax(g->d[1], g->d[2]));
    for (int h = 0; h < s->n; h++) {
        const struct imposed *m = &body[s->body[h]];
        for (int c = 0; c < 3; c++)
            l->x[c][h] = s->x0[c][h] + s->d[c][h] + (m->speed > 0 ? way * (m->velocity[c] / m->speed) : 0);
    }
    double *velocity[3];
    for (int c = 0; c < 3; c++) velocity[c] = memory_new(MEMORY_COUPLING, g->size, sizeof(double));
    for (int b = 0; b < s->in.bodies; b++) {
        int is_first = body[b].is_rigid && body[b].speed > 0;
        for (int other = 0; other < b; other++) is_first &= !is_same(&body[other], &body[b]);
        if (!is_first) continue;
        deposit_bodies(r, body, l, &body[b]);
        medium_closed_mark(r->medium, body[b].velocity, velocity);
    }
    deposit_bodies(r, body, l, NULL);
    int ways[3][2];
    for (int d = 0; d < 3; d++)
        for (int high = 0; high < 2; high++) ways[d][high] = fluid_side_flow(&in->side[d][high], d, high) != 0;
    struct medium_part worst = {0}, *part;
    const double *const v[3] = {velocity[0], velocity[1], velocity[2]};
    double net;
    const double fronts = medium_closed_fronts(r->medium, v, &net);
    const long parts = medium_closed_parts(r->medium, (const int(*)[2])ways, v, &part);
    for (long k = 0; k < parts; k++) {
        const double rate = fabs(part[k].rate);
        if (rate > PART_OF_FACES * part[k].faces && rate > PART_OF_FRONTS * fronts &&
            rate > fabs(worst.rate) * (part[k].rate > 0 ? 1 - TIE : 1 + TIE)) /* before a body rather than behind it */
            worst = part[k];
    }
    memory_free(part);
    if (is_between && fabs(net) > PART_OF_FACES * fronts) worst.rate = 0;
    for (int c = 0; c < 3; c++) memory_free(velocity[c]);
    return worst;
}

/* Whether a closed part of the fluid takes what the bodies displace, also with the bodies moved on. */
static int is_closed(struct run *r, const struct imposed *body, int is_between, struct medium_part *now) {
    struct deposit l = deposit_new(r->solid);
    *now = largest_part_of(r, body, &l, 0, is_between);
    const int is = now->rate != 0 && largest_part_of(r, body, &l, ON, is_between).rate != 0;
    deposit_free(&l);
    r->deposited = -1;
    deposit_update(r);
    return is;
}

static int of_imposed(struct run *r, const struct imposed *body, char sentence[PISTON_SENTENCE]) {
    int fast = -1, driven = 0;
    struct medium_part now;
    for (int b = 0; b < r->solid->in.bodies; b++) {
        if (!body[b].is_rigid || body[b].speed == 0) continue;
        driven++;
        if (fast < 0 || body[b].speed > body[fast].speed) fast = b;
    }
    if (fast < 0 || !is_closed(r, body, 0, &now)) return 0;
    snprintf(sentence, PISTON_SENTENCE,
             "the imposed motion of %s, %.3g m/s at most, %s %.3g m3/s of fluid %s %.3g m3 that have no way out "
             "that the cells resolve: the fluid is pressed through the solid",
             driven == 1 ? r->solid->in.body[fast].name : "the bodies", body[fast].speed,
             now.rate > 0 ? "displaces" : "draws", fabs(now.rate), now.rate > 0 ? "into" : "from", now.volume);
    return 1;
}

/* The largest factor of a load, with its sign. */
static double largest(const struct solid_time *time) {
    double most = time->n == 0 ? 1 : 0;
    for (int p = 0; p < time->n; p++)
        if (fabs(time->factor[p]) > fabs(most)) most = time->factor[p];
    return most;
}

/* What loads, weight and buoyancy push a body with at most, or else the velocity that it begins with; 0: nothing, or
 * less than rounding. */
static void push_on(const struct run *r, int b, double push[3]) {
    const struct solid *s = r->solid;
    const struct fluid_input *in = fluid_input_of(r->fluid);
    double sum[6] = {0}; /* and of the magnitudes */
    for (int h = 0; h < s->n; h++) {
        if (s->body[h] != b) continue;
        double force[3], size[3];
        for (int c = 0; c < 3; c++) {
            const double weight = solid_density(s, h) * s->in.body_force[c], buoyancy = in->density * in->body_force[c];
            force[c] = weight - buoyancy;
            size[c] = fabs(weight) + fabs(buoyancy);
        }
        for (int k = 0; k < s->in.loads; k++) {
            const struct solid_load *load = &s->in.load[k];
            if (!solid_constraint_inside(s, h, load->low, load->high, &load->turn)) continue;
            for (int c = 0; c < 3; c++) force[c] += largest(&load->time) * load->force[c];
            for (int c = 0; c < 3; c++) size[c] += fabs(largest(&load->time) * load->force[c]);
        }
        for (int c = 0; c < 3; c++) sum[c] += s->volume[h] * force[c];
        for (int c = 0; c < 3; c++) sum[3 + c] += s->volume[h] * size[c];
    }
    par_sum_array(sum, 6);
    const double all = sum[3] + sum[4] + sum[5], *v = r->scene->solid->body[b].velocity;
    const int moves = v[0] != 0 || v[1] != 0 || v[2] != 0;
    for (int c = 0; c < 3; c++) push[c] = moves ? v[c] : fabs(sum[c]) > TIE * all ? sum[c] : 0;
}

/* Whether body b fills the domain across a direction to a cell, so that it may shut it. */
static int spans(const struct run *r, int b, int along) {
    const struct solid *s = r->solid;
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    double end[6]; /* -low, high */
    for (int k = 0; k < 6; k++) end[k] = -INFINITY;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3 && s->body[h] == b; c++) {
            end[c] = fmax(end[c], 0.5 * s->in.spacing - s->x0[c][h]);
            end[3 + c] = fmax(end[3 + c], 0.5 * s->in.spacing + s->x0[c][h]);
        }
    par_max_array(end, 6);
    for (int c = 0; c < 3; c++)
        if (c != along && (end[c] < -g->d[c] || end[3 + c] < r->scene->domain.size[c] - g->d[c])) return 0;
    return 1;
}

/* Of a free body that shuts a duct and is pushed along it. Only bodies that span the domain are examined, one at a
 * time; other free ones give way. */
static int of_pushed(struct run *r, const struct imposed *body, char sentence[PISTON_SENTENCE]) {
    const int bodies = r->solid->in.bodies;
    int is = 0;
    struct imposed *one = memory_new(MEMORY_COUPLING, (size_t)bodies, sizeof *one);
    for (int b = 0; b < bodies && !is; b++) {
        double push[3];
        int along = 0;
        struct medium_part now;
        if (!body[b].is_free) continue;
        push_on(r, b, push);
        for (int c = 1; c < 3; c++)
            if (fabs(push[c]) > fabs(push[along])) along = c;
        if (push[along] == 0 || !spans(r, b, along)) continue;
        for (int other = 0; other < bodies; other++) {
            one[other] = body[other];
            one[other].is_rigid &= one[other].speed == 0;
        }
        one[b] = (struct imposed){.is_rigid = 1, .speed = 1};
        one[b].velocity[along] = push[along] > 0 ? 1 : -1;
        is = is_closed(r, one, 1, &now);
        if (is)
            snprintf(
                sentence, PISTON_SENTENCE,
                "body %s is pushed along %c, and the %.3g m3 of fluid %s it have no way out that the cells resolve: it "
                "would stand still, and moves because the fluid is pressed through the solid",
                r->solid->in.body[b].name, "xyz"[along], now.volume, now.rate > 0 ? "before" : "behind");
    }
    memory_free(one);
    return is;
}

int piston_of(struct run *r, char sentence[PISTON_SENTENCE]) {
    int moves = 0;
    if (!r->needs.immersed || r->solid->dim != 3) return 0;
    for (int k = 0; k < r->scene->stages; k++)
        moves |= r->scene->stage[k].solid == SCENE_SOLID_ELASTIC && !r->scene->stage[k].relax;
    if (!moves) return 0;
    struct imposed *body = memory_new(MEMORY_COUPLING, (size_t)r->solid->in.bodies, sizeof *body);
    for (int b = 0; b < r->solid->in.bodies; b++) body[b] = imposed_on(r->solid, b);
    const int is = of_imposed(r, body, sentence) || of_pushed(r, body, sentence);
    memory_free(body);
    return is;
}
