/* Writes a gnuplot script and runs it. */
#include "postproc/charts/plot.h"
#include "files/folder.h"

#include <errno.h>
#include <math.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

enum { ROWS_MAX = 4000 };

/* Colours that colour-blind readers can distinguish.  (Okabe and Ito 2008) */
static const char *const palette[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
enum { PALETTE = 7 };

/* A text between gnuplot's single quotes, on one line. */
static void put_text(FILE *f, const char *text) {
    fputc('\'', f);
    for (; *text; text++) {
        if (*text == '\'') fputc('\'', f);
        fputc(*text == '\n' ? ' ' : *text, f);
    }
    fputc('\'', f);
}

static void put_point(FILE *f, const struct postproc_plot *p, const struct postproc_curve *c, long i) {
    if (isfinite(c->y[i]) && isfinite(c->x[i]) && !(p->log_y && c->y[i] <= 0) && !(p->log_x && c->x[i] <= 0)) {
        fprintf(f, "%.10g %.10g", c->x[i], c->y[i]);
        if (c->label) {
            fputs(" \"", f);
            for (const char *at = c->label[i]; *at; at++) fputc(strchr("\"\\\n", *at) ? ' ' : *at, f);
            fputc('"', f);
        }
    }
    fputc('\n', f);
}

static void put_data(FILE *f, const struct postproc_plot *p) {
    for (int k = 0; k < p->curves; k++) {
        const struct postproc_curve *c = &p->curve[k];
        const long stride = c->n / ROWS_MAX + 1;
        fprintf(f, "$curve%d << EOD\n", k);
        for (long i = 0; i < c->n; i += c->bars ? 1 : stride) put_point(f, p, c, i);
        fputs("EOD\n", f);
    }
}

/* A range around values that are all equal; gnuplot would warn about an empty one. */
static void put_flat_range(FILE *f, const struct postproc_plot *p) {
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < p->curves; k++)
        for (long i = 0; i < p->curve[k].n; i++) {
            if (!isfinite(p->curve[k].y[i]) || (p->log_y && p->curve[k].y[i] <= 0)) continue;
            low = fmin(low, p->curve[k].y[i]);
            high = fmax(high, p->curve[k].y[i]);
        }
    if (!(high - low <= 1e-9 * fabs(high))) return;
    if (p->log_y)
        fprintf(f, "set yrange [%.10g:%.10g]\n", 0.1 * high, 10 * high);
    else
        fprintf(f, "set yrange [%.10g:%.10g]\n", low > 0 ? 0 : 2 * low, low < 0 ? 0 : low > 0 ? 2 * low : 1);
}

/* Ranges of a plot with two logarithmic axes: of the data and of the levels, with space for labels on the right. */
static void put_log_range(FILE *f, char axis, double low, double high, double room) {
    if (!(low > 0) || !isfinite(high)) return;
    const double margin = fmax(0.08 * log(high / low), 0.25);
    fprintf(f, "set %crange [%.4g:%.4g]\n", axis, low * exp(-margin), high * exp(margin * room));
    if (high < 30 * low) fprintf(f, "set format %c '%%g'\nset %ctics add (%.2g, %.2g)\n", axis, axis, low, high);
}

static void put_log_ranges(FILE *f, const struct postproc_plot *p) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < p->curves; k++)
        for (long i = 0; i < p->curve[k].n; i++) {
            const double at[2] = {p->curve[k].x[i], p->curve[k].y[i]};
            if (!(at[0] > 0 && at[1] > 0 && isfinite(at[0]) && isfinite(at[1]))) continue;
            for (int d = 0; d < 2; d++) {
                low[d] = fmin(low[d], at[d]);
                high[d] = fmax(high[d], at[d]);
            }
        }
    for (int k = 0; k < p->levels; k++) {
        low[1] = fmin(low[1], p->level[k].y);
        high[1] = fmax(high[1], p->level[k].y);
    }
    put_log_range(f, 'x', low[0], high[0], 2);
    put_log_range(f, 'y', low[1], high[1], 1);
}

