/* Section of the report with distributions of strain and of stresses, and the shares beyond the critical ones. */
#include "base/memory.h"
#include "base/arena.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "postproc/data/pdf.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void pdf_table(FILE *file, const char *when, double time, const struct postproc_pdf *p) {
    for (int i = 0; i < p->bins; i++)
        fprintf(file, "%s,%.10g,%.10g,%.10g,%.10g\n", when, time, p->low + i * p->width, p->low + (i + 1) * p->width,
                p->density[i]);
}

/* body[2]: at the end of settling, and at the end; the same file twice is drawn once. */
static void pdf_draw(struct postproc_output *out, const struct postproc_history *h, enum postproc_measure kind,
                     struct postproc_body *const body[2]) {
    const struct postproc_body_kind *is = &postproc_body_kind[kind];
    struct postproc_pdf pdf[2] = {{0}};
    struct postproc_curve curve[2];
    double *middle[2] = {NULL, NULL};
    char path[FOLDER_PATH], file_name[64], title[2][64];
    int curves = 0, filled = 0;
    const double threshold = postproc_body_threshold(kind, h);
    static const char *const when[2] = {"before", "after"};
    snprintf(file_name, sizeof file_name, "%s.csv", is->name);
    FILE *file = atomic_write_open(folder_path(path, out->folder, file_name));
    if (!file) {
        postproc_sections_fail(out, path);
        return;
    }
    fprintf(file, "field,t,low,high,density\n#,s,%s,%s,1/(%s)\n", is->unit, is->unit, is->unit);
    for (int b = 0; b < 2; b++) {
        const double *value = !body[b] ? NULL : body[b]->measure[kind];
        if (!value) continue;
        long m;
        double *sample = postproc_body_sample(body[b], value, &m);
        pdf[b] = postproc_pdf_new(m, sample);
        if (pdf[b].n > 0) {
            filled = 1;
            pdf_table(file, when[b], body[b]->time, &pdf[b]);
            if (pdf[b].bins > 1) { /* equal values, as before any load, make no curve */
                const double t = postproc_history_when(h, body[b]->time);
                middle[b] = arena_new((size_t)pdf[b].bins, sizeof(double));
                for (int i = 0; i < pdf[b].bins; i++) middle[b][i] = pdf[b].low + (i + 0.5) * pdf[b].width;
                snprintf(title[b], sizeof *title, "%s = %.3g", h->t0 > 0 ? "t/t0" : "t [s]", fabs(t) < 1e-9 ? 0 : t);
                curve[curves++] = (struct postproc_curve){
                    .title = title[b], .n = pdf[b].bins, .x = middle[b], .y = pdf[b].density, .bars = 1};
            }
            postproc_facts_number(&out->facts, NAMED("%s, mean, %s", is->title, when[b]), is->unit, pdf[b].mean);
            postproc_facts_number(&out->facts,
                                  NAMED("%s, %s, %s", is->title, is->is_least ? "smallest" : "largest", when[b]),
                                  is->unit, is->is_least ? pdf[b].smallest : pdf[b].largest);
            if (threshold > 0) {
                postproc_facts_number(&out->facts, NAMED("%s, share above %s, %s", is->title, is->mark, when[b]), "1",
                                      postproc_pdf_above(m, sample, threshold));
            }
        }
        memory_free(sample);
    }
    const int bad = ferror(file);
    if (atomic_write_close(file, path, bad)) postproc_sections_fail(out, path);
    char folder[FOLDER_PATH];
    const struct postproc_mark mark = {threshold, is->label};
    postproc_charts_add(&out->charts, &(struct postproc_plot){
                                          .folder = folder_path(folder, out->folder, "plots"),
                                          .name = is->name,
                                          .title = is->title,
                                          .xlabel = is->xlabel,
                                          .ylabel = "probability density",
                                          .curves = curves,
                                          .curve = curve,
                                          .marks = threshold > 0,
                                          .mark = &mark,
                                          .log_y = 1,
                                      });
    if (!filled) remove(path);
}

void postproc_sections_pdf(struct postproc_output *out, const struct postproc_history *h) {
    struct postproc_body *body[2] = {postproc_body_before(h), postproc_body_new(h, h->end)};
    if (body[0] && body[1] && body[0]->step == body[1]->step) {
        postproc_body_free(body[0]);
        body[0] = NULL;
    }
    for (int kind = 0; kind < POSTPROC_MEASURES; kind++) pdf_draw(out, h, (enum postproc_measure)kind, body);
    postproc_body_free(body[0]);
    postproc_body_free(body[1]);
}
