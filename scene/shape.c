/* The table of shapes on the lattice, and what each is to the scene. */
#include "scene/shape.h"
#include "scene/turn.h"

#include <math.h>

static int add(const double its_low[3], const double its_high[3], double low[3], double high[3]) {
    for (int d = 0; d < 3; d++) {
        low[d] = fmin(low[d], its_low[d]);
        high[d] = fmax(high[d], its_high[d]);
    }
    return 1;
}

/* centre -+ half */
static int add_about(const double centre[3], const double half[3], double low[3], double high[3]) {
    double its_low[3], its_high[3];
    for (int d = 0; d < 3; d++) {
        its_low[d] = centre[d] - half[d];
        its_high[d] = centre[d] + half[d];
    }
    return add(its_low, its_high, low, high);
}

/* The same of a turned shape; half: of its extent in direction c. */
static int add_turned(const struct scene_part *p, double half(const struct scene_part *p, int c), double low[3],
                      double high[3]) {
    double centre[3], halves[3];
    scene_turn_point(&p->turn, p->centre, centre);
    for (int d = 0; d < 3; d++) halves[d] = half(p, d);
    return add_about(centre, halves, low, high);
}

static double radius_of(const struct scene_part *p) { return p->radius; }

static int box_bounds(const struct scene_part *p, double low[3], double high[3]) {
    double its_low[3], its_high[3];
    scene_turn_box(&p->turn, p->low, p->high, its_low, its_high);
    return add(its_low, its_high, low, high);
}

static double box_volume(const struct scene_part *p) {
    return (p->high[0] - p->low[0]) * (p->high[1] - p->low[1]) * (p->high[2] - p->low[2]);
}

static const struct scene_shape_kind kind_box = {.bounds = box_bounds, .volume = box_volume};

static int sphere_bounds(const struct scene_part *p, double low[3], double high[3]) {
    return add_about(p->centre, (double[]){p->radius, p->radius, p->radius}, low, high);
}

static double sphere_volume(const struct scene_part *p) { return 4 * M_PI / 3 * pow(p->radius, 3); }

static const struct scene_shape_kind kind_sphere = {sphere_bounds, sphere_volume, radius_of, "radius"};

/* Ends are discs: of one with the normal a the half extent in direction c is radius sqrt(1 - a_c^2). */
static double half_cylinder(const struct scene_part *p, int c) {
    const double along = p->turn.edge[p->axis][c];
    return fabs(along) * (p->length / 2) + p->radius * sqrt(fmax(1 - along * along, 0));
}

static int cylinder_bounds(const struct scene_part *p, double low[3], double high[3]) {
    double half[3] = {p->radius, p->radius, p->radius};
    half[p->axis] = p->length / 2;
    return p->turn.is_turned ? add_turned(p, half_cylinder, low, high) : add_about(p->centre, half, low, high);
}

static double cylinder_volume(const struct scene_part *p) { return M_PI * p->radius * p->radius * p->length; }

static const struct scene_shape_kind kind_cylinder = {cylinder_bounds, cylinder_volume, radius_of, "radius"};

static double half_ellipsoid(const struct scene_part *p, int c) {
    double sum = 0;
    for (int k = 0; k < 3; k++) sum += p->turn.edge[k][c] * p->turn.edge[k][c] * (p->radii[k] * p->radii[k]);
    return sqrt(sum);
}

static int ellipsoid_bounds(const struct scene_part *p, double low[3], double high[3]) {
    return p->turn.is_turned ? add_turned(p, half_ellipsoid, low, high) : add_about(p->centre, p->radii, low, high);
}

static double ellipsoid_volume(const struct scene_part *p) {
    return 4 * M_PI / 3 * p->radii[0] * p->radii[1] * p->radii[2];
}

static double ellipsoid_radius(const struct scene_part *p) { return fmin(p->radii[0], fmin(p->radii[1], p->radii[2])); }

static const struct scene_shape_kind kind_ellipsoid = {ellipsoid_bounds, ellipsoid_volume, ellipsoid_radius, "radii"};

static int spheres_bounds(const struct scene_part *p, double low[3], double high[3]) {
    for (int k = 0; k < p->spheres; k++) {
        const double r = p->sphere[k][3];
        add_about(p->sphere[k], (double[]){r, r, r}, low, high);
    }
    return p->spheres > 0;
}

static double spheres_radius(const struct scene_part *p) {
    double least = INFINITY;
    for (int k = 0; k < p->spheres; k++) least = fmin(least, p->sphere[k][3]);
    return least;
}

static const struct scene_shape_kind kind_spheres = {spheres_bounds, NULL, spheres_radius, "spheres"};

#define LINE(constant, word, keys) [SOLID_##constant] = &kind_##word,
static const struct scene_shape_kind *const kind[] = {SOLID_LATTICE_SHAPES(LINE)};
#undef LINE

const struct scene_shape_kind *scene_shape_of(enum solid_shape shape) {
    return (size_t)shape < sizeof kind / sizeof *kind ? kind[shape] : NULL;
}
