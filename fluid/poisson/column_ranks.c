/* Couples the pieces of columns along z that ranks hold, in one level or in two. */
#include "fluid/poisson/column_ranks.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_column.h"
#include "base/par_piece.h"
#include "fluid/poisson/column.h"
#include "fluid/poisson/column_ends.h"

#include <math.h>
#include <stdlib.h>

/* Powers of r below this are set to 0, so that none is denormal. */
static const double smallest = 1e-290;

/* Up to so many ranks along z are coupled in one level. */
enum { ONE_LEVEL = 8 };

/* The coupling of pieces, each of one rank or of a group of ranks. */
struct level {
    struct par_column *exchange; /* NULL: this rank takes no part in it */
    int parts;
    int *plane;                   /* [parts + 1] first planes of the pieces */
    int own, own_low;             /* the columns that are coupled here */
    double *decay, *feel, *place; /* [parts][own] r^m, r^2 + .. + r^2m, r^(planes of the parts below) */
    double *share;                /* [parts][2][own] */
};

struct fluid_column_ranks {
    struct fluid_column_input in;
    int at;                         /* this rank's place along z */
    struct level group, all;        /* the ranks of this rank's group, if there are groups; the groups, or all ranks */
    double *sum[2];                 /* [group.own] Y and S of the group; then y below and q above it */
    struct fluid_column_ends *ends; /* [all.own] */
};

static double *array(size_t count) { return memory_new(MEMORY_FLUID, count + 1, sizeof(double)); }

/* exp(-theta n), flushed to zero. */
static double power_of(double theta, int n) {
    const double p = exp(-theta * n);
    return p < smallest ? 0 : p;
}

static int low_of(const struct fluid_column_ranks *c, int place) {
    return c->in.cut ? c->in.cut[place] : par_piece_low(c->in.n, c->in.ranks[2], place);
}

/* place [parts + 1]: the places along z at which the parts begin; those that exchange stand `at` places further up. */
static void make(const struct fluid_column_ranks *c, struct level *l, int parts, const int *place, int at,
                 const struct par_column_input *how) {
    struct par_column_input in = *how;
    int *rank = malloc((size_t)parts * sizeof *rank);
    l->parts = parts;
    l->plane = calloc((size_t)parts + 1, sizeof *l->plane);
    for (int p = 0; p <= parts; p++) l->plane[p] = low_of(c, place[p]);
    for (int p = 0; p < parts; p++) rank[p] = par_rank() % c->in.ranks[1] + (place[p] + at) * c->in.ranks[1];
    in.parts = parts;
    in.rank = rank;
    in.values = 2;
    l->exchange = par_column_new(&in);
    par_column_own(l->exchange, &l->own_low, &l->own);
    const size_t size = (size_t)parts * (size_t)l->own;
    l->decay = array(size);
    l->feel = array(size);
    l->place = array(size);
    l->share = array(2 * size);
    free(rank);
}

static int groups_of(const struct fluid_column_input *in) {
    const int parts = in->ranks[2];
    if (in->groups > 0) return in->groups < parts ? in->groups : parts;
    return parts <= ONE_LEVEL ? 1 : (int)lround(sqrt(parts));
}

struct fluid_column_ranks *fluid_column_ranks_new(const struct fluid_column_input *in) {
    struct fluid_column_ranks *c = calloc(1, sizeof *c);
    const int parts = in->ranks[2], groups = groups_of(in);
    int *place = malloc((size_t)(parts + 1) * sizeof *place), *first = malloc((size_t)(groups + 1) * sizeof *first);
    c->in = *in;
    c->in.lambda = NULL;
    c->at = par_rank() / in->ranks[1];
    for (int p = 0; p <= parts; p++) place[p] = p;
    for (int g = 0; g <= groups; g++) first[g] = par_piece_low(parts, groups, g);
    if (groups == 1) {
        make(c, &c->all, parts, place, 0,
             &(struct par_column_input){
                 .place = c->at, .owners = parts, .columns = in->columns, .work = in->work, .capacity = in->capacity});
    } else {
        /* Groups differ by one rank at most: the last of a larger group couples no columns. */
        const int g = par_piece_of(first, groups, c->at), owners = parts / groups, at = c->at - first[g];
        make(c, &c->group, first[g + 1] - first[g], place + first[g], 0,
             &(struct par_column_input){.place = at, .owners = owners, .columns = in->columns});
        if (at < owners)
            make(c, &c->all, groups, first, at,
                 &(struct par_column_input){.place = g, .owners = groups, .columns = c->group.own});
        for (int v = 0; v < 2; v++) c->sum[v] = array((size_t)c->group.own);
    }
    c->ends = memory_new(MEMORY_FLUID, (size_t)c->all.own + 1, sizeof *c->ends);
    free(place);
    free(first);
    return c;
}

