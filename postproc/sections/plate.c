/* Section of the report with pictures and a film of a plate. */
#include "base/ensure.h"
#include "base/memory.h"
#include "base/sort.h"
#include "base/files/folder.h"
#include "postproc/draw/plate_picture.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>

/* How a quantity is drawn. spread: the fraction of the values within the colour range. */
static const struct style {
    const char *title, *label;
    enum postproc_map map; /* of values of one sign */
    double spread;
} styles[POSTPROC_PLATE_QUANTITIES] = {
    [POSTPROC_DAMAGE] = {"Damage", "damage", POSTPROC_MAGMA_REVERSED, 0},
    [POSTPROC_STRETCH] = {"Largest stretch of a bond", "stretch", POSTPROC_MAGMA_REVERSED, 0.995},
    [POSTPROC_ENERGY] = {"Energy density", "W  [J/m³]", POSTPROC_MAGMA_REVERSED, 0.995},
    [POSTPROC_DISPLACEMENT_X] = {"Displacement along x", "u_x  [m]", POSTPROC_VIRIDIS, 0.98},
    [POSTPROC_DISPLACEMENT_Y] = {"Displacement along y", "u_y  [m]", POSTPROC_VIRIDIS, 0.98},
};

/* The values of a quantity, *stride apart; NULL if the file has none. */
static const double *values_of(const struct postproc_plate *p, enum postproc_quantity q, int *stride) {
    *stride = q == POSTPROC_DISPLACEMENT_X || q == POSTPROC_DISPLACEMENT_Y ? 2 : 1;
    switch (q) {
    case POSTPROC_DAMAGE:
        return p->damage;
    case POSTPROC_STRETCH:
        return p->stretch;
    case POSTPROC_ENERGY:
        return p->energy;
    case POSTPROC_DISPLACEMENT_X:
        return &p->u[0][0];
    case POSTPROC_DISPLACEMENT_Y:
        return &p->u[0][1];
    case POSTPROC_FLOW:
    case POSTPROC_SPEED:
    case POSTPROC_PRESSURE:
    case POSTPROC_APERTURE:
    case POSTPROC_CRACK_PRESSURE:
    case POSTPROC_QUANTITIES:
        break;
    }
    ENSURE(0, "quantity %d", (int)q);
}

/* Bounds of the colours: 0 ... 1 for damage; otherwise from 0 (from the lower quantile if there are negative values) to
 * the upper quantile. */
static void range_of(const struct postproc_plate *p, enum postproc_quantity q, double range[2]) {
    int stride;
    const double *value = values_of(p, q, &stride), spread = styles[q].spread;
    range[0] = 0;
    range[1] = 1;
    if (spread <= 0 || !value) return;
    double *sorted = memory_new(MEMORY_OUTPUT, (size_t)p->n + 1, sizeof *sorted);
    for (long i = 0; i < p->n; i++) sorted[i] = value[(size_t)i * (size_t)stride];
    sort_ascending(sorted, (size_t)p->n);
    const double low = sorted[(long)((1 - spread) * (double)(p->n - 1))],
                 high = sorted[(long)(spread * (double)(p->n - 1))];
    memory_free(sorted);
    range[0] = q >= POSTPROC_DISPLACEMENT_X ? fmin(low, 0) : 0;
    range[1] = fmax(high, 0);
    if (!(range[1] > range[0])) range[1] = range[0] + 1;
}

/* A plate with its damage contour, common to all its pictures. */
struct plate_view {
    struct postproc_plate *plate;
    struct postproc_contour *contour;
    struct postproc_grid *u[2];
};

static struct plate_view plate_view_new(struct postproc_output *out, const struct postproc_history *h, int file) {
    struct plate_view s = {.plate = postproc_plate_new(h, file)};
    if (!s.plate || !s.plate->damage) return s;
    struct postproc_grid *damage = postproc_plate_grid(s.plate, h, s.plate->damage, 1);
    s.contour = postproc_contour_new(damage, postproc_sections_crack_level(out, h));
    postproc_grid_free(damage);
    for (int c = 0; c < 2; c++) s.u[c] = postproc_plate_grid(s.plate, h, &s.plate->u[0][c], 2);
    return s;
}

