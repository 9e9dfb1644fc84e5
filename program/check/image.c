/* frana check of images: what was understood, labels, porosity, connected and floating parts, thin parts, slices. */
#include "program/check/parts.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/print.h"
#include "coupling/setup/image.h"
#include "coupling/setup/image_cut.h"
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

enum { CELLS_WIDE = 3, EDGE_MAX = 64, PICTURE = 512 };

/* What is measured of the solid or of the pores, by one rank each. */
struct phase {
    long voxels, pieces, largest, through[3];
    long floating_pieces, floating_voxels, floating_largest;
    long thin;
    int edge[3]; /* voxels along the box's edges */
};

static double share(long part, long whole) { return whole > 0 ? 100.0 * (double)part / (double)whole : 0; }

static long voxels_of(const struct setup_image *image) {
    const int *n = image->voxels->n;
    return (long)n[0] * n[1] * n[2];
}

/* "1e-05", or "1e-05 x 1e-05 x 2e-05" where they differ. */
static const char *lengths(const double edge[3], char *text, size_t capacity) {
    const int n = snprintf(text, capacity, "%.6g", edge[0]);
    if (edge[1] != edge[0] || edge[2] != edge[0])
        snprintf(text + n, capacity - (size_t)n, " x %.6g x %.6g", edge[1], edge[2]);
    return text;
}

static void print_reading(const struct scene *scene, const struct setup_image *image) {
    static const char *const axes[] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
    const struct scene_image *s = &image->body->image;
    const struct solid_voxels *v = image->voxels;
    const char *a = axes[s->axes];
    print("\nimage %s\n", image->body->name);
    print("  file       %s, %s, %s\n", image->body->own.file, image->format, image->type);
    char voxel[64];
    print("  voxels     %d along x, %d along y, %d along z, of %s m; in the file %c varies first, then %c, then %c\n",
          s->size[0], s->size[1], s->size[2], lengths(s->voxel, voxel, sizeof voxel), a[0], a[1], a[2]);
    if (image->header_voxel[0] > 0)
        print("  header     says voxels of %s%s%s; the scene's count\n",
              lengths(image->header_voxel, voxel, sizeof voxel), image->header_unit[0] ? " " : "",
              image->header_unit[0] ? image->header_unit : " without a unit");
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
    const double *low = image->body->own.low;
    const int *sites = v->sites, is_cube = sites[0] == sites[1] && sites[0] == sites[2];
    int n[3];
    double high[3];
    char along[64];
    for (int c = 0; c < 3; c++) {
        n[c] = v->n[c] * sites[c];
        high[c] = low[c] + n[c] * scene->solid->spacing;
    }
    snprintf(along, sizeof along, is_cube ? "%d" : "%d, %d and %d", sites[0], sites[1], sites[2]);
    print(
        "  body       %d x %d x %d lattice sites %.6g m apart, %s along the edge%s of a %s; from (%.6g, %.6g, %.6g) m "
        "to (%.6g, %.6g, %.6g) m\n",
        n[0], n[1], n[2], scene->solid->spacing, along, is_cube ? "" : "s", image->per_cell > 1 ? "cell" : "voxel",
        low[0], low[1], low[2], high[0], high[1], high[2]);
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
    long count[1 << SOLID_VOXELS_PLANES], faces[3], solid = 0;
    double edge[3], area = 0;
    if (v->planes == 0) return;
    solid_borders_count(v, count, faces);
    for (int c = 0; c < 3; c++) edge[c] = v->sites[c] * scene->solid->spacing;
    for (int c = 0; c < 3; c++) area += (double)faces[c] * edge[(c + 1) % 3] * edge[(c + 2) % 3];
    for (int k = 0; k < s->kinds; k++) solid += count[k];
    for (int k = 0; k < s->kinds; k++)
        print("  %-10s %s: %ld %s, %.4f %% of the solid\n", k ? "" : "materials", name_of(scene, s, k), count[k],
              image->per_cell > 1 ? "cells" : "voxels", share(count[k], solid));
    print("  borders    %ld faces between voxels of two materials: %.6g m2, %.6g m2 a m3 of solid\n",
          faces[0] + faces[1] + faces[2], area, area / ((double)solid * edge[0] * edge[1] * edge[2]));
}

/* Voxels that a cube of CELLS_WIDE lengths reaches into along an edge. */
static int edge_of(double length, double voxel) { return (int)ceil(CELLS_WIDE * length / voxel - 1e-6); }

