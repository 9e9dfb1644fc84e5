/* Fourier transforms of four complex lines at once, by factors (Stockham's order: no permutation at the end). */
#include "fluid/poisson/fourier.h"
#include "base/memory.h"
#include "base/vec.h"

#include <math.h>
#include <stdlib.h>

enum {
    FACTORS = 32,
    LARGEST = 61, /* prime factor: it takes as many operations a value */
    VALUE = FLUID_FOURIER_VALUE,
    LINES = FLUID_FOURIER_LINES
};

struct fluid_fourier {
    int n, factors, factor[FACTORS];
    double *cosine, *sine; /* [n] of 2 pi j/n */
    double *root[FACTORS]; /* of each pass, in its order: [n/(done p)][p - 1][2] */
};

/* Factors in the order of their passes. The last pass needs no roots of unity, so the largest power of two is last. */
static int factorize(int n, int *factor) {
    int count = 0, twos = 0;
    for (; n % 2 == 0; n /= 2) twos++;
    for (int p = 3; n > 1; p += 2)
        for (; n % p == 0; n /= p) {
            if (p > LARGEST) return 0;
            factor[count++] = p;
        }
    if (twos == 1) factor[count++] = 2;
    for (; twos % 3 && twos > 1; twos -= 2) factor[count++] = 4;
    for (; twos > 2; twos -= 3) factor[count++] = 8;
    return count;
}

static double *new_roots(const struct fluid_fourier *f, int p, int done) {
    const int rest = f->n / (done * p);
    double *root = memory_new(MEMORY_FLUID, 2 * (size_t)(rest * (p - 1)), sizeof(double));
    for (int j = 0; j < rest; j++)
        for (int r = 1; r < p; r++) {
            root[2 * (j * (p - 1) + r - 1)] = f->cosine[j * r * done];
            root[2 * (j * (p - 1) + r - 1) + 1] = f->sine[j * r * done];
        }
    return root;
}

struct fluid_fourier *fluid_fourier_new(int n) {
    int factor[FACTORS];
    const int factors = factorize(n, factor);
    if (n < 2 || factors == 0) return NULL;
    struct fluid_fourier *f = calloc(1, sizeof *f);
    f->n = n;
    f->factors = factors;
    for (int i = 0; i < factors; i++) f->factor[i] = factor[i];
    f->cosine = memory_new(MEMORY_FLUID, 2 * (size_t)n, sizeof(double));
    f->sine = f->cosine + n;
    for (int j = 0; j < n; j++) {
        f->cosine[j] = cos(2 * M_PI * j / n);
        f->sine[j] = sin(2 * M_PI * j / n);
    }
    for (int i = 0, done = 1; i < factors; done *= factor[i++]) f->root[i] = new_roots(f, factor[i], done);
    return f;
}

void fluid_fourier_free(struct fluid_fourier *f) {
    if (!f) return;
    for (int i = 0; i < f->factors; i++) memory_free(f->root[i]);
    memory_free(f->cosine);
    free(f);
}

#define INLINE static inline __attribute__((always_inline))

struct complex4 {
    vec4 re, im;
};

INLINE struct complex4 plus(struct complex4 a, struct complex4 b) {
    return (struct complex4){a.re + b.re, a.im + b.im};
}
INLINE struct complex4 minus(struct complex4 a, struct complex4 b) {
    return (struct complex4){a.re - b.re, a.im - b.im};
}
INLINE struct complex4 minus_i_times(struct complex4 a) { return (struct complex4){a.im, -a.re}; }
/* a exp(-i phi), of the angle's cosine and sine. */
INLINE struct complex4 turned(struct complex4 a, double c, double s) {
    return (struct complex4){c * a.re + s * a.im, c * a.im - s * a.re};
}

/* Transforms of p values, in place. */

INLINE void of_two(struct complex4 a[2]) {
    const struct complex4 sum = plus(a[0], a[1]), difference = minus(a[0], a[1]);
    a[0] = sum;
    a[1] = difference;
}

INLINE void of_four(struct complex4 a[4]) {
    const struct complex4 even = plus(a[0], a[2]), odd = plus(a[1], a[3]);
    const struct complex4 apart = minus(a[0], a[2]), across = minus_i_times(minus(a[1], a[3]));
    a[0] = plus(even, odd);
    a[1] = plus(apart, across);
    a[2] = minus(even, odd);
    a[3] = minus(apart, across);
}