void fluid_column_ranks_free(struct fluid_column_ranks *c) {
    if (!c) return;
    for (struct level *l = &c->group; l; l = l == &c->group ? &c->all : NULL) {
        MEMORY_FREE(l->decay, l->feel, l->place, l->share);
        free(l->plane);
        par_column_free(l->exchange);
    }
    MEMORY_FREE(c->sum[0], c->sum[1], c->ends);
    free(c);
}

void fluid_column_ranks_planes(const struct fluid_column_ranks *c, int *low, int *m) {
    *low = low_of(c, c->at);
    *m = low_of(c, c->at + 1) - *low;
}

static void set(struct level *l, const double *lambda, double shift, double d) {
    for (int i = 0; i < l->own; i++) {
        const double theta = fluid_column_ends_theta(lambda[i] - shift, d), r = exp(-theta);
        for (int p = 0; p < l->parts; p++) {
            const int low = l->plane[p] - l->plane[0], m = l->plane[p + 1] - l->plane[p];
            l->decay[p * l->own + i] = power_of(theta, m);
            l->feel[p * l->own + i] = r * r * fluid_column_ends_ratio(2.0 * m, 2, theta);
            l->place[p * l->own + i] = power_of(theta, low);
        }
    }
}

void fluid_column_ranks_set(struct fluid_column_ranks *c, const double *lambda, double shift) {
    const double *of_group = lambda + c->group.own_low, *own = of_group + c->all.own_low;
    set(&c->group, of_group, shift, c->in.d);
    set(&c->all, own, shift, c->in.d);
    for (int i = 0; i < c->all.own; i++)
        c->ends[i] =
            fluid_column_ends_close(c->in.n, fluid_column_ends_theta(own[i] - shift, c->in.d), c->in.low, c->in.high);
}

/* Column i, up through the parts and down, from y = 0 and q = 0. The last y of a part becomes the y below it; y and q:
 * at the end. */
static void join(const struct level *l, int i, double *y_above, double *q_below) {
    const int own = l->own;
    double y = 0, q = 0;
    for (int p = 0; p < l->parts; p++) {
        double *about = l->share + 2 * p * own + i;
        const double top = about[0];
        about[0] = y;
        y = l->decay[p * own + i] * y + top;
    }
    for (int p = l->parts - 1; p >= 0; p--) {
        const double *about = l->share + 2 * p * own + i;
        q = l->decay[p * own + i] * q - about[own] - l->feel[p * own + i] * about[0];
    }
    *y_above = y;
    *q_below = q;
}

/* From the true y below all parts and q above them to those of each part. */
static void spread(const struct level *l, int i, double y_below, double q) {
    const int own = l->own;
    for (int p = l->parts - 1; p >= 0; p--) {
        double *about = l->share + 2 * p * own + i;
        const double sum = about[own], below = about[0] + l->place[p * own + i] * y_below;
        about[0] = below;
        about[own] = q;
        q = l->decay[p * own + i] * q - sum - l->feel[p * own + i] * below;
    }
}

/* The parts of the upper level, closed by the end conditions. */
static void couple(struct fluid_column_ranks *c, const double *const known[2], double *const found[2]) {
    if (!c->all.exchange) return;
    par_column_share(c->all.exchange, known, c->all.share);
    for (int i = 0; i < c->all.own; i++) {
        const struct fluid_column_ends *e = &c->ends[i];
        double y, q;
        join(&c->all, i, &y, &q);
        spread(&c->all, i, e->y_by_y * y - e->y_by_s * q, e->q_by_y * y - e->q_by_s * q);
    }
    par_column_return(c->all.exchange, c->all.share, found);
}

void fluid_column_ranks_couple(struct fluid_column_ranks *c, const double *const known[2], double *const found[2]) {
    struct level *l = &c->group;
    if (!l->exchange) {
        couple(c, known, found);
        return;
    }
    par_column_share(l->exchange, known, l->share);
    for (int i = 0; i < l->own; i++) {
        double q;
        join(l, i, &c->sum[0][i], &q);
        c->sum[1][i] = -q;
    }
    couple(c, (const double *const *)c->sum, c->sum);
    for (int i = 0; i < l->own; i++) spread(l, i, c->sum[0][i], c->sum[1][i]);
    par_column_return(l->exchange, l->share, found);
}
