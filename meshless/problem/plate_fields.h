/* Fields of an element-free plate: its nodes, cells and Gauss points, and the lines of its cracks. */
#pragma once
#include "meshless/galerkin/galerkin.h"

/* Writes fields/solution.hdf, fields/cells.hdf, fields/gauss_points.hdf and crack_lines.csv. Collective. */
void meshless_plate_fields_write(const struct galerkin *g, const char *folder);
