/* frana check of images: what was understood, labels, porosity, connected and floating parts, thin parts, slices. */
#include "program/check/image.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/print.h"
#include "coupling/setup/image.h"
#include "coupling/setup/image_voxel.h"
#include "base/files/folder.h"
#include "postproc/draw/figure.h"
#include "solid/voxels/borders.h"
#include "solid/voxels/opening.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS_WIDE = 3, PICTURE = 512 };

/* What is measured of the solid or of the pores, by one rank each. */
struct phase {
    long voxels, pieces, largest, through[3];
    long loose_pieces, loose_voxels, loose_largest;
    long thin;
    int edge; /* voxels along the cube's edge */
};

static double share(long part, long whole) { return whole > 0 ? 100.0 * (double)part / (double)whole : 0; }

static long voxels_of(const struct setup_image *image) {
    const int *n = image->voxels->n;
    return (long)n[0] * n[1] * n[2];
}

static void print_reading(const struct scene *scene, const struct setup_image *image) {
    static const char *const axes[] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
    const struct scene_image *s = &image->body->image;
    const struct solid_voxels *v = image->voxels;
    const char *a = axes[s->axes];
    print("\nimage %s\n", image->body->name);
    print("  file       %s, %s, %s\n", image->body->own.file, image->format, image->type);
    print("  voxels     %d along x, %d along y, %d along z, of %.6g m; in the file %c varies first, then %c, then %c\n",
          s->size[0], s->size[1], s->size[2], s->voxel, a[0], a[1], a[2]);
    if (image->header_voxel[0] > 0)
        print("  header     says voxels of %.6g%s%s; the scene's count\n", image->header_voxel[0],
              image->header_unit[0] ? " " : "", image->header_unit[0] ? image->header_unit : " without a unit");
    char differs[IMAGE_VOXEL_SENTENCE];
    if (par_rank() == 0 && image_voxel_differs(scene, image->number, differs)) print("  warning: %s\n", differs);
    if (s->has_crop)
        print("  crop       voxels %d to %d along x, %d to %d along y, %d to %d along z\n", s->crop_low[0],
              s->crop_high[0] - 1, s->crop_low[1], s->crop_high[1] - 1, s->crop_low[2], s->crop_high[2] - 1);
    if (s->flip[0]) print("  turned     round along %s\n", s->flip);
    if (s->mirror[0]) print("  mirrored   its mirror image follows along %s\n", s->mirror);
    if (image->per_cell > 1)
        print("  coarsened  %d x %d x %d voxels are one cell, solid where more than half of them are\n",
              image->per_cell, image->per_cell, image->per_cell);
    print(
        "  body       %d x %d x %d lattice sites %.6g m apart, %d along the edge of a %s; from (%.6g, %.6g, %.6g) m to "
        "(%.6g, %.6g, %.6g) m\n",
        v->n[0] * v->sites, v->n[1] * v->sites, v->n[2] * v->sites, scene->solid->spacing, v->sites,
        image->per_cell > 1 ? "cell" : "voxel", image->body->own.low[0], image->body->own.low[1],
        image->body->own.low[2], image->body->own.low[0] + v->n[0] * v->sites * scene->solid->spacing,
        image->body->own.low[1] + v->n[1] * v->sites * scene->solid->spacing,
        image->body->own.low[2] + v->n[2] * v->sites * scene->solid->spacing);
}

/* The name of a material of the image. */
static const char *name_of(const struct scene *scene, const struct scene_image *s, int kind) {
    return scene->solid->material[s->kind[kind]].name;
}

/* The material of a label, behind a comma; nothing where the body has one. */
static const char *material_of(const struct scene_image *s, int label) {
    static char text[SCENE_NAME + 3];
    for (int l = 0; l < s->materials; l++)
        if (s->material[l].label == label) {
            snprintf(text, sizeof text, ", %s", s->material[l].material);
            return text;
        }
    return "";
}

