/* Transforms of pairs of real lines: complex Fourier transforms by factors (Stockham's order: no permutation at the
 * end), whose first pass reads real lines or coefficients and whose last pass writes them (Makhoul's fold). */
#include "fluid/poisson/fourier.h"
#include "base/memory.h"
#include "fluid/poisson/fourier_factor.h"

#include <math.h>
#include <stdlib.h>

enum {
    FACTORS = 32,
    LARGEST = FOURIER_LARGEST, /* prime factor: it takes as many operations a value */
    ROW = FLUID_FOURIER_ROW,
    PAIRS = FLUID_FOURIER_PAIRS
};

/* The factors of a direction in the order of their passes. */
struct order {
    int factors, factor[FACTORS];
    double *root[FACTORS]; /* of each pass, in its order: [n/(done p)][p - 1][2] */
};

struct fluid_fourier {
    int n;
    /* In both orders the pass on the side of the coefficients has a factor 1, 2, 4 or 8: 1 if and only if n is odd. */
    struct order forward, backward;
    double *cosine, *sine; /* [n] of 2 pi j/n */
    int *place;            /* [n] where value j of the complex line is among the real lines' values */
    double *sign;          /* [n] and its sign */
    int is_from_end;       /* coefficients count from their end (Dirichlet) */
    double *c, *s;         /* [n/2 + 1] cos and sin of pi k/2n (periodic: 1/2, 0); backward times `back` */
    double mirror;         /* 1, or -1 for periodic lines: sign of the cosine for coefficient n-k */
    double back, first, middle, back_middle; /* first, middle: factors of coefficients 0 and n/2 */
};

/* The last factor is 1, 2, 4 or 8, the first one any other; a first factor of 1 only reads. With 16 as a factor there
 * is one pass less; that is faster where the pass multiplies by no roots of unity, which is the last one backward. */
static int factorize(int n, int sixteen, int *factor) {
    int count = 0, twos = 0;
    const int odd = n % 2;
    for (; n % 2 == 0; n /= 2) twos++;
    for (int p = 3; n > 1; p += 2)
        for (; n % p == 0; n /= p) {
            if (p > LARGEST) return 0;
            factor[count++] = p;
        }
    if (sixteen && twos % 3 == 1 && twos > 6) {
        factor[count++] = 16;
        twos -= 4;
    }
    if (count == 0 && twos < 4) factor[count++] = 1;
    if (twos == 1) factor[count++] = 2;
    for (; twos % 3 && twos > 1; twos -= 2) factor[count++] = 4;
    for (; twos > 2; twos -= 3) factor[count++] = 8;
    if (odd) factor[count++] = 1;
    return count;
}

static double *new_roots(const struct fluid_fourier *f, int p, int done) {
    const int rest = f->n / (done * p);
    double *root = memory_new(MEMORY_FLUID, 2 * (size_t)(rest * (p - 1)) + 1, sizeof(double));
    for (int j = 0; j < rest; j++)
        for (int r = 1; r < p; r++) {
            root[2 * (j * (p - 1) + r - 1)] = f->cosine[j * r * done];
            root[2 * (j * (p - 1) + r - 1) + 1] = f->sine[j * r * done];
        }
    return root;
}

static void fill_order(const struct fluid_fourier *f, int is_backward, struct order *o) {
    int factor[FACTORS];
    o->factors = factorize(f->n, is_backward, factor);
    for (int i = 0, done = 1; i < o->factors; done *= o->factor[i++]) {
        o->factor[i] = factor[is_backward ? o->factors - 1 - i : i];
        o->root[i] = new_roots(f, o->factor[i], done);
    }
}

/* Even places forwards, then odd ones backwards. */
static int folded(int n, int j) { return 2 * j < n ? 2 * j : 2 * (n - 1 - j) + 1; }

static void fill_tables(struct fluid_fourier *f, enum fluid_end ends) {
    const int n = f->n, periodic = ends == FLUID_END_PERIODIC, dirichlet = ends == FLUID_END_DIRICHLET;
    for (int j = 0; j < n; j++) {
        f->cosine[j] = cos(2 * M_PI * j / n);
        f->sine[j] = sin(2 * M_PI * j / n);
        f->place[j] = periodic ? j : folded(n, j);
        f->sign[j] = dirichlet && f->place[j] % 2 ? -1 : 1;
    }
    for (int k = 0; k <= n / 2; k++) {
        f->c[k] = periodic ? 0.5 : cos(0.5 * M_PI * k / n);
        f->s[k] = periodic ? 0 : sin(0.5 * M_PI * k / n);
    }
    f->is_from_end = dirichlet;
    f->mirror = periodic ? -1 : 1;
    f->back = periodic ? 2 : 1;
    f->first = periodic ? 1 : 2;
    f->middle = f->back_middle = periodic ? 1 : sqrt(2);
}

