/* Lattices of nodes, finer about the tips. */
#include "meshless/galerkin/nodes.h"
#include "base/memory.h"
#include "meshless/galerkin/cut.h"

#include <math.h>

/* Half the width of a level's patch, m. */
static double reach_of(const struct galerkin_input *in, int level) {
    return in->patch * ldexp(in->spacing, 1 - level) * (1 + 1e-9);
}

static int is_near(const double x[2], const double tip[2], const double *along, double reach) {
    const double dx = x[0] - tip[0], dy = x[1] - tip[1];
    if (!along) return fabs(dx) < reach && fabs(dy) < reach;
    return fabs(dx * along[0] + dy * along[1]) < reach && fabs(dy * along[0] - dx * along[1]) < reach;
}

/* Whether x is within the patch of a level: level 0 is everywhere. */
static int is_in_patch(const struct galerkin_input *in, int level, const double x[2], int tips, const double (*tip)[2],
                       const double (*along)[2]) {
    if (level == 0) return 1;
    for (int t = 0; t < tips; t++)
        if (is_near(x, tip[t], along ? along[t] : NULL, reach_of(in, level))) return 1;
    return 0;
}

static void add_node(struct meshless_nodes *nodes, int *capacity, const double x[2], double size) {
    if (nodes->n == *capacity) {
        *capacity = 2 * *capacity + 256;
        nodes->x = memory_grown(MEMORY_SOLID, nodes->x, (size_t)nodes->n, (size_t)*capacity, sizeof *nodes->x);
        nodes->size = memory_grown(MEMORY_SOLID, nodes->size, (size_t)nodes->n, (size_t)*capacity, sizeof *nodes->size);
    }
    nodes->x[nodes->n][0] = x[0];
    nodes->x[nodes->n][1] = x[1];
    nodes->size[nodes->n++] = size;
}

/* A level about each tip in the tip's frame. Where two patches meet, the first tip has its nodes. The outermost nodes
 * have the supports of the level before, because its lattice may begin a whole spacing farther out. */
static void turned(struct meshless_nodes *nodes, int *capacity, const struct galerkin_input *in, int level, int tips,
                   const double (*tip)[2], const double (*along)[2]) {
    const double h = ldexp(in->spacing, -level);
    const int most = (int)ceil(2 * in->patch) + 1;
    for (int t = 0; t < tips; t++)
        for (int j = -most; j < most; j++)
            for (int i = -most; i <= most; i++) {
                const double xi = i * h, eta = (j + 0.5) * h;
                const double x[2] = {tip[t][0] + xi * along[t][0] - eta * along[t][1],
                                     tip[t][1] + xi * along[t][1] + eta * along[t][0]};
                if (!is_near(x, tip[t], along[t], reach_of(in, level)) || meshless_cut_depth(in, x) < -1e-9 * h)
                    continue;
                if (level < in->levels && is_in_patch(in, level + 1, x, tips, tip, along)) continue;
                if (is_in_patch(in, level, x, t, tip, along)) continue;
                const int outermost = !is_near(x, tip[t], along[t], reach_of(in, level) - h);
                add_node(nodes, capacity, x, outermost ? 2 * h : h);
            }
}

struct meshless_nodes meshless_nodes_new(const struct galerkin_input *in, const double offset[2], int tips,
                                         const double (*tip)[2], const double (*along)[2]) {
    struct meshless_nodes nodes = {0};
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    int capacity = 0;
    for (int k = 0; k < in->corners; k++)
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], in->corner[k][c]);
            high[c] = fmax(high[c], in->corner[k][c]);
        }
    for (int level = 0; level <= in->levels && (level == 0 || tips > 0); level++) {
        const double h = ldexp(in->spacing, -level);
        long first[2], last[2];
        if (level > 0 && along) {
            turned(&nodes, &capacity, in, level, tips, tip, along);
            continue;
        }
        for (int c = 0; c < 2; c++) {
            double from = low[c], to = high[c];
            if (level > 0) {
                from = INFINITY, to = -INFINITY;
                for (int t = 0; t < tips; t++) {
                    from = fmin(from, tip[t][c] - (2 * in->patch + 1) * h);
                    to = fmax(to, tip[t][c] + (2 * in->patch + 1) * h);
                }
            }
            first[c] = lround(floor(from / h - 0.5 - offset[c])) - 1;
            last[c] = lround(ceil(to / h - 0.5 - offset[c])) + 1;
        }
        for (long j = first[1]; j <= last[1]; j++)
            for (long i = first[0]; i <= last[0]; i++) {
                const double x[2] = {((double)i + 0.5 + offset[0]) * h, ((double)j + 0.5 + offset[1]) * h};
                if (meshless_cut_depth(in, x) < -1e-9 * h) continue;
                if (!is_in_patch(in, level, x, tips, tip, along)) continue;
                if (level < in->levels && tips > 0 && is_in_patch(in, level + 1, x, tips, tip, along)) continue;
                add_node(&nodes, &capacity, x, h);
            }
    }
    return nodes;
}
