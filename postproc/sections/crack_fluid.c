/* Section of the report on fluid in cracks below the grid: the injection's record, pictures and film of aperture and
 * pressure. */
#include "base/memory.h"
#include "base/sort.h"
#include "base/files/folder.h"
#include "postproc/charts/injection.h"
#include "postproc/data/injection.h"
#include "postproc/data/crack_fluid.h"
#include "postproc/draw/plate_picture.h"
#include "postproc/draw/legend.h"
#include "postproc/sections/sections.h"
#include "scene/notch.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The share of the particles whose values are within the colours. */
#define SPREAD 0.995

static void add_moment(struct postproc_facts *f, const char *name, const struct postproc_instant *m) {
    postproc_facts_number(f, name, "Pa", m->pressure);
    postproc_facts_number(f, NAMED("%s, t", name), "s", m->t);
}

static void add_regime(struct postproc_facts *f, const struct postproc_history *h, double speed) {
    struct scene_notch notch;
    if (scene_notch_of(h->scene, &notch)) {
        postproc_facts_number(f,
                              notch.in.shape == PHYSICS_KGD ? "dimensionless toughness K'/(mu' E'^3 Q0)^(1/4)"
                                                            : "dimensionless toughness as the notch begins to grow",
                              "1", notch.number);
        postproc_facts_text(f, "regime", scene_notch_regime(&notch));
    }
    const struct scene_solid *s = h->scene->solid;
    const struct scene_material *m = &s->material[s->body[0].material_index];
    postproc_facts_number(f, "speed of the tips over five spacings, largest", "m/s", speed);
    postproc_facts_number(f, "the same over sqrt(E/rho)", "1", speed / sqrt(m->youngs_modulus / m->density));
}

/* The largest of a column. */
static double largest_of(const struct postproc_history *h, const char *column) {
    double *y = postproc_history_column(h, column), most = NAN;
    for (long i = 0; y && i < h->series->rows; i++) most = fmax(most, fabs(y[i]));
    return most;
}

void postproc_sections_crack_fluid_numbers(struct postproc_output *out, const struct postproc_history *h) {
    struct postproc_facts *f = &out->facts;
    if (!h->scene->crack_fluid || !h->series || h->series->rows == 0) return;
    struct postproc_injection in = postproc_injection_new(h, postproc_crack_fluid_least_aperture(h));
    postproc_facts_number(f, "injection pressure, largest", "Pa", largest_of(h, "injection_pressure"));
    add_moment(f, "pressure as the first bond broke", &in.first);
    add_moment(f, "breakdown pressure", &in.breakdown);
    add_moment(f, "shut-in pressure", &in.shut_in);
    add_moment(f, "closure pressure", &in.closure);
    static const struct {
        const char *column, *name, *unit;
    } last[] = {{"injected_volume", "injected volume", "m3"},
                {"crack_volume", "volume of the cracks", "m3"},
                {"cavity_volume", "void in the cracks", "m3"},
                {"leaked_volume", "leaked volume", "m3"},
                {"crack_area_wet", "area of the cracks, notch included", "m2"},
                {"aperture_mean", "aperture, mean", "m"},
                {"aperture_max", "aperture, largest", "m"}};
    for (size_t k = 0; k < sizeof last / sizeof *last; k++)
        postproc_facts_number(f, last[k].name, last[k].unit, postproc_history_value(h, last[k].column, h->end));
    postproc_facts_number(f, "error of the volumes over the injected one", "1",
                          largest_of(h, "volume_residual") / largest_of(h, "injected_volume"));
    add_regime(f, h, in.speed);
}

/* What the band of particles with broken bonds conducts. */
static void add_band(struct postproc_facts *f, const struct postproc_crack_fluid *w) {
    if (!(w->area > 0)) return;
    postproc_facts_number(f, "field of the pictures of the cracks, t", "s", w->plate.time);
    postproc_facts_number(f, "band of broken bonds, thickness", "m", w->volume / w->area);
    postproc_facts_number(f, "band of broken bonds, permeability along the crack", "m2", w->conductive / w->volume);
    postproc_facts_number(f, "hydraulic aperture", "m", cbrt(12 * w->conductive / w->area));
}