static int is_label(const struct scene_image *s, int value) {
    if (s->has_threshold) return value >= s->threshold;
    for (int l = 0; l < s->labels; l++)
        if (s->label[l] == value) return 1;
    return 0;
}

static void print_labels(const struct setup_image *image) {
    const struct scene_image *s = &image->body->image;
    const long all = (long)image->used[0] * image->used[1] * image->used[2];
    print("  values     %.6g to %.6g, mean %.6g\n", image->least, image->most, image->mean);
    if (s->has_threshold) {
        print("    %.6g and more  solid  %ld voxels, %.4f %%\n", s->threshold, image->solid, share(image->solid, all));
        return;
    }
    for (int l = 0; l < image->labels && image->labels <= SETUP_IMAGE_LABELS; l++)
        print("    %-6d %-5s  %ld voxels, %.4f %%%s\n", image->label[l].value,
              is_label(s, image->label[l].value) ? "solid" : "pore", image->label[l].voxels,
              share(image->label[l].voxels, all), material_of(s, image->label[l].value));
    if (image->labels > SETUP_IMAGE_LABELS)
        print("    more than %d labels; solid: %ld voxels, %.4f %%\n", SETUP_IMAGE_LABELS, image->solid,
              share(image->solid, all));
}

/* Voxels of each material of the body, and the area of the borders between two of them. */
static void print_materials(const struct scene *scene, const struct setup_image *image) {
    const struct scene_image *s = &image->body->image;
    const struct solid_voxels *v = image->voxels;
    const double edge = v->sites * scene->solid->spacing;
    long count[1 << SOLID_VOXELS_PLANES], solid = 0;
    if (v->planes == 0) return;
    const long faces = solid_borders_count(v, count);
    for (int k = 0; k < s->kinds; k++) solid += count[k];
    for (int k = 0; k < s->kinds; k++)
        print("  %-10s %s: %ld %s, %.4f %% of the solid\n", k ? "" : "materials", name_of(scene, s, k), count[k],
              image->per_cell > 1 ? "cells" : "voxels", share(count[k], solid));
    print("  borders    %ld faces between voxels of two materials: %.6g m2, %.6g m2 a m3 of solid\n", faces,
          (double)faces * edge * edge, (double)faces / (double)solid / edge);
}

/* Voxels that a cube of CELLS_WIDE lengths reaches into along an edge. */
static int edge_of(double length, double voxel) { return (int)ceil(CELLS_WIDE * length / voxel - 1e-6); }

/* loose: the bits of the solid's loose pieces, if there are any; may be NULL. */
static void measure(const struct scene *scene, const struct setup_image *image, int is_solid, struct phase *phase,
                    uint64_t **loose) {
    const struct solid_voxels *v = image->voxels;
    const double spacing = scene->solid->spacing, voxel = v->sites * spacing;
    const double cell = scene->fluid ? scene->domain.size[0] / scene->domain.cells[0] : spacing;
    int wraps[3];
    setup_image_wraps(scene, image, wraps);
    struct solid_components *c =
        is_solid ? setup_image_solid(scene, image) : solid_components_new(v, 0, wraps, 0, NULL);
    *phase = (struct phase){
        c->voxels,       c->pieces,        c->largest, {c->through[0], c->through[1], c->through[2]}, c->loose_pieces,
        c->loose_voxels, c->loose_largest, 0,          edge_of(is_solid ? spacing : cell, voxel)};
    if (loose && c->loose_pieces > 0) solid_components_loose(c, v, *loose = solid_voxels_array(v));
    solid_components_free(c);
    if (phase->edge > 1 && phase->edge < 64) phase->thin = solid_opening_thin(v, is_solid, phase->edge);
}

