/* Checks the bodies that are cut from images: the file's header, the crop, voxels and cells that fit each other. */
#include "base/text.h"
#include "base/files/image.h"
#include "physics/limits.h"
#include "scene/check/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A place on the lattice and a ratio of lengths are whole to this part of a spacing. */
static const double WHOLE = 1e-6;
enum { SITES_MAX = 64 }; /* along the edge of a voxel, or voxels along that of a cell */

/* Voxels along d that are used, before mirroring; 0: not known. */
static int voxels_of(const struct scene_image *image, int d) {
    return image->has_crop ? image->crop_high[d] - image->crop_low[d] : image->size[d];
}

int scene_check_image_bounds(const struct scene_body *body, double low[3], double high[3]) {
    for (int d = 0; d < 3; d++) {
        const int n = voxels_of(&body->image, d);
        if (n <= 0) return 0;
        low[d] = body->own.low[d];
        high[d] = low[d] + n * (1 + body->image.mirrors[d]) * body->image.voxel[d];
    }
    return 1;
}

/* Adds key: [x, y, z] as the file's header gives it, in six digits: headers round. */
static void add_from_header(struct scene_node *body, const char *key, const double value[3]) {
    struct scene_node *list = scene_node_new(SCENE_NODE_LIST, key, NULL);
    int at = 0;
    list->line = body->line;
    for (int d = 0; d < 3; d++) {
        char *text = text_new("%.6g", value[d]);
        scene_node_append(list, scene_node_new(SCENE_NODE_SCALAR, NULL, text));
        free(text);
    }
    while (at < body->n && strcmp(body->child[at]->key, "format") != 0) at++;
    scene_node_insert(body, at < body->n ? at + 1 : body->n, list);
}

/* Takes the size and the edges of a voxel that the scene leaves out from the file. */
static void take_from_header(struct scene_image *image, struct scene_node *node, const struct files_image *file) {
    const long *n = files_image_size(file);
    const double *edge = files_image_voxel(file);
    if (!scene_node_child(node, "size")) {
        for (int d = 0; d < 3; d++) image->size[d] = (int)n[d];
        add_from_header(node, "size", (double[3]){(double)n[0], (double)n[1], (double)n[2]});
    }
    if (!scene_node_child(node, "voxel")) {
        add_from_header(node, "voxel", edge);
        for (int d = 0; d < 3; d++) image->voxel[d] = atof(scene_node_child(node, "voxel")->child[d]->value);
    }
}

static int are_equal(const double edge[3]) {
    return fabs(edge[1] - edge[0]) <= 1e-3 * edge[0] && fabs(edge[2] - edge[0]) <= 1e-3 * edge[0];
}

static void open_one(struct scene *s, struct scene_node *root, struct scene_problems *problems, int b) {
    static const char *const key[] = {"file",       "format", "dataset",      "size", "type",
                                      "byte_order", "axes",   "header_bytes", "unit"};
    static const char axes[][4] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
    const struct scene_check its = {s, root, problems}, *c = &its;
    const struct scene_path path = PATH("solid.bodies[%d]", b);
    struct scene_image *image = &s->solid->body[b].image;
    struct scene_node *node = scene_node_find(root, path.text);
    struct files_image_input in = {.file = s->solid->body[b].own.file,
                                   .format = image->format,
                                   .dataset = image->dataset,
                                   .type = image->type,
                                   .byte_order = image->byte_order,
                                   .header_bytes = image->header_bytes};
    char problem[512];
    if (access(in.file, R_OK) != 0) return; /* reported where names are resolved */
    for (size_t k = 0; k < sizeof key / sizeof *key; k++)
        if (scene_node_child(node, key[k]) && !CLEAN(c, AT("%s.%s", path.text, key[k]))) return;
    memcpy(in.axes, axes[image->axes], sizeof in.axes);
    for (int d = 0; d < 3; d++) {
        in.size[d] = image->size[d];
        in.edge[d] = image->unit > 0 ? image->voxel[d] / image->unit : 0;
    }
    struct files_image *file = files_image_open(&in, problem, sizeof problem);
    if (!file) {
        const size_t name = strlen(in.file);
        const int named = !strncmp(problem, in.file, name) && !strncmp(problem + name, ": ", 2);
        PROBLEM(c, AT("%s.file", path.text), "%s", problem + (named ? name + 2 : 0));
        node->bad = 1;
        return;
    }
    const long *n = files_image_size(file);
    const double *edge = files_image_voxel(file);
    const struct scene_node *voxel = scene_node_child(node, "voxel");
    if (voxel && voxel->kind == SCENE_NODE_SCALAR && !are_equal(edge)) {
        PROBLEM(c, AT("%s.voxel", path.text),
                "one length, and the file has voxels of %g x %g x %g%s%s: give the three, as in voxel: [x, y, z]",
                edge[0], edge[1], edge[2], files_image_unit(file)[0] ? " " : "", files_image_unit(file));
        node->bad = 1;
    } else if (n[0] > 1000000 || n[1] > 1000000 || n[2] > 1000000) {
        PROBLEM(c, AT("%s.file", path.text), "has %ld x %ld x %ld voxels, at most 1000000 are possible in a direction",
                n[0], n[1], n[2]);
        node->bad = 1;
    } else if (!voxel && !(files_image_unit(file)[0] && edge[0] > 0 && edge[1] > 0 && edge[2] > 0)) {
        PROBLEM(c, AT("%s.voxel", path.text),
                "missing (m): the file does not give the size of its voxels with a unit of length");
        node->bad = 1;
    } else {
        take_from_header(image, node, file);
    }
    files_image_close(file);
}

