/* Section of the report on scenes that are solved at once: the numbers of solution.csv, and the error at the points. */
#include "base/files/folder.h"
#include "base/files/read_file.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Adds each line quantity,unit,value of the file. */
static void add_facts(struct postproc_facts *f, char *text) {
    char *rest = NULL;
    strtok_r(text, "\n", &rest); /* the names of the columns */
    for (char *line = strtok_r(NULL, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest)) {
        char *unit = strchr(line, ','), *value = unit ? strchr(unit + 1, ',') : NULL;
        if (!value) continue;
        *unit++ = *value++ = '\0';
        postproc_facts_number(f, line, unit, strtod(value, NULL));
    }
}

/* The error over the distance from the middle, and in a plane a map of it (in space of the points near z = 0). */
static void put_script(FILE *f, const char *name, int is_map, double spacing, struct vtkhdf_source *s, double (*x)[3],
                       const double *error) {
    fputs("$points << EOD\n", f);
    for (long i = 0; i < s->points; i++)
        if (!is_map)
            fprintf(f, "%.8g %.8g\n", sqrt(x[i][0] * x[i][0] + x[i][1] * x[i][1] + x[i][2] * x[i][2]), error[i]);
        else if (fabs(x[i][2]) <= spacing)
            fprintf(f, "%.8g %.8g %.8g\n", x[i][0], x[i][1], error[i]);
    fputs("EOD\n", f);
    for (int k = 0; k < POSTPROC_FORMATS; k++) {
        postproc_gnuplot_terminal(f, (enum postproc_format)k, name, is_map ? 760 : 800, is_map ? 680 : 500);
        if (is_map)
            fputs("set size ratio -1\nset xlabel 'x [m]'\nset ylabel 'y [m]'\nset cblabel 'u_i - u(x_i) [m^2]'\n"
                  "plot $points using 1:2:3 with points pt 7 ps 0.6 palette notitle\n",
                  f);
        else
            fputs("set xlabel '|x| [m]'\nset ylabel 'u_i - u(x_i) [m^2]'\n"
                  "plot $points using 1:2 with points pt 7 ps 0.4 notitle\n",
                  f);
    }
}

static void draw(struct postproc_output *out, int is_map, struct vtkhdf_source *s, double (*x)[3],
                 const double *error) {
    char plots[FOLDER_PATH];
    const char *name = is_map ? "solution_map" : "solution_error";
    const struct postproc_fact *spacing = postproc_facts_find(&out->facts, "spacing");
    FILE *f = postproc_gnuplot_script_new(folder_path(plots, out->folder, "plots"), name);
    if (!f) {
        postproc_sections_fail(out, plots);
        return;
    }
    put_script(f, name, is_map, spacing ? spacing->value : NAN, s, x, error);
    const enum postproc_plot_status status = postproc_gnuplot_script_end(f, plots, name);
    postproc_charts_note(&out->charts, status, name,
                         is_map ? "Error at the points" : "Error over the distance from the middle");
}

void postproc_sections_solution(struct postproc_output *out, const struct postproc_history *h) {
    char path[FOLDER_PATH];
    char *text = read_file(folder_path(path, h->folder, "solution.csv"));
    if (!text) return;
    add_facts(&out->facts, text);
    free(text);
    struct vtkhdf_source *s = vtkhdf_read_open(folder_path(path, h->folder, "fields/solution.hdf"), NULL);
    double *error = s ? vtkhdf_read_double(s, "error") : NULL, (*x)[3] = error ? vtkhdf_read_points(s) : NULL;
    for (int is_map = 0; x && is_map < 1 + (h->scene->dimension > 1) && out->charts.n < POSTPROC_CHARTS; is_map++)
        draw(out, is_map, s, x, error);
    free(x);
    free(error);
    if (s) vtkhdf_read_close(s);
}
