/* The porous block of the main case in its channel, put into words here so that the program needs no file.
 * (cases/porous_channel) */
#pragma once
#include "scene/scene.h"

struct bench_scene {
    int half;     /* 1: half the size in each direction, on 64 x 32 x 32 cells */
    int breakage; /* 1: bonds may break, but are too strong to; contact is then looked for as well */
    int rk3;      /* 1: the solid by RK3, else velocity Verlet */
};

/* Two stages: a rigid block until the flow's start is over, then an elastic one. Collective. */
struct scene *bench_scene_new(const struct bench_scene *b);
