/* Section of the report with pictures of a porous block. */
#include "base/memory.h"
#include "base/sort.h"
#include "files/folder.h"
#include "postproc/draw/picture.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>

static const struct view {
    const char *name, *title, *said;
    double toward[3];
    int quantity; /* 0: damage, 1: displacement */
    int section;  /* 1: the half nearer to the camera than the middle plane of z is cut away */
} views[] = {
    {"damage_back", "Damage, from downstream", "from downstream", {1, 0.5, 1.25}, 0, 0},
    {"damage_front", "Damage, from upstream", "from upstream", {-1, 0.5, 1.25}, 0, 0},
    {"damage_section", "Damage, cut along the middle", "cut along the middle plane", {0.45, 0.4, 1.25}, 0, 1},
    {"displacement_back", "Displacement, from downstream", "from downstream", {1, 0.5, 1.25}, 1, 0},
};
enum { VIEWS = sizeof views / sizeof *views };

/* The values of a view's quantity, [n]; NULL if the file has none. *largest: the largest of them. */
static double *view_value(const struct view *view, const struct postproc_body *b, double *largest) {
    const double *d = b->displacement;
    if (view->quantity == 0 ? !b->damage : !d) return NULL;
    double *value = memory_new(MEMORY_OUTPUT, (size_t)b->n + 1, sizeof *value);
    *largest = 0;
    for (long i = 0; i < b->n; i++) {
        value[i] = view->quantity == 0
                       ? b->damage[i]
                       : sqrt(d[3 * i] * d[3 * i] + d[3 * i + 1] * d[3 * i + 1] + d[3 * i + 2] * d[3 * i + 2]);
        *largest = fmax(*largest, value[i]);
    }
    return value;
}

/* The 98 % quantile over the particles that have bonds, so that a few ejected particles do not set the colours. 0
 * without such particles. */
static double colour_bound(const struct postproc_body *b, const double *value) {
    long m;
    double *sorted = postproc_body_sample(b, value, &m);
    sort_ascending(sorted, (size_t)m);
    const double bound = m ? sorted[(long)(0.98 * (double)(m - 1))] : 0;
    memory_free(sorted);
    return bound;
}

static void view_draw(struct postproc_output *out, const struct postproc_history *h, const struct view *view,
                      const struct postproc_body *b) {
    char path[FOLDER_PATH], inside[128], subtitle[256];
    double largest = 0, *value = view_value(view, b, &largest);
    if (!value) return;
    double high = 1;
    const char *label = "damage";
    if (view->quantity == 1) {
        high = colour_bound(b, value);
        if (!(high > 0)) high = largest > 0 ? largest : 1;
        const double unit = high < 1e-4 ? 1e-6 : 1e-3;
        label = high < 1e-4 ? "|d|  [um]" : "|d|  [mm]";
        for (long i = 0; i < b->n; i++) value[i] /= unit;
        high /= unit;
    }
    snprintf(inside, sizeof inside, "pictures/%s.png", view->name);
    snprintf(subtitle, sizeof subtitle, "%s = %.4g of stage %s, step %ld, %s", h->t0 > 0 ? "t/t0" : "t",
             fabs(postproc_history_when(h, b->time)) < 1e-9 ? 0 : postproc_history_when(h, b->time), h->stage, b->step,
             view->said);
    struct postproc_picture p = {
        .path = folder_path(path, out->folder, inside),
        .title = h->scene->title,
        .subtitle = subtitle,
        .label = label,
        .n = b->n,
        .x = (const double(*)[3])b->x,
        .value = value,
        .value_high = high,
        .map = view->quantity == 0 ? POSTPROC_MAGMA_REVERSED : POSTPROC_VIRIDIS,
        .size = h->spacing,
        .width = 1400,
        .height = 900,
    };
    for (int k = 0; k < 3; k++) { /* particles farther from the channel than its size are ignored */
        p.domain[k] = h->scene->domain.size[k];
        p.toward[k] = view->toward[k];
        p.low[k] = -0.1 * p.domain[k];
        p.high[k] = 1.1 * p.domain[k];
    }
    if (view->section) p.high[2] = 0.5 * p.domain[2];
    if (postproc_picture_draw(&p))
        postproc_sections_fail(out, path);
    else
        postproc_sections_picture(out, view->name, view->title);
    memory_free(value);
}

void postproc_sections_pictures(struct postproc_output *out, const struct postproc_history *h) {
    if (h->scene->dimension == 2) return; /* see sections/plate.c */
    struct postproc_body *b = postproc_body_new(h, h->end);
    if (b && b->x && b->n > 0 && h->spacing > 0)
        for (int k = 0; k < VIEWS; k++) view_draw(out, h, &views[k], b);
    postproc_body_free(b);
}
