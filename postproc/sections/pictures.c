/* Section of the report with pictures and a film of space: the solid, the flow, and both. */
#include "base/memory.h"
#include "base/sort.h"
#include "base/files/folder.h"
#include "postproc/data/flow_lines.h"
#include "postproc/data/slice.h"
#include "postproc/draw/picture.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>

enum solid_value { PLAIN, DAMAGE, DISPLACEMENT };
enum flow_value { NO_FLOW, LINES, SPEED, PRESSURE };
enum { SEEDS = 160 };

static const struct view {
    const char *name, *title, *caption;
    double toward[3];
    enum solid_value solid; /* PLAIN: drawn only if the solid has no damage */
    enum flow_value flow;   /* with a flow the solid is coloured by damage, if it has one */
    int section;            /* 1: the half nearer to the camera than the middle plane of z is cut away */
} views[] = {
    {"flow_lines", "Streamlines, with the solid", "streamlines", {0.55, 0.5, 1.25}, PLAIN, LINES, 0},
    {"flow_speed", "Speed on the middle plane", "speed", {0.45, 0.4, 1.25}, PLAIN, SPEED, 1},
    {"flow_pressure", "Pressure on the middle plane", "pressure", {0.45, 0.4, 1.25}, PLAIN, PRESSURE, 1},
    {"solid_back", "The solid, from downstream", "from downstream", {1, 0.5, 1.25}, PLAIN, NO_FLOW, 0},
    {"damage_back", "Damage, from downstream", "from downstream", {1, 0.5, 1.25}, DAMAGE, NO_FLOW, 0},
    {"damage_front", "Damage, from upstream", "from upstream", {-1, 0.5, 1.25}, DAMAGE, NO_FLOW, 0},
    {"damage_section",
     "Damage, cut along the middle",
     "cut along the middle plane",
     {0.45, 0.4, 1.25},
     DAMAGE,
     NO_FLOW,
     1},
    {"displacement_back", "Displacement, from downstream", "from downstream", {1, 0.5, 1.25}, DISPLACEMENT, NO_FLOW, 0},
};
enum { VIEWS = sizeof views / sizeof *views };

/* What is there at one time; each part may be missing. */
struct snapshot {
    double time;
    long step;
    struct postproc_body *body;
    struct postproc_flow *flow;
    struct postproc_stream lines;
    struct postproc_slice *slice[3];
    /* bounds of the colours; of the planes only: pressure and planar; displacement: the upper one, m */
    double speed[2], planar[2], pressure[2], displacement;
};

/* The 98 % quantile over the particles that have bonds, so that a few ejected particles do not set the colours. 0
 * without such particles. */
static double colour_bound(const struct postproc_body *b, const double *value) {
    long m;
    double *sorted = postproc_body_sample(b, value, &m);
    sort_ascending(sorted, (size_t)m);
    const double bound = m ? sorted[(long)(0.98 * (double)(m - 1))] : 0;
    memory_free(sorted);
    return bound;
}

/* |d| of every particle. */
static double *lengths(const struct postproc_body *b) {
    const double *d = b->displacement;
    double *value = memory_new(MEMORY_OUTPUT, (size_t)b->n + 1, sizeof *value);
    for (long i = 0; i < b->n; i++)
        value[i] = sqrt(d[3 * i] * d[3 * i] + d[3 * i + 1] * d[3 * i + 1] + d[3 * i + 2] * d[3 * i + 2]);
    return value;
}

static double displacement_bound(const struct postproc_body *b) {
    if (!b->displacement) return 0;
    double *value = lengths(b), largest = 0, bound = colour_bound(b, value);
    for (long i = 0; i < b->n; i++) largest = fmax(largest, value[i]);
    memory_free(value);
    return bound > 0 ? bound : largest > 0 ? largest : 1;
}

static void bounds_of(struct snapshot *m) {
    m->pressure[0] = INFINITY;
    m->pressure[1] = -INFINITY;
    for (int a = 0; a < 3; a++) {
        const struct postproc_slice *s = m->slice[a];
        if (!s) continue;
        m->planar[1] = fmax(m->planar[1], postproc_slice_quantile(s, s->speed, 0.999));
        if (!s->pressure) continue;
        m->pressure[0] = fmin(m->pressure[0], postproc_slice_quantile(s, s->pressure, 0.01));
        m->pressure[1] = fmax(m->pressure[1], postproc_slice_quantile(s, s->pressure, 0.99));
    }
    m->speed[1] = m->flow ? m->flow->bound : 0;
    m->displacement = m->body ? displacement_bound(m->body) : 0;
}

