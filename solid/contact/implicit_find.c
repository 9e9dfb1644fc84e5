/* Finds the pairs that touch in a substep, and their particles. */
#include "base/memory.h"
#include "solid/contact/implicit_parts.h"
#include "solid/contact/pairs.h"
#include "solid/contact/repulsion.h"
#include "solid/contact/room.h"
#include "solid/imposed/added_mass.h"

#include <math.h>
#include <string.h>

void solid_contact_implicit_find_faces(const struct solid *s, struct solid_contact *c) {
    struct solid_contact_implicit *m = c->implicit;
    memset(m->face_of, 0, (size_t)c->ends->n * sizeof *m->face_of);
    for (int i = s->added ? s->added->n - 1 : -1; i >= 0; i--)
        if (c->ends->of[s->added->h[i]] > 0) m->face_of[c->ends->of[s->added->h[i]] - 1] = 1 + i;
}

/* Adds the faces of a node, if it can move. */
static void add_faces(const struct solid *s, struct solid_contact_implicit *m, int node) {
    const struct solid_contact_node *of = &m->node[node];
    if (m->face_of[of->end] == 0 || of->held == (1 << s->dim) - 1) return;
    const struct solid_added_mass *added = s->added;
    double carried = solid_density(s, of->particle);
    for (int i = m->face_of[of->end] - 1; i < added->n && added->h[i] == of->particle; i++) {
        m->face = solid_contact_room(m->face, &m->room_face, m->faces + 1, sizeof *m->face);
        struct solid_contact_face *f = &m->face[m->faces++];
        carried += added->density[i];
        *f = (struct solid_contact_face){.node = node, .share = added->density[i] / carried};
        for (int c = 0; c < s->dim; c++) f->normal[c] = added->normal[c][i];
    }
}

/* Room for node k in an array of the iterate; it and the next are 0. */
static solid_contact_row *room(solid_contact_row *of, int *capacity, int k) {
    of = solid_contact_room(of, capacity, k + 2, sizeof *of);
    memset(of[k], 0, 2 * sizeof *of);
    return of;
}

/* Returns the number of the end's node, which is added if it is new. */
static int add_node(const struct solid *s, const struct solid_contact *c, int end) {
    struct solid_contact_implicit *m = c->implicit;
    struct solid_contact_iterate *by = &m->by;
    if (m->node_of[end] > 0) return m->node_of[end] - 1;
    const int particle = c->ends->particle[end], k = m->nodes;
    m->node = solid_contact_room(m->node, &m->room_node, k + 1, sizeof *m->node);
    by->a = room(by->a, &by->room_a, k);
    by->turn = room(by->turn, &by->room_turn, k);
    by->now = room(by->now, &by->room_now, k);
    by->push = room(by->push, &by->room_push, k);
    by->predicted = room(by->predicted, &by->room_predicted, k);
    by->moves = room(by->moves, &by->room_moves, k);
    struct solid_contact_node *node = &m->node[k];
    *node = (struct solid_contact_node){.end = end, .particle = particle, .is_own = particle >= 0 && particle < s->n};
    if (node->is_own) node->held = s->flag[particle] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z);
    for (int i = 0; i < s->dim; i++) {
        by->moves[k][i] = node->is_own && !(node->held >> i & 1);
        by->predicted[k][i] = by->now[k][i] = m->now[end][i];
    }
    add_faces(s, m, k);
    m->node_of[end] = ++m->nodes;
    return k;
}

/* Adds a pair's stiffness where it is nearest, at r. */
static void stiffen(struct solid_contact_implicit *m, const struct solid_contact_one *p, double r) {
    const double exponent = m->law.exponent, ratio = fmin(fmax(p->radius / r, 1), 1e3),
                 quantum = m->law.quantum / p->radius;
    const double slope = 2 * exponent * (exponent == 1 ? ratio * ratio : pow(ratio, exponent + 1)) / p->radius;
    const double *x = p->start;
    const double part = slope / fmax(x[0] * x[0] + x[1] * x[1] + x[2] * x[2], m->law.least2);
    const double along[6] = {x[0] * x[0], x[1] * x[1], x[2] * x[2], x[0] * x[1], x[0] * x[2], x[1] * x[2]};
    struct solid_contact_node *h = &m->node[p->h], *l = &m->node[p->l];
    for (int i = 0; i < 6; i++) {
        h->stiffness[i] += solid_contact_list_rounded(part * along[i] * p->on_h, quantum);
        l->stiffness[i] += solid_contact_list_rounded(part * along[i] * p->on_l, quantum);
    }
}

/* The largest eigenvalue of the nodes' stiffness. Its norm is not below it, so few nodes need more than that. */
static void find_stiffest(struct solid_contact_implicit *m) {
    for (int k = 0; k < m->nodes; k++) {
        const double *t = m->node[k].stiffness;
        const double norm2 = t[0] * t[0] + t[1] * t[1] + t[2] * t[2] + 2 * (t[3] * t[3] + t[4] * t[4] + t[5] * t[5]);
        if (norm2 * (1 + 1e-9) > m->stiffest * m->stiffest)
            m->stiffest = fmax(m->stiffest, solid_contact_rate_largest(t));
    }
}

