/* Contact over a substep of velocity Verlet, implicit in the displacements. */
#include "solid/contact/implicit.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/par_ghost.h"
#include "solid/contact/implicit_parts.h"
#include "solid/contact/pairs.h"
#include "solid/contact/reserve.h"
#include "solid/imposed/added_mass.h"
#include "solid/imposed/reactions.h"

#include <math.h>
#include <string.h>

/* A pair that moves by twice this part of r_c in a substep may be overlooked. */
static const double FAR = 0.1;
/* The square of the least distance of two particles, over r_c^2, as in struct solid_contact_touch. */
static const double LEAST2 = 1e-12;

void solid_contact_implicit_free(struct solid_contact_implicit *m) {
    if (!m) return;
    solid_contact_touching_free(&m->touching);
    MEMORY_FREE(m->motion, m->close, m->node_of, m->remote, m->taken[0], m->taken[1], m->taken[2], m->node, m->face,
                m->face_of, m->by.a, m->by.turn, m->by.now, m->by.push, m->by.moves, m->by.predicted, m);
}

int solid_contact_implicit_is(const struct solid *s) { return s->stage.integrator == SOLID_VERLET && !s->push; }

double solid_contact_implicit_step(const struct solid *s, double fastest) {
    const struct solid_contact *c = s->contact;
    return s->in.contact && c && c->any && fastest > 0 ? FAR * c->radius / fastest : INFINITY;
}

struct step_status solid_contact_implicit_status(const struct solid *s) {
    return s->contact && s->contact->implicit ? s->contact->implicit->status : (struct step_status){0};
}

void solid_contact_implicit_reset(struct solid *s) {
    if (s->contact && s->contact->implicit) s->contact->implicit->status.failed = 0;
}

/* Present displacements of all ends, of those of other ranks by the last exchange; d: those of the first end. */
static void read(const struct solid *s, const struct solid_contact *c, double *restrict d) {
    const size_t next = sizeof *c->implicit->motion / sizeof *d;
    const int n = c->ends->n, *restrict particle = c->ends->particle;
    const double *restrict x = s->d[0], *restrict y = s->d[1], *restrict z = s->d[s->dim - 1], third = s->dim == 3;
    for (int k = 0; k < n; k++, d += next) {
        if (particle[k] >= 0) {
            d[0] = x[particle[k]];
            d[1] = y[particle[k]];
            d[2] = third * z[particle[k]];
        } else {
            for (int i = 0; i < s->dim; i++) d[i] = c->ghosts.d[i][SOLID_CONTACT_SERVED_END - particle[k]];
        }
    }
}

static void reserve(struct solid_contact *c, struct solid_contact_implicit *m) {
    const int n = c->ends->n;
    m->motion = solid_contact_reserve(m->motion, &m->motion_capacity, n, sizeof *m->motion);
    m->node_of = solid_contact_reserve(m->node_of, &m->node_of_capacity, n, sizeof *m->node_of);
    m->face_of = solid_contact_reserve(m->face_of, &m->face_of_capacity, n, sizeof *m->face_of);
    m->remote = solid_contact_reserve(m->remote, &m->remote_capacity, n, sizeof *m->remote);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++)
        m->taken[kind] = solid_contact_reserve(m->taken[kind], &m->taken_capacity[kind],
                                               c->pairs[kind].n / VEC_LANES + 1, sizeof *m->taken[kind]);
    m->close = solid_contact_reserve(m->close, &m->close_capacity, c->pairs[SOLID_CONTACT_OWNED].n / VEC_LANES + 1,
                                     sizeof *m->close);
}

void solid_contact_implicit_begin(struct solid *s) {
    struct solid_contact *c = s->contact;
    if (!c->any) return;
    clock_begin(CLOCK_CONTACT);
    if (!c->implicit) c->implicit = memory_new(MEMORY_SOLID, 1, sizeof *c->implicit);
    struct solid_contact_implicit *m = c->implicit;
    for (int k = 0; k < m->nodes; k++) m->node_of[m->node[k].end] = 0;
    m->nodes = 0;
    solid_contact_ends_list(s, c);
    reserve(c, m);
    read(s, c, m->motion->start);
    clock_end(CLOCK_CONTACT);
}