static void draw_injection(struct postproc_output *out, const struct postproc_history *h) {
    struct postproc_charts *charts = &out->charts;
    struct postproc_injection in = postproc_injection_new(h, postproc_crack_fluid_least_aperture(h));
    if (in.n < 2 || charts->n == POSTPROC_CHARTS) {
        return;
    }
    char folder[FOLDER_PATH], label[3][64];
    const struct {
        const char *name;
        struct postproc_instant at;
    } all[3] = {{"breakdown", in.breakdown}, {"shut-in", in.shut_in}, {"closure", in.closure}};
    struct postproc_mark mark[3];
    int marks = 0;
    for (int k = 0; k < 3; k++) {
        if (isnan(all[k].at.t)) continue;
        snprintf(label[marks], sizeof *label, "%s: %.3g MPa", all[k].name, 1e-6 * all[k].at.pressure);
        mark[marks] = (struct postproc_mark){postproc_history_when(h, all[k].at.t), label[marks]};
        marks++;
    }
    for (long i = 0; i < in.n; i++) in.t[i] = postproc_history_when(h, in.t[i]);
    static const char name[] = "injection", title[] = "Pressure and rate of the injection";
    const enum postproc_plot_status status = postproc_injection_draw(
        &(struct postproc_injection_plot){.folder = folder_path(folder, out->folder, "plots"),
                                          .name = name,
                                          .title = title,
                                          .time = postproc_history_when_name(h),
                                          .n = in.n,
                                          .when = in.t,
                                          .pressure = in.pressure,
                                          .rate = in.rate,
                                          .marks = marks,
                                          .mark = mark,
                                          .peak = {postproc_history_when(h, in.breakdown.t), in.breakdown.pressure}});
    postproc_charts_note(charts, status, name, title);
}

static const struct style {
    enum postproc_quantity quantity;
    const char *title;
} styles[] = {{POSTPROC_APERTURE, "Aperture of the cracks"}, {POSTPROC_CRACK_PRESSURE, "Pressure in the cracks"}};
enum { STYLES = sizeof styles / sizeof *styles };

static const double *values_of(const struct postproc_crack_fluid *w, int style) {
    return style ? w->pressure : w->aperture;
}

/* Widens the range, which begins as 0 to 0, by the values that are there. Returns how many there are. */
static long widen(double range[2], const struct postproc_crack_fluid *w, int style) {
    const double *value = values_of(w, style);
    double *sorted = memory_new(MEMORY_OUTPUT, (size_t)w->plate.n + 1, sizeof *sorted);
    long n = 0;
    for (long i = 0; i < w->plate.n; i++)
        if (isfinite(value[i])) sorted[n++] = value[i];
    sort_ascending(sorted, (size_t)n);
    if (n > 0) {
        range[0] = fmin(range[0], style ? sorted[(long)((1 - SPREAD) * (double)(n - 1))] : 0);
        range[1] = fmax(range[1], sorted[(long)(SPREAD * (double)(n - 1))]);
    }
    memory_free(sorted);
    return n;
}

/* A unit for values up to `most`, and the label of the colour bar. */
static double unit_of(int style, double most, char label[64]) {
    static const struct {
        double size;
        const char *name;
    } pressure[] = {{1e9, "GPa"}, {1e6, "MPa"}, {1e3, "kPa"}, {1, "Pa"}};
    int k = 0;
    if (!style) {
        const char *name;
        const double unit = postproc_plot_unit(most, &name);
        snprintf(label, 64, "w  [%s]", name);
        return unit;
    }
    while (k < 3 && most < 0.9999 * pressure[k].size) k++;
    snprintf(label, 64, "p  [%s]", pressure[k].name);
    return pressure[k].size;
}

