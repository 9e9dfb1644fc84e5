/* Several materials in one lattice body: kinds of particles. For solid/ only.
 *
 * A bond is made of the halves of its ends, as one of an interface (solid/law/pair.h). The kinds have one stencil, so
 * Gamma is the same from both ends:
 *
 *     K = (c_h + c_l)/2 Gamma      s0^2 = (c_h s_h^2 + c_l s_l^2)/(c_h + c_l)      G = (G_h + G_l)/2
 *
 * The sweep's arrays hold forces per volume over the density of kind 0. Most segments (solid/bonds/segments.h) have
 * bonds of one kind only: they take the ordinary kernel with that kind's constants. The others have several: their
 * kernel also loads c/(2 c of kind 0) of both ends. Bodies of one material have none of this, and lattice->kinds is
 * NULL. */
#pragma once
#include "solid/bonds/lattice.h"

enum { SOLID_KINDS_SEVERAL = 255 }; /* a segment of several kinds */

struct solid_kinds {
    int n;
    struct solid_law pair[SOLID_KINDS_MAX][SOLID_KINDS_MAX]; /* of bonds between two kinds, and within one */
    double stiffer[SOLID_KINDS_MAX];                         /* c over that of kind 0 */
    double lighter[SOLID_KINDS_MAX];                         /* the density of kind 0 over that of the kind */
    int is_even;                                             /* all have one density */
    double least;                                            /* the least eps at which a bond breaks */
    uint8_t of_material[256];
    const uint8_t *material; /* of the particles, by local index; borrowed */
    double *memory;          /* of the arrays below */
    double *half, *look;     /* [places + 8] c/(2 c of kind 0); eps at which a bond within the kind breaks, less 1e-9 */
    uint8_t *segment;        /* [segments] the kind of all ends of its bonds, or SOLID_KINDS_SEVERAL */
    struct solid_lattice_offset *table; /* [n][2][offsets] work of the sweep: constants of each kind */
};

/* Makes them for a lattice that is linked. law [n]; material: of the particles, by local index, ghosts included; is
 * material kind[k] of the k-th law. Not collective. */
struct solid_kinds *solid_kinds_new(const struct solid_lattice *lattice, const struct solid_law *law, int n,
                                    const int *kind, const uint8_t *material);
void solid_kinds_free(struct solid_kinds *kinds); /* may be NULL */

static inline int solid_kinds_of(const struct solid_kinds *kinds, int h) {
    return kinds->of_material[kinds->material[h]];
}

/* The law of the bond between two particles of the lattice. */
static inline const struct solid_law *solid_kinds_law(const struct solid_lattice *lattice, int h, int l) {
    const struct solid_kinds *kinds = lattice->kinds;
    return kinds ? &kinds->pair[solid_kinds_of(kinds, h)][solid_kinds_of(kinds, l)] : &lattice->law;
}
