/* Section of the report with pictures of an element-free plate: nodes and cells, stress, deformed shape, K, growth. */
#include "base/memory.h"
#include "base/files/folder.h"
#include "postproc/charts/patches.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TIPS = 16 };

/* What the run has written. */
struct plate {
    long nodes, quads, points, outlines, cracks, extensions;
    double (*node)[2], (*x)[2], (*u)[2], (*stress)[6], (*point)[2], (*outline)[2], (*crack)[2], (*extension)[2];
    double low[2], high[2]; /* of the cells, m */
    double coarsest;        /* nodal spacing, m */
    double centre[2], half; /* of the part that is drawn larger; half 0: there is no tip */
};

static double (*array_new(long n))[2] { return memory_new(MEMORY_OUTPUT, (size_t)n + 1, 2 * sizeof(double)); }

/* The places of a file, in the plane; NULL if there is none. */
static double (*places(struct vtkhdf_source *s, long *n))[2] {
    double(*x)[3] = s ? vtkhdf_read_points(s) : NULL, (*to)[2] = NULL;
    if (x) {
        *n = s->points;
        to = array_new(*n);
        for (long i = 0; i < *n; i++) memcpy(to[i], x[i], sizeof *to);
    }
    free(x);
    return to;
}

static void set_nodes(struct plate *p, const char *folder) {
    char path[FOLDER_PATH];
    struct vtkhdf_source *s = vtkhdf_read_open(folder_path(path, folder, "fields/solution.hdf"), NULL);
    double *spacing = s ? vtkhdf_read_double(s, "spacing") : NULL;
    p->node = places(s, &p->nodes);
    for (long i = 0; spacing && i < p->nodes; i++) p->coarsest = fmax(p->coarsest, spacing[i]);
    free(spacing);
    if (s) vtkhdf_read_close(s);
    s = vtkhdf_read_open(folder_path(path, folder, "fields/gauss_points.hdf"), NULL);
    p->point = places(s, &p->points);
    if (s) vtkhdf_read_close(s);
}

/* Returns whether the cells and their values are there. */
static int set_cells(struct plate *p, const char *folder) {
    char path[FOLDER_PATH];
    struct vtkhdf_source *s = vtkhdf_read_open(folder_path(path, folder, "fields/cells.hdf"), NULL);
    if (!s) return 0;
    double *u = vtkhdf_read_double(s, "displacement"), *stress = vtkhdf_read_double(s, "stress");
    long corners = 0;
    p->x = places(s, &corners);
    p->quads = corners / 4;
    if (p->x && u && stress) {
        p->u = array_new(corners);
        p->stress = memory_copy(MEMORY_OUTPUT, stress, (size_t)corners, sizeof *p->stress);
        p->outline = array_new(4 * p->quads);
        for (int c = 0; c < 2; c++) p->low[c] = INFINITY, p->high[c] = -INFINITY;
        for (long i = 0; i < corners; i++)
            for (int c = 0; c < 2; c++) {
                p->u[i][c] = u[3 * i + c];
                p->low[c] = fmin(p->low[c], p->x[i][c]);
                p->high[c] = fmax(p->high[c], p->x[i][c]);
            }
        for (long q = 0; q < p->quads; q++) { /* from the middle of one edge over the corner to that of the next */
            for (int k = 1; k < 4; k++) memcpy(p->outline[p->outlines++], p->x[4 * q + k], sizeof p->x[0]);
            p->outline[p->outlines++][0] = NAN;
        }
    }
    free(u);
    free(stress);
    vtkhdf_read_close(s);
    return p->outlines > 0;
}

static void set_lines(struct plate *p, const char *folder) {
    char path[FOLDER_PATH];
    struct table_data *d = table_read(folder_path(path, folder, "crack_lines.csv"), NULL);
    if (!d || d->columns < 6) {
        table_read_free(d);
        return;
    }
    p->crack = array_new(3 * d->rows);
    p->extension = array_new(3 * d->rows);
    for (long r = 0; r < d->rows; r++) {
        const double *v = d->value + r * d->columns;
        double(*to)[2] = v[1] > 0 ? p->extension + p->extensions : p->crack + p->cracks;
        memcpy(to[0], v + 2, sizeof *to);
        memcpy(to[1], v + 4, sizeof *to);
        to[2][0] = NAN;
        *(v[1] > 0 ? &p->extensions : &p->cracks) += 3;
        if (v[1] > 0) memcpy(p->centre, v + 2, sizeof p->centre);
    }
    if (p->extensions > 0)
        p->half = fmin(2.5 * p->coarsest, 0.25 * fmin(p->high[0] - p->low[0], p->high[1] - p->low[1]));
    table_read_free(d);
}

