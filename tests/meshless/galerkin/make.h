/* Element-free plates for the tests: nodes about tips, one rectangle, one crack. */
#pragma once
#include "base/memory.h"
#include "meshless/galerkin/field.h"
#include "meshless/galerkin/galerkin.h"
#include "meshless/galerkin/intensity.h"
#include "meshless/galerkin/mls.h"
#include "meshless/galerkin/nodes.h"
#include "meshless/galerkin/solve.h"
#include "tests/check.h"

/* Numbers in [0, 1), the same in every run. */
static inline double make_random(unsigned *state) {
    *state = *state * 1664525U + 1013904223U;
    return (double)(*state >> 8) / (double)(1U << 24);
}

static inline void make_nodes_free(struct meshless_nodes *nodes) {
    memory_free(nodes->x);
    memory_free(nodes->size);
}

static inline struct galerkin_input make_input(double width, double height, int across) {
    static double corner[4][2];
    corner[1][0] = corner[2][0] = width;
    corner[2][1] = corner[3][1] = height;
    return (struct galerkin_input){.youngs_modulus = 1000,
                                   .poisson_ratio = 0.3,
                                   .thickness = 1,
                                   .spacing = width / across,
                                   .corners = 4,
                                   .corner = (const double(*)[2])corner,
                                   .basis = GALERKIN_LINEAR,
                                   .support = 2.5,
                                   .tip_radius = 1e9,
                                   .cells = {across, (int)lround(across * height / width)},
                                   .patch = 2,
                                   .gauss = 4,
                                   .gauss_tip = 6,
                                   .interface_spacing = 1,
                                   .penalty = 100,
                                   .tolerance = 1e-12,
                                   .iterations = 2000};
}

/* Adds the nodes: columns on the sides, rows between them, as far from each other as the spacing. */
static inline struct meshless_nodes make_nodes(struct galerkin_input *in, int tips, const double (*tip)[2]) {
    struct meshless_nodes nodes = meshless_nodes_new(in, (const double[2]){0.5, 0}, tips, tip, NULL);
    in->nodes = nodes.n;
    in->node = (const double(*)[2])nodes.x;
    in->size = nodes.size;
    return nodes;
}

/* An edge crack of length a at half the height under tension 1. The returned plate borrows in's arrays. */
static inline struct galerkin *make_edge_crack(struct galerkin_input *in, double a, struct meshless_nodes *nodes) {
    static struct galerkin_crack crack;
    static struct galerkin_fixed fix[2];
    static struct galerkin_pull pull[2];
    const double width = in->corner[2][0], height = in->corner[2][1];
    const double tip[1][2] = {{a, height / 2}};
    crack = (struct galerkin_crack){.end = {{0, height / 2}, {a, height / 2}}};
    fix[0] = (struct galerkin_fixed){.direction = {1, 1}};
    fix[1] = (struct galerkin_fixed){.from = {width, 0}, .to = {width, 0}, .direction = {0, 1}};
    pull[0] = (struct galerkin_pull){.to = {width, 0}, .traction = {0, -1}};
    pull[1] = (struct galerkin_pull){.from = {0, height}, .to = {width, height}, .traction = {0, 1}};
    in->cracks = 1;
    in->crack = &crack;
    in->fixed = 2;
    in->fix = fix;
    in->pulls = 2;
    in->pull = pull;
    *nodes = make_nodes(in, 1, tip);
    struct galerkin *g = meshless_galerkin_new(in);
    meshless_galerkin_solve(g);
    return g;
}
