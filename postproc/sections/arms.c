/* Section of the report on the arms of a plate's cracks: directions, forks, paths and speeds of the tips. */
#include "base/files/folder.h"
#include "base/arena.h"
#include "base/files/atomic_write.h"
#include "postproc/data/crack_arms.h"
#include "postproc/data/plate.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of so many arms and forks the report has numbers; crack-arms.csv has all. */
enum { ARMS = 12, FORKS = 6 };
/* A particle of the last field belongs to an initial crack if it is nearer to it than this, in spacings. */
static const double BESIDE = 1.6;
/* Least number of spacings that a Rayleigh wave runs in the window of speeds. */
static const double SPACINGS = 10;

/* The damaged particles. */
struct damaged {
    long n;
    double (*x)[2], *t;
    char *initial;
};

static struct damaged damaged_new(long capacity) {
    const size_t n = (size_t)capacity + 1;
    return (struct damaged){0, arena_new(n, sizeof(double[2])), arena_new(n, sizeof(double)), arena_new(n, 1)};
}

/* From crack_particles.csv: those of the first row of crack.csv are an initial crack's. */
static struct damaged damaged_of_run(const struct postproc_history *h) {
    double *t = postproc_history_values(h->particles, "t"), *x = postproc_history_values(h->particles, "x"),
           *y = postproc_history_values(h->particles, "y"), *times = postproc_history_values(h->crack, "t");
    const long rows = t && x && y ? h->particles->rows : 0;
    struct damaged d = damaged_new(rows);
    for (; d.n < rows; d.n++) {
        d.x[d.n][0] = x[d.n];
        d.x[d.n][1] = y[d.n];
        d.t[d.n] = t[d.n];
        d.initial[d.n] = times && h->crack->rows > 0 && t[d.n] <= times[0];
    }
    return d;
}

static int is_beside(const struct scene_solid *s, const double x[2], double reach) {
    for (int c = 0; c < s->cracks; c++)
        for (int k = 0; k + 1 < s->crack[c].points; k++) {
            const double *a = s->crack[c].point[k], *b = s->crack[c].point[k + 1];
            const double e[2] = {b[0] - a[0], b[1] - a[1]}, r[2] = {x[0] - a[0], x[1] - a[1]};
            const double f = fmin(fmax((e[0] * r[0] + e[1] * r[1]) / (e[0] * e[0] + e[1] * e[1]), 0), 1);
            if (hypot(r[0] - f * e[0], r[1] - f * e[1]) <= reach) return 1;
        }
    return 0;
}

/* From the last field, which has no times. */
static struct damaged damaged_of_field(const struct postproc_history *h, const struct postproc_plate *p, double level) {
    struct damaged d = damaged_new(p && p->damage ? p->n : 0);
    for (long i = 0; p && p->damage && i < p->n; i++) {
        if (!(p->damage[i] > level)) continue;
        memcpy(d.x[d.n], p->x[i], sizeof *d.x);
        d.t[d.n] = NAN;
        d.initial[d.n++] = (char)is_beside(h->scene->solid, p->x[i], BESIDE * h->spacing);
    }
    return d;
}

/* What is to be known about an arm's top speed. */
static const char *note_of(const struct postproc_arm *a, double grain) {
    if (a->places == 0) return "unknown: crack_particles.csv is missing";
    if (a->windows == 0) return "not resolved: it advanced in fewer than three places in every window";
    if (a->above > 0) return "above the Rayleigh speed: damage formed ahead of the tip, which is not its way";
    if (a->top < grain) return "below what the grid resolves: a spacing over the window";
    return "resolved";
}

static void fact(struct postproc_facts *f, const char *what, int number, const char *quantity, const char *unit,
                 double value) {
    postproc_facts_number(f, NAMED("%s %d: %s", what, number, quantity), unit, value);
}

static void facts_of_arms(struct postproc_facts *f, const struct postproc_arms *a, double grain) {
    for (int k = 0; k < a->forks && k < FORKS; k++) {
        const struct postproc_fork *g = &a->fork[k];
        fact(f, "fork", k + 1, "ends arm", "1", g->arm + 1);
        fact(f, "fork", k + 1, "x", "m", g->place[0]);
        fact(f, "fork", k + 1, "y", "m", g->place[1]);
        fact(f, "fork", k + 1, "tip passes, t", "s", g->t);
        fact(f, "fork", k + 1, "angle between its arms", "deg", g->angle);
        fact(f, "fork", k + 1, "angle between its arms, uncertainty", "deg", g->error);
    }
    for (int k = 0; k < a->arms && k < ARMS; k++) {
        const struct postproc_arm *m = &a->arm[k];
        char name[96];
        fact(f, "arm", k + 1, "length", "m", m->length);
        fact(f, "arm", k + 1, "direction at first", "deg", m->first.value);
        fact(f, "arm", k + 1, "direction at last", "deg", m->last.value);
        fact(f, "arm", k + 1, "direction at last, uncertainty", "deg", m->last.error);
        fact(f, "arm", k + 1, "mean speed", "m/s", m->speed);
        fact(f, "arm", k + 1, "top speed", "m/s", m->top);
        snprintf(name, sizeof name, "arm %d: top speed is", k + 1);
        postproc_facts_text(f, name, note_of(m, grain));
        if (m->jumps > 0) fact(f, "arm", k + 1, "new fronts ahead of its tip", "1", (double)m->jumps);
        fact(f, "arm", k + 1, "tip at its end, t", "s", m->t_end);
    }
}

