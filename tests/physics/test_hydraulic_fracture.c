/* Fluid-driven cracks: the similarity solutions against a solution of lubrication with elasticity that is computed
 * here, the printed digits, units, and the numbers that tell the regime. */
#include "physics/hydraulic_fracture.h"
#include "base/par.h"
#include "tests/physics/pressurised_crack.h"
#include "tests/check.h"

#include <stdlib.h>

/* The viscosity regime. With x = l X, w = gamma W O(X), p = P p(X), where W and P are the scales of opening and
 * pressure and O is the opening over gamma, gamma drops out of both equations:
 *     KGD    O^3 p' = -(integral of O from X to 1) - 2/3 X O ,           O = -4/pi integral of p'(Y) k(X, Y) dY
 *     penny  X O^3 p' = -(integral of Y O from X to 1) - 4/9 X^2 O ,     O = -8/pi integral of sqrt(S^2 - X^2) g(S) dS
 *            from X to 1,   g(S) = integral of sin^2(a) p'(S sin a) da from 0 to pi/2
 * and the volume Q0 t gives gamma: 2 gamma^2 times the integral of O is 1; 2 pi gamma^3 times that of X O is 1.
 * Both forms of elasticity hold K_I = 0. The unknowns stand at the middles of N parts of a parameter s with the
 * distance from the tip y = 1 - X = s^4 (5 - 4 s); the error falls as 1/N^2. */
enum { N = 400, FINE = 240 };

struct similar {
    double y[N], dy[N]; /* distance from the tip, and its part of an integral */
    double shape[N];    /* O/y^(2/3) */
    double slope[N];    /* p' of KGD, X p' of a penny */
    double (*turn)[N];  /* O = turn slope */
};

static void grid(struct similar *k) {
    for (int i = 0; i < N; i++) {
        const double s = (i + 0.5) / N;
        k->y[i] = pow(s, 4) * (5 - 4 * s);
        k->dy[i] = 20 * pow(s, 3) * (1 - s) / N;
    }
}

/* Y ln((a + b)/|a - b|) + X ln|(Y a - X b)/(Y a + X b)|,  a = sqrt(1 - X^2), b = sqrt(1 - Y^2): what is left of the
 * pressure's kernel ln|(a + b)/(a - b)| after an integration by parts with K_I = 0 */
static double kernel(double y, double y2, int same) {
    const double X = 1 - y, Y = 1 - y2, a = sqrt(y * (2 - y)), b = sqrt(y2 * (2 - y2));
    const double apart = same ? 1 : fabs((y - y2) * (2 - y - y2)); /* |a^2 - b^2|: cancels where Y = X */
    return Y * log((a + b) * (a + b) / apart) + X * log(apart / ((Y * a + X * b) * (Y * a + X * b)));
}

static void turn_kgd(struct similar *k) {
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) k->turn[i][j] = -4 / acos(-1) * kernel(k->y[i], k->y[j], i == j) * k->dy[j];
}

/* Adds weight times the value at y of a function given at the points, linear between them in sqrt(y). */
static void add_at(const struct similar *k, double y, double weight, double *row) {
    int low = 0, high = N - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (k->y[middle] <= y)
            low = middle;
        else
            high = middle;
    }
    const double at = (sqrt(y) - sqrt(k->y[low])) / (sqrt(k->y[high]) - sqrt(k->y[low]));
    const double part = at < 0 ? 0 : at > 1 ? 1 : at;
    row[low] += weight * (1 - part);
    row[high] += weight * part;
}

