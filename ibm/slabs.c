/* Shares the slabs between threads, and writes them in an order that does not depend on the threads. */
/* Blocks of markers in slabs that are not neighbours do not overlap, so a cell gets increments from two slabs at most.
 * Even slabs are written before odd ones. */
#include "base/threads.h"
#include "ibm/state.h"

/* Number of markers before a slab, far edges not counted. */
static int before(const struct ibm *ibm, int slab) {
    return ibm_slab_first(ibm, IBM_INNER, slab) + ibm_slab_first(ibm, IBM_NEAR, slab);
}

/* The first of a thread's slabs, by the number of markers. */
static int first_of(const struct ibm *ibm, int thread) {
    const long wanted = (long)before(ibm, ibm->slabs) * thread / threads_count();
    int slab = 0;
    while (slab < ibm->slabs && before(ibm, slab) < wanted) slab++;
    return slab;
}

void ibm_slabs_share(const struct ibm *ibm, int thread, int *from, int *to) {
    *from = thread == 0 ? 0 : first_of(ibm, thread);
    *to = thread + 1 == threads_count() ? ibm->slabs : first_of(ibm, thread + 1);
}

void ibm_slabs_write(const struct ibm *ibm, double *const u[3], int slab) {
    if (slab < 0 || slab >= ibm->slabs) return;
    ibm_sweep_scatter(ibm, u, ibm_slab_first(ibm, IBM_INNER, slab), ibm_slab_first(ibm, IBM_INNER, slab + 1));
    ibm_edge_scatter(ibm, u, ibm_slab_first(ibm, IBM_NEAR_PIECES, slab),
                     ibm_slab_first(ibm, IBM_NEAR_PIECES, slab + 1));
    ibm_edge_scatter(ibm, u, ibm_slab_first(ibm, IBM_FAR_PIECES, slab), ibm_slab_first(ibm, IBM_FAR_PIECES, slab + 1));
}

/* On one thread an odd slab is written as soon as its neighbours are. */
void ibm_slabs_write_part(const struct ibm *ibm, double *const u[3], int from, int to) {
    if (threads_count() == 1) {
        for (int s = 0; s <= ibm->slabs; s += 2)
            for (int k = s; k >= s - 1; k--) ibm_slabs_write(ibm, u, k);
        return;
    }
    for (int odd = 0; odd < 2; odd++) {
        threads_wait();
        for (int s = from + ((from ^ odd) & 1); s < to; s += 2) ibm_slabs_write(ibm, u, s);
    }
}

void ibm_slabs_read(struct ibm *ibm, double *const u[3], int slab, double (*velocity)[3]) {
    if (slab < 0 || slab >= ibm->slabs) return;
    ibm_sweep_read(ibm, u, ibm_slab_first(ibm, IBM_INNER, slab), ibm_slab_first(ibm, IBM_INNER, slab + 1), velocity);
    ibm_edge_sum(ibm, u, ibm_slab_first(ibm, IBM_NEAR_PIECES, slab), ibm_slab_first(ibm, IBM_NEAR_PIECES, slab + 1));
}

void ibm_slabs_finish(struct ibm *ibm, double *const u[3], int with_sides, double (*velocity)[3]) {
    ibm_edge_sum(ibm, u, ibm_slab_first(ibm, IBM_FAR_PIECES, 0), ibm->pieces);
    ibm_share_sums(ibm);
    ibm_edge_velocity(ibm, with_sides, ibm->inner > 0 ? velocity + ibm->inner : velocity); /* may be NULL */
}
