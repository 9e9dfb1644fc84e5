/* Areas and edge lengths of a plate's particles of different levels.  (000: eq. 38) */
#include "solid/refine/area.h"
#include "base/memory.h"
#include "solid/geometry/outline.h"
#include "solid/refine/parts.h"
#include "solid/refine/places.h"

#include <math.h>

enum { UNIT = SOLID_REFINE_UNIT, MARGIN = 3 };

/* Areas less than NOTHING of a cell are zero; areas that differ by less than EQUAL are equal. */
static const double NOTHING = 1e-11, EQUAL = 1e-9;

static double rounded(double area) { return rint(area * 0x1p40) * 0x1p-40; }

void solid_refine_area_new(struct solid_refine_cells *k, const struct solid_cloud *cloud) {
    for (int c = 0; c < 2; c++) {
        double low = INFINITY, high = -INFINITY;
        for (long i = 0; i < cloud->n; i++) {
            low = fmin(low, cloud->place[c][i]);
            high = fmax(high, cloud->place[c][i]);
        }
        k->low[c] = (int)floor(low) - MARGIN;
        k->n[c] = (int)floor(high) + MARGIN + 1 - k->low[c];
    }
    const long cells = (long)k->n[0] * k->n[1];
    k->area = memory_new(MEMORY_SOLID, (size_t)cells, sizeof *k->area);
    for (long i = 0; i < cells; i++) k->area[i] = NAN;
}

void solid_refine_area_free(struct solid_refine_cells *k) { memory_free(k->area); }

static int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/* The site of a level whose cell contains x; x is the centre of a quarter of that cell. */
static int site_of(int x, int level) {
    const int h = solid_refine_plan_spacing(level);
    return level == 0 ? h * floor_div(x, h) + h / 2 : h * floor_div(x + h / 2, h);
}

/* The particle at x, y if its level is at least this one, or -1. */
static long at_level(const struct solid_refine_plan *p, int x, int y, int level) {
    const long i = solid_refine_places_at(p, x, y);
    return i >= 0 && p->level[i] >= level ? i : -1;
}

/* The nearest particles to a site of the level among the eight sites next to it. */
static int nearest(const struct solid_refine_plan *p, const int site[2], int level, long near[4]) {
    const int h = solid_refine_plan_spacing(level);
    for (int diagonal = 0; diagonal < 2; diagonal++) {
        int n = 0;
        for (int k = 0; k < 9; k++) {
            if ((k % 3 != 1) + (k / 3 != 1) != 1 + diagonal) continue;
            const long i = at_level(p, site[0] + (k % 3 - 1) * h, site[1] + (k / 3 - 1) * h, level);
            if (i >= 0) near[n++] = i;
        }
        if (n > 0) return n;
    }
    return 0;
}

/* The particles that a region belongs to: one, or several in equal parts. */
struct owners {
    int n;
    long owner[4];
};

/* The particles that share a quarter of a cell, with its centre at x, that lies in no particle's cell. */
static struct owners heirs(const struct solid_refine_plan *p, const int x[2], int level) {
    struct owners owners = {0};
    for (; level >= 0 && owners.n == 0; level--) {
        const int site[2] = {site_of(x[0], level), site_of(x[1], level)};
        owners.n = nearest(p, site, level, owners.owner);
    }
    return owners;
}

/* Whether a part of the quarter may belong to a finer particle, by its cell or as a share. */
static int is_split(const struct solid_refine_plan *p, const int x[2], int level, int owned) {
    const int part = solid_refine_plan_spacing(level) / 8;
    long near[4];
    if (level == p->in->levels) return 0;
    for (int k = 0; k < 4; k++) {
        const int site[2] = {site_of(x[0] + (2 * (k % 2) - 1) * part, level + 1),
                             site_of(x[1] + (2 * (k / 2) - 1) * part, level + 1)};
        if (at_level(p, site[0], site[1], level + 1) >= 0) return 1;
        if (!owned && nearest(p, site, level + 1, near) > 0) return 1;
    }
    return 0;
}

/* A walk down the levels of quarters. owner: the particle of the finest level so far whose cell contains the quarter,
 * unless finer particles may own parts of it, or -1. */
