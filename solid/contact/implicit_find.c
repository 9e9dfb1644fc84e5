/* Finds the pairs that touch in a substep, and their particles. */
#include "base/vec_shuffle.h"
#include "solid/contact/implicit_parts.h"
#include "solid/contact/pairs.h"
#include "solid/contact/reserve.h"
#include "solid/imposed/added_mass.h"

#include <math.h>
#include <string.h>

void solid_contact_implicit_find_faces(const struct solid *s, struct solid_contact *c) {
    struct solid_contact_implicit *m = c->implicit;
    memset(m->face_of, 0, (size_t)c->ends->n * sizeof *m->face_of);
    for (int i = s->added ? s->added->n - 1 : -1; i >= 0; i--)
        if (c->ends->end_of[s->added->h[i]] > 0) m->face_of[c->ends->end_of[s->added->h[i]] - 1] = 1 + i;
}

/* Adds the faces of a node, if it can move. */
static void add_faces(const struct solid *s, struct solid_contact_implicit *m, int node) {
    const struct solid_contact_node *own = &m->node[node];
    if (m->face_of[own->end] == 0 || own->held == (1 << s->dim) - 1) return;
    const struct solid_added_mass *added = s->added;
    double carried = solid_density(s, own->particle);
    for (int i = m->face_of[own->end] - 1; i < added->n && added->h[i] == own->particle; i++) {
        m->face = solid_contact_reserve(m->face, &m->face_capacity, m->faces + 1, sizeof *m->face);
        struct solid_contact_face *f = &m->face[m->faces++];
        carried += added->density[i];
        *f = (struct solid_contact_face){.node = node, .share = added->density[i] / carried};
        for (int c = 0; c < s->dim; c++) f->normal[c] = added->normal[c][i];
    }
}

/* Room for the nodes of a vec of pairs more, and for the row of zeros behind them. */
static void reserve(struct solid_contact_implicit *m) {
    struct solid_contact_iterate *by = &m->by;
    solid_contact_row **const rows[] = {&by->a, &by->turn, &by->now, &by->push, &by->predicted, &by->moves};
    const int n = m->nodes + 2 * VEC_LANES + 1;
    if (n <= m->nodes_capacity) return;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        int capacity = m->nodes_capacity;
        *rows[i] = solid_contact_reserve(*rows[i], &capacity, n, sizeof **rows[i]);
    }
    m->node = solid_contact_reserve(m->node, &m->nodes_capacity, n, sizeof *m->node);
}

/* Sets the row behind the last node to 0. */
static void fill_up(struct solid_contact_implicit *m) {
    const struct solid_contact_iterate *by = &m->by;
    solid_contact_row *const rows[] = {by->a, by->turn, by->now, by->push, by->predicted, by->moves};
    for (size_t i = 0; i < sizeof rows / sizeof *rows && m->nodes > 0; i++)
        memset(rows[i][m->nodes], 0, sizeof *rows[i]);
}

/* Returns the number of the end's node, which is added if it is new. */
static int add_node(const struct solid *s, const struct solid_contact *c, int end) {
    struct solid_contact_implicit *m = c->implicit;
    const struct solid_contact_iterate *by = &m->by;
    if (m->node_of[end] > 0) return m->node_of[end] - 1;
    const int particle = c->ends->particle[end], k = m->nodes++;
    m->node_of[end] = m->nodes;
    struct solid_contact_node *node = &m->node[k];
    *node = (struct solid_contact_node){.end = end, .particle = particle, .is_own = particle >= 0 && particle < s->n};
    if (node->is_own) node->held = s->flag[particle] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z);
    memset(by->a[k], 0, sizeof *by->a);
    memset(by->turn[k], 0, sizeof *by->turn);
    memset(by->push[k], 0, sizeof *by->push);
    memset(by->moves[k], 0, sizeof *by->moves);
    for (int i = 0; i < s->dim; i++) by->moves[k][i] = node->is_own && !(node->held >> i & 1);
    memcpy(by->predicted[k], m->motion[end].now, sizeof *by->predicted);
    memcpy(by->now[k], m->motion[end].now, sizeof *by->now);
    if (m->face_of[end] > 0) add_faces(s, m, k);
    return k;
}

