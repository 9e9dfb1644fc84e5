/* Lists non-bonded pairs: near particles that never shared a bond, also on different ranks. */
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "solid/bonds/interface.h"
#include "solid/bonds/family.h"
#include "solid/bonds/store.h"
#include "solid/contact/cells.h"
#include "solid/contact/list.h"
#include "solid/contact/pairs.h"
#include "solid/contact/reserve.h"

#include <math.h>
#include <string.h>

/* Which particles of a body may touch a particle that they never shared a bond with: its search candidates. */
struct criterion {
    double rest[3];   /* mean displacement of the body, 0 if a part of it is held, m */
    double distance2; /* square of the displacement relative to rest from which on a particle may touch a non-bonded one
                       * of its own body, m2 */
    int bodies;       /* number of other bodies within reach */
    uint8_t body[SOLID_CONTACT_BODIES];
};

/* Lowest and negated highest position, m. */
struct box {
    double at[6];
};

struct solid_contact_nonbonded {
    double *id;                  /* [n + n_ghost] global ids */
    struct criterion *criterion; /* [bodies] */
    double (*mean)[4];           /* [bodies] displacement m; particles */
    struct box (*boxes)[2];      /* [ranks] bounds of its exposed particles, and of its candidates */
    uint8_t *is_candidate;       /* [s->n] 1: a search candidate */
    struct solid_cells cells;
    /* points: exposed particles near a candidate; owned ones, then contact ghosts */
    int points, capacity[3];
    int *point;     /* [points] particle, or s->n + k: the k-th contact ghost */
    double (*x)[3]; /* [points] m */
    int *found;     /* [points] work */
};

struct solid_contact_nonbonded *solid_contact_nonbonded_new(const struct solid *s) {
    struct solid_contact_nonbonded *t = memory_new(MEMORY_SOLID, 1, sizeof *t);
    const size_t bodies = (size_t)s->in.bodies;
    t->id = memory_new(MEMORY_SOLID, (size_t)(s->n + s->n_ghost) + 1, sizeof *t->id);
    t->criterion = memory_new(MEMORY_SOLID, bodies, sizeof *t->criterion);
    t->mean = memory_new(MEMORY_SOLID, bodies, sizeof *t->mean);
    t->boxes = memory_new(MEMORY_SOLID, (size_t)par_size(), sizeof *t->boxes);
    t->is_candidate = memory_new(MEMORY_SOLID, (size_t)s->n + 1, 1);
    for (int h = 0; h < s->n; h++) t->id[h] = (double)(s->first[par_rank()] + h);
    par_ghost_update(s->ghost, 1, &t->id, s->n);
    return t;
}

void solid_contact_nonbonded_free(struct solid_contact_nonbonded *t) {
    if (!t) return;
    MEMORY_FREE(t->id, t->criterion, t->mean, t->boxes, t->is_candidate, t->point, t->x, t->found);
    solid_contact_cells_free(&t->cells);
    memory_free(t);
}

/* The longest distance of a listed pair, m. */
static double farthest(const struct solid_contact *c) { return solid_contact_list_reach(c, c->has_fast, c->has_fast); }

/* Sets the criteria for search candidates. Collective. */
static void set_criteria(const struct solid *s, const struct solid_contact *c, struct solid_contact_nonbonded *t) {
    const double near = c->radius + c->skin;
    memset(t->mean, 0, (size_t)s->in.bodies * sizeof *t->mean);
    for (int h = 0; h < s->n; h++) {
        double *mean = t->mean[s->body[h]];
        for (int k = 0; k < s->dim; k++) mean[k] += s->d[k][h];
        mean[3]++;
    }
    par_sum_array(&t->mean[0][0], 4 * s->in.bodies);
    for (int b = 0; b < s->in.bodies; b++) {
        struct criterion *m = &t->criterion[b];
        const double distance = fmax(0.5 * (solid_contact_bounds_least_unbonded(s, b) - near), 0);
        const int is_held = c->bounds[b][13] == 0;
        for (int k = 0; k < 3; k++) m->rest[k] = is_held ? 0 : t->mean[b][k] / fmax(t->mean[b][3], 1);
        m->distance2 = distance * distance;
        m->bodies = 0;
        for (int other = 0; other < s->in.bodies; other++)
            if (other != b && solid_contact_bounds_near(s, c->bounds[b], c->bounds[other], farthest(c)))
                m->body[m->bodies++] = (uint8_t)other;
    }
}

