/* Refinement of plates: makes the plans from marked particles or start regions, and applies them. */
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "physics/limits.h"
#include "solid/bonds/family.h"
#include "solid/bonds/list.h"
#include "solid/geometry/on_surface.h"
#include "solid/geometry/turn.h"
#include "solid/geometry/shape.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/external_loads.h"
#include "solid/refine/parts.h"
#include "solid/step/balance.h"

#include <stdlib.h>

/* Copies the caller's outlines and cracks, which are needed again during the solid's life. */
static void own_outlines(struct solid_body *body) {
    struct solid_outline *outline = memory_copy(MEMORY_SOLID, body->outline, (size_t)body->outlines, sizeof *outline);
    for (int l = 0; l < body->outlines; l++) {
        const size_t n = (size_t)outline[l].corners;
        outline[l].corner = memory_copy(MEMORY_SOLID, outline[l].corner, n, sizeof *outline[l].corner);
        if (outline[l].centre)
            outline[l].centre = memory_copy(MEMORY_SOLID, outline[l].centre, n, sizeof *outline[l].centre);
        outline[l].turn = memory_copy(MEMORY_SOLID, outline[l].turn, n, 1);
    }
    body->outline = outline;
}

static void own_cuts(struct solid_input *in) {
    struct solid_cut *cut = memory_copy(MEMORY_SOLID, in->cut, (size_t)in->cuts, sizeof *cut);
    for (int q = 0; q < in->cuts; q++)
        cut[q].point = memory_copy(MEMORY_SOLID, cut[q].point, (size_t)cut[q].points, sizeof *cut[q].point);
    in->cut = cut;
}

struct solid_refine *solid_refine_new(struct solid_input *in) {
    if (!in->refinement || solid_dim(in) == 3) return NULL;
    struct solid_refine *r = memory_new(MEMORY_SOLID, 1, sizeof *r);
    r->in = *in->refinement;
    ENSURE(r->in.levels <= PHYSICS_LEVELS_MAX, "%d levels", r->in.levels);
    r->in.start = memory_copy(MEMORY_SOLID, r->in.start, (size_t)r->in.starts, sizeof *r->in.start);
    r->bodies = in->bodies;
    r->cells = memory_new(MEMORY_SOLID, (size_t)in->bodies, sizeof *r->cells);
    for (int b = 0; b < in->bodies; b++) own_outlines((struct solid_body *)(uintptr_t)&in->body[b]);
    own_cuts(in);
    r->body = in->body;
    r->cut = in->cut;
    r->cuts = in->cuts;
    in->refinement = &r->in;
    return r;
}

static void give_back(const void *own) { memory_free((void *)(uintptr_t)own); }

void solid_refine_free(struct solid_refine *r) {
    if (!r) return;
    for (int b = 0; b < r->bodies; b++) {
        const struct solid_body *body = &r->body[b];
        for (int l = 0; l < body->outlines; l++) {
            give_back(body->outline[l].corner);
            give_back(body->outline[l].centre);
            give_back(body->outline[l].turn);
        }
        give_back(body->outline);
        solid_refine_area_free(&r->cells[b]);
    }
    for (int q = 0; q < r->cuts; q++) give_back(r->cut[q].point);
    give_back(r->cut);
    give_back(r->in.start);
    MEMORY_FREE(r->cells, r->mark, r->energy, r);
}

int solid_refine_level(const struct solid *s, int h) {
    const struct solid_cloud *cloud = s->family->cloud[s->body[h]];
    return s->refine ? solid_refine_plan_level(cloud->size[s->first[par_rank()] + h - cloud->first]) : 0;
}

int solid_refine_finest(const struct solid *s) {
    int finest = 0;
    for (int b = 0; s->refine && b < s->in.bodies; b++) {
        const struct solid_cloud *cloud = s->family->cloud[b];
        for (long i = 0; solid_refine_plan_is_possible(s, b) && i < cloud->n; i++) {
            const int level = solid_refine_plan_level(cloud->size[i]);
            finest = level > finest ? level : finest;
        }
    }
    return finest;
}

long solid_refine_events(const struct solid *s) { return s->refine ? s->refine->events : 0; }

