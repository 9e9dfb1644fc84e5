/* Lattices of nodes, finer about the tips. */
#include "meshless/galerkin/nodes.h"
#include "base/memory.h"
#include "meshless/galerkin/cut.h"

#include <math.h>

/* Whether x is within the patch of a level: level 0 is everywhere. */
static int is_in_patch(const struct galerkin_input *in, int level, const double x[2], int tips,
                       const double (*tip)[2]) {
    const double reach = in->patch * ldexp(in->spacing, 1 - level) * (1 + 1e-9);
    if (level == 0) return 1;
    for (int t = 0; t < tips; t++)
        if (fabs(x[0] - tip[t][0]) < reach && fabs(x[1] - tip[t][1]) < reach) return 1;
    return 0;
}

struct meshless_nodes meshless_nodes_new(const struct galerkin_input *in, const double offset[2], int tips,
                                         const double (*tip)[2]) {
    struct meshless_nodes nodes = {0};
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    int room = 0;
    for (int k = 0; k < in->corners; k++)
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], in->corner[k][c]);
            high[c] = fmax(high[c], in->corner[k][c]);
        }
    for (int level = 0; level <= in->levels && (level == 0 || tips > 0); level++) {
        const double h = ldexp(in->spacing, -level);
        long first[2], last[2];
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
                if (!is_in_patch(in, level, x, tips, tip)) continue;
                if (level < in->levels && tips > 0 && is_in_patch(in, level + 1, x, tips, tip)) continue;
                if (nodes.n == room) {
                    room = 2 * room + 256;
                    nodes.x = memory_grown(MEMORY_SOLID, nodes.x, (size_t)nodes.n, (size_t)room, sizeof *nodes.x);
                    nodes.size =
                        memory_grown(MEMORY_SOLID, nodes.size, (size_t)nodes.n, (size_t)room, sizeof *nodes.size);
                }
                nodes.x[nodes.n][0] = x[0];
                nodes.x[nodes.n][1] = x[1];
                nodes.size[nodes.n++] = h;
            }
    }
    return nodes;
}

void meshless_nodes_free(struct meshless_nodes *nodes) {
    memory_free(nodes->x);
    memory_free(nodes->size);
}