/* turn: to O from X p'. The smooth parts of p' and g are interpolated: y^(4/3) X p' and y^(5/6) S g. */
static void turn_penny(struct similar *k) {
    const double pi = acos(-1);
    double(*g)[N] = calloc(N, sizeof *g);
    for (int i = 0; i < N; i++) { /* y^(5/6) S g at y_i; b = pi/2 - a = root sinh(c), since p' is steep at b = 0 */
        const double y = k->y[i], S = 1 - y, root = sqrt(y), end = asinh(0.5 * pi / root);
        for (int f = 0; f < FINE; f++) {
            const double c = (f + 0.5) * end / FINE, b = root * sinh(c), half = sin(0.5 * b);
            const double y2 = y + 2 * S * half * half;
            add_at(k, y2, pow(y, 5.0 / 6) * cos(b) * pow(y2, -4.0 / 3) * root * cosh(c) * end / FINE, g[i]);
        }
    }
    for (int i = 0; i < N; i++) { /* y_S = y q^6 (7 - 6 q) */
        double row[N] = {0};
        const double y = k->y[i];
        for (int f = 0; f < FINE; f++) {
            const double q = (f + 0.5) / FINE, y2 = y * pow(q, 6) * (7 - 6 * q);
            const double chord = sqrt(fmax(0, (y - y2) * (2 - y - y2)));
            add_at(k, y2, chord / (1 - y2) * pow(y2, -5.0 / 6) * y * 42 * pow(q, 5) * (1 - q) / FINE, row);
        }
        for (int j = 0; j < N; j++) k->turn[i][j] = 0;
        for (int m = 0; m < N; m++)
            for (int j = 0; j < N && row[m] != 0; j++) k->turn[i][j] += -8 / pi * row[m] * g[m][j];
        for (int j = 0; j < N; j++) k->turn[i][j] *= pow(k->y[j], 4.0 / 3);
    }
    free(g);
}

/* Sets the slope from the shape; returns the whole integral of O or of X O. */
static double slopes(struct similar *k, enum physics_hydraulic_shape shape) {
    double sum = 0;
    for (int i = 0; i < N; i++) {
        const double O = k->shape[i] * pow(k->y[i], 2.0 / 3), X = 1 - k->y[i];
        const double part = (shape == PHYSICS_KGD ? O : X * O) * k->dy[i];
        const double moved = shape == PHYSICS_KGD ? 2.0 / 3 * X * O : 4.0 / 9 * X * X * O;
        k->slope[i] = -(sum + 0.5 * part + moved) / (O * O * O);
        sum += part;
    }
    return sum;
}

/* Iterates to the solution, whose error in O falls by a third to a half a turn; returns gamma. */
static double solve(struct similar *k, enum physics_hydraulic_shape shape) {
    double volume = 0, worst = 1;
    for (int i = 0; i < N; i++) k->shape[i] = 1.8;
    for (int turns = 0; turns < 100 && worst > 1e-11; turns++) {
        volume = slopes(k, shape);
        worst = 0;
        for (int i = 0; i < N; i++) {
            double O = 0;
            for (int j = 0; j < N; j++) O += k->turn[i][j] * k->slope[j];
            const double ratio = O / (k->shape[i] * pow(k->y[i], 2.0 / 3));
            k->shape[i] *= cbrt(ratio);
            worst = check_worst(worst, ratio - 1);
        }
    }
    check_below(worst, 1e-11);
    return shape == PHYSICS_KGD ? 1 / sqrt(2 * volume) : 1 / cbrt(2 * acos(-1) * volume);
}

/* The part of an integral over y_i's cell that lies within 1/2 of the well, by the cell's ends. */
static double inner_half(int i) {
    const double s = (double)i / N, low = pow(s, 4) * (5 - 4 * s);
    const double r = (double)(i + 1) / N, high = pow(r, 4) * (5 - 4 * r);
    return low >= 0.5 ? 1 : high <= 0.5 ? 0 : (high - 0.5) / (high - low);
}

/* A crack with E' = mu' = Q0 = t = 1, so that the lengths are the constants. */
static struct physics_hydraulic_state constants(enum physics_hydraulic_shape shape) {
    const struct physics_hydraulic_fracture unit = {shape, 1, 0, 1.0 / 12, 1};
    return physics_hydraulic_fracture_at(&unit, PHYSICS_VISCOSITY, 1);
}

/* The tolerance is half of the last digit of the constants, and 5e-6 for the error of N = 400 (four times as small at
 * N = 800). */
