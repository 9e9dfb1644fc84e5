/* Solves an element-free plate (solid.method: element_free).  (002) */
#include "base/die.h"
#include "base/memory.h"
#include "base/print.h"
#include "meshless/problem/plate.h"
#include "base/files/log.h"
#include "base/files/table_columns.h"
#include "meshless/galerkin/intensity.h"
#include "meshless/galerkin/solve.h"
#include "meshless/problem/plate_fields.h"
#include "meshless/problem/plate_growth.h"
#include "meshless/problem/solution.h"
#include "meshless/problem/kinds.h"

#include <math.h>
#include <stdio.h>

enum { SENTENCE = 400 };

struct problem {
    const struct scene *scene;
    struct meshless_plate setup;
    struct galerkin *g; /* NULL before its phase */
    struct meshless_plate_growth growth;
};

static int is_asked(const struct scene *scene) { return scene->solid && scene->solid->method == SCENE_ELEMENT_FREE; }

static void *new (const struct scene *scene) {
    struct problem *p = memory_new(MEMORY_SOLID, 1, sizeof *p);
    p->scene = scene;
    return p;
}

static void arrange(void *problem) {
    struct problem *p = problem;
    meshless_plate_begin(p->scene, &p->setup);
    p->g = meshless_galerkin_new(&p->setup.in);
    if (p->scene->solid->element_free->growth) meshless_plate_growth_check(p->scene, p->g);
    const struct scene_intensity *wanted = p->scene->output.intensity;
    if (wanted && p->g->tips == 0) die_all(EXIT_CODE_SCENE, "output.intensity: no end of a crack is inside the body");
    for (int t = 0; wanted && t < p->g->tips; t++)
        for (int k = 0; k < wanted->radii; k++) {
            const double widest = meshless_intensity_widest(p->g, t);
            if (wanted->radius[k] > widest * (1 + 1e-9))
                die_all(EXIT_CODE_SCENE,
                        "output.intensity.radii[%d] = %g: about the tip (%.6g, %.6g) it must be at most %.6g m, so "
                        "that the circle stays in the body and meets one straight crack",
                        k, wanted->radius[k], p->g->tip[t].x[0], p->g->tip[t].x[1], widest);
        }
}

static void solve_plate(struct galerkin *g) {
    meshless_galerkin_solve(g);
    if (!g->solution.converged)
        die_all(EXIT_CODE_UNSTABLE,
                "solid.element_free.iterations = %d: the constraints are still violated by %.3g of the largest "
                "displacement, more than tolerance = %g: take more iterations, a larger penalty or a larger tolerance",
                g->in.iterations, g->solution.violation, g->in.tolerance);
}

static void solve(void *problem) {
    struct problem *p = problem;
    if (p->scene->solid->element_free->growth)
        meshless_plate_growth_run(&p->growth, p->scene, &p->setup, &p->g, solve_plate);
    else
        solve_plate(p->g);
}

static int rows_of(const struct galerkin *g, enum galerkin_row kind) {
    int n = 0;
    for (int r = 0; r < g->rows.rows; r++) n += g->rows.kind[r] == (int)kind;
    return n;
}

/* In plane strain a plate that hardly changes its area locks. The numbers are those of the edge crack of
 * cases/verification/element_free, whose K does not depend on Poisson's ratio. Returns whether the sentence is to be
 * said. */
static int locks(const struct scene *scene, char sentence[SENTENCE]) {
    static const double MOST = 0.45;
    const double ratio = scene->solid->material[0].poisson_ratio;
    if (scene->solid->model != PHYSICS_PLANE_STRAIN || !(ratio > MOST)) return 0;
    snprintf(
        sentence, SENTENCE,
        "solid.materials[0].poisson_ratio = %g in plane strain: the nodes lock near 0.5. K of an edge crack is too "
        "small by 0.7 %% at 0.45, 3 %% at 0.49 and 9 to 13 %% at 0.499 with 320 nodes, and by 0.3, 0.9 and up to 3 "
        "%% with 1400: halve solid.spacing to see how much it is here",
        ratio);
    return 1;
}

static void check(const void *problem) {
    const struct galerkin *g = ((const struct problem *)problem)->g;
    const struct scene_growth *growth = ((const struct problem *)problem)->scene->solid->element_free->growth;
    print("  nodes      %d, supports up to %.6g m\n", g->in.nodes, g->widest);
    print("  unknowns   %d, half bandwidth %d\n", 2 * g->in.nodes, g->half_band);
    print("  constraints %d: %d of given displacements, %d of jumps and %d of strains across extensions\n",
          g->rows.rows, rows_of(g, GALERKIN_ROW_FIXED), rows_of(g, GALERKIN_ROW_JUMP), rows_of(g, GALERKIN_ROW_STRAIN));
    print("  cells      %d pieces, %ld Gauss points\n", g->cells.pieces, g->cells.points);
    for (int t = 0; t < g->tips; t++)
        print("  tip        (%.6g, %.6g) m, extension %.6g m, radii up to %.6g m\n", g->tip[t].x[0], g->tip[t].x[1],
              g->line[g->tip[t].line].reach[g->tip[t].end], meshless_intensity_widest(g, t));
    if (growth)
        print("  growth     at most %d steps of %.6g m, %.3g nodal spacings at the tip\n", growth->steps, growth->step,
              growth->step / ldexp(g->in.spacing, -g->in.levels));
    print("  band       %.3g MB, allocated when it is solved\n",
          2e-6 * g->in.nodes * (g->half_band + 1.0) * sizeof(double));
    char sentence[SENTENCE];
    if (locks(((const struct problem *)problem)->scene, sentence)) print("  warning: %s\n", sentence);
}