/* The ends of `pairs` pairs, and the pairs' stiffness xx, yy, zz, xy, xz, yz in each of a vec's lanes, 1/s2. */
struct stiffness {
    int pairs, h[VEC_LANES], l[VEC_LANES], lane[VEC_LANES];
    double on_h[6][VEC_LANES], on_l[6][VEC_LANES];
};

/* The pairs' stiffness where they are nearest, at r. */
static void stiffness_of(const struct solid_contact_law *law, const struct solid_contact_lanes *p, vec r,
                         struct stiffness *stiffness) {
    const vec ratio = vec_min(vec_max(p->radius / r, vec_set(1)), vec_set(1e3)), quantum = law->quantum / p->radius;
    vec power = ratio * ratio;
    for (int k = 0; k < VEC_LANES && law->exponent != 1; k++) power[k] = pow(ratio[k], law->exponent + 1);
    const vec *x = p->start, x2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    const vec part = 2 * law->exponent * power / (p->radius * vec_max(x2, vec_set(law->least2)));
    const vec along[6] = {x[0] * x[0], x[1] * x[1], x[2] * x[2], x[0] * x[1], x[0] * x[2], x[1] * x[2]};
    for (int i = 0; i < 6; i++) {
        vec_store(stiffness->on_h[i], solid_contact_list_rounded_vec(part * along[i] * p->on_h, quantum));
        vec_store(stiffness->on_l[i], solid_contact_list_rounded_vec(part * along[i] * p->on_l, quantum));
    }
}

