/* The porous block of the main case in its channel, as a text in the program, so that no file is needed.
 * (cases/porous_channel) */
#pragma once
#include "scene/scene.h"

struct bench_scene {
    int half;     /* 1: half the size in each direction, on 64 x 32 x 32 cells */
    int breakage; /* 1: bonds may break, but are too strong to break; contact is then searched for as well */
    int reaction; /* 1: the load is the forcing's reaction, else the probes' */
    int rk3;      /* 1: the solid by RK3, else velocity Verlet */
    int ab2;      /* 1: the fluid beside the elastic block by Adams and Bashforth's scheme, else RK3 */
};

/* Two stages: a rigid block during the start of the flow, then an elastic one. Collective. */
struct scene *bench_scene_new(const struct bench_scene *b);