static void kgd_with_viscosity(void **state) {
    struct similar *k = calloc(1, sizeof *k);
    (void)state;
    k->turn = calloc(N, sizeof *k->turn);
    grid(k);
    turn_kgd(k);
    const double gamma = solve(k, PHYSICS_KGD);
    double opening = 0, well = 0, half = 0;
    for (int i = 0; i < N; i++) {
        const double dp = k->slope[i] * k->dy[i], Y = 1 - k->y[i], b = sqrt(k->y[i] * (2 - k->y[i]));
        opening -= 4 / acos(-1) * dp * Y * log((1 + b) * (1 + b) / (Y * Y));
        well -= 2 / acos(-1) * dp * acos(Y); /* K_I = 0 */
        half += dp * inner_half(i);
    }
    const struct physics_hydraulic_state now = constants(PHYSICS_KGD);
    check_close(now.length, gamma, 1e-5);
    check_close(now.opening, gamma * opening, 1e-5);
    check_close(now.pressure_well, well, 1e-5);
    check_close(now.pressure_half, well + half, 1e-5);
    free(k->turn);
    free(k);
}

static void penny_with_viscosity(void **state) {
    struct similar *k = calloc(1, sizeof *k);
    (void)state;
    k->turn = calloc(N, sizeof *k->turn);
    grid(k);
    turn_penny(k);
    const double gamma = solve(k, PHYSICS_PENNY);
    double row[N] = {0}, half = 0;
    for (int f = 0; f < FINE; f++) { /* K_I = 0: the integral of X p/sqrt(1 - X^2) is 0 */
        const double q = (f + 0.5) / FINE, outer = 0.5 * pow(q, 6) * (7 - 6 * q), inner = 0.5 + 0.5 * q;
        const double at[2] = {outer, inner}, part[2] = {21 * pow(q, 5) * (1 - q) / FINE, 0.5 / FINE};
        for (int i = 0; i < 2; i++)
            add_at(k, at[i], -(sqrt(at[i] * (2 - at[i])) - i) / (1 - at[i]) * pow(at[i], -4.0 / 3) * part[i], row);
    }
    for (int j = 0; j < N; j++) half += row[j] * pow(k->y[j], 4.0 / 3) * k->slope[j];
    const struct physics_hydraulic_state now = constants(PHYSICS_PENNY);
    check_close(now.length, gamma, 2e-5);
    check_close(now.opening, gamma * k->shape[N - 1], 4e-5);
    check_close(now.pressure_half, half, 2e-5);
    check_equal(isinf(now.pressure_well), 1);
    free(k->turn);
    free(k);
}

/* E' = K' = Q0 = t = 1, against the printed factors; and by Sneddon's crack. */
static void with_toughness(void **state) {
    (void)state;
    const struct {
        enum physics_hydraulic_shape shape;
        enum crack_shape at_rest;
        double length, opening, pressure;
    } row[] = {{PHYSICS_KGD, CRACK_PLANE, 0.93239, 0.68278, 0.18307},
               {PHYSICS_PENNY, CRACK_PENNY, 0.85464, 0.65370, 0.30037}};
    for (int i = 0; i < 2; i++) {
        struct physics_hydraulic_fracture in = {row[i].shape, 1, 1 / (4 * sqrt(2 / acos(-1))), 0, 1};
        struct physics_hydraulic_state now = physics_hydraulic_fracture_at(&in, PHYSICS_TOUGHNESS, 1);
        check_close(now.length, row[i].length, 5e-6);
        check_close(now.opening, row[i].opening, 5e-6);
        check_close(now.pressure_well, row[i].pressure, 5e-6);
        in = (struct physics_hydraulic_fracture){row[i].shape, 3e10, 1.4e6, 0, 2e-4};
        now = physics_hydraulic_fracture_at(&in, PHYSICS_TOUGHNESS, 7);
        const double p = now.pressure_half, a = now.length;
        check_relative(pressurised_crack_intensity(row[i].at_rest, p, a), 1.4e6, 1e-13);
        check_relative(pressurised_crack_volume(row[i].at_rest, 3e10, p, a), 2e-4 * 7, 1e-13);
        check_equal(now.pressure_well, p);
        check_relative(pressurised_crack_opening(row[i].at_rest, 3e10, p, a, 0), now.opening, 1e-13);
    }
}

