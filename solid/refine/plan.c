/* Plans a refinement: new particles, their levels, and which neighbours must be refined too.  (000: sec. 2.1.2) */
#include "solid/refine/plan.h"
#include "base/memory.h"
#include "solid/bonds/store.h"
#include "solid/geometry/outline.h"
#include "solid/refine/parts.h"
#include "solid/refine/places.h"

#include <math.h>
#include <string.h>

int solid_refine_plan_level(double size) { return size < 1 ? -ilogb(size) : 0; }

static void reserve(struct solid_refine_plan *p, long n) {
    if (n <= p->capacity) return;
    p->capacity = n + n / 2 + 64;
    p->at = memory_grown(MEMORY_SOLID, p->at, (size_t)p->n, (size_t)p->capacity, sizeof *p->at);
    p->level = memory_grown(MEMORY_SOLID, p->level, (size_t)p->n, (size_t)p->capacity, 1);
    p->locked = memory_grown(MEMORY_SOLID, p->locked, (size_t)p->n, (size_t)p->capacity, 1);
    p->interpolated = memory_grown(MEMORY_SOLID, p->interpolated, (size_t)(p->n > p->before ? p->n - p->before : 0),
                                   (size_t)(p->capacity - p->before), sizeof *p->interpolated);
    for (p->mask = 64; p->mask < 3 * p->capacity; p->mask *= 2) {
    }
    memory_free(p->slot);
    p->slot = memory_new(MEMORY_SOLID, (size_t)p->mask, sizeof *p->slot);
    p->mask--;
    for (long i = 0; i < p->n; i++) solid_refine_places_enter(p, i);
}

int solid_refine_plan_is_possible(const struct solid *s, int b) { return s->in.body[b].shape == SOLID_POLYGON; }

struct solid_refine_plan *solid_refine_plan_of(const struct solid *s, int b, const uint8_t *locked) {
    const struct solid_cloud *cloud = s->family->cloud[b];
    const struct solid_body *body = &s->in.body[b];
    struct solid_refine_plan *p = memory_new(MEMORY_SOLID, 1, sizeof *p);
    *p = (struct solid_refine_plan){.cloud = cloud,
                                    .body = body,
                                    .in = &s->refine->in,
                                    .ratio = s->in.material[body->material].horizon_ratio,
                                    .before = cloud->n};
    for (int c = 0; c < 2; c++) p->period[c] = (int)lrint(cloud->period[c] * SOLID_REFINE_UNIT);
    reserve(p, cloud->n);
    for (; p->n < cloud->n; p->n++) {
        for (int c = 0; c < 2; c++)
            p->at[p->n][c] =
                solid_refine_places_wrapped((int)lrint(cloud->place[c][p->n] * SOLID_REFINE_UNIT), p->period[c]);
        p->level[p->n] = (uint8_t)solid_refine_plan_level(cloud->size[p->n]);
        p->locked[p->n] = locked ? locked[p->n] : 0;
        solid_refine_places_enter(p, p->n);
    }
    return p;
}

void solid_refine_plan_free(struct solid_refine_plan *p) {
    if (!p) return;
    MEMORY_FREE(p->at, p->level, p->locked, p->interpolated, p->slot, p);
}

/* m h, without the correction of the interface. */
static double reach_of(const struct solid_refine_plan *p, int level) {
    return p->in->horizon_kept ? p->ratio : ldexp(p->ratio, -level);
}

/* 000: eq. 40. */
double solid_refine_plan_horizon(const struct solid_refine_plan *p, long i) {
    const int level = p->level[i], h = solid_refine_plan_spacing(level);
    const double reach = reach_of(p, level);
    if (!p->in->interface_corrected || level == 0) return reach;
    for (int k = 0; k < 9; k++) {
        const long near = solid_refine_places_at(p, p->at[i][0] + (k % 3 - 1) * h, p->at[i][1] + (k / 3 - 1) * h);
        if (near >= 0 && p->level[near] < level) return M_SQRT2 * reach;
    }
    return reach;
}

static int is_inside(const struct solid_refine_plan *p, const int at[2]) {
    double x[2];
    for (int c = 0; c < 2; c++) x[c] = p->cloud->origin[c] + (double)at[c] / SOLID_REFINE_UNIT * p->cloud->spacing;
    return solid_outline_contains(p->body->outline, p->body->outlines, x, p->cloud->spacing);
}

