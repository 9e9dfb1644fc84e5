/* Several materials in one lattice body. For solid/ only. The materials of the body are numbered 0, 1, .. (`kind`).
 *
 * A bond consists of the halves of its ends, as a bond of an interface does (solid/law/pair.h). The materials have the
 * same stencil, so Gamma is the same from both ends:
 *
 *     K = (c_h + c_l)/2 Gamma      s0^2 = (c_h s_h^2 + c_l s_l^2)/(c_h + c_l)      G = (G_h + G_l)/2
 *
 * The sweep's arrays hold forces per volume over the density of material 0. Most segments (solid/bonds/segments.h) have
 * bonds of one material only: they use the ordinary kernel with that material's constants. For the others the kernel
 * also loads c/(2 c of material 0) of both ends. In bodies of one material lattice->materials is NULL. */
#pragma once
#include "solid/bonds/lattice.h"

enum { SOLID_MATERIALS_SEVERAL = 255 }; /* a segment of several materials */

struct solid_materials {
    int n;
    struct solid_law pair[SOLID_BODY_MATERIALS_MAX]
                         [SOLID_BODY_MATERIALS_MAX]; /* of bonds between two materials, and within one */
    double stiffer[SOLID_BODY_MATERIALS_MAX];        /* c over that of material 0 */
    double lighter[SOLID_BODY_MATERIALS_MAX];        /* the density of material 0 over that of the material */
    int is_even;                                     /* all have one density */
    double least;                                    /* the least eps at which a bond breaks */
    uint8_t of_material[256];
    const uint8_t *material;  /* of the particles, by local index; borrowed */
    double *memory;           /* of the arrays below */
    double *half, *threshold; /* [places + 8] c/(2 c of material 0); eps at which a bond within the material breaks,
                               * times 1 - 1e-9 */
    uint8_t *segment;         /* [segments] the material of all ends of its bonds, or SOLID_MATERIALS_SEVERAL */
    struct solid_lattice_offset *table; /* [n][2][offsets] work of the sweep: constants of each material */
};

/* Makes them for a lattice that is linked. law [n]; material: of the particles, by local index, ghosts included; is
 * material kind[k] of the k-th law. Not collective. */
struct solid_materials *solid_materials_new(const struct solid_lattice *lattice, const struct solid_law *law, int n,
                                            const int *kind, const uint8_t *material);
void solid_materials_free(struct solid_materials *materials); /* may be NULL */

static inline int solid_materials_of(const struct solid_materials *materials, int h) {
    return materials->of_material[materials->material[h]];
}

/* The law of the bond between two particles of the lattice. */
static inline const struct solid_law *solid_materials_law(const struct solid_lattice *lattice, int h, int l) {
    const struct solid_materials *materials = lattice->materials;
    return materials ? &materials->pair[solid_materials_of(materials, h)][solid_materials_of(materials, l)]
                     : &lattice->law;
}