static struct snapshot snapshot_new(const struct postproc_history *h, int k) {
    struct snapshot m = {0};
    const struct postproc_fields *leading = h->fluid.n ? &h->fluid : &h->solid;
    const double t = leading->entry[k].time;
    if (h->solid.n && h->spacing > 0) m.body = postproc_body_new(h, t);
    if (m.body && (!m.body->x || m.body->n == 0)) {
        postproc_body_free(m.body);
        m.body = NULL;
    }
    if (h->fluid.n) m.flow = postproc_flow_new(h, k);
    if (m.flow) m.lines = postproc_flow_lines_new(m.flow, SEEDS);
    for (int a = 0; m.flow && a < 3; a++)
        if (a == 2 || !m.body) m.slice[a] = postproc_slice_new(h, k, a, NAN);
    m.time = m.body ? m.body->time : m.flow ? m.flow->time : t;
    m.step = m.body ? m.body->step : m.flow ? m.flow->step : 0;
    bounds_of(&m);
    return m;
}

static void snapshot_free(struct snapshot *m) {
    postproc_body_free(m->body);
    postproc_flow_free(m->flow);
    postproc_stream_free(&m->lines);
    for (int a = 0; a < 3; a++) postproc_slice_free(m->slice[a]);
}

/* Whether there is what the view shows. */
static int is_there(const struct view *v, const struct snapshot *m) {
    const struct postproc_body *b = m->body;
    switch (v->flow) {
    case NO_FLOW:
        break;
    case LINES:
        return m->lines.lines > 0;
    case SPEED:
        return m->slice[2] && m->planar[1] > 0;
    case PRESSURE:
        return m->slice[2] && m->pressure[1] > m->pressure[0] + 1e-9 * fabs(m->pressure[1]);
    }
    switch (v->solid) {
    case PLAIN:
        return b && !b->damage;
    case DAMAGE:
        return b && b->damage;
    case DISPLACEMENT:
        break;
    }
    return b && b->displacement;
}

/* The solid of a view; values that are made for it are returned, by memory_new. */
static double *solid_of(struct postproc_picture *p, const struct postproc_history *h, const struct view *v,
                        const struct snapshot *m, const struct snapshot *colours) {
    const struct postproc_body *b = m->body;
    double *made = NULL;
    if (!b) return NULL;
    p->n = b->n;
    p->x = (const double(*)[3])b->x;
    p->size = h->spacing;
    for (int k = 0; k < 3; k++) { /* particles farther from the domain than its size are ignored */
        p->low[k] = -0.1 * p->domain[k];
        p->high[k] = 1.1 * p->domain[k];
    }
    if (v->section) p->high[2] = m->slice[2] ? m->slice[2]->place + 0.5 * m->flow->d[2] : 0.5 * p->domain[2];
    if (v->solid == DISPLACEMENT) {
        p->value = made = lengths(b);
        p->value_high = colours->displacement;
        p->label = "|d|  [m]";
        p->map = POSTPROC_VIRIDIS;
    } else if (b->damage) {
        p->value = b->damage;
        p->value_high = 1;
        p->label = "damage";
        p->map = POSTPROC_MAGMA_REVERSED;
    }
    return made;
}

static void flow_of(struct postproc_picture *p, struct postproc_plane plane[3], const struct view *v,
                    const struct snapshot *m, const struct snapshot *colours) {
    const int pressure = v->flow == PRESSURE;
    double limit[2];
    for (int k = 0; k < 2; k++)
        limit[k] = pressure ? colours->pressure[k] : v->flow == LINES ? colours->speed[k] : colours->planar[k];
    p->flow_map = postproc_sections_map(limit);
    p->flow_low = limit[0];
    p->flow_high = limit[1];
    p->flow_label = pressure ? "p  [Pa]" : "|u|  [m/s]";
    if (v->flow == LINES) p->stream = &m->lines;
    for (int a = 0; a < 3 && v->flow != LINES; a++) {
        const struct postproc_slice *s = m->slice[a];
        if (!s) continue; /* of a solid that is cut, only the plane of the cut */
        plane[p->planes++] = (struct postproc_plane){.axis = a,
                                                     .place = m->body ? s->place + 0.5 * m->flow->d[a] : s->place,
                                                     .n = {s->n[0], s->n[1]},
                                                     .d = {s->d[0], s->d[1]},
                                                     .value = pressure ? s->pressure : s->speed};
    }
    p->plane = plane;
}