struct walk {
    const struct solid_refine_plan *plan;
    void (*give)(struct walk *w, const struct owners *to, const int x[2], int level);
    /* for areas */
    const struct solid_outline *outline;
    int outlines, is_full;
    double *sum;
    /* for one point: only the quarters that contain it */
    const int *only;
    struct owners found;
};

static void walk_down(struct walk *w, const int x[2], int level, long owner) {
    const struct solid_refine_plan *p = w->plan;
    const int part = solid_refine_plan_spacing(level) / 8;
    const long here = at_level(p, site_of(x[0], level), site_of(x[1], level), level);
    if (here >= 0) owner = p->level[here] == level ? here : -1;
    if ((here >= 0 || owner < 0) && is_split(p, x, level, owner >= 0)) {
        for (int k = 0; k < 4; k++) {
            const int next[2] = {x[0] + (2 * (k % 2) - 1) * part, x[1] + (2 * (k / 2) - 1) * part};
            if (w->only && ((w->only[0] > x[0]) != k % 2 || (w->only[1] > x[1]) != k / 2)) continue;
            walk_down(w, next, level + 1, owner);
        }
        return;
    }
    const struct owners owners = owner >= 0 ? (struct owners){1, {owner}} : heirs(p, x, level);
    w->give(w, &owners, x, level);
}

static double area_of(const struct solid_refine_plan *p, const int x[2], int side) {
    const struct solid_cloud *cloud = p->cloud;
    double centre[2];
    for (int c = 0; c < 2; c++) centre[c] = cloud->origin[c] + (double)x[c] / UNIT * cloud->spacing;
    return solid_outline_area_in(p->body->outline, p->body->outlines, centre, (double)side / UNIT * cloud->spacing) /
           (cloud->spacing * cloud->spacing);
}

static void give_area(struct walk *w, const struct owners *to, const int x[2], int level) {
    const int side = solid_refine_plan_spacing(level) / 2;
    const double full = (double)side * side / (UNIT * UNIT), area = w->is_full ? full : area_of(w->plan, x, side);
    if (area > NOTHING * full && to->n > 0)
        for (int k = 0; k < to->n; k++) w->sum[to->owner[k]] += rounded(area / to->n);
}

/* The area of the body in a cell of the lattice, in cells. */
static double cell_area(const struct solid_refine_plan *p, struct solid_refine_cells *k, int i, int j) {
    double *area = &k->area[(long)j * k->n[0] + i];
    if (isnan(*area)) {
        const int x[2] = {(k->low[0] + i) * UNIT + UNIT / 2, (k->low[1] + j) * UNIT + UNIT / 2};
        *area = area_of(p, x, UNIT);
    }
    return *area;
}

/* Marks the cells next to those marked value - 1, across periodic sides. */
static void dilate(const struct solid_refine_plan *p, const struct solid_refine_cells *k, uint8_t *mark, int value) {
    for (int j = 0; j < k->n[1]; j++)
        for (int i = 0; i < k->n[0]; i++) {
            if (mark[(long)j * k->n[0] + i] != value - 1 || value < 2) continue;
            for (int q = 0; q < 9; q++) {
                int at[2] = {i + q % 3 - 1, j + q / 3 - 1};
                for (int c = 0; c < 2; c++) {
                    const int period = p->period[c] / UNIT, x = at[c] + k->low[c];
                    if (period) at[c] = (x % period + period) % period - k->low[c];
                }
                if (at[0] < 0 || at[1] < 0 || at[0] >= k->n[0] || at[1] >= k->n[1]) continue;
                uint8_t *to = &mark[(long)at[1] * k->n[0] + at[0]];
                if (*to == 0) *to = (uint8_t)value;
            }
        }
}

static uint8_t *mark_of(const struct solid_refine_cells *k, uint8_t *mark, const int at[2]) {
    return &mark[(long)(floor_div(at[1], UNIT) - k->low[1]) * k->n[0] + (floor_div(at[0], UNIT) - k->low[0])];
}

