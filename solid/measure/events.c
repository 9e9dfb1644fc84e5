/* Clusters of bonds that broke in one step: number, place, normal, area and energy. */
#include "solid/measure/events.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/sets.h"
#include "base/par.h"
#include "solid/contact/cells.h"
#include "solid/measure/tensors.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int by_numbers(const double *p, const double *q, int n) {
    for (int c = 0; c < n; c++)
        if (p[c] != q[c]) return p[c] < q[c] ? -1 : 1;
    return 0;
}

static int by_bond(const void *a, const void *b) {
    const struct solid_break *p = a, *q = b;
    if (p->step != q->step) return p->step < q->step ? -1 : 1;
    const int place = by_numbers(p->x, q->x, 3);
    return place ? place : by_numbers(p->xi, q->xi, 3);
}

/* Halves of one bond, which may differ in the last digit, are added in a fixed order. */
static int by_half(const void *a, const void *b) {
    const struct solid_break *p = a, *q = b;
    const int bond = by_bond(a, b);
    return bond ? bond : by_numbers(&p->energy, &q->energy, 1);
}

long solid_events_join(struct solid_break *list, long n) {
    long bonds = 0;
    qsort(list, (size_t)n, sizeof *list, by_half);
    for (long i = 0; i < n; i++) {
        if (bonds > 0 && by_bond(&list[bonds - 1], &list[i]) == 0) {
            list[bonds - 1].energy += list[i].energy;
            list[bonds - 1].area += list[i].area;
        } else {
            list[bonds++] = list[i];
        }
    }
    return bonds;
}

long solid_events_take(struct solid *s, struct solid_break **list) {
    size_t bytes = 0;
    *list = par_all_gather_any(s->breaks->record, (size_t)s->breaks->n * sizeof **list, &bytes);
    solid_breaks_drop(s->breaks);
    return solid_events_join(*list, (long)(bytes / sizeof **list));
}

double solid_events_reach(const struct solid_input *in) {
    double most = 0;
    for (int m = 0; m < in->materials; m++) most = fmax(most, in->material[m].horizon_ratio * in->spacing);
    return most;
}

/* An end of a bond. */
struct end {
    double x[3];
    long at; /* 2 bond + which */
};

static int by_place(const void *a, const void *b) {
    return by_numbers(((const struct end *)a)->x, ((const struct end *)b)->x, 3);
}

struct period {
    const int *is;
    const double *length; /* m */
};

/* The shortest of x and its images. */
static double shortest(const struct period *p, int c, double x) {
    return p->is[c] ? x - p->length[c] * rint(x / p->length[c]) : x;
}

/* The ends of the bonds of one step: the different places x, and of each bond's ends their index there. An end across a
 * periodic side is the same place on both sides but for rounding, so that it may be listed twice. */
static int places(const struct solid_break *bond, int n, double (*x)[3], int (*end)[2]) {
    struct end *all = memory_new(MEMORY_OUTPUT, 2 * (size_t)n, sizeof *all);
    int found = 0;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 2; k++) {
            struct end *e = &all[2 * i + k];
            e->at = 2L * i + k;
            for (int c = 0; c < 3; c++) e->x[c] = bond[i].x[c] + k * bond[i].xi[c];
        }
    qsort(all, 2 * (size_t)n, sizeof *all, by_place);
    for (int i = 0; i < 2 * n; i++) {
        if (i == 0 || by_place(&all[i - 1], &all[i]) != 0) memcpy(x[found++], all[i].x, sizeof all[i].x);
        end[all[i].at / 2][all[i].at % 2] = found - 1;
    }
    memory_free(all);
    return found;
}

