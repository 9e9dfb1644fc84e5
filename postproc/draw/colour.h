/* Colours: sRGB and linear light, and perceptually uniform maps. */
#pragma once

enum postproc_map {
    POSTPROC_MAGMA_REVERSED, /* 0 near-white, 1 black: intact parts stay light, so that their shading is visible */
    POSTPROC_VIRIDIS,
    POSTPROC_DIVERGING /* 0 blue, 1/2 near-white, 1 red: for values of both signs, 0 in the middle */
};

/* sRGB, each 0 ... 1, of the map at t; t is clamped to [0, 1], NaN is grey. */
void postproc_colour_map(enum postproc_map map, double t, double srgb[3]);
/* IEC 61966-2-1 transfer function, both ways; of one channel, 0 ... 1. */
double postproc_colour_linear(double srgb);
double postproc_colour_srgb(double linear);