static void draw(struct postproc_output *out, const struct postproc_history *h, const struct postproc_crack_fluid *w,
                 int style, const double range[2], double magnify, const char *inside, const char *name) {
    char folder[FOLDER_PATH], subtitle[256], label[64], moved[64] = "";
    const double unit = unit_of(style, fmax(fabs(range[0]), fabs(range[1])), label);
    const double *value = values_of(w, style);
    double *scaled = memory_new(MEMORY_OUTPUT, (size_t)w->plate.n + 1, sizeof *scaled);
    for (long i = 0; i < w->plate.n; i++) scaled[i] = value[i] / unit;
    double limit[2] = {range[0] / unit, range[1] > range[0] ? range[1] / unit : range[0] / unit + 1};
    struct postproc_plate_picture f = {.folder = folder_path(folder, out->folder, inside),
                                       .name = name,
                                       .all = inside[0] == 'p',
                                       .title = h->scene->title,
                                       .subtitle = subtitle,
                                       .label = label,
                                       .plate = &w->plate,
                                       .value = scaled,
                                       .stride = 1,
                                       .along = 2 - w->along,
                                       .magnify = magnify,
                                       .width = out->options.width};
    f.map = style ? postproc_sections_map(limit) : POSTPROC_VIRIDIS;
    f.value_low = limit[0];
    f.value_high = limit[1];
    const double shape = (w->plate.high[1] - w->plate.low[1]) / (w->plate.high[0] - w->plate.low[0]);
    f.height = (int)(fmin(fmax(shape * 0.83 / 0.82, 0.4), 1) * f.width) / 2 * 2;
    if (h->scene->dimension == 2)
        snprintf(moved, sizeof moved, "; displacements times %.4g", magnify);
    else
        snprintf(moved, sizeof moved, ", mean along %c", "xyz"[w->along]);
    const int all = style && h->scene->dimension == 2 && h->scene->crack_fluid->pores;
    char time[64];
    snprintf(subtitle, sizeof subtitle, "t = %s, step %ld; %s%s%s", postproc_sections_seconds(h, w->plate.time, time),
             w->plate.step, all ? "Pressure in cracks and pores" : styles[style].title, moved,
             all ? "" : "; grey: no crack");
    if (postproc_plate_picture_draw(&f)) postproc_sections_fail(out, folder);
    memory_free(scaled);
}

/* The colours are those of all files, for the pressure is highest before the crack grows. */
static void film(struct postproc_output *out, const struct postproc_history *h, const struct postproc_crack_fluid *full,
                 int style, double magnify) {
    const char *word = postproc_options_name(styles[style].quantity);
    double range[2] = {0, 0};
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0, frame = 1; k < h->solid.n; k++) {
            char name[96];
            struct postproc_crack_fluid *w = postproc_crack_fluid_new(h, k, full);
            if (w && pass == 0) widen(range, w, style);
            if (w && pass == 1) {
                snprintf(name, sizeof name, "%s_%04d", word, frame);
                draw(out, h, w, style, range, magnify, "film", name);
                out->frames = frame++;
            }
            postproc_crack_fluid_free(w);
        }
    snprintf(out->film, sizeof out->film, "%s", word);
    snprintf(out->film_title, sizeof out->film_title, "%s", styles[style].title);
}

/* A round factor that opens the crack of the picture by up to a tenth of its width. */
static double magnify_of(const struct postproc_output *out, const struct postproc_crack_fluid *w) {
    double range[2] = {0, 0};
    widen(range, w, 0);
    if (out->options.magnify > 0 || !(range[1] > 0)) return fmax(out->options.magnify, 1);
    return fmax(1, postproc_legend_round(fmin(0.1 * (w->plate.high[0] - w->plate.low[0]) / range[1], 1e6)));
}

/* The file in which the cracks held most: the last one without a series. */
static int fullest(const struct postproc_history *h) {
    int best = h->solid.n - 1;
    double most = 0;
    for (int k = 0; k < h->solid.n; k++) {
        const double volume = postproc_history_value(h, "crack_volume", h->solid.entry[k].time);
        if (!(volume > most)) continue;
        most = volume;
        best = k;
    }
    return best;
}

void postproc_sections_crack_fluid(struct postproc_output *out, const struct postproc_history *h) {
    if (!h->scene->crack_fluid) return;
    postproc_sections_crack_fluid_numbers(out, h);
    if (h->series) draw_injection(out, h);
    struct postproc_crack_fluid *w = h->solid.n > 0 ? postproc_crack_fluid_new(h, fullest(h), NULL) : NULL;
    if (!w) return;
    add_band(&out->facts, w);
    const double magnify = magnify_of(out, w);
    for (int k = 0; k < STYLES; k++) {
        const char *name = postproc_options_name(styles[k].quantity);
        double range[2] = {0, 0};
        if (widen(range, w, k) == 0) continue;
        draw(out, h, w, k, range, magnify, "pictures", name);
        postproc_sections_picture(out, name, styles[k].title);
        if (out->options.film && out->options.film_named && out->options.film_quantity == styles[k].quantity)
            film(out, h, w, k, magnify);
    }
    postproc_crack_fluid_free(w);
}