static void plate_free(struct plate *p) {
    MEMORY_FREE(p->node, p->x, p->u, p->stress, p->point, p->outline, p->crack, p->extension);
}

static void map_draw(struct postproc_output *out, const struct postproc_history *h, const struct plate *p,
                     const char *name, const char *title, const char *subtitle, struct postproc_patches map) {
    char folder[FOLDER_PATH];
    map.folder = folder_path(folder, out->folder, "pictures");
    map.name = name;
    map.title = h->scene->title;
    map.subtitle = subtitle;
    map.quads = p->quads;
    const enum postproc_plot_status status = postproc_patches_draw(&map);
    if (status != POSTPROC_PLOT_DONE)
        out->charts.worst = status;
    else
        postproc_sections_picture(out, name, title);
}

/* The whole plate with a margin, and the part about a tip. */
static struct postproc_patches view(const struct plate *p, double margin) {
    struct postproc_patches map = {.half = p->half, .map = POSTPROC_VIRIDIS};
    const double more = margin * fmax(p->high[0] - p->low[0], p->high[1] - p->low[1]);
    for (int c = 0; c < 2; c++) {
        map.low[c] = p->low[c] - more;
        map.high[c] = p->high[c] + more;
        map.centre[c] = p->centre[c];
    }
    return map;
}

static void nodes_draw(struct postproc_output *out, const struct postproc_history *h, const struct plate *p) {
    const struct postproc_patches_line line[] = {
        {p->outlines, (const double(*)[2])p->outline, "with lines lw 0.6 lc rgb '#b9bdc2'", 0},
        {p->points, (const double(*)[2])p->point, "with points pt 7 ps 0.12 lc rgb '#56B4E9'", 1},
        {p->nodes, (const double(*)[2])p->node, "with points pt 7 ps 0.35 lc rgb '#23282e'", 0},
        {p->extensions, (const double(*)[2])p->extension, "with lines lw 2 dt 2 lc rgb '#0072B2'", 0},
        {p->cracks, (const double(*)[2])p->crack, "with lines lw 2.5 lc rgb '#D55E00'", 0}};
    char subtitle[160];
    snprintf(subtitle, sizeof subtitle, "%ld nodes (black), cells (grey)%s", p->nodes,
             p->half > 0 ? ", Gauss points (light blue); crack (red), its extension (dashed)" : ", Gauss points");
    struct postproc_patches map = view(p, 0.01);
    map.lines = sizeof line / sizeof *line;
    map.line = line;
    map_draw(out, h, p, "nodes", "Nodes, cells and Gauss points; the crack and its extension", subtitle, map);
}

/* Von Mises stress; in plane strain with the stress across the plane, which the file has too. */
static double mises_of(const double s[6]) {
    const double d[3] = {s[0] - s[1], s[1] - s[2], s[2] - s[0]};
    return sqrt(0.5 * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) + 3 * s[3] * s[3]);
}

static void stress_draw(struct postproc_output *out, const struct postproc_history *h, const struct plate *p,
                        int is_mises) {
    double *value = memory_new(MEMORY_OUTPUT, 4 * (size_t)p->quads + 1, sizeof *value);
    for (long i = 0; i < 4 * p->quads; i++) value[i] = is_mises ? mises_of(p->stress[i]) : p->stress[i][1];
    struct postproc_patches map = view(p, 0);
    map.x = (const double(*)[2])p->x;
    map.value = value;
    map.label = "[Pa]";
    map_draw(out, h, p, is_mises ? "stress_mises" : "stress_yy",
             is_mises ? "Contours of the von Mises stress" : "Contours of the stress along y",
             is_mises ? "von Mises stress, each side of the crack by its own nodes"
                      : "stress along y, each side of the crack by its own nodes",
             map);
    memory_free(value);
}

