/* Reads tips and fronts of a plate's crack from the damaged particles.  (000: sec. 3.1) */
#include "solid/measure/crack.h"
#include "base/memory.h"
#include "base/sets.h"
#include "base/par.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Distances in particles: of neighbours along a lattice's axes and diagonals; of neighbours across a gap of two
 * particles. */
static const double TOUCH = 1.6, NEAR = 3.1;
/* Least length of a front, in particles. */
static const double STANDS_OUT = 3;
/* Positions nearer than this are equal, in particles. */
static const double SAME = 1e-6;

struct entry {
    double far, lateral, x[2], size;
};

static double along(const double x[2], const double d[2]) { return d[0] * x[0] + d[1] * x[1]; }
static double lateral(const double x[2], const double d[2]) { return d[0] * x[1] - d[1] * x[0]; }

static int by_distance(const void *a, const void *b) {
    const struct entry *p = a, *q = b;
    if (p->far != q->far) return p->far < q->far ? 1 : -1;
    return (p->lateral > q->lateral) - (p->lateral < q->lateral);
}

static struct solid_crack_particles particles_new(long n) {
    const size_t capacity = (size_t)n + 1;
    return (struct solid_crack_particles){.n = n,
                                          .x = memory_new(MEMORY_OUTPUT, capacity, sizeof(double[2])),
                                          .size = memory_new(MEMORY_OUTPUT, capacity, sizeof(double))};
}

void solid_crack_particles_free(struct solid_crack_particles *p) {
    MEMORY_FREE(p->x, p->size);
    *p = (struct solid_crack_particles){0};
}

/* Sorts the list and writes it to p. */
static void take(struct solid_crack_particles *p, struct entry *list, const double direction[2]) {
    for (long i = 0; i < p->n; i++) {
        list[i].far = along(list[i].x, direction);
        list[i].lateral = lateral(list[i].x, direction);
    }
    qsort(list, (size_t)p->n, sizeof *list, by_distance);
    for (long i = 0; i < p->n; i++) {
        memcpy(p->x[i], list[i].x, sizeof p->x[i]);
        p->size[i] = list[i].size;
    }
}

void solid_crack_sort(struct solid_crack_particles *p, const double direction[2]) {
    struct entry *list = memory_new(MEMORY_OUTPUT, (size_t)p->n + 1, sizeof *list);
    for (long i = 0; i < p->n; i++) list[i] = (struct entry){.x = {p->x[i][0], p->x[i][1]}, .size = p->size[i]};
    take(p, list, direction);
    memory_free(list);
}

struct solid_crack_particles solid_crack_gather(const struct solid *s, const double *damage, double level,
                                                const double direction[2]) {
    int local = 0;
    for (int h = 0; h < s->n; h++) local += damage[h] > level;
    struct entry *list = memory_new(MEMORY_OUTPUT, (size_t)local + 1, sizeof *list);
    local = 0;
    for (int h = 0; h < s->n; h++) {
        if (!(damage[h] > level)) continue;
        list[local++] =
            (struct entry){.x = {s->x0[0][h], s->x0[1][h]},
                           .size = s->dim == 2 ? sqrt(s->volume[h] / solid_depth(&s->in)) : cbrt(s->volume[h])};
    }
    size_t bytes;
    struct entry *all = par_all_gather_any(list, (size_t)local * sizeof *list, &bytes);
    memory_free(list);
    struct solid_crack_particles p = particles_new((long)(bytes / sizeof *all));
    take(&p, all, direction);
    free(all);
    return p;
}

/* A forest of particles, as indices into a list; the root of a tree is its farthest particle, which has the lowest
 * index. */
static double largest(const struct solid_crack_particles *p) {
    double size = 0;
    for (long i = 0; i < p->n; i++) size = fmax(size, p->size[i]);
    return size;
}

/* The first particle from `from` on that is farther than i by at most reach, the largest distance of any pair. */
static long first_within(const struct solid_crack_particles *p, const double d[2], long from, long i, double reach) {
    while (along(p->x[from], d) - along(p->x[i], d) > reach) from++;
    return from;
}

static int near(const struct solid_crack_particles *p, long i, long j) {
    return hypot(p->x[i][0] - p->x[j][0], p->x[i][1] - p->x[j][1]) <= NEAR * fmax(p->size[i], p->size[j]);
}

/* Index of a particle in a list that contains it, from `from` on. */
static long place_in(const struct solid_crack_particles *all, const double x[2], long from) {
    while (memcmp(all->x[from], x, sizeof *all->x) != 0) from++;
    return from;
}