static void print_thin(const struct phase *phase, const char *what, const char *unit) {
    if (phase->edge >= 64)
        print("  thin %s     not measured: a voxel is less than a twentieth of a %s\n", what, unit);
    else
        print("  thin %-5s %.4f %% of the %s is less than %d %ss wide: in no cube of %d %ss that lies within it\n",
              what, share(phase->thin, phase->voxels), what, CELLS_WIDE, unit, CELLS_WIDE, unit);
}

static void print_phases(const struct setup_image *image, const struct phase phase[2]) {
    static const char *const done[] = {"kept", "removed", "held"};
    const struct phase *pore = &phase[0], *solid = &phase[1];
    const long all = voxels_of(image);
    print("  porosity   %.5f; connected from face to face along x %.5f, y %.5f, z %.5f\n",
          (double)pore->voxels / (double)all, (double)pore->through[0] / (double)all,
          (double)pore->through[1] / (double)all, (double)pore->through[2] / (double)all);
    print("  pores      %ld piece%s, the largest %.4f %% of the pores\n", pore->pieces, pore->pieces == 1 ? "" : "s",
          share(pore->largest, pore->voxels));
    print("  solid      %ld piece%s, the largest %.4f %% of the solid\n", solid->pieces, solid->pieces == 1 ? "" : "s",
          share(solid->largest, solid->voxels));
    if (solid->loose_pieces > 0)
        print("  floating   %ld piece%s of solid, %.4f %% of it, the largest of %ld voxels: %s\n", solid->loose_pieces,
              solid->loose_pieces == 1 ? "" : "s", share(solid->loose_voxels, solid->voxels), solid->loose_largest,
              done[image->body->image.floating]);
    else
        print("  floating   no piece of solid\n");
    print_thin(pore, "pore", "cell");
    print_thin(solid, "solid", "particle");
    if (pore->through[0] + pore->through[1] + pore->through[2] == 0)
        print("  warning: no pore leads from face to face in any direction\n");
    if (solid->through[0] + solid->through[1] + solid->through[2] == 0)
        print("  warning: no piece of solid reaches from face to face in any direction\n");
}

/* Of the materials, in turn. Colour-blind readers can tell them apart (Okabe and Ito 2008). */
static const struct {
    const char *name;
    uint32_t rgb;
} colour_of[] = {{"grey", 0x5a5a5a},   {"blue", 0x0072b2},   {"sky blue", 0x56b4e9}, {"bluish green", 0x009e73},
                 {"yellow", 0xf0e442}, {"purple", 0xcc79a7}, {"black", 0x000000}};
enum { COLOURS = sizeof colour_of / sizeof *colour_of };

/* Slice d through the middle: columns along the first other direction, rows along the second, from below. */
static int draw(const char *path, const struct solid_voxels *v, const uint64_t *loose, int d) {
    static const uint32_t pore = 0xffffff, floating = 0xe67800;
    const int a = d == 0 ? 1 : 0, b = d == 2 ? 1 : 2, n = v->n[a] > v->n[b] ? v->n[a] : v->n[b];
    const int zoom = n < PICTURE ? (PICTURE + n - 1) / n : 1, skip = (n + 4 * PICTURE - 1) / (4 * PICTURE);
    const int width = v->n[a] / skip * zoom, height = v->n[b] / skip * zoom;
    uint32_t *rgb = memory_new(MEMORY_OUTPUT, (size_t)width * (size_t)height, sizeof *rgb), *to = rgb;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            int at[3] = {0};
            at[a] = x / zoom * skip;
            at[b] = (height - 1 - y) / zoom * skip;
            at[d] = v->n[d] / 2;
            uint32_t colour = colour_of[solid_voxels_kind(v, at[0], at[1], at[2]) % COLOURS].rgb;
            if (!solid_voxels_is(v, v->bits, at[0], at[1], at[2]))
                colour = pore;
            else if (loose && solid_voxels_is(v, loose, at[0], at[1], at[2]))
                colour = floating;
            *to++ = colour;
        }
    const int failed = postproc_figure_write_pixels(path, width, height, rgb);
    memory_free(rgb);
    return failed;
}

