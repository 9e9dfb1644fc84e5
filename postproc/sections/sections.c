/* Sections of the report: the run, the medium, fracture, wall time. */
#include "postproc/sections/sections.h"
#include "physics/darcy.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void postproc_sections_fail(struct postproc_output *out, const char *path) {
    if (out->failed) return;
    out->failed = errno ? errno : EIO;
    snprintf(out->failed_path, sizeof out->failed_path, "%s", path);
}

void postproc_sections_picture(struct postproc_output *out, const char *name, const char *title) {
    if (out->pictures == POSTPROC_PICTURES) return;
    snprintf(out->picture[out->pictures].name, sizeof out->picture->name, "%s", name);
    snprintf(out->picture[out->pictures++].title, sizeof out->picture->title, "%s", title);
}

void postproc_sections_when(const struct postproc_history *h, double t, char text[64]) {
    const double when = postproc_history_when(h, t);
    snprintf(text, 64, h->t0 > 0 ? "t/t0 = %.4g" : "t = %.4g s", fabs(when) < 1e-9 * fabs(h->end) ? 0 : when);
}

const char *postproc_sections_seconds(const struct postproc_history *h, double t, char text[64]) {
    const int slow = h->end >= 0.01;
    snprintf(text, 64, "%.4g %s", slow ? t : 1e6 * t, slow ? "s" : "µs");
    return text;
}

enum postproc_map postproc_sections_map(double limit[2]) {
    const double most = fmax(fabs(limit[0]), fabs(limit[1]));
    if (!(limit[0] < 0 && limit[1] > 0 && fmin(-limit[0], limit[1]) > 0.2 * most)) return POSTPROC_VIRIDIS;
    limit[0] = -most;
    limit[1] = most;
    return POSTPROC_DIVERGING;
}

void postproc_sections_run(struct postproc_output *out, const struct postproc_history *h) {
    struct postproc_facts *f = &out->facts;
    postproc_facts_text(f, "title", h->scene->title);
    postproc_facts_text(f, "status", json_read_text(h->record, "status"));
    if (h->scene->stages == 0) return;
    postproc_facts_text(f, "stage", h->stage);
    postproc_facts_number(f, "start of the stage", "s", h->origin);
    postproc_facts_number(f, "end of the data", "s", h->end);
    postproc_facts_number(f, "t0 = L_ref/U_b", "s", h->t0);
    postproc_facts_number(f, "end of the data, after the start of the stage", "t0",
                          h->t0 > 0 ? (h->end - h->origin) / h->t0 : NAN);
    postproc_facts_number(f, "p0 = rho_f U_b^2", "Pa", h->pressure);
    postproc_facts_number(f, "critical stretch s0", "1", h->s0);
    postproc_facts_number(f, "sigma0 = E s0", "Pa", h->sigma0);
}

/* Adds a quantity at the start of the stage, at the end, and its mean over the stage's last tenth. */
static void before_after(struct postproc_output *out, const struct postproc_history *h, const char *column,
                         const char *name, const char *unit, double scale) {
    double before = postproc_history_value(h, column, h->origin);
    if (isnan(before)) { /* the series begins after the start of the stage */
        double *all = postproc_history_column(h, column);
        for (long i = 0; all && i < h->series->rows && isnan(before); i++) before = all[i];
    }
    postproc_facts_number(&out->facts, NAMED("%s, before", name), unit, before / scale);
    postproc_facts_number(&out->facts, NAMED("%s, after", name), unit,
                          postproc_history_value(h, column, h->end) / scale);
    const double from = h->end - 0.1 * (h->end - h->origin);
    postproc_facts_number(&out->facts, NAMED("%s, mean over the last tenth", name), unit,
                          postproc_history_mean(h, column, from, h->end) / scale);
}

