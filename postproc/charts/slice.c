/* Writes the gnuplot script of a plane of the fluid and runs it. */
#include "postproc/charts/slice.h"
#include "base/files/atomic_write.h"
#include "base/memory.h"
#include "base/files/folder.h"
#include "postproc/charts/plot.h"

#include <math.h>
#include <stdio.h>

enum { COLOURS = 32, SHARP = 400, THIN = 3 };

/* Pixels of the picture and of the room around the plane. */
enum { LEFT = 95, RIGHT = 175, TOP = 115, BOTTOM = 92, LONG = 930, TALL = 760, SHORT = 150 };
struct layout {
    int wide, high;
};

/* The plane fills a box of LONG by TALL pixels in one of its directions. */
static struct layout layout_of(const double size[2]) {
    const double scale = fmin(LONG / size[0], TALL / size[1]);
    return (struct layout){LEFT + RIGHT + (int)fmax(scale * size[0], 3 * SHORT),
                           TOP + BOTTOM + (int)fmax(scale * size[1], SHORT)};
}

/* How often a cell is repeated in both directions, so that viewers that smooth an image do not blur the cells. */
static int repeat_of(const struct postproc_slice *s) {
    const int n = s->n[0] > s->n[1] ? s->n[0] : s->n[1];
    return n < SHARP ? (SHARP + n - 1) / n : 1;
}

/* Power of ten of the numbers at the colour bar. */
static int power_of(const struct postproc_slice_plot *p) {
    return postproc_gnuplot_power(fmax(fabs(p->low), fabs(p->high)));
}

/* The values over the power of ten: gnuplot reads plain values in a third of the time that `using` with a formula
 * takes. */
static int values_write(const struct postproc_slice_plot *p, const char *path) {
    FILE *f = atomic_write_open(path);
    if (!f) return -1;
    const int repeat = repeat_of(p->slice), n = p->slice->n[0] * repeat;
    const double unit = pow(10, power_of(p));
    float *row = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *row);
    for (int j = 0; j < p->slice->n[1]; j++) {
        for (int i = 0; i < n; i++)
            row[i] = (float)(p->value[(size_t)j * (size_t)p->slice->n[0] + (size_t)(i / repeat)] / unit);
        for (int k = 0; k < repeat; k++) fwrite(row, sizeof *row, (size_t)n, f);
    }
    memory_free(row);
    const int bad = ferror(f);
    return atomic_write_close(f, path, bad);
}

/* Lines, and an arrowhead in the middle of each: its tail and the vector to its head. */
static void put_lines(FILE *f, const struct postproc_stream *s, double unit) {
    fputs("$lines << EOD\n", f);
    for (int k = 0; k < s->lines; k++) {
        const long last = s->first[k + 1] - 1;
        for (long i = s->first[k]; i <= last; i = i < last && i + THIN > last ? last : i + THIN)
            fprintf(f, "%.6g %.6g\n", s->x[i][0] / unit, s->x[i][1] / unit);
        fputc('\n', f);
    }
    fputs("EOD\n$heads << EOD\n", f);
    for (int k = 0; k < s->lines; k++) {
        const long i = (s->first[k] + s->first[k + 1]) / 2;
        if (i < s->first[k] + 1) continue;
        fprintf(f, "%.6g %.6g %.6g %.6g\n", s->x[i - 1][0] / unit, s->x[i - 1][1] / unit,
                (s->x[i][0] - s->x[i - 1][0]) / unit, (s->x[i][1] - s->x[i - 1][1]) / unit);
    }
    fputs("EOD\n", f);
}

void postproc_slice_palette(FILE *f, enum postproc_map map, int bands) {
    const int nodes = bands ? bands : COLOURS;
    fputs("set palette ", f);
    if (bands) fprintf(f, "maxcolors %d ", bands);
    fputs("defined (", f);
    for (int k = 0; k <= nodes; k++) {
        double srgb[3];
        postproc_colour_map(map, (double)k / nodes, srgb);
        fprintf(f, "%s%d '#%02x%02x%02x'", k ? ", " : "", k, (unsigned)lround(255 * srgb[0]),
                (unsigned)lround(255 * srgb[1]), (unsigned)lround(255 * srgb[2]));
    }
    fputs(")\n", f);
}

