/* What frana permeability says of a sample in creeping flow. */
#pragma once
#include "physics/darcy.h"
#include "program/permeability/level.h"

#include <stdio.h>

enum { PERMEABILITY_RESULT_LEVELS = 3 };

struct permeability_result {
    struct permeability_drive drive;
    int levels, of_voxels; /* 1: all bodies are images, whose voxels are the geometry */
    struct permeability_level level[PERMEABILITY_RESULT_LEVELS];
    int has_smooth;
    struct permeability_level smooth; /* on the scene's grid, the voxels as the stairs of a smooth solid */
    /* from the levels */
    double K[3][3], error[3][3];              /* m2; the error of the grid, NaN with one level */
    struct physics_darcy_principal principal; /* NaN where a part of K is */
    double reynolds[3];                       /* by the root of k, with the scene's driving */
};

/* Voxels: the tensor is extrapolated from the two levels, K_2 + (K_2 - K_1)/2, as for an error of the order 1.58,
 * between that of flow along edges and that of walls. The error is 0.35 |K_2 - K_1| and half a per cent of K_2. With a
 * third level, three times as fine as the scene, the order is the observed one, from 0.8 to 2, and the error what a
 * quarter more or less of it changes. Set drive, of_voxels and the levels first.
 * Shapes: their cells are stairs that change from level to level. So the tensor is that of the finer grid. Its error is
 * 2/3 |K_2 - K_1|, and what k changes, by Carman's formula, with the levels' difference in porosity and with walls that
 * are off by a small part of a cell. Not collective. */
void permeability_result_make(const struct scene *s, struct permeability_result *r);
/* 1: of voxels, and the error of an axis's k is more than a quarter of it: two levels do not tell the order. Not
 * collective. */
int permeability_result_is_rough(const struct permeability_result *r);
void permeability_result_csv(FILE *to, const struct permeability_result *r);
void permeability_result_page(FILE *to, const struct scene *s, const struct permeability_result *r);
