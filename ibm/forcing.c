/* Multidirect forcing.  (001: sec. 3.5.2; Breugem 2012)
 *
 * An iteration reads all markers' velocities, then spreads all their increments. Blocks of markers in slabs that are
 * not neighbours do not overlap. So two iterations can run in one pass over the slabs, the second two slabs behind the
 * first, on planes that are still in the cache:
 *
 *     slab           s-3        s-2        s-1         s
 *                    write 2    read 2     write 1     read 1
 *
 * Sums over the cells of several ranks are completed before the first write and after the last read. */
#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "ibm/feedback.h"
#include "ibm/state.h"

struct sweep {
    struct ibm *b;
    double *const *u;
    struct ibm_tally *tally;
};

static void read_slab(const struct sweep *w, int slab, enum ibm_keep keep) {
    struct ibm *ibm = w->b;
    const int first = ibm_slab_first(ibm, IBM_NEAR, slab), last = ibm_slab_first(ibm, IBM_NEAR, slab + 1);
    ibm_sweep_gather(ibm, w->u, ibm_slab_first(ibm, IBM_INNER, slab), ibm_slab_first(ibm, IBM_INNER, slab + 1), keep,
                     w->tally);
    ibm_edge_sum(ibm, w->u, ibm_slab_first(ibm, IBM_NEAR_PIECES, slab), ibm_slab_first(ibm, IBM_NEAR_PIECES, slab + 1));
    ibm_edge_finish(ibm, first, last, keep, w->tally);
}

static void write_slab(const struct sweep *w, int slab) {
    const struct ibm *ibm = w->b;
    ibm_sweep_scatter(ibm, w->u, ibm_slab_first(ibm, IBM_INNER, slab), ibm_slab_first(ibm, IBM_INNER, slab + 1));
    ibm_edge_scatter(ibm, w->u, ibm_slab_first(ibm, IBM_NEAR_PIECES, slab),
                     ibm_slab_first(ibm, IBM_NEAR_PIECES, slab + 1));
}

static void read_far(const struct sweep *w, int first_slab, int last_slab) {
    ibm_edge_sum(w->b, w->u, ibm_slab_first(w->b, IBM_FAR_PIECES, first_slab),
                 ibm_slab_first(w->b, IBM_FAR_PIECES, last_slab));
}

static void write_far(const struct sweep *w, int first_slab, int last_slab) {
    ibm_edge_scatter(w->b, w->u, ibm_slab_first(w->b, IBM_FAR_PIECES, first_slab),
                     ibm_slab_first(w->b, IBM_FAR_PIECES, last_slab));
}

static void finish_far(const struct sweep *w, enum ibm_keep keep) {
    ibm_share_sums(w->b);
    ibm_edge_finish(w->b, w->b->near_edges, w->b->edges, keep, w->tally);
}

/* One iteration, or two in one pass. */
static void iterate(const struct sweep *w, enum ibm_keep keep, int two) {
    const int slabs = w->b->slabs;
    read_far(w, 0, slabs);
    finish_far(w, keep);
    for (int s = 0; s < slabs + (two ? 3 : 1); s++) {
        if (s < slabs) read_slab(w, s, keep);
        if (s >= 1 && s - 1 < slabs) {
            write_slab(w, s - 1);
            write_far(w, s - 1, s);
        }
        if (two && s >= 2 && s - 2 < slabs) {
            read_slab(w, s - 2, IBM_ADD);
            read_far(w, s - 2, s - 1);
        }
        if (two && s >= 3) write_slab(w, s - 3);
    }
    if (!two) return;
    finish_far(w, IBM_ADD);
    write_far(w, 0, slabs);
}

void ibm_forcing_stage(struct ibm *ibm, int r, double dt) {
    ibm_inside_stage(ibm, r, dt);
    if (ibm->slip_time > 0) {
        ibm_feedback_begin(ibm, r, dt);
        ibm_feedback_end(ibm, r, dt);
        return;
    }
    clock_begin(CLOCK_FORCING);
    const struct fluid_grid *g = ibm->grid;
    struct ibm_tally tally = {.squares = 0};
    const struct sweep w = {ibm, fluid_predicted(ibm->fluid), &tally};
    for (int s = 0; s < ibm->iterations; s += 2)
        iterate(&w, r == 0 && s == 0 ? IBM_SET : IBM_ADD, s + 1 < ibm->iterations);
    /* gamma_r rho Q V = gamma_r rho sum (V - U) V / (gamma_r dt) */
    const double scale = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2] / dt;
    for (int c = 0; c < 3; c++) ibm->given[c] = (r == 0 ? 0 : ibm->given[c]) + tally.given[c] * scale;
    clock_end(CLOCK_FORCING);
}

void ibm_forcing_by_marker(struct ibm *ibm, double dt, double *const force[3]) {
    const struct fluid_grid *g = ibm->grid;
    const double scale = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2] / dt;
    ibm_buffer_reserve(&ibm->by_marker, &ibm->by_marker_size, 3 * (size_t)(ibm->served + ibm->route.n) + 1);
    double(*served)[3] = (double(*)[3])ibm->by_marker, (*mine)[3] = served + ibm->served;
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++) served[ibm->arrival[h]][c] = ibm->received[h][c] * scale;
    for (int i = 0; i < ibm->route.n; i++)
        for (int c = 0; c < 3; c++) mine[i][c] = 0;
    par_exchange_backward(ibm->route.plan, served, mine, sizeof *mine);
    for (int i = 0; i < ibm->route.n; i++)
        for (int c = 0; c < 3; c++) force[c][i] = mine[i][c];
}

void ibm_forcing_total(struct ibm *ibm, double force[3]) {
    for (int c = 0; c < 3; c++) force[c] = ibm->given[c] + ibm->inside.taken[c];
    par_sum_array(force, 3);
}

double ibm_forcing_slip(struct ibm *ibm) {
    struct ibm_tally tally = {.squares = 0};
    const struct sweep w = {ibm, fluid_predicted(ibm->fluid), &tally};
    read_far(&w, 0, ibm->slabs);
    finish_far(&w, IBM_LOOK);
    for (int s = 0; s < ibm->slabs; s++) read_slab(&w, s, IBM_LOOK);
    double sum[2] = {tally.squares, ibm->inner};
    for (int e = 0; e < ibm->edges; e++) sum[1] += ibm->edge[e].mine;
    par_sum_array(sum, 2);
    return sum[1] > 0 ? sqrt(sum[0] / sum[1]) : 0;
}