static void stiffen(struct solid_contact_implicit *m, const struct stiffness *by) {
    for (int n = 0; n < by->pairs; n++) {
        double *h = m->node[by->h[n]].stiffness, *l = m->node[by->l[n]].stiffness;
        for (int i = 0; i < 6; i++) {
            h[i] += by->on_h[i][by->lane[n]];
            l[i] += by->on_l[i][by->lane[n]];
        }
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

/* X_h - X_l of the listed pairs from .. from + VEC_LANES - 1 at the beginning or at the end of the substep, m. Returns
 * its square, m2. */
static vec distance2(const struct solid_contact *c, int kind, int from, int at_end, vec x[3]) {
    const struct solid_contact_pairs *p = &c->pairs[kind];
    const struct solid_contact_motion *motion = c->implicit->motion;
    vec between[4], sum = vec_set(0);
    vec_shuffle_between4(at_end ? motion->now : motion->start, sizeof *motion / sizeof(double), c->ends->h[kind] + from,
                         c->ends->l[kind] + from, between);
    x[2] = vec_set(0);
    for (int i = 0; i < p->dim; i++) {
        x[i] = vec_load(p->xi[i] + from) + between[i];
        sum += x[i] * x[i];
    }
    return sum;
}

/* Takes those of the listed pairs from .. from + VEC_LANES - 1 whose bit is set and that touch at the beginning or at
 * the end, with X_h - X_l at the beginning, and the squares of the distances then and at the end, m2. */
static void take(const struct solid *s, struct solid_contact *c, int kind, int from, unsigned which, const vec start[3],
                 vec start2, vec end2) {
    struct solid_contact_implicit *m = c->implicit;
    const struct solid_contact_pairs *p = &c->pairs[kind];
    const struct solid_contact_constants *constants = &c->ends->of_pair[kind];
    const int *h = c->ends->h[kind], *l = c->ends->l[kind];
    struct solid_contact_lanes some = {.xi[2] = vec_set(0),
                                       .start = {start[0], start[1], start[2]},
                                       .radius = vec_load(constants->radius + from),
                                       .on_h = vec_load(constants->on_h + from),
                                       .on_l = vec_load(constants->on_l + from)};
    const vec least2 = vec_set(m->law.least2), nearest2 = vec_max(vec_min(start2, end2), least2);
    which &= vec_signs(nearest2 - some.radius * some.radius);
    if (!which) return;
    start2 = vec_max(start2, least2);
    m->taken[kind][from / VEC_LANES] |= (uint8_t)which;
    for (int i = 0; i < p->dim; i++) some.xi[i] = vec_load(p->xi[i] + from);
    some.depth = (some.radius * some.radius - start2) / (some.radius * (some.radius + vec_sqrt(start2)));
    struct stiffness stiffness = {.pairs = 0};
    stiffness_of(&m->law, &some, vec_sqrt(nearest2), &stiffness);
    reserve(m);
    for (unsigned left = which; left; left &= left - 1) {
        const int lane = __builtin_ctz(left), n = stiffness.pairs++;
        stiffness.lane[n] = lane;
        stiffness.h[n] = add_node(s, c, h[from + lane]);
        stiffness.l[n] = add_node(s, c, l[from + lane]);
    }
    stiffen(m, &stiffness);
    solid_contact_touching_add(&m->touching, &some, which, stiffness.h, stiffness.l);
}

/* Adds the listed pairs that touch at the beginning or at the end, and marks those that are close. */
static void find(const struct solid *s, struct solid_contact *c, int kind) {
    struct solid_contact_implicit *m = c->implicit;
    const int n = c->pairs[kind].n;
    const double near = (1 + SOLID_CONTACT_NEAR) * c->radius, close = (1 + SOLID_CONTACT_CLOSE) * c->radius;
    vec start[3], end[3];
    for (int from = 0; from < n; from += VEC_LANES) {
        const unsigned all = vec_first(n - from);
        const vec start2 = distance2(c, kind, from, 0, start), end2 = distance2(c, kind, from, 1, end),
                  least2 = vec_min(start2, end2);
        const unsigned touch = all & vec_signs(least2 - c->radius * c->radius);
        if (touch) take(s, c, kind, from, touch, start, start2, end2);
        if (kind == SOLID_CONTACT_OWNED)
            m->close[from / VEC_LANES] = (uint8_t)(all & vec_signs(least2 - close * close));
        else if (all & vec_signs(least2 - near * near))
            m->across = 1;
    }
}

/* Adds the pairs that touch at the end and are not in the list yet. only_close: only close pairs are tested. */
static void find_again(const struct solid *s, struct solid_contact *c, int kind, int only_close) {
    struct solid_contact_implicit *m = c->implicit;
    const int n = c->pairs[kind].n;
    const double near = (1 + SOLID_CONTACT_NEAR) * c->radius;
    vec x[3];
    for (int from = 0; from < n; from += VEC_LANES) {
        unsigned left = vec_first(n - from) & ~(unsigned)m->taken[kind][from / VEC_LANES];
        if (only_close) left &= m->close[from / VEC_LANES];
        if (!left) continue;
        const vec end2 = distance2(c, kind, from, 1, x);
        if (kind != SOLID_CONTACT_OWNED && left & vec_signs(end2 - near * near)) m->across = 1;
        left &= vec_signs(end2 - c->radius * c->radius);
        if (!left) continue;
        const vec start2 = distance2(c, kind, from, 0, x);
        take(s, c, kind, from, left, x, start2, end2);
    }
}

/* Tells the ends where their nodes are. Returns whether pairs that touch now must have been close in the first
 * search. */
static int spread(const struct solid *s, const struct solid_contact *c) {
    const struct solid_contact_implicit *m = c->implicit;
    vec most = vec_set(0);
    for (int n = 0; n < 4 * m->nodes; n += VEC_LANES)
        most = vec_absmax(most, vec_load((double *)m->by.now + n) - vec_load((double *)m->by.predicted + n));
    for (int k = 0; k < m->nodes; k++) memcpy(m->motion[m->node[k].end].now, m->by.now[k], sizeof *m->by.now);
    return 2 * sqrt((double)s->dim) * vec_highest(most) <= SOLID_CONTACT_CLOSE * c->radius;
}

void solid_contact_implicit_find(const struct solid *s, struct solid_contact *c, int is_first) {
    struct solid_contact_implicit *m = c->implicit;
    const int before = m->touching.pairs, is_close = !is_first && spread(s, c);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) {
        if (is_first)
            find(s, c, kind);
        else
            find_again(s, c, kind, is_close && kind == SOLID_CONTACT_OWNED);
    }
    fill_up(m);
    solid_contact_touching_fill_up(&m->touching);
    if (m->touching.pairs > before) find_stiffest(m);
}