/* Takes pair k among those that touch, if it does so at the beginning or at the end. */
static void take(const struct solid *s, struct solid_contact *c, int kind, int k) {
    struct solid_contact_implicit *m = c->implicit;
    const struct solid_contact_pairs *listed = &c->pairs[kind];
    const struct solid_contact_constants *of = &c->ends->of_pair[kind][k];
    struct solid_contact_one p = {
        .radius = of->radius, .on_h = of->on_h, .on_l = kind == SOLID_CONTACT_OWNED ? of->on_l : 0};
    const int h = c->ends->h[kind][k], l = c->ends->l[kind][k];
    double start2 = 0, end2 = 0;
    for (int i = 0; i < s->dim; i++) {
        p.xi[i] = listed->xi[i][k];
        p.start[i] = p.xi[i] + (m->start[h][i] - m->start[l][i]);
        const double end = p.xi[i] + (m->now[h][i] - m->now[l][i]);
        start2 += p.start[i] * p.start[i];
        end2 += end * end;
    }
    start2 = fmax(start2, m->law.least2);
    end2 = fmax(end2, m->law.least2);
    if (fmin(start2, end2) >= p.radius * p.radius) return;
    m->taken[kind][k / VEC_LANES] |= (uint8_t)(1u << k % VEC_LANES);
    p.depth = solid_repulsion_depth(start2, p.radius);
    p.h = add_node(s, c, h);
    p.l = add_node(s, c, l);
    stiffen(m, &p, sqrt(fmin(start2, end2)));
    solid_contact_touching_add(&m->touching, &p);
}

/* Squares of the distances of the listed pairs from .. from + VEC_LANES - 1 with the displacements d, m2. */
static vec distance2(const struct solid_contact_pairs *p, solid_contact_row *d, const int *h, const int *l, int from) {
    vec of_h[4], of_l[4], sum = vec_set(0);
    vec_shuffle_gather4(d[0], 4, h + from, of_h);
    vec_shuffle_gather4(d[0], 4, l + from, of_l);
    for (int i = 0; i < p->dim; i++) {
        const vec x = vec_load(p->xi[i] + from) + (of_h[i] - of_l[i]);
        sum += x * x;
    }
    return sum;
}

/* Takes the listed pairs that touch at the end, if is_first also those that touch at the beginning, and then lists
 * those that are close. */
static void find(const struct solid *s, struct solid_contact *c, int kind, int is_first) {
    struct solid_contact_implicit *m = c->implicit;
    const struct solid_contact_pairs *p = &c->pairs[kind];
    const double near = (1 + SOLID_CONTACT_NEAR) * c->radius, close = (1 + SOLID_CONTACT_CLOSE) * c->radius;
    if (is_first && kind == SOLID_CONTACT_OWNED)
        m->close = solid_contact_room(m->close, &m->room_close, p->n, sizeof *m->close);
    for (int from = 0; from < p->n; from += VEC_LANES) {
        const unsigned all = vec_first(p->n - from);
        vec least2 = distance2(p, m->now, c->ends->h[kind], c->ends->l[kind], from);
        if (is_first) least2 = vec_min(least2, distance2(p, m->start, c->ends->h[kind], c->ends->l[kind], from));
        if (kind != SOLID_CONTACT_OWNED && all & vec_signs(least2 - near * near)) m->across = 1;
        unsigned touch = all & vec_signs(least2 - c->radius * c->radius) & ~(unsigned)m->taken[kind][from / VEC_LANES];
        for (; touch; touch &= touch - 1) take(s, c, kind, from + __builtin_ctz(touch));
        if (!is_first || kind != SOLID_CONTACT_OWNED) continue;
        unsigned nearly = all & vec_signs(least2 - close * close) & ~(unsigned)m->taken[kind][from / VEC_LANES];
        for (; nearly; nearly &= nearly - 1) m->close[m->closes++] = from + __builtin_ctz(nearly);
    }
}

/* The same among the pairs that are close. */
static void find_close(const struct solid *s, struct solid_contact *c) {
    const struct solid_contact_implicit *m = c->implicit;
    const struct solid_contact_pairs *p = &c->pairs[SOLID_CONTACT_OWNED];
    const int *h = c->ends->h[SOLID_CONTACT_OWNED], *l = c->ends->l[SOLID_CONTACT_OWNED];
    for (int n = 0; n < m->closes; n++) {
        const int k = m->close[n];
        double end2 = 0;
        for (int i = 0; i < s->dim; i++) {
            const double x = p->xi[i][k] + (m->now[h[k]][i] - m->now[l[k]][i]);
            end2 += x * x;
        }
        if (end2 < c->radius * c->radius && !(m->taken[SOLID_CONTACT_OWNED][k / VEC_LANES] >> k % VEC_LANES & 1))
            take(s, c, SOLID_CONTACT_OWNED, k);
    }
}

/* Tells the ends where their nodes are. Returns whether pairs that touch now must have been close in the first
 * search. */
static int spread(const struct solid *s, const struct solid_contact *c) {
    const struct solid_contact_implicit *m = c->implicit;
    vec most = vec_set(0);
    for (int n = 0; n < 4 * m->nodes; n += VEC_LANES)
        most = vec_absmax(most, vec_load((double *)m->by.now + n) - vec_load((double *)m->by.predicted + n));
    for (int k = 0; k < m->nodes; k++) memcpy(m->now[m->node[k].end], m->by.now[k], sizeof *m->now);
    return 2 * sqrt((double)s->dim) * vec_highest(most) <= SOLID_CONTACT_CLOSE * c->radius;
}

void solid_contact_implicit_find(const struct solid *s, struct solid_contact *c, int is_first) {
    struct solid_contact_implicit *m = c->implicit;
    const int before = m->touching.pairs, is_close = !is_first && spread(s, c);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) {
        if (is_close && kind == SOLID_CONTACT_OWNED)
            find_close(s, c);
        else
            find(s, c, kind, is_first);
    }
    if (m->touching.pairs > before) find_stiffest(m);
}