/* In units of m a, s b and kg c the answers are the same lengths and pressures. */
static void units(void **state) {
    (void)state;
    const double m = 3, s = 7, kg = 0.4, pascal = kg / (m * s * s);
    for (int shape = 0; shape < 2; shape++)
        for (int regime = 0; regime < 2; regime++) {
            const struct physics_hydraulic_fracture in = {shape, 3e4, 14, 1e-3, 2e-4},
                                                    other = {shape, 3e4 * pascal, 14 * pascal * sqrt(m),
                                                             1e-3 * pascal * s,
                                                             2e-4 * (shape == PHYSICS_KGD ? m * m : m * m * m) / s};
            const struct physics_hydraulic_state now = physics_hydraulic_fracture_at(&in, regime, 5),
                                                 then = physics_hydraulic_fracture_at(&other, regime, 5 * s);
            check_relative(then.length, now.length * m, 1e-12);
            check_relative(then.opening, now.opening * m, 1e-12);
            check_relative(then.pressure_half, now.pressure_half * pascal, 1e-12);
            check_relative(physics_hydraulic_fracture_number(&other, 5 * s), physics_hydraulic_fracture_number(&in, 5),
                           1e-12);
        }
}

/* Exponents of time: length 2/3, opening 1/3 (KGD); 4/9 and 1/9, and 2/5 and 1/5 (penny); pressure -1/3, -1/5. */
static void in_time(void **state) {
    (void)state;
    const double power[2][2][3] = {{{2.0 / 3, 1.0 / 3, -1.0 / 3}, {2.0 / 3, 1.0 / 3, -1.0 / 3}},
                                   {{0.4, 0.2, -0.2}, {4.0 / 9, 1.0 / 9, -1.0 / 3}}};
    for (int shape = 0; shape < 2; shape++)
        for (int regime = 0; regime < 2; regime++) {
            const struct physics_hydraulic_fracture in = {shape, 3e10, 1e6, 0.1, 1e-3};
            const struct physics_hydraulic_state now = physics_hydraulic_fracture_at(&in, regime, 2),
                                                 then = physics_hydraulic_fracture_at(&in, regime, 6);
            const double *exponent = power[shape][regime];
            check_close(log(then.length / now.length) / log(3), exponent[0], 1e-12);
            check_close(log(then.opening / now.opening) / log(3), exponent[1], 1e-12);
            check_close(log(then.pressure_half / now.pressure_half) / log(3), exponent[2], 1e-12);
        }
}

/* At the time of transition the penny's number is 1, and both regimes have lengths of one size: 0.6978 and 0.8546 of
 * (Q0^3 E' t^4/mu')^(1/9), which is (E' Q0 t/K')^(2/5) then. */
static void transition(void **state) {
    (void)state;
    const struct physics_hydraulic_fracture penny = {PHYSICS_PENNY, 3e10, 1e6, 0.1, 1e-3};
    const double t = physics_hydraulic_fracture_transition(&penny), k = 4 * sqrt(2 / acos(-1)) * 1e6;
    check_relative(t, sqrt(pow(1.2, 5) * pow(3e10, 13) * pow(1e-3, 3) / pow(k, 18)), 1e-12);
    check_relative(physics_hydraulic_fracture_number(&penny, t), 1, 1e-14);
    check_relative(physics_hydraulic_fracture_number(&penny, 512 * t), 2, 1e-14);
    const double ratio = physics_hydraulic_fracture_at(&penny, PHYSICS_VISCOSITY, t).length /
                         physics_hydraulic_fracture_at(&penny, PHYSICS_TOUGHNESS, t).length;
    check_relative(ratio, 0.69784 / 0.85464, 1e-5);
    struct physics_hydraulic_fracture kgd = {PHYSICS_KGD, 3e10, 1e6, 0.1, 1e-4};
    check_relative(physics_hydraulic_fracture_number(&kgd, 4), k / pow(1.2 * pow(3e10, 3) * 1e-4, 0.25), 1e-12);
    check_equal(physics_hydraulic_fracture_number(&kgd, 4), physics_hydraulic_fracture_number(&kgd, 40));
    check_equal(isinf(physics_hydraulic_fracture_transition(&kgd)), 1);
}