struct fluid_fourier *fluid_fourier_new(int n, enum fluid_end ends) {
    int factor[FACTORS];
    if (n < 2 || factorize(n, 0, factor) == 0) return NULL;
    struct fluid_fourier *f = calloc(1, sizeof *f);
    f->n = n;
    f->cosine = memory_new(MEMORY_FLUID, 4 * (size_t)n + 2, sizeof(double));
    f->sine = f->cosine + n;
    f->sign = f->sine + n;
    f->c = f->sign + n;
    f->s = f->c + n / 2 + 1;
    f->place = calloc((size_t)n, sizeof *f->place);
    fill_tables(f, ends);
    fill_order(f, 0, &f->forward);
    fill_order(f, 1, &f->backward);
    return f;
}

void fluid_fourier_free(struct fluid_fourier *f) {
    if (!f) return;
    for (int i = 0; i < f->forward.factors; i++) memory_free(f->forward.root[i]);
    for (int i = 0; i < f->backward.factors; i++) memory_free(f->backward.root[i]);
    memory_free(f->cosine);
    free(f->place);
    free(f);
}

INLINE void dft(const struct fluid_fourier *f, int p, struct complex_lanes *a) {
    dft_factor(p, f->n, f->cosine, f->sine, a);
}

/* Values 1 .. p-1 turned by the roots of a pass. */
INLINE void turn(int p, const double *root, struct complex_lanes *a) {
#pragma GCC unroll 16
    for (int r = 1; r < p; r++) a[r] = turned(a[r], root[2 * r - 2], root[2 * r - 1]);
}

/* A pass: `done` is the product of the factors before p, rest = n/(done p). The values
 *     x[q + done (j + rest r)] , r = 0 .. p-1 ,
 * are transformed, turned by the angles 2 pi j r/(n/done), and written to y[q + done (p j + r)]. */
INLINE void pass(const struct fluid_fourier *f, int p, int done, const double *restrict root, const double *restrict x,
                 double *restrict y) {
    const int rest = f->n / (done * p);
    const ptrdiff_t among = (ptrdiff_t)rest * done * ROW, stride = (ptrdiff_t)done * ROW;
    for (int j = 0; j < rest; j++, root += 2 * (p - 1), y += (p - 1) * stride)
        for (const double *end = x + stride; x < end; x += ROW, y += ROW)
            for (int l = 0; l < PAIRS; l += VEC_LANES) {
                struct complex_lanes a[LARGEST];
#pragma GCC unroll 16
                for (int r = 0; r < p; r++) a[r] = load_row(x + r * among + l);
                dft(f, p, a);
                turn(p, root, a);
#pragma GCC unroll 16
                for (int r = 0; r < p; r++) store_row(y + r * stride + l, a[r]);
            }
}

/* The first pass forward, done = 1: reads the values of real lines. */
INLINE void first_of_values(const struct fluid_fourier *f, int p, const double *restrict root,
                            struct fluid_fourier_rows x, double *restrict y) {
    const int rest = f->n / p;
    for (int j = 0; j < rest; j++, root += 2 * (p - 1), y += p * ROW)
        for (int l = 0; l < PAIRS; l += VEC_LANES) {
            struct complex_lanes a[LARGEST];
#pragma GCC unroll 16
            for (int r = 0; r < p; r++)
                a[r] = times(f->sign[j + rest * r], load_row(x.at + f->place[j + rest * r] * x.stride + l));
            dft(f, p, a);
            turn(p, root, a);
#pragma GCC unroll 16
            for (int r = 0; r < p; r++) store_row(y + r * ROW + l, a[r]);
        }
}

/* The last pass backward, rest = 1: writes the values of real lines. The inverse transform is the forward one of
 * conjugate values. */
INLINE void last_of_values(const struct fluid_fourier *f, int p, const double *x, struct fluid_fourier_rows y) {
    const int done = f->n / p;
    for (int q = 0; q < done; q++)
        for (int l = 0; l < PAIRS; l += VEC_LANES) {
            struct complex_lanes a[LARGEST];
#pragma GCC unroll 16
            for (int r = 0; r < p; r++) a[r] = load_row(x + (q + done * r) * ROW + l);
            dft(f, p, a);
#pragma GCC unroll 16
            for (int r = 0; r < p; r++)
                store_row(y.at + f->place[q + done * r] * y.stride + l, times(f->sign[q + done * r], conjugate(a[r])));
        }
}

/* Coefficient k of the lines. */
INLINE double *row_of(const struct fluid_fourier *f, struct fluid_fourier_rows rows, int k) {
    return rows.at + (f->is_from_end ? f->n - 1 - k : k) * rows.stride;
}

