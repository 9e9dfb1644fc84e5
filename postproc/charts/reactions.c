/* Draws curves of reactions.csv: forces over time, and force over displacement. */
#include "postproc/charts/charts.h"
#include "base/arena.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { CURVES_MAX = 16, TITLE = 96 };

/* The rows of one constraint or load, and its direction: that of its displacement if it is driven, else that of its
 * largest force. */
struct one {
    int is_load, index, axis;
    long n;
    double *t, *force, *displacement; /* [n] s, N, m, along the axis */
};

struct columns {
    const struct table_data *d;
    int t, load, index, force, displacement, dim;
};

static struct columns columns_of(const struct table_data *d) {
    struct columns c = {.d = d};
    if (!d) return c;
    c.t = table_read_column(d, "t");
    c.load = table_read_column(d, "load");
    c.index = table_read_column(d, "index");
    c.force = table_read_column(d, "force_x");
    c.displacement = table_read_column(d, "displacement_x");
    const int whole = c.t >= 0 && c.load >= 0 && c.index >= 0 && c.force >= 0 && c.displacement > c.force;
    c.dim = whole ? c.displacement - c.force : 0;
    return c;
}

static double at(const struct columns *c, long row, int column) { return c->d->value[row * c->d->columns + column]; }

static int is_of(const struct columns *c, long row, const struct one *o) {
    return at(c, row, c->load) == o->is_load && at(c, row, c->index) == o->index;
}

/* The component with the largest value of the columns first ..., over all rows of o; *most is that value. */
static int largest(const struct columns *c, const struct one *o, int first, double *most) {
    int axis = 0;
    *most = 0;
    for (long i = 0; i < c->d->rows; i++)
        for (int k = 0; k < c->dim; k++) {
            const double value = fabs(at(c, i, first + k));
            if (!is_of(c, i, o) || !(value > *most)) continue;
            *most = value;
            axis = k;
        }
    return axis;
}

/* Whether it is a constraint that the scene drives. */
static int is_driven(const struct postproc_history *h, const struct one *o, int axis) {
    const struct scene_solid *s = h->scene->solid;
    if (o->is_load || !s || o->index >= s->constraints) return 0;
    const struct scene_constraint *k = &s->constraint[o->index];
    return k->direction[axis] && (k->has_displacement ? k->displacement[axis] != 0 : k->velocity[axis] != 0);
}

static int one_new(struct one *o, const struct columns *c, const struct postproc_history *h) {
    double displacement, force;
    const int of_force = largest(c, o, c->force, &force),
              of_displacement = largest(c, o, c->displacement, &displacement);
    if (!(force > 0)) return 0;
    const int moves = displacement > 0 && is_driven(h, o, of_displacement);
    o->axis = moves ? of_displacement : of_force;
    o->t = arena_new((size_t)c->d->rows, sizeof *o->t);
    o->force = arena_new((size_t)c->d->rows, sizeof *o->force);
    o->displacement = arena_new((size_t)c->d->rows, sizeof *o->displacement);
    for (long i = 0; i < c->d->rows; i++) {
        if (!is_of(c, i, o)) continue;
        o->t[o->n] = postproc_history_when(h, at(c, i, c->t));
        o->force[o->n] = at(c, i, c->force + o->axis);
        o->displacement[o->n++] = at(c, i, c->displacement + o->axis);
    }
    return 1;
}

/* The opening between two constraints that are driven in opposite directions: displacement of the second less that of
 * the first, force of the second. NULL unless there are just two driven ones and these are. */
static struct one *opening_of(int n, struct one *const *driven) {
    if (n != 2 || driven[0]->axis != driven[1]->axis || driven[0]->n != driven[1]->n || driven[0]->is_load ||
        driven[0]->n == 0)
        return NULL;
    struct one *a = driven[0], *b = driven[1];
    const long last = a->n - 1;
    if (!(a->displacement[last] * b->displacement[last] < 0)) return NULL;
    if (b->displacement[last] < 0) {
        struct one *const first = b;
        b = a;
        a = first;
    }
    for (long i = 0; i < b->n; i++) b->displacement[i] -= a->displacement[i];
    return b;
}

/* Divides the displacements by a unit of length in which they are easy to read, and returns its name. */
static const char *in_unit(int n, struct one *const *o, const char *mm, const char *um) {
    double most = 0;
    for (int k = 0; k < n; k++)
        for (long i = 0; i < o[k]->n; i++) most = fmax(most, fabs(o[k]->displacement[i]));
    const double unit = most < 1e-4 ? 1e-6 : 1e-3;
    for (int k = 0; k < n; k++)
        for (long i = 0; i < o[k]->n; i++) o[k]->displacement[i] /= unit;
    return unit < 1e-3 ? um : mm;
}

static void title_of(char title[TITLE], const struct one *o) {
    snprintf(title, TITLE, "%s %d, %c", o->is_load ? "load" : "constraint", o->index, "xyz"[o->axis]);
}

void postproc_charts_reactions_draw(struct postproc_charts *charts, const struct postproc_history *h,
                                    const char *folder) {
    const struct columns c = columns_of(h->reactions);
    struct one one[CURVES_MAX] = {{0}}, *driven[CURVES_MAX];
    struct postproc_curve curve[CURVES_MAX];
    char title[CURVES_MAX][TITLE];
    int n = 0, moving = 0;
    for (long i = 0; c.dim > 0 && i < c.d->rows && n < CURVES_MAX; i++) { /* those of the first sample */
        if (at(&c, i, c.t) > at(&c, 0, c.t)) break;
        one[n] = (struct one){.is_load = at(&c, i, c.load) != 0, .index = (int)at(&c, i, c.index)};
        n += one_new(&one[n], &c, h);
    }
    for (int k = 0; k < n; k++) {
        title_of(title[k], &one[k]);
        curve[k] = (struct postproc_curve){.title = title[k], .n = one[k].n, .x = one[k].t, .y = one[k].force};
        if (is_driven(h, &one[k], one[k].axis)) driven[moving++] = &one[k];
    }
    for (int k = 0; k < n && (moving == 0 || driven[0]->is_load); k++) /* where nothing is driven, the loads */
        if (one[k].is_load) driven[moving++] = &one[k];
    struct postproc_plot plot = {.folder = folder,
                                 .name = "reactions",
                                 .title = "Forces of constraints and loads on the solid",
                                 .xlabel = postproc_history_when_name(h),
                                 .ylabel = "force  [N]",
                                 .curves = n > 0 && one[0].n > 1 ? n : 0,
                                 .curve = curve};
    postproc_charts_add(charts, &plot);
    struct one *opening = opening_of(moving, driven);
    if (opening) driven[0] = opening;
    const int curves = opening ? 1 : moving;
    for (int k = 0; k < curves; k++) {
        title_of(title[k], driven[k]);
        curve[k] = (struct postproc_curve){
            .title = title[k], .n = driven[k]->n, .x = driven[k]->displacement, .y = driven[k]->force};
    }
    plot.name = "load_displacement";
    plot.title = opening ? "Load against opening" : "Load against displacement";
    plot.xlabel = opening ? in_unit(curves, driven, "opening  [mm]", "opening  [{/Symbol m}m]")
                          : in_unit(curves, driven, "mean displacement  [mm]", "mean displacement  [{/Symbol m}m]");
    plot.ylabel = "force on the solid  [N]";
    plot.curves = curves > 0 && driven[0]->n > 1 ? curves : 0;
    postproc_charts_add(charts, &plot);
}
