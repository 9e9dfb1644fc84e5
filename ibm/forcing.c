/* Multidirect forcing.  (001: sec. 3.5.2; Breugem 2012)
 *
 * An iteration reads all markers' velocities, then spreads all their increments. Blocks of markers in slabs that are
 * not neighbours do not overlap, so a cell gets increments from two slabs at most. Even slabs are written before odd
 * ones: the sums then do not depend on how the slabs are shared. One thread takes two iterations in one pass over pairs
 * of slabs, the second a pair behind the first, on planes that are still in the cache:
 *
 *     slabs          s-3   s-2   s-1    s    s+1
 *     read 1                            1     2
 *     write 1                      4    3
 *     read 2               5     6
 *     write 2         8    7
 *
 * Several threads share the slabs and take one iteration after the other: they read all slabs, write the even ones, and
 * then the odd ones. Sums over the cells of several ranks are completed before the first write and after the last
 * read, by one thread. */
#include "base/clock.h"
#include "base/par.h"
#include "base/threads.h"
#include "ibm/feedback.h"
#include "ibm/state.h"

#include <string.h>

struct sweep {
    struct ibm *b;
    double *const *u;
    enum ibm_record record; /* of the first iteration */
    int second;             /* 1: the second of two iterations is shared */
};

static int is_slab(const struct sweep *w, int slab) { return slab >= 0 && slab < w->b->slabs; }

static void read_slab(const struct sweep *w, int slab, enum ibm_record record) {
    struct ibm *ibm = w->b;
    if (!is_slab(w, slab)) return;
    const int first = ibm_slab_first(ibm, IBM_NEAR, slab), last = ibm_slab_first(ibm, IBM_NEAR, slab + 1);
    ibm_sweep_gather(ibm, w->u, ibm_slab_first(ibm, IBM_INNER, slab), ibm_slab_first(ibm, IBM_INNER, slab + 1), record,
                     &ibm->tally[slab]);
    ibm_edge_sum(ibm, w->u, ibm_slab_first(ibm, IBM_NEAR_PIECES, slab), ibm_slab_first(ibm, IBM_NEAR_PIECES, slab + 1));
    ibm_edge_finish(ibm, first, last, record, &ibm->tally[slab]);
}

static void write_slab(const struct sweep *w, int slab) {
    const struct ibm *ibm = w->b;
    if (!is_slab(w, slab)) return;
    ibm_sweep_scatter(ibm, w->u, ibm_slab_first(ibm, IBM_INNER, slab), ibm_slab_first(ibm, IBM_INNER, slab + 1));
    ibm_edge_scatter(ibm, w->u, ibm_slab_first(ibm, IBM_NEAR_PIECES, slab),
                     ibm_slab_first(ibm, IBM_NEAR_PIECES, slab + 1));
}

static void read_far(const struct sweep *w, int slab) {
    if (is_slab(w, slab))
        ibm_edge_sum(w->b, w->u, ibm_slab_first(w->b, IBM_FAR_PIECES, slab),
                     ibm_slab_first(w->b, IBM_FAR_PIECES, slab + 1));
}

static void write_far(const struct sweep *w, int slab) {
    if (is_slab(w, slab))
        ibm_edge_scatter(w->b, w->u, ibm_slab_first(w->b, IBM_FAR_PIECES, slab),
                         ibm_slab_first(w->b, IBM_FAR_PIECES, slab + 1));
}

static void finish_far(const struct sweep *w, enum ibm_record record) {
    struct ibm *ibm = w->b;
    ibm_share_sums(ibm);
    ibm_edge_finish(ibm, ibm->near_edges, ibm->edges, record, &ibm->tally[ibm->slabs]);
}

static void read_all_far(const struct sweep *w, enum ibm_record record) {
    for (int s = 0; s < w->b->slabs; s++) read_far(w, s);
    finish_far(w, record);
}

/* One iteration, or two in one pass, on one thread. */
static void iterate(const struct sweep *w, int two) {
    const int slabs = w->b->slabs;
    read_all_far(w, w->record);
    for (int s = 0; s < slabs + (two ? 4 : 2); s += 2) {
        for (int k = s; k <= s + 1; k++) read_slab(w, k, w->record);
        for (int k = s; k >= s - 1; k--) {
            write_slab(w, k);
            write_far(w, k);
        }
        for (int k = s - 2; two && k <= s - 1; k++) {
            read_slab(w, k, IBM_ACCUMULATE);
            read_far(w, k);
        }
        for (int k = s - 2; two && k >= s - 3; k--) write_slab(w, k);
    }
    if (!two) return;
    finish_far(w, IBM_ACCUMULATE);
    for (int odd = 0; odd < 2; odd++)
        for (int s = odd; s < slabs; s += 2) write_far(w, s);
}

