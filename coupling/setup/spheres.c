/* Reads a list of spheres and ellipsoids: x y z radius, or x y z and three radii, a line. */
#include "base/ensure.h"
#include "base/par.h"
#include "base/text.h"
#include "coupling/setup/lines.h"
#include "coupling/setup/parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WHAT "x y z radius, or x y z and three radii"

struct entries {
    double (*entry)[6];
    long n, capacity;
};

static void add(struct entries *to, const double centre[3], const double radii[3]) {
    if (to->n == to->capacity) {
        to->capacity = 2 * to->capacity + 64;
        to->entry = realloc(to->entry, (size_t)to->capacity * sizeof *to->entry);
        ENSURE(to->entry, "no memory for %ld spheres", to->capacity);
    }
    memcpy(to->entry[to->n], centre, 3 * sizeof(double));
    memcpy(to->entry[to->n++] + 3, radii, 3 * sizeof(double));
}

static char *take(void *with, long at, int n, const double *value) {
    if (n != 4 && n != 6) return text_new("line %ld is not the numbers " WHAT " (as in 0.01 0.02 0.03 0.004)", at);
    const double radii[3] = {value[3], value[n == 6 ? 4 : 3], value[n == 6 ? 5 : 3]};
    for (int c = 0; c < 3; c++)
        if (!isfinite(value[c]) || !isfinite(radii[c]) || !(radii[c] > 0))
            return text_new("line %ld: radii must be greater than 0 and everything finite", at);
    add(with, value, radii);
    return NULL;
}

/* Returns NULL, or why a line is wrong. */
static char *read_file(const struct scene_part *from, const char *name, struct entries *to) {
    char what[SCENE_NAME + 32], *why;
    snprintf(what, sizeof what, "list of spheres of body %s", name);
    const long lines = setup_lines_read(from->file, what, take, to, &why);
    if (!why && lines == 0) why = text_new("holds no line " WHAT);
    return why;
}

void setup_spheres(const struct scene_part *from, const char *name, struct solid_body *to) {
    struct entries list = {0};
    char *why = NULL;
    if (from->spheres == 0 && par_rank() == 0) why = read_file(from, name, &list);
    setup_lines_die(from->file, why);
    for (int k = 0; k < from->spheres; k++) {
        const double *sphere = from->sphere[k], radii[3] = {sphere[3], sphere[3], sphere[3]};
        add(&list, sphere, radii);
    }
    par_bcast(&list.n, sizeof list.n, 0);
    if (!list.entry) list.entry = malloc((size_t)list.n * sizeof *list.entry);
    ENSURE(list.entry, "no memory for %ld spheres", list.n);
    par_bcast(list.entry, (size_t)list.n * sizeof *list.entry, 0);
    to->entries = list.n;
    to->entry = (const double(*)[6])list.entry;
}
