/* Reads the particles of a block at one time, and finds where its damage begins. */
#include "postproc/data/body.h"
#include "base/memory.h"
#include "physics/griffith.h"

#include <math.h>
#include <stdlib.h>

#define STRESS(its_name, its_title, its_label)                                                                         \
    .name = its_name, .unit = "Pa", .title = its_title, .at_end = its_title " at the end", .xlabel = its_label "  [Pa]"

const struct postproc_body_kind postproc_body_kind[POSTPROC_MEASURES] = {
    [POSTPROC_STRAIN] = {"pdf_strain", "1", "Largest principal strain", "Largest principal strain at the end",
                         "largest principal strain", "s0", "s_0", .is_strain = 1},
    [POSTPROC_STRESS] = {STRESS("pdf_stress", "Largest principal stress", "largest principal stress"), .mark = "sigma0",
                         .label = "{/Symbol s}_0"},
    [POSTPROC_STRESS_MIDDLE] = {STRESS("pdf_stress_middle", "Middle principal stress", "middle principal stress")},
    [POSTPROC_STRESS_LEAST] = {STRESS("pdf_stress_least", "Least principal stress", "least principal stress"),
                               .is_least = 1},
    [POSTPROC_VON_MISES] = {STRESS("pdf_von_mises", "Von Mises stress", "von Mises stress"), .mark = "sigma0",
                            .label = "{/Symbol s}_0"},
    [POSTPROC_GRIFFITH] = {STRESS("pdf_griffith", "Equivalent tension by Griffith", "equivalent tension by Griffith"),
                           .mark = "sigma0", .label = "{/Symbol s}_0"},
};

#undef STRESS

double postproc_body_threshold(enum postproc_measure kind, const struct postproc_history *h) {
    const struct postproc_body_kind *k = &postproc_body_kind[kind];
    return !k->mark ? NAN : k->is_strain ? h->s0 : h->sigma0;
}

/* Middle and least principal stress, and Griffith's tension. Fields of an earlier frana lack them. */
static void read_principal(struct postproc_body *b, struct vtkhdf_source *source) {
    double *all = vtkhdf_read_double(source, "stress_principal");
    if (!all) return;
    for (int k = 0; k < 3; k++) {
        static const enum postproc_measure measures[3] = {POSTPROC_STRESS_MIDDLE, POSTPROC_STRESS_LEAST,
                                                          POSTPROC_GRIFFITH};
        double *value = b->measure[measures[k]] = calloc((size_t)b->n + 1, sizeof *value);
        for (long i = 0; i < b->n; i++)
            value[i] = measures[k] == POSTPROC_GRIFFITH ? physics_griffith_tension(all + 3 * i) : all[3 * i + 1 + k];
    }
    free(all);
}

struct postproc_body *postproc_body_new(const struct postproc_history *h, double t) {
    struct vtkhdf_source *source = postproc_history_open(h, &h->solid, t);
    if (!source) return NULL;
    struct postproc_body *b = calloc(1, sizeof *b);
    b->n = source->points;
    b->time = source->time;
    b->step = source->step;
    b->x = vtkhdf_read_points(source);
    b->displacement = vtkhdf_read_double(source, "displacement");
    b->damage = vtkhdf_read_double(source, "damage");
    b->held = vtkhdf_read_double(source, "held");
    b->measure[POSTPROC_STRAIN] = vtkhdf_read_double(source, "strain_max");
    b->measure[POSTPROC_STRESS] = vtkhdf_read_double(source, "stress_max");
    b->measure[POSTPROC_VON_MISES] = vtkhdf_read_double(source, "von_mises");
    read_principal(b, source);
    vtkhdf_read_close(source);
    return b;
}

struct postproc_body *postproc_body_before(const struct postproc_history *h) {
    for (const struct postproc_history *its = h; its; its = its->earlier)
        if (its->solid.n > 0 && its->solid.entry[0].time <= h->origin * (1 + 1e-9))
            return postproc_body_new(its, h->origin);
    return NULL;
}

void postproc_body_free(struct postproc_body *b) {
    if (!b) return;
    free(b->x);
    free(b->displacement);
    free(b->damage);
    free(b->held);
    for (int k = 0; k < POSTPROC_MEASURES; k++) free(b->measure[k]);
    free(b);
}

double *postproc_body_sample(const struct postproc_body *b, const double *value, long *m) {
    double *sample = memory_new(MEMORY_OUTPUT, (size_t)b->n + 1, sizeof *sample);
    *m = 0;
    for (long i = 0; i < b->n; i++) {
        if ((b->held && b->held[i] != 0) || (b->damage && b->damage[i] > 1 - 1e-6)) continue;
        sample[(*m)++] = value[i];
    }
    return sample;
}

void postproc_body_box(const struct postproc_history *h, const struct postproc_body *b, double low[3], double high[3]) {
    const struct scene_coupling *c = h->scene->coupling;
    for (int k = 0; k < 3; k++) {
        if (c && c->box_high[k] > c->box_low[k]) {
            low[k] = c->box_low[k];
            high[k] = c->box_high[k];
            continue;
        }
        low[k] = INFINITY;
        high[k] = -INFINITY;
        for (long i = 0; i < b->n; i++) {
            const double x0 = b->x[i][k] - (b->displacement ? b->displacement[3 * i + k] : 0);
            low[k] = fmin(low[k], x0 - 0.5 * h->spacing);
            high[k] = fmax(high[k], x0 + 0.5 * h->spacing);
        }
        low[k] = fmax(low[k], 0);
        high[k] = fmin(high[k], h->scene->domain.size[k]);
    }
}

/* The shares of the damage in the thirds of the box along each axis; what is beyond counts to the outer third. */
static void thirds(const struct postproc_body *b, const double low[3], const double high[3], double share[3][3]) {
    double sum = 0;
    for (long i = 0; i < b->n; i++) {
        if (!(b->damage[i] > 1e-9)) continue;
        sum += b->damage[i];
        for (int k = 0; k < 3; k++) {
            const double x0 = b->x[i][k] - (b->displacement ? b->displacement[3 * i + k] : 0);
            const double at = (x0 - low[k]) / (high[k] - low[k]);
            share[k][at < 1 / 3. ? 0 : at > 2 / 3. ? 2 : 1] += b->damage[i];
        }
    }
    for (int k = 0; k < 9; k++) share[k / 3][k % 3] /= sum;
}

struct postproc_onset postproc_body_onset(const struct postproc_history *h) {
    struct postproc_onset onset = {0};
    for (int f = 0; f < h->solid.n && !onset.found; f++) {
        struct postproc_body *b = postproc_body_new(h, h->solid.entry[f].time);
        if (!b) continue;
        double sum = 0;
        for (long i = 0; b->damage && i < b->n; i++) {
            if (!(b->damage[i] > 1e-9)) continue;
            sum += b->damage[i];
            onset.particles++;
            for (int k = 0; k < 3; k++)
                onset.x[k] += b->damage[i] * (b->x[i][k] - (b->displacement ? b->displacement[3 * i + k] : 0));
        }
        if (sum > 0) {
            double low[3], high[3];
            postproc_body_box(h, b, low, high);
            onset.found = 1;
            onset.time = b->time;
            for (int k = 0; k < 3; k++) {
                onset.x[k] /= sum;
                onset.fraction[k] = (onset.x[k] - low[k]) / (high[k] - low[k]);
            }
            thirds(b, low, high, onset.third);
            const double at = onset.fraction[postproc_history_axis(h)];
            onset.where = at < 1 / 3. ? "front" : at > 2 / 3. ? "back" : "middle";
        }
        postproc_body_free(b);
    }
    return onset;
}