static void refine(struct solid_refine_plan *p, long i) {
    const int level = ++p->level[i], h = solid_refine_plan_spacing(level);
    p->refined++;
    for (int k = 0; k < 9; k++) {
        const int at[2] = {solid_refine_places_wrapped(p->at[i][0] + (k % 3 - 1) * h, p->period[0]),
                           solid_refine_places_wrapped(p->at[i][1] + (k / 3 - 1) * h, p->period[1])};
        if (solid_refine_places_at(p, at[0], at[1]) >= 0 || !is_inside(p, at)) continue;
        const struct solid_refine_interpolated interpolated = solid_refine_interpolate_at(p, at, level);
        reserve(p, p->n + 1);
        memcpy(p->at[p->n], at, sizeof at);
        p->level[p->n] = (uint8_t)level;
        for (int q = 0; q < interpolated.parents; q++) p->locked[p->n] |= p->locked[interpolated.parent[q]];
        p->interpolated[p->n - p->before] = interpolated;
        solid_refine_places_enter(p, p->n++);
    }
}

/* Called for the neighbours of a particle on its own level's lattice. */
typedef int visitor(struct solid_refine_plan *p, uint8_t *wanted, long i, long near);

static int about(struct solid_refine_plan *p, uint8_t *wanted, long i, visitor *visit) {
    const int level = p->level[i], h = solid_refine_plan_spacing(level);
    const double reach = fmax(reach_of(p, level) * SOLID_REFINE_UNIT, 1.5 * h);
    const int steps = (int)(reach / h);
    int met = 0;
    for (int k = -steps; k <= steps; k++)
        for (int j = -steps; j <= steps; j++) {
            const double dx = (double)j * h, dy = (double)k * h;
            if (dx * dx + dy * dy > reach * reach * (1 + 1e-12)) continue;
            const long near = solid_refine_places_at(p, p->at[i][0] + j * h, p->at[i][1] + k * h);
            if (near >= 0 && near != i) met += visit(p, wanted, i, near);
        }
    return met;
}

static int want_alike(struct solid_refine_plan *p, uint8_t *wanted, long i, long near) {
    wanted[near] |= p->level[near] == p->level[i];
    return 0;
}

static int want_coarser(struct solid_refine_plan *p, uint8_t *wanted, long i, long near) {
    const int coarser = p->level[near] < p->level[i];
    wanted[near] |= (uint8_t)coarser;
    return coarser;
}

/* Whether more than five of the eight positions at half its spacing have particles. */
static int is_enclosed(const struct solid_refine_plan *p, long i) {
    const int h = solid_refine_plan_spacing(p->level[i] + 1);
    int n = -1; /* without the particle itself */
    for (int k = 0; k < 9; k++)
        n += solid_refine_places_at(p, p->at[i][0] + (k % 3 - 1) * h, p->at[i][1] + (k / 3 - 1) * h) >= 0;
    return n > 5;
}

/* Wants particles next to new ones if these enclose them. */
static void want_enclosed(const struct solid_refine_plan *p, uint8_t *wanted) {
    for (long i = p->before; i < p->n; i++) {
        const int h = solid_refine_plan_spacing(p->level[i]);
        for (int k = 0; k < 9; k++) {
            const long near = solid_refine_places_at(p, p->at[i][0] + (k % 3 - 1) * h, p->at[i][1] + (k / 3 - 1) * h);
            if (near >= 0 && p->level[near] < p->level[i] && is_enclosed(p, near)) wanted[near] = 1;
        }
    }
}

/* Refines the wanted particles that have no coarser ones within their horizon; else the coarser ones become wanted
 * first. Returns how many were refined. */
static long refine_wanted(struct solid_refine_plan *p, uint8_t *wanted) {
    const long before = p->refined, n = p->n;
    for (int level = p->in->levels - 1; level >= 0; level--)
        for (long i = 0; i < n; i++) {
            if (!wanted[i] || p->level[i] != level) continue;
            wanted[i] = !p->locked[i];
            if (wanted[i] && about(p, wanted, i, want_coarser) > 0) wanted[i] = 0;
        }
    for (long i = 0; i < n; i++)
        if (wanted[i] && p->level[i] < p->in->levels) refine(p, i);
    return p->refined - before;
}

void solid_refine_plan_close(struct solid_refine_plan *p, const long *marked, long n, int families) {
    uint8_t *from = memory_new(MEMORY_SOLID, (size_t)n + 1, 1);
    for (long k = 0; k < n; k++) from[k] = p->level[marked[k]];
    for (long refined = 1; refined > 0;) {
        uint8_t *wanted = memory_new(MEMORY_SOLID, (size_t)p->n + 1, 1);
        for (long k = 0; k < n; k++) {
            if (p->locked[marked[k]] || p->level[marked[k]] != from[k] || from[k] >= p->in->levels) continue;
            wanted[marked[k]] = 1;
            if (families) about(p, wanted, marked[k], want_alike);
        }
        want_enclosed(p, wanted);
        refined = refine_wanted(p, wanted);
        memory_free(wanted);
    }
    memory_free(from);
}
