/* The particles that may touch in a substep, and their accelerations by contact. */
#include "solid/contact/near.h"
#include "base/memory.h"
#include "solid/contact/pairs.h"
#include "solid/contact/repulsion.h"
#include "solid/contact/room.h"
#include "solid/imposed/added_mass.h"

/* Pairs add to the bound of the stiffness up to this distance beyond r_c, in r_c. */
static const double ABOUT = 0.005;
/* The square of the least distance of two particles, over r_c^2, as in struct solid_contact_touch. */
static const double LEAST2 = 1e-12;

void solid_near_free(struct solid_near *m) {
    void *const list[] = {m->start,      m->node_of, m->end,  m->node, m->a,    m->has_moved, m->has_turn,
                          m->may_differ, m->held,    m->pair, m->of,   m->face, m->serve,     m->ask};
    for (size_t k = 0; k < sizeof list / sizeof list[0]; k++) memory_free(list[k]);
    solid_contact_remote_free(&m->remote);
}

static int is_own(const struct solid *s, const struct solid_contact_end *e) {
    return e->particle >= 0 && e->particle < s->n;
}

void solid_near_begin(const struct solid *s, struct solid_contact *c, struct solid_near *m) {
    solid_contact_ends_list(s, c);
    solid_contact_remote_renew(s, c, &m->remote);
    const int n = c->ends->n, before = m->node_of ? m->room_of : 0;
    m->start = solid_contact_room(m->start, &m->room_start, n, sizeof *m->start);
    m->node_of = solid_contact_room(m->node_of, &m->room_of, n, sizeof *m->node_of);
    m->serve = solid_contact_room(m->serve, &m->room_serve, m->remote.served, sizeof *m->serve);
    m->ask = solid_contact_room(m->ask, &m->room_ask, m->remote.asked, sizeof *m->ask);
    if (m->room_of > before) memset(m->node_of + before, 0, (size_t)(m->room_of - before) * sizeof *m->node_of);
    for (int k = 0; k < n; k++)
        if (is_own(s, &c->ends->end[k]))
            for (int i = 0; i < s->dim; i++) m->start[k][i] = s->d[i][c->ends->end[k].particle];
}

void solid_near_predict(const struct solid *s, struct solid_contact *c, struct solid_near *m) {
    m->nodes = m->pairs = 0;
    for (int k = 0; k < c->ends->n; k++) {
        struct solid_contact_end *e = &c->ends->end[k];
        if (is_own(s, e))
            for (int i = 0; i < s->dim; i++) e->d[i] = s->d[i][e->particle];
    }
}

/* The node of an end of contact's, which is added if it is new. */
static int node_of(const struct solid *s, struct solid_near *m, const struct solid_contact_ends *t, int k) {
    if (m->node_of[k] > 0) return m->node_of[k] - 1;
    const struct solid_contact_end *e = &t->end[k];
    m->node = solid_contact_room(m->node, &m->room_node, m->nodes + 1, sizeof *m->node);
    m->end = solid_contact_room(m->end, &m->room_end, m->nodes + 1, sizeof *m->end);
    m->a = solid_contact_room(m->a, &m->room_a, m->nodes + 1, sizeof *m->a);
    memset(m->a[m->nodes], 0, sizeof *m->a);
    struct solid_near_node *node = &m->node[m->nodes];
    *node = (struct solid_near_node){.particle = e->particle, .is_own = is_own(s, e), .end = k};
    if (node->is_own) node->held = s->flag[e->particle] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z);
    memcpy(m->end[m->nodes].d, e->d, sizeof e->d);
    memcpy(node->predicted, e->d, sizeof node->predicted);
    for (int i = 0; i < s->dim; i++) node->start[i] = m->start[k][i];
    m->held = solid_contact_room(m->held, &m->room_held, m->nodes + 1, 1);
    m->held[m->nodes] = node->is_own ? node->held : SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z;
    m->node_of[k] = ++m->nodes;
    return m->nodes - 1;
}

/* The longest way of a particle in contact's lists from its start to its present place, m. */
static double longest_way(const struct solid *s, const struct solid_contact_ends *t, const struct solid_near *m) {
    double most = 0;
    for (int k = 0; k < t->n; k++) {
        double way2 = 0;
        for (int i = 0; i < s->dim; i++) way2 += (t->end[k].d[i] - m->start[k][i]) * (t->end[k].d[i] - m->start[k][i]);
        most = way2 > most ? way2 : most;
    }
    return sqrt(most);
}

