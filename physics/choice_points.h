/* What a scene chooses for arrangements of points and for element-free plates: meshless computes with it, scene has the
 * words (scene/keys/table.c, table_element_free.c). */
#pragma once

enum meshless_arrangement {
    MESHLESS_LATTICE,
    MESHLESS_HEXAGONAL,
    MESHLESS_PERTURBED,
    MESHLESS_CENTROIDAL,
    MESHLESS_RANDOM
};

enum meshless_volume { MESHLESS_EQUAL, MESHLESS_CELL };

enum galerkin_basis {
    GALERKIN_LINEAR, /* 1, x, y */
    GALERKIN_SQRT_R, /* and sqrt(r), r from the nearest tip */
    GALERKIN_TIP     /* and sqrt(r) times cos t/2, sin t/2, sin t/2 sin t, cos t/2 sin t */
};

enum galerkin_weight { GALERKIN_CUBIC, GALERKIN_QUARTIC };

enum galerkin_method {
    GALERKIN_VIRTUAL, /* cut along the crack and its extension, along which displacement and strain are continuous */
    GALERKIN_DIFFRACTION, /* weights pass round the tip */
    GALERKIN_VISIBILITY   /* cut along the crack alone */
};

enum galerkin_update { GALERKIN_CONJUGATE, GALERKIN_HESTENES_POWELL };
