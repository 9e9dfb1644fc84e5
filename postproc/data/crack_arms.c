/* Finds the arms of cracks among damaged particles, and their forks. */
#include "postproc/data/crack_arms.h"
#include "base/memory.h"
#include "base/sets.h"
#include "postproc/data/crack_arm.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* In spacings: neighbours along axes and diagonals; neighbours across a gap of two particles; width of a band; least
 * length of an arm; the farthest that the meeting point of a fork's arms is from where particles part them. */
static const double TOUCH = 1.8, NEAR = 3.1, BAND = 2, LEAST = 5, FORK = 15;

struct edge {
    long a, b;
    double length;
};

/* A connected part of a band. */
struct node {
    long parent, first, next;        /* nodes, -1: none; its children are first, and their next */
    double near, far, deepest, x[2]; /* least, largest distance; the largest of its subtree, m; centre, m */
    long n;
    int alone, arm;
};

struct work {
    const struct postproc_arms_input *in;
    long *order, edges, capacity, *start, *other, *band, *node_of, *before, nodes, *union_parent;
    struct edge *edge;
    double *length, *d; /* [2 edges]; [n] distance from the beginning, m */
    struct node *node;
    struct postproc_arms *out;
    int arm_capacity, fork_capacity;
};

static void *list_of(long n, size_t size) { return memory_new(MEMORY_OUTPUT, (size_t)n + 1, size); }

static double distance(const double a[2], const double b[2]) { return hypot(a[0] - b[0], a[1] - b[1]); }

static const double (*sorted_x)[2];
static int by_x(const void *a, const void *b) {
    const double *p = sorted_x[*(const long *)a], *q = sorted_x[*(const long *)b];
    const int k = p[0] == q[0];
    return (p[k] > q[k]) - (p[k] < q[k]);
}

static int by_length(const void *a, const void *b) {
    const struct edge *p = a, *q = b;
    if (p->length != q->length) return p->length < q->length ? -1 : 1;
    return p->a != q->a ? (p->a > q->a) - (p->a < q->a) : (p->b > q->b) - (p->b < q->b);
}

static void edge_add(struct work *w, long a, long b, double length) {
    MEMORY_MORE(MEMORY_OUTPUT, w->edge, w->edges, w->capacity);
    w->edge[w->edges++] = (struct edge){a, b, length};
}

/* Joins neighbours; then, across gaps, pairs of parts that are not connected yet, the nearest first. */
static void join(struct work *w) {
    const struct postproc_arms_input *in = w->in;
    const double touch = TOUCH * in->spacing, near = NEAR * in->spacing;
    sorted_x = in->x;
    for (long i = 0; i < in->n; i++) w->order[i] = w->union_parent[i] = i;
    qsort(w->order, (size_t)in->n, sizeof *w->order, by_x);
    for (long p = 0, from = 0; p < in->n; p++) {
        const long i = w->order[p];
        while (in->x[i][0] - in->x[w->order[from]][0] > near) from++;
        for (long q = from; q < p; q++) {
            const double length = distance(in->x[i], in->x[w->order[q]]);
            if (length <= near) edge_add(w, w->order[q], i, length);
        }
    }
    if (w->edges > 0) qsort(w->edge, (size_t)w->edges, sizeof *w->edge, by_length);
    long kept = 0;
    for (long e = 0; e < w->edges; e++) {
        const long a = sets_root(w->union_parent, w->edge[e].a), b = sets_root(w->union_parent, w->edge[e].b);
        if (a == b && w->edge[e].length > touch) continue;
        w->union_parent[a > b ? a : b] = a > b ? b : a;
        w->edge[kept++] = w->edge[e];
    }
    w->edges = kept;
}

/* The joints of each particle, one list after another. */
static void list_joints(struct work *w) {
    const long n = w->in->n;
    w->start = list_of(n + 2, sizeof *w->start);
    w->other = list_of(2 * w->edges, sizeof *w->other);
    w->length = list_of(2 * w->edges, sizeof *w->length);
    for (long e = 0; e < w->edges; e++) w->start[w->edge[e].a + 2]++, w->start[w->edge[e].b + 2]++;
    for (long i = 2; i < n + 2; i++) w->start[i] += w->start[i - 1];
    for (long e = 0; e < w->edges; e++) {
        const struct edge g = w->edge[e];
        long at = w->start[g.a + 1]++;
        w->other[at] = g.b, w->length[at] = g.length;
        at = w->start[g.b + 1]++;
        w->other[at] = g.a, w->length[at] = g.length;
    }
}

