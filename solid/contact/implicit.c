/* Contact over a substep of velocity Verlet, implicit in the displacements. */
#include "solid/contact/implicit.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "solid/contact/contact.h"
#include "solid/contact/pairs.h"
#include "solid/contact/repulsion.h"
#include "solid/contact/room.h"
#include "solid/imposed/added_mass.h"
#include "solid/imposed/reactions.h"

#include <math.h>
#include <string.h>

/* The residual over the largest acceleration of contact, at which the iteration ends; the energy of contact is kept to
 * this part of its work in a substep. Momentum is kept to round-off in any case. */
static const double TOLERANCE = 1e-6;
/* Accelerations are sums of multiples of contact's quantum, so the residual cannot fall below some of them. */
enum { QUANTA = 16, ITERATIONS_MAX = 2001 };
/* The residual is reduced over the ranks in every third iteration. */
enum { LOOK = 3 };
/* A pair that moves by twice this part of r_c in a substep may be overlooked. */
static const double FAR = 0.1;
/* Pairs count as near up to this distance beyond r_c, in r_c, and twice the longest way of a particle. */
static const double REACH = 0.005;
/* The square of the least distance of two particles, over r_c^2, as in struct solid_contact_touch. */
static const double LEAST2 = 1e-12;

/* A particle of a near pair: what the sum over the pairs reads and writes, in one cache line; and the rest. */
struct end {
    double d[3];    /* displacement at the end of the substep, by the last iterate, m */
    double push[3]; /* acceleration by contact with that d, m/s2 */
    double unused[2];
};
struct node {
    double a[3];          /* the iterate, m/s2 */
    double turn[3];       /* its last change, m/s2 */
    double predicted[3];  /* displacement at the end of the substep without contact, m */
    int particle;         /* as in struct solid_contact_end */
    uint8_t is_own, held; /* held: bit c is set if direction c is imposed */
    double start[3];      /* displacement at the beginning of the substep, m */
    double stiffness[6];  /* sum of 2 kappa/rho e e: xx, yy, zz, and sqrt(2) xy, xz, yz, 1/s2 */
};

/* A pair that may touch in the substep. */
struct near {
    int h, l;                        /* nodes */
    int is_own;                      /* both ends are owned here */
    double xi[3], start[3];          /* X0_h - X0_l; X_h - X_l at the beginning, m */
    double depth, potential, radius; /* q and phi at the beginning; r_c of the pair */
    double on_h, on_l;               /* k_c V_l/rho_h, k_c V_h/rho_l, m/s2 */
};

/* A wetted face of a node, with added mass. */
struct face {
    int of, node; /* index in s->added */
    double lost;  /* the part of the acceleration along the normal that the added mass takes, m/s2 */
};

struct solid_contact_implicit {
    double (*start)[3]; /* [ends] displacements at the beginning of the substep, m */
    int *node_of;       /* [ends] 1 + node; 0: none. Of the last try */
    struct end *end;    /* [nodes] */
    struct node *node;  /* [nodes] */
    struct near *pair;
    struct face *face;
    int nodes, pairs, faces, room_start, room_of, room_end, room_node, room_pair, room_face;
    double reach; /* pairs nearer than r_c + reach are taken, m */
    int across;   /* 1: on some rank a node is not owned */
};

void solid_contact_implicit_free(struct solid_contact_implicit *m) {
    if (!m) return;
    memory_free(m->start);
    memory_free(m->node_of);
    memory_free(m->end);
    memory_free(m->node);
    memory_free(m->pair);
    memory_free(m->face);
    memory_free(m);
}

int solid_contact_implicit_is(const struct solid *s) { return s->stage.integrator == SOLID_VERLET && !s->push; }

double solid_contact_implicit_step(const struct solid *s, double fastest) {
    const struct solid_contact *c = s->contact;
    return s->in.contact && c && c->any && fastest > 0 ? FAR * c->radius / fastest : INFINITY;
}

