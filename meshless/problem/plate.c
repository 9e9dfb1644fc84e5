/* An element-free plate from the scene: outline, cracks, nodes, given displacements and tractions. */
#include "meshless/problem/plate.h"
#include "base/die.h"
#include "base/machine.h"
#include "base/memory.h"
#include "meshless/arrange/arrange.h"
#include "meshless/galerkin/cut.h"
#include "meshless/galerkin/nodes.h"
#include "scene/outline.h"

#include <math.h>
#include <string.h>

/* The outline's corners, counterclockwise. */
static void set_outline(const struct scene_body *body, struct meshless_plate *to) {
    const struct scene_outline *o = &body->outline[0];
    double twice = 0;
    to->corner = memory_new(MEMORY_SOLID, (size_t)o->corners, sizeof *to->corner);
    for (int k = 0; k < o->corners; k++) {
        const double *p = o->corner[k].at, *q = o->corner[(k + 1) % o->corners].at;
        twice += p[0] * q[1] - p[1] * q[0];
    }
    for (int k = 0; k < o->corners; k++)
        memcpy(to->corner[k], o->corner[twice > 0 ? k : o->corners - 1 - k].at, sizeof to->corner[k]);
    to->in.corners = o->corners;
    to->in.corner = (const double(*)[2])to->corner;
}

/* Dies of a spacing with which not even half of the matrix's band fits: 2 n unknowns for n nodes, each coupled to those
 * that stand within a support further along the plate. */
static void check_memory(const struct scene_solid *s, const struct meshless_plate *to) {
    const struct scene_body *body = &s->body[0];
    const double has = (double)machine_memory();
    double length = 0;
    for (int k = 0; k < to->in.corners; k++)
        for (int l = 0; l < k; l++)
            length = fmax(length, hypot(to->corner[k][0] - to->corner[l][0], to->corner[k][1] - to->corner[l][1]));
    const double area = scene_outline_area(body), nodes = fmin(area / s->spacing / s->spacing, 1e100);
    const double band = 2 * s->element_free->support * area / length / s->spacing;
    const double bytes = 2 * nodes * fmin(band, nodes) * sizeof(double);
    if (has > 0 && bytes > has)
        die_all(EXIT_CODE_SCENE,
                "solid.bodies.%s: %.3g nodes of spacing %g m take %.3g GB of memory at least, and there are %.3g GB",
                body->name, nodes, s->spacing, 1e-9 * bytes, 1e-9 * has);
}

/* The corners of a hole, counterclockwise; arcs become chords. Returns how many; corner may be NULL. */
static int hole_corners(const struct scene_outline *o, double spacing, double (*corner)[2]) {
    int n = 0;
    for (int k = 0; k < o->corners; k++) {
        const struct scene_corner *p = &o->corner[k], *q = &o->corner[(k + 1) % o->corners];
        const double pi = acos(-1), radius = hypot(p->at[0] - p->centre[0], p->at[1] - p->centre[1]);
        int chords = 1;
        double from = 0, sweep = 0;
        if (p->turn != 0) {
            from = atan2(p->at[1] - p->centre[1], p->at[0] - p->centre[0]);
            sweep = atan2(q->at[1] - p->centre[1], q->at[0] - p->centre[0]) - from;
            if (p->turn > 0 && sweep <= 0) sweep += 2 * pi;
            if (p->turn < 0 && sweep >= 0) sweep -= 2 * pi;
            chords = (int)ceil(fabs(sweep) / fmin(pi / 24, 0.5 * spacing / radius));
        }
        for (int i = 0; i < chords; i++, n++) {
            const double angle = from + sweep * i / chords;
            if (!corner) continue;
            corner[n][0] = i ? p->centre[0] + radius * cos(angle) : p->at[0];
            corner[n][1] = i ? p->centre[1] + radius * sin(angle) : p->at[1];
        }
    }
    double twice = 0;
    for (int k = 0; k < n && corner; k++)
        twice += corner[k][0] * corner[(k + 1) % n][1] - corner[k][1] * corner[(k + 1) % n][0];
    for (int k = 0; twice < 0 && k < n / 2; k++)
        for (int c = 0; c < 2; c++) {
            const double swapped = corner[k][c];
            corner[k][c] = corner[n - 1 - k][c];
            corner[n - 1 - k][c] = swapped;
        }
    return n;
}