/* A heap of particles by distance, the nearest on top; entries that are out of date are skipped. */
struct waiting {
    double d;
    long i;
};
static void heap_push(struct waiting *heap, long *n, struct waiting e) {
    long at = (*n)++;
    for (; at > 0 && heap[(at - 1) / 2].d > e.d; at = (at - 1) / 2) heap[at] = heap[(at - 1) / 2];
    heap[at] = e;
}
static struct waiting heap_pop(struct waiting *heap, long *n) {
    const struct waiting top = heap[0], e = heap[--*n];
    long at = 0;
    for (long k = 1; k < *n; k = 2 * at + 1) {
        if (k + 1 < *n && heap[k + 1].d < heap[k].d) k++;
        if (heap[k].d >= e.d) break;
        heap[at] = heap[k];
        at = k;
    }
    heap[at] = e;
    return top;
}

/* Distances along the joints (Dijkstra 1959) from the initial particles; in a part without any, from the one that was
 * damaged first. */
static void measure(struct work *w) {
    const struct postproc_arms_input *in = w->in;
    struct waiting *heap = list_of(2 * w->edges + in->n, sizeof *heap);
    long *earliest = list_of(in->n, sizeof *earliest), waiting = 0;
    for (long i = 0; i < in->n; i++) {
        w->d[i] = INFINITY;
        w->before[i] = earliest[i] = -1;
    }
    for (long i = 0; i < in->n; i++) {
        long *first = &earliest[sets_root(w->union_parent, i)];
        if (*first < 0 || in->initial[i] > in->initial[*first] ||
            (in->initial[i] == in->initial[*first] && in->t[i] < in->t[*first]))
            *first = i;
    }
    for (long i = 0; i < in->n; i++)
        if (in->initial[i] || earliest[sets_root(w->union_parent, i)] == i) {
            w->d[i] = 0;
            heap_push(heap, &waiting, (struct waiting){0, i});
        }
    while (waiting > 0) {
        const struct waiting e = heap_pop(heap, &waiting);
        if (e.d > w->d[e.i]) continue;
        for (long k = w->start[e.i]; k < w->start[e.i + 1]; k++) {
            const double d = e.d + w->length[k];
            if (d >= w->d[w->other[k]]) continue;
            w->d[w->other[k]] = d;
            w->before[w->other[k]] = e.i;
            heap_push(heap, &waiting, (struct waiting){d, w->other[k]});
        }
    }
    for (long i = 0; i < in->n; i++) {
        const long first = earliest[sets_root(w->union_parent, i)];
        w->band[i] = in->initial[i] ? -1 : (long)(w->d[i] / (BAND * in->spacing));
        w->node_of[i] = in->initial[first] ? 0 : 1; /* until the nodes are made: 1: alone */
    }
    MEMORY_FREE(earliest, heap);
}

