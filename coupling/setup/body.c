/* Translates bodies, outlines and cracks of the scene into the solid's input. */
#include "base/ensure.h"
#include "coupling/setup/image.h"
#include "coupling/setup/parts.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Frees an array that the solid's input borrows as constant. */
static void give_back(const void *array) { free((void *)(uintptr_t)array); }

static void setup_outline(const struct scene_outline *from, struct solid_outline *to) {
    double(*corner)[2] = calloc((size_t)from->corners, sizeof *corner);
    double(*centre)[2] = calloc((size_t)from->corners, sizeof *centre);
    signed char *turn = calloc((size_t)from->corners, sizeof *turn);
    ENSURE(corner && centre && turn, "no memory for an outline of %d corners", from->corners);
    for (int i = 0; i < from->corners; i++) {
        memcpy(corner[i], from->corner[i].at, sizeof *corner);
        memcpy(centre[i], from->corner[i].centre, sizeof *centre);
        turn[i] = (signed char)from->corner[i].turn;
    }
    *to = (struct solid_outline){.is_hole = from->is_hole,
                                 .corners = from->corners,
                                 .corner = (const double(*)[2])corner,
                                 .centre = (const double(*)[2])centre,
                                 .turn = turn};
}

void setup_body_outlines(const struct scene_body *from, struct solid_body *to) {
    struct solid_outline *outline = calloc((size_t)from->outlines + 1, sizeof *outline);
    ENSURE(outline, "no memory for %d outlines", from->outlines);
    for (int i = 0; i < from->outlines; i++) setup_outline(&from->outline[i], &outline[i]);
    to->outline = outline;
    to->outlines = from->outlines;
    snprintf(to->name, sizeof to->name, "%s", from->name);
}

/* The voxels of an image, and their bounds. */
static void setup_voxels(const struct scene *scene, int b, struct solid_body *to) {
    struct setup_image *image = setup_image_read(scene, b);
    setup_image_floating(scene, image);
    to->voxels = image->voxels;
    static_assert((int)SCENE_KINDS_MAX <= (int)SOLID_BODY_MATERIALS_MAX,
                  "the solid takes the scene's materials of an image");
    to->image_materials = image->body->image.kinds;
    for (int k = 0; k < to->image_materials; k++) to->image_material[k] = image->body->image.kind[k];
    for (int c = 0; c < 3; c++)
        to->high[c] = to->low[c] + image->voxels->n[c] * image->voxels->sites[c] * scene->solid->spacing;
    image->voxels = NULL;
    setup_image_free(image);
}

struct solid_turn setup_body_turn(const struct scene_turn *turn) {
    struct solid_turn to = {.is_turned = turn->is_turned};
    memcpy(to.about, turn->about, sizeof to.about);
    memcpy(to.edge, turn->edge, sizeof to.edge);
    return to;
}

/* The numbers of a shape, of a body or a part of it. A body with outlines is a polygon. */
static void setup_shape(const struct scene_part *from, const char *name, struct solid_body *to) {
    to->shape = to->outlines > 0 ? SOLID_POLYGON : from->shape;
    to->radius = from->radius;
    to->axis = from->axis;
    to->length = from->length;
    to->turn = setup_body_turn(&from->turn);
    memcpy(to->low, from->low, sizeof to->low);
    memcpy(to->high, from->high, sizeof to->high);
    memcpy(to->centre, from->centre, sizeof to->centre);
    memcpy(to->radii, from->radii, sizeof to->radii);
    if (to->shape == SOLID_SPHERES) setup_spheres(from, name, to);
}

/* Further pieces and holes of a body in 3D. */
static void setup_parts(const struct scene_body *from, struct solid_body *to) {
    struct solid_body *part = calloc((size_t)(from->pieces + from->holes) + 1, sizeof *part);
    ENSURE(part, "no memory for %d parts", from->pieces + from->holes);
    for (int i = 0; i < from->pieces; i++) setup_shape(&from->piece[i], from->name, &part[to->parts++]);
    for (int i = 0; i < from->holes; i++) {
        part[to->parts].is_hole = 1;
        setup_shape(&from->hole[i], from->name, &part[to->parts++]);
    }
    to->part = part;
}

void setup_body(const struct scene *scene, int b, struct solid_body *to) {
    const struct scene_body *from = &scene->solid->body[b];
    *to = (struct solid_body){.material = from->material_index, .contacts_broken = from->contacts_broken};
    memcpy(to->velocity, from->velocity, sizeof to->velocity);
    switch (from->arrangement.kind) {
    case MESHLESS_LATTICE: /* as the shape says */
    case MESHLESS_HEXAGONAL:
    case MESHLESS_CENTROIDAL:
    case MESHLESS_RANDOM:
        break;
    case MESHLESS_PERTURBED:
        to->perturbation = from->arrangement.perturbation;
        to->perturbation_seed = from->arrangement.seed;
        break;
    }
    setup_body_outlines(from, to);
    setup_shape(&from->own, from->name, to);
    if (scene->dimension == 3) setup_parts(from, to);
    if (from->has_cavities) {
        to->cavity_period = from->cavity_period;
        to->cavity_radius = from->cavity_radius;
        memcpy(to->cavity_centre, from->cavity_centre, sizeof to->cavity_centre);
    }
    if (to->shape == SOLID_POINTS) setup_points(from, &scene->domain, scene->dimension, scene->solid->spacing, to);
    if (to->shape == SOLID_IMAGE) setup_voxels(scene, b, to);
    if (setup_arrange_is_on(scene, b)) setup_arrange(scene, b, to);
}

void setup_body_free(struct solid_body *body) {
    for (int i = 0; i < body->outlines; i++) {
        give_back(body->outline[i].corner);
        give_back(body->outline[i].centre);
        give_back(body->outline[i].turn);
    }
    for (int i = 0; i < body->parts; i++) give_back(body->part[i].entry);
    give_back(body->part);
    give_back(body->entry);
    give_back(body->outline);
    solid_voxels_free((struct solid_voxels *)(uintptr_t)body->voxels);
    give_back(body->point[0]);
}

void setup_body_cut(const struct scene_crack *from, struct solid_cut *to) {
    double(*point)[3] = calloc((size_t)from->points, sizeof *point);
    ENSURE(point, "no memory for a crack of %d points", from->points);
    memcpy(point, from->point, (size_t)from->points * sizeof *point);
    *to = (struct solid_cut){from->points, (const double(*)[3])point};
}

void setup_body_cut_free(struct solid_cut *cut) { give_back(cut->point); }