/* Whether x, or a periodic image of it, lies within reach of the box. */
static int is_near_box(const struct solid *s, const double x[3], const double box[6], double reach) {
    for (int c = 0; c < 3; c++) {
        const double half = 0.5 * (-box[3 + c] - box[c]);
        if (!(half >= 0)) return 0; /* an empty box */
        if (fabs(solid_shortest(s, c, x[c] - (box[c] + half))) > half + reach &&
            !(s->in.periodic[c] && 2 * half + 2 * reach > s->in.length[c]))
            return 0;
    }
    return 1;
}

static void box_add(struct box *box, const double x[3]) {
    for (int k = 0; k < 3; k++) {
        box->at[k] = fmin(box->at[k], x[k]);
        box->at[3 + k] = fmin(box->at[3 + k], -x[k]);
    }
}

static int may_meet(const struct solid *s, const struct solid_contact *c, const struct criterion *m, int h,
                    const double x[3]) {
    double distance2 = 0;
    if (c->is_fast[h]) return 1;
    for (int k = 0; k < s->dim; k++) distance2 += (s->d[k][h] - m->rest[k]) * (s->d[k][h] - m->rest[k]);
    if (distance2 >= m->distance2) return 1;
    for (int k = 0; k < m->bodies; k++)
        if (is_near_box(s, x, c->bounds[m->body[k]], c->radius + c->skin)) return 1;
    return 0;
}

/* Only particles on the interface and those with a broken bond are searched. */
static int is_exposed(const struct solid *s, int h) { return (s->flag[h] & (SOLID_INTERFACE | SOLID_BROKEN)) != 0; }

/* Finds the search candidates, and gathers all ranks' boxes. Returns whether any rank has candidates. Collective. */
static int find_candidates(const struct solid *s, const struct solid_contact *c, struct solid_contact_nonbonded *t) {
    struct box local[2];
    for (int k = 0; k < 6; k++) local[0].at[k] = local[1].at[k] = INFINITY;
    for (int h = 0; h < s->n; h++) {
        double x[3];
        t->is_candidate[h] = 0;
        if (!is_exposed(s, h)) continue;
        solid_position(s, h, x);
        box_add(&local[0], x);
        if (!may_meet(s, c, &t->criterion[s->body[h]], h, x)) continue;
        t->is_candidate[h] = 1;
        box_add(&local[1], x);
    }
    par_all_gather(local, sizeof local, t->boxes);
    for (int r = 0; r < par_size(); r++)
        if (isfinite(t->boxes[r][1].at[0])) return 1;
    return 0;
}

static void point_add(struct solid_contact_nonbonded *t, int point, const double x[3]) {
    const int n = t->points + 1;
    t->point = solid_contact_reserve(t->point, &t->capacity[0], n, sizeof *t->point);
    t->x = solid_contact_reserve(t->x, &t->capacity[1], n, sizeof *t->x);
    t->point[t->points] = point;
    memcpy(t->x[t->points++], x, sizeof *t->x);
}

/* Collects the exposed particles near candidates of any rank: the points here, and the particles that another rank
 * needs as contact ghosts. */
static void gather(const struct solid *s, struct solid_contact *c, struct solid_contact_nonbonded *t) {
    const double near = farthest(c);
    t->points = 0;
    c->ghosts.sent = 0;
    for (int h = 0; h < s->n; h++) {
        double x[3];
        int is_point = t->is_candidate[h];
        if (!is_exposed(s, h)) continue;
        solid_position(s, h, x);
        for (int r = 0; r < par_size(); r++) {
            const int near_candidates = is_near_box(s, x, t->boxes[r][1].at, near);
            is_point |= near_candidates;
            if (r == par_rank() ||
                !(near_candidates || (t->is_candidate[h] && is_near_box(s, x, t->boxes[r][0].at, near))))
                continue;
            const struct solid_contact_ghost it = {.x0 = {s->x0[0][h], s->x0[1][h], s->dim > 2 ? s->x0[2][h] : 0},
                                                   .x = {x[0], x[1], x[2]},
                                                   .volume = s->volume[h],
                                                   .id = (long)t->id[h],
                                                   .body = s->body[h],
                                                   .material = (short)solid_particle_material(s, h),
                                                   .is_candidate = t->is_candidate[h],
                                                   .is_fast = c->is_fast[h]};
            solid_contact_ghosts_send(&c->ghosts, h, r, &it);
        }
        if (is_point) point_add(t, h, x);
    }
    solid_contact_ghosts_begin(&c->ghosts);
    for (int k = 0; k < c->ghosts.served; k++) point_add(t, s->n + k, c->ghosts.other[k].x);
    t->found = solid_contact_reserve(t->found, &t->capacity[2], t->points, sizeof *t->found);
}