/* Connected parts of the bands, and which one each comes from: that of the particle before its nearest one. */
static void make_nodes(struct work *w) {
    const struct postproc_arms_input *in = w->in;
    long *nearest = list_of(in->n, sizeof *nearest), *number = list_of(in->n, sizeof *number);
    for (long i = 0; i < in->n; i++) w->union_parent[i] = i;
    for (long e = 0; e < w->edges; e++) {
        if (w->band[w->edge[e].a] != w->band[w->edge[e].b]) continue;
        const long a = sets_root(w->union_parent, w->edge[e].a), b = sets_root(w->union_parent, w->edge[e].b);
        w->union_parent[a > b ? a : b] = a > b ? b : a;
    }
    for (long i = 0; i < in->n; i++) number[i] = -1;
    for (long i = 0; i < in->n; i++) {
        const long r = sets_root(w->union_parent, i);
        const int alone = (int)w->node_of[i];
        w->node_of[i] = -1;
        if (w->band[i] < 0) continue;
        if (number[r] < 0) {
            nearest[w->nodes] = i;
            w->node[w->nodes] =
                (struct node){.parent = -1, .first = -1, .next = -1, .near = INFINITY, .alone = alone, .arm = -1};
            number[r] = w->nodes++;
        }
        struct node *k = &w->node[w->node_of[i] = number[r]];
        if (w->d[i] < k->near) nearest[w->node_of[i]] = i;
        k->near = fmin(k->near, w->d[i]);
        k->far = k->deepest = fmax(k->far, w->d[i]);
        for (int c = 0; c < 2; c++) k->x[c] += (in->x[i][c] - k->x[c]) / (double)(k->n + 1);
        k->n++;
    }
    for (long k = 0; k < w->nodes; k++) {
        const long from = w->before[nearest[k]];
        if (from < 0 || w->node_of[from] < 0) continue;
        struct node *parent = &w->node[w->node[k].parent = w->node_of[from]];
        w->node[k].next = parent->first;
        parent->first = k;
    }
    /* A node's parent begins nearer: climb from each node. */
    for (long k = 0; k < w->nodes; k++)
        for (long p = w->node[k].parent; p >= 0 && w->node[p].deepest < w->node[k].far; p = w->node[p].parent)
            w->node[p].deepest = w->node[k].far;
    MEMORY_FREE(number, nearest);
}

static int arm_new(struct work *w, int parent, int alone) {
    struct postproc_arms *o = w->out;
    MEMORY_MORE(MEMORY_OUTPUT, o->arm, o->arms, w->arm_capacity);
    o->arm[o->arms] = (struct postproc_arm){.parent = parent, .alone = alone, .speed = NAN, .top = NAN, .top_t = NAN};
    return o->arms++;
}

/* Whether what begins with a node goes on far enough beyond a distance to be an arm. */
static int is_arm(const struct work *w, long k, double from) {
    return w->node[k].deepest - from >= LEAST * w->in->spacing;
}

/* Gives a node and what follows it to an arm, until it forks; then begins the arms of the fork. */
static void follow(struct work *w, long k, int arm) {
    struct postproc_arms *o = w->out;
    for (;;) {
        long deepest = -1;
        int branches = 0;
        w->node[k].arm = arm;
        for (long c = w->node[k].first; c >= 0; c = w->node[c].next) {
            branches += is_arm(w, c, w->node[k].far);
            if (deepest < 0 || w->node[c].deepest > w->node[deepest].deepest) deepest = c;
        }
        if (deepest < 0) return;
        if (branches < 2) {
            k = deepest;
            continue;
        }
        MEMORY_MORE(MEMORY_OUTPUT, o->fork, o->forks, w->fork_capacity);
        const int fork = o->forks++;
        /* the node's centre is where the arms part, until their lines say where they meet */
        o->fork[fork] =
            (struct postproc_fork){arm, branches, o->arms, {w->node[k].x[0], w->node[k].x[1]}, NAN, NAN, NAN};
        const int first = o->arms;
        for (int b = 0; b < branches; b++) arm_new(w, arm, w->node[k].alone);
        int b = first;
        for (long c = w->node[k].first; c >= 0; c = w->node[c].next)
            if (is_arm(w, c, w->node[k].far)) follow(w, c, b++);
        return;
    }
}

static void make_arms(struct work *w) {
    for (long k = 0; k < w->nodes; k++) {
        if (w->node[k].parent >= 0 || w->node[k].arm >= 0) continue;
        if (!w->node[k].alone) {
            if (is_arm(w, k, 0)) follow(w, k, arm_new(w, -1, 0));
            continue;
        }
        /* a crack without an initial one grows from a place in its middle to all sides */
        for (long c = w->node[k].first; c >= 0; c = w->node[c].next)
            if (is_arm(w, c, 0)) follow(w, c, arm_new(w, -1, 1));
    }
}