/* Holes: convex, a nodal spacing from the border and from each other. */
static void set_holes(const struct scene_body *body, struct meshless_plate *to) {
    struct galerkin_input *in = &to->in;
    to->hole = memory_new(MEMORY_SOLID, (size_t)body->holes + 1, sizeof *to->hole);
    to->edge = memory_new(MEMORY_SOLID, (size_t)body->holes + 1, sizeof *to->edge);
    in->hole = to->hole;
    for (int i = 1; i < body->outlines; i++) {
        const int h = in->holes, n = hole_corners(&body->outline[i], in->spacing, NULL);
        to->edge[h] = memory_new(MEMORY_SOLID, (size_t)n, sizeof **to->edge);
        hole_corners(&body->outline[i], in->spacing, to->edge[h]);
        const double(*corner)[2] = (const double(*)[2])to->edge[h];
        for (int k = 0; k < n; k++) {
            const double *p = corner[k], *q = corner[(k + 1) % n], *r = corner[(k + 2) % n];
            if ((q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0]) < -1e-12 * in->spacing * in->spacing)
                die_all(EXIT_CODE_SCENE, "solid.bodies[0].holes[%d]: a hole of an element-free plate is convex", h);
            if (meshless_cut_depth(in, p) < in->spacing * (1 - 1e-9))
                die_all(EXIT_CODE_SCENE,
                        "solid.bodies[0].holes[%d]: its edge at (%.6g, %.6g) is nearer than a nodal spacing, %g m, to "
                        "the body's border or to another hole: move it, or take a smaller solid.spacing",
                        h, p[0], p[1], in->spacing);
        }
        to->hole[h] = (struct galerkin_hole){n, corner};
        in->holes++;
    }
}

static int is_inside(const void *with, const double x[3]) {
    const struct galerkin_input *in = with;
    return meshless_cut_depth(in, x) >= -1e-9 * in->spacing;
}

/* Points of another arrangement than the lattice. */
static void arrange(const struct scene_solid *s, struct meshless_plate *to) {
    const struct scene_body *body = &s->body[0];
    struct meshless_arrange_input in = {.kind = body->arrangement.kind,
                                        .volume = MESHLESS_EQUAL,
                                        .spacing = s->spacing,
                                        .perturbation = body->arrangement.perturbation,
                                        .seed = body->arrangement.seed,
                                        .domain = {.dim = 2, .is_inside = is_inside, .with = &to->in}};
    for (int c = 0; c < 2; c++) {
        in.origin[c] = s->lattice_offset[c] * s->spacing;
        in.domain.low[c] = INFINITY;
        in.domain.high[c] = -INFINITY;
        for (int k = 0; k < to->in.corners; k++) {
            in.domain.low[c] = fmin(in.domain.low[c], to->corner[k][c]);
            in.domain.high[c] = fmax(in.domain.high[c], to->corner[k][c]);
        }
    }
    struct meshless_points *p = meshless_arrange_new(&in);
    to->in.nodes = (int)p->n;
    to->node = memory_new(MEMORY_SOLID, (size_t)p->n, sizeof *to->node);
    for (long i = 0; i < p->n; i++)
        for (int c = 0; c < 2; c++) to->node[i][c] = p->x[c][i];
    meshless_arrange_free(p);
}

static void set_nodes(const struct scene_solid *s, struct meshless_plate *to) {
    const int grows = s->element_free->growth != NULL; /* nodes as the tips lie, which may turn */
    double tip[GALERKIN_TIPS][2], along[GALERKIN_TIPS][2];
    int tips = 0;
    for (int k = 0; k < to->in.cracks && k < GALERKIN_CRACKS; k++)
        for (int e = 0; e < 2; e++)
            if (meshless_cut_depth(&to->in, to->crack[k].end[e]) > 1e-6 * s->spacing) {
                const struct galerkin_crack *crack = &to->crack[k];
                const double *at = crack->end[e];
                const double *from = crack->bends == 0 ? crack->end[!e] : crack->bend[e ? crack->bends - 1 : 0];
                const double length = hypot(at[0] - from[0], at[1] - from[1]);
                for (int c = 0; c < 2; c++) along[tips][c] = (at[c] - from[c]) / length;
                memcpy(tip[tips++], at, sizeof tip[0]);
            }
    if (s->body[0].arrangement.kind != MESHLESS_LATTICE) {
        to->in.levels = 0;
        arrange(s, to);
    } else {
        const struct meshless_nodes nodes = meshless_nodes_new(
            &to->in, s->lattice_offset, tips, (const double(*)[2])tip, grows ? (const double(*)[2])along : NULL);
        to->in.nodes = nodes.n;
        to->node = nodes.x;
        to->size = nodes.size;
    }
    to->in.node = (const double(*)[2])to->node;
    to->in.size = to->size;
}

