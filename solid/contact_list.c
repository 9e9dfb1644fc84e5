#include "solid/contact_list.h"

#include "base/memory.h"
#include "base/par.h"
#include "base/par_exchange.h"
#include "solid/contact_cells.h"
#include "solid/family.h"
#include "solid/surface_lost.h"
#include "solid/surface_sector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void solid_contact_pairs_add(struct solid_contact_pairs *pairs, int h, int l) {
    if (pairs->n == pairs->capacity) {
        pairs->capacity = 2 * pairs->capacity + 256;
        pairs->h = realloc(pairs->h, (size_t)pairs->capacity * sizeof *pairs->h);
        pairs->l = realloc(pairs->l, (size_t)pairs->capacity * sizeof *pairs->l);
        ENSURE(pairs->h && pairs->l, "no memory for %d pairs", pairs->capacity);
    }
    pairs->h[pairs->n] = h;
    pairs->l[pairs->n++] = l;
}

double solid_contact_stiffness_of(const struct solid *s, int body) {
    return solid_micromodulus(&s->in.material[s->in.body[body].material], s->in.spacing);
}

/* Shortest difference across periodic sides. */
static double shortest(const struct solid *s, int c, double x) {
    return s->in.periodic[c] ? x - s->in.length[c] * rint(x / s->in.length[c]) : x;
}

static double distance2(const struct solid *s, const double a[3], const double b[3]) {
    double r2 = 0;
    for (int c = 0; c < 3; c++) {
        const double x = shortest(s, c, a[c] - b[c]);
        r2 += x * x;
    }
    return r2;
}

/* Broken bonds of h whose ends are near each other now. */
static void add_broken(const struct solid *s, struct solid_contact *c, int h) {
    struct solid_family_view view;
    const double near = c->radius + c->skin;
    solid_family_view(s, h, &view);
    for (int b = 0; b < view.n; b++) {
        if (view.intact[b]) continue;
        double zeta[3];
        solid_relative(s, h, view.l[b], zeta);
        if (zeta[0] * zeta[0] + zeta[1] * zeta[1] + zeta[2] * zeta[2] < near * near)
            solid_contact_pairs_add(&c->broken, h, view.l[b]);
    }
}

void solid_contact_list_broken(struct solid *s, struct solid_contact *c) {
    struct solid_contact_pairs *p = &c->broken;
    const int found = solid_lost_find(c->lost, s);
    if (!found) return;
    for (int k = 0; k < found; k++) c->again[c->lost->h[k]] = 1;
    int kept = 0;
    for (int k = 0; k < p->n; k++) {
        if (c->again[p->h[k]]) continue;
        p->h[kept] = p->h[k];
        p->l[kept++] = p->l[k];
    }
    p->n = kept;
    for (int k = 0; k < found; k++) {
        add_broken(s, c, c->lost->h[k]);
        c->again[c->lost->h[k]] = 0;
    }
}

static struct solid_contact_other describe(const struct solid *s, const struct solid_contact *c, int h) {
    struct solid_contact_other o = {.volume = s->volume[h],
                                    .c0 = solid_contact_stiffness_of(s, s->body[h]),
                                    .id = (long)c->id[h],
                                    .body = s->body[h]};
    for (int k = 0; k < 3; k++) {
        o.x0[k] = s->x0[k][h];
        o.x[k] = s->x0[k][h] + s->d[k][h];
    }
    return o;
}

/* Whether the two are of one family, broken or not. Families are within a body; on a lattice |xi| < delta + spacing/2. */
static int is_family(const struct solid *s, const struct solid_contact *c, int h,
                     const struct solid_contact_other *o) {
    if (o->body != s->body[h]) return 0;
    const struct solid_body *body = &s->in.body[o->body];
    if (body->shape != SOLID_POINTS) {
        const double x0[3] = {s->x0[0][h], s->x0[1][h], s->x0[2][h]};
        const double reach = (s->in.material[body->material].horizon_ratio + 0.5) * s->in.spacing;
        return distance2(s, x0, o->x0) < reach * reach * (1 - 1e-9);
    }
    struct solid_family_view view;
    solid_family_view(s, h, &view);
    for (int b = 0; b < view.n; b++)
        if ((long)c->id[view.l[b]] == o->id) return 1;
    return 0;
}

/* Whether x, or an image of it, lies within reach of the box low[3], high[3]. */
static int is_near_box(const struct solid *s, const double x[3], const double box[6], double reach) {
    for (int c = 0; c < 3; c++) {
        const double half = 0.5 * (box[3 + c] - box[c]);
        if (!(half >= 0)) return 0; /* nobody there */
        if (fabs(shortest(s, c, x[c] - (box[c] + half))) > half + reach &&
            !(s->in.periodic[c] && 2 * half + 2 * reach > s->in.length[c]))
            return 0;
    }
    return 1;
}

