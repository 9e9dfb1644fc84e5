/* How much of the fluid on a straight line through the domain is deep in bodies. */
#pragma once
#include "coupling/run.h"

/* Of the particles at the start: the part of the line through each, of a direction in which fluid may move on as it is,
 * that is deep in bodies; the largest over these directions. Such a direction is periodic, or pressure is given at both
 * of its sides. A line that is deep all along does not count: no marker sees a motion along it.
 * is_deep [n] by particle; part [n], 0: no line. Collective. */
void inner_lines_measure(const struct run *r, const uint8_t *is_deep, float *part);