/* The particles of the body's cloud that have a constraint or a load, on every rank. Collective. */
static uint8_t *locked_of(const struct solid *s, int b) {
    const struct solid_cloud *cloud = s->family->cloud[b];
    const long from = s->first[par_rank()];
    uint8_t *here = memory_new(MEMORY_SOLID, (size_t)s->n + 1, 1);
    uint8_t *locked = memory_new(MEMORY_SOLID, (size_t)cloud->n + 1, 1);
    long *id = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *id), n = 0;
    size_t bytes;
    solid_external_loads_mark(s, here);
    for (int h = s->family->first[b]; h < s->family->first[b + 1]; h++)
        if (here[h] || (s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z))) id[n++] = from + h - cloud->first;
    long *all = par_all_gather_any(id, (size_t)n * sizeof *id, &bytes);
    for (size_t k = 0; k < bytes / sizeof *id; k++) locked[all[k]] = 1;
    free(all);
    MEMORY_FREE(id, here);
    return locked;
}

static struct solid_refine_plan *plan_new(const struct solid *s, int b) {
    uint8_t *locked = s->refine->in.held_refine ? NULL : locked_of(s, b);
    struct solid_refine_plan *plan = solid_refine_plan_of(s, b, locked);
    memory_free(locked);
    return plan;
}

/* Applies the plans, unless all are empty, and frees them. Returns how many particles were refined. */
static long carry_out(struct solid *s, struct solid_refine_plan **plan) {
    long refined = 0;
    for (int b = 0; b < s->in.bodies; b++) refined += plan[b]->refined;
    if (refined > 0) {
        solid_balance_end(s);
        solid_refine_apply(s, plan);
    }
    for (int b = 0; b < s->in.bodies; b++) solid_refine_plan_free(plan[b]);
    memory_free(plan);
    return refined;
}

static struct solid_refine_plan **plans(const struct solid *s) {
    struct solid_refine_plan **plan =
        memory_new(MEMORY_SOLID, (size_t)s->in.bodies, sizeof(struct solid_refine_plan *));
    for (int b = 0; b < s->in.bodies; b++) plan[b] = plan_new(s, b);
    return plan;
}

long solid_refine_marked(struct solid *s, const uint8_t *mark) {
    const long from = s->first[par_rank()];
    long n = 0, refined = 0;
    size_t bytes;
    for (int h = 0; h < s->n; h++) n += mark[h] != 0;
    if (par_sum_long(n) == 0) return 0;
    long *id = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *id);
    n = 0;
    for (int h = 0; h < s->n; h++)
        if (mark[h]) id[n++] = from + h;
    long *all = par_all_gather_any(id, (size_t)n * sizeof *id, &bytes);
    n = (long)(bytes / sizeof *all);
    if (n > 0) {
        struct solid_refine_plan **plan = plans(s);
        for (int b = 0; b < s->in.bodies; b++) {
            const struct solid_cloud *cloud = s->family->cloud[b];
            long of_body = 0, *number = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *number);
            for (long k = 0; k < n; k++)
                if (all[k] >= cloud->first && all[k] < cloud->first + cloud->n)
                    number[of_body++] = all[k] - cloud->first;
            if (solid_refine_plan_is_possible(s, b)) solid_refine_plan_close(plan[b], number, of_body, 1);
            memory_free(number);
        }
        refined = carry_out(s, plan);
    }
    free(all);
    memory_free(id);
    return refined;
}

/* Marks the particles of a region that have not reached its level yet. */
static void start_region(struct solid_refine_plan *p, const struct solid_refined *region) {
    const struct solid_cloud *cloud = p->cloud;
    for (int level = 0; level < region->level; level++) {
        long n = 0, *marked = memory_new(MEMORY_SOLID, (size_t)p->n + 1, sizeof *marked);
        for (long i = 0; i < p->n; i++) {
            double x[3] = {0}, own[3];
            for (int c = 0; c < 2; c++)
                x[c] = cloud->origin[c] + (double)p->at[i][c] / SOLID_REFINE_UNIT * cloud->spacing;
            solid_turn_place_into(&region->turn, x, own);
            const double depth = solid_on_surface_depth(own, region->low, region->high, 2);
            if (p->level[i] == level && solid_on_surface_is_inside(depth, cloud->spacing)) marked[n++] = i;
        }
        solid_refine_plan_close(p, marked, n, 0);
        memory_free(marked);
    }
}

void solid_refine_start(struct solid *s) {
    if (!s->refine || s->refine->in.starts == 0) return;
    solid_constraint_flags(s);
    struct solid_refine_plan **plan = plans(s);
    for (int b = 0; b < s->in.bodies; b++)
        for (int k = 0; solid_refine_plan_is_possible(s, b) && k < s->refine->in.starts; k++)
            start_region(plan[b], &s->refine->in.start[k]);
    if (carry_out(s, plan) == 0) die_all(EXIT_CODE_SCENE, "solid.refinement.start refines no particle");
    s->refine->events = 0;
}