/* Adds a pair's stiffness where it is nearest, with the margin of a pair that is about to touch. */
static void stiffen(struct solid_near *m, const struct solid_near_pair *p, const int of[2], double nearest2,
                    double exponent, double quantum) {
    const double part = fmin(p->radius / sqrt(nearest2), 1e3);
    const double slope = exponent * (exponent == 1 ? part * part : pow(part, exponent + 1)) / p->radius;
    const double *x = p->start, inverse = 2 * slope / (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    const double along[TENSOR] = {x[0] * x[0], x[1] * x[1], x[2] * x[2], x[0] * x[1], x[0] * x[2], x[1] * x[2]};
    quantum /= p->radius;
    for (int i = 0; i < TENSOR; i++) {
        m->node[of[0]].stiffness[i] += solid_contact_list_rounded(inverse * along[i] * p->on_h, quantum);
        m->node[of[1]].stiffness[i] += solid_contact_list_rounded(inverse * along[i] * p->on_l, quantum);
    }
}

/* Adds a pair if it is near. */
static void pair_add(const struct solid *s, struct solid_contact *c, struct solid_near *m, int kind, int k,
                     double reach) {
    const struct solid_contact_ends *t = c->ends;
    const double *of_h = m->start[t->h[kind][k]], *of_l = m->start[t->l[kind][k]];
    const struct solid_contact_touch touch = solid_contact_pairs_touch_of(s, c, kind, k);
    struct solid_near_pair q = {.is_own = kind == SOLID_CONTACT_OWNED, .radius = touch.radius};
    double start2 = 0;
    for (int i = 0; i < s->dim; i++) {
        q.xi[i] = c->pairs[kind].xi[i][k];
        q.start[i] = q.xi[i] + (of_h[i] - of_l[i]);
        start2 += q.start[i] * q.start[i];
    }
    start2 = fmax(start2, LEAST2 * c->radius * c->radius);
    if (start2 >= touch.radius * touch.radius && touch.r >= touch.radius + reach) return;
    q.on_h = touch.k * touch.l->volume / c->density[touch.h->material];
    q.on_l = touch.k * touch.h->volume / c->density[touch.l->material];
    q.depth = solid_repulsion_depth(start2, touch.radius);
    q.potential = solid_repulsion_potential(q.depth, touch.radius, s->in.contact_exponent);
    int *of = m->of[m->pairs];
    of[0] = node_of(s, m, t, t->h[kind][k]);
    of[1] = node_of(s, m, t, t->l[kind][k]);
    const double nearest2 = fmin(start2, touch.r * touch.r), about = (1 + ABOUT) * touch.radius;
    if (nearest2 < about * about) stiffen(m, &q, of, nearest2, s->in.contact_exponent, c->quantum);
    m->pair[m->pairs++] = q;
}

/* Faces with added mass at the nodes that can move; the ones of one particle stay adjacent. */
static void gather_faces(const struct solid *s, const struct solid_contact *c, struct solid_near *m) {
    const int is_fixed = (1 << s->dim) - 1;
    m->faces = 0;
    for (int i = 0; s->added && m->nodes > 0 && i < s->added->n; i++) {
        const int end = c->ends->of[s->added->h[i]] - 1;
        if (end < 0 || m->node_of[end] == 0 || m->node[m->node_of[end] - 1].held == is_fixed) continue;
        m->face = solid_contact_room(m->face, &m->room_face, m->faces + 1, sizeof *m->face);
        m->face[m->faces++] = (struct solid_near_face){.of = i, .node = m->node_of[end] - 1};
    }
}

/* The ends' displacements to and from the other ranks, with those at the beginning. Collective. */
static void meet(const struct solid *s, struct solid_contact *c, struct solid_near *m) {
    struct solid_contact_remote *r = &m->remote;
    const int dim = s->dim;
    for (int k = 0; k < m->nodes; k++) memcpy(c->ends->end[m->node[k].end].d, m->end[k].d, sizeof m->end[k].d);
    for (int k = 0; k < r->served; k++) {
        memcpy(r->out + 2 * dim * k, c->ends->end[r->serve[k]].d, (size_t)dim * sizeof *r->out);
        memcpy(r->out + 2 * dim * k + dim, m->start[r->serve[k]], (size_t)dim * sizeof *r->out);
    }
    solid_contact_remote_update(r, 2 * dim);
    for (int k = 0; k < r->asked; k++) {
        memcpy(c->ends->end[r->ask[k]].d, r->in + 2 * dim * k, (size_t)dim * sizeof *r->in);
        memcpy(m->start[r->ask[k]], r->in + 2 * dim * k + dim, (size_t)dim * sizeof *r->in);
    }
    for (int k = 0; k < m->nodes; k++) memcpy(m->end[k].d, c->ends->end[m->node[k].end].d, sizeof m->end[k].d);
}

void solid_near_gather(struct solid *s, struct solid_contact *c, struct solid_near *m, double reach) {
    int found[SOLID_CONTACT_BLOCK];
    meet(s, c, m);
    const double way = 2 * longest_way(s, c->ends, m), search = fmin(c->radius + reach + way, c->radius + c->skin);
    m->pairs = 0;
    for (int k = 0; k < m->nodes; k++) {
        m->node_of[m->node[k].end] = 1 + k;
        memset(m->node[k].stiffness, 0, sizeof m->node[k].stiffness);
    }
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++)
        for (int from = 0; from < c->pairs[kind].n; from += SOLID_CONTACT_BLOCK) {
            const int n = solid_contact_pairs_touching(c, kind, from, search, found);
            m->pair = solid_contact_room(m->pair, &m->room_pair, m->pairs + n, sizeof *m->pair);
            m->of = solid_contact_room(m->of, &m->room_nodes, m->pairs + n, sizeof *m->of);
            for (int j = 0; j < n; j++) pair_add(s, c, m, kind, found[j], reach);
        }
    gather_faces(s, c, m);
    for (int k = 0; k < m->nodes; k++) memset(m->end[k].sum, 0, sizeof m->end[k].sum);
    m->has_moved = solid_contact_room(m->has_moved, &m->room_moved, m->nodes, 1);
    m->may_differ = solid_contact_room(m->may_differ, &m->room_differ, m->nodes, 1);
    m->has_turn = solid_contact_room(m->has_turn, &m->room_turn, m->nodes, 1);
    if (m->nodes > 0) memset(m->has_moved, 1, (size_t)m->nodes);
    if (m->nodes > 0) memset(m->has_turn, 0, (size_t)m->nodes);
    for (int k = 0; k < m->remote.served; k++) m->serve[k] = m->node_of[m->remote.serve[k]] - 1;
    for (int k = 0; k < m->remote.asked; k++) m->ask[k] = m->node_of[m->remote.ask[k]] - 1;
    for (int k = 0; k < m->nodes; k++) m->node_of[m->node[k].end] = 0;
}

