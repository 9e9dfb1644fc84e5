/* frana check: prints parts of the run, stable steps and their limits, memory, dimensionless groups, costs. Takes
 * no step, unless it is to measure some. */
#include "program/check/check.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/print.h"
#include "coupling/interface/near_outflow.h"
#include "coupling/interface/ratio.h"
#include "coupling/interface/standing.h"
#include "coupling/march.h"
#include "coupling/setup/forecast.h"
#include "coupling/setup/pores.h"
#include "program/check/costs.h"
#include "program/check/parts.h"
#include "program/output/outputs.h"
#include "program/check/groups.h"

static void print_memory(void) {
    double most[MEMORY_PARTS + 1], sum = 0;
    for (int p = 0; p < MEMORY_PARTS; p++) sum += most[p] = (double)memory_bytes((enum memory_part)p);
    most[MEMORY_PARTS] = sum;
    par_max_array(most, MEMORY_PARTS + 1);
    print("\nmemory per rank, MB (largest of %d)\n", par_size());
    for (int p = 0; p < MEMORY_PARTS; p++) print("  %-10s %.1f\n", memory_name((enum memory_part)p), most[p] * 1e-6);
    const double share = par_min(forecast_share());
    print("  %-10s %.1f, and the libraries' own; of %.0f that a rank has here\n", "in all", most[MEMORY_PARTS] * 1e-6,
          share * 1e-6);
    if (most[MEMORY_PARTS] > share) print("  warning: the run needs more memory than there is: other ranks or nodes\n");
}

/* Memory of a run by its size, GB: 464 bytes a particle with its bonds, and 18 more where a body is of several
 * materials; 200 a particle at rest while it is made, measured with samples of rock; 260 a cell of the fluid, an
 * estimate. */
static double gigabytes_of(const struct scene *scene, double particles) {
    const int bonds = setup_needs_of(scene).bonds;
    double cells = scene->fluid ? 1 : 0, bytes = bonds ? 464 : 200;
    for (int c = 0; c < 3; c++) cells *= scene->domain.cells[c];
    for (int b = 0; scene->solid && b < scene->solid->bodies; b++)
        if (bonds && scene->solid->body[b].image.kinds > 1) bytes = 464 + 18;
    return 1e-9 * (bytes * particles + 260 * cells);
}

/* Whether a body of an image makes the run larger than this machine's memory for so many ranks; if so, says it, and
 * before that what frana permeability takes. Collective. */
static int is_too_large(const struct scene *scene, double particles) {
    const double share = 1e-9 * par_min(forecast_share());
    const double needed = gigabytes_of(scene, particles) / par_size();
    if (particles == 0 || share >= needed) return 0;
    const int is_rigid = setup_needs_of(scene).immersed && !setup_pores_why(scene);
    struct stokes_mask *m = is_rigid ? setup_pores(scene, 1) : NULL;
    print("\nforecast\n");
    if (m) check_intrinsic_print_at_once((double)m->before[(long)m->n[1] * m->n[2]], "what follows is");
    stokes_mask_free(m);
    print("  %-10s some %.3g GB a rank on %d rank%s; this machine has %.3g GB a rank. Stable steps and what else needs "
          "the "
          "particles is left out: check the scene on more ranks, or a crop of the image.\n",
          "memory", needed, par_size(), par_size() > 1 ? "s" : "", share);
    return 1;
}

/* Whether the scene is a solid in cells that are not cubes, of which only the creeping flow is solved; if so, says it.
 * Collective. */
static int is_only_solved(const struct scene *scene) {
    if (!setup_needs_of(scene).immersed || setup_check_are_cubes(scene)) return 0;
    const char *why = setup_pores_why(scene);
    if (why) die_all(EXIT_CODE_SCENE, "domain.cells: must be cubes, because %s", why);
    struct stokes_mask *m = setup_pores(scene, 1);
    print("\nThe cells are not cubes: frana run refuses the scene, frana permeability solves the creeping flow.\n");
    check_intrinsic_print_at_once((double)m->before[(long)m->n[1] * m->n[2]], NULL);
    stokes_mask_free(m);
    return 1;
}

/* Bodies whose particles fit the cells badly, that are close before a side through which the flow leaves, or on a wall.
 */
static void print_places(const struct run *r) {
    char sentence[NEAR_OUTFLOW_MAX][NEAR_OUTFLOW_SENTENCE], standing[STANDING_SENTENCE], ratio[RATIO_SENTENCE];
    struct standing stand[PHYSICS_BODIES_MAX];
    if (!r->solid) return;
    if (ratio_of(r, ratio)) print("\n  warning: %s\n", ratio);
    standing_measure(r, 1, stand);
    for (int b = 0; b < r->solid->in.bodies; b++) {
        for (int k = 0, n = near_outflow_of(r, b, sentence); k < n; k++) print("\n  warning: %s\n", sentence[k]);
        if (standing_of(r, b, stand, standing)) print("\n  %s\n", standing);
    }
}

int check_scene(const struct command *c, const struct scene *scene) {
    const double particles = check_image(c, scene);
    if (is_only_solved(scene)) return EXIT_CODE_DONE;
    if (is_too_large(scene, particles)) return EXIT_CODE_DONE;
    struct run *r = run_new(scene);
    struct costs costs = {0};
    struct outputs *outputs = outputs_new(r); /* dies on what does not fit; they take memory */
    struct march *march = march_new(r);       /* the kept state takes memory */
    check_holdings_print(r);
    check_limits_print(r, &costs);
    print_memory();
    march_free(march);
    check_groups_print(r);
    print_places(r);
    check_strength_print(r, costs.moves_from, costs.seconds);
    costs_print(&costs, r, outputs, c->out, c->measure);
    check_sizes_print(r, costs.seconds);
    check_gaps_print(scene);
    outputs_free(outputs);
    run_free(r);
    return EXIT_CODE_DONE;
}