/* The cluster of each of the n bonds of a step: the same number for those of one event. */
static void cluster(const struct solid_break *bond, int n, double reach, const struct period *period, int *group) {
    double(*x)[3] = memory_new(MEMORY_OUTPUT, 2 * (size_t)n, sizeof *x);
    int(*end)[2] = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *end);
    const int m = places(bond, n, x, end);
    int *parent = memory_new(MEMORY_OUTPUT, (size_t)m, sizeof *parent);
    int *found = memory_new(MEMORY_OUTPUT, (size_t)m, sizeof *found);
    struct solid_cells cells = {0};
    for (int i = 0; i < m; i++) parent[i] = i;
    for (int i = 0; i < n; i++) sets_join_int(parent, end[i][0], end[i][1]);
    solid_contact_cells_fill(&cells, m, (const double(*)[3])x, reach, period->is, period->length);
    for (int i = 0; i < m; i++) {
        const int near = solid_contact_cells_near(&cells, x[i], 1, found);
        for (int k = 0; k < near; k++) {
            double r2 = 0;
            if (found[k] <= i) continue;
            for (int c = 0; c < 3; c++) {
                const double separation = shortest(period, c, x[found[k]][c] - x[i][c]);
                r2 += separation * separation;
            }
            if (r2 <= reach * reach) sets_join_int(parent, i, found[k]);
        }
    }
    for (int i = 0; i < n; i++) group[i] = sets_root_int(parent, end[i][0]);
    solid_contact_cells_free(&cells);
    MEMORY_FREE(found, parent, end, x);
}

/* Sums over the bonds of an event. */
struct sums {
    long bonds;
    const struct solid_break *first;
    double area, energy, moment[3], fabric[6]; /* m2, J, m3, m2 */
};

static void add(struct sums *to, const struct solid_break *bond, const struct period *period) {
    double length2 = 0;
    if (to->bonds++ == 0) to->first = bond;
    to->area += bond->area;
    to->energy += bond->energy;
    for (int c = 0; c < 3; c++) {
        const double middle = bond->x[c] + 0.5 * bond->xi[c], from = to->first->x[c] + 0.5 * to->first->xi[c];
        to->moment[c] += bond->area * shortest(period, c, middle - from);
        length2 += bond->xi[c] * bond->xi[c];
    }
    for (int k = 0; k < 6; k++) { /* xx yy zz xy yz zx */
        const int i = k % 3, j = k < 3 ? k : (k + 1) % 3;
        to->fabric[k] += bond->area * bond->xi[i] * bond->xi[j] / length2;
    }
}

static struct solid_event event_of(const struct sums *sums, const struct period *period) {
    struct solid_event e = {.t = sums->first->t,
                            .step = sums->first->step,
                            .bonds = sums->bonds,
                            .area = sums->area,
                            .energy = sums->energy};
    double value[3], vector[3][3];
    int most = 0;
    solid_tensors_eigen(sums->fabric, value, vector);
    e.alignment = value[0] / (value[0] + value[1] + value[2]);
    for (int c = 1; c < 3; c++)
        if (fabs(vector[0][c]) > fabs(vector[0][most]) * (1 + 1e-9)) most = c;
    for (int c = 0; c < 3; c++) {
        e.centre[c] = sums->first->x[c] + 0.5 * sums->first->xi[c] + sums->moment[c] / sums->area;
        if (period->is[c]) e.centre[c] -= period->length[c] * floor(e.centre[c] / period->length[c]);
        e.normal[c] = (vector[0][most] < 0 ? -1 : 1) * vector[0][c];
    }
    return e;
}

/* The events of the n bonds of one step; returns how many. */
static long of_step(const struct solid_break *bond, int n, double reach, const struct period *period,
                    struct solid_event *event) {
    int *group = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *group);
    int *number = memory_new(MEMORY_OUTPUT, 2 * (size_t)n, sizeof *number); /* 1 + the event, by cluster */
    struct sums *sums = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *sums);
    int found = 0;
    cluster(bond, n, reach, period, group);
    for (int i = 0; i < n; i++) {
        if (number[group[i]] == 0) number[group[i]] = ++found;
        add(&sums[number[group[i]] - 1], &bond[i], period);
    }
    for (int k = 0; k < found; k++) event[k] = event_of(&sums[k], period);
    MEMORY_FREE(sums, number, group);
    return found;
}

long solid_events_of(const struct solid_break *bond, long n, double reach, const int periodic[3],
                     const double length[3], struct solid_event **event) {
    const struct period period = {periodic, length};
    struct solid_event *list = calloc((size_t)n + 1, sizeof *list);
    long found = 0;
    ENSURE(list, "no memory for %ld events", n);
    for (long from = 0, to; from < n; from = to) {
        for (to = from + 1; to < n && bond[to].step == bond[from].step;) to++;
        ENSURE(to - from < INT_MAX / 2, "%ld bonds broke in step %ld", to - from, bond[from].step);
        found += of_step(bond + from, (int)(to - from), reach, &period, list + found);
    }
    *event = list;
    return found;
}
