/* Section of the report on a plate's crack: tips, speeds, branching, contour. */
#include "base/files/folder.h"
#include "base/arena.h"
#include "postproc/data/contour.h"
#include "postproc/data/crack_shape.h"
#include "postproc/data/plate.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Level of the damage contour if it can be chosen neither by options nor by cracks: that of 003, chapter 7. */
static const double LEVEL = 0.41;
/* Damage above which a particle belongs to a crack, unless the scene gives it.  (000: sec. 3.1.2) */
static const double DAMAGED = 0.35;

/* The horizon of the first material, m: within it the damage beside a tip is less than beside the crack behind. */
static double horizon(const struct postproc_history *h) {
    return h->spacing * h->scene->solid->material[0].horizon_ratio;
}

double postproc_sections_crack_level(struct postproc_output *out, const struct postproc_history *h) {
    if (out->level > 0) return out->level;
    out->level = out->options.level;
    struct postproc_plate *p = out->level > 0 || h->solid.n == 0 ? NULL : postproc_plate_new(h, 0);
    if (p && p->damage && h->scene->solid->cracks > 0) {
        struct postproc_grid *damage = postproc_plate_grid(p, h, p->damage, 1);
        const double level =
            postproc_crack_shape_level(damage, h->scene->solid->cracks, h->scene->solid->crack, horizon(h));
        if (!isnan(level)) out->level = level;
        postproc_grid_free(damage);
    }
    postproc_plate_free(p);
    if (!(out->level > 0)) out->level = LEVEL;
    return out->level;
}

/* The columns of crack.csv that are used here, [rows]; NULL for a missing one. */
struct track {
    long rows;
    double *t, *tip[2], *side[2][2], *speed, *fronts, *length, *released, *per_area, *over_g0;
};

static struct track track_new(const struct table_data *d) {
    static const char *const place[3][2] = {{"tip_x", "tip_y"}, {"left_x", "left_y"}, {"right_x", "right_y"}};
    struct track k = {.rows = d ? d->rows : 0};
    k.t = postproc_history_values(d, "t");
    k.speed = postproc_history_values(d, "speed");
    k.fronts = postproc_history_values(d, "fronts");
    k.length = postproc_history_values(d, "length");
    k.released = postproc_history_values(d, "e_fracture");
    k.per_area = postproc_history_values(d, "energy_per_area");
    k.over_g0 = postproc_history_values(d, "energy_over_g0");
    int whole = k.t && k.speed && k.fronts && k.length && k.released && k.per_area && k.over_g0;
    for (int c = 0; c < 2; c++) {
        k.tip[c] = postproc_history_values(d, place[0][c]);
        for (int side = 0; side < 2; side++) {
            k.side[side][c] = postproc_history_values(d, place[side + 1][c]);
            whole = whole && k.side[side][c];
        }
        whole = whole && k.tip[c];
    }
    if (!whole) k.rows = 0;
    return k;
}

/* The first time at which a tip has moved by more than one spacing. */
static double growth(const struct track *k, double spacing) {
    for (long i = 0; i < k->rows; i++)
        for (int side = 0; side < 2; side++) {
            double moved = INFINITY;
            for (int from = 0; from < 2; from++)
                moved = fmin(
                    moved, hypot(k->side[side][0][i] - k->side[from][0][0], k->side[side][1][i] - k->side[from][1][0]));
            if (isfinite(moved) && moved > spacing * (1 + 1e-6)) return k->t[i];
        }
    return NAN;
}

/* The first time from which on, to the end, there are more fronts than at the start. */
static double parting(const struct track *k) {
    long i = k->rows;
    while (i > 0 && k->fronts[i - 1] > fmax(k->fronts[0], 1)) i--;
    return i > 0 && i < k->rows ? k->t[i] : NAN;
}

/* The first time at which the tip has reached a position along the axis. */
static double passing(const struct track *k, const double d[2], double place) {
    for (long i = 0; i < k->rows; i++)
        if (d[0] * k->tip[0][i] + d[1] * k->tip[1][i] >= place) return k->t[i];
    return NAN;
}

