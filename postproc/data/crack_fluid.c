/* Reads the cracks' fluid in the field file of a plate or of a block. */
#include "postproc/data/crack_fluid.h"
#include "cracks/cracks.h"
#include "scene/notch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MARGIN = 6 }; /* spacings around the cracks that are drawn */

/* A field file's particles. */
struct fields {
    long n;
    double (*x)[3], (*u)[3]; /* at the start; displacement */
    double *pressure, *aperture, *area, *volume;
};

double postproc_crack_fluid_least_aperture(const struct postproc_history *h) {
    const struct scene *s = h->scene;
    if (s->crack_fluid->least_aperture > 0) return s->crack_fluid->least_aperture;
    const double e = s->solid->material[s->solid->body[0].material_index].youngs_modulus;
    return CRACKS_LEAST_STRETCH * scene_notch_limit(s) / e * h->spacing;
}

static void fields_free(struct fields *f) {
    void *const all[] = {f->x, f->u, f->pressure, f->aperture, f->area, f->volume};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) free(all[k]);
}

/* n is 0 if the file lacks one of the fields. */
static struct fields fields_of(struct vtkhdf_source *source) {
    struct fields f = {.n = source->points};
    f.pressure = vtkhdf_read_double(source, "crack_pressure");
    f.aperture = vtkhdf_read_double(source, "crack_aperture");
    f.area = vtkhdf_read_double(source, "crack_area");
    f.volume = vtkhdf_read_double(source, "volume");
    f.u = (double(*)[3])(void *)vtkhdf_read_double(source, "displacement");
    f.x = vtkhdf_read_points(source);
    if (!f.pressure || !f.aperture || !f.area || !f.volume || !f.u || !f.x) f.n = 0;
    for (long i = 0; i < f.n; i++)
        for (int c = 0; c < 3; c++) f.x[i][c] -= f.u[i][c];
    return f;
}

static void sums_of(struct postproc_crack_fluid *w, const struct fields *f, double least) {
    for (long i = 0; i < f->n; i++) {
        if (!(f->area[i] > 0)) continue;
        w->particles++;
        w->area += f->area[i];
        w->volume += f->volume[i];
        w->conductive += f->area[i] * pow(fmax(f->aperture[i], least), 3) / 12;
    }
}

/* The axis along which the cracks' area is spread least. */
static int flattest(const struct fields *f) {
    double least = INFINITY;
    int along = 2;
    for (int c = 0; c < 3; c++) {
        double all = 0, mean = 0, square = 0;
        for (long i = 0; i < f->n; i++) {
            all += f->area[i];
            mean += f->area[i] * f->x[i][c];
        }
        for (long i = 0; i < f->n; i++) square += f->area[i] * pow(f->x[i][c] - mean / all, 2);
        if (all > 0 && square < least * (1 - 1e-9)) {
            least = square;
            along = c;
        }
    }
    return along;
}

/* The cracks with a margin, or, without a crack, all. */
static void window_of(struct postproc_crack_fluid *w, const struct fields *f, const int across[2], double spacing) {
    const double reach = w->particles > 0 ? (MARGIN + 0.5) * spacing : 0.5 * spacing;
    for (int c = 0; c < 2; c++) {
        double all[2] = {INFINITY, -INFINITY};
        w->plate.low[c] = INFINITY;
        w->plate.high[c] = -INFINITY;
        for (long i = 0; i < f->n; i++) {
            const double x = f->x[i][across[c]];
            all[0] = fmin(all[0], x - 0.5 * spacing);
            all[1] = fmax(all[1], x + 0.5 * spacing);
            if (w->particles > 0 && !(f->area[i] > 0)) continue;
            w->plate.low[c] = fmin(w->plate.low[c], x - reach);
            w->plate.high[c] = fmax(w->plate.high[c], x + reach);
        }
        w->plate.low[c] = fmax(w->plate.low[c], all[0]);
        w->plate.high[c] = fmin(w->plate.high[c], all[1]);
    }
}

static int is_in(const struct postproc_plate *p, const double x[2]) {
    for (int c = 0; c < 2; c++)
        if (x[c] < p->low[c] || x[c] > p->high[c]) return 0;
    return 1;
}

static void reserve(struct postproc_crack_fluid *w, long n) {
    w->plate.x = calloc((size_t)n + 1, sizeof *w->plate.x);
    w->plate.u = calloc((size_t)n + 1, sizeof *w->plate.u);
    w->plate.size = calloc((size_t)n + 1, sizeof *w->plate.size);
    w->aperture = calloc((size_t)n + 1, sizeof *w->aperture);
    w->pressure = calloc((size_t)n + 1, sizeof *w->pressure);
}

