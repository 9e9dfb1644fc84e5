/* Section of the report with the pressure along the channel. */
#include "base/files/folder.h"
#include "base/files/atomic_write.h"
#include "postproc/data/profile.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>

static int profile_table(const struct postproc_profile *p, int axis, const char *path) {
    FILE *file = atomic_write_open(path);
    if (!file) return -1;
    const struct postproc_profile *a = &p[0], *b = &p[1];
    fprintf(file,
            "%c,pressure_before,pressure_fluid_before,porosity_before,pressure_after,pressure_fluid_after,"
            "porosity_after\n"
            "#m,Pa,Pa,1,Pa,Pa,1\n",
            "xyz"[axis]);
    for (int i = 0; i < b->n; i++) {
        fprintf(file, "%.10g", b->x[i]);
        for (int k = 0; k < 2; k++) {
            const struct postproc_profile *q = k ? b : a;
            const int have = i < q->n;
            fprintf(file, ",%.10g,%.10g,%.10g", have ? q->pressure[i] : NAN, have && q->fluid ? q->fluid[i] : NAN,
                    have && q->porosity ? q->porosity[i] : NAN);
        }
        fputc('\n', file);
    }
    const int bad = ferror(file);
    return atomic_write_close(file, path, bad);
}

void postproc_sections_profile(struct postproc_output *out, const struct postproc_history *h) {
    struct postproc_profile p[2] = {postproc_profile_new(h, h->origin), postproc_profile_new(h, h->end)};
    const int axis = postproc_history_axis(h);
    if (p[1].n > 0) {
        static const char *const xlabel[3] = {"x  [m]", "y  [m]", "z  [m]"};
        char path[FOLDER_PATH], folder[FOLDER_PATH], title[2][64];
        if (p[0].time >= p[1].time) p[0].n = 0;
        if (profile_table(p, axis, folder_path(path, out->folder, "pressure.csv"))) postproc_sections_fail(out, path);
        struct postproc_curve curve[2];
        int curves = 0;
        for (int k = 0; k < 2; k++) {
            if (p[k].n == 0) continue;
            const double when = postproc_history_when(h, p[k].time);
            snprintf(title[k], sizeof *title, "%s = %.3g", h->t0 > 0 ? "t/t0" : "t [s]", fabs(when) < 1e-9 ? 0 : when);
            curve[curves++] = (struct postproc_curve){
                .title = title[k], .n = p[k].n, .x = p[k].x, .y = p[k].fluid ? p[k].fluid : p[k].pressure};
        }
        struct postproc_mark mark[2] = {{0, "front"}, {0, "back"}};
        const struct scene_coupling *c = h->scene->coupling;
        const int box = c && c->box_high[axis] > c->box_low[axis];
        if (box) {
            mark[0].x = c->box_low[axis];
            mark[1].x = c->box_high[axis];
        }
        postproc_charts_add(&out->charts, &(struct postproc_plot){
                                              .folder = folder_path(folder, out->folder, "plots"),
                                              .name = "pressure",
                                              .title = "Mean pressure of the sections along the channel",
                                              .xlabel = xlabel[axis],
                                              .ylabel = "pressure  [Pa]",
                                              .curves = curves,
                                              .curve = curve,
                                              .marks = box ? 2 : 0,
                                              .mark = mark,
                                              .x_low = 0,
                                              .x_high = h->scene->domain.size[axis],
                                          });
    }
}