static void plate_view_free(struct plate_view *s) {
    postproc_plate_free(s->plate);
    postproc_contour_free(s->contour);
    for (int c = 0; c < 2; c++) postproc_grid_free(s->u[c]);
}

/* Draws a picture; its height follows from the plate. */
static void draw(struct postproc_output *out, const struct postproc_history *h, const struct plate_view *s,
                 enum postproc_quantity q, const double range[2], double magnify, const char *inside, const char *name,
                 int all) {
    char subtitle[256], folder[FOLDER_PATH];
    const struct postproc_plate *p = s->plate;
    struct postproc_plate_picture f = {.folder = folder_path(folder, out->folder, inside),
                                       .name = name,
                                       .all = all,
                                       .title = h->scene->title,
                                       .subtitle = subtitle,
                                       .label = styles[q].label,
                                       .plate = p};
    double limit[2] = {range[0], range[1]};
    f.value = values_of(p, q, &f.stride);
    f.map = styles[q].map == POSTPROC_VIRIDIS ? postproc_sections_map(limit) : styles[q].map;
    f.value_low = limit[0];
    f.value_high = limit[1];
    f.magnify = magnify;
    f.contour = s->contour;
    for (int c = 0; c < 2; c++) f.displacement[c] = s->u[c];
    f.width = out->options.width;
    const double shape = (p->high[1] - p->low[1]) / (p->high[0] - p->low[0]);
    f.height = (int)(fmin(fmax(shape * 0.83 / 0.82, 0.4), 1) * f.width) / 2 * 2;
    char time[64];
    snprintf(subtitle, sizeof subtitle, "t = %s, step %ld; %s; displacements times %.4g; line: damage %.3f",
             postproc_sections_seconds(h, p->time, time), p->step, styles[q].title, magnify, out->level);
    if (postproc_plate_picture_draw(&f)) postproc_sections_fail(out, folder);
}

/* Draws one picture for each field file: film/NAME_0001.png, 0002 ... with the colours and the magnification of the
 * last file. */
static void film(struct postproc_output *out, const struct postproc_history *h, const double range[2], double magnify) {
    char name[96];
    const enum postproc_quantity q = out->options.film_quantity;
    for (int k = 0, frame = 1; k < h->solid.n; k++) {
        struct plate_view s = plate_view_new(out, h, k);
        int stride;
        if (s.plate && values_of(s.plate, q, &stride)) {
            snprintf(name, sizeof name, "%s_%04d", postproc_options_name(q), frame);
            draw(out, h, &s, q, range, magnify, "film", name, 0);
            out->frames = frame++;
            snprintf(out->film, sizeof out->film, "%s", postproc_options_name(q));
            snprintf(out->film_title, sizeof out->film_title, "%s", styles[q].title);
        }
        plate_view_free(&s);
    }
}

void postproc_sections_plate(struct postproc_output *out, const struct postproc_history *h) {
    if (h->scene->dimension != 2 || h->solid.n == 0 || !(h->spacing > 0)) return;
    struct plate_view s = plate_view_new(out, h, h->solid.n - 1);
    if (!s.plate) return;
    const double magnify = out->options.magnify > 0 ? out->options.magnify : postproc_plate_picture_magnify(s.plate);
    for (int q = 0; q < POSTPROC_PLATE_QUANTITIES; q++) {
        double range[2];
        int stride;
        if (!values_of(s.plate, q, &stride)) continue;
        range_of(s.plate, q, range);
        draw(out, h, &s, q, range, magnify, "pictures", postproc_options_name(q), 1);
        postproc_sections_picture(out, postproc_options_name(q), styles[q].title);
        if (out->options.film && out->options.film_quantity == (enum postproc_quantity)q) film(out, h, range, magnify);
    }
    plate_view_free(&s);
}