static void put_style(FILE *f, const struct postproc_plot *p) {
    fputs("set border 3 lw 1 lc rgb '#5a6068'\n"
          "set tics nomirror out scale 0.6 textcolor rgb '#23282e'\n"
          "set grid back lt 1 lw 0.6 lc rgb '#e4e7ea'\n"
          "set key at screen 0.975, screen 0.975 right top horizontal samplen 2 textcolor rgb '#23282e'\n"
          "set lmargin 13\nset rmargin 4\nset tmargin 4\n"
          "set datafile missing 'nan'\n",
          f);
    fputs("set label 1 ", f);
    put_text(f, p->title);
    fputs(" at screen 0.03, screen 0.955 left noenhanced font ',15' tc rgb '#23282e'\n", f);
    fputs("set xlabel ", f);
    put_text(f, p->xlabel);
    fputs("\nset ylabel ", f);
    put_text(f, p->ylabel);
    fputs(" offset -1,0\n", f);
    if (p->log_y) fputs("set logscale y\nset format y '10^{%T}'\n", f);
    if (p->log_x)
        fputs("set logscale x\nset format x '10^{%T}'\nset mxtics 10\nset mytics 10\n"
              "set key inside left bottom vertical Left reverse\n",
              f);
    if (p->log_x && p->log_y)
        put_log_ranges(f, p);
    else
        put_flat_range(f, p);
    if (isfinite(p->x_low) && isfinite(p->x_high) && p->x_high > p->x_low)
        fprintf(f, "set xrange [%.10g:%.10g]\n", p->x_low, p->x_high);
    for (int k = 0; k < p->marks; k++) {
        fprintf(f,
                "set arrow %d from first %.10g, graph 0 to first %.10g, graph 1 nohead back dt 2 lw 1.2 lc "
                "rgb '#8a9199'\n",
                k + 1, p->mark[k].x, p->mark[k].x);
        fprintf(f, "set label %d ", k + 2);
        put_text(f, p->mark[k].label);
        fprintf(f, " at first %.10g, graph 0.97 left offset 0.6,0 front tc rgb '#5a6068'\n", p->mark[k].x);
    }
}

/* Horizontal lines, and the positions of their labels. */
static void put_levels(FILE *f, const struct postproc_plot *p) {
    for (int k = 0; k < p->levels; k++) {
        fprintf(f,
                "set arrow %d from graph 0, first %.10g to graph 1, first %.10g nohead back dt 2 lw 1.2 lc rgb "
                "'#8a9199'\nset label %d ",
                100 + k, p->level[k].y, p->level[k].y, 100 + k);
        put_text(f, p->level[k].label);
        fprintf(f, " at graph 0.99, first %.10g right offset 0,0.5 front tc rgb '#5a6068'\n", p->level[k].y);
    }
}

static void put_curves(FILE *f, const struct postproc_plot *p) {
    fputs("plot ", f);
    for (int k = 0; k < p->curves; k++) {
        fprintf(f, "%s$curve%d using 1:2 with %s lw 2 lc rgb '%s' ", k ? ", \\\n     " : "", k,
                p->curve[k].bars    ? "histeps"
                : p->curve[k].label ? "linespoints pt 7 ps 1.1"
                                    : "lines",
                palette[k % PALETTE]);
        if (p->curves > 1) {
            fputs("title ", f);
            put_text(f, p->curve[k].title);
            fputs(" noenhanced", f);
        } else
            fputs("notitle", f);
        if (p->curve[k].label)
            fprintf(f,
                    ", \\\n     $curve%d using 1:2:3 with labels left offset 0.8,0.5 noenhanced font ',11' "
                    "tc rgb "
                    "'%s' notitle",
                    k, palette[k % PALETTE]);
    }
    fputc('\n', f);
}

static int script_write(const struct postproc_plot *p, const char *path) {
    FILE *f = fopen(path, "w");
    if (!f) return -1;
    fprintf(f, "# gnuplot %s.gp\n", p->name);
    put_data(f, p);
    put_style(f, p);
    put_levels(f, p);
    fputs("set terminal pngcairo size 1200,760 enhanced font 'DejaVu Sans,13' linewidth 1.4 background "
          "'#ffffff'\n",
          f);
    fprintf(f, "set output '%s.png'\n", p->name);
    put_curves(f, p);
    fputs("set terminal svg size 900,570 enhanced font 'DejaVu Sans,12' linewidth 1.2 background '#ffffff'\n", f);
    fprintf(f, "set output '%s.svg'\nreplot\nset output\n", p->name);
    const int bad = ferror(f);
    return fclose(f) || bad ? -1 : 0;
}

/* Runs gnuplot in the folder, without a shell and without output. */
static enum postproc_plot_status gnuplot_run(const char *folder, const char *script) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", 0, 0);
    char program[] = "gnuplot", name[FOLDER_PATH];
    snprintf(name, sizeof name, "%s", script);
    char *argv[] = {program, name, NULL};
    pid_t pid;
    int status;
    const int fault = posix_spawnp(&pid, program, &actions, NULL, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (fault) return POSTPROC_PLOT_NO_GNUPLOT;
    while (waitpid(pid, &status, 0) < 0)
        if (errno != EINTR) return POSTPROC_PLOT_FAILED;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? POSTPROC_PLOT_DONE : POSTPROC_PLOT_FAILED;
}

enum postproc_plot_status postproc_plot_draw(const struct postproc_plot *p) {
    char path[FOLDER_PATH], script[256];
    snprintf(script, sizeof script, "%s.gp", p->name);
    if (script_write(p, folder_path(path, p->folder, script))) return POSTPROC_PLOT_NO_FILE;
    return gnuplot_run(p->folder, script);
}