/* A column of intrinsic.csv at the start of the stage and at the end, in m2 and mD. */
static void intrinsic(struct postproc_output *out, const struct postproc_history *h, int axis) {
    const char column[] = {'k', '_', "xyz"[axis], "xyz"[axis], '\0'};
    double *t = postproc_history_values(h->intrinsic, "t"), *k = postproc_history_values(h->intrinsic, column);
    const long rows = t && k ? h->intrinsic->rows : 0;
    long first = 0;
    while (first + 1 < rows && t[first + 1] <= h->origin) first++;
    for (int after = 0; rows > 0 && after < 2; after++) {
        const double value = k[after ? rows - 1 : first];
        char quantity[96];
        snprintf(quantity, sizeof quantity, "intrinsic permeability along %c, %s", "xyz"[axis],
                 after ? "after" : "before");
        if (isinf(value)) postproc_facts_text(&out->facts, quantity, "infinite: nothing resists the flow");
        if (!isfinite(value)) continue;
        postproc_facts_number(&out->facts, quantity, "m2", value);
        postproc_facts_number(
            &out->facts, NAMED("intrinsic permeability along %c in mD, %s", "xyz"[axis], after ? "after" : "before"),
            "mD", 1e3 * value / PHYSICS_DARCY);
    }
}

/* The column's value in the first row, 0 without one. */
static double first_of(const struct postproc_history *h, const char *column) {
    const double *y = postproc_history_column(h, column);
    return y && h->series->rows > 0 ? y[0] : 0;
}

/* Of the mean grain, a piece of the solid, at the start: the surface of the sphere of its volume over its own. The
 * wetted surface is the box's times S, the pieces' volume the box's times 1 - porosity.  (001: eq. 2.2) */
static double sphericity(const struct postproc_history *h) {
    const struct scene_coupling *c = h->scene->coupling;
    const double *low = c ? c->box_low : NULL, *high = c ? c->box_high : NULL;
    const double box = c ? (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]) : 0,
                 surface = first_of(h, "specific_surface");
    if (!(box > 0 && surface > 0)) return NAN;
    const double pieces = fmax(first_of(h, "fragments"), h->scene->solid->bodies);
    return cbrt(M_PI * pieces / box) * pow(6 * (1 - first_of(h, "porosity")), 2. / 3) / surface;
}

void postproc_sections_medium(struct postproc_output *out, const struct postproc_history *h) {
    const int axis = postproc_history_axis(h);
    if (h->pressure > 0) before_after(out, h, "dp", "dp/(rho_f U_b^2)", "1", h->pressure);
    before_after(out, h, "dp", "dp", "Pa", 1);
    before_after(out, h, "porosity", "porosity", "1", 1);
    before_after(out, h, "porosity_effective", "effective porosity", "1", 1);
    before_after(out, h, "permeability", "permeability", "m2", 1);
    before_after(out, h, "permeability_md", "permeability in mD", "mD", 1);
    for (int c = 0; h->intrinsic && c < 3; c++) intrinsic(out, h, c);
    before_after(out, h, "tortuosity", "tortuosity", "1", 1);
    postproc_facts_number(&out->facts, "sphericity of the mean grain at the start", "1", sphericity(h));
    static const char *const load[3][2] = {
        {"load_x", "load on the solid, x"}, {"load_y", "load on the solid, y"}, {"load_z", "load on the solid, z"}};
    before_after(out, h, load[axis][0], load[axis][1], "N", 1);
}

static double first_time_above(const struct postproc_history *h, const char *column, double threshold) {
    double *t = postproc_history_column(h, "t"), *y = postproc_history_column(h, column), first = NAN;
    for (long i = 0; t && y && i < h->series->rows && isnan(first); i++)
        if (y[i] > threshold) first = t[i];
    return first;
}

/* The area of crack whose energy by Griffith's balance is what the bonds have released, e_fracture/G0; NAN if several
 * materials and interfaces have different G0, or none breaks. */
static double griffith_area(const struct postproc_history *h, double released) {
    const struct scene_solid *s = h->scene->solid;
    double g0 = NAN;
    for (int k = 0; s && k < s->materials + s->interfaces; k++) {
        const double energy =
            k < s->materials ? s->material[k].fracture_energy : s->interface[k - s->materials].fracture_energy;
        if (!isfinite(energy) || energy == g0) continue;
        if (!isnan(g0)) return NAN;
        g0 = energy;
    }
    return released / g0;
}

