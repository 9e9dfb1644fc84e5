/* frana check: sizes of the scene that are too few spacings or horizons, with the error to expect.  (docs/choosing.md)
 */
#include "program/check/parts.h"
#include "base/par.h"
#include "coupling/control/unresolved.h"
#include "cracks/cracks.h"
#include "scene/shape.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

/* What docs/choosing.md asks for: spacings of a wall, of a hole's and of a colliding body's radius; horizons of a
 * crack; horizons over E G0/sigma_t^2 of the bilinear law. */
#define WALL 6
#define HOLE 16
#define BODY 24
#define CRACK 4
#define NARROW 0.25
#define WIDE 0.8
/* Spacings between a body's held end and its loaded face. */
#define LAYER 24
/* Spacings across a porous body; and by the strain of how many its middle bears too much of a stress from all sides. */
#define POROUS 60
#define AROUND 1.2
/* Displaced masses that the layer of the forcing adds to a sphere that starts, times the cells in its diameter. */
#define CARRIED 5

/* The sentences' heading is printed with the first one. */
struct sizes {
    const struct scene *scene;
    const struct scene_solid *solid;
    int dim, sentences;
};

static void add(struct sizes *z, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void add(struct sizes *z, const char *format, ...) {
    va_list args;
    if (z->sentences++ == 0) printf("\nfew spacings\n");
    printf("  ");
    va_start(args, format);
    vprintf(format, args);
    va_end(args);
    printf("\n");
}

/* In spacings, to six digits: 0.006/0.001 is 6. */
static double spacings(const struct sizes *z, double length) { return round(1e6 * length / z->solid->spacing) / 1e6; }

/* The thinnest direction of a box or rectangle; one that fills the period has no faces there. */
static void print_wall(struct sizes *z, const char *key, const double low[3], const double high[3]) {
    double least = INFINITY;
    int thin = 0;
    for (int d = 0; d < z->dim; d++) {
        const double whole = z->scene->domain.size[d];
        if (z->scene->domain.periodic[d] && high[d] - low[d] >= whole * (1 - 1e-9)) continue;
        if (high[d] - low[d] < least) least = high[d] - low[d], thin = d;
    }
    if (!(spacings(z, least) < WALL)) return;
    add(z, "%s.high: %g spacings thick along %c, %d are asked for: too soft in bending by %s", key, spacings(z, least),
        "xyz"[thin], WALL,
        spacings(z, least) < 3   ? "more than 26 %"
        : spacings(z, least) < 4 ? "10 to 26 %"
                                 : "3 to 10 %");
}

/* The shape of a hole or cavity, or of a body. */
static void print_hole(struct sizes *z, const char *key, double radius) {
    if (!(spacings(z, radius) < HOLE)) return;
    add(z, "%s: a radius of %g spacings, %d are asked for: the stress at its edge is read %s", key, spacings(z, radius),
        HOLE, spacings(z, radius) < 8 ? "more than 25 % too low" : "16 to 25 % too low");
}

/* The radius of a round shape; INFINITY: it has none. Of the shapes of plates a disc has one. */
static double radius_of(const struct scene_part *p) {
    const struct scene_shape_kind *kind = scene_shape_of(p->shape);
    if (kind) return kind->radius ? kind->radius(p) : INFINITY;
    return p->shape == SOLID_DISC ? p->radius : INFINITY;
}

/* The key that gives it. */
static const char *radius_key(enum solid_shape shape) {
    const struct scene_shape_kind *kind = scene_shape_of(shape);
    return kind && kind->radius_key ? kind->radius_key : "radius";
}

static int is_wall(enum solid_shape shape) { return shape == SOLID_BOX || shape == SOLID_RECTANGLE; }

static void print_body(struct sizes *z, int b) {
    const struct scene_body *body = &z->solid->body[b];
    char key[96];
    for (int k = -1; k < body->pieces; k++) {
        const struct scene_part *p = k < 0 ? &body->own : &body->piece[k];
        if (k < 0)
            snprintf(key, sizeof key, "solid.bodies[%d]", b);
        else
            snprintf(key, sizeof key, "solid.bodies[%d].pieces[%d]", b, k);
        /* pieces of one solid make up a wall together */
        if (is_wall(p->shape) && (body->pieces == 0 || body->contacts_broken)) print_wall(z, key, p->low, p->high);
    }
    for (int k = 0; k < body->holes; k++) {
        snprintf(key, sizeof key, "solid.bodies[%d].holes[%d].%s", b, k, radius_key(body->hole[k].shape));
        print_hole(z, key, radius_of(&body->hole[k]));
    }
    if (body->has_cavities) {
        snprintf(key, sizeof key, "solid.bodies[%d].cavities.radius", b);
        print_hole(z, key, body->cavity_radius);
    }
}

/* By how many spacings' strain the face of a layer whose other end is held moves too far, under pressure and under
 * shear: bonds are missing at the face, and those from the held particles reach a horizon into the layer. The load of a
 * flow acts a quarter of a spacing above the outermost particles, a load of the scene on them. Sums over a chain of
 * layers (docs/design/solid-bonds.md), for m = 2, 3, 4. */
enum { ACROSS, ALONG };
static const double of_flow[3][2] = {{1.09, 0.81}, {2.10, 1.16}, {3.56, 1.67}};
static const double of_load[3][2] = {{0.83, 0.60}, {1.66, 0.92}, {2.85, 1.35}};

static double too_far(const double by_ratio[3][2], double m, int how) {
    const int k = m < 3 ? 0 : 1;
    return fmax(by_ratio[0][how], by_ratio[k][how] + (m - 2 - k) * (by_ratio[k + 1][how] - by_ratio[k][how]));
}

/* Whether a region holds all of the cross-section of a box at its low or high end along c; by how much of its length.
 */
static double depth_at(const struct sizes *z, const struct scene_part *p, int c, int high, const double from[3],
                       const double to[3]) {
    const double off = 0.5 * z->solid->spacing;
    for (int d = 0; d < z->dim; d++)
        if (d != c && (from[d] > p->low[d] + off || to[d] < p->high[d] - off)) return 0;
    if (high) return to[c] > p->high[c] - off ? fmin(fmax(p->high[c] - from[c], 0), p->high[c] - p->low[c]) : 0;
    return from[c] < p->low[c] + off ? fmin(fmax(to[c] - p->low[c], 0), p->high[c] - p->low[c]) : 0;
}

static double held_at(const struct sizes *z, const struct scene_part *p, int c, int high) {
    double most = 0;
    for (int k = 0; k < z->solid->constraints; k++) {
        const struct scene_constraint *q = &z->solid->constraint[k];
        if (!q->turn.is_turned && q->direction[c]) most = fmax(most, depth_at(z, p, c, high, q->low, q->high));
    }
    return most;
}

/* Whether a load of the scene acts on the outermost layer alone. */
static int is_loaded(const struct sizes *z, const struct scene_part *p, int c, int high) {
    for (int k = 0; k < z->solid->loads; k++) {
        const struct scene_load *q = &z->solid->load[k];
        if (q->kind != SOLID_LOAD_REGION || q->turn.is_turned) continue;
        const double depth = spacings(z, depth_at(z, p, c, high, q->low, q->high));
        if (depth > 0 && depth < 1.5) return 1;
    }
    return 0;
}

/* The extent of a box, in spacings; INFINITY where it fills the period. */
static double extent_along(const struct sizes *z, const struct scene_part *p, int c) {
    const double extent = p->high[c] - p->low[c];
    if (z->scene->domain.periodic[c] && extent >= z->scene->domain.size[c] * (1 - 1e-9)) return INFINITY;
    return spacings(z, extent);
}

/* A box that is held at one end, with a load on its other face, and at least as wide as it is high: it is sheared and
 * pressed as a layer. */
static void print_layer(struct sizes *z, const struct run *r, int b) {
    const struct scene_body *body = &z->solid->body[b];
    const struct scene_part *p = &body->own;
    if (!is_wall(p->shape) || p->turn.is_turned || body->pieces > 0 || body->arrangement.kind != MESHLESS_LATTICE ||
        z->solid->surface_correction != SOLID_CORRECTION_ENERGY)
        return;
    for (int c = 0; c < z->dim; c++)
        for (int high = 0; high < 2; high++) {
            const double held = spacings(z, held_at(z, p, c, !high)), n = extent_along(z, p, c) - held;
            int slender = 0;
            for (int d = 0; d < z->dim; d++) slender |= d != c && extent_along(z, p, d) < n;
            if (!(held > 0) || held_at(z, p, c, high) > 0 || slender || !(n > 0 && n < LAYER)) continue;
            if (!r->needs.immersed && !is_loaded(z, p, c, high)) continue;
            const double(*by)[2] = r->needs.immersed ? of_flow : of_load;
            const double m = z->solid->material[body->material_index].horizon_ratio;
            add(z,
                "solid.bodies[%d]: %g spacings along %c from its held end to its face, %d are asked for: %s moves this "
                "face about %.2g %% too far by pressure and %.2g %% by shear",
                b, n, "xyz"[c], LAYER, r -> needs.immersed ? "the flow" : "a load on its last layer",
                100 * too_far(by, m, ACROSS) / n, 100 * too_far(by, m, ALONG) / n);
        }
}

/* Bodies that may collide: several, or one whose shapes are not bonded. */
static void print_collision(struct sizes *z, int b) {
    const struct scene_body *body = &z->solid->body[b];
    double least = radius_of(&body->own);
    if (z->solid->bodies < 2 && !body->contacts_broken) return;
    for (int k = 0; k < body->pieces; k++) least = fmin(least, radius_of(&body->piece[k]));
    if (!(spacings(z, least) < BODY)) return;
    add(z,
        "solid.bodies[%d].%s: %g spacings, %d are asked for where bodies collide: along a lattice axis the collision "
        "is %s too short",
        b, radius_key(body->own.shape), spacings(z, least), BODY,
        spacings(z, least) < 16 ? "30 to 39 %" : "21 to 30 %");
}

/* Round bodies on the lattice that are squeezed slowly. Between two flat plates along a lattice axis balls of 8, 16 and
 * 24 spacings have 2.3 to 2.6, 1.6 to 1.8, 1.3 to 1.4 and 1.0 to 1.2 times Hertz's force where each side is pressed in
 * by 1/4, 1/2, 3/4 and 1 spacing: as a stamp of the facet's radius, sqrt(R spacing), has 1.5/sqrt(depth). */
static void print_squeeze(struct sizes *z, int b) {
    const struct scene_body *body = &z->solid->body[b];
    int relaxes = 0;
    for (int k = 0; k < z->scene->stages; k++) relaxes |= z->scene->stage[k].relax;
    if (z->solid->bodies < 2 || z->dim < 3 || !relaxes || !isfinite(radius_of(&body->own)) ||
        body->own.turn.is_turned || body->arrangement.kind != MESHLESS_LATTICE)
        return;
    add(z,
        "solid.bodies[%d].%s: a round body on the lattice ends in a flat facet along each axis: pressed in by 1/4, 1/2 "
        "and 1 spacing it bears 2.6, 1.8 and 1.2 times Hertz's force there, perturbed by 0.2 spacings (arrangement) "
        "0.95 to 1.09 times",
        b, radius_key(body->own.shape));
}

/* A porous body with free faces: within a horizon of those along a stress the fluid is coupled less to the solid, and
 * the middle bears more (docs/design/cracks.md, Pores). */
static void print_porous(struct sizes *z, int b) {
    const struct scene_body *body = &z->solid->body[b];
    double least = INFINITY;
    int finite = 0; /* a layer has no faces along the stress across it */
    if (!is_wall(body->own.shape) || body->pieces > 0) return;
    for (int c = 0; c < z->dim; c++) {
        finite += isfinite(extent_along(z, &body->own, c));
        least = fmin(least, extent_along(z, &body->own, c));
    }
    if (finite > 1 && least < POROUS)
        add(z,
            "solid.bodies[%d]: %g spacings across, %d are asked for with pores: sealed and under a stress from all "
            "sides "
            "its pressure is about %.2g %% too high in the middle",
            b, least, POROUS, 100 * AROUND / least);
}

static double distance(const double a[3], const double b[3]) {
    return sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2));
}