static void facts_of_track(struct postproc_facts *f, const struct track *k, const struct postproc_history *h) {
    const double rayleigh = postproc_history_waves(h).rayleigh;
    postproc_facts_number(f, "Rayleigh speed", "m/s", rayleigh);
    if (k->rows == 0) return;
    const double window = h->scene->output.crack ? h->scene->output.crack->window : 0;
    double broken = NAN;
    long top = -1;
    for (long i = k->rows - 1; i >= 0; i--) {
        if (k->released[i] > k->released[0]) broken = k->t[i];
        const int full = k->t[i] - k->t[0] >= window * (1 - 1e-9);
        if (full && !isnan(k->speed[i]) && (top < 0 || k->speed[i] >= k->speed[top])) top = i;
    }
    const long last = k->rows - 1;
    postproc_facts_number(f, "start of growth: first broken bond, t", "s", broken);
    postproc_facts_number(f, "start of growth: tip moved by more than a spacing, t", "s", growth(k, h->spacing));
    if (top >= 0) {
        postproc_facts_number(f, "window of the tip's speed", "s", window);
        postproc_facts_number(f, "top speed of the tip", "m/s", k->speed[top]);
        postproc_facts_number(f, "top speed of the tip, t", "s", k->t[top] - 0.5 * window);
        postproc_facts_number(f, "top speed over the Rayleigh speed", "1", k->speed[top] / rayleigh);
        postproc_facts_number(f, "grain of the speed: spacing over window", "m/s", h->spacing / window);
        if (k->speed[top] > rayleigh)
            postproc_facts_text(
                f, "top speed of the tip is",
                "above the Rayleigh speed: the farthest particle changed to another front; see the arms");
        if (k->speed[top] < h->spacing / window)
            postproc_facts_text(f, "top speed of the tip is",
                                "below what the grid resolves: a spacing over the window");
    }
    postproc_facts_number(f, "tip at the end, x", "m", k->tip[0][last]);
    postproc_facts_number(f, "tip at the end, y", "m", k->tip[1][last]);
    postproc_facts_number(f, "fronts at the end", "1", k->fronts[last]);
    postproc_facts_number(f, "length grown", "m", k->length[last]);
    postproc_facts_number(f, "energy released over the new area", "J/m2", k->per_area[last]);
    postproc_facts_number(f, "energy released over the new area, over G0", "1", k->over_g0[last]);
}

static void angle_add(struct postproc_facts *f, const char *name, const char *part, struct postproc_angle a) {
    postproc_facts_number(f, NAMED("%s, %s", name, part), "deg", a.value);
    postproc_facts_number(f, NAMED("%s, %s, uncertainty", name, part), "deg", a.error);
}

/* The tip's highest speed up to a time, from the first complete window on. */
static double top_until(const struct track *k, double window, double t) {
    double top = NAN;
    for (long i = 0; i < k->rows && k->t[i] <= t; i++)
        if (k->t[i] - k->t[0] >= window * (1 - 1e-9)) top = fmax(top, k->speed[i]);
    return top;
}

static void facts_of_branching(struct postproc_facts *f, const struct postproc_history *h,
                               const struct postproc_branching *b, const double d[2], const struct track *k) {
    static const char *const name[2] = {"angle of the branch to the left", "angle of the branch to the right"};
    postproc_facts_number(f, "branching: fronts apart from then on, t", "s", parting(k));
    postproc_facts_number(f, "branching: tip passes the place, t", "s", passing(k, d, b->place[0]));
    if (h->scene->output.crack)
        postproc_facts_number(f, "top speed of the tip before branching", "m/s",
                              top_until(k, h->scene->output.crack->window, passing(k, d, b->place[0])));
    postproc_facts_number(f, "branching, x", "m", d[0] * b->place[0] - d[1] * b->place[1]);
    postproc_facts_number(f, "branching, y", "m", d[1] * b->place[0] + d[0] * b->place[1]);
    for (int side = 0; side < 2; side++) {
        angle_add(f, name[side], "at first", b->side[side].first);
        angle_add(f, name[side], "at last", b->side[side].last);
    }
}

static void facts_of_chord(struct postproc_facts *f, int number, const struct postproc_chord *c) {
    const struct postproc_facts_name name = postproc_facts_name("crack %d: from its tip to its end", number);
    postproc_facts_number(f, name.text, "m", c->length);
    angle_add(f, name.text, "angle", c->angle);
}