/* Writes coefficients k and n-k. */
INLINE void put_pair(const struct fluid_fourier *f, int k, struct complex_lanes here, struct complex_lanes there,
                     struct fluid_fourier_rows to, int l) {
    const double c = f->c[k], s = f->s[k], cm = f->mirror * c;
    const struct complex_lanes sum = plus(here, there), turn = minus_i_times(minus(here, there));
    store_row(row_of(f, to, k) + l, plus(times(c, sum), times(s, turn)));
    store_row(row_of(f, to, f->n - k) + l, minus(times(s, sum), times(cm, turn)));
}

/* Reads coefficients k and n-k; here and there: the conjugates of Z_k and Z_{n-k}. */
INLINE void take_pair(const struct fluid_fourier *f, int k, struct fluid_fourier_rows from, int l,
                      struct complex_lanes *here, struct complex_lanes *there) {
    const double c = f->back * f->c[k], s = f->back * f->s[k], cm = f->mirror * c;
    const struct complex_lanes low = load_row(row_of(f, from, k) + l), high = load_row(row_of(f, from, f->n - k) + l);
    const struct complex_lanes r = plus(times(c, low), times(s, high)), i = minus(times(s, low), times(cm, high));
    *here = (struct complex_lanes){r.re - i.im, -(i.re + r.im)};
    *there = (struct complex_lanes){r.re + i.im, i.re - r.im};
}

/* The last pass forward, rest = 1: it gives the values q + done r, and their partners in the coefficients are the
 * values done - q + done (p - 1 - r). Two q, 0 and done/2, have their partners among their own values. */
INLINE void last_of_coefficients(const struct fluid_fourier *f, int p, const double *x, struct fluid_fourier_rows to) {
    const int n = f->n, done = n / p;
    for (int l = 0; l < PAIRS; l += VEC_LANES) {
        struct complex_lanes a[8], b[8];
#pragma GCC unroll 16
        for (int r = 0; r < p; r++) a[r] = load_row(x + done * r * ROW + l);
        dft(f, p, a);
        store_row(row_of(f, to, 0) + l, times(f->first, a[0]));
#pragma GCC unroll 16
        for (int r = 1; r < (p + 1) / 2; r++) put_pair(f, done * r, a[r], a[p - r], to, l);
        if (p % 2 == 0) store_row(row_of(f, to, n / 2) + l, times(f->middle, a[p / 2]));
        for (int q = 1; 2 * q < done; q++) {
#pragma GCC unroll 16
            for (int r = 0; r < p; r++) a[r] = load_row(x + (q + done * r) * ROW + l);
#pragma GCC unroll 16
            for (int r = 0; r < p; r++) b[r] = load_row(x + (done - q + done * r) * ROW + l);
            dft(f, p, a);
            dft(f, p, b);
#pragma GCC unroll 16
            for (int r = 0; r < (p + 1) / 2; r++) put_pair(f, q + done * r, a[r], b[p - 1 - r], to, l);
#pragma GCC unroll 16
            for (int r = 0; r < p / 2; r++) put_pair(f, done - q + done * r, b[r], a[p - 1 - r], to, l);
        }
        if (done % 2) continue;
#pragma GCC unroll 16
        for (int r = 0; r < p; r++) a[r] = load_row(x + (done / 2 + done * r) * ROW + l);
        dft(f, p, a);
#pragma GCC unroll 16
        for (int r = 0; r < p / 2; r++) put_pair(f, done / 2 + done * r, a[r], a[p - 1 - r], to, l);
    }
}

