/* Finds the branching of a crack in a damage field and the angles of its branches. */
#include "base/memory.h"
#include "postproc/data/crack_shape.h"

#include <math.h>
#include <stdlib.h>

enum { LEFT, RIGHT };
/* Columns without branches that are tolerated in between; nodes of distance that branches must reach somewhere. */
enum { MISSING = 2, APART = 3, LEAST = 4 };

/* The damaged nodes of a column: the outermost runs of nodes. */
struct column {
    int runs;
    double left, right; /* centres of the uppermost and of the lowest run, weighted by damage, m */
    int gap;            /* the largest number of undamaged nodes between two runs */
};

static struct column column_of(const struct postproc_grid *g, int i) {
    struct column c = {0, NAN, NAN, 0};
    double weight = 0, moment = 0;
    int last = -1;
    for (int j = 0; j < g->n[1]; j++) {
        const double value = postproc_grid_value(g, i, j);
        if (isnan(value)) continue;
        if (c.runs == 0 || j > last + 1) {
            if (c.runs > 0) c.gap = c.gap > j - last - 1 ? c.gap : j - last - 1;
            c.runs++;
            weight = moment = 0;
        }
        weight += value;
        moment += value * (g->origin[1] + j * g->h);
        c.left = moment / weight;
        if (c.runs == 1) c.right = c.left;
        last = j;
    }
    return c;
}

/* The longest range of columns with several runs, with a few columns missing; 0: there is none. */
static int longest(const struct column *c, int n, int *first, int *last) {
    int best = 0;
    for (int a = 0; a < n; a++) {
        if (c[a].runs < 2) continue;
        int b = a;
        for (int i = a; i < n && i <= b + 1 + MISSING; i++)
            if (c[i].runs >= 2) b = i;
        if (b - a + 1 > best) {
            best = b - a + 1;
            *first = a;
            *last = b;
        }
        a = b;
    }
    return best >= LEAST;
}

struct line {
    int n;
    double (*x)[2]; /* [n] along, across, m */
};

static void put(struct line *l, double s, double t) {
    l->x[l->n][0] = s;
    l->x[l->n++][1] = t;
}

/* Slope of a straight line through the points with low <= along <= high, as an angle.  (least squares) */
static struct postproc_angle fit(const struct line *l, double low, double high, double sign) {
    double n = 0, s = 0, t = 0, ss = 0, st = 0, rest = 0;
    for (int k = 0; k < l->n; k++) {
        if (l->x[k][0] < low || l->x[k][0] > high) continue;
        n++;
        s += l->x[k][0];
        t += l->x[k][1];
    }
    s /= n;
    t /= n;
    for (int k = 0; k < l->n; k++) {
        if (l->x[k][0] < low || l->x[k][0] > high) continue;
        ss += (l->x[k][0] - s) * (l->x[k][0] - s);
        st += (l->x[k][0] - s) * (l->x[k][1] - t);
    }
    if (n < 3) return (struct postproc_angle){NAN, NAN};
    const double slope = st / ss;
    for (int k = 0; k < l->n; k++)
        if (l->x[k][0] >= low && l->x[k][0] <= high) rest += pow(l->x[k][1] - t - slope * (l->x[k][0] - s), 2);
    const double error = sqrt(rest / (n - 2) / ss);
    return (struct postproc_angle){sign * atan(slope) * 180 / M_PI, 2 * error / (1 + slope * slope) * 180 / M_PI};
}

/* Centre lines of both branches from column a to b; the longer branch is followed beyond b. */
static void follow(const struct postproc_grid *g, const struct column *c, int a, int b, struct line line[2]) {
    for (int i = a; i <= b; i++) {
        if (c[i].runs < 2) continue;
        put(&line[LEFT], g->origin[0] + i * g->h, c[i].left);
        put(&line[RIGHT], g->origin[0] + i * g->h, c[i].right);
    }
    for (int i = b + 1, missed = 0; i < g->n[0] && missed <= MISSING; i++, missed++) {
        if (c[i].runs == 0) continue;
        for (int side = 0; side < 2; side++) {
            const double t = side == LEFT ? c[i].left : c[i].right, *own = line[side].x[line[side].n - 1],
                         *other = line[1 - side].x[line[1 - side].n - 1];
            if (fabs(t - own[1]) > fabs(t - other[1]) || fabs(t - own[1]) > APART * g->h * (missed + 1)) continue;
            put(&line[side], g->origin[0] + i * g->h, t);
            missed = -1;
        }
    }
}

struct postproc_branching postproc_crack_branch_of(const struct postproc_grid *g, double length) {
    struct postproc_branching out = {0};
    struct column *c = memory_new(MEMORY_OUTPUT, (size_t)g->n[0] + 1, sizeof *c);
    for (int i = 0; i < g->n[0]; i++) c[i] = column_of(g, i);
    int a = 0, b = 0, widest = 0;
    out.found = longest(c, g->n[0], &a, &b);
    for (int i = a; i <= b; i++) widest = widest > c[i].gap ? widest : c[i].gap;
    if (!out.found || widest <= APART || a == 0 || c[a - 1].runs == 0) { /* without a stem, these are two cracks */
        out.found = 0;
        memory_free(c);
        return out;
    }
    out.place[0] = g->origin[0] + a * g->h;
    out.place[1] = c[a - 1].left;
    struct line line[2];
    for (int side = 0; side < 2; side++)
        line[side] = (struct line){.x = memory_new(MEMORY_OUTPUT, (size_t)g->n[0] + 1, sizeof *line->x)};
    follow(g, c, a, b, line);
    for (int side = 0; side < 2; side++) {
        const struct line *l = &line[side];
        const double sign = side == LEFT ? 1 : -1, from = l->x[0][0], to = l->x[l->n - 1][0];
        out.side[side].first = fit(l, from, from + length * (1 + 1e-9), sign);
        out.side[side].last = fit(l, to - length * (1 + 1e-9), to, sign);
        for (int k = 0; k < 2; k++) out.side[side].end[k] = l->x[l->n - 1][k];
        memory_free(l->x);
    }
    memory_free(c);
    return out;
}
