/* Velocity profiles through a section: inflow profiles and the developed channel or duct flow. */
#include "fluid/grid/profile.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
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
    memory_free(lambda);
    memory_free(b);
    memory_free(diagonal);
    memory_free(beside);
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

/* Text, one velocity a line, b fastest. */
static void read_file(const char *path, int na, int nb, double *profile) {
    int read = 0, more = 0, wrong = 0;
    if (par_rank() == 0) {
        FILE *file = fopen(path, "r");
        double value;
        if (!file) read = -1;
        while (file && read < na * nb && fscanf(file, "%lf", &value) == 1) {
            profile[(read % nb) * na + read / nb] = value;
            read++;
            if (!isfinite(value) && wrong == 0) wrong = read;
        }
        if (file) {
            more = fscanf(file, "%lf", &value) == 1;
            fclose(file);
        }
    }
    par_bcast(&read, sizeof read, 0);
    par_bcast(&more, sizeof more, 0);
    par_bcast(&wrong, sizeof wrong, 0);
    if (read < 0) die_all(EXIT_CODE_FILE, "%s: cannot be read", path);
    if (wrong > 0) die_all(EXIT_CODE_SCENE, "%s: number %d of the inflow's velocities is not finite", path, wrong);
    if (read < na * nb || more)
        die_all(EXIT_CODE_SCENE, "%s: holds %s than the %d x %d velocities of the inflow", path,
                more ? "more" : "fewer", na, nb);
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
