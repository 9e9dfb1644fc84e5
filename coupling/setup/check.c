/* Checks a plate's outlines and cracks by their geometry before anything is written. */
#include "base/die.h"
#include "base/ensure.h"
#include "coupling/setup/parts.h"
#include "solid/geometry/outline.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Appends ", 2 to 3 its holes"; nothing if there are none. A full text is truncated. */
static void add_range(char *text, size_t size, int first, int n, const char *one, const char *many) {
    const size_t at = strlen(text);
    if (n == 1) snprintf(text + at, size - at, ", %d its %s", first, one);
    if (n > 1) snprintf(text + at, size - at, ", %d to %d its %s", first, first + n - 1, many);
}

/* Describes the outlines by number: " (outline 1 is the body's own, 2 its piece, 3 to 4 its holes)". */
static void name_body(const struct scene_body *b, char *text, size_t size) {
    text[0] = '\0';
    if (b->outlines < 2) return;
    snprintf(text, size, " (outline 1 is the body's own");
    add_range(text, size, 2, b->pieces, "piece", "pieces");
    add_range(text, size, 2 + b->pieces, b->holes, "hole", "holes");
    snprintf(text + strlen(text), size - strlen(text), ")");
}

static void check_outlines(const struct scene *scene, int b, const struct solid_body *body) {
    char fault[256], which[128];
    if (!solid_outline_fault(body->outline, body->outlines, fault, sizeof fault)) return;
    name_body(&scene->solid->body[b], which, sizeof which);
    die_all(EXIT_CODE_SCENE, "%s: solid.bodies[%d] (%s): %s%s", scene->path, b, body->name, fault, which);
}

/* Whether some body contains a part of the crack, as far as its shape is known. */
static int is_in_body(const struct scene_solid *s, const struct solid_body *body, const struct solid_cut *cut) {
    for (int b = 0; b < s->bodies; b++)
        if (body[b].outlines == 0 ||
            solid_outline_length_inside(body[b].outline, body[b].outlines, cut, s->spacing) > 0)
            return 1;
    return 0;
}

int setup_check_are_cubes(const struct scene *scene) {
    double d[3];
    for (int c = 0; c < 3; c++) d[c] = scene->domain.size[c] / scene->domain.cells[c];
    return fabs(d[1] - d[0]) <= 1e-9 * d[0] && fabs(d[2] - d[0]) <= 1e-9 * d[0];
}

void setup_check(const struct scene *scene) {
    const struct scene_solid *s = scene->solid;
    if (!s || scene->dimension == 3) return;
    struct solid_body *body = calloc((size_t)s->bodies, sizeof *body);
    ENSURE(body, "no memory for %d bodies", s->bodies);
    for (int b = 0; b < s->bodies; b++) {
        setup_body_outlines(&s->body[b], &body[b]);
        if (body[b].outlines > 0) check_outlines(scene, b, &body[b]);
    }
    for (int k = 0; k < s->cracks; k++) {
        struct solid_cut cut;
        setup_body_cut(&s->crack[k], &cut);
        if (!is_in_body(s, body, &cut))
            die_all(EXIT_CODE_SCENE, "%s: solid.cracks[%d]: no part of it lies in a body", scene->path, k);
        setup_body_cut_free(&cut);
    }
    for (int b = 0; b < s->bodies; b++) setup_body_free(&body[b]);
    free(body);
}
