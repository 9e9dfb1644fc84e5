/* Writes intensity.csv: J and stress-intensity factors of the tips of a plate's cracks during the run. */
#include "program/output/outputs.h"
#include "base/die.h"
#include "base/memory.h"
#include "solid/bonds/ghosts.h"
#include "solid/measure/intensity.h"

#include <math.h>

enum { STEP, T, CRACK, TIP, X, RADIUS = X + 2, K_I, K_II, J, K_J, T_STRESS, COLUMNS };
struct tip {
    struct solid_tip is;
    int crack, end;
};

struct intensity {
    struct outputs_base base;
    const struct scene_intensity *scene; /* borrowed */
    int tips, material;
    struct tip *tip;            /* [tips] */
    struct solid_intensity *is; /* [radii], work */
};

/* The e-th end of a crack, and the length of its last straight part. */
static struct solid_tip end_of(const struct scene_crack *crack, int e, double *length) {
    const double *at = crack->point[e ? crack->points - 1 : 0], *from = crack->point[e ? crack->points - 2 : 1];
    struct solid_tip tip;
    *length = hypot(at[0] - from[0], at[1] - from[1]);
    for (int c = 0; c < 2; c++) {
        tip.x[c] = at[c];
        tip.along[c] = (at[c] - from[c]) / *length;
    }
    return tip;
}

static double to_line(const double x[2], const double p[2], const double q[2]) {
    const double d[2] = {q[0] - p[0], q[1] - p[1]}, size = d[0] * d[0] + d[1] * d[1];
    const double along = size > 0 ? ((x[0] - p[0]) * d[0] + (x[1] - p[1]) * d[1]) / size : 0;
    const double s = fmin(fmax(along, 0), 1);
    return hypot(p[0] + s * d[0] - x[0], p[1] + s * d[1] - x[1]);
}

/* The distance from a tip to the nearest crack or part of one other than its own straight part. */
static double to_others(const struct scene_solid *s, const struct tip *tip) {
    double least = INFINITY;
    for (int k = 0; k < s->cracks; k++) {
        const struct scene_crack *crack = &s->crack[k];
        const int its = k != tip->crack ? -1 : tip->end ? crack->points - 2 : 0;
        for (int p = 0; p + 1 < crack->points; p++)
            if (p != its) least = fmin(least, to_line(tip->is.x, crack->point[p], crack->point[p + 1]));
    }
    return least;
}

static double horizon_of(const struct solid *s) {
    double most = 0;
    for (int m = 0; m < s->in.materials; m++) most = fmax(most, s->in.material[m].horizon_ratio * s->in.spacing);
    return most;
}

static void check(const struct run *r, const struct tip *tip, double length) {
    const struct scene_intensity *scene = r->scene->output.intensity;
    const double others = fmin(to_others(r->scene->solid, tip), length), horizon = horizon_of(r->solid);
    for (int k = 0; k < scene->radii; k++) {
        const double radius = scene->radius[k];
        if (radius < 2 * horizon * (1 - 1e-9))
            die_all(EXIT_CODE_SCENE,
                    "%s: output.intensity.radii[%d] = %g: must be at least two horizons, %g m: the integral starts at "
                    "half the radius",
                    r->scene->path, k, radius, 2 * horizon);
        if (radius > others * (1 + 1e-9))
            die_all(EXIT_CODE_SCENE,
                    "%s: output.intensity.radii[%d] = %g: about the tip (%.6g, %.6g) it must be at most %.6g m, so "
                    "that the circle meets one straight crack",
                    r->scene->path, k, radius, tip->is.x[0], tip->is.x[1], others);
        if (!solid_intensity_is_inside(r->solid, &tip->is, radius))
            die_all(EXIT_CODE_SCENE,
                    "%s: output.intensity.radii[%d] = %g: the circle about the tip (%.6g, %.6g) leaves the body: take "
                    "a smaller radius",
                    r->scene->path, k, radius, tip->is.x[0], tip->is.x[1]);
    }
}

static int begin(void *self, struct run *r) {
    const struct scene_intensity *scene = r->scene->output.intensity;
    const struct scene_solid *solid = r->scene->solid;
    struct intensity *a = self;
    if (!scene || !r->needs.bonds) return 0;
    a->base.every = scene->every;
    a->scene = scene;
    a->material = r->solid->in.body[0].material;
    a->tip = memory_new(MEMORY_OUTPUT, 2 * (size_t)solid->cracks + 1, sizeof *a->tip);
    a->is = memory_new(MEMORY_OUTPUT, (size_t)scene->radii, sizeof *a->is);
    if (scene->crack >= solid->cracks)
        die_all(EXIT_CODE_SCENE, "%s: output.intensity.crack = %d: the scene has %d cracks, the first is 0",
                r->scene->path, scene->crack, solid->cracks);
    for (int b = 0; b < r->solid->in.bodies; b++)
        if (r->solid->in.body[b].material != a->material || r->solid->in.body[b].image_materials > 1)
            die_all(EXIT_CODE_SCENE, "%s: output.intensity: the bodies must be of one material", r->scene->path);
    for (int k = 0; k < solid->cracks; k++)
        for (int e = 0; e < 2; e++) {
            double length;
            const struct tip tip = {end_of(&solid->crack[k], e, &length), k, e};
            if ((scene->crack >= 0 && scene->crack != k) || (scene->tip >= 0 && scene->tip != e)) continue;
            if (!solid_intensity_is_inside(r->solid, &tip.is, horizon_of(r->solid))) continue;
            check(r, &tip, length);
            a->tip[a->tips++] = tip;
        }
    if (a->tips == 0)
        die_all(EXIT_CODE_SCENE,
                "%s: output.intensity: no end of a crack is inside the body, a horizon from its border",
                r->scene->path);
    a->base.rows = a->tips * scene->radii;
    return 1;
}

static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    struct intensity *a = self;
    (void)m;
    solid_ghosts_update(r->solid);
    for (int k = 0; k < a->tips; k++) {
        const struct tip *tip = &a->tip[k];
        solid_intensity_measure(r->solid, &tip->is, a->material, a->scene->radii, a->scene->radius, a->is);
        for (int i = 0; i < a->scene->radii; i++)
            outputs_row(&a->base, r,
                        (double[COLUMNS]){[CRACK] = tip->crack,
                                          [TIP] = tip->end,
                                          [X] = tip->is.x[0],
                                          [X + 1] = tip->is.x[1],
                                          [RADIUS] = a->scene->radius[i],
                                          [K_I] = a->is[i].k[0],
                                          [K_II] = a->is[i].k[1],
                                          [J] = a->is[i].j,
                                          [K_J] = a->is[i].k_j,
                                          [T_STRESS] = a->is[i].t});
    }
}

static void free_intensity(void *self) {
    struct intensity *a = self;
    MEMORY_FREE(a->tip, a->is);
}

const struct output output_intensity = {
    .file = {"intensity.csv"},
    .columns = "step 1|t s|crack 1|tip 1|x m|y m|radius m|K_I Pa m^0.5|K_II Pa m^0.5|J J/m2|K_J Pa m^0.5|T Pa",
    .bytes = sizeof(struct intensity),
    .when = OUTPUTS_EVERY | OUTPUTS_STAGE,
    .begin = begin,
    .sample = sample,
    .free = free_intensity,
};
