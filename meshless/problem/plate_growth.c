/* Grows the cracks of an element-free plate step by step. */
#include "meshless/problem/plate_growth.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/files/log.h"
#include "base/files/table_columns.h"
#include "meshless/galerkin/cut.h"
#include "meshless/galerkin/intensity.h"
#include "physics/crack_tip.h"
#include "physics/kink.h"

#include <math.h>

static const struct scene_growth *growth_of(const struct scene *scene) { return scene->solid->element_free->growth; }

static double radius_of(const struct scene_growth *growth) {
    return growth->radius > 0 ? growth->radius : growth->step;
}

static double toughness_of(const struct scene *scene, const struct galerkin *g) {
    const struct physics_crack_tip tip = {g->in.youngs_modulus, g->in.poisson_ratio, g->in.plane_strain};
    const double energy = scene->solid->material[scene->solid->body[0].material_index].fracture_energy;
    const double given = growth_of(scene)->toughness;
    return given > 0 ? given : sqrt(energy * physics_crack_tip_modulus(&tip));
}

void meshless_plate_growth_check(const struct scene *scene, const struct galerkin *g) {
    const struct scene_growth *growth = growth_of(scene);
    const double finest = ldexp(g->in.spacing, -g->in.levels), radius = radius_of(growth);
    if (g->tips == 0) die_all(EXIT_CODE_SCENE, "solid.element_free.growth: no end of a crack is inside the body");
    if (growth->step < 2 * finest * (1 - 1e-9))
        die_all(EXIT_CODE_SCENE,
                "solid.element_free.growth.step = %g: must be at least two nodal spacings at the tip, %g m: take a "
                "larger step, or more tip_levels",
                growth->step, 2 * finest);
    if (radius > growth->step * (1 + 1e-9))
        die_all(EXIT_CODE_SCENE,
                "solid.element_free.growth.radius = %g: must be at most the step, %g m, so that its circle meets one "
                "straight part of the crack",
                radius, growth->step);
    if (radius < 2 * finest * (1 - 1e-9))
        die_all(EXIT_CODE_SCENE,
                "solid.element_free.growth.radius = %g: must be at least two nodal spacings at the tip, %g m", radius,
                2 * finest);
    for (int t = 0; t < g->tips; t++)
        if (radius > meshless_intensity_widest(g, t) * (1 + 1e-9))
            die_all(EXIT_CODE_SCENE,
                    "solid.element_free.growth: the radius, %g m, must be at most %.6g m about the tip (%.6g, %.6g), "
                    "so that the circle stays in the body and meets one straight crack: give growth.radius, or a "
                    "smaller step",
                    radius, meshless_intensity_widest(g, t), g->tip[t].x[0], g->tip[t].x[1]);
}

/* Adds the rows of a step. Returns the first of them. */
static struct meshless_plate_growth_row *measure(struct meshless_plate_growth *a, const struct scene *scene,
                                                 const struct galerkin *g, const double *grown) {
    const double degrees = 180 / acos(-1), toughness = toughness_of(scene, g);
    double most = 0;
    if (a->rows + g->tips > a->capacity) {
        const size_t old = (size_t)a->capacity;
        a->capacity = 2 * (a->rows + g->tips);
        a->row = memory_grown(MEMORY_OUTPUT, a->row, old, (size_t)a->capacity, sizeof *a->row);
    }
    struct meshless_plate_growth_row *row = a->row + a->rows;
    for (int t = 0; t < g->tips; t++) {
        const struct galerkin_tip *tip = &g->tip[t];
        const struct galerkin_intensity is = meshless_intensity_of(g, t, radius_of(growth_of(scene)));
        row[t] = (struct meshless_plate_growth_row){.step = a->steps,
                                                    .tip = t,
                                                    .x = {tip->x[0], tip->x[1]},
                                                    .along = degrees * atan2(tip->along[1], tip->along[0]),
                                                    .kink = degrees * physics_kink_angle(is.k),
                                                    .k = {is.k[0], is.k[1]},
                                                    .k_eq = physics_kink_equivalent(is.k),
                                                    .length = grown[t]};
        most = fmax(most, row[t].k_eq);
    }
    for (int t = 0; t < g->tips; t++) row[t].load = most > 0 ? toughness / most : NAN;
    a->rows += g->tips;
    return row;
}