/* The damaged particles connected to an initially damaged one. */
static struct solid_crack_particles connected(const struct solid_crack_particles *damaged,
                                              const struct solid_crack_particles *initial, const double d[2]) {
    const long n = damaged->n + initial->n;
    struct solid_crack_particles all = particles_new(n), kept = particles_new(damaged->n);
    long *parent = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *parent);
    char *has_initial = memory_new(MEMORY_OUTPUT, (size_t)n + 1, 1);
    memcpy(all.x, damaged->x, (size_t)damaged->n * sizeof *all.x);
    memcpy(all.x + damaged->n, initial->x, (size_t)initial->n * sizeof *all.x);
    memcpy(all.size, damaged->size, (size_t)damaged->n * sizeof *all.size);
    memcpy(all.size + damaged->n, initial->size, (size_t)initial->n * sizeof *all.size);
    solid_crack_sort(&all, d);
    const double reach = NEAR * largest(&all);
    for (long i = 0, from = 0; i < n; i++) {
        parent[i] = i;
        from = first_within(&all, d, from, i, reach);
        for (long j = from; j < i; j++) {
            if (!near(&all, i, j)) continue;
            const long a = sets_root(parent, i), b = sets_root(parent, j);
            parent[a > b ? a : b] = a > b ? b : a;
        }
    }
    for (long k = 0, i = 0; k < initial->n; k++, i++) {
        i = place_in(&all, initial->x[k], i);
        has_initial[sets_root(parent, i)] = 1;
    }
    kept.n = 0;
    for (long k = 0, i = 0; k < damaged->n; k++, i++) {
        i = place_in(&all, damaged->x[k], i);
        if (!has_initial[sets_root(parent, i)]) continue;
        memcpy(kept.x[kept.n], damaged->x[k], sizeof *kept.x);
        kept.size[kept.n++] = damaged->size[k];
    }
    MEMORY_FREE(has_initial, parent);
    solid_crack_particles_free(&all);
    return kept;
}

/* Whether i continues the crack behind j, the farther one; a gap of two particles along the direction does not end a
 * crack. */
static int follows(const struct solid_crack_particles *p, const double d[2], long i, long j) {
    const double size = fmax(p->size[i], p->size[j]);
    return along(p->x[j], d) - along(p->x[i], d) <= NEAR * size &&
           fabs(lateral(p->x[j], d) - lateral(p->x[i], d)) <= TOUCH * size;
}

/* Particles are a forest, as indices into the list; the root of a tree is its farthest particle, which has the lowest
 * index. Each particle joins the earlier ones in the list, which are farther. A tree begins at a peak and ends where it
 * meets a tree with a farther peak; it is a front if it is long enough there. */
static int count_fronts(const struct solid_crack_particles *p, const double d[2]) {
    long *parent = memory_new(MEMORY_OUTPUT, 2 * (size_t)p->n + 1, sizeof *parent), *last = parent + p->n;
    const double reach = NEAR * largest(p);
    int fronts = 0;
    for (long i = 0, from = 0; i < p->n; i++) {
        parent[i] = last[i] = i;
        from = first_within(p, d, from, i, reach);
        for (long j = from; j < i; j++) {
            if (!follows(p, d, i, j)) continue;
            const long a = sets_root(parent, i), b = sets_root(parent, j), young = a > b ? a : b, old = a > b ? b : a;
            last[old] = i;
            if (young == old) continue;
            fronts += along(p->x[young], d) - along(p->x[i], d) > STANDS_OUT * p->size[i];
            parent[young] = old;
        }
    }
    for (long i = 0; i < p->n; i++)
        if (parent[i] == i) fronts += i == 0 || along(p->x[i], d) - along(p->x[last[i]], d) > STANDS_OUT * p->size[i];
    memory_free(parent);
    return fronts;
}

/* The farthest particle on one side of the axis (sign 0: on both); the mean position of equally far ones. Returns 0 if
 * there is none. */
static int farthest(const struct solid_crack_particles *p, const double d[2], double axis, int sign, double x[2]) {
    double sum[2] = {0, 0}, first = NAN;
    int n = 0;
    for (long i = 0; i < p->n; i++) {
        const double same = SAME * p->size[i];
        if (sign * (lateral(p->x[i], d) - axis) < -same) continue;
        if (n > 0 && first - along(p->x[i], d) > same) break;
        if (n++ == 0) first = along(p->x[i], d);
        for (int c = 0; c < 2; c++) sum[c] += p->x[i][c];
    }
    for (int c = 0; c < 2; c++) x[c] = n ? sum[c] / n : NAN;
    return n > 0;
}

struct solid_crack_tips solid_crack_tips_of(const struct solid_crack_particles *damaged,
                                            const struct solid_crack_particles *initial, const double direction[2],
                                            const double *axis) {
    struct solid_crack_particles some = {0};
    if (initial->n > 0) some = connected(damaged, initial, direction);
    const struct solid_crack_particles *p = initial->n > 0 ? &some : damaged;
    struct solid_crack_tips t;
    t.found = farthest(p, direction, 0, 0, t.tip);
    const double middle = lateral(axis ? axis : t.tip, direction);
    farthest(p, direction, middle, 1, t.side[SOLID_CRACK_LEFT]);
    farthest(p, direction, middle, -1, t.side[SOLID_CRACK_RIGHT]);
    t.fronts = count_fronts(p, direction);
    solid_crack_particles_free(&some);
    return t;
}
