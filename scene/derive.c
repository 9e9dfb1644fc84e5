/* Sets the scene's members that follow from others: dimension, periodicity, time tables, outlines. */
#include "scene/derive.h"
#include "base/die.h"
#include "scene/outline.h"
#include "scene/text/path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int is_given(const struct scene_node *root, const char *path) { return scene_node_find(root, path) != NULL; }

/* The different materials of an image. */
static void derive_kinds(const struct scene_solid *s, struct scene_body *body) {
    struct scene_image *image = &body->image;
    for (int l = 0; l < image->materials; l++) {
        struct scene_image_material *entry = &image->material[l];
        int known = 0;
        entry->index = -1;
        for (int m = s->materials - 1; m >= 0; m--)
            if (!strcmp(entry->material, s->material[m].name)) entry->index = m;
        for (int k = 0; k < image->kinds && k < SCENE_KINDS_MAX; k++) known |= image->kind[k] == entry->index;
        if (known || entry->index < 0) continue;
        if (image->kinds < SCENE_KINDS_MAX) image->kind[image->kinds] = entry->index;
        image->kinds++;
    }
    if (image->kinds > 0) body->material_index = image->kind[0];
}

static void derive_body(const struct scene_solid *s, const struct scene_node *root, int b) {
    struct scene_body *body = &s->body[b];
    body->has_cavities = is_given(root, AT("solid.bodies[%d].cavities", b));
    body->image.has_crop = is_given(root, AT("solid.bodies[%d].crop", b));
    body->image.has_threshold = is_given(root, AT("solid.bodies[%d].threshold", b));
    for (int d = 0; d < 3; d++) {
        body->image.flips[d] = strchr(body->image.flip, "xyz"[d]) != NULL;
        body->image.mirrors[d] = strchr(body->image.mirror, "xyz"[d]) != NULL;
    }
    for (int m = s->materials - 1; m >= 0; m--)
        if (!strcmp(body->material, s->material[m].name)) body->material_index = m;
    derive_kinds(s, body);
    scene_outline_make(body);
}

/* Splits the file's pairs [t, factor] into two arrays. */
static void derive_time(const struct scene *s, struct scene_time *time) {
    time->stage = time->from[0] ? -1 : 0;
    for (int k = s->stages - 1; k >= 0 && time->from[0]; k--)
        if (!strcmp(time->from, s->stage[k].name)) time->stage = k + 1;
    if (time->n == 0) return;
    time->t = malloc((size_t)time->n * sizeof(double));
    time->factor = malloc((size_t)time->n * sizeof(double));
    if (!time->t || !time->factor) die(EXIT_CODE_FILE, "no memory left for the scene");
    for (int i = 0; i < time->n; i++) {
        time->t[i] = time->point[i][0];
        time->factor[i] = time->point[i][1];
    }
}

static void time_free(struct scene_time *time) {
    free(time->t);
    free(time->factor);
    time->t = time->factor = NULL;
}

static void derive_refinement(struct scene_refinement *r, const struct scene_node *root) {
    if (!r || is_given(root, "solid.refinement.low")) return;
    for (int d = 0; d < 3; d++) {
        r->low[d] = -INFINITY;
        r->high[d] = INFINITY;
    }
}

static void derive_solid(const struct scene *scene, const struct scene_node *root) {
    struct scene_solid *s = scene->solid;
    for (int b = 0; b < s->bodies; b++) derive_body(s, root, b);
    for (int i = 0; i < s->interfaces; i++)
        for (int e = 0; e < 2; e++) {
            s->interface[i].body[e] = -1;
            for (int b = s->bodies - 1; b >= 0; b--)
                if (!strcmp(s->interface[i].between[e], s->body[b].name)) s->interface[i].body[e] = b;
        }
    for (int i = 0; i < s->constraints; i++) {
        struct scene_constraint *k = &s->constraint[i];
        for (int d = 0; d < 3; d++) k->direction[d] = strchr(k->directions, "xyz"[d]) != NULL;
        k->has_displacement = is_given(root, AT("solid.constraints[%d].displacement", i));
        derive_time(scene, &k->time);
    }
    for (int i = 0; i < s->loads; i++) {
        struct scene_load *load = &s->load[i];
        load->kind = is_given(root, AT("solid.loads[%d].edge", i)) ? SOLID_LOAD_EDGE : SOLID_LOAD_REGION;
        derive_time(scene, &load->time);
    }
    derive_refinement(s->refinement, root);
}

/* auto: about 20 dumps over all stages, besides those at the stages' ends. */
static void derive_output(struct scene *s) {
    enum { DUMPS = 20 };
    long steps = 0;
    if (s->output.fields_every >= 0) return;
    for (int k = 0; k < s->stages; k++) {
        const struct scene_stage *stage = &s->stage[k];
        const double taken =
            stage->duration > 0 && stage->time_step > 0 ? stage->duration / stage->time_step : INFINITY;
        steps += taken < (double)stage->steps ? (long)ceil(taken) : stage->steps;
    }
    if (s->stages == 0) steps = 1; /* solved at once: one file of fields */
    s->output.fields_every = (steps + DUMPS - 1) / DUMPS;
}

static void derive_injections(const struct scene *s, const struct scene_node *root) {
    struct scene_crack_fluid *f = s->crack_fluid;
    for (int i = 0; f && i < f->injections; i++) {
        f->injection[i].is_pressure = is_given(root, AT("crack_fluid.injections[%d].pressure", i));
        derive_time(s, &f->injection[i].time);
    }
}

void scene_derive_domain(struct scene *s, const struct scene_node *root) {
    const struct scene_node *size = scene_node_find(root, "domain.size");
    s->dimension = size && size->n == 3 && !size->bad ? 3 : 2;
    if (s->nonlocal) s->dimension = s->nonlocal->dimension;
}

void scene_derive(struct scene *s, const struct scene_node *root) {
    for (int d = 0; d < 3 && s->fluid; d++) s->domain.periodic[d] = s->fluid->side[d][0].type == FLUID_PERIODIC;
    if (s->fluid) s->fluid->has_taylor_green = is_given(root, "fluid.initial.taylor_green");
    if (s->solid) derive_solid(s, root);
    derive_injections(s, root);
    if (s->crack_fluid && s->fluid && !is_given(root, "crack_fluid.viscosity"))
        s->crack_fluid->viscosity = s->fluid->density * s->fluid->viscosity;
    for (int i = 0; i < s->stages; i++) s->stage[i].has_until = is_given(root, AT("stages[%d].until", i));
    derive_output(s);
}

void scene_derive_free(struct scene *s) {
    for (int b = 0; s->solid && b < s->solid->bodies; b++) scene_outline_free(&s->solid->body[b]);
    for (int i = 0; s->solid && i < s->solid->constraints; i++) time_free(&s->solid->constraint[i].time);
    for (int i = 0; s->solid && i < s->solid->loads; i++) time_free(&s->solid->load[i].time);
    for (int i = 0; s->crack_fluid && i < s->crack_fluid->injections; i++)
        time_free(&s->crack_fluid->injection[i].time);
}
