/* Velocity profiles through a section: inflow profiles and the developed channel or duct flow. */
#include "fluid/grid/profile.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/files/plain_file.h"
#include "fluid/grid/side.h"
#include "fluid/poisson/transform.h"

#include <lapacke.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static int walls(const struct fluid_input *in, int d, int component) {
    return fluid_side_is_wall(&in->side[d][0], component) && fluid_side_is_wall(&in->side[d][1], component);
}

static void parabola(int n, double d, double *q) {
    for (int j = 0; j < n; j++) {
        const double y = (j + 0.5) * d;
        q[j] = y * (n * d - y) + 0.25 * d * d;
    }
}

/* lap q = -1 with q = 0 on the four walls: sine series along a, bands along b.
 * -1 = sum_k c_k sin(pi k (j+1/2)/n_a), c_k = -(2/n_a) sum_j sin(...), halved for k = n_a. */
static void duct(int na, double da, int nb, double db, double *q) {
    const double a = 1 / (db * db);
    double *lambda = memory_new(MEMORY_FLUID, (size_t)na, sizeof *lambda);
    double *b = memory_new(MEMORY_FLUID, (size_t)na * (size_t)nb, sizeof *b); /* [na][nb] */
    double *diagonal = memory_new(MEMORY_FLUID, (size_t)nb, sizeof *diagonal);
    double *beside = memory_new(MEMORY_FLUID, (size_t)nb, sizeof *beside);
    fluid_transform_eigenvalues(na, da, FLUID_END_DIRICHLET, FLUID_END_DIRICHLET, lambda);
    for (int k = 0; k < na; k++) {
        double c = 0;
        for (int j = 0; j < na; j++) c -= sin(M_PI * (k + 1) * (j + 0.5) / na);
        c *= (k == na - 1 ? 1.0 : 2.0) / na;
        for (int l = 0; l < nb; l++) { /* both sides times -1: positive definite; a wall adds a to the diagonal of the
                                        * cell beside it */
            b[k * nb + l] = -c;
            diagonal[l] = 2 * a - lambda[k] + (l == 0 ? a : 0) + (l == nb - 1 ? a : 0);
            beside[l] = -a;
        }
        ENSURE(LAPACKE_dptsv(LAPACK_COL_MAJOR, nb, 1, diagonal, beside, b + (size_t)k * (size_t)nb, nb) == 0,
               "the duct's profile has no solution");
    }
    for (int j = 0; j < na; j++)
        for (int l = 0; l < nb; l++) {
            double sum = 0;
            for (int k = 0; k < na; k++) sum += b[k * nb + l] * sin(M_PI * (k + 1) * (j + 0.5) / na);
            q[l * na + j] = sum;
        }
    MEMORY_FREE(lambda, b, diagonal, beside);
}

static void normalise(int n, double *q) {
    double sum = 0;
    for (int i = 0; i < n; i++) sum += q[i];
    for (int i = 0; i < n; i++) q[i] *= n / sum;
}

void fluid_profile_developed(const struct fluid_input *in, int direction, double *profile) {
    int a, b;
    fluid_boundary_others(direction, &a, &b);
    const int na = in->n[a], nb = in->n[b];
    const double da = in->length[a] / na, db = in->length[b] / nb;
    const int walls_a = walls(in, a, direction), walls_b = walls(in, b, direction);
    double *line = memory_new(MEMORY_FLUID, (size_t)(na > nb ? na : nb), sizeof *line);
    if (walls_a && walls_b) duct(na, da, nb, db, profile);
    if (walls_a) parabola(na, da, line);
    if (walls_b && !walls_a) parabola(nb, db, line);
    for (int l = 0; l < nb; l++)
        for (int j = 0; j < na; j++)
            if (!(walls_a && walls_b)) profile[l * na + j] = walls_a ? line[j] : walls_b ? line[l] : 1.0;
    normalise(na * nb, profile);
    memory_free(line);
}

/* A speed whose square is a number with all digits, m/s; as in a scene (scene/keys/walk_scalar.c). */
static const double FASTEST = 1e150;

/* What is wrong with a file of velocities, and at which of its values, from 1. */
struct complaint {
    enum { NOTHING, UNREADABLE, NO_NUMBER, NOT_FINITE, TOO_FAST, FEWER, MORE } what;
    int at;
};

/* Text, one velocity a line, b fastest. */
static struct complaint read_numbers(const char *path, int na, int nb, double *profile) {
    enum { WORD = 512 };
    FILE *file = plain_file_read(path);
    struct complaint is = {file ? NOTHING : UNREADABLE, 0};
    char word[WORD], *end;
    while (is.what == NOTHING && fscanf(file, "%511s", word) == 1) {
        const double value = strtod(word, &end);
        is.at++;
        if (is.at > na * nb)
            is.what = MORE;
        else if (*end)
            is.what = NO_NUMBER;
        else if (!isfinite(value))
            is.what = NOT_FINITE;
        else if (fabs(value) > FASTEST)
            is.what = TOO_FAST;
        else
            profile[(is.at - 1) % nb * na + (is.at - 1) / nb] = value;
    }
    if (is.what == NOTHING && is.at < na * nb) is.what = FEWER;
    if (file) fclose(file);
    return is;
}

/* Collective. */
static void read_file(const char *path, int na, int nb, double *profile) {
    struct complaint is = {NOTHING, 0};
    if (par_rank() == 0) is = read_numbers(path, na, nb, profile);
    par_bcast(&is, sizeof is, 0);
    switch (is.what) {
    case NOTHING:
        break;
    case UNREADABLE:
        die_all(EXIT_CODE_FILE, "%s: cannot be read", path);
    case NO_NUMBER:
        die_all(
            EXIT_CODE_SCENE,
            "%s: value %d of the inflow's velocities is not a number (it needs one velocity on each line, as in 0.05)",
            path, is.at);
    case NOT_FINITE:
        die_all(EXIT_CODE_SCENE, "%s: value %d of the inflow's velocities is not finite", path, is.at);
    case TOO_FAST:
        die_all(EXIT_CODE_SCENE, "%s: value %d of the inflow's velocities is too large: at most %g m/s", path, is.at,
                FASTEST);
    case FEWER:
        die_all(EXIT_CODE_SCENE, "%s: holds %d values, fewer than the %d x %d velocities of the inflow", path, is.at,
                na, nb);
    case MORE:
        die_all(EXIT_CODE_SCENE, "%s: holds more than the %d x %d velocities of the inflow", path, na, nb);
    }
    par_bcast(profile, (size_t)na * (size_t)nb * sizeof *profile, 0);
}

void fluid_profile_inflow(const struct fluid_input *in, int direction, int side, double *profile) {
    const struct fluid_side *s = &in->side[direction][side];
    int a, b;
    fluid_boundary_others(direction, &a, &b);
    const int count = in->n[a] * in->n[b];
    switch (s->profile) {
    case FLUID_PROFILE_FILE:
        read_file(s->file, in->n[a], in->n[b], profile);
        return;
    case FLUID_POISEUILLE:
        fluid_profile_developed(in, direction, profile);
        for (int i = 0; i < count; i++) profile[i] = s->bulk_velocity * profile[i];
        return;
    case FLUID_UNIFORM:
        for (int i = 0; i < count; i++) profile[i] = s->bulk_velocity;
        return;
    }
    ENSURE(0, "profile %d", (int)s->profile);
}