/* Where the lines of a fork's outermost arms meet, when the tip was there, and the angle between them. */
static void finish_fork(struct postproc_fork *f, const struct postproc_arms *o, const struct postproc_arms_input *in) {
    int one = f->first, two = f->first;
    const double ahead = o->arm[f->arm].last.value;
    double left = -INFINITY, right = INFINITY;
    for (int b = f->first; b < f->first + f->arms; b++) {
        const double turn = remainder(o->arm[b].first.value - ahead, 360);
        if (turn > left) left = turn, one = b;
        if (turn < right) right = turn, two = b;
    }
    const struct postproc_arm *a = &o->arm[one], *b = &o->arm[two];
    f->angle = fabs(left - right);
    f->error = hypot(a->first.error, b->first.error);
    const double u[2] = {cos(a->first.value * M_PI / 180), sin(a->first.value * M_PI / 180)};
    const double v[2] = {cos(b->first.value * M_PI / 180), sin(b->first.value * M_PI / 180)};
    const double cross = u[0] * v[1] - u[1] * v[0];
    const double s = ((b->middle[0] - a->middle[0]) * v[1] - (b->middle[1] - a->middle[1]) * v[0]) / cross;
    const double x[2] = {a->middle[0] + s * u[0], a->middle[1] + s * u[1]};
    if (fabs(cross) > 0.1 && distance(x, f->place) < FORK * in->spacing) memcpy(f->place, x, sizeof x);
    const struct postproc_arm *stem = &o->arm[f->arm];
    double nearest = INFINITY;
    for (long k = stem->first_place; k < stem->first_place + stem->places; k++) {
        const double away = distance(o->place[k].x, f->place);
        if (away < nearest) nearest = away, f->t = o->place[k].t;
    }
}

static void describe(struct work *w) {
    const struct postproc_arms_input *in = w->in;
    struct postproc_arms *o = w->out;
    long *start = list_of(o->arms + 2, sizeof *start);
    struct postproc_crack_member *m = list_of(in->n, sizeof *m);
    o->place = list_of(in->n, sizeof *o->place);
    for (long i = 0; i < in->n; i++)
        if (w->node_of[i] >= 0 && w->node[w->node_of[i]].arm >= 0) start[w->node[w->node_of[i]].arm + 2]++;
    for (int a = 2; a < o->arms + 2; a++) start[a] += start[a - 1];
    for (long i = 0; i < in->n; i++)
        if (w->node_of[i] >= 0 && w->node[w->node_of[i]].arm >= 0)
            m[start[w->node[w->node_of[i]].arm + 1]++] =
                (struct postproc_crack_member){w->d[i], in->t[i], {in->x[i][0], in->x[i][1]}};
    for (int a = 0; a < o->arms; a++) {
        struct postproc_crack_member *members = m + start[a];
        const long n = start[a + 1] - start[a];
        postproc_crack_arm_line(&o->arm[a], members, n, in);
        o->arm[a].t_begin = o->arm[a].t_end = NAN;
        o->arm[a].first_place = o->places;
        postproc_crack_arm_tip(&o->arm[a], members, n, in, o->place + o->places);
        o->places += o->arm[a].places;
    }
    for (int f = 0; f < o->forks; f++) finish_fork(&o->fork[f], o, in);
    MEMORY_FREE(m, start);
}

double postproc_crack_arms_grain(const struct postproc_arms_input *in) { return in->spacing / in->window; }

struct postproc_arms *postproc_crack_arms_of(const struct postproc_arms_input *in) {
    struct work w = {.in = in, .out = memory_new(MEMORY_OUTPUT, 1, sizeof *w.out)};
    w.order = list_of(in->n, sizeof *w.order);
    w.union_parent = list_of(in->n, sizeof *w.union_parent);
    w.d = list_of(in->n, sizeof *w.d);
    w.before = list_of(in->n, sizeof *w.before);
    w.band = list_of(in->n, sizeof *w.band);
    w.node_of = list_of(in->n, sizeof *w.node_of);
    w.node = list_of(in->n, sizeof *w.node);
    join(&w);
    list_joints(&w);
    measure(&w);
    make_nodes(&w);
    make_arms(&w);
    describe(&w);
    MEMORY_FREE(w.order, w.union_parent, w.d, w.before, w.band, w.node_of, w.node, w.edge, w.start, w.other, w.length);
    return w.out;
}

void postproc_crack_arms_free(struct postproc_arms *a) {
    if (!a) return;
    MEMORY_FREE(a->arm, a->fork, a->place, a);
}
