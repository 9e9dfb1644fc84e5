/* Scene of the main case's porous block, for the bench. */
#include "program/bench/scene.h"
#include "base/ensure.h"
#include "scene/read.h"

#include <stdio.h>
#include <string.h>

static const char text[] =
    "title: The main case's block, for its time\n"
    "domain: {size: [%g, %g, %g], cells: [%d, %d, %d]}\n"
    "fluid:\n"
    "  density: 1000\n"
    "  viscosity: 1.0e-3\n"
    "  initial: {velocity: [0.1, 0, 0]}\n"
    "  sides:\n"
    "    x_low: {type: inflow, profile: poiseuille, bulk_velocity: 0.1}\n"
    "    x_high: {type: outflow}\n"
    "    y_low: {type: wall}\n"
    "    y_high: {type: wall}\n"
    "    z_low: {type: periodic}\n"
    "    z_high: {type: periodic}\n"
    "solid:\n"
    "  materials:\n"
    "    - {name: ceramic, youngs_modulus: 1.0e8, density: 3000, horizon_ratio: 3, fracture_energy: 1.0e6}\n"
    "  bodies:\n"
    "    - {name: block, material: ceramic, shape: box, low: [%.9g, -0.0046875, 0], high: [%.9g, %.9g, "
    "%.9g],\n"
    "       cavities: {period: 0.025, radius: 0.014325, centre: [%.9g, 0, 0]}}\n"
    "  constraints:\n"
    "    - {low: [0, -0.01, 0], high: [1, 0, 1], directions: xyz}\n"
    "    - {low: [0, %.9g, 0], high: [1, 1, 1], directions: xyz}\n"
    "coupling: {load: %s}\n"
    "stages:\n"
    "  - {name: flow, steps: 20, time_step: 3.3569e-4, solid: rigid}\n"
    "  - {name: elastic, steps: 1000000, time_step: 3.3569e-5, breakage: %s, integrator: %s,\n"
    "     fluid_integrator: %s,\n"
    "     safety: 0.97, damping_absolute: 2000, damping_relative: 1.0e15}\n";

struct scene *bench_scene_new(const struct bench_scene *b) {
    char filled[4096];
    struct scene_problems problems = {0};
    const double f = b->half ? 0.5 : 1;
    const double low = 0.025 * f, high = 0.1 * f, h = 0.1 * f;
    snprintf(filled, sizeof filled, text, 0.2 * f, h, h, (int)(128 * f), (int)(64 * f), (int)(64 * f), low, high,
             h + 0.0046875, h, low + 0.000234375, h, b->reaction ? "reaction" : "probe", b->breakage ? "true" : "false",
             b->rk3 ? "rk3" : "verlet", b->ab2 ? "ab2" : "rk3");
    struct scene *scene = scene_read("the bench's scene", filled, strlen(filled), 0, NULL, 0, &problems);
    ENSURE(scene, "%s", problems.n ? problems.text[0] : "no scene");
    scene_problem_free(&problems);
    return scene;
}
