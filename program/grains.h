/* The image of frana init rock: overlapping grains, made on the spot. */
#pragma once
#include <stdio.h>

/* Writes 32 x 32 x 32 bytes, x first, then y, then z: 1 grain, 0 pore. Grains go on across the sides. */
void grains_write(FILE *to);
