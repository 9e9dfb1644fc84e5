/* Colours: sRGB and linear light, and perceptually uniform maps. */
#pragma once

enum postproc_map {
    POSTPROC_MAGMA_REVERSED, /* 0 porcelain, 1 black: what is intact stays light, so that its shading can be read */
    POSTPROC_VIRIDIS
};

/* sRGB, each 0 ... 1, of the map at t; t is clamped to [0, 1], NaN is grey. */
void postproc_colour_map(enum postproc_map map, double t, double srgb[3]);
/* IEC 61966-2-1 transfer function, both ways; of one channel, 0 ... 1. */
double postproc_colour_linear(double srgb);
double postproc_colour_srgb(double linear);