/* The length of a line, or the lesser extent of a quadrilateral. */
static double extent_of(const struct scene_crack *c, int dim) {
    double length = 0;
    if (dim == 3)
        return 0.5 * fmin(distance(c->point[0], c->point[1]) + distance(c->point[2], c->point[3]),
                          distance(c->point[1], c->point[2]) + distance(c->point[3], c->point[0]));
    for (int p = 0; p + 1 < c->points; p++) length += distance(c->point[p], c->point[p + 1]);
    return length;
}

static void print_crack(struct sizes *z, int k) {
    double horizon = 0;
    int breaks = 0;
    for (int m = 0; m < z->solid->materials; m++) {
        horizon = fmax(horizon, z->solid->material[m].horizon_ratio * z->solid->spacing);
        breaks |= isfinite(z->solid->material[m].fracture_energy) || z->solid->material[m].s00 > 0;
    }
    const double horizons = round(1e6 * extent_of(&z->solid->crack[k], z->dim) / horizon) / 1e6;
    if (!breaks || !(horizons < CRACK)) return;
    add(z, "solid.cracks[%d].points: %g horizons long, %d are asked for: the crack starts at %s times Griffith's load",
        k, horizons, CRACK, horizons < 2 ? "more than 1.4" : "up to 1.4");
}