/* The nodes' places and velocities; the work of loads, added mass and constraints over the motion; the constraints'
 * impulses. */
static void finish(struct solid *s, const struct solid_contact_implicit *m, double dt) {
    for (int k = 0; k < m->nodes; k++) {
        const struct solid_contact_node *node = &m->node[k];
        const double *d = m->by.now[k], *start = m->motion[node->end].start, *a = m->by.a[k];
        if (!node->is_own) continue;
        const int h = node->particle;
        const double density = solid_density(s, h), mass = density * s->volume[h];
        double impulse[3] = {0};
        for (int i = 0; i < s->dim; i++) {
            impulse[i] = mass * dt * a[i];
            if (node->held >> i & 1) {
                s->e_constraint -= mass * a[i] * (d[i] - start[i]);
                continue;
            }
            s->d[i][h] = d[i];
            s->v[i][h] += dt * a[i];
            s->work_load += s->volume[h] * (s->load[i][h] + density * s->in.body_force[i]) * 0.5 * dt * dt * a[i];
        }
        if (node->held && s->reactions) solid_reactions_add_impulse(s, h, impulse);
    }
    for (int k = 0; k < m->faces; k++) {
        const struct solid_contact_face *f = &m->face[k];
        const struct solid_contact_node *node = &m->node[f->node];
        double moved = 0;
        for (int i = 0; i < s->dim; i++)
            moved += (m->by.now[f->node][i] - m->motion[node->end].start[i]) * f->normal[i];
        s->work_load -= s->volume[node->particle] * solid_density(s, node->particle) * f->lost * moved;
    }
}

/* Reads where the motion without contact ends. Collective. */
static void begin(struct solid *s, struct solid_contact *c) {
    struct solid_contact_implicit *m = c->implicit;
    if (c->reaches_ghosts) par_ghost_update(s->ghost, s->dim, s->d, s->n);
    if (c->ghosts.active) solid_contact_ghosts_update(s, &c->ghosts);
    read(s, c, m->motion->now);
    solid_contact_implicit_find_faces(s, c);
    m->law = (struct solid_contact_law){
        .exponent = s->in.contact_exponent, .quantum = c->quantum, .least2 = LEAST2 * c->radius * c->radius};
    m->touching.pairs = m->faces = m->remote_ends = m->across = 0;
    m->stiffest = 0;
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++)
        memset(m->taken[kind], 0, (size_t)c->pairs[kind].n / VEC_LANES + 1);
    for (int k = 0; k < c->ends->n && solid_contact_implicit_solve_crosses(c); k++)
        if (c->ends->particle[k] < 0 || c->ends->particle[k] >= s->n) m->remote[m->remote_ends++] = k;
}

void solid_contact_implicit_end(struct solid *s, double dt) {
    struct solid_contact *c = s->contact;
    if (!c->any) return;
    struct solid_contact_implicit *m = c->implicit;
    clock_begin(CLOCK_CONTACT);
    begin(s, c);
    solid_contact_implicit_solve(s, c, 0.5 * dt * dt);
    finish(s, m, dt);
    clock_end(CLOCK_CONTACT);
}

/* The nodes of the last substep, NULL: none. */
static const struct solid_contact_implicit *moved(const struct solid *s) {
    return s->contact && s->contact->any && solid_contact_implicit_is(s) ? s->contact->implicit : NULL;
}

double solid_contact_implicit_push(const struct solid *s, int h, int c) {
    const struct solid_contact_implicit *m = moved(s);
    const int end = m ? s->contact->ends->end_of[h] - 1 : -1, k = end < 0 ? -1 : m->node_of[end] - 1;
    return k < 0 || m->node[k].held >> c & 1 ? 0 : m->by.a[k][c];
}

double solid_contact_implicit_along(const struct solid *s, double *const f[3], double sign, double *const g[3]) {
    const struct solid_contact_implicit *m = moved(s);
    double sum = 0;
    for (int k = 0; m && k < m->nodes; k++) {
        const struct solid_contact_node *node = &m->node[k];
        const int h = node->particle;
        for (int i = 0; node->is_own && i < s->dim; i++)
            if (!(node->held >> i & 1))
                sum += solid_density(s, h) * s->volume[h] * (f[i][h] + sign * g[i][h]) * m->by.a[k][i];
    }
    return sum;
}