/* The time is the inverse of the length, and the speed its slope. */
static void reached(void **state) {
    (void)state;
    for (int shape = 0; shape < 2; shape++)
        for (int regime = 0; regime < 2; regime++) {
            const struct physics_hydraulic_fracture in = {shape, 3e10, 1e6, 0.1, 1e-3};
            const double t = 3, length = physics_hydraulic_fracture_at(&in, regime, t).length;
            check_relative(physics_hydraulic_fracture_reached(&in, regime, length), t, 1e-12);
            const double slope = (physics_hydraulic_fracture_at(&in, regime, t + 1e-4).length -
                                  physics_hydraulic_fracture_at(&in, regime, t - 1e-4).length) /
                                 2e-4;
            check_relative(physics_hydraulic_fracture_speed(&in, regime, t), slope, 1e-7);
        }
}

/* Integral of the opening's kernel of a semi-infinite crack without toughness,
 *     w(x) = 4/(pi E') int (ln |(x^1/2 + s^1/2)/(x^1/2 - s^1/2)| - 2 (x/s)^1/2) p(s) ds */
static double lag_kernel(double x, double s) {
    const double a = sqrt(x), b = sqrt(s);
    return (s == x ? 0 : (s - x) * log((a + b) / fabs(a - b))) - 2 * a * b;
}

/* The lag of length 1: p = -1 in it, then p' = M/w^2 up to p = 0 far away; the lag is 1/M mu' V E'^2/sigma0^3. Far from
 * the tip p goes with x^-1/3 and w with x^2/3. */
static void lag(void **state) {
    (void)state;
    enum { DRY = 60, WET = 260, ALL = DRY + WET };
    static double edge[ALL + 1], x[ALL], p[ALL], w[ALL], pull[ALL][ALL];
    const double pi = acos(-1), far = 1e8;
    for (int i = 0; i <= ALL; i++) edge[i] = i < DRY ? pow((double)i / DRY, 2) : pow(far, (double)(i - DRY) / WET);
    for (int i = 0; i < ALL; i++) x[i] = i ? sqrt(edge[i] * edge[i + 1]) : edge[1] / 3;
    for (int i = 0; i < ALL; i++)
        for (int j = 0; j < ALL; j++) pull[i][j] = 4 / pi * (lag_kernel(x[i], edge[j + 1]) - lag_kernel(x[i], edge[j]));
    for (int i = 0; i < ALL; i++) p[i] = i < DRY ? -1 : -pow(x[i], -1.0 / 3);
    double m = 0, before = 1;
    for (int k = 0; k < 100 && fabs(m - before) > 1e-9; k++) {
        before = m;
        const double rest = p[ALL - 1] * cbrt(x[ALL - 1]) * 4 / pi * 2 / 3 * 6 / 5 * pow(far, -5.0 / 6);
        double beyond = 0;
        for (int i = ALL - 1; i >= DRY; i--) {
            w[i] = rest * pow(x[i], 1.5);
            for (int j = 0; j < ALL; j++) w[i] += pull[i][j] * p[j];
            if (i == ALL - 1) beyond = 3 * pow(w[i], -2) * pow(x[i], 4.0 / 3) / cbrt(far);
            w[i] = pow(w[i], -2) * (edge[i + 1] - edge[i]);
        }
        double sum = beyond;
        for (int i = ALL - 1; i >= DRY; i--) sum += w[i];
        m = 1 / sum;
        sum = beyond;
        for (int i = ALL - 1; i >= DRY; i--) {
            p[i] = 0.5 * p[i] - 0.5 * m * (sum + 0.5 * w[i]);
            sum += w[i];
        }
    }
    const struct physics_hydraulic_fracture one = {PHYSICS_KGD, 3, 0, 0.5, 1};
    check_relative(physics_hydraulic_fracture_lag(&one, 2, 5), 1 / m * 6 * 2 * 9 / 125, 5e-4);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(kgd_with_viscosity),
                                       cmocka_unit_test(penny_with_viscosity),
                                       cmocka_unit_test(with_toughness),
                                       cmocka_unit_test(units),
                                       cmocka_unit_test(in_time),
                                       cmocka_unit_test(transition),
                                       cmocka_unit_test(reached),
                                       cmocka_unit_test(lag)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
