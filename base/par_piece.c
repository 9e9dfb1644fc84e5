/* Cuts a row of cells into pieces by weight. */
#include "base/par_piece.h"
#include "base/ensure.h"

#include <math.h>

/* Fills pieces up to `most`, each with `least` cells or more, and leaves `least` for each piece behind. Returns whether
 * none is heavier. */
static int fill(int n, const double *weight, int pieces, int least, double most, int *first) {
    int i = 0, fits = 1;
    for (int c = 0; c < pieces; c++) {
        const int end = n - least * (pieces - 1 - c);
        double sum = 0;
        first[c] = i;
        while (i < end && (i - first[c] < least || c == pieces - 1 || sum + weight[i] <= most)) sum += weight[i++];
        fits &= sum <= most;
    }
    first[pieces] = n;
    return fits;
}

void par_piece_cut(int n, const double *weight, int pieces, int least, int *first) {
    ENSURE(pieces >= 1 && (long)least * pieces <= n, "%d cells in %d pieces of %d", n, pieces, least);
    for (int c = 0; c <= pieces; c++) first[c] = par_piece_low(n, pieces, c);
    if (!weight) return;
    double low = 0, high = 0;
    for (int c = 0; c < pieces; c++) {
        double sum = 0;
        for (int i = first[c]; i < first[c + 1]; i++) sum += weight[i];
        high = fmax(high, sum);
        low += sum / pieces;
    }
    const double even = high;
    for (int k = 0; k < 60; k++) {
        const double most = 0.5 * (low + high);
        if (fill(n, weight, pieces, least, most, first))
            high = most;
        else
            low = most;
    }
    if (high < even && fill(n, weight, pieces, least, high, first)) return;
    for (int c = 0; c <= pieces; c++) first[c] = par_piece_low(n, pieces, c); /* equal numbers are as good */
}

int par_piece_of(const int *first, int pieces, int i) {
    int low = 0, high = pieces;
    while (high - low > 1) {
        const int mid = (low + high) / 2;
        if (first[mid] <= i)
            low = mid;
        else
            high = mid;
    }
    return low;
}