static void put_style(FILE *f, const struct postproc_slice_plot *p, const char *unit, const double size[2],
                      const struct layout *at) {
    static const char *const name[3] = {"x", "y", "z"};
    const int power = power_of(p);
    fputs("set encoding utf8\nset border 15 lw 1 lc rgb '#5a6068'\nset tics nomirror out scale 0.6 textcolor rgb "
          "'#23282e'\nunset key\n"
          "set size ratio -1\nset object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb '#b9bdc2' fs solid "
          "noborder\n",
          f);
    fputs("set label 1 ", f);
    postproc_gnuplot_text(f, p->title);
    fprintf(f, " at screen %.6g, screen %.6g left noenhanced font ',15' tc rgb '#23282e'\nset label 4 ",
            20.0 / at->wide, 1 - 26.0 / at->high);
    postproc_gnuplot_text(f, p->subtitle);
    fprintf(f, " at screen %.6g, screen %.6g left noenhanced tc rgb '#5a6068'\n", 20.0 / at->wide, 1 - 54.0 / at->high);
    fprintf(f,
            "set lmargin at screen %.6g\nset rmargin at screen %.6g\nset tmargin at screen %.6g\nset bmargin at screen "
            "%.6g\n",
            (double)LEFT / at->wide, 1 - (double)RIGHT / at->wide, 1 - (double)TOP / at->high,
            (double)BOTTOM / at->high);
    fprintf(f, "set xlabel '%s  [%s]'\nset ylabel '%s  [%s]'\n", name[p->slice->across[0]], unit,
            name[p->slice->across[1]], unit);
    fputs("set label 2 ", f);
    postproc_gnuplot_text(f, p->label);
    fprintf(f, " at graph 1, graph 1 left offset 1,%g noenhanced tc rgb '#23282e'\n", power ? 2.3 : 0.9);
    if (power) fprintf(f, "set label 3 '× 10^{%d}' at graph 1, graph 1 left offset 1,0.9 tc rgb '#23282e'\n", power);
    postproc_slice_palette(f, p->map, 0);
    fprintf(f, "set xrange [0:%.10g]\nset yrange [0:%.10g]\nset cbrange [%.10g:%.10g]\n", size[0], size[1],
            p->low / pow(10, power), p->high / pow(10, power));
    const int repeat = repeat_of(p->slice), n[2] = {repeat * p->slice->n[0], repeat * p->slice->n[1]};
    const double d[2] = {size[0] / n[0], size[1] / n[1]};
    fprintf(f, "plot '%s.bin' binary array=(%d,%d) format='%%float' dx=%.10g dy=%.10g origin=(%.10g,%.10g) with image",
            p->name, n[0], n[1], d[0], d[1], 0.5 * d[0], 0.5 * d[1]);
    if (p->lines && p->lines->lines > 0)
        for (int k = 0; k < 2; k++) { /* white on a dark rim, to be seen on all colours */
            const char *colour = k ? "#20ffffff" : "#80000000";
            const double width = k ? 1.1 : 2.6;
            fprintf(
                f,
                ", \\\n     $lines using 1:2 with lines lw %g lc rgb '%s', \\\n     $heads using 1:2:3:4 with vectors "
                "head filled size screen 0.009,22 fixed lw %g lc rgb '%s'",
                width, colour, width, colour);
        }
    fputc('\n', f);
}

enum postproc_plot_status postproc_slice_draw(const struct postproc_slice_plot *p) {
    char path[FOLDER_PATH], file[256];
    snprintf(file, sizeof file, "%s.bin", p->name);
    if (values_write(p, folder_path(path, p->folder, file))) return POSTPROC_PLOT_NO_FILE;
    FILE *f = postproc_gnuplot_script_new(p->folder, p->name);
    if (!f) return POSTPROC_PLOT_NO_FILE;
    const struct postproc_slice *s = p->slice;
    const char *unit;
    const double length = postproc_plot_unit(fmax(s->n[0] * s->d[0], s->n[1] * s->d[1]), &unit);
    const double size[2] = {s->n[0] * s->d[0] / length, s->n[1] * s->d[1] / length};
    const struct layout at = layout_of(size);
    if (p->lines) put_lines(f, p->lines, length);
    postproc_gnuplot_terminal(f, POSTPROC_PNG, p->name, at.wide, at.high);
    put_style(f, p, unit, size, &at);
    if (p->all) postproc_gnuplot_again(f, p->name, at.wide, at.high, "refresh"); /* reads the values once */
    return postproc_gnuplot_script_end(f, p->folder, p->name);
}
