/* Solves the nonlocal boundary-value problem of a scene with the section `nonlocal`.  (004) */
#include "base/memory.h"
#include "base/par.h"
#include "base/print.h"
#include "base/files/folder.h"
#include "base/files/vtkhdf.h"
#include "meshless/nonlocal/condition.h"
#include "meshless/nonlocal/nonlocal.h"
#include "meshless/problem/solution.h"
#include "meshless/problem/kinds.h"

struct problem {
    const struct scene_nonlocal *scene;
    struct meshless_nonlocal *n; /* NULL before its first phase */
};

static int is_asked(const struct scene *scene) { return scene->nonlocal != NULL; }

static void *new (const struct scene *scene) {
    struct problem *p = memory_new(MEMORY_SOLID, 1, sizeof *p);
    p->scene = scene->nonlocal;
    return p;
}

static void arrange(void *problem) {
    struct problem *p = problem;
    const struct scene_nonlocal *s = p->scene;
    p->n =
        meshless_nonlocal_new(&(struct meshless_nonlocal_input){.dimension = s->dimension,
                                                                .exponent = s->exponent,
                                                                .horizon = s->horizon,
                                                                .inner = s->inner_radius,
                                                                .outer = s->outer_radius,
                                                                .points = {.kind = s->arrangement.kind,
                                                                           .volume = s->arrangement.volume,
                                                                           .spacing = s->spacing,
                                                                           .points = s->points,
                                                                           .perturbation = s->arrangement.perturbation,
                                                                           .seed = s->arrangement.seed}});
}

static void assemble(void *problem) { meshless_nonlocal_assemble(((struct problem *)problem)->n); }
static void solve(void *problem) { meshless_nonlocal_solve(((struct problem *)problem)->n); }
static void measure(void *problem) { meshless_nonlocal_measure(((struct problem *)problem)->n); }

static void condition(void *problem) {
    const struct problem *p = problem;
    if (p->scene->condition) p->n->condition = meshless_condition(p->n->matrix);
}

static void check(const void *problem) {
    const struct meshless_nonlocal *n = ((const struct problem *)problem)->n;
    const double rows = (double)n->matrix->rows_global;
    print("  points     %ld, spacing %.6g m, horizon %.6g spacings\n", n->points->n, n->points->spacing,
          n->in.horizon / n->points->spacing);
    print("  unknowns   %.0f, and %ld given values\n", rows, n->points->n - n->matrix->rows_global);
    print("  matrix     %ld entries, %.4g a row, by conjugate gradients\n", n->matrix->entries,
          (double)n->matrix->entries / rows);
}

/* u and its error at all points, each rank a part of them. */
static void write_fields(const struct meshless_nonlocal *n, const char *folder) {
    const struct meshless_points *p = n->points;
    const long from = p->n * par_rank() / par_size(), to = p->n * (par_rank() + 1) / par_size(), local = to - from;
    double *all = memory_new(MEMORY_OUTPUT, (size_t)p->n + 1, sizeof *all),
           *error = memory_new(MEMORY_OUTPUT, (size_t)local + 1, sizeof *error),
           (*x)[3] = memory_new(MEMORY_OUTPUT, (size_t)local + 1, sizeof *x);
    for (int i = 0; i < n->matrix->rows; i++) all[n->matrix->point[i]] = n->u[i];
    par_sum_array(all, (int)p->n);
    for (long i = from; i < to; i++) {
        for (int c = 0; c < p->dim; c++) x[i - from][c] = p->x[c][i];
        if (!n->free[i]) all[i] = meshless_nonlocal_exact(n, i);
        error[i - from] = all[i] - meshless_nonlocal_exact(n, i);
    }
    char path[FOLDER_PATH];
    struct vtkhdf *f =
        vtkhdf_points_begin(&(struct vtkhdf_points_input){.path = folder_path(path, folder, "fields/solution.hdf"),
                                                          .n = local,
                                                          .x = (const double(*)[3])(const void *)x,
                                                          .wide = 1});
    vtkhdf_add(f, "u", 1, all + from);
    vtkhdf_add(f, "error", 1, error);
    vtkhdf_add(f, "volume", 1, p->volume + from);
    vtkhdf_add_byte(f, "solved", 1, (const uint8_t *)n->free + from);
    vtkhdf_end(f);
    MEMORY_FREE(x, error, all);
}

static void write(const void *problem, const struct scene *scene, const char *folder) {
    const struct meshless_nonlocal *n = ((const struct problem *)problem)->n;
    const struct meshless_solution_quantity fact[] = {
        {"points", "1", (double)n->points->n},
        {"unknowns", "1", (double)n->matrix->rows_global},
        {"spacing", "m", n->points->spacing},
        {"horizon_ratio", "1", n->in.horizon / n->points->spacing},
        {"neighbours", "1", (double)n->matrix->entries / (double)n->matrix->rows_global - 1},
        {"operator_error", "1", n->operator_mean},
        {"operator_error_max", "1", n->operator_max},
        {"error_linf", "m2", n->error_linf},
        {"error_l2", "1", n->error_l2},
        {"lloyd_iterations", "1", n->points->iterations},
        {"condition", "1", n->condition}};
    meshless_solution_write((int)(sizeof fact / sizeof *fact) - !(n->condition > 0), fact, folder);
    if (scene->output.fields_every > 0) write_fields(n, folder);
}

static void write_json(const void *problem, struct json *j) {
    const struct meshless_nonlocal *n = ((const struct problem *)problem)->n;
    json_long(j, "points", n->points->n);
    json_long(j, "unknowns", n->matrix->rows_global);
    json_long(j, "matrix_entries", n->matrix->entries);
    json_long(j, "iterations", n->solved.iterations);
    json_number(j, "residual", n->solved.residual);
    if (n->points->iterations > 0) {
        json_long(j, "lloyd_iterations", n->points->iterations);
        json_number(j, "lloyd_energy", n->points->energy[n->points->iterations]);
    }
}

static void free_problem(void *problem) {
    struct problem *p = problem;
    meshless_nonlocal_free(p->n);
    memory_free(p);
}

static const struct meshless_problem_phase phase[] = {{"arrange", arrange}, {"assemble", assemble},   {"solve", solve},
                                                      {"measure", measure}, {"condition", condition}, {NULL, NULL}};

const struct meshless_problem meshless_problem_nonlocal = {.is_asked = is_asked,
                                                           .new = new,
                                                           .phase = phase,
                                                           .checked = 2,
                                                           .check = check,
                                                           .write = write,
                                                           .write_json = write_json,
                                                           .free = free_problem};