/* colours: the snapshot whose bounds the colours have. */
static void view_draw(struct postproc_output *out, const struct postproc_history *h, const struct view *v,
                      const struct snapshot *m, const struct snapshot *colours, const char *inside, const char *name) {
    char folder[FOLDER_PATH], subtitle[256], when[64];
    struct postproc_plane plane[3];
    postproc_sections_when(h, m->time, when);
    snprintf(subtitle, sizeof subtitle, "%s%s%s, step %ld, %s", when, h->stage[0] ? " from the start of stage " : "",
             h->stage, m->step, v->caption);
    struct postproc_picture p = {.folder = folder_path(folder, out->folder, inside),
                                 .name = name,
                                 .all = m == colours,
                                 .title = h->scene->title,
                                 .subtitle = subtitle,
                                 .through = 0.5,
                                 .width = out->options.width,
                                 .height = out->options.width * 9 / 14};
    for (int k = 0; k < 3; k++) {
        p.domain[k] = h->scene->domain.size[k];
        p.toward[k] = v->toward[k];
        if (m->flow && m->flow->fastest > 0) p.flow[k] = m->flow->mean[k];
    }
    double *made = solid_of(&p, h, v, m, colours);
    if (v->flow != NO_FLOW) flow_of(&p, plane, v, m, colours);
    if (postproc_picture_draw(&p)) postproc_sections_fail(out, folder);
    memory_free(made);
}

/* The view of a film's quantity: the first that shows it. NULL: none does. */
static const struct view *film_view(const struct postproc_output *out, const struct snapshot *last) {
    const int flows = last->flow && last->flow->fastest > 0, damaged = last->body && last->body->damage;
    const enum postproc_quantity q = out->options.film_named ? out->options.film_quantity
                                     : flows                 ? POSTPROC_FLOW
                                                             : POSTPROC_DAMAGE;
    enum flow_value flow = NO_FLOW;
    switch (q) {
    case POSTPROC_DAMAGE:
        break;
    case POSTPROC_FLOW:
        flow = LINES;
        break;
    case POSTPROC_SPEED:
        flow = SPEED;
        break;
    case POSTPROC_PRESSURE:
        flow = PRESSURE;
        break;
    case POSTPROC_STRETCH:
    case POSTPROC_ENERGY:
    case POSTPROC_DISPLACEMENT_X:
    case POSTPROC_DISPLACEMENT_Y:
    case POSTPROC_APERTURE:
    case POSTPROC_CRACK_PRESSURE:
    case POSTPROC_QUANTITIES:
        return NULL; /* of plates, or of cracks with fluid (sections/crack_fluid.c) */
    }
    const enum solid_value solid = flow == NO_FLOW && damaged ? DAMAGE : PLAIN;
    for (int k = 0; k < VIEWS; k++)
        if (views[k].flow == flow && views[k].solid == solid) return &views[k];
    return NULL;
}

/* One picture for each field file, with the colours of the last one: film/NAME_0001.png, 0002 ... */
static void film(struct postproc_output *out, const struct postproc_history *h, int files,
                 const struct snapshot *last) {
    const struct view *v = film_view(out, last);
    for (int k = 0, frame = 1; v && k < files; k++) {
        struct snapshot m = snapshot_new(h, k);
        char name[64];
        snprintf(name, sizeof name, "%s_%04d", v->name, frame);
        if ((v->flow == NO_FLOW ? m.body != NULL : m.flow != NULL) && is_there(v, last)) {
            view_draw(out, h, v, &m, last, "film", name);
            out->frames = frame++;
            snprintf(out->film, sizeof out->film, "%s", v->name);
            snprintf(out->film_title, sizeof out->film_title, "%s", v->title);
        }
        snapshot_free(&m);
    }
}

/* Of the streamlines that cross the medium from end to end. */
static void tortuosity(struct postproc_output *out, const struct postproc_history *h, const struct snapshot *m) {
    double low[3], high[3], *mean = m->flow->mean;
    const int yz = fabs(mean[2]) > fabs(mean[1]) ? 2 : 1, axis = fabs(mean[yz]) > fabs(mean[0]) ? yz : 0;
    postproc_body_box(h, m->body, low, high);
    const double d = m->flow->d[axis], from = fmax(low[axis], 2e-3 * d), /* seeds are inside */
        to = fmin(high[axis], (m->flow->n[axis] - 2e-3) * d);
    postproc_facts_number(&out->facts, "tortuosity by streamlines", "1",
                          postproc_stream_tortuosity(&m->lines, axis, from, to));
}

void postproc_sections_pictures(struct postproc_output *out, const struct postproc_history *h) {
    const int files = h->fluid.n ? h->fluid.n : h->solid.n;
    if (h->scene->dimension == 2 || files == 0) return; /* of plates: sections/plate.c */
    struct snapshot last = snapshot_new(h, files - 1);
    if (last.lines.lines && last.body) tortuosity(out, h, &last);
    for (int k = 0; k < VIEWS; k++) {
        if (!is_there(&views[k], &last)) continue;
        const int failed = out->failed;
        view_draw(out, h, &views[k], &last, &last, "pictures", views[k].name);
        if (out->failed == failed) postproc_sections_picture(out, views[k].name, views[k].title);
    }
    if (out->options.film) film(out, h, files, &last);
    snapshot_free(&last);
}