void solid_contact_implicit_begin(struct solid *s) {
    struct solid_contact *c = s->contact;
    if (!c->any) return;
    clock_begin(CLOCK_CONTACT);
    if (!c->implicit) c->implicit = memory_new(MEMORY_SOLID, 1, sizeof *c->implicit);
    struct solid_contact_implicit *m = c->implicit;
    solid_contact_ends_update(s, c);
    const int n = c->ends->n;
    m->start = solid_contact_room(m->start, &m->room_start, n, sizeof *m->start);
    m->node_of = solid_contact_room(m->node_of, &m->room_of, n, sizeof *m->node_of);
    for (int k = 0; k < n; k++) memcpy(m->start[k], c->ends->end[k].d, sizeof *m->start);
    clock_end(CLOCK_CONTACT);
}

/* The longest way of a particle in contact's lists from its start to its present place, m. */
static double longest_way(const struct solid_contact_ends *t, const struct solid_contact_implicit *m) {
    double most = 0;
    for (int k = 0; k < t->n; k++) {
        double way2 = 0;
        for (int i = 0; i < 3; i++) way2 += (t->end[k].d[i] - m->start[k][i]) * (t->end[k].d[i] - m->start[k][i]);
        most = fmax(most, way2);
    }
    return sqrt(most);
}

static int node_of(const struct solid *s, struct solid_contact_implicit *m, const struct solid_contact_ends *t, int k) {
    if (m->node_of[k] > 0) return m->node_of[k] - 1;
    const struct solid_contact_end *e = &t->end[k];
    m->node = solid_contact_room(m->node, &m->room_node, m->nodes + 1, sizeof *m->node);
    m->end = solid_contact_room(m->end, &m->room_end, m->nodes + 1, sizeof *m->end);
    struct node *node = &m->node[m->nodes];
    *node = (struct node){.particle = e->particle, .is_own = e->particle >= 0 && e->particle < s->n};
    if (node->is_own) node->held = s->flag[e->particle] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z);
    memcpy(m->end[m->nodes].d, e->d, sizeof e->d);
    memcpy(node->predicted, e->d, sizeof node->predicted);
    memcpy(node->start, m->start[k], sizeof node->start);
    m->node_of[k] = ++m->nodes;
    return m->nodes - 1;
}

