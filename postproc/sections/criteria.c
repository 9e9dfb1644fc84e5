/* Section of the report that asks which strain or stress, before bonds may break, tells which particles lose bonds. */
#include "base/memory.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "postproc/data/roc.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>

enum { UNTIL = 2 };
static const char *const until_name[UNTIL] = {"first", "end"};

/* Whether the files have the same particles in the same order. Positions are in single precision. */
static int are_same(const struct postproc_body *a, const struct postproc_body *b, double spacing) {
    if (a->n != b->n || !a->displacement || !b->displacement) return 0;
    for (long i = 0; i < a->n; i++)
        for (int c = 0; c < 3; c++) {
            const double difference =
                (a->x[i][c] - a->displacement[3 * i + c]) - (b->x[i][c] - b->displacement[3 * i + c]);
            if (fabs(difference) > 0.1 * spacing) return 0;
        }
    return 1;
}

/* Marks the particles whose damage grew; damage in the files is in single precision. Returns their number. */
static long grown(const struct postproc_body *before, const struct postproc_body *after, uint8_t *broke) {
    long n = 0;
    for (long i = 0; i < before->n; i++) n += broke[i] = after->damage[i] > before->damage[i] + 1e-6;
    return n;
}

/* The first file after `before` in which a particle has lost a bond, or NULL. */
static struct postproc_body *first_broken(const struct postproc_history *h, const struct postproc_body *before,
                                          uint8_t *broke) {
    for (int f = 0; f < h->solid.n; f++) {
        if (h->solid.entry[f].time <= before->time * (1 + 1e-9)) continue;
        struct postproc_body *b = postproc_body_new(h, h->solid.entry[f].time);
        if (b && b->damage && are_same(before, b, h->spacing) && grown(before, b, broke)) return b;
        postproc_body_free(b);
    }
    return NULL;
}

static void add_facts(struct postproc_output *out, const char *title, const char *unit, const char *until,
                      const struct postproc_roc *r) {
    postproc_facts_number(&out->facts, NAMED("%s, area under hits over false alarms, %s", title, until), "1", r->area);
    postproc_facts_number(&out->facts, NAMED("%s, best threshold, %s", title, until), unit, r->threshold);
    postproc_facts_number(&out->facts, NAMED("%s, hits at it, %s", title, until), "1", r->hits);
    postproc_facts_number(&out->facts, NAMED("%s, false alarms at it, %s", title, until), "1", r->false_ones);
}

/* A row for each criterion. broke: by particle; value and mark: scratch [n]. */
static void evaluate(struct postproc_output *out, const struct postproc_history *h, FILE *file, int until, double time,
                     const struct postproc_body *before, const uint8_t *broke, double *value, uint8_t *mark) {
    static const enum postproc_measure criterion[] = {POSTPROC_STRAIN, POSTPROC_STRESS, POSTPROC_VON_MISES,
                                                      POSTPROC_GRIFFITH};
    for (size_t k = 0; k < sizeof criterion / sizeof *criterion; k++) {
        const struct postproc_body_kind *is = &postproc_body_kind[criterion[k]];
        const double *measure = before->measure[criterion[k]], critical = postproc_body_threshold(criterion[k], h);
        long m = 0;
        for (long i = 0; measure && i < before->n; i++) {
            if ((before->held && before->held[i] != 0) || before->damage[i] > 1 - 1e-6) continue;
            value[m] = measure[i];
            mark[m++] = broke[i];
        }
        if (!m) continue;
        const struct postproc_roc r = postproc_roc_new(m, value, mark);
        double hits, false_ones;
        postproc_roc_at(m, value, mark, critical, &hits, &false_ones);
        fprintf(file, "%s,%s,%.10g,%ld,%ld,%.6g,%.10g,%.6g,%.6g,%.10g,%.6g,%.6g\n", is->title, until_name[until], time,
                r.n, r.become, r.area, r.threshold, r.hits, r.false_ones, critical, hits, false_ones);
        add_facts(out, is->title, is->unit, until_name[until], &r);
    }
}

static void write_table(struct postproc_output *out, const struct postproc_history *h,
                        const struct postproc_body *before, struct postproc_body *const after[UNTIL], uint8_t *broke) {
    char path[FOLDER_PATH];
    FILE *file = atomic_write_open(folder_path(path, out->folder, "criteria.csv"));
    if (!file) {
        postproc_sections_fail(out, path);
        return;
    }
    double *value = memory_new(MEMORY_OUTPUT, (size_t)before->n + 1, sizeof *value);
    uint8_t *mark = memory_new(MEMORY_OUTPUT, (size_t)before->n + 1, 1);
    fprintf(file, "criterion,until,t,particles,broke,area,threshold,hits,false_alarms,critical,hits_at_critical,"
                  "false_alarms_at_critical\n#,1,s,1,1,1,1 or Pa,1,1,1 or Pa,1,1\n");
    for (int u = 0; u < UNTIL; u++) {
        if (!after[u] || !grown(before, after[u], broke)) continue;
        evaluate(out, h, file, u, after[u]->time, before, broke, value, mark);
    }
    MEMORY_FREE(value, mark);
    const int bad = ferror(file);
    if (atomic_write_close(file, path, bad)) postproc_sections_fail(out, path);
}

void postproc_sections_criteria(struct postproc_output *out, const struct postproc_history *h) {
    struct postproc_body *before = postproc_body_before(h), *after[UNTIL] = {NULL, NULL};
    char path[FOLDER_PATH];
    remove(folder_path(path, out->folder, "criteria.csv")); /* of an earlier call that had a state before */
    if (!before) return;
    uint8_t *broke = memory_new(MEMORY_OUTPUT, (size_t)before->n + 1, 1);
    if (before->damage && before->displacement) after[0] = first_broken(h, before, broke);
    if (after[0]) after[1] = postproc_body_new(h, h->end);
    if (after[1] && after[1]->damage && are_same(before, after[1], h->spacing))
        write_table(out, h, before, after, broke);
    for (int u = 0; u < UNTIL; u++) postproc_body_free(after[u]);
    postproc_body_free(before);
    memory_free(broke);
}
