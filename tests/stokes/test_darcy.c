/* The Darcy operator's solution: it satisfies the equation, a few cycles suffice on any number of ranks, in pores that
 * nothing holds and in those between given pressures, also where the right-hand side has round-off in its sum. */
#include "base/memory.h"
#include "stokes/darcy.h"
#include "tests/stokes/make.h"

/* Cycles until a step adds 1e-6 of the work, for flow along z with weights between 1 and 30. */
static int cycles_of(int edge, make_is_pore *is_pore, const void *with, const struct stokes_input *in,
                     double *balance) {
    const int n[3] = {edge, edge, edge};
    struct stokes *s = make_stokes(n, is_pore, with, in);
    const struct stokes_cells *c = s->cells;
    const size_t size = stokes_cells_size(c);
    float(*phi)[3] = memory_new(MEMORY_FLUID, size, sizeof *phi), *b = memory_new(MEMORY_FLUID, 6 * size, sizeof *b);
    for (int i = 0; i < c->n; i++)
        for (int d = 0; d < 3; d++)
            if (stokes_faces_is_open(s->faces, i, d)) phi[i][d] = (float)(1 + (c->first[par_rank()] + i) * 7 % 30);
    stokes_cells_fill(c, sizeof *phi, phi);
    float(*of)[3] = memory_copy(MEMORY_FLUID, phi, size, sizeof *phi);
    struct stokes_darcy *d = stokes_darcy_new(c, phi);
    float *x = b + size, *const work[3] = {b + 2 * size, b + 3 * size, b + 4 * size};
    stokes_darcy_force(d, 2, b);
    const int cycles = stokes_darcy_solve(d, 1e-3, b, x, work);
    /* of each cell: what flows out by the faces, for the force alone and with the pressure */
    double norm[2] = {0};
    for (int i = 0; i < c->n; i++) {
        double force = 0, both = 0;
        int is_outside = 0;
        for (int q = 0; q < 6; q++) {
            const int to = c->next[i][q], low = q % 2 == 0;
            const double w = (double)of[low ? to : i][q / 2];
            force += (low ? -w : w) * (q / 2 == 2);
            both += (low ? -w : w) * (q / 2 == 2) - w * ((double)x[to] - (double)x[i]);
        }
        for (int k = 0; k < c->outside; k++) is_outside |= c->of_outside[k] == i;
        if (is_outside) continue;
        norm[0] += force * force;
        norm[1] += both * both;
    }
    par_sum_array(norm, 2);
    *balance = sqrt(norm[1] / norm[0]);
    stokes_darcy_free(d);
    memory_free(b);
    memory_free(of);
    stokes_free(s);
    return cycles;
}

/* The residual is of the size of the error of the work, up to the round-off of floats. */
static void few_cycles(void **state) {
    (void)state;
    const struct stokes_input free = {.tolerance = 1e-4},
                              held = {.side = {[2] = {STOKES_SIDE_PRESSURE, STOKES_SIDE_PRESSURE}}, .tolerance = 1e-4};
    const double share = 0.7;
    double balance;
    check_at_most(cycles_of(30, make_noise, &share, &free, &balance), 12);
    check_below(balance, 3e-4);
    check_at_most(cycles_of(30, make_noise, &share, &held, &balance), 12);
    check_below(balance, 3e-4);
}

/* Chambers of 5 cells, 12 apart, from which narrow tubes go out across all sides. They end, but for those along z,
 * which lead from chamber to chamber. */
static int is_comb(const int at[3], const void *unused) {
    int in = 0, c = 0;
    (void)unused;
    for (int d = 0; d < 3; d++) in += at[d] % 12 < 5;
    if (in != 2) return in == 3;
    while (at[c] % 12 < 5) c++;
    const int is_tube = at[(c + 1) % 3] % 12 % 2 == 0 && at[(c + 2) % 3] % 12 % 2 == 0;
    return is_tube && (c == 2 || at[c] % 12 < 8 || at[c] % 12 > 8);
}

static void dead_ends(void **state) {
    (void)state;
    const struct stokes_input free = {.tolerance = 1e-4};
    double balance;
    const int small = cycles_of(24, is_comb, NULL, &free, &balance),
              large = cycles_of(72, is_comb, NULL, &free, &balance);
    check_at_most(small, 14);
    check_at_most(large, 14);
    check_below(balance, 1e-3);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(few_cycles), cmocka_unit_test(dead_ends)};
    par_begin(&argc, &argv);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