/* The first pass backward, done = 1, by the same pairs: it needs the values j + rest r. */
INLINE void first_of_coefficients(const struct fluid_fourier *f, int p, const double *root,
                                  struct fluid_fourier_rows from, double *y) {
    const int n = f->n, rest = n / p;
    for (int l = 0; l < PAIRS; l += VEC_LANES) {
        struct complex_lanes a[8], b[8];
        a[0] = conjugate(load_row(row_of(f, from, 0) + l));
#pragma GCC unroll 16
        for (int r = 1; r < (p + 1) / 2; r++) take_pair(f, rest * r, from, l, &a[r], &a[p - r]);
        if (p % 2 == 0) a[p / 2] = times(f->back_middle, conjugate(load_row(row_of(f, from, n / 2) + l)));
        dft(f, p, a);
#pragma GCC unroll 16
        for (int r = 0; r < p; r++) store_row(y + r * ROW + l, a[r]);
        for (int j = 1; 2 * j < rest; j++) {
#pragma GCC unroll 16
            for (int r = 0; r < (p + 1) / 2; r++) take_pair(f, j + rest * r, from, l, &a[r], &b[p - 1 - r]);
#pragma GCC unroll 16
            for (int r = 0; r < p / 2; r++) take_pair(f, rest - j + rest * r, from, l, &b[r], &a[p - 1 - r]);
            dft(f, p, a);
            dft(f, p, b);
            turn(p, root + 2 * (p - 1) * j, a);
            turn(p, root + 2 * (p - 1) * (rest - j), b);
#pragma GCC unroll 16
            for (int r = 0; r < p; r++) store_row(y + (p * j + r) * ROW + l, a[r]);
#pragma GCC unroll 16
            for (int r = 0; r < p; r++) store_row(y + (p * (rest - j) + r) * ROW + l, b[r]);
        }
        if (rest % 2) continue;
#pragma GCC unroll 16
        for (int r = 0; r < p / 2; r++) take_pair(f, rest / 2 + rest * r, from, l, &a[r], &a[p - 1 - r]);
        dft(f, p, a);
        turn(p, root + 2 * (p - 1) * (rest / 2), a);
#pragma GCC unroll 16
        for (int r = 0; r < p; r++) store_row(y + (p * rest / 2 + r) * ROW + l, a[r]);
    }
}

/* Calls a pass with its factor as a constant. */
#define FACTOR(call, p, ...)                                                                                           \
    case p:                                                                                                            \
        call(f, p, __VA_ARGS__);                                                                                       \
        break;
#define WITH_FACTOR_OF_TWO(call, p, ...)                                                                               \
    switch (p) {                                                                                                       \
        FACTOR(call, 1, __VA_ARGS__)                                                                                   \
        FACTOR(call, 2, __VA_ARGS__)                                                                                   \
        FACTOR(call, 4, __VA_ARGS__)                                                                                   \
    default:                                                                                                           \
        call(f, 8, __VA_ARGS__);                                                                                       \
    }
#define WITH_FACTOR(call, p, ...)                                                                                      \
    switch (p) {                                                                                                       \
        FACTOR(call, 1, __VA_ARGS__)                                                                                   \
        FACTOR(call, 2, __VA_ARGS__)                                                                                   \
        FACTOR(call, 3, __VA_ARGS__)                                                                                   \
        FACTOR(call, 4, __VA_ARGS__)                                                                                   \
        FACTOR(call, 5, __VA_ARGS__)                                                                                   \
        FACTOR(call, 8, __VA_ARGS__)                                                                                   \
        FACTOR(call, 16, __VA_ARGS__)                                                                                  \
    default:                                                                                                           \
        call(f, p, __VA_ARGS__);                                                                                       \
    }

/* The passes between the first and the last one, from x. Returns where their result is: x or other. */
static double *inner_passes(const struct fluid_fourier *f, const struct order *o, double *x, double *other) {
    for (int i = 1, done = o->factor[0]; i < o->factors - 1; done *= o->factor[i++]) {
        const int p = o->factor[i];
        WITH_FACTOR(pass, p, done, o->root[i], x, other)
        double *const result = other;
        other = x;
        x = result;
    }
    return x;
}

/* Where a result is to be that has no place yet: where the last pass reads, or in the other scratch. */
static struct fluid_fourier_rows placed(struct fluid_fourier_rows to, double *x, int in_place,
                                        double *const scratch[2]) {
    return to.at ? to : (struct fluid_fourier_rows){in_place ? x : x == scratch[0] ? scratch[1] : scratch[0], ROW};
}

struct fluid_fourier_rows fluid_fourier_forward(const struct fluid_fourier *f, struct fluid_fourier_rows from,
                                                struct fluid_fourier_rows to, double *const scratch[2]) {
    const struct order *o = &f->forward;
    const int first = o->factor[0], last = o->factor[o->factors - 1];
    WITH_FACTOR(first_of_values, first, o->root[0], from, scratch[1])
    double *x = inner_passes(f, o, scratch[1], scratch[0]);
    to = placed(to, x, !f->is_from_end, scratch);
    WITH_FACTOR_OF_TWO(last_of_coefficients, last, x, to)
    return to;
}

struct fluid_fourier_rows fluid_fourier_backward(const struct fluid_fourier *f, struct fluid_fourier_rows from,
                                                 struct fluid_fourier_rows to, double *const scratch[2]) {
    const struct order *o = &f->backward;
    const int first = o->factor[0], last = o->factor[o->factors - 1];
    WITH_FACTOR_OF_TWO(first_of_coefficients, first, o->root[0], from, scratch[1])
    double *x = inner_passes(f, o, scratch[1], scratch[0]);
    to = placed(to, x, 0, scratch);
    WITH_FACTOR(last_of_values, last, x, to)
    return to;
}
