/* Scenes of the test of the state: between them they have every variable of it. */
#pragma once
#include "tests/coupling/scene_of.h"

/* A block in a periodic flow: no side's condition sets any of the fields when a checkpoint is read. */
static const char *const flow =
    "title: test\n"
    "domain: {size: [0.16, 0.08, 0.08], cells: [32, 16, 16]}\n"
    "fluid:\n"
    "  density: 1000\n"
    "  viscosity: 1.0e-3\n"
    "  initial: {velocity: [0.1, 0, 0]}\n"
    "  driving: {type: bulk_velocity, direction: x, value: 0.1}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
    "  materials:\n"
    "    - {name: soft, youngs_modulus: 1.0e6, density: 3000, fracture_energy: 1.0}\n"
    "  bodies:\n"
    "    - {name: block, material: soft, shape: box, low: [0.06, 0.02, 0.02], high: [0.09, 0.055, 0.06]}\n"
    "coupling: {medium: {low: [0, 0, 0], high: [0.16, 0.08, 0.08]}}\n"
    "stages:\n"
    "  - {name: first, steps: 100, time_step: 1.0e-3, integrator: verlet}\n"
    "  - {name: second, steps: 100, time_step: 1.0e-3, integrator: verlet, until: {quantity: rest}}\n";

/* Two blocks in contact, under a load; of a Poisson's ratio that takes two passes. */
static const char *const blocks =
    "title: test\n"
    "domain: {size: [0.2, 0.1, 0.1]}\n"
    "solid:\n"
    "  spacing: 0.005\n"
    "  materials:\n"
    "    - {name: soft, youngs_modulus: 1.0e7, density: 1000, fracture_energy: 0.05,\n"
    "       poisson_ratio: 0.35, breakage: {law: bilinear, tensile_strength: 2500}}\n"
    "  bodies:\n"
    "    - {name: left, material: soft, shape: box, low: [0.05, 0.03, 0.03], high: [0.09, 0.06, 0.06]}\n"
    "    - {name: right, material: soft, shape: box, low: [0.1, 0.04, 0.04], high: [0.13, 0.07, 0.07]}\n"
    "  constraints:\n"
    "    - {low: [0.12, 0.04, 0.04], high: [0.13, 0.07, 0.07], velocity: [-5, 0, 0], time: [[0, 1], [1.0e-2, 2]]}\n"
    "  loads:\n"
    "    - {low: [0.05, 0.03, 0.03], high: [0.06, 0.06, 0.06], force: [1.0e7, 0, 0], time: [[0, 0], [1.0, 2]],\n"
    "       time_from: first}\n"
    "stages:\n"
    "  - {name: first, steps: 1000, time_step: 5.0e-5, integrator: verlet}\n"
    "  - {name: second, steps: 1000, time_step: 5.0e-5, integrator: verlet}\n";

/* A plate that is refined by hand. */
static const char *const plate =
    "title: test\n"
    "domain: {size: [0.06, 0.04]}\n"
    "solid:\n"
    "  spacing: 0.002\n"
    "  model: plane_stress\n"
    "  thickness: 0.002\n"
    "  materials:\n"
    "    - {name: glass, youngs_modulus: 7.2e10, density: 2235, fracture_energy: 20}\n"
    "  bodies:\n"
    "    - {name: plate, material: glass, shape: rectangle, low: [0, 0], high: [0.06, 0.04]}\n"
    "  refinement: {levels: 1, damage: 0.3, from: 1}\n"
    "stages:\n"
    "  - {name: first, steps: 1000, time_step: 5.0e-8, integrator: verlet}\n"
    "  - {name: second, steps: 1000, time_step: 5.0e-8, integrator: verlet}\n";

/* A plate with a notch that fluid is pumped into. */
static const char *const cracked = "title: test\n"
                                   "domain: {size: [0.03, 0.03]}\n"
                                   "solid:\n"
                                   "  spacing: 1.0e-3\n"
                                   "  model: plane_strain\n"
                                   "  thickness: 1.0e-3\n"
                                   "  materials: [{name: rock, youngs_modulus: 2.0e10, density: 2500}]\n"
                                   "  bodies: [{shape: rectangle, low: [0, 0], high: [0.03, 0.03]}]\n"
                                   "  cracks: [{points: [[0.01, 0.015], [0.02, 0.015]]}]\n"
                                   "crack_fluid:\n"
                                   "  viscosity: 1.0e-3\n"
                                   "  leak_off: 1.0e-6\n"
                                   "  least_aperture: 1.0e-8\n"
                                   "  injections: [{low: [0.014, 0.012], high: [0.016, 0.018], rate: 1.0e-5}]\n"
                                   "stages:\n"
                                   "  - {name: first, steps: 1000, integrator: verlet, crack_fluid: true}\n"
                                   "  - {name: second, steps: 1000, integrator: verlet, crack_fluid: true}\n";

/* A block in a flow, with a notch that is open to it. */
static const char *const open_notch =
    "title: test\n"
    "domain: {size: [0.12, 0.08, 0.08], cells: [24, 16, 16]}\n"
    "fluid:\n"
    "  density: 1000\n"
    "  viscosity: 1.0e-3\n"
    "  initial: {velocity: [0.1, 0, 0]}\n"
    "  driving: {type: bulk_velocity, direction: x, value: 0.1}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
    "  materials: [{name: soft, youngs_modulus: 1.0e6, density: 3000}]\n"
    "  bodies: [{material: soft, shape: box, low: [0.04, 0.02, 0.02], high: [0.08, 0.06, 0.06]}]\n"
    "  cracks: [{points: [[0.03, 0.04, 0.01], [0.06, 0.04, 0.01], [0.06, 0.04, 0.07], [0.03, 0.04, 0.07]]}]\n"
    "coupling: {load: probe, medium: {low: [0, 0, 0], high: [0.12, 0.08, 0.08]}}\n"
    "crack_fluid:\n"
    "  least_pressure: -1.0e5\n"
    "  least_aperture: 1.0e-5\n"
    "  injections: [{low: [0.04, 0.03, 0.03], high: [0.05, 0.05, 0.05], rate: 1.0e-9}]\n"
    "stages:\n"
    "  - {name: first, steps: 100, time_step: 1.0e-3, integrator: verlet, crack_fluid: true}\n"
    "  - {name: second, steps: 100, time_step: 1.0e-3, integrator: verlet, crack_fluid: true}\n";

/* A block that an indenter moves into, whose limits of the stretch follow the other bonds. */
static const char *const indented =
    "title: test\n"
    "domain: {size: [12, 12, 12]}\n"
    "solid:\n"
    "  spacing: 1\n"
    "  materials:\n"
    "    - {name: glass, youngs_modulus: 1, density: 1, breakage: {law: brittle, s00: 0.01, alpha: 0.25}}\n"
    "  bodies: [{shape: box, low: [2, 2, 2], high: [10, 8, 10]}]\n"
    "  indenters: [{shape: sphere, centre: [6, 9.9, 6], radius: 2, velocity: [0, -0.1, 0], stiffness: 1}]\n"
    "stages:\n"
    "  - {name: first, steps: 100, time_step: 0.3, integrator: verlet}\n"
    "  - {name: second, steps: 100, time_step: 0.3, integrator: verlet}\n";