/* "solid grey", or "quartz grey, clay blue". */
static void name_colours(const struct scene *scene, const struct setup_image *image, char *text, size_t capacity) {
    const struct scene_image *s = &image->body->image;
    const int kinds = image->voxels->planes > 0 ? s->kinds : 1;
    text[0] = '\0';
    for (int k = 0; k < kinds; k++)
        snprintf(text + strlen(text), capacity - strlen(text), "%s%s %s", k ? ", " : "",
                 kinds > 1 ? name_of(scene, s, k) : "solid", colour_of[k % COLOURS].name);
}

static void write_slices(const char *folder, const struct scene *scene, const struct setup_image *image,
                         const uint64_t *loose) {
    char colours[SCENE_KINDS_MAX * (SCENE_NAME + 16)];
    char name[SCENE_NAME], path[FOLDER_PATH + SCENE_NAME + 8];
    const int fault = folder_make_path(folder);
    if (fault) die(EXIT_CODE_FILE, "%s: the folder for pictures cannot be made: %s", folder, strerror(fault));
    snprintf(name, sizeof name, "%s", image->body->name);
    for (char *at = name; *at; at++)
        if (!isalnum((unsigned char)*at) && !strchr("-_.", *at)) *at = '_';
    for (int d = 0; d < 3; d++) {
        snprintf(path, sizeof path, "%s/%s_%c.png", folder, name, "xyz"[d]);
        if (draw(path, image->voxels, loose, d))
            die(EXIT_CODE_FILE, "%s: cannot be written: %s", path, strerror(errno));
    }
    name_colours(scene, image, colours, sizeof colours);
    print("  slices     %s/%s_x.png, _y.png, _z.png through the middle, across x, y and z: pores white, %s, "
          "floating pieces orange; to the right y, x, x, upwards z, z, y\n",
          folder, name, colours);
}

static void print_memory(const struct solid_voxels *v) {
    const char *why = solid_voxels_why(v);
    print("  memory     %.1f MB of bits a %s%s%s; at most %.1f MB in use on a rank so far\n",
          1e-6 * (double)solid_voxels_bytes(v) * (1 + v->planes),
          why[0] ? "rank, because those of a node cannot share memory (" : "node", why, why[0] ? ")" : "",
          1e-6 * par_max((double)memory_peak()));
}

/* Particles of the body. */
static double check_one(const struct command *c, const struct scene *scene, int b) {
    struct setup_image *image = setup_image_read(scene, b);
    const struct solid_voxels *v = image->voxels;
    struct phase phase[2] = {{0}};
    uint64_t *loose = NULL;
    print_reading(scene, image);
    print_labels(image);
    if (par_rank() == 0) print_materials(scene, image);
    /* one rank measures the solid, another one the pores */
    for (int q = 0; q < 2; q++)
        if (par_rank() == (1 - q) % par_size()) measure(scene, image, q, &phase[q], q ? &loose : NULL);
    for (int q = 0; q < 2; q++) par_bcast(&phase[q], sizeof phase[q], (1 - q) % par_size());
    print_phases(image, phase);
    if (par_rank() == 0) write_slices(c->out, scene, image, loose);
    print_memory(v);
    const long gone = image->body->image.floating == SCENE_FLOATING_REMOVE ? phase[1].loose_voxels : 0;
    const double particles = (double)(phase[1].voxels - gone) * v->sites * v->sites * v->sites;
    memory_free(loose);
    setup_image_free(image);
    return particles;
}

double check_image(const struct command *c, const struct scene *scene) {
    double particles = 0;
    for (int b = 0; scene->solid && b < scene->solid->bodies; b++)
        if (scene->solid->body[b].own.shape == SOLID_IMAGE) particles += check_one(c, scene, b);
    if (particles > 0) print("\n");
    return particles;
}