void scene_check_image_open(struct scene *s, struct scene_node *root, struct scene_problems *problems) {
    for (int b = 0; s->solid && b < s->solid->bodies; b++)
        if (s->solid->body[b].own.shape == SOLID_IMAGE && scene_node_find(root, "solid.bodies"))
            open_one(s, root, problems, b);
}

/* Whether the word consists of different letters x, y, z. */
static int check_letters(const struct scene_check *c, struct scene_path path, const char *word) {
    for (const char *at = word; at && *at; at++)
        if (!strchr("xyz", *at) || strchr(at + 1, *at)) {
            PROBLEM(c, path.text, "must be a word of the letters x, y and z, each at most once");
            return 0;
        }
    return 1;
}

static int check_crop(const struct scene_check *c, struct scene_path body, const struct scene_image *image) {
    for (int d = 0; image->has_crop && d < 3; d++) {
        if (image->crop_low[d] >= image->crop_high[d]) {
            PROBLEM(c, AT("%s.crop.low", body.text), "must be below high in every direction, %c is not", "xyz"[d]);
            return 0;
        }
        if (image->size[d] > 0 && image->crop_high[d] > image->size[d]) {
            PROBLEM(c, AT("%s.crop.high", body.text), "must be at most %d in %c: the image has no more voxels",
                    image->size[d], "xyz"[d]);
            return 0;
        }
    }
    return 1;
}

/* How many times `part` goes into `whole`, 1 .. SITES_MAX; 0: not a whole number of times. */
static int times(double whole, double part) {
    const double ratio = rint(whole / part);
    return ratio >= 1 && ratio <= SITES_MAX && fabs(whole / part - ratio) <= WHOLE ? (int)ratio : 0;
}

/* Says which spacing would fit voxels that are not cubes. */
static void report_spacing(const struct scene_check *c, struct scene_path body, const double voxel[3]) {
    const struct scene_path key = PATH("%s.voxel", body.text);
    for (int n = 1; n <= SITES_MAX; n++) {
        const double spacing = voxel[0] / n;
        if (!times(voxel[1], spacing) || !times(voxel[2], spacing)) continue;
        PROBLEM(c, key.text,
                "edges that differ must each be solid.spacing (%.10g m) times 1, 2, 3 ... %d; "
                "solid.spacing: %.10g fits",
                c->scene->solid->spacing, SITES_MAX, spacing);
        return;
    }
    PROBLEM(c, key.text,
            "edges that differ must each be solid.spacing times 1, 2, 3 ... %d, and no spacing fits %g, %g and "
            "%g m: resample the image to voxels that are cubes",
            SITES_MAX, voxel[0], voxel[1], voxel[2]);
}

/* A voxel must be a whole number of spacings, or a spacing a whole number of voxels, of which the image has a multiple.
 * Edges that differ are whole numbers of spacings. */
static int check_voxel(const struct scene_check *c, struct scene_path body, const struct scene_image *image) {
    const double spacing = c->scene->solid->spacing, *voxel = image->voxel;
    if (!(spacing > 0) || !(voxel[0] > 0)) return 1; /* reported elsewhere */
    if (voxel[1] != voxel[0] || voxel[2] != voxel[0]) {
        const int fits = times(voxel[0], spacing) && times(voxel[1], spacing) && times(voxel[2], spacing);
        if (!fits) report_spacing(c, body, voxel);
        return fits;
    }
    const int m = voxel[0] < spacing ? times(spacing, voxel[0]) : times(voxel[0], spacing);
    if (!m) {
        PROBLEM(c, AT("%s.voxel", body.text),
                "must be solid.spacing (%.10g m) times 1, 2, 3 ... %d (refinement), or divided by one of these "
                "(several voxels a cell)",
                spacing, SITES_MAX);
        return 0;
    }
    for (int d = 0; voxel[0] < (1 - WHOLE) * spacing && d < 3; d++) {
        const int n = voxels_of(image, d);
        if (n <= 0 || n % m == 0) continue;
        PROBLEM(c, AT("%s.voxel", body.text),
                "%d voxels along %c do not make whole cells of %d voxels; crop the image to %d", n, "xyz"[d], m,
                n / m * m);
        return 0;
    }
    return 1;
}

/* A site's centre must not lie on the border of two voxels: the low corner stands on a corner of the lattice's cells.
 */