static void set_crack(const struct scene_crack *crack, int k, struct meshless_plate *to) {
    const int bends = crack->points - 2;
    to->bend[k] = memory_new(MEMORY_SOLID, (size_t)bends + 1, sizeof **to->bend);
    for (int p = 0; p < bends; p++) memcpy(to->bend[k][p], crack->point[1 + p], sizeof **to->bend);
    for (int e = 0; e < 2; e++)
        memcpy(to->crack[k].end[e], crack->point[e ? crack->points - 1 : 0], sizeof to->crack[k].end[e]);
    to->crack[k].bends = bends;
    to->crack[k].bend = (const double(*)[2])to->bend[k];
}

/* The part of the segment from a to b in the box: 0 if there is none. */
static int clip(const double a[2], const double b[2], const double low[3], const double high[3], double from[2],
                double to[2]) {
    double first = 0, last = 1;
    for (int c = 0; c < 2; c++) {
        const double d = b[c] - a[c];
        if (d == 0 && (a[c] < low[c] || a[c] > high[c])) return 0;
        if (d == 0) continue;
        const double s = (low[c] - a[c]) / d, t = (high[c] - a[c]) / d;
        first = fmax(first, fmin(s, t));
        last = fmin(last, fmax(s, t));
    }
    if (first >= last) return 0;
    for (int c = 0; c < 2; c++) {
        from[c] = a[c] + first * (b[c] - a[c]);
        to[c] = a[c] + last * (b[c] - a[c]);
    }
    return 1;
}

/* A constraint's box: the parts of the outline in it that are at least a nodal spacing long; if there is none, a corner
 * in it, or else the middle of the box, which must be in the body. */
static void set_constraint(const struct scene_solid *s, int k, struct meshless_plate *to) {
    const struct scene_constraint *c = &s->constraint[k];
    struct galerkin_fixed fix = {.direction = {c->direction[0], c->direction[1]},
                                 .displacement = {c->displacement[0], c->displacement[1]}};
    const struct galerkin_input *in = &to->in;
    const int before = in->fixed;
    const double slack = 1e-6 * s->spacing;
    for (int i = 0; i < in->corners; i++) {
        if (!clip(in->corner[i], in->corner[(i + 1) % in->corners], c->low, c->high, fix.from, fix.to)) continue;
        if (hypot(fix.to[0] - fix.from[0], fix.to[1] - fix.from[1]) < s->spacing - slack) continue;
        to->fix[to->in.fixed++] = fix;
    }
    if (in->fixed > before) return;
    for (int d = 0; d < 2; d++) fix.from[d] = 0.5 * (c->low[d] + c->high[d]);
    for (int i = 0; i < in->corners; i++) {
        const double *x = in->corner[i];
        if (x[0] < c->low[0] || x[0] > c->high[0] || x[1] < c->low[1] || x[1] > c->high[1]) continue;
        memcpy(fix.from, x, sizeof fix.from);
    }
    memcpy(fix.to, fix.from, sizeof fix.to);
    if (meshless_cut_depth(in, fix.from) < -slack)
        die_all(EXIT_CODE_SCENE,
                "solid.constraints[%d]: its box holds neither a nodal spacing of the outline nor a corner, and its "
                "middle (%.6g, %.6g) is outside the body: move it, or make it larger",
                k, fix.from[0], fix.from[1]);
    to->fix[to->in.fixed++] = fix;
}

static void set_load(const struct scene_solid *s, int k, struct meshless_plate *to) {
    const struct scene_load *load = &s->load[k];
    const struct galerkin_input *in = &to->in;
    struct galerkin_pull pull = {.traction = {load->traction[0], load->traction[1]}};
    const double slack = 1e-6 * s->spacing;
    memcpy(pull.from, load->edge[0], sizeof pull.from);
    memcpy(pull.to, load->edge[1], sizeof pull.to);
    const double depth = fmax(fabs(meshless_cut_depth(in, pull.from)), fabs(meshless_cut_depth(in, pull.to)));
    const double middle[2] = {0.5 * (pull.from[0] + pull.to[0]), 0.5 * (pull.from[1] + pull.to[1])};
    if (depth > slack || fabs(meshless_cut_depth(in, middle)) > slack)
        die_all(EXIT_CODE_SCENE,
                "solid.loads[%d].edge: from (%.6g, %.6g) to (%.6g, %.6g) is not a part of one side of the body's "
                "outline",
                k, pull.from[0], pull.from[1], pull.to[0], pull.to[1]);
    to->pull[to->in.pulls++] = pull;
}