/* Our candidates near another rank's: sent_h, and the rank for each in dest (malloc'ed). */
static int *choose_sent(const struct solid *s, struct solid_contact *c, int n, const int *h,
                        const double (*x)[3]) {
    const int size = par_size();
    double box[6] = {INFINITY, INFINITY, INFINITY, -INFINITY, -INFINITY, -INFINITY};
    double(*boxes)[6] = malloc((size_t)size * sizeof *boxes);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++) {
            box[k] = fmin(box[k], x[i][k]);
            box[3 + k] = fmax(box[3 + k], x[i][k]);
        }
    par_all_gather(box, sizeof box, boxes);
    int *dest = NULL, capacity = 0;
    c->sent = 0;
    for (int i = 0; i < n; i++)
        for (int r = 0; r < size; r++) {
            if (r == par_rank() || !is_near_box(s, x[i], boxes[r], c->radius + c->skin)) continue;
            if (c->sent == c->sent_capacity) {
                c->sent_capacity = 2 * c->sent_capacity + 256;
                c->sent_h = realloc(c->sent_h, (size_t)c->sent_capacity * sizeof *c->sent_h);
            }
            if (c->sent == capacity) {
                capacity = 2 * capacity + 256;
                dest = realloc(dest, (size_t)capacity * sizeof *dest);
            }
            ENSURE(c->sent_h && dest, "no memory for %d particles of contact", capacity);
            dest[c->sent] = r;
            c->sent_h[c->sent++] = h[i];
        }
    free(boxes);
    return dest;
}

/* Plans the exchange of the sent particles and receives what others sent. */
static void plan(struct solid *s, struct solid_contact *c, const int *dest) {
    par_exchange_free(c->exchange);
    c->exchange = par_exchange_new(c->sent, dest);
    c->served = par_exchange_count(c->exchange);
    struct solid_contact_other *mine = malloc(((size_t)c->sent + 1) * sizeof *mine);
    for (int k = 0; k < c->sent; k++) mine[k] = describe(s, c, c->sent_h[k]);
    c->other = realloc(c->other, ((size_t)c->served + 1) * sizeof *c->other);
    c->other_x = realloc(c->other_x, ((size_t)c->served + 1) * sizeof *c->other_x);
    c->sent_x = realloc(c->sent_x, ((size_t)c->sent + 1) * sizeof *c->sent_x);
    ENSURE(mine && c->other && c->other_x && c->sent_x, "no memory for %d particles of contact", c->served);
    par_exchange_forward(c->exchange, mine, c->other, sizeof *mine);
    free(mine);
}

/* Leaves out of the exchange what no pair of the other rank needs. */
static void prune(struct solid *s, struct solid_contact *c, int *dest) {
    uint8_t *used = calloc((size_t)c->served + 1, 1), *wanted = calloc((size_t)c->sent + 1, 1);
    for (int k = 0; k < c->strangers.n; k++)
        if (c->strangers.l[k] >= s->n) used[c->strangers.l[k] - s->n] = 1;
    par_exchange_backward(c->exchange, used, wanted, 1);
    int kept = 0, place = 0;
    for (int k = 0; k < c->sent; k++)
        if (wanted[k]) {
            c->sent_h[kept] = c->sent_h[k];
            dest[kept++] = dest[k];
        }
    c->sent = kept;
    int *at = malloc(((size_t)c->served + 1) * sizeof *at);
    ENSURE(used && wanted && at, "no memory for %d particles of contact", c->served);
    for (int k = 0; k < c->served; k++) at[k] = used[k] ? place++ : -1;
    for (int k = 0; k < c->strangers.n; k++)
        if (c->strangers.l[k] >= s->n) c->strangers.l[k] = s->n + at[c->strangers.l[k] - s->n];
    free(at);
    free(used);
    free(wanted);
    plan(s, c, dest);
}

/* Near pairs that never were of one family, among n candidates here and those served from other ranks. */
static void seek(struct solid *s, struct solid_contact *c, int n, const int *h, double (*x)[3]) {
    const double near = c->radius + c->skin;
    struct solid_cells cells;
    int *found = memory_new(MEMORY_SOLID, (size_t)(n + c->served) + 1, sizeof *found);
    for (int k = 0; k < c->served; k++) memcpy(x[n + k], c->other[k].x, sizeof x[0]);
    solid_cells_new(&cells, n + c->served, (const double(*)[3])x, near, s->in.periodic, s->in.length);
    c->strangers.n = 0;
    for (int i = 0; i < n; i++) {
        const int number = solid_cells_near(&cells, x[i], found);
        for (int k = 0; k < number; k++) {
            const int j = found[k];
            if (j == i || !(distance2(s, x[i], x[j]) < near * near)) continue;
            const struct solid_contact_other o = j < n ? describe(s, c, h[j]) : c->other[j - n];
            if (!is_family(s, c, h[i], &o))
                solid_contact_pairs_add(&c->strangers, h[i], j < n ? h[j] : s->n + j - n);
        }
    }
    solid_cells_free(&cells);
    memory_free(found);
}

void solid_contact_list(struct solid *s, struct solid_contact *c) {
    int n = 0;
    int *h = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *h);
    for (int i = 0; i < s->n; i++)
        if (solid_contact_is_candidate(s, i)) h[n++] = i;
    double(*x)[3] = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *x);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++) x[i][k] = s->x0[k][h[i]] + s->d[k][h[i]];
    int *dest = choose_sent(s, c, n, h, (const double(*)[3])x);
    plan(s, c, dest);
    double(*all)[3] = memory_new(MEMORY_SOLID, (size_t)(n + c->served) + 1, sizeof *all);
    memcpy(all, x, (size_t)n * sizeof *all);
    seek(s, c, n, h, all);
    prune(s, c, dest);
    free(dest);
    memory_free(all);
    memory_free(x);
    memory_free(h);

    c->broken.n = 0;
    for (int i = 0; i < s->n; i++) {
        for (int k = 0; k < 3; k++) c->built[k][i] = s->d[k][i];
        if (!(s->flag[i] & SOLID_BROKEN)) continue;
        add_broken(s, c, i);
    }
    solid_lost_find(c->lost, s);
    c->crossing = par_sum_long(c->served) > 0;
}
