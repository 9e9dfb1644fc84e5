/* Four doubles of a row of the grid: one vector register. */
#pragma once
#include <string.h>

typedef double ibm_row __attribute__((vector_size(32)));

static inline ibm_row ibm_row_load(const double *p) {
    ibm_row r;
    memcpy(&r, p, sizeof r);
    return r;
}
static inline void ibm_row_store(double *p, ibm_row r) { memcpy(p, &r, sizeof r); }
static inline ibm_row ibm_row_set(double a) { return (ibm_row){a, a, a, a}; }