static void print_law(struct sizes *z, int m) {
    const struct scene_material *k = &z->solid->material[m];
    if (k->breakage != SCENE_BILINEAR) return;
    const double length = k->youngs_modulus * k->fracture_energy / (k->tensile_strength * k->tensile_strength);
    const double share = k->horizon_ratio * z->solid->spacing / length;
    if (share < NARROW * (1 - 1e-6))
        add(z,
            "solid.materials[%d].breakage.tensile_strength: the horizon is %.3g E G0/sigma_t2, at least %g are asked "
            "for: bonds beside a crack soften without breaking, it takes more than 9 %% too much energy or stops",
            m, share, NARROW);
    if (share > WIDE * (1 + 1e-6))
        add(z,
            "solid.materials[%d].breakage.tensile_strength: the horizon is %.3g E G0/sigma_t2, at most %g are asked "
            "for: the law is nearly brittle, and a crack goes on in jumps and takes 6 %% or more too much energy",
            m, share, WIDE);
}

/* A negative ratio: the dilatation of the families at a face is far from that of the strain
 * (cases/verification/poisson_ratio). */
static void print_ratio(struct sizes *z, int m) {
    const double ratio = z->solid->material[m].poisson_ratio;
    if (z->solid->method == SCENE_ELEMENT_FREE || !(ratio < 0)) return;
    add(z,
        "solid.materials[%d].poisson_ratio: %g is negative: parts six spacings thick are 10 %% too stiff in tension at "
        "-0.1, 24 %% at -0.3 and 54 %% at -0.5, and twice as thick ones 6, 15 and 33 %%",
        m, ratio);
}

