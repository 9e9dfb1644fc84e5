/* Measures the machine's limits: memory bandwidth and floating-point rate. */
#include "program/bench/limits.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/vec.h"
#include "program/bench/parts.h"

struct triad {
    long n;
    double *a, *b, *c;
    int idle; /* 1: this rank waits */
};

/* a = b + s c: two loads and a store, 24 B, and 2 flops an element. The store goes past the caches if the machine can
 * do that, so that no line is read before it is written. n is a multiple of a vector's lanes. */
static void triad(void *with) {
    const struct triad *t = with;
    if (t->idle) return;
    for (long i = 0; i < t->n; i += VEC_LANES)
        vec_stream(t->a + i, vec_load(t->b + i) + vec_set(3) * vec_load(t->c + i));
    t->b[0] = t->a[t->n / 2] * 1e-300; /* a use of the result, so that the compiler cannot remove a call */
}

enum { CHAINS = 10, ROUNDS = 20000 };

struct chains {
    double sum;
};

/* Independent chains of a vec each: enough to hide the latency of a multiply-add in two units, few enough for sixteen
 * registers. */
static void multiply_add(void *with) {
    struct chains *result = with;
    const vec factor = vec_set(0.999), term = vec_set(1e-3);
    vec x[CHAINS];
    for (int k = 0; k < CHAINS; k++) x[k] = vec_set(result->sum + k);
    for (int i = 0; i < ROUNDS; i++)
        for (int k = 0; k < CHAINS; k++) x[k] = x[k] * factor + term;
    for (int k = 0; k < CHAINS; k++) result->sum += 1e-9 * vec_sum(x[k]);
}

struct bench_limits bench_limits_measure(const struct bench_repetition *repetition, long length) {
    struct bench_limits l = {.triad_length = (double)length};
    struct triad t = {.n = length};
    struct chains chains = {0};
    double **array[3] = {&t.a, &t.b, &t.c};
    for (int k = 0; k < 3; k++) {
        *array[k] = memory_new(MEMORY_OUTPUT, (size_t)length, sizeof(double));
        for (long i = 0; i < length; i++) (*array[k])[i] = 1;
    }
    t.idle = par_rank() != 0;
    l.triad_alone = bench_measure_one(repetition, triad, &t);
    t.idle = 0;
    l.triad = bench_measure_one(repetition, triad, &t);
    for (int k = 0; k < 3; k++) memory_free(*array[k]);
    l.fma = bench_measure_one(repetition, multiply_add, &chains);
    l.fma_length = 2.0 * CHAINS * ROUNDS * VEC_LANES;
    const double bytes = 24 * l.triad_length;
    l.alone = bytes / l.triad_alone.low; /* the highest rate: it is a limit */
    l.together = par_size() * bytes / l.triad.low;
    l.peak = par_size() * l.fma_length / l.fma.low;
    return l;
}

void bench_limits(struct bench *bench) {
    const struct bench_limits *l = &bench->table.limits;
    const struct bench_row row[3] = {{.part = "triad_one_rank",
                                      .time = l->triad_alone,
                                      .units = l->triad_length,
                                      .unit = "element",
                                      .bytes = 24,
                                      .flops = 2},
                                     {.part = "triad",
                                      .time = l->triad,
                                      .units = par_size() * l->triad_length,
                                      .unit = "element",
                                      .bytes = 24,
                                      .flops = 2},
                                     {.part = "multiply_add",
                                      .time = l->fma,
                                      .units = par_size() * l->fma_length / 2,
                                      .unit = "multiply-add",
                                      .flops = 2}};
    for (int k = 0; k < 3; k++) {
        struct bench_row r = row[k];
        snprintf(r.size, sizeof r.size, "%.0f", r.units);
        bench_row_write(&bench->table, &r);
    }
}