void solid_near_ask(const struct solid *s, const struct solid_contact *c, struct solid_near *m) {
    struct solid_contact_remote *r = &m->remote;
    const size_t bytes = (size_t)s->dim * sizeof(double);
    for (int k = 0; k < r->served; k++)
        memcpy(r->out + s->dim * k, m->serve[k] < 0 ? c->ends->end[r->serve[k]].d : m->end[m->serve[k]].d, bytes);
    solid_contact_remote_update(r, s->dim);
    for (int k = 0; k < r->asked; k++)
        if (m->ask[k] >= 0 && memcmp(m->end[m->ask[k]].d, r->in + s->dim * k, bytes) != 0) {
            memcpy(m->end[m->ask[k]].d, r->in + s->dim * k, bytes);
            m->has_moved[m->ask[k]] = 1;
        }
}

/* The added mass as part of the nodes' mass, as in solid_added_mass_apply. */
static void carry(const struct solid *s, struct solid_near *m) {
    const struct solid_added_mass *added = s->added;
    for (int k = 0; k < m->nodes && m->faces > 0; k++) memcpy(m->node[k].push, m->end[k].sum, sizeof m->node[k].push);
    for (int k = 0; k < m->faces; k++) {
        struct solid_near_face *f = &m->face[k];
        struct solid_near_node *node = &m->node[f->node];
        const int i = f->of;
        double carried = solid_density(s, node->particle), before = 0;
        for (int q = i - 1; q >= 0 && added->h[q] == node->particle; q--) carried += added->density[q];
        for (int c = 0; c < s->dim; c++) before += node->push[c] * added->normal[c][i];
        f->lost = before * added->density[i] / (carried + added->density[i]);
        for (int c = 0; c < s->dim; c++) node->push[c] -= f->lost * added->normal[c][i];
    }
}

/* -(phi_1 - phi_0)/(r_1^2 - r_0^2) of a pair that ends at a distance, 1/m; 0: it does not touch. */
static inline double slope_of(const struct solid_near_pair *p, double end2, double least2,
                              const struct solid_repulsion_series *of) {
    if (p->depth <= 0 && end2 >= p->radius * p->radius) return 0;
    const double depth = solid_repulsion_depth(end2 > least2 ? end2 : least2, p->radius);
    return solid_repulsion_slope(p->depth, p->potential, depth, p->radius, of);
}

void solid_near_push(const struct solid *s, const struct solid_contact *c, struct solid_near *m) {
    const double least2 = LEAST2 * c->radius * c->radius;
    const struct solid_repulsion_series series = solid_repulsion_series_of(s->in.contact_exponent);
    if (m->nodes > 0) memcpy(m->may_differ, m->has_moved, (size_t)m->nodes);
    for (int k = 0; k < m->pairs; k++) {
        struct solid_near_pair *p = &m->pair[k];
        struct solid_near_end *h = &m->end[m->of[k][0]], *l = &m->end[m->of[k][1]];
        double end[3] = {0}, end2 = 0;
        if (!(m->has_moved[m->of[k][0]] | m->has_moved[m->of[k][1]])) continue;
        for (int i = 0; i < s->dim; i++) {
            end[i] = p->xi[i] + (h->d[i] - l->d[i]);
            end2 += end[i] * end[i];
        }
        m->may_differ[m->of[k][0]] = m->may_differ[m->of[k][1]] = 1;
        const double slope = slope_of(p, end2, least2, &series);
        for (int i = 0; i < s->dim; i++) {
            const double along = slope * (p->start[i] + end[i]);
            const double on_h = solid_contact_list_rounded(p->on_h * along, c->quantum),
                         on_l = solid_contact_list_rounded(-p->on_l * along, c->quantum);
            h->sum[i] += on_h - p->push_h[i];
            if (p->is_own) l->sum[i] += on_l - p->push_l[i];
            p->push_h[i] = on_h;
            p->push_l[i] = on_l;
        }
    }
    if (m->nodes > 0) memset(m->has_moved, 0, (size_t)m->nodes);
    carry(s, m);
}
