/* Finds the bonds between the bodies that an interface joins. */
#include "solid/bonds/interface.h"
#include "base/die.h"
#include "base/memory.h"

#include <math.h>

int solid_interface_joins(const struct solid_input *in, int body, int other) {
    for (int k = 0; k < in->interfaces; k++) {
        const int *pair = in->interface[k].body;
        if ((pair[0] == body && pair[1] == other) || (pair[1] == body && pair[0] == other)) return 1;
    }
    return 0;
}

int solid_interface_any(const struct solid_input *in, int body) {
    for (int b = 0; b < in->bodies; b++)
        if (solid_interface_joins(in, body, b)) return 1;
    return 0;
}

/* The law of a body's ends, with partial volumes as accurate as within the body. */
static struct solid_bond_law law_of(const struct solid_input *in, const struct solid_cloud *cloud, int body,
                                    double fracture_energy) {
    struct solid_material material = in->material[in->body[body].material];
    material.fracture_energy = fracture_energy;
    struct solid_bond_law law = solid_pair_law(in, &material);
    law.columns = cloud->law.columns;
    return law;
}

struct solid_interface_side *solid_interface_new(const struct solid_input *in, struct solid_cloud *const *cloud,
                                                 int body, int *n) {
    struct solid_interface_side *interface = NULL;
    *n = 0;
    if (!solid_interface_any(in, body)) return NULL;
    interface = memory_new(MEMORY_SOLID, (size_t)in->interfaces, sizeof *interface);
    for (int k = 0; k < in->interfaces; k++) {
        const int *pair = in->interface[k].body;
        if (pair[0] != body && pair[1] != body) continue;
        const int other = pair[0] == body ? pair[1] : pair[0];
        interface[(*n)++] =
            (struct solid_interface_side){.cloud = cloud[other],
                                          .law = law_of(in, cloud[body], body, in->interface[k].fracture_energy),
                                          .other = law_of(in, cloud[other], other, in->interface[k].fracture_energy)};
    }
    return interface;
}

struct search {
    const struct solid_interface_side *interface;
    const struct solid_cloud *cloud;
    struct solid_end end;
    struct solid_cloud_near *near;
    int capacity;
};

static void take(void *with, long l, int image, const double *xi) {
    struct search *k = with;
    struct solid_cloud_near *near = k->near;
    const struct solid_end other = solid_cloud_end(k->interface->cloud, l);
    if (xi[0] == 0 && xi[1] == 0 && xi[2] == 0)
        die(EXIT_CODE_SCENE, "a particle of solid body %s and one of %s coincide", k->cloud->name,
            k->interface->cloud->name);
    if (!solid_pair_across_exists(&k->interface->law, &k->interface->other, xi, &k->end, &other)) return;
    if (near->n == k->capacity)
        die(EXIT_CODE_SCENE, "a particle of solid body %s has more than %d neighbours", k->cloud->name,
            SOLID_FAMILY_MAX);
    near->number[near->n] = l;
    near->image[near->n] = image;
    for (int c = 0; c < 3; c++) near->xi[near->n][c] = xi[c];
    near->n++;
}

/* The clouds' origins are rounded relative to each other as places are, so that xi is exact and the opposite from the
 * other end. */
void solid_interface_find(const struct solid_interface_side *interface, const struct solid_cloud *cloud, long number,
                          int capacity, struct solid_cloud_near *near) {
    struct search k = {interface, cloud, solid_cloud_end(cloud, number), near, capacity};
    double place[3] = {0};
    near->n = 0;
    for (int c = 0; c < cloud->dim; c++) {
        const double between = (interface->cloud->origin[c] - cloud->origin[c]) / cloud->spacing;
        place[c] = cloud->place[c][number] - 0x1p-20 * rint(0x1p20 * between);
    }
    solid_cloud_near_visit(interface->cloud, place, fmax(cloud->longest_reach, interface->cloud->longest_reach), take,
                           &k);
}