void postproc_sections_fracture(struct postproc_output *out, const struct postproc_history *h) {
    struct postproc_facts *f = &out->facts;
    const double broken = postproc_history_value(h, "bonds_broken", h->end);
    const double intact = postproc_history_value(h, "bonds_intact", h->end);
    postproc_facts_number(f, "bonds broken", "1", broken);
    postproc_facts_number(f, "bonds broken, share", "1", broken / (broken + intact));
    postproc_facts_number(f, "fragments", "1", postproc_history_value(h, "fragments", h->end));
    postproc_facts_number(f, "largest fragment", "particles", postproc_history_value(h, "largest_fragment", h->end));
    postproc_facts_number(f, "damage, mean", "1", postproc_history_value(h, "damage_mean", h->end));
    postproc_facts_number(f, "damage, largest", "1", postproc_history_value(h, "damage_max", h->end));
    postproc_facts_number(f, "energy released by bonds", "J", postproc_history_value(h, "e_fracture", h->end));
    postproc_facts_number(f, "area of crack by Griffith's balance, energy released over G0", "m2",
                          griffith_area(h, postproc_history_value(h, "e_fracture", h->end)));
    postproc_facts_number(f, "area of crack by broken bonds", "m2", postproc_history_value(h, "crack_area", h->end));
    const int cut = h->scene->solid && h->scene->solid->cracks > 0; /* bonds broken from the start */
    const double at_start = cut ? first_of(h, "bonds_broken") : 0;
    const double first = first_time_above(h, "bonds_broken", at_start);
    if (!isnan(first)) {
        postproc_facts_number(f, "first bond broken, t", "s", first);
        if (h->t0 > 0)
            postproc_facts_number(f, "first bond broken, after the start of the stage", "t0",
                                  (first - h->origin) / h->t0);
    }
    if (cut) return;
    const struct postproc_onset onset = postproc_body_onset(h);
    if (!onset.found) return;
    const int along = postproc_history_axis(h), across = along == 1 ? 2 : 1;
    char text[160];
    if (h->scene->dimension == 2)
        snprintf(text, sizeof text, "x = %.4g m, y = %.4g m", onset.x[0], onset.x[1]);
    else
        snprintf(text, sizeof text, "%c = %.4g m: %s (x/L = %.2f, y/h = %.2f, z/w = %.2f of the medium's box)",
                 "xyz"[along], onset.x[along], onset.where, onset.fraction[0], onset.fraction[1], onset.fraction[2]);
    postproc_facts_text(f, "where it broke first", text);
    postproc_facts_number(f, "first field with damage, t", "s", onset.time);
    postproc_facts_number(f, "first field with damage, damaged particles", "1", (double)onset.particles);
    postproc_facts_number(f, NAMED("first field with damage, %c/L", "xyz"[along]), "1", onset.fraction[along]);
    for (int k = 0; k < 2; k++)
        for (int t = 0; t < 3; t++) {
            static const char *const name[2][3] = {{"front", "middle", "back"}, {"lowest", "middle", "highest"}};
            postproc_facts_number(f,
                                  NAMED("first field with damage, share of it in the %s third of %s", name[k][t],
                                        k ? "the height" : "the length"),
                                  "1", onset.third[k ? across : along][t]);
        }
}

void postproc_sections_wall(struct postproc_output *out, const struct postproc_history *h) {
    struct postproc_facts *f = &out->facts;
    postproc_facts_number(f, "ranks", "1", json_read_number(h->record, "ranks"));
    postproc_facts_number(f, "steps", "1", json_read_number(h->record, "steps"));
    postproc_facts_number(f, "wall time", "s", json_read_number(h->record, "wall_seconds"));
    const char *key;
    double rest = json_read_number(h->record, "wall_seconds");
    for (int k = 0; (key = json_read_key(h->record, "wall_seconds_by_part", k)); k++) {
        char path[128];
        snprintf(path, sizeof path, "wall_seconds_by_part.%s", key);
        postproc_facts_number(f, NAMED("wall time, %s", key), "s", json_read_number(h->record, path));
        rest -= json_read_number(h->record, path);
    }
    postproc_facts_number(f, "wall time, the rest", "s", rest);
    postproc_facts_number(f, "time per cell and step", "ns", json_read_number(h->record, "ns_per_cell_step"));
    postproc_facts_number(f, "time per directed bond and force sweep", "ns",
                          json_read_number(h->record, "ns_per_directed_bond_sweep"));
    postproc_facts_text(f, "host", json_read_text(h->record, "host"));
}
