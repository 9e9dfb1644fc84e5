/* frana post for one run: makes the folders, runs each section, writes the report. */
#include "postproc/post.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/arena.h"
#include "base/files/folder.h"
#include "postproc/draw/film.h"
#include "postproc/gnuplot.h"
#include "postproc/report.h"
#include "postproc/sections/sections.h"
#include "postproc/timeline.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static int refuse(const char *path, int fault) {
    fprintf(stderr, "frana: %s: cannot be written: %s\n", path, strerror(fault));
    return EXIT_CODE_FILE;
}

/* Makes the folders of the results. Returns 0 or errno. */
static int make_folders(const char *post, int film) {
    static const char *const inside[] = {"plots", "pictures", "film"};
    char path[FOLDER_PATH];
    if (mkdir(post, 0777) != 0 && errno != EEXIST) return errno;
    for (int k = 0; k < 2 + film; k++)
        if (mkdir(folder_path(path, post, inside[k]), 0777) != 0 && errno != EEXIST) return errno;
    return 0;
}

/* Writes a heading and the facts that a section has added, if there are any. */
static void report_section(struct postproc_report *r, const struct postproc_output *out, const char *heading, int first,
                           int last) {
    if (last <= first) return;
    postproc_report_heading(r, heading);
    postproc_report_facts(r, &out->facts, first, last);
}

/* At most FRAMES pictures of the film, evenly spread, for the page would grow without bound. */
static void report_film(struct postproc_report *r, const struct postproc_output *out) {
    enum { FRAMES = 40 };
    char path[FRAMES][128];
    const char *all[FRAMES];
    const int n = out->frames < FRAMES ? out->frames : FRAMES;
    if (n == 0) return;
    for (int k = 0; k < n; k++) {
        const int frame = n < 2 ? 1 : 1 + (int)((long)k * (out->frames - 1) / (n - 1));
        snprintf(path[k], sizeof *path, "film/%s_%04d.png", out->film, frame);
        all[k] = path[k];
    }
    postproc_report_heading(r, "Film");
    postproc_report_film(r, n, all, out->film_title);
}

/* All pictures of the film as one file, film/NAME.png, twelve a second. */
static void film_write(struct postproc_output *out) {
    char folder[FOLDER_PATH], path[FOLDER_PATH], name[96];
    if (out->frames == 0) return;
    snprintf(name, sizeof name, "film/%s.png", out->film);
    if (postproc_film_write(folder_path(path, out->folder, name), folder_path(folder, out->folder, "film"), out->film,
                            out->frames, 1000 / 12) < 0)
        postproc_sections_fail(out, path);
}

static void report_images(struct postproc_report *r, const struct postproc_output *out) {
    char path[128];
    if (out->pictures) postproc_report_heading(r, "Pictures");
    for (int k = 0; k < out->pictures; k++) {
        snprintf(path, sizeof path, "pictures/%s.png", out->picture[k].name);
        postproc_report_image(r, path, out->picture[k].title);
    }
    report_film(r, out);
    if (out->charts.n) postproc_report_heading(r, "Plots");
    for (int k = 0; k < out->charts.n; k++) {
        snprintf(path, sizeof path, "plots/%s.png", out->charts.name[k]);
        postproc_report_image(r, path, out->charts.title[k]);
    }
}

static const char *plots_missing(enum postproc_plot_status status) {
    switch (status) {
    case POSTPROC_PLOT_NO_GNUPLOT:
        return "No plots and no slices of the fluid: gnuplot was not found. Their scripts are in post/plots and "
               "post/pictures (*.gp).";
    case POSTPROC_PLOT_NO_FILE:
        return "No plots: their scripts could not be written.";
    case POSTPROC_PLOT_FAILED:
        return "Some plots are missing: gnuplot did not accept their scripts in post/plots or "
               "post/pictures (*.gp).";
    case POSTPROC_PLOT_DONE:
        return NULL;
    }
    ENSURE(0, "plots end with %d", (int)status);
}