/* The cells moved by their displacements, times a factor that makes the largest a twentieth of the plate. */
static void shape_draw(struct postproc_output *out, const struct postproc_history *h, const struct plate *p) {
    double(*moved)[2] = array_new(4 * p->quads), (*outline)[2] = array_new(4 * p->quads), most = 0, factor = 1;
    double *value = memory_new(MEMORY_OUTPUT, 4 * (size_t)p->quads + 1, sizeof *value);
    for (long i = 0; i < 4 * p->quads; i++) most = fmax(most, hypot(p->u[i][0], p->u[i][1]));
    if (most > 0) factor = 0.05 * fmax(p->high[0] - p->low[0], p->high[1] - p->low[1]) / most;
    factor = pow(10, floor(log10(factor))) * floor(factor / pow(10, floor(log10(factor))));
    if (out->options.magnify > 0) factor = out->options.magnify;
    struct plate at = *p;
    for (int c = 0; c < 2; c++) at.low[c] = INFINITY, at.high[c] = -INFINITY;
    for (long i = 0; i < 4 * p->quads; i++) {
        value[i] = p->u[i][1];
        for (int c = 0; c < 2; c++) {
            moved[i][c] = p->x[i][c] + factor * p->u[i][c];
            at.low[c] = fmin(at.low[c], moved[i][c]);
            at.high[c] = fmax(at.high[c], moved[i][c]);
        }
    }
    double nearest = INFINITY; /* the tip moves too */
    for (long i = 0; i < 4 * p->quads; i++) {
        const double r = hypot(p->x[i][0] - p->centre[0], p->x[i][1] - p->centre[1]);
        if (r >= nearest) continue;
        nearest = r;
        memcpy(at.centre, moved[i], sizeof at.centre);
    }
    for (long q = 0; q < p->quads; q++) {
        for (int k = 1; k < 4; k++) memcpy(outline[4 * q + k - 1], moved[4 * q + k], sizeof *moved);
        outline[4 * q + 3][0] = NAN;
    }
    const struct postproc_patches_line line = {4 * p->quads, (const double(*)[2])outline,
                                               "with lines lw 0.4 lc rgb '#5a6068'", 0};
    char subtitle[160];
    snprintf(subtitle, sizeof subtitle, "displacements times %.3g; colours: displacement along y", factor);
    struct postproc_patches map = view(&at, 0.02);
    map.x = (const double(*)[2])moved;
    map.value = value;
    map.label = "u_y  [m]";
    map.lines = 1;
    map.line = &line;
    map_draw(out, h, p, "shape", "The deformed plate", subtitle, map);
    MEMORY_FREE(moved, outline, value);
}

/* A curve of a table: rows of one tip, or all where tip is -1. */
struct series {
    const char *column, *title;
};

/* Draws columns of a table over another one, a curve a column and tip, and adds the plot if a curve has two points. */
static void series_draw(struct postproc_output *out, const struct table_data *d, const char *over, int kinds,
                        const struct series *kind, struct postproc_plot plot) {
    enum { CURVES = 3 * TIPS };
    char title[CURVES][64];
    struct postproc_curve curve[CURVES];
    const int tip = table_read_column(d, "tip"), x_column = table_read_column(d, over);
    int curves = 0, tips = 0;
    long most = 0;
    if (tip < 0 || x_column < 0) return;
    for (long r = 0; r < d->rows; r++) tips = (int)fmax(tips, d->value[r * d->columns + tip] + 1);
    for (int t = 0; t < tips && t < TIPS; t++)
        for (int k = 0; k < kinds && k < 3; k++) {
            const int column = table_read_column(d, kind[k].column);
            double *x = memory_new(MEMORY_OUTPUT, (size_t)d->rows + 1, sizeof *x);
            double *y = memory_new(MEMORY_OUTPUT, (size_t)d->rows + 1, sizeof *y);
            long n = 0;
            for (long r = 0; column >= 0 && r < d->rows; r++) {
                const double *v = d->value + r * d->columns;
                if ((int)v[tip] != t) continue;
                x[n] = v[x_column];
                y[n++] = v[column];
            }
            snprintf(title[curves], sizeof *title, tips > 1 ? "%s, tip %d" : "%s", kind[k].title, t);
            curve[curves] = (struct postproc_curve){.title = title[curves], .n = n, .x = x, .y = y, .points = 1};
            curves++;
            most = n > most ? n : most;
        }
    plot.curves = most > 1 ? curves : 0;
    plot.curve = curve;
    plot.x_low = plot.x_high = NAN;
    postproc_charts_add(&out->charts, &plot);
    for (int k = 0; k < curves; k++) MEMORY_FREE((void *)(size_t)curve[k].x, (void *)(size_t)curve[k].y);
}