/* loose: the bits of the solid's loose pieces, if there are any; may be NULL. */
static void measure(const struct scene *scene, const struct setup_image *image, int is_solid, struct phase *phase,
                    uint64_t **loose) {
    const struct solid_voxels *v = image->voxels;
    const double spacing = scene->solid->spacing;
    int wraps[3], fits = 1, is_one = 1;
    setup_image_wraps(scene, image, wraps);
    struct solid_components *c =
        is_solid ? setup_image_solid(scene, image) : solid_components_new(v, 0, wraps, 0, NULL);
    *phase = (struct phase){c->voxels,
                            c->pieces,
                            c->largest,
                            {c->through[0], c->through[1], c->through[2]},
                            c->floating_pieces,
                            c->floating_voxels,
                            c->floating_largest,
                            0,
                            {0}};
    for (int d = 0; d < 3; d++) {
        const double cell = scene->fluid ? scene->domain.size[d] / scene->domain.cells[d] : spacing;
        phase->edge[d] = edge_of(is_solid ? spacing : cell, v->sites[d] * spacing);
        fits &= phase->edge[d] < EDGE_MAX;
        is_one &= phase->edge[d] == 1;
    }
    if (loose && c->floating_pieces > 0) solid_components_floating(c, v, *loose = solid_voxels_array(v));
    solid_components_free(c);
    if (fits && !is_one) phase->thin = solid_opening_thin(v, is_solid, phase->edge);
}

static void print_thin(const struct phase *phase, const char *what, const char *unit) {
    if (phase->edge[0] >= EDGE_MAX || phase->edge[1] >= EDGE_MAX || phase->edge[2] >= EDGE_MAX)
        print("  thin %s     not measured: a voxel is less than a twentieth of a %s\n", what, unit);
    else
        print("  thin %-5s %.4f %% of the %s is less than %d %ss wide: in no cube of %d %ss that lies within it\n",
              what, share(phase->thin, phase->voxels), what, CELLS_WIDE, unit, CELLS_WIDE, unit);
}

static void print_pores(const struct phase *pore, long all) {
    if (pore->voxels == 0) {
        print("  porosity   0: no voxel is pore\n");
        return;
    }
    print("  porosity   %.5f; connected from face to face along x %.5f, y %.5f, z %.5f\n",
          (double)pore->voxels / (double)all, (double)pore->through[0] / (double)all,
          (double)pore->through[1] / (double)all, (double)pore->through[2] / (double)all);
    print("  pores      %ld piece%s, the largest %.4f %% of the pores\n", pore->pieces, pore->pieces == 1 ? "" : "s",
          share(pore->largest, pore->voxels));
}

static void print_phases(const struct setup_image *image, const struct phase phase[2]) {
    static const char *const done[] = {"kept", "removed", "held"};
    const struct phase *pore = &phase[0], *solid = &phase[1];
    print_pores(pore, voxels_of(image));
    print("  solid      %ld piece%s, the largest %.4f %% of the solid\n", solid->pieces, solid->pieces == 1 ? "" : "s",
          share(solid->largest, solid->voxels));
    if (solid->floating_pieces > 0)
        print("  floating   %ld piece%s of solid, %.4f %% of it, the largest of %ld voxels: %s\n",
              solid->floating_pieces, solid->floating_pieces == 1 ? "" : "s",
              share(solid->floating_voxels, solid->voxels), solid->floating_largest, done[image->body->image.floating]);
    else
        print("  floating   no piece of solid\n");
    if (pore->voxels > 0) print_thin(pore, "pore", "cell");
    print_thin(solid, "solid", "particle");
    if (pore->voxels > 0 && pore->through[0] + pore->through[1] + pore->through[2] == 0)
        print("  warning: no pore leads from face to face in any direction\n");
    if (solid->through[0] + solid->through[1] + solid->through[2] == 0)
        print("  warning: no piece of solid reaches from face to face in any direction\n");
}

static void print_cut(const struct scene *scene, const struct setup_image *image, const uint64_t *loose) {
    const uint64_t *gone = image->body->image.floating == SCENE_FLOATING_REMOVE ? loose : NULL;
    char sentence[IMAGE_CUT_SENTENCE];
    for (int axis = 0; axis < 3; axis++)
        if (image_cut_describe(image_cut_share(scene, image->voxels, gone, axis), axis, sentence))
            print("  warning: %s\n", sentence);
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
    const int least = v->sites[a] < v->sites[b] ? v->sites[a] : v->sites[b];
    const double wide = (double)zoom * v->sites[a] / least, high = (double)zoom * v->sites[b] / least; /* of a voxel */
    const int width = (int)(v->n[a] / skip * wide), height = (int)(v->n[b] / skip * high);
    uint32_t *rgb = memory_new(MEMORY_OUTPUT, (size_t)width * (size_t)height, sizeof *rgb), *to = rgb;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            int at[3] = {0};
            at[a] = (int)(x / wide) * skip;
            at[b] = (int)((height - 1 - y) / high) * skip;
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
    if (par_rank() == 0) print_cut(scene, image, loose);
    if (par_rank() == 0) write_slices(c->out, scene, image, loose);
    print_memory(v);
    const long gone = image->body->image.floating == SCENE_FLOATING_REMOVE ? phase[1].floating_voxels : 0;
    const double particles = (double)(phase[1].voxels - gone) * v->sites[0] * v->sites[1] * v->sites[2];
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
