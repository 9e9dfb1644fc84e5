/* Draws curves of the series over time, of one run or of several. */
#include "postproc/charts/charts.h"

#include <math.h>
#include <stdio.h>

enum { LINES = 5, RUNS_MAX = 16 };
enum scale { AS_IS, BY_PRESSURE }; /* BY_PRESSURE: divided by rho_f U_b^2 if all runs have one */

static const struct chart {
    const char *name, *title, *ylabel;
    struct {
        const char *column, *title;
    } line[LINES];
    enum scale scale;
    int whole; /* 1: the whole run; 0: the last stage and an equal time before it */
    int along; /* 1: columns of x, in whose place those of the axis of the stream are drawn */
} all_charts[] = {
    {"pressure_drop", "Pressure drop across the medium", "{/Symbol D}p / ({/Symbol r}_f U_b^2)", .line = {{"dp", "dp"}},
     .scale = BY_PRESSURE},
    {"pressure_drop_whole", "Pressure drop across the medium, all stages", "{/Symbol D}p / ({/Symbol r}_f U_b^2)",
     .line = {{"dp", "dp"}}, .scale = BY_PRESSURE, .whole = 1},
    {"porosity", "Porosity of the medium", "porosity",
     .line = {{"porosity", "all void"}, {"porosity_effective", "connected void"}}},
    {"permeability", "Permeability of the medium", "k  [m^2]", .line = {{"permeability", "k"}}},
    {"tortuosity", "Hydraulic tortuosity", "<|u|> / <u_e>", .line = {{"tortuosity", "tortuosity"}}},
    {"bonds_broken", "Broken bonds", "bonds broken", .line = {{"bonds_broken", "bonds broken"}}},
    {"fragments", "Fragments", "fragments", .line = {{"fragments", "fragments"}}},
    {"damage", "Damage", "damage", .line = {{"damage_mean", "mean"}, {"damage_max", "largest"}}},
    {"energy", "Energies of the solid", "energy  [J]",
     .line = {{"e_strain", "strain"},
              {"e_kinetic_solid", "kinetic"},
              {"e_fracture", "released by bonds"},
              {"e_damped", "damped"},
              {"work_fluid", "work of the fluid"}}},
    {"crack_pressure", "Pressure of the fluid in cracks", "pressure  [Pa]",
     .line = {{"injection_pressure", "at the injection"}, {"crack_pressure_mean", "mean"}}},
    {"crack_volume", "Volumes of the fluid in cracks", "volume  [m^3]",
     .line = {{"crack_volume", "of the cracks"},
              {"injected_volume", "injected"},
              {"cavity_volume", "void"},
              {"leaked_volume", "leaked"}}},
    {"crack_aperture", "Aperture of the cracks", "aperture  [m]",
     .line = {{"aperture_max", "largest"}, {"aperture_mean", "mean"}}},
    {"crack_wet", "Area of the cracks with fluid", "area  [m^2]", .line = {{"crack_area_wet", "area"}}},
    {"load", "Force along the stream: on the solid, and by the forcing on the fluid", "force  [N]",
     .line = {{"load_x", "load on the solid"}, {"forcing_x", "forcing on the fluid"}}, .along = 1},
};
enum { CHARTS = sizeof all_charts / sizeof *all_charts };

void postproc_charts_note(struct postproc_charts *charts, enum postproc_plot_status status, const char *name,
                          const char *title) {
    if (status != POSTPROC_PLOT_DONE) {
        charts->worst = status;
        return;
    }
    charts->name[charts->n] = name;
    charts->title[charts->n++] = title;
}

void postproc_charts_add(struct postproc_charts *charts, const struct postproc_plot *plot) {
    if (plot->curves == 0 || charts->n == POSTPROC_CHARTS) return;
    postproc_charts_note(charts, postproc_plot_draw(plot), plot->name, plot->title);
}

/* The curve of a column; 0 if it has fewer than two points. */
static int curve_new(struct postproc_curve *curve, const struct postproc_history *h, const char *column, double scale) {
    double *x = postproc_history_column(h, "t"), *y = postproc_history_column(h, column);
    long n = 0, finite = 0;
    for (long i = 0; x && y && i < h->series->rows; i++, n++) {
        x[i] = postproc_history_when(h, x[i]);
        y[i] /= scale;
        finite += isfinite(y[i]) != 0;
    }
    curve->n = n;
    curve->x = x;
    curve->y = y;
    return finite >= 2;
}

/* The name of a line's column in a run. */
static const char *column_of(const struct chart *chart, int line, const struct postproc_history *h, char name[32]) {
    const int used = snprintf(name, 32, "%s", chart->line[line].column);
    if (chart->along) name[used - 1] = "xyz"[postproc_history_axis(h)];
    return name;
}

static void chart_draw(struct postproc_charts *charts, const struct chart *chart, int runs,
                       struct postproc_history *const *run, const char *const *label, const char *folder) {
    struct postproc_curve curve[LINES * RUNS_MAX];
    static const struct postproc_mark origin = {0, ""};
    char title[LINES * RUNS_MAX][96];
    int curves = 0, scaled = 1, staged = 0;
    double first = INFINITY, last = -INFINITY;
    for (int r = 0; r < runs; r++) {
        scaled = scaled && run[r]->pressure > 0;
        staged = staged || run[r]->origin > 0;
    }
    if (chart->whole && !staged) return;
    const int by_pressure = chart->scale == BY_PRESSURE && scaled;
    for (int r = 0; r < runs && r < RUNS_MAX; r++)
        for (int l = 0; l < LINES && chart->line[l].column && (runs == 1 || l == 0); l++) {
            struct postproc_curve *c = &curve[curves];
            char column[32];
            *c = (struct postproc_curve){.title = title[curves]};
            if (!curve_new(c, run[r], column_of(chart, l, run[r], column), by_pressure ? run[r]->pressure : 1))
                continue;
            snprintf(title[curves++], sizeof *title, "%s", runs > 1 ? label[r] : chart->line[l].title);
            const double span = c->x[c->n - 1] > 0 ? c->x[c->n - 1] : INFINITY; /* before time 0, as long as after it */
            first = fmin(first, chart->whole ? c->x[0] : fmax(c->x[0], -0.25 * span));
            last = fmax(last, c->x[c->n - 1]);
        }
    postproc_charts_add(charts,
                        &(struct postproc_plot){
                            .folder = folder,
                            .name = chart->name,
                            .title = chart->title,
                            .xlabel = postproc_history_when_name(run[0]),
                            .ylabel = chart->scale == BY_PRESSURE && !scaled ? "{/Symbol D}p  [Pa]" : chart->ylabel,
                            .curves = curves,
                            .curve = curve,
                            .marks = staged,
                            .mark = &origin,
                            .x_low = first,
                            .x_high = last,
                        });
}

void postproc_charts_draw(struct postproc_charts *charts, int runs, struct postproc_history *const *run,
                          const char *const *label, const char *folder) {
    for (int k = 0; k < CHARTS; k++) chart_draw(charts, &all_charts[k], runs, run, label, folder);
}
