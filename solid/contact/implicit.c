/* Contact over a substep of velocity Verlet, implicit in the displacements. */
#include "solid/contact/implicit.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "physics/chebyshev.h"
#include "solid/contact/contact.h"
#include "solid/contact/near.h"
#include "solid/contact/room.h"
#include "solid/imposed/added_mass.h"
#include "solid/imposed/reactions.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The residual over the largest acceleration of contact, at which the iteration ends; the energy of contact is kept to
 * this part of its work in a substep. Momentum is kept to round-off in any case. */
static const double TOLERANCE = 1e-6;
/* Accelerations are sums of multiples of contact's quantum, so the residual cannot fall below some of them. */
enum { QUANTA = 16, ITERATIONS_MAX = 2000 };
/* The part of that at which a particle is left where it is. */
static const double SETTLED = 0.25;
/* The residual is reduced over the ranks when it should be small enough, and after this number of terms at most. */
enum { LOOK = 6 };
/* A pair that moves by twice this part of r_c in a substep may be overlooked. */
static const double FAR = 0.1;
/* Pairs are taken up to this distance beyond r_c, in r_c, at first. */
static const double REACH = 0.005;
/* The least span of the eigenvalues that the iteration is made for. */
static const double SPAN_LEAST = 2e-3;

struct solid_contact_implicit {
    struct solid_near near;
    int across; /* 1: on some rank a node is not owned */
};

void solid_contact_implicit_free(struct solid_contact_implicit *m) {
    if (!m) return;
    solid_near_free(&m->near);
    memory_free(m);
}

int solid_contact_implicit_is(const struct solid *s) { return s->stage.integrator == SOLID_VERLET && !s->push; }

double solid_contact_implicit_step(const struct solid *s, double fastest) {
    const struct solid_contact *c = s->contact;
    return s->in.contact && c && c->any && fastest > 0 ? FAR * c->radius / fastest : INFINITY;
}

void solid_contact_implicit_check(const struct solid *s, struct step_status *status) {
    if (s->contact && s->contact->status.failed) *status = s->contact->status;
}

void solid_contact_implicit_begin(struct solid *s) {
    struct solid_contact *c = s->contact;
    if (!c->any) return;
    clock_begin(CLOCK_CONTACT);
    if (!c->implicit) c->implicit = memory_new(MEMORY_SOLID, 1, sizeof *c->implicit);
    solid_near_begin(s, c, &c->implicit->near);
    clock_end(CLOCK_CONTACT);
}

/* Puts the owned nodes at d* + dt^2/2 a. */
static void place(const struct solid *s, struct solid_near *m, double half) {
    for (int k = 0; k < m->nodes; k++) {
        const struct solid_near_node *node = &m->node[k];
        for (int i = 0; node->is_own && i < s->dim; i++)
            if (!(node->held >> i & 1)) m->end[k].d[i] = node->predicted[i] + half * m->a[k][i];
    }
}

/* A bound of contact's stiffness over mass at the owned nodes, 1/s2. */
static double stiffest(const struct solid_near *m) {
    double most = 0;
    for (int k = 0; k < m->nodes; k++) {
        const double *t = m->node[k].stiffness;
        /* the trace is not below the largest eigenvalue, so most nodes need no more than that */
        if (!m->node[k].is_own || (t[XX] + t[YY] + t[ZZ]) * (1 + 1e-9) <= most) continue;
        most = fmax(most, solid_contact_tensor_largest(t));
    }
    return most;
}

/* NaN is larger than any number. */
static double larger(double a, double b) { return b > a || b != b ? b : a; }

enum { RESIDUAL, LARGEST, SHIFT, STIFFEST, ACROSS, SEEN };

/* The residual of a node's free directions, m/s2. */
static double residual_of(const struct solid_near *m, int dim, int k) {
    const double *push = solid_near_pushed(m, k), *a = m->a[k];
    double most = 0;
    for (int i = 0; i < dim; i++) {
        if (!(m->held[k] >> i & 1)) most = larger(most, fabs(push[i] - a[i]));
    }
    return most;
}