INLINE void of_eight(struct complex4 a[8]) {
    struct complex4 even[4] = {a[0], a[2], a[4], a[6]}, odd[4] = {a[1], a[3], a[5], a[7]};
    of_four(even);
    of_four(odd);
    odd[1] = turned(odd[1], M_SQRT1_2, M_SQRT1_2);
    odd[2] = minus_i_times(odd[2]);
    odd[3] = turned(odd[3], -M_SQRT1_2, M_SQRT1_2);
    for (int k = 0; k < 4; k++) {
        a[k] = plus(even[k], odd[k]);
        a[k + 4] = minus(even[k], odd[k]);
    }
}

/* p is odd; c, s: cosines and sines of 2 pi j/p, `step` apart. */
INLINE void of_odd(int p, int step, const double *c, const double *s, struct complex4 *a) {
    struct complex4 sum[LARGEST / 2], difference[LARGEST / 2];
    const struct complex4 first = a[0];
    for (int j = 1; j <= p / 2; j++) {
        sum[j - 1] = plus(a[j], a[p - j]);
        difference[j - 1] = minus(a[j], a[p - j]);
        a[0] = plus(a[0], sum[j - 1]);
    }
    for (int k = 1; k <= p / 2; k++) {
        struct complex4 even = first, odd = {vec4_set(0), vec4_set(0)};
        for (int j = 1; j <= p / 2; j++) {
            const double cosine = c[j * k % p * step], sine = s[j * k % p * step];
            even = plus(even, (struct complex4){cosine * sum[j - 1].re, cosine * sum[j - 1].im});
            odd = plus(odd, (struct complex4){sine * difference[j - 1].re, sine * difference[j - 1].im});
        }
        a[k] = plus(even, minus_i_times(odd));
        a[p - k] = minus(even, minus_i_times(odd));
    }
}

INLINE void of(const struct fluid_fourier *f, int p, struct complex4 *a) {
    if (p == 2)
        of_two(a);
    else if (p == 4)
        of_four(a);
    else if (p == 8)
        of_eight(a);
    else
        of_odd(p, f->n / p, f->cosine, f->sine, a);
}

/* A pass: `done` is the product of the factors before p, rest = n/(done p). The values
 *     x[q + done (j + rest r)] , r = 0 .. p-1 ,
 * are transformed, turned by the angles 2 pi j r/(n/done), and written to y[q + done (p j + r)]. */
INLINE void pass(const struct fluid_fourier *f, int p, int done, const double *restrict root, const double *restrict x,
                 double *restrict y) {
    const int rest = f->n / (done * p);
    const ptrdiff_t among = (ptrdiff_t)rest * done * VALUE, apart = (ptrdiff_t)done * VALUE;
    for (int j = 0; j < rest; j++, root += 2 * (p - 1), y += (p - 1) * apart)
        for (const double *end = x + apart; x < end; x += VALUE, y += VALUE)
            for (int l = 0; l < LINES; l += VEC4_LANES) {
                struct complex4 a[LARGEST];
                for (int r = 0; r < p; r++)
                    a[r] = (struct complex4){vec4_load(x + r * among + l), vec4_load(x + r * among + l + LINES)};
                of(f, p, a);
                for (int r = 0; r < p; r++) {
                    const struct complex4 z = r > 0 && rest > 1 ? turned(a[r], root[2 * r - 2], root[2 * r - 1]) : a[r];
                    vec4_store(y + r * apart + l, z.re);
                    vec4_store(y + r * apart + l + LINES, z.im);
                }
            }
}

double *fluid_fourier_forward(const struct fluid_fourier *f, double *z, double *other) {
    for (int i = 0, done = 1; i < f->factors; done *= f->factor[i++]) {
        switch (f->factor[i]) {
        case 2:
            pass(f, 2, done, f->root[i], z, other);
            break;
        case 3:
            pass(f, 3, done, f->root[i], z, other);
            break;
        case 4:
            pass(f, 4, done, f->root[i], z, other);
            break;
        case 5:
            pass(f, 5, done, f->root[i], z, other);
            break;
        case 8:
            pass(f, 8, done, f->root[i], z, other);
            break;
        default:
            pass(f, f->factor[i], done, f->root[i], z, other);
        }
        double *const result = other;
        other = z;
        z = result;
    }
    return z;
}