int postproc_post(const char *rundir, const struct postproc_options *options) {
    static const struct {
        const char *heading;
        void (*add)(struct postproc_output *out, const struct postproc_history *h);
    } section[] = {
        {"The run", postproc_sections_run},
        {"The solution", postproc_sections_solution},
        {"The medium", postproc_sections_medium},
        {"Fracture", postproc_sections_fracture},
        {"Fragments", postproc_sections_fragments},
        {"Events", postproc_sections_events},
        {"Azimuthal modes of the damage", postproc_sections_modes},
        {"The crack", postproc_sections_crack},
        {"Fluid in the cracks", postproc_sections_crack_fluid},
        {"Strain and stress", postproc_sections_pdf},
        {"What tells beforehand where it breaks", postproc_sections_criteria},
        {"Where the time went", postproc_sections_wall},
        {NULL, postproc_sections_profile},
        {"Streamlines", postproc_sections_pictures},
        {NULL, postproc_sections_flow},
        {NULL, postproc_sections_plate},
        {NULL, postproc_sections_element_free},
        {NULL, postproc_sections_arrangement},
    };
    enum { SECTIONS = sizeof section / sizeof *section };
    char error[FOLDER_PATH + 256], post[FOLDER_PATH], plots[FOLDER_PATH], path[FOLDER_PATH];
    struct postproc_history *h = postproc_history_new(rundir, error, sizeof error);
    if (!h) {
        fprintf(stderr, "frana: %s\n", error);
        return EXIT_CODE_FILE;
    }
    for (int c = 0; c < 3 && options; c++) {
        const double size = h->scene->domain.size[c];
        if (!options->sliced[c] || (options->slice[c] >= 0 && options->slice[c] <= size)) continue;
        fprintf(stderr, "frana: --slice %c=%g: must be in the domain, from 0 to %g m\n", "xyz"[c], options -> slice[c],
                size);
        postproc_history_free(h);
        return EXIT_CODE_SCENE;
    }
    if (options && options->before && !(h->earlier = postproc_history_new(options->before, error, sizeof error))) {
        fprintf(stderr, "frana: --before: %s\n", error);
        postproc_history_free(h);
        return EXIT_CODE_FILE;
    }
    struct postproc_output *out = calloc(1, sizeof *out);
    int code = EXIT_CODE_DONE, last[SECTIONS];
    out->folder = folder_path(post, rundir, "post");
    if (options) out->options = *options;
    if (!out->options.width) out->options.width = 1400;
    struct postproc_report *report = NULL;
    int fault = make_folders(post, out->options.film);
    if (!fault && !(report = postproc_report_begin(post, h->scene->title[0] ? h->scene->title : rundir))) fault = errno;
    if (fault) {
        code = refuse(post, fault);
        goto end;
    }
    folder_path(plots, post, "plots");
    postproc_charts_draw(&out->charts, 1, &h, &rundir, plots);
    postproc_charts_crack_draw(&out->charts, 1, &h, &rundir, plots);
    postproc_charts_reactions_draw(&out->charts, h, plots);
    postproc_charts_intrinsic_draw(&out->charts, h, plots);
    postproc_charts_texture_draw(&out->charts, h, plots);
    for (int k = 0; k < SECTIONS; k++) {
        section[k].add(out, h);
        last[k] = out->facts.n;
        if (section[k].heading) report_section(report, out, section[k].heading, k ? last[k - 1] : 0, last[k]);
        if (section[k].add == postproc_sections_wall) postproc_timeline_report(report, h->record);
    }
    film_write(out);
    report_images(report, out);
    const char *missing = plots_missing(out->charts.worst);
    if (missing) {
        fprintf(stderr, "frana: %s: %s\n", rundir, missing);
        postproc_report_text(report, missing);
    }
    if (postproc_report_end(report)) postproc_sections_fail(out, post);
    if (postproc_facts_write(&out->facts, folder_path(path, post, "summary.csv"))) postproc_sections_fail(out, path);
    if (out->failed)
        code = refuse(out->failed_path, out->failed);
    else
        printf("%s: report.md, report.html, summary.csv, %d plots, %d pictures\n", post, out->charts.n, out->pictures);
end:
    postproc_gnuplot_end();
    postproc_history_free(h);
    free(out);
    arena_free();
    return code;
}