/* The largest component of the residual, of the acceleration and of its change since the start, m/s2, over all ranks;
 * the first time what else the ranks must agree about. */
static void measure(const struct solid *s, const struct solid_near *m, double seen[SEEN]) {
    seen[RESIDUAL] = seen[LARGEST] = seen[SHIFT] = 0;
    for (int k = 0; k < m->nodes; k++) {
        const double *push = solid_near_pushed(m, k);
        seen[RESIDUAL] = larger(seen[RESIDUAL], residual_of(m, s->dim, k));
        for (int i = 0; i < s->dim; i++) {
            if (m->held[k] >> i & 1) continue;
            seen[LARGEST] = larger(seen[LARGEST], fabs(push[i]));
            seen[SHIFT] = larger(seen[SHIFT], fabs(push[i] - m->node[k].first[i]));
        }
    }
    par_max_array(seen, SEEN);
}

/* The iteration has failed: the step is made again with shorter substeps, or the run ends. */
static void fail(const struct solid *s, struct solid_contact *c, double residual) {
    const struct solid_near *m = &c->implicit->near;
    for (int k = 0; k < m->nodes && !c->status.failed; k++) {
        if (!m->node[k].is_own || residual_of(m, s->dim, k) < residual) continue;
        c->status =
            (struct step_status){.failed = 1, .seen_in = STEP_STATUS_SOLID, .rank = par_rank(), .value = residual};
        for (int i = 0; i < s->dim; i++) c->status.x[i] = s->x0[i][m->node[k].particle];
        snprintf(c->status.field, sizeof c->status.field, "unsolved contact, residual");
    }
}

/* A term of the iteration for the nodes whose residual is larger than enough. The others stay where they are, until
 * their neighbours have moved so far that their residual is larger again. */
static void change(const struct solid *s, struct solid_near *m, const struct physics_chebyshev *of, double enough,
                   double half) {
    for (int k = 0; k < m->nodes; k++) {
        if (!m->may_differ[k] || residual_of(m, s->dim, k) <= enough) {
            m->has_turn[k] = 0;
            continue;
        }
        struct solid_near_node *node = &m->node[k];
        const double *push = solid_near_pushed(m, k);
        double *a = m->a[k];
        const double keep = m->has_turn[k] ? of->keep : 0;
        m->has_moved[k] = m->has_turn[k] = 1;
        for (int i = 0; i < s->dim; i++) {
            node->turn[i] = keep * node->turn[i] + of->gain * (push[i] - a[i]);
            a[i] += node->turn[i];
            if (!(node->held >> i & 1)) m->end[k].d[i] = node->predicted[i] + half * a[i];
        }
    }
}

/* Solves a = C(d* + dt^2/2 a)/rho by Chebyshev's iteration; at the end d belongs to a, and a to d but for TOLERANCE.
 * If the residual grows, the contacts are stiffer than at the start and the iteration begins anew with a larger
 * bound. Returns the largest change of an acceleration since the start. */