/* Marks of the cells: 1: near a finer particle; 2 and 3: cells whose areas may change because of these. */
static uint8_t *mark_cells(const struct solid_refine_plan *p, const struct solid_refine_cells *k) {
    uint8_t *mark = memory_new(MEMORY_SOLID, (size_t)k->n[0] * (size_t)k->n[1], 1);
    for (long i = 0; i < p->n; i++)
        for (int q = 0; p->level[i] > 0 && q < 9; q++) {
            int at[2] = {p->at[i][0] + (q % 3 - 1) * UNIT, p->at[i][1] + (q / 3 - 1) * UNIT};
            for (int c = 0; c < 2; c++)
                if (p->period[c]) at[c] = (at[c] % p->period[c] + p->period[c]) % p->period[c];
            *mark_of(k, mark, at) = 1;
        }
    dilate(p, k, mark, 2);
    dilate(p, k, mark, 3);
    return mark;
}

void solid_refine_area(const struct solid_refine_plan *p, struct solid_refine_cells *k, double *volume) {
    uint8_t *mark = mark_cells(p, k);
    double *sum = memory_new(MEMORY_SOLID, (size_t)p->n + 1, sizeof *sum);
    struct walk w = {.plan = p, .give = give_area, .sum = sum};
    for (int j = 0; j < k->n[1]; j++)
        for (int i = 0; i < k->n[0]; i++) {
            if (!mark[(long)j * k->n[0] + i]) continue;
            const double area = cell_area(p, k, i, j);
            if (area < NOTHING) continue;
            w.is_full = area > 1 - NOTHING;
            for (int q = 0; q < 4; q++) {
                const int x[2] = {(k->low[0] + i) * UNIT + UNIT / 4 * (1 + 2 * (q % 2)),
                                  (k->low[1] + j) * UNIT + UNIT / 4 * (1 + 2 * (q / 2))};
                walk_down(&w, x, 0, -1);
            }
        }
    for (long i = 0; i < p->n; i++) {
        const int m = *mark_of(k, mark, p->at[i]);
        if (p->level[i] == 0 && m != 1 && m != 2) continue;
        if (i >= p->before || fabs(sum[i] - volume[i]) > EQUAL * ldexp(1, -2 * p->level[i])) volume[i] = sum[i];
    }
    MEMORY_FREE(mark, sum);
}

static void give_place(struct walk *w, const struct owners *to, const int x[2], int level) {
    (void)x;
    (void)level;
    w->found = *to;
}

int solid_refine_area_length(const struct solid_refine_plan *p, const double from[2], const double to[2],
                             double *length, char *text, size_t size) {
    const int side = solid_refine_plan_spacing(p->in->levels) / 2;
    const double step = p->cloud->spacing * side / UNIT;
    struct solid_outline_lengths *l =
        solid_outline_lengths(p->body->outline, p->body->outlines, p->cloud->origin, step, NULL, from, to, text, size);
    if (!l) return 0;
    for (long k = 0; k < l->n; k++) {
        const int at[2] = {solid_outline_key_i(l->share[k].cell) * side + side / 2,
                           solid_outline_key_j(l->share[k].cell) * side + side / 2};
        struct walk w = {.plan = p, .give = give_place, .only = at};
        const int q[2] = {floor_div(at[0], UNIT / 2), floor_div(at[1], UNIT / 2)};
        const int x[2] = {q[0] * (UNIT / 2) + UNIT / 4, q[1] * (UNIT / 2) + UNIT / 4};
        walk_down(&w, x, 0, -1);
        for (int i = 0; i < w.found.n; i++)
            length[w.found.owner[i]] += step * rounded(l->share[k].length / step / w.found.n);
    }
    solid_outline_lengths_free(l);
    return 1;
}

int solid_refine_area_lengths(const struct solid *s, int b, const double from[2], const double to[2], double *length) {
    char text[256];
    if (!solid_refine_plan_is_possible(s, b)) return 0;
    struct solid_refine_plan *plan = solid_refine_plan_of(s, b, NULL);
    const int found = solid_refine_area_length(plan, from, to, length, text, sizeof text);
    solid_refine_plan_free(plan);
    return found;
}
