/* Finds the ranks that share a marker, and completes the sums over their cells. */
#include "ibm/state.h"

#include <string.h>

int ibm_share_ranks(const struct ibm *ibm, const int cell[3], int rank[IBM_SHARERS]) {
    const struct ibm_touch *y = &ibm->touch[1][cell[1]], *z = &ibm->touch[2][cell[2]];
    const int parts = ibm->grid->ranks[1];
    int n = 0;
    for (int k = 0; k <= (z->low != z->high); k++)
        for (int j = 0; j <= (y->low != y->high); j++)
            rank[n++] = (k ? z->high : z->low) * parts + (j ? y->high : y->low);
    for (int i = 1; i < n; i++) /* in a periodic direction the first rank comes after the last; sorts them */
        for (int j = i; j > 0 && rank[j] < rank[j - 1]; j--) {
            const int r = rank[j];
            rank[j] = rank[j - 1];
            rank[j - 1] = r;
        }
    return n;
}

void ibm_share_sums(struct ibm *ibm) {
    if (ibm->swapped == 0) return;
    for (int k = 0; k < ibm->swapped; k++) memcpy(ibm->sent[k], ibm->sum[ibm->swap_edge[k]], sizeof *ibm->sent);
    par_swap(ibm->swap, &ibm->sent[0][0], &ibm->sum[ibm->edges][0], 3);
}