static double solve(const struct solid *s, struct solid_contact *c, double half) {
    struct solid_contact_implicit *m = c->implicit;
    struct solid_near *near = &m->near;
    struct physics_chebyshev of = {0};
    double beta = 0, enough = 0, least = INFINITY, seen[SEEN] = {[STIFFEST] = stiffest(near)};
    for (int k = 0; k < near->nodes; k++) {
        seen[ACROSS] = fmax(seen[ACROSS], !near->node[k].is_own);
        memcpy(near->node[k].first, near->a[k], sizeof *near->a);
    }
    for (int turn = 0, look = 0;; turn++) {
        solid_near_push(s, c, near);
        if (turn == look) {
            measure(s, near, seen);
            enough = fmax(TOLERANCE * seen[LARGEST], QUANTA * c->quantum);
            if (!(seen[RESIDUAL] > enough)) break;
            if (turn >= ITERATIONS_MAX) {
                fail(s, c, seen[RESIDUAL]);
                break;
            }
            if (turn == 0 || seen[RESIDUAL] > 4 * least) {
                beta = turn == 0 ? fmax(0.5 * half * seen[STIFFEST], SPAN_LEAST) : 4 * beta;
                of = physics_chebyshev_of(1, 1 + beta);
                least = seen[RESIDUAL];
            }
            least = fmin(least, seen[RESIDUAL]);
            const int terms = physics_chebyshev_terms(&of, enough / seen[RESIDUAL]);
            look += terms < LOOK ? terms : LOOK;
            if (near->nodes > 0) memset(near->may_differ, 1, (size_t)near->nodes); /* enough may be less than before */
        }
        physics_chebyshev_next(&of);
        c->terms++;
        change(s, near, &of, SETTLED * enough, half);
        if (seen[ACROSS] > 0) solid_near_ask(s, c, near);
    }
    for (int k = 0; k < near->nodes; k++) memcpy(near->a[k], solid_near_pushed(near, k), sizeof *near->a);
    place(s, near, half);
    return seen[SHIFT];
}

static int is_pushed(const struct solid_near *m, int k) {
    return m->node[k].is_own && (m->a[k][0] != 0 || m->a[k][1] != 0 || m->a[k][2] != 0);
}

/* The displacements and velocities; the work of loads, added mass and constraints over the motion; the constraints'
 * impulses. */
static void finish(struct solid *s, const struct solid_near *m, double dt) {
    for (int k = 0; k < m->nodes; k++) {
        const struct solid_near_node *node = &m->node[k];
        const double *d = m->end[k].d;
        if (!is_pushed(m, k)) continue; /* it is where it was predicted */
        const int h = node->particle;
        const double density = solid_density(s, h), mass = density * s->volume[h];
        double impulse[3] = {0};
        for (int i = 0; i < s->dim; i++) {
            s->d[i][h] = d[i];
            impulse[i] = mass * dt * m->a[k][i];
            if (node->held >> i & 1) {
                s->e_constraint -= mass * m->a[k][i] * (d[i] - node->start[i]);
                continue;
            }
            s->v[i][h] += dt * m->a[k][i];
            s->work_load += s->volume[h] * (s->load[i][h] + density * s->in.body_force[i]) * 0.5 * dt * dt * m->a[k][i];
        }
        if (node->held && s->reactions) solid_reactions_give(s, h, impulse);
    }
    for (int k = 0; k < m->faces; k++) {
        const struct solid_near_face *f = &m->face[k];
        const struct solid_near_node *node = &m->node[f->node];
        double moved = 0;
        for (int i = 0; i < s->dim; i++) moved += (m->end[f->node].d[i] - node->start[i]) * s->added->normal[i][f->of];
        s->work_load -= s->volume[node->particle] * solid_density(s, node->particle) * f->lost * moved;
    }
}

void solid_contact_implicit_end(struct solid *s, double dt) {
    struct solid_contact *c = s->contact;
    if (!c->any) return;
    struct solid_near *m = &c->implicit->near;
    clock_begin(CLOCK_CONTACT);
    const double half = 0.5 * dt * dt;
    double reach = REACH * c->radius;
    solid_near_predict(s, c, m);
    for (;;) {
        solid_near_gather(s, c, m, reach);
        const double moved = sqrt((double)s->dim) * half * solve(s, c, half);
        /* pushed further than the pairs that were taken reach: others may be hit */
        if (!(2 * moved > reach) || reach >= c->skin) break;
        reach = fmin(fmax(2 * reach, 3 * moved), c->skin);
    }
    finish(s, m, dt);
    clock_end(CLOCK_CONTACT);
}