/* Describes the cracks that have grown from each tip of the initial cracks, by the last field: branches with their
 * angles to the initial crack, or, without branches, the angle of the whole. A crack that has turned by more than this
 * angle is not searched for branches. */
static const double AHEAD = 45;

static void facts_of_shape(struct postproc_facts *f, const struct postproc_history *h, const struct postproc_plate *p,
                           const struct postproc_grid *damage, const struct track *k) {
    const struct scene_solid *s = h->scene->solid;
    const struct scene_crack_output *o = h->scene->output.crack;
    const double side = fmax(p->high[0] - p->low[0], p->high[1] - p->low[1]);
    struct postproc_tip *tip = arena_new(2 * (size_t)s->cracks, sizeof *tip);
    const int tips = postproc_crack_shape_tips(damage, s->cracks, s->crack, tip);
    for (int i = 0, branched = 0; i < tips; i++) {
        struct postproc_branching b = {0};
        struct postproc_grid *crack = postproc_crack_shape_connected(damage, o ? o->damage : DAMAGED, tip[i].x);
        const struct postproc_chord c = postproc_crack_shape_chord(crack, &tip[i]);
        if (c.found && c.angle.value < AHEAD) {
            /* turned first: between a damaged node and one left out the turned grid would have no value */
            const double *e = tip[i].direction, *x = tip[i].x;
            struct postproc_grid *turned = postproc_grid_turn(damage, e);
            struct postproc_grid *ahead = postproc_crack_shape_connected(
                turned, o ? o->damage : DAMAGED, (double[]){e[0] * x[0] + e[1] * x[1], e[0] * x[1] - e[1] * x[0]});
            b = postproc_crack_branch_of(ahead, fmax(10 * h->spacing, 0.05 * side));
            postproc_grid_free(ahead);
            postproc_grid_free(turned);
        }
        if (b.found && !branched++)
            facts_of_branching(f, h, &b, tip[i].direction, k);
        else if (!b.found && c.found && c.length > 3 * h->spacing)
            facts_of_chord(f, i + 1, &c);
        postproc_grid_free(crack);
    }
}

static void contour_write(struct postproc_output *out, const struct postproc_grid *damage, double level) {
    char path[FOLDER_PATH];
    struct postproc_contour *c = postproc_contour_new(damage, level);
    if (postproc_contour_write_csv(c, folder_path(path, out->folder, "contour.csv"))) postproc_sections_fail(out, path);
    if (postproc_contour_write_vtk(c, folder_path(path, out->folder, "contour.vtk"))) postproc_sections_fail(out, path);
    postproc_contour_free(c);
}

void postproc_sections_crack_numbers(struct postproc_output *out, const struct postproc_history *h) {
    if (h->scene->dimension != 2 || !h->scene->solid || !(h->spacing > 0)) return;
    struct track k = track_new(h->crack);
    struct postproc_plate *p = h->solid.n ? postproc_plate_new(h, h->solid.n - 1) : NULL;
    if (k.rows > 0 || (p && p->damage)) facts_of_track(&out->facts, &k, h);
    if (p && p->damage) {
        struct postproc_grid *damage = postproc_plate_grid(p, h, p->damage, 1);
        const double level = postproc_sections_crack_level(out, h);
        postproc_facts_number(&out->facts, "level of the damage contour", "1", level);
        facts_of_shape(&out->facts, h, p, damage, &k);
        postproc_sections_arms(out, h, p, h->scene->output.crack ? h->scene->output.crack->damage : DAMAGED);
        if (out->folder) contour_write(out, damage, level);
        postproc_grid_free(damage);
    }
    postproc_plate_free(p);
}

void postproc_sections_crack(struct postproc_output *out, const struct postproc_history *h) {
    char path[FOLDER_PATH];
    const int first = out->facts.n;
    postproc_sections_crack_numbers(out, h);
    if (out->facts.n == first) return;
    if (postproc_facts_write_from(&out->facts, first, folder_path(path, out->folder, "crack-summary.csv")))
        postproc_sections_fail(out, path);
}