/* Whether particle h and another one (its body, x0 and global id) share a bond, broken or not. */
static int is_family(const struct solid *s, const struct solid_contact_nonbonded *t, int h, int body,
                     const double x0[3], long id) {
    if (body != s->body[h] && !solid_interface_joins(&s->in, body, s->body[h])) return 0;
    if (s->family->lattice[body]) {
        const double reach = solid_contact_bounds_least_unbonded(s, body);
        double r2 = 0;
        for (int c = 0; c < 3; c++) {
            const double x = solid_shortest(s, c, s->x0[c][h] - x0[c]);
            r2 += x * x;
        }
        return r2 < reach * reach * (1 - 1e-9);
    }
    struct solid_family_view view;
    solid_family_view(s, h, &view);
    for (int b = 0; b < view.n; b++)
        if ((long)t->id[view.l[b]] == id) return 1;
    return 0;
}

static int is_fast(const struct solid *s, const struct solid_contact *c, int point) {
    return point < s->n ? c->is_fast[point] : c->ghosts.other[point - s->n].is_fast;
}

/* Lists points i and j, at least one of them owned, if they are near and share no bond. */
static void pair_add(const struct solid *s, struct solid_contact *c, const struct solid_contact_nonbonded *t, int i,
                     int j) {
    const int h = t->point[i], l = t->point[j], is_served = l >= s->n;
    const double near = solid_contact_list_reach(c, is_fast(s, c, h), is_fast(s, c, l));
    double x0[3], xi[3], r2 = 0;
    for (int k = 0; k < s->dim; k++) {
        x0[k] = is_served ? c->ghosts.other[l - s->n].x0[k] : s->x0[k][l];
        const double between = solid_contact_list_initial_offset(s, s->x0[k][h], x0[k]);
        const double x = t->x[i][k] - t->x[j][k], nearest = solid_shortest(s, k, x);
        xi[k] = between - (x - nearest);
        r2 += nearest * nearest;
    }
    if (!(r2 < near * near)) return;
    const int body = is_served ? c->ghosts.other[l - s->n].body : s->body[l];
    const long id = is_served ? c->ghosts.other[l - s->n].id : (long)t->id[l];
    if (is_family(s, t, h, body, x0, id)) return;
    solid_contact_pairs_add(&c->pairs[is_served ? SOLID_CONTACT_GHOST : SOLID_CONTACT_OWNED], h,
                            is_served ? l - s->n : l, xi);
    if (is_served) c->ghosts.used[l - s->n] = 1;
}

static int is_candidate(const struct solid *s, const struct solid_contact *c, const struct solid_contact_nonbonded *t,
                        int point) {
    return point < s->n ? t->is_candidate[point] : c->ghosts.other[point - s->n].is_candidate;
}

/* Whether the search around point j lists the pair of points i and j, so that the one around i need not. */
static int lists(const struct solid *s, const struct solid_contact *c, const struct solid_contact_nonbonded *t, int i,
                 int j) {
    const int is_fast_i = is_fast(s, c, t->point[i]), is_fast_j = is_fast(s, c, t->point[j]);
    return is_fast_i == is_fast_j ? j < i && is_candidate(s, c, t, t->point[j]) : is_fast_j;
}

void solid_contact_nonbonded_list(struct solid *s, struct solid_contact *c) {
    struct solid_contact_nonbonded *t = c->nonbonded;
    struct solid_contact_pairs *served = &c->pairs[SOLID_CONTACT_GHOST];
    set_criteria(s, c, t);
    c->ghosts.active = 0;
    if (!find_candidates(s, c, t)) return;
    gather(s, c, t);
    solid_contact_cells_fill(&t->cells, t->points, (const double(*)[3])t->x, c->radius + c->skin, s->in.periodic,
                             s->in.length);
    for (int i = 0; i < t->points; i++) {
        if (!is_candidate(s, c, t, t->point[i])) continue;
        const int number = solid_contact_cells_near(&t->cells, t->x[i], 1 + is_fast(s, c, t->point[i]), t->found);
        for (int k = 0; k < number; k++) {
            const int j = t->found[k], first = i < j ? i : j, second = i < j ? j : i;
            /* pairs of two ghosts are listed by other ranks */
            if (j == i || lists(s, c, t, i, j) || t->point[first] >= s->n) continue;
            pair_add(s, c, t, first, second);
        }
    }
    solid_contact_ghosts_keep(&c->ghosts);
    for (int k = 0; k < served->n; k++) served->l[k] = c->ghosts.at[served->l[k]];
}