/* Adds a pair's stiffness where it is nearest, at r, with the margin of a pair that is about to touch. */
static void stiffen(struct solid_contact_implicit *m, const struct near *p, double r, double exponent, double quantum) {
    const double root2 = 1.41421356237309504880;
    const double slope = exponent * pow(fmin(p->radius / r, 1e3), exponent + 1) / p->radius;
    const double *x = p->start, inverse = 1 / (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    const double along[6] = {x[0] * x[0],         x[1] * x[1],         x[2] * x[2],
                             root2 * x[0] * x[1], root2 * x[0] * x[2], root2 * x[1] * x[2]};
    quantum /= p->radius;
    for (int i = 0; i < 6; i++) {
        const double part = 2 * slope * inverse * along[i];
        m->node[p->h].stiffness[i] += solid_contact_list_rounded(part * p->on_h, quantum);
        m->node[p->l].stiffness[i] += solid_contact_list_rounded(part * p->on_l, quantum);
    }
}

/* A bound of the tensor's largest eigenvalue: its norm. */
static double largest_of(const struct node *node) {
    double sum = 0;
    for (int i = 0; i < 6; i++) sum += node->stiffness[i] * node->stiffness[i];
    return sqrt(sum);
}

static void gather(const struct solid *s, struct solid_contact *c, int kind) {
    struct solid_contact_implicit *m = c->implicit;
    const struct solid_contact_pairs *p = &c->pairs[kind];
    int found[SOLID_CONTACT_BLOCK];
    for (int from = 0; from < p->n; from += SOLID_CONTACT_BLOCK) {
        const int n = solid_contact_pairs_touching(c, kind, from, c->radius + m->reach, found);
        m->pair = solid_contact_room(m->pair, &m->room_pair, m->pairs + n, sizeof *m->pair);
        for (int j = 0; j < n; j++) {
            const int k = found[j];
            const struct solid_contact_touch t = solid_contact_pairs_touch_of(s, c, kind, k);
            struct near q = {.is_own = kind == SOLID_CONTACT_OWNED,
                             .radius = t.radius,
                             .on_h = t.k * t.l->volume / c->density[t.h->material],
                             .on_l = t.k * t.h->volume / c->density[t.l->material]};
            const double *of_h = m->start[c->ends->h[kind][k]], *of_l = m->start[c->ends->l[kind][k]];
            double start2 = 0;
            for (int i = 0; i < s->dim; i++) {
                q.xi[i] = p->xi[i][k];
                q.start[i] = q.xi[i] + (of_h[i] - of_l[i]);
                start2 += q.start[i] * q.start[i];
            }
            start2 = fmax(start2, LEAST2 * c->radius * c->radius);
            const double nearest = fmin(sqrt(start2), t.r);
            if (nearest >= t.radius + m->reach) continue;
            q.depth = solid_repulsion_depth(start2, t.radius);
            q.potential = solid_repulsion_potential(q.depth, t.radius, s->in.contact_exponent);
            q.h = node_of(s, m, c->ends, c->ends->h[kind][k]);
            q.l = node_of(s, m, c->ends, c->ends->l[kind][k]);
            if (nearest < (1 + REACH) * t.radius) stiffen(m, &q, nearest, s->in.contact_exponent, c->quantum);
            m->pair[m->pairs++] = q;
        }
    }
}

/* All its directions are imposed. */
static int is_fixed(const struct solid *s, const struct node *node) { return node->held == (1 << s->dim) - 1; }

/* Faces with added mass at the nodes that can move; the ones of one particle stay adjacent. */
static void gather_faces(const struct solid *s, struct solid_contact *c) {
    struct solid_contact_implicit *m = c->implicit;
    m->faces = 0;
    for (int i = 0; s->added && m->nodes > 0 && i < s->added->n; i++) {
        const int end = c->ends->of[s->added->h[i]] - 1;
        if (end < 0 || m->node_of[end] == 0 || is_fixed(s, &m->node[m->node_of[end] - 1])) continue;
        m->face = solid_contact_room(m->face, &m->room_face, m->faces + 1, sizeof *m->face);
        m->face[m->faces++] = (struct face){.of = i, .node = m->node_of[end] - 1};
    }
}

/* The added mass as part of the nodes' mass, as in solid_added_mass_apply. */
static void carry(const struct solid *s, struct solid_contact_implicit *m) {
    const struct solid_added_mass *added = s->added;
    for (int k = 0; k < m->faces; k++) {
        struct face *f = &m->face[k];
        const struct node *node = &m->node[f->node];
        double *push = m->end[f->node].push;
        const int i = f->of;
        double carried = solid_density(s, node->particle), before = 0;
        for (int q = i - 1; q >= 0 && added->h[q] == node->particle; q--) carried += added->density[q];
        for (int c = 0; c < s->dim; c++) before += push[c] * added->normal[c][i];
        f->lost = before * added->density[i] / (carried + added->density[i]);
        for (int c = 0; c < s->dim; c++) push[c] -= f->lost * added->normal[c][i];
    }
}

/* The accelerations by contact if the nodes end at d. */
static void push(const struct solid *s, struct solid_contact *c) {
    struct solid_contact_implicit *m = c->implicit;
    const double least2 = LEAST2 * c->radius * c->radius;
    for (int k = 0; k < m->nodes; k++) memset(m->end[k].push, 0, sizeof m->end[k].push);
    for (int k = 0; k < m->pairs; k++) {
        const struct near *p = &m->pair[k];
        struct end *h = &m->end[p->h], *l = &m->end[p->l];
        double end[3] = {0}, end2 = 0;
        for (int i = 0; i < s->dim; i++) {
            end[i] = p->xi[i] + (h->d[i] - l->d[i]);
            end2 += end[i] * end[i];
        }
        if (p->depth <= 0 && end2 >= p->radius * p->radius) continue;
        const double depth = solid_repulsion_depth(end2 > least2 ? end2 : least2, p->radius);
        const double slope = solid_repulsion_slope(p->depth, p->potential, depth, p->radius, s->in.contact_exponent);
        for (int i = 0; i < s->dim; i++) {
            const double along = slope * (p->start[i] + end[i]);
            h->push[i] += solid_contact_list_rounded(p->on_h * along, c->quantum);
            if (p->is_own) l->push[i] -= solid_contact_list_rounded(p->on_l * along, c->quantum);
        }
    }
    carry(s, m);
}

/* Puts the owned nodes at d* + dt^2/2 a. */
static void place(struct solid *s, struct solid_contact_implicit *m, double half) {
    for (int k = 0; k < m->nodes; k++) {
        const struct node *node = &m->node[k];
        double *d = m->end[k].d;
        if (!node->is_own) continue;
        for (int i = 0; i < s->dim; i++) {
            if (!(node->held >> i & 1)) d[i] = node->predicted[i] + half * node->a[i];
            s->d[i][node->particle] = d[i];
        }
    }
}

/* Asks the owners of the other nodes where these are. Collective. */
static void ask(struct solid *s, struct solid_contact *c) {
    struct solid_contact_implicit *m = c->implicit;
    if (!m->across) return;
    par_ghost_update(s->ghost, s->dim, s->d, s->n);
    if (c->crossing.active) solid_contact_crossing_update(s, &c->crossing);
    for (int k = 0; k < m->nodes; k++) {
        const struct node *node = &m->node[k];
        if (node->is_own) continue;
        const int is_served = node->particle < 0,
                  at = is_served ? SOLID_CONTACT_SERVED_END - node->particle : node->particle;
        for (int i = 0; i < s->dim; i++) m->end[k].d[i] = (is_served ? c->crossing.d[i] : s->d[i])[at];
    }
}

/* NaN is larger than any number. */
static double larger(double a, double b) { return b > a || b != b ? b : a; }

enum { RESIDUAL, LARGEST, SEEN };

/* The largest component of the residual and of the acceleration, m/s2, over all ranks. */
static void measure(const struct solid *s, const struct solid_contact_implicit *m, double seen[SEEN]) {
    double residual = 0, largest = 0;
    for (int k = 0; k < m->nodes; k++) {
        const struct node *node = &m->node[k];
        const double *push = m->end[k].push;
        for (int i = 0; node->is_own && i < s->dim; i++) {
            if (node->held >> i & 1) continue;
            residual = larger(residual, fabs(push[i] - node->a[i]));
            largest = larger(largest, fabs(push[i]));
        }
    }
    seen[RESIDUAL] = residual;
    seen[LARGEST] = largest;
    par_max_array(seen, SEEN);
}

/* Solves a = C(d* + dt^2/2 a)/rho by Chebyshev's iteration; at the end d belongs to a, and a to d but for TOLERANCE.
 * If the residual grows, the contacts are stiffer than at the start and the iteration begins anew with a larger
 * bound. Returns the largest acceleration. */
static double solve(struct solid *s, struct solid_contact *c, double half, double beta) {
    struct solid_contact_implicit *m = c->implicit;
    double ratio = 0, least = INFINITY, seen[SEEN];
    for (int turn = 0;; turn++) {
        push(s, c);
        if (turn % LOOK == 0) measure(s, m, seen);
        if (turn % LOOK == 0 && !(seen[RESIDUAL] > fmax(TOLERANCE * seen[LARGEST], QUANTA * c->quantum))) break;
        if (turn == ITERATIONS_MAX) { /* the step has failed: it is made again with shorter substeps, or the run ends */
            for (int k = 0; k < m->nodes; k++) m->end[k].push[0] = NAN;
            break;
        }
        if (seen[RESIDUAL] > 4 * least) {
            beta *= 4;
            ratio = 0;
            least = seen[RESIDUAL];
        }
        least = fmin(least, seen[RESIDUAL]);
        /* the eigenvalues' mean and half of their spread */
        const double middle = 1 + 0.5 * beta, spread = fmax(0.5 * beta, 1e-3);
        const double next = ratio > 0 ? 1 / (2 * middle / spread - ratio) : spread / middle;
        for (int k = 0; k < m->nodes; k++) {
            struct node *node = &m->node[k];
            const double *push = m->end[k].push;
            for (int i = 0; i < s->dim; i++) {
                const double residual = push[i] - node->a[i];
                node->turn[i] = ratio > 0 ? next * (ratio * node->turn[i] + 2 / spread * residual) : residual / middle;
                node->a[i] += node->turn[i];
            }
        }
        ratio = next;
        place(s, m, half);
        ask(s, c);
    }
    for (int k = 0; k < m->nodes; k++) memcpy(m->node[k].a, m->end[k].push, sizeof m->node[k].a);
    place(s, m, half);
    return seen[LARGEST];
}

/* The velocities; the work of loads, added mass and constraints over the motion; the constraints' impulses. */
static void finish(struct solid *s, const struct solid_contact_implicit *m, double dt) {
    for (int k = 0; k < m->nodes; k++) {
        const struct node *node = &m->node[k];
        const double *d = m->end[k].d;
        if (!node->is_own) continue;
        const int h = node->particle;
        const double density = solid_density(s, h), mass = density * s->volume[h];
        double impulse[3] = {0};
        for (int i = 0; i < s->dim; i++) {
            impulse[i] = mass * dt * node->a[i];
            if (node->held >> i & 1) {
                s->e_constraint -= mass * node->a[i] * (d[i] - node->start[i]);
                continue;
            }
            s->v[i][h] += dt * node->a[i];
            s->work_load += s->volume[h] * (s->load[i][h] + density * s->in.body_force[i]) * 0.5 * dt * dt * node->a[i];
        }
        if (node->held && s->reactions) solid_reactions_give(s, h, impulse);
    }
    for (int k = 0; k < m->faces; k++) {
        const struct face *f = &m->face[k];
        const struct node *node = &m->node[f->node];
        double moved = 0;
        for (int i = 0; i < s->dim; i++) moved += (m->end[f->node].d[i] - node->start[i]) * s->added->normal[i][f->of];
        s->work_load -= s->volume[node->particle] * solid_density(s, node->particle) * f->lost * moved;
    }
}

/* One try with the pairs within reach; returns the largest acceleration. */
static double attempt(struct solid *s, struct solid_contact *c, double half) {
    struct solid_contact_implicit *m = c->implicit;
    double bound[2] = {0, 0};
    m->nodes = m->pairs = 0;
    for (int k = 0; k < c->ends->n; k++) m->node_of[k] = 0;
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) gather(s, c, kind);
    gather_faces(s, c);
    for (int k = 0; k < m->nodes; k++) {
        bound[0] = fmax(bound[0], largest_of(&m->node[k]));
        bound[1] = fmax(bound[1], !m->node[k].is_own);
    }
    par_max_array(bound, 2);
    m->across = bound[1] > 0;
    return bound[0] > 0 ? solve(s, c, half, 0.5 * half * bound[0]) : 0;
}