/* K_I, K_II and the root of J E' over the radius of the ring, a curve a tip. */
static void intensity_draw(struct postproc_output *out, const struct postproc_history *h, const char *plots) {
    static const struct series shown[] = {{"K_I", "K_I"}, {"K_II", "K_II"}, {"K_J", "√(J E')"}};
    char path[FOLDER_PATH];
    struct table_data *d = table_read(folder_path(path, h->folder, "intensity.csv"), NULL);
    if (d)
        series_draw(out, d, "radius", 3, shown,
                    (struct postproc_plot){.folder = plots,
                                           .name = "intensity_radius",
                                           .title = "Stress-intensity factors over the radius of the integral's ring",
                                           .xlabel = "radius  [m]",
                                           .ylabel = "K  [Pa √m]"});
    table_read_free(d);
}

/* The path of the tips, and K and the load over the growth of a tip. */
static void growth_draw(struct postproc_output *out, const struct postproc_history *h, const struct plate *p,
                        const char *plots) {
    static const struct series shown[] = {{"K_I", "K_I"}, {"K_II", "K_II"}}, load = {"load", "load"};
    char path[FOLDER_PATH], subtitle[160];
    struct table_data *d = table_read(folder_path(path, h->folder, "growth.csv"), NULL);
    const int x = d ? table_read_column(d, "x") : -1, y = d ? table_read_column(d, "y") : -1;
    if (x >= 0 && y >= 0) {
        series_draw(out, d, "length", 2, shown,
                    (struct postproc_plot){.folder = plots,
                                           .name = "growth_k",
                                           .title = "Stress-intensity factors of the growing crack under the scene's "
                                                    "loads",
                                           .xlabel = "length grown  [m]",
                                           .ylabel = "K  [Pa √m]"});
        series_draw(out, d, "length", 1, &load,
                    (struct postproc_plot){.folder = plots,
                                           .name = "growth_load",
                                           .title = "Factor of the loads at which the crack grows",
                                           .xlabel = "length grown  [m]",
                                           .ylabel = "factor"});
    }
    if (x >= 0 && y >= 0 && p->outlines > 0) {
        double(*tip)[2] = array_new(d->rows);
        for (long r = 0; r < d->rows; r++) {
            tip[r][0] = d->value[r * d->columns + x];
            tip[r][1] = d->value[r * d->columns + y];
        }
        const struct postproc_patches_line line[] = {
            {p->outlines, (const double(*)[2])p->outline, "with lines lw 0.5 lc rgb '#e4e7ea'", 0},
            {p->cracks, (const double(*)[2])p->crack, "with lines lw 2.5 lc rgb '#D55E00'", 0},
            {d->rows, (const double(*)[2])tip, "with points pt 7 ps 0.6 lc rgb '#23282e'", 0}};
        struct plate whole = *p;
        whole.half = 0;
        struct postproc_patches map = view(&whole, 0.01);
        map.lines = sizeof line / sizeof *line;
        map.line = line;
        snprintf(subtitle, sizeof subtitle, "crack (red), tips at each step (black), cells of the last step (grey)");
        map_draw(out, h, p, "growth", "The way of the crack", subtitle, map);
        memory_free(tip);
    }
    table_read_free(d);
}

void postproc_sections_element_free(struct postproc_output *out, const struct postproc_history *h) {
    const struct scene_solid *s = h->scene->solid;
    if (!s || s->method != SCENE_ELEMENT_FREE) return;
    char plots[FOLDER_PATH];
    struct plate p = {0};
    set_nodes(&p, h->folder);
    if (set_cells(&p, h->folder)) {
        set_lines(&p, h->folder);
        nodes_draw(out, h, &p);
        stress_draw(out, h, &p, 0);
        stress_draw(out, h, &p, 1);
        shape_draw(out, h, &p);
    }
    folder_path(plots, out->folder, "plots");
    intensity_draw(out, h, plots);
    growth_draw(out, h, &p, plots);
    plate_free(&p);
}