static void plate_of(struct postproc_crack_fluid *w, const struct fields *f, const struct postproc_history *h) {
    struct postproc_plate *p = &w->plate;
    const int porous = h->scene->crack_fluid->pores != NULL;
    reserve(w, f->n);
    for (long i = 0; i < f->n; i++) {
        if (!is_in(p, f->x[i])) continue;
        const int wet = f->area[i] > 0;
        memcpy(p->x[p->n], f->x[i], sizeof *p->x);
        memcpy(p->u[p->n], f->u[i], sizeof *p->u);
        p->size[p->n] = h->spacing;
        w->aperture[p->n] = wet ? f->aperture[i] : NAN;
        w->pressure[p->n++] = wet || porous ? f->pressure[i] : NAN;
    }
}

/* A column's sums over its particles are made into means. */
static void columns_of(struct postproc_crack_fluid *w, const struct fields *f, const int across[2], double spacing) {
    struct postproc_plate *p = &w->plate;
    long m[2];
    for (int c = 0; c < 2; c++) m[c] = lround((p->high[c] - p->low[c]) / spacing) + 1;
    double *area = calloc((size_t)(m[0] * m[1]) + 1, sizeof *area);
    char *there = calloc((size_t)(m[0] * m[1]) + 1, 1);
    reserve(w, m[0] * m[1]);
    for (long i = 0; i < f->n; i++) {
        const double x[2] = {f->x[i][across[0]], f->x[i][across[1]]};
        if (!is_in(p, x)) continue;
        long at[2];
        for (int c = 0; c < 2; c++) at[c] = lround((x[c] - p->low[c]) / spacing - 0.5);
        const long k = at[1] * m[0] + at[0];
        if (at[0] < 0 || at[1] < 0 || at[0] >= m[0] || at[1] >= m[1]) continue;
        there[k] = 1;
        area[k] += f->area[i];
        w->aperture[k] += f->area[i] * f->aperture[i];
        w->pressure[k] += f->area[i] * f->pressure[i];
    }
    for (long k = 0; k < m[0] * m[1]; k++) {
        if (!there[k]) continue;
        for (int c = 0; c < 2; c++) p->x[p->n][c] = p->low[c] + ((double)(c ? k / m[0] : k % m[0]) + 0.5) * spacing;
        p->size[p->n] = spacing;
        w->aperture[p->n] = area[k] > 0 ? w->aperture[k] / area[k] : NAN;
        w->pressure[p->n++] = area[k] > 0 ? w->pressure[k] / area[k] : NAN;
    }
    free(area);
    free(there);
}

struct postproc_crack_fluid *postproc_crack_fluid_new(const struct postproc_history *h, int k,
                                                      const struct postproc_crack_fluid *like) {
    if (!h->scene->crack_fluid || !(h->spacing > 0)) return NULL;
    struct vtkhdf_source *source = postproc_history_open(h, &h->solid, h->solid.entry[k].time);
    if (!source) return NULL;
    struct fields f = fields_of(source);
    struct postproc_crack_fluid *w = calloc(1, sizeof *w);
    w->plate.time = source->time;
    w->plate.step = source->step;
    vtkhdf_read_close(source);
    sums_of(w, &f, postproc_crack_fluid_least_aperture(h));
    const int plate = h->scene->dimension == 2;
    if (f.n == 0 || (w->particles == 0 && !(plate && h->scene->crack_fluid->pores))) {
        fields_free(&f);
        free(w);
        return NULL;
    }
    w->along = like ? like->along : plate ? 2 : flattest(&f);
    const int across[2] = {w->along == 0 ? 1 : 0, w->along == 2 ? 1 : 2};
    window_of(w, &f, across, h->spacing);
    for (int c = 0; like && c < 2; c++) {
        w->plate.low[c] = like->plate.low[c];
        w->plate.high[c] = like->plate.high[c];
    }
    if (plate)
        plate_of(w, &f, h);
    else
        columns_of(w, &f, across, h->spacing);
    fields_free(&f);
    return w;
}

void postproc_crack_fluid_free(struct postproc_crack_fluid *w) {
    if (!w) return;
    void *const all[] = {w->plate.x, w->plate.u, w->plate.size, w->aperture, w->pressure};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) free(all[k]);
    free(w);
}