static int check_place(const struct scene_check *c, struct scene_path body, const double low[3]) {
    const struct scene_solid *s = c->scene->solid;
    for (int d = 0; s->spacing > 0 && d < 3; d++) {
        const double at = low[d] / s->spacing - s->lattice_offset[d];
        if (fabs(at - rint(at)) <= WHOLE) continue;
        PROBLEM(c, AT("%s.low", body.text),
                "must be on a corner of the lattice's cells; along %c the nearest are at %.10g and %.10g m", "xyz"[d],
                (floor(at) + s->lattice_offset[d]) * s -> spacing,
                (floor(at) + 1 + s->lattice_offset[d]) * s -> spacing);
        return 0;
    }
    return 1;
}

static struct scene_path of_materials(int b, int l, const char *key) {
    return PATH("solid.bodies[%d].materials[%d].%s", b, l, key);
}

/* Each label of the solid needs one material, and each material is of a label of the solid. */
static int check_labels(const struct scene_check *c, int b) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_image *image = &s->body[b].image;
    const char *name[PHYSICS_BODIES_MAX];
    for (int m = 0; m < s->materials; m++) name[m] = s->material[m].name;
    for (int l = 0; l < image->materials; l++) {
        const struct scene_image_material *entry = &image->material[l];
        int first = 0, is_solid = 0;
        while (image->material[first].label != entry->label) first++;
        for (int q = 0; q < image->labels; q++) is_solid |= image->label[q] == entry->label;
        if (first < l) {
            PROBLEM(c, of_materials(b, l, "label").text, "has a material already, %s", image->material[first].material);
            return 0;
        }
        if (!is_solid) {
            PROBLEM(c, of_materials(b, l, "label").text, "is not among the labels of the solid, solid.bodies[%d].solid",
                    b);
            return 0;
        }
        if (!scene_check_parts_name(c, of_materials(b, l, "material"), entry->material, "solid.materials", s->materials,
                                    name))
            return 0;
    }
    for (int q = 0; q < image->labels; q++) {
        int has = 0;
        for (int l = 0; l < image->materials; l++) has |= image->material[l].label == image->label[q];
        if (has) continue;
        PROBLEM(c, AT("solid.bodies[%d].solid", b), "label %d has no material in solid.bodies[%d].materials",
                image->label[q], b);
        return 0;
    }
    return 1;
}

/* Why bonds of this material cannot stand in one lattice with those of another one; NULL: they can. */
static const char *why_not(const struct scene_material *k) {
    if (k->micromodulus != PHYSICS_CONSTANT) return "needs micromodulus: constant";
    if (k->breakage == SCENE_BILINEAR) return "must be brittle; it has the bilinear law";
    return k->s00 > 0 ? "must have a constant limit of the stretch; it has s00 and alpha" : NULL;
}

/* Several materials in one body: bonds on the lattice that differ in stiffness, density and limit only. */
static void check_kinds(const struct scene_check *c, int b) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_image *image = &s->body[b].image;
    const struct scene_path list = PATH("solid.bodies[%d].materials", b);
    if (image->kinds > SCENE_KINDS_MAX)
        PROBLEM(c, list.text, "has %d different materials, at most %d are possible", image->kinds, SCENE_KINDS_MAX);
    if (image->kinds < 2 || image->kinds > SCENE_KINDS_MAX) return;
    for (int l = 0; l < image->materials; l++) {
        const struct scene_material *k = &s->material[image->material[l].index], *first = &s->material[image->kind[0]];
        const char *why = why_not(k);
        if (why)
            PROBLEM(c, of_materials(b, l, "material").text, "in a body of several materials each %s", why);
        else if (k->horizon_ratio != first->horizon_ratio)
            PROBLEM(c, of_materials(b, l, "material").text,
                    "has a horizon_ratio of %g, and %s of %g: a body of several materials needs one", k->horizon_ratio,
                    first->name, first->horizon_ratio);
        else
            continue;
        return;
    }
    if (s->partial_volume != SOLID_PARTIAL_EXACT)
        PROBLEM(c, list.text, "several materials need solid.partial_volume: exact");
    for (int i = 0; i < s->interfaces; i++)
        if (s->interface[i].body[0] == b || s->interface[i].body[1] == b) {
            PROBLEM(c, list.text, "several materials do not go with an interface of the body, solid.interfaces[%d]", i);
            return;
        }
}

int scene_check_image(const struct scene_check *c, int b) {
    const struct scene_body *body = &c->scene->solid->body[b];
    const struct scene_path path = PATH("solid.bodies[%d]", b);
    const struct scene_coupling *k = c->scene->coupling;
    if (k && k->surface == SOLID_DEPTH_SHAPE && CLEAN(c, "coupling.surface"))
        PROBLEM(c, "coupling.surface",
                "does not go with a body of shape image (%s), whose surface only the lattice knows: must be "
                "lattice",
                path.text);
    int good = check_letters(c, PATH("%s.flip", path.text), body->image.flip) &
               check_letters(c, PATH("%s.mirror", path.text), body->image.mirror);
    if (body->image.materials > 0 && CLEAN(c, "solid.materials") && check_labels(c, b)) check_kinds(c, b);
    good &= check_crop(c, path, &body->image);
    return good && check_voxel(c, path, &body->image) && check_place(c, path, body->own.low);
}