/* A sphere that starts from rest in a fluid at rest, so briefly that its viscous layer stays below a cell: the layer of
 * the forcing goes along with it as well (cases/verification/released_sphere). seconds: time of the run. */
static void print_start(struct sizes *z, const struct run *r, int b, double seconds) {
    const struct scene_part *p = &z->solid->body[b].own;
    const struct scene_fluid *f = z->scene->fluid;
    if (!r->reaction || p->shape != SOLID_SPHERE || z->solid->constraints > 0 || !(seconds > 0)) return;
    if (f->driving != FLUID_DRIVING_NONE || unresolved_velocity(f) > 0) return;
    const double cell = fluid_grid_of(r->fluid)->d[0], cells = 2 * p->radius / cell;
    const double layer = sqrt(f->viscosity * seconds) / cell;
    if (layer < 1)
        add(z,
            "solid.bodies[%d].radius: %.3g cells in a diameter, and a viscous layer sqrt(nu t) of %.2g cells at the "
            "run's end: where it starts from rest it carries about %.2g of the displaced mass along, in place of "
            "a half",
            b, cells, layer, 0.5 + CARRIED / cells);
}

void check_sizes_print(const struct run *r, double seconds) {
    struct sizes z = {.scene = r->scene, .solid = r->scene->solid};
    if (par_rank() != 0 || !r->needs.bonds) return;
    z.dim = r->solid->dim;
    for (int b = 0; b < z.solid->bodies; b++) print_body(&z, b);
    for (int b = 0; b < z.solid->bodies; b++) print_layer(&z, r, b);
    for (int b = 0; b < z.solid->bodies && r->fluid; b++) print_start(&z, r, b, seconds);
    for (int b = 0; b < z.solid->bodies && r->needs.contact; b++) print_collision(&z, b);
    for (int b = 0; b < z.solid->bodies && r->cracks && r->cracks->in.porous; b++) print_porous(&z, b);
    for (int b = 0; b < z.solid->bodies && r->needs.contact; b++) print_squeeze(&z, b);
    for (int k = 0; k < z.solid->cracks && r->needs.breakage; k++) print_crack(&z, k);
    for (int m = 0; m < z.solid->materials && r->needs.breakage; m++) print_law(&z, m);
    for (int m = 0; m < z.solid->materials; m++) print_ratio(&z, m);
}
