/* Sizes of the small scenes of a calibration, in spacings. */
#include "program/calibrate/sample.h"
#include "base/ensure.h"

#include <math.h>

double calibrate_sample_g0(const struct calibrate_sample *k) { return 3e-6 * k->m; }

static int odd(double x) { return 2 * (int)floor(x / 2) + 1; }
static int even(double x) { return 2 * (int)ceil(x / 2 - 1e-9); }

/* Energy of a wide strip that is stretched across by the strain e, with fixed length and depth: stiffness e^2/2. */
static double stiffness_of(const struct calibrate_sample *k) {
    const double nu = physics_model_poisson_ratio(k->model) + k->ratio_excess;
    if (k->ratio_excess == 0) return k->model == PHYSICS_PLANE_STRESS ? 9. / 8 : 6. / 5;
    return k->model == PHYSICS_PLANE_STRESS ? 1 / (1 - nu * nu) : (1 - nu) / ((1 + nu) * (1 - 2 * nu));
}

/* Half of the clamps' opening at which the strip stores so many G0 a unit of length. */
static double half_opening_of(const struct calibrate_sample *k, double stored, double free_height) {
    return 0.5 * sqrt(2 * stored * calibrate_sample_g0(k) * free_height / stiffness_of(k));
}

/* Strips are some ten horizons high, and so high that the stress that strains them is well below the strength. */
static int height_of(const struct calibrate_sample *k) {
    const int space = k->model == PHYSICS_3D;
    const double least = k->quick ? 8 * k->m : space ? 10 * k->m : fmax(10 * k->m, fmin(40, 40 * k->m / 3));
    const double soft = (k->quick || space ? 8 : 14) * k->length;
    return even(fmax(least, fmin(soft, 40 * k->m)));
}

static struct calibrate_sizes running(const struct calibrate_scene *c) {
    struct calibrate_sizes z = {.height = height_of(c->sample)};
    const double h = z.height;
    z.length = odd((c->sample->quick ? 2.75 : 3.25) * h);
    z.crack = 0.9 * h;
    z.from = 1.4 * h;
    z.to = z.length - 0.75 * h;
    z.step = c->sample->m / 6;
    z.steps = (int)((1.5 * h + (z.to - z.crack) / 0.25) / z.step); /* the tip's speed is some 0.3 sqrt(E/density) */
    z.every = 5;
    return z;
}

static struct calibrate_sizes damped(const struct calibrate_scene *c) {
    struct calibrate_sizes z = {.height = height_of(c->sample)};
    const double h = z.height;
    z.length = odd(2.05 * h);
    z.crack = 0.455 * h;
    z.from = 0.68 * h;
    z.to = 1.42 * h;
    z.step = c->sample->m / 2.4;
    z.steps = (int)(17 * h / z.step);
    z.damping = 7 / h;
    z.every = 5;
    return z;
}

static struct calibrate_sizes creeping(const struct calibrate_scene *c) {
    const int small = c->sample->quick || c->sample->model == PHYSICS_3D;
    struct calibrate_sizes z = {.height = even((small ? 8 : 10) * c->sample->m)};
    const double h = z.height;
    z.length = odd(2.2 * h);
    z.crack = 0.8 * h;
    z.from = z.crack + c->sample->m;
    z.to = 1.6 * h;
    z.steps = small ? 24 : 32;
    z.increment = small ? 0.05 : 0.03;
    z.first = 1.15;
    z.every = 1;
    return z;
}

static struct calibrate_sizes notch(const struct calibrate_scene *c) {
    const double m = c->sample->m;
    const int longer = c->kind == CALIBRATE_LONGER ? 1 : c->kind == CALIBRATE_SHORTER ? -1 : 0;
    struct calibrate_sizes z = {.length = even(10 * m), .height = even(10 * m) + 2 * (int)ceil(m)};
    z.crack = ceil(4 * m - 1e-9) + longer;
    z.to = ceil(7 * m);
    z.every = 1;
    if (c->kind != CALIBRATE_NOTCHED) {
        z.steps = 1;
    } else if (c->sample->length == 0) {
        const int coarse = c->sample->quick || c->sample->model == PHYSICS_3D;
        z.first = 0.7;
        z.increment = coarse ? 0.04 : 0.02;
        z.steps = coarse ? 33 : 60;
    } else {
        z.step = m / 2.4;
        z.steps = (int)(1500 * m / 3 / z.step);
        z.damping = 7. / z.height;
        z.every = 5;
    }
    return z;
}

static struct calibrate_sizes bar(const struct calibrate_scene *c) {
    const double m = c->sample->m;
    const int space = c->sample->model == PHYSICS_3D;
    const double strength = c->sample->length > 0 ? sqrt(calibrate_sample_g0(c->sample) / c->sample->length) : 2.1e-3;
    struct calibrate_sizes z = {.length = even(10 * m), .height = even((space ? 5 : 8) * m)};
    z.step = m / 2.4;
    z.steps = (int)(1000 * m / 3 / z.step);
    z.damping = 0.06 / m;
    z.every = 5;
    z.half_opening = 0.5 * 1.7 * strength * (z.length - 2 * ceil(m));
    return z;
}

struct calibrate_sizes calibrate_sample_sizes(const struct calibrate_scene *c) {
    const struct calibrate_sample *k = c->sample;
    const int space = k->model == PHYSICS_3D;
    struct calibrate_sizes z = {0};
    switch (c->kind) {
    case CALIBRATE_RUNNING:
        z = running(c);
        break;
    case CALIBRATE_DAMPED:
        z = damped(c);
        break;
    case CALIBRATE_CREEPING:
        z = creeping(c);
        break;
    case CALIBRATE_SHORTER:
    case CALIBRATE_LONGER:
    case CALIBRATE_NOTCHED:
        z = notch(c);
        break;
    case CALIBRATE_BAR:
        z = bar(c);
        break;
    }
    ENSURE(z.length > 0, "no sizes of kind %d", (int)c->kind);
    z.clamp = (int)ceil(k->m - 1e-9);
    z.depth = !space ? 1 : c->kind == CALIBRATE_BAR ? z.height : (int)floor(2 * k->m + 1 + 1e-6) + 1;
    if (c->kind != CALIBRATE_BAR)
        z.half_opening = half_opening_of(k, c->kind == CALIBRATE_NOTCHED ? 1 : c->stored, z.height - 2 * z.clamp);
    if (c->kind == CALIBRATE_NOTCHED) z.half_opening *= c->stored;
    return z;
}