static void write_intensity(const struct problem *p, const char *folder) {
    static const char columns[] = "tip 1|x m|y m|radius m|K_I Pa m^0.5|K_II Pa m^0.5|J J/m2|K_J Pa m^0.5|T Pa";
    const struct scene_intensity *wanted = p->scene->output.intensity;
    struct table *table = table_columns_new(folder, "intensity.csv", columns, 2, -1);
    for (int t = 0; t < p->g->tips; t++)
        for (int k = 0; k < wanted->radii; k++) {
            const struct galerkin_intensity is = meshless_intensity_of(p->g, t, wanted->radius[k]);
            table_row(table, (const double[]){t, p->g->tip[t].x[0], p->g->tip[t].x[1], wanted->radius[k], is.k[0],
                                              is.k[1], is.j, is.k_j, is.t});
        }
    table_free(table);
}

/* Numbers of the solution, with K of the last tip by the last radius. */
static void write(const void *problem, const struct scene *scene, const char *folder) {
    const struct problem *p = problem;
    const struct galerkin *g = p->g;
    char sentence[SENTENCE];
    if (locks(scene, sentence)) log_line("warning: %s", sentence);
    struct meshless_solution_quantity fact[16] = {{"nodes", "1", g->in.nodes},
                                                  {"unknowns", "1", 2.0 * g->in.nodes},
                                                  {"constraints", "1", g->rows.rows},
                                                  {"gauss_points", "1", (double)g->cells.points},
                                                  {"iterations", "1", g->solution.iterations},
                                                  {"violation", "1", g->solution.violation},
                                                  {"equilibrium", "1", g->solution.equilibrium},
                                                  {"energy", "J", g->solution.energy}};
    int n = 8;
    if (scene->output.intensity) {
        const double radius = scene->output.intensity->radius[scene->output.intensity->radii - 1];
        const struct galerkin_intensity is = meshless_intensity_of(g, g->tips - 1, radius);
        fact[n++] = (struct meshless_solution_quantity){"K_I", "Pa m^0.5", is.k[0]};
        fact[n++] = (struct meshless_solution_quantity){"K_II", "Pa m^0.5", is.k[1]};
        fact[n++] = (struct meshless_solution_quantity){"J", "J/m2", is.j};
        fact[n++] = (struct meshless_solution_quantity){"K_J", "Pa m^0.5", is.k_j};
        fact[n++] = (struct meshless_solution_quantity){"T", "Pa", is.t};
        write_intensity(p, folder);
    }
    if (scene->solid->element_free->growth) meshless_plate_growth_write(&p->growth, folder);
    meshless_solution_write(n, fact, folder);
    if (scene->output.fields_every > 0) meshless_plate_fields_write(g, folder);
}

static void write_json(const void *problem, struct json *j) {
    const struct galerkin *g = ((const struct problem *)problem)->g;
    json_long(j, "nodes", g->in.nodes);
    json_long(j, "unknowns", 2L * g->in.nodes);
    json_long(j, "half_bandwidth", g->half_band);
    json_long(j, "constraints", g->rows.rows);
    json_long(j, "pieces", g->cells.pieces);
    json_long(j, "gauss_points", g->cells.points);
    json_long(j, "iterations", g->solution.iterations);
    json_number(j, "violation", g->solution.violation);
    json_number(j, "equilibrium", g->solution.equilibrium);
    json_array(j, "violations");
    for (int k = 0; k < g->solution.iterations; k++) json_number(j, NULL, g->solution.history[k]);
    json_close(j);
    if (((const struct problem *)problem)->growth.rows > 0)
        meshless_plate_growth_write_json(&((const struct problem *)problem)->growth, j);
}

static void free_problem(void *problem) {
    struct problem *p = problem;
    meshless_galerkin_free(p->g);
    meshless_plate_growth_free(&p->growth);
    meshless_plate_end(&p->setup);
    memory_free(p);
}

static const struct meshless_problem_phase phase[] = {{"arrange", arrange}, {"solve", solve}, {NULL, NULL}};

const struct meshless_problem meshless_problem_element_free = {
    .file = {"intensity.csv", "growth.csv", "crack_lines.csv"},
    .is_asked = is_asked,
    .new = new,
    .phase = phase,
    .checked = 1,
    .check = check,
    .write = write,
    .write_json = write_json,
    .free = free_problem};
