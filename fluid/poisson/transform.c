/* Real transforms of one direction by FFTW, for each pair of end conditions, and their eigenvalues. */
#include "fluid/poisson/transform.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "fluid/poisson/transform_pair.h"

#include <fftw3.h>
#include <math.h>
#include <stdlib.h>

struct fluid_transform {
    struct fluid_transform_pair *pair; /* used instead of FFTW's real transforms if possible */
    fftw_plan forward, backward;
};

static void kinds(enum fluid_end low, enum fluid_end high, fftw_r2r_kind *forward, fftw_r2r_kind *backward) {
    ENSURE((low == FLUID_END_PERIODIC) == (high == FLUID_END_PERIODIC), "one end is periodic");
    ENSURE((low == FLUID_END_FACE) == (high == FLUID_END_FACE), "one end is a face");
    switch (low) {
    case FLUID_END_PERIODIC:
        *forward = FFTW_R2HC;
        *backward = FFTW_HC2R;
        return;
    case FLUID_END_FACE:
        *forward = *backward = FFTW_RODFT00;
        return;
    case FLUID_END_NEUMANN:
        *forward = low == high ? FFTW_REDFT10 : FFTW_REDFT11;
        *backward = low == high ? FFTW_REDFT01 : FFTW_REDFT11;
        return;
    case FLUID_END_DIRICHLET:
        *forward = low == high ? FFTW_RODFT10 : FFTW_RODFT11;
        *backward = low == high ? FFTW_RODFT01 : FFTW_RODFT11;
        return;
    }
    ENSURE(0, "end %d", (int)low);
}

/* -(2/d)^2 sin^2(theta/2), theta = 2 pi k/n periodic (k and n-k for the two halves of R2HC), pi k/n, k = 0.. (NN)
 * or 1.. (DD, faces), pi (k + 1/2)/n (ND, DN). */
void fluid_transform_eigenvalues(int n, double d, enum fluid_end low, enum fluid_end high, double *lambda) {
    for (int i = 0; i < n; i++) {
        double half;
        if (low == FLUID_END_PERIODIC)
            half = M_PI * (i <= n / 2 ? i : n - i) / n;
        else if (low == high)
            half = 0.5 * M_PI * (low == FLUID_END_NEUMANN ? i : i + 1) / n;
        else
            half = 0.5 * M_PI * (i + 0.5) / n;
        const double s = 2 * sin(half) / d;
        lambda[i] = -s * s;
    }
}

double fluid_transform_scale(int n, enum fluid_end low, enum fluid_end high) {
    (void)high;
    return low == FLUID_END_PERIODIC ? n : 2.0 * n;
}

static fftw_plan plan(const struct fluid_transform_input *in, fftw_r2r_kind kind, double *from, double *to, int stride,
                      int distance) {
    const int n = in->low == FLUID_END_FACE ? in->n - 1 : in->n;
    return fftw_plan_many_r2r(1, &n, in->lines, from, NULL, in->stride, in->distance, to, NULL, stride, distance, &kind,
                              FFTW_MEASURE | FFTW_UNALIGNED | FFTW_PRESERVE_INPUT);
}

struct fluid_transform *fluid_transform_new(const struct fluid_transform_input *in) {
    struct fluid_transform *t = calloc(1, sizeof *t);
    fftw_r2r_kind forward, backward;
    t->pair = fluid_transform_pair_new(in);
    if (t->pair || (in->low == FLUID_END_FACE && in->n == 1)) return t; /* no inner face */
    kinds(in->low, in->high, &forward, &backward);
    const size_t last = (size_t)(in->n - 1), lines = (size_t)(in->lines - 1);
    const size_t count = last * (size_t)in->stride + lines * (size_t)in->distance + 1;
    const size_t out = last * (size_t)in->out_stride + lines * (size_t)in->out_distance + 1;
    double *scratch = memory_new(MEMORY_FLUID, count, sizeof *scratch);
    t->forward = plan(in, forward, scratch, scratch, in->stride, in->distance);
    if (in->out_stride) {
        double *other = memory_new(MEMORY_FLUID, out, sizeof *other);
        t->backward = plan(in, backward, scratch, other, in->out_stride, in->out_distance);
        memory_free(other);
    } else {
        t->backward = plan(in, backward, scratch, scratch, in->stride, in->distance);
    }
    memory_free(scratch);
    ENSURE(t->forward && t->backward, "FFTW has no plan for %d lines of %d", in->lines, in->n);
    return t;
}

void fluid_transform_free(struct fluid_transform *t) {
    if (!t) return;
    if (!t->pair) {
        fftw_destroy_plan(t->forward);
        fftw_destroy_plan(t->backward);
    }
    fluid_transform_pair_free(t->pair);
    free(t);
}

void fluid_transform_forward(const struct fluid_transform *t, double *in_place) {
    if (t->pair)
        fluid_transform_pair_forward(t->pair, in_place);
    else if (t->forward)
        fftw_execute_r2r(t->forward, in_place, in_place);
}

void fluid_transform_backward(const struct fluid_transform *t, const double *from, double *to) {
    if (t->pair)
        fluid_transform_pair_backward(t->pair, from, to);
    else if (t->backward)
        fftw_execute_r2r(t->backward, (double *)(size_t)from, to); /* the plan preserves its input */
}