void meshless_plate_begin(const struct scene *scene, struct meshless_plate *to) {
    const struct scene_solid *s = scene->solid;
    const struct scene_element_free *free = s->element_free;
    const struct scene_material *material = &s->material[s->body[0].material_index];
    *to = (struct meshless_plate){.in = {.plane_strain = s->model == PHYSICS_PLANE_STRAIN,
                                         .youngs_modulus = material->youngs_modulus,
                                         .poisson_ratio = material->poisson_ratio,
                                         .thickness = s->thickness,
                                         .spacing = s->spacing,
                                         .basis = free->basis,
                                         .weight = free->weight,
                                         .support = free->support,
                                         .tip_radius = free->tip_radius,
                                         .levels = free->tip_levels,
                                         .patch = free->tip_patch,
                                         .turned = free->growth != NULL,
                                         .cells = {free->cells[0], free->cells[1]},
                                         .gauss = free->gauss,
                                         .gauss_tip = free->gauss_tip,
                                         .method = free->crack,
                                         .interface_spacing = free->interface_spacing,
                                         .penalty = free->penalty,
                                         .tolerance = free->tolerance,
                                         .iterations = free->iterations,
                                         .update = free->update}};
    set_outline(&s->body[0], to);
    check_memory(s, to);
    set_holes(&s->body[0], to);
    for (int c = 0; c < 2; c++) {
        double low = INFINITY, high = -INFINITY;
        to->in.body_force[c] = material->density * s->body_force[c];
        for (int k = 0; k < to->in.corners; k++) {
            low = fmin(low, to->corner[k][c]);
            high = fmax(high, to->corner[k][c]);
        }
        if (to->in.cells[c] == 0) to->in.cells[c] = (int)fmax(1, lround((high - low) / s->spacing));
    }
    to->crack = memory_new(MEMORY_SOLID, (size_t)s->cracks + 1, sizeof *to->crack);
    to->bend = memory_new(MEMORY_SOLID, (size_t)s->cracks + 1, sizeof *to->bend);
    to->fix = memory_new(MEMORY_SOLID, (size_t)(s->constraints * to->in.corners) + 1, sizeof *to->fix);
    to->pull = memory_new(MEMORY_SOLID, (size_t)s->loads + 1, sizeof *to->pull);
    to->in.cracks = s->cracks;
    for (int k = 0; k < s->cracks; k++) set_crack(&s->crack[k], k, to);
    to->in.crack = to->crack;
    to->in.fix = to->fix;
    to->in.pull = to->pull;
    for (int k = 0; k < s->constraints; k++) set_constraint(s, k, to);
    for (int k = 0; k < s->loads; k++) set_load(s, k, to);
    set_nodes(s, to);
}

void meshless_plate_grow(const struct scene *scene, struct meshless_plate *to, int crack, int end, const double x[2]) {
    struct galerkin_crack *its = &to->crack[crack];
    double(*bend)[2] = memory_new(MEMORY_SOLID, (size_t)its->bends + 1, sizeof *bend);
    memcpy(bend + !end, to->bend[crack], (size_t)its->bends * sizeof *bend);
    memcpy(bend[end ? its->bends : 0], its->end[end], sizeof *bend);
    memcpy(its->end[end], x, sizeof its->end[end]);
    memory_free(to->bend[crack]);
    to->bend[crack] = bend;
    its->bend = (const double(*)[2])bend;
    its->bends++;
    if (scene->solid->body[0].arrangement.kind != MESHLESS_LATTICE) return;
    MEMORY_FREE(to->node, to->size);
    set_nodes(scene->solid, to);
}

void meshless_plate_end(struct meshless_plate *to) {
    for (int k = 0; k < to->in.cracks; k++) memory_free(to->bend[k]);
    for (int k = 0; k < to->in.holes; k++) memory_free(to->edge[k]);
    MEMORY_FREE(to->bend, to->hole, to->edge, to->corner, to->node, to->size, to->crack, to->fix, to->pull);
}