/* Where the tip goes to. */
static void next_of(const struct meshless_plate_growth_row *row, double step, double x[2]) {
    const double angle = (row->along + row->kink) * acos(-1) / 180;
    x[0] = row->x[0] + step * cos(angle);
    x[1] = row->x[1] + step * sin(angle);
}

/* NULL, or why the tip cannot go there. */
static const char *hindrance(const struct galerkin *g, const struct scene_growth *growth, int tip, const double x[2]) {
    const double clearance = fmax(g->in.spacing, radius_of(growth));
    if (meshless_cut_depth(&g->in, x) < clearance * (1 + 1e-6)) return "a tip is next to the border or to a hole";
    for (int c = 0; c < g->lines; c++) {
        if (c == g->tip[tip].line) continue;
        if (meshless_cut_from_line(&g->line[c], x) < g->widest + 2 * clearance) return "a tip is next to another crack";
    }
    if (meshless_cut_from_bends(g, &g->tip[tip], x) < radius_of(growth)) return "a tip is next to its own crack";
    return NULL;
}

/* Moves the tips whose K_eq is the largest or within a hundredth of it. Returns NULL, or why none can move. */
static const char *advance(const struct scene *scene, struct meshless_plate *setup, const struct galerkin *g,
                           const struct meshless_plate_growth_row *row, double *grown) {
    const struct scene_growth *growth = growth_of(scene);
    double most = 0;
    for (int t = 0; t < g->tips; t++) most = fmax(most, row[t].k_eq);
    if (!(most > 0)) return "no crack is opened by the loads";
    for (int t = 0; t < g->tips; t++) {
        double x[2];
        if (row[t].k_eq < 0.99 * most) continue;
        if (grown[t] >= growth->until * (1 - 1e-9)) return "a tip has grown by the length asked for";
        next_of(&row[t], growth->step, x);
        const char *why = hindrance(g, growth, t, x);
        if (why) return why;
    }
    for (int t = 0; t < g->tips; t++) {
        double x[2];
        if (row[t].k_eq < 0.99 * most) continue;
        next_of(&row[t], growth->step, x);
        grown[t] += growth->step;
        meshless_plate_grow(scene, setup, g->tip[t].line, g->tip[t].end, x);
    }
    return NULL;
}

void meshless_plate_growth_run(struct meshless_plate_growth *a, const struct scene *scene, struct meshless_plate *setup,
                               struct galerkin **g, void (*solve)(struct galerkin *g)) {
    double grown[GALERKIN_TIPS] = {0};
    for (a->steps = 0;; a->steps++) {
        solve(*g);
        const struct meshless_plate_growth_row *row = measure(a, scene, *g, grown);
        for (int t = 0; t < (*g)->tips; t++)
            log_line("step %d, tip %d at (%.6g, %.6g): K_I %.5g, K_II %.5g Pa m^0.5, kink %.4g degrees, loads times "
                     "%.5g",
                     row[t].step, t, row[t].x[0], row[t].x[1], row[t].k[0], row[t].k[1], row[t].kink, row[t].load);
        a->end = "all steps are done";
        if (a->steps == growth_of(scene)->steps) return;
        a->end = advance(scene, setup, *g, row, grown);
        if (a->end) return;
        meshless_galerkin_free(*g);
        *g = meshless_galerkin_new(&setup->in);
    }
}

void meshless_plate_growth_write(const struct meshless_plate_growth *a, const char *folder) {
    static const char columns[] =
        "step 1|tip 1|x m|y m|direction degrees|kink degrees|K_I Pa m^0.5|K_II Pa m^0.5|K_eq Pa "
        "m^0.5|load 1|length m";
    struct table *table = table_columns_new(folder, "growth.csv", columns, 2, -1);
    for (int k = 0; k < a->rows; k++) {
        const struct meshless_plate_growth_row *r = &a->row[k];
        table_row(table, (const double[]){r->step, r->tip, r->x[0], r->x[1], r->along, r->kink, r->k[0], r->k[1],
                                          r->k_eq, r->load, r->length});
    }
    table_free(table);
}

void meshless_plate_growth_write_json(const struct meshless_plate_growth *a, struct json *j) {
    json_long(j, "growth_steps", a->steps);
    json_text(j, "growth_end", a->end);
}

void meshless_plate_growth_free(struct meshless_plate_growth *a) { memory_free(a->row); }