/* A number of a table; an empty field for NAN. */
static void put(FILE *file, double value) {
    if (isnan(value))
        fputc(',', file);
    else
        fprintf(file, ",%.9g", value);
}

static int write_arms(const struct postproc_arms *a, double grain, const char *path) {
    FILE *file = atomic_write_open(path);
    if (!file) return -1;
    fputs("arm,parent,alone,begin_x,begin_y,end_x,end_y,length,angle_first,angle_first_error,angle_last,"
          "angle_last_error,begin_t,end_t,speed,top_speed,top_speed_t,windows,windows_above_rayleigh,jumps,top_speed_"
          "is\n",
          file);
    for (int k = 0; k < a->arms; k++) {
        const struct postproc_arm *m = &a->arm[k];
        const double value[] = {m->begin[0],    m->begin[1],    m->end[0],     m->end[1],     m->length,
                                m->first.value, m->first.error, m->last.value, m->last.error, m->t_begin,
                                m->t_end,       m->speed,       m->top,        m->top_t};
        fprintf(file, "%d,%d,%d", k + 1, m->parent + 1, m->alone);
        for (size_t c = 0; c < sizeof value / sizeof *value; c++) put(file, value[c]);
        fprintf(file, ",%ld,%ld,%ld,\"%s\"\n", m->windows, m->above, m->jumps, note_of(m, grain));
    }
    const int bad = ferror(file);
    return atomic_write_close(file, path, bad);
}

static int write_tips(const struct postproc_arms *a, const char *path) {
    FILE *file = atomic_write_open(path);
    if (!file) return -1;
    fputs("arm,t,x,y,speed,jumped\n", file);
    for (int k = 0; k < a->arms; k++)
        for (long i = a->arm[k].first_place; i < a->arm[k].first_place + a->arm[k].places; i++) {
            const struct postproc_place *p = &a->place[i];
            fprintf(file, "%d", k + 1);
            put(file, p->t);
            put(file, p->x[0]);
            put(file, p->x[1]);
            put(file, p->speed);
            fprintf(file, ",%d\n", p->jumped);
        }
    const int bad = ferror(file);
    return atomic_write_close(file, path, bad);
}

void postproc_sections_arms(struct postproc_output *out, const struct postproc_history *h,
                            const struct postproc_plate *last, double level) {
    const struct scene_crack_output *o = h->scene->output.crack;
    const double rayleigh = postproc_history_waves(h).rayleigh;
    struct damaged d = h->particles ? damaged_of_run(h) : damaged_of_field(h, last, level);
    const double side = last ? fmax(last->high[0] - last->low[0], last->high[1] - last->low[1]) : 0;
    const struct postproc_arms_input in = {.n = d.n,
                                           .x = (const double(*)[2])d.x,
                                           .t = d.t,
                                           .initial = d.initial,
                                           .spacing = h->spacing,
                                           .fit = fmax(10 * h->spacing, 0.05 * side),
                                           .window = fmax(o ? o->window : 0, SPACINGS * h->spacing / rayleigh),
                                           .rayleigh = rayleigh};
    struct postproc_arms *a = postproc_crack_arms_of(&in);
    const double grain = postproc_crack_arms_grain(&in);
    char path[FOLDER_PATH];
    if (a->arms > 0) {
        postproc_facts_number(&out->facts, "arms of the cracks", "1", a->arms);
        postproc_facts_number(&out->facts, "forks of the cracks", "1", a->forks);
        if (h->particles) {
            postproc_facts_number(&out->facts, "window of the arms' speeds", "s", in.window);
            postproc_facts_number(&out->facts, "grain of the arms' speeds: spacing over window", "m/s", grain);
        }
        facts_of_arms(&out->facts, a, grain);
        if (out->folder && write_arms(a, grain, folder_path(path, out->folder, "crack-arms.csv")))
            postproc_sections_fail(out, path);
        if (out->folder && h->particles && write_tips(a, folder_path(path, out->folder, "crack-tips.csv")))
            postproc_sections_fail(out, path);
    }
    postproc_crack_arms_free(a);
}