void solid_contact_implicit_end(struct solid *s, double dt) {
    struct solid_contact *c = s->contact;
    if (!c->any) return;
    struct solid_contact_implicit *m = c->implicit;
    clock_begin(CLOCK_CONTACT);
    const double half = 0.5 * dt * dt, skin = c->skin;
    par_ghost_update(s->ghost, s->dim, s->d, s->n);
    solid_contact_ends_update(s, c);
    const double way = 2 * longest_way(c->ends, m);
    double reach = REACH * c->radius;
    for (;;) {
        m->reach = fmin(way + reach, skin);
        const double moved = sqrt((double)s->dim) * half * attempt(s, c, half);
        /* pushed further than the pairs that were taken reach: others may be hit */
        if (2 * moved <= reach || reach >= skin) break;
        reach = fmax(2 * reach, 3 * moved);
    }
    finish(s, m, dt);
    clock_end(CLOCK_CONTACT);
}

/* The nodes of the last substep, NULL: none. */
static const struct solid_contact_implicit *moved(const struct solid *s) {
    return s->contact && s->contact->any && solid_contact_implicit_is(s) ? s->contact->implicit : NULL;
}

double solid_contact_implicit_push(const struct solid *s, int h, int c) {
    const struct solid_contact_implicit *m = moved(s);
    const int end = m ? s->contact->ends->of[h] - 1 : -1, k = end < 0 ? -1 : m->node_of[end] - 1;
    return k < 0 || m->node[k].held >> c & 1 ? 0 : m->node[k].a[c];
}

double solid_contact_implicit_along(const struct solid *s, double *const f[3], double *const g[3]) {
    const struct solid_contact_implicit *m = moved(s);
    double sum = 0;
    for (int k = 0; m && k < m->nodes; k++) {
        const struct node *node = &m->node[k];
        const int h = node->particle;
        for (int i = 0; node->is_own && i < s->dim; i++)
            if (!(node->held >> i & 1)) sum += solid_density(s, h) * s->volume[h] * (f[i][h] + g[i][h]) * node->a[i];
    }
    return sum;
}
