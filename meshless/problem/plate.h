/* Translates the scene of an element-free plate into the input of meshless/galerkin. */
#pragma once
#include "meshless/galerkin/galerkin.h"
#include "scene/scene.h"

/* The input with the arrays it points to; owned. */
struct meshless_plate {
    struct galerkin_input in;
    double (*corner)[2], (*node)[2], *size;
    struct galerkin_crack *crack;
    double (**bend)[2];         /* [cracks] the points of each crack between its ends */
    struct galerkin_hole *hole; /* [holes] */
    double (**edge)[2];         /* [holes] the corners of each hole */
    struct galerkin_fixed *fix;
    struct galerkin_pull *pull;
};

/* Dies (exit 2) where a constraint or load reaches no part of the outline. Collective. */
void meshless_plate_begin(const struct scene *scene, struct meshless_plate *to);
/* An end of a crack moves to x by a straight part; nodes of a lattice are placed again. Collective. */
void meshless_plate_grow(const struct scene *scene, struct meshless_plate *to, int crack, int end, const double x[2]);
void meshless_plate_end(struct meshless_plate *to);