/* A thread's part of an iteration, by the number of markers. Far edges are written with their slab, after the
 * second of two iterations behind all slabs, as above. */
static void iterate_part(int thread, void *data) {
    const struct sweep *w = data;
    int from, to;
    ibm_slabs_share(w->b, thread, &from, &to);
    for (int s = from; s < to; s++) read_slab(w, s, w->second ? IBM_ACCUMULATE : w->record);
    for (int odd = 0; odd < 2; odd++) {
        threads_wait();
        for (int s = from + ((from ^ odd) & 1); s < to; s += 2) {
            write_slab(w, s);
            if (!w->second) write_far(w, s);
        }
    }
    for (int odd = 0; w->second && odd < 2; odd++) {
        threads_wait();
        for (int s = from + ((from ^ odd) & 1); s < to; s += 2) write_far(w, s);
    }
}

static void iterate_shared(struct sweep *w, int two) {
    for (w->second = 0; w->second <= two; w->second++) {
        read_all_far(w, w->second ? IBM_ACCUMULATE : w->record);
        threads_run(iterate_part, w);
    }
}

static void tally_clear(struct ibm *ibm) { memset(ibm->tally, 0, ((size_t)ibm->slabs + 1) * sizeof *ibm->tally); }

/* Of all slabs and of far edges, in an order that does not depend on the threads. */
static struct ibm_tally tally_sum(const struct ibm *ibm) {
    struct ibm_tally sum = {.squares = 0};
    for (int s = 0; s <= ibm->slabs; s++) {
        for (int c = 0; c < 3; c++) sum.impulse[c] += ibm->tally[s].impulse[c];
        sum.squares += ibm->tally[s].squares;
    }
    return sum;
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
    struct sweep w = {.b = ibm, .u = fluid_predicted(ibm->fluid)};
    tally_clear(ibm);
    for (int s = 0; s < ibm->iterations; s += 2) {
        w.record = r == 0 && s == 0 ? IBM_OVERWRITE : IBM_ACCUMULATE;
        if (threads_count() == 1)
            iterate(&w, s + 1 < ibm->iterations);
        else
            iterate_shared(&w, s + 1 < ibm->iterations);
    }
    const struct ibm_tally tally = tally_sum(ibm);
    /* gamma_r rho Q V = gamma_r rho sum (V - U) V / (gamma_r dt) */
    const double scale = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2] / dt;
    for (int c = 0; c < 3; c++) ibm->total_force[c] = (r == 0 ? 0 : ibm->total_force[c]) + tally.impulse[c] * scale;
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

void ibm_forcing_share(const struct ibm *ibm, double force[3]) {
    for (int c = 0; c < 3; c++) force[c] = ibm->total_force[c] + ibm->inside.taken[c];
}

void ibm_forcing_total(struct ibm *ibm, double force[3]) {
    ibm_forcing_share(ibm, force);
    par_sum_array(force, 3);
}

double ibm_forcing_work(const struct ibm *ibm) {
    const struct fluid_grid *g = ibm->grid;
    double sum = 0;
    for (int h = 0; h < ibm->inner; h++) {
        const double *v = ibm->route.served + (size_t)ibm->arrival[h] * IBM_ITEM + IBM_V;
        for (int c = 0; c < 3; c++) sum += ibm->received[h][c] * v[c];
    }
    for (int e = 0; e < ibm->edges; e++)
        for (int c = 0; ibm->edge[e].mine && c < 3; c++)
            sum += ibm->received[ibm->inner + e][c] * ibm->edge[e].share[c] * ibm->edge[e].v[c];
    return fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2] * sum;
}

double ibm_forcing_slip(struct ibm *ibm) {
    const struct sweep w = {.b = ibm, .u = fluid_predicted(ibm->fluid)};
    tally_clear(ibm);
    read_all_far(&w, IBM_EVALUATE);
    for (int s = 0; s < ibm->slabs; s++) read_slab(&w, s, IBM_EVALUATE);
    double sum[2] = {tally_sum(ibm).squares, ibm->inner};
    for (int e = 0; e < ibm->edges; e++) sum[1] += ibm->edge[e].mine;
    par_sum_array(sum, 2);
    return sum[1] > 0 ? sqrt(sum[0] / sum[1]) : 0;
}
