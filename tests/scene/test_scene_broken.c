/* Each mistake in a scene is reported in its own line, and all of them at once. */
#include "base/par.h"
#include "tests/leaves.h"
#include "tests/scene/scene_sample.h"

/* clang-format off */
static const struct sample_broken table[] = {
    /* the text as YAML */
    {"fluid", "  density: 1\n", "\tdensity: 1\n",
     "it.yaml:3: not valid YAML: while scanning for the next token: found character that cannot start any token "
     "(the line is indented by a tab: use spaces)"},
    {"fluid", "[1, 2, 0.5]", "[1, 2, 0.5",
     "it.yaml:1: not valid YAML: while parsing a flow sequence: did not find expected ',' or ']'"},
    {"fluid", "density: 1", "density: *one", "it.yaml:3: an alias (*one) is not read in a scene: write the value out"},
    {"fluid", "density: 1", "density: 1\n  density: 2", "it.yaml:4: fluid.density: is given twice, first on line 3"},
    {"fluid", "steps: 10}", "steps: 10}\n---\ndomain: 1", "it.yaml:14: a second document begins: a scene is one"},
    {"fluid", "density: 1", "[a, b]: 1", "it.yaml:3: a key must be a word"},
    {"fluid", "density: 1", "density: [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]",
     "it.yaml:3: lists and mappings are nested more than 32 deep"},
    {"fluid", "density: 1", "density: \"1\\0\"", "it.yaml:3: a text holds a zero byte"},
    /* keys */
    {"coupled", "viscosity", "viscosty", "it.yaml:7: fluid.viscosty: unknown key; did you mean viscosity?"},
    {"coupled", "stages:", "stagse:", "it.yaml:41: stagse: unknown key; did you mean stages?"},
    {"coupled", "damping_absolute", "dampng_absolute",
     "it.yaml:43: stages[1].dampng_absolute: unknown key; did you mean damping_absolute?"},
    {"coupled", "title: A", "weather: A",
     "it.yaml:1: weather: unknown key; known here: title, domain, fluid, solid, coupling, crack_fluid, nonlocal, stages, output"},
    {"coupled", "  density: 1000\n", "", "it.yaml:5: fluid.density: missing (kg/m3)"},
    {"coupled", "    x_high: {type: outflow}\n", "", "it.yaml:9: fluid.sides.x_high: missing"},
    {"coupled", "  cells: [40, 20, 20]\n", "", "it.yaml:2: domain.cells: missing; a scene with a fluid needs it"},
    {"coupled", "name: ceramic, ", "", "it.yaml:20: solid.materials[0].name: missing"},
    {"coupled", ", steps: 100, time_step: auto", "", "it.yaml:42: stages[0].steps: missing"},
    {"fluid", "stages:\n  - {name: start-up, steps: 10}\n", "", "it.yaml:1: stages: missing"},
    /* types */
    {"coupled", "density: 1000", "density: heavy",
     "it.yaml:6: fluid.density = heavy: must be a number, greater than 0 (kg/m3)"},
    {"coupled", "density: 1000", "density: \"1000\"",
     "it.yaml:6: fluid.density = \"1000\": must be a number, greater than 0 (kg/m3)"},
    {"coupled", "density: 1000", "density: 0x10",
     "it.yaml:6: fluid.density = 0x10: must be a number, greater than 0 (kg/m3)"},
    {"coupled", "density: 1000", "density: .nan",
     "it.yaml:6: fluid.density = .nan: must be a number, greater than 0 (kg/m3)"},
    {"coupled", "density: 1000", "density: 1e999", "it.yaml:6: fluid.density = 1e999: is too large: at most 1e+300"},
    {"coupled", "density: 1000", "density:", "it.yaml:6: fluid.density: must be a number, greater than 0 (kg/m3)"},
    {"coupled", "size: [0.04, 0.02, 0.02]", "size: [0.04, 0.02]",
     "it.yaml:3: domain.size = [0.04, 0.02]: must be a list of 3 numbers (m): a plate, of 2, has no fluid yet"},
    {"coupled", "size: [0.04, 0.02, 0.02]", "size: 0.04",
     "it.yaml:3: domain.size = 0.04: must be a list of 3 numbers (m)"},
    {"coupled", "cells: [40, 20, 20]", "cells: [40, 20.5, 20]",
     "it.yaml:4: domain.cells[1] = 20.5: must be a whole number, between 1 and 1000000"},
    {"coupled", "steps: 100, time_step: auto", "steps: 1e3",
     "it.yaml:42: stages[0].steps = 1e3: must be a whole number, at least 0"},
    {"coupled", "breakage: false", "breakage: 0", "it.yaml:43: stages[1].breakage = 0: must be true or false"},
    {"coupled", "x_high: {type: outflow}", "x_high: {type: outflw}",
     "it.yaml:11: fluid.sides.x_high.type = outflw: must be one of periodic, wall, slip, inflow, outflow, pressure, "
     "general; did you mean outflow?"},
    {"coupled", "x_high: {type: outflow}", "x_high: outflow",
     "it.yaml:11: fluid.sides.x_high = outflow: must be a mapping of keys to values"},
    {"coupled", "name: flow", "name: \"\"", "it.yaml:42: stages[0].name: must be a text, is empty"},
    {"coupled", "name: flow", "name: aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa",
     "it.yaml:42: stages[0].name = aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa...: is too long: 72 "
     "characters, at most 63"},
    {"coupled", "contact: {enabled: true, stiffness: 15}", "contact: true",
     "it.yaml:37: solid.contact = true: must be a mapping of keys to values"},
    {"coupled", "time_step: auto", "time_step: soon",
     "it.yaml:42: stages[0].time_step = soon: must be a number, greater than 0 (s), or auto"},
    {"fluid", "stages:\n  - {name: start-up, steps: 10}", "stages: []",
     "it.yaml:12: stages: is empty: needs at least one entry"},
    {"fluid", "stages:\n  - {name: start-up, steps: 10}", "stages: {name: start-up, steps: 10}",
     "it.yaml:12: stages: must be a list of mappings"},
    /* ranges */
    {"fluid", "steps: 10", "steps: 99999999999999999999",
     "it.yaml:13: stages[0].steps = 99999999999999999999: is too large"},
    {"fluid", "cells: [8, 16, 4]", "cells: [8, 16, 40000000]",
     "it.yaml:1: domain.cells[2] = 40000000: must be between 1 and 1000000"},
    {"coupled", "density: 1000", "density: -1000", "it.yaml:6: fluid.density = -1000: must be greater than 0"},
    {"coupled", "viscosity: 1.0e-3", "viscosity: 0", "it.yaml:7: fluid.viscosity = 0: must be greater than 0"},
    {"coupled", "cells: [40, 20, 20]", "cells: [40, 0, 20]",
     "it.yaml:4: domain.cells[1] = 0: must be between 1 and 1000000"},
    {"coupled", "size: [0.04, 0.02, 0.02]", "size: [0.04, -0.02, 0.02]",
     "it.yaml:3: domain.size[1] = -0.02: must be greater than 0"},
    {"coupled", "bulk_velocity: 0.1", "bulk_velocity: -0.1",
     "it.yaml:10: fluid.sides.x_low.bulk_velocity = -0.1: must be greater than 0"},
    {"coupled", "youngs_modulus: 1.0e8", "youngs_modulus: 0",
     "it.yaml:20: solid.materials[0].youngs_modulus = 0: must be greater than 0"},
    {"coupled", "fracture_energy: 0.05", "fracture_energy: 0",
     "it.yaml:20: solid.materials[0].fracture_energy = 0: must be greater than 0, or .inf"},
    {"coupled", "horizon_ratio: 2", "horizon_ratio: 0.5",
     "it.yaml:21: solid.materials[1].horizon_ratio = 0.5: must be at least 1 and less than 4.5"},
    {"coupled", "horizon_ratio: 2", "horizon_ratio: 4.5",
     "it.yaml:21: solid.materials[1].horizon_ratio = 4.5: must be at least 1 and less than 4.5"},
    {"coupled", "radius: 0.004", "radius: 0", "it.yaml:29: solid.bodies[1].radius = 0: must be greater than 0"},
    {"coupled", "forcing_iterations: 2", "forcing_iterations: 0",
     "it.yaml:39: coupling.forcing_iterations = 0: must be between 1 and 100"},
    {"coupled", "forcing_iterations: 2", "retraction: 1.5",
     "it.yaml:39: coupling.retraction = 1.5: must be between -1 and 1"},
    {"coupled", "forcing_iterations: 2", "load: prob",
     "it.yaml:39: coupling.load = prob: must be one of reaction, probe; did you mean probe?"},
    {"coupled", "forcing_iterations: 2", "load: wall",
     "it.yaml:39: coupling.load = wall: no longer a load, leave it out: reaction, the default, goes with crack_fluid and "
     "with fluid.diffusion: implicit too"},
    {"coupled", "forcing_iterations: 2", "scheme: strong",
     "it.yaml:39: coupling.scheme: no longer a key, leave it out: with coupling.load: reaction, the default, fluid and "
     "solid need no iterations within a step"},
    {"coupled", "steps: 100, time_step: auto", "steps: -1", "it.yaml:42: stages[0].steps = -1: must be at least 0"},
    {"coupled", "time_step: auto", "time_step: 0",
     "it.yaml:42: stages[0].time_step = 0: must be greater than 0, or auto"},
    {"coupled", "cfl: 0.5", "cfl: 1.01", "it.yaml:42: stages[0].cfl = 1.01: must be greater than 0 and at most 1"},
    {"coupled", "cfl: 0.5", "safety: 0", "it.yaml:42: stages[0].safety = 0: must be greater than 0 and at most 1"},
    {"coupled", "substeps: 4", "substeps: 0",
     "it.yaml:44: stages[2].substeps = 0: must be between 1 and 1000000, or auto"},
    {"coupled", "damping_absolute: 2000", "damping_absolute: -1",
     "it.yaml:43: stages[1].damping_absolute = -1: must be at least 0, or auto"},
    {"coupled", "damping_absolute: 2000", "damping_absolute: auto",
     "it.yaml:43: stages[1].damping_absolute = auto: needs until: {quantity: rest} and an elastic solid, or a number"},
    {"block", "time: [[0, 0], [1, 1]]", "time: [[0, 0], [1, 1]], time_from: push",
     "it.yaml:13: solid.constraints[0].time_from = push: is the name of no stage"},
    {"block", "time: [[0, 0], [1, 1]]", "time_from: pull",
     "it.yaml:13: solid.constraints[0].time_from = pull: only together with time"},
    {"block", "steps: 10", "steps: 10, relax: true, until: {quantity: rest}",
     "it.yaml:17: stages[0].until: does not go with relax: true, which ends at rest"},
    {"coupled", "cfl: 0.5", "cfl: 0.5, until: {kinetic: 0.1}",
     "it.yaml:42: stages[0].until.kinetic = 0.1: only with quantity rest, here it is permeability"},
    {"coupled", "series_every: 10", "log_every: -1", "it.yaml:46: output.log_every = -1: must be at least 0"},
    /* keys that something else rules out or asks for */
    {"coupled", "y_low: {type: wall}", "y_low: {type: wall, pressure: 1}",
     "it.yaml:12: fluid.sides.y_low.pressure = 1: only with type pressure, here it is wall"},
    {"coupled", ", bulk_velocity: 0.1", "",
     "it.yaml:10: fluid.sides.x_low.bulk_velocity: missing; profile poiseuille needs it (m/s)"},
    {"coupled", "x_low: {type: inflow, profile: poiseuille, bulk_velocity: 0.1}",
     "x_low: {type: inflow, profile: file}", "it.yaml:10: fluid.sides.x_low.file: missing; profile file needs it"},
    {"coupled", "shape: sphere, centre: [0.03, 0.01, 0.01], radius: 0.004", "shape: sphere, centre: [0.03, 0.01, 0.01]",
     "it.yaml:29: solid.bodies[1].radius: missing; shape sphere needs it (m)"},
    {"coupled", "  cells: [40, 20, 20]", "  cells: [40, 20, 20]\n  periodic: [false, false, true]",
     "it.yaml:5: domain.periodic = [false, false, true]: only in a scene without fluid"},
    {"coupled", "solid: rigid", "relax: true", "it.yaml:42: stages[0].relax = true: only in a scene without fluid"},
    {"fluid", "steps: 10", "steps: 10, solid: elastic",
     "it.yaml:13: stages[0].solid = elastic: only in a scene with a solid"},
    {"fluid", "stages:", "coupling: {retraction: 0.3}\nstages:",
     "it.yaml:12: coupling: only in a scene with both fluid and solid"},
    {"solid", "stages:", "coupling: {retraction: 0.3}\nstages:",
     "it.yaml:12: coupling: only in a scene with both fluid and solid"},
    {"solid", "relax: true", "solid: rigid",
     "it.yaml:13: stages[0].solid = rigid: a rigid solid without a fluid does nothing: must be elastic"},
    /* combinations: fluid */
    {"coupled", "cells: [40, 20, 20]", "cells: [40, 20, 21]",
     "it.yaml:4: domain.cells = [40, 20, 21]: a solid in a fluid needs cells of the same size in all directions, "
     "these are 0.001 x 0.001 x 0.000952381 m"},
    {"fluid", "z_low: {type: periodic}", "z_low: {type: slip}",
     "it.yaml:11: fluid.sides.z_high.type = periodic: periodic sides come in pairs, but z_low is slip"},
    {"coupled", "velocity: [0.01, 0, 0]}", "velocity: [0, 0.01, 0]}",
     "it.yaml:13: fluid.sides.y_high.velocity = [0, 0.01, 0]: a wall moves in its own plane: the y component must "
     "be 0"},
    {"fluid", "profile: file, file: profile.txt", "profile: poiseuille, bulk_velocity: 1",
     "it.yaml:6: fluid.sides.x_low.profile = poiseuille: needs walls on both sides in y or z"},
    {"coupled", "x_high: {type: outflow}", "x_high: {type: inflow, bulk_velocity: 0.1}",
     "it.yaml:9: fluid.sides: the velocities given at the sides do not balance, and no side is an outflow or of "
     "given pressure"},
    {"coupled", "x_low: {type: inflow, profile: poiseuille, bulk_velocity: 0.1}", "x_low: {type: slip}",
     "it.yaml:11: fluid.sides.x_high.type = outflow: an outflow needs a side where something comes in (inflow, "
     "pressure or general)"},
    {"coupled", "direction: z", "direction: x",
     "it.yaml:16: fluid.driving.direction = x: must be a periodic direction: x_low is inflow, x_high is outflow"},
    {"coupled", "initial: {velocity: [0.1, 0, 0]", "initial: {velocity: [0, 0, 0]",
     "it.yaml:8: fluid.initial.poiseuille = true: needs initial.velocity, its mean, along one of the axes"},
    {"coupled", "initial: {velocity: [0.1, 0, 0]", "initial: {velocity: [0, 0.1, 0]",
     "it.yaml:8: fluid.initial.poiseuille = true: needs walls on both sides in x or z"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  initial: {taylor_green: {velocity: 1, axes: yz}}",
     "it.yaml:5: fluid.initial.taylor_green.axes = yz: y_low must be periodic or slip, it is general"},
    {"coupled", "viscosity: 1.0e-3", "viscosity: 1.0e-11",
     "it.yaml:7: fluid.viscosity = 1.0e-11: the Reynolds number of a cell, U d/nu, is 1e+07, with U = 0.1 m/s and d = "
     "0.001 m: it may be 1e+06, which needs 1e-10 m2/s or more"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  diffusion: implicit",
     "it.yaml:5: fluid.diffusion = implicit: needs a normal velocity on every side, and x_high has a pressure"},
    {"coupled", "time_step: auto", "time_step: auto, fluid_integrator: euler",
     "it.yaml:42: stages[0].fluid_integrator = euler: must be one of rk3, ab2"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  projection: once",
     "it.yaml:5: fluid.projection = once: must be one of each_stage, last_stage"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  diffusion: half",
     "it.yaml:5: fluid.diffusion = half: must be one of explicit, implicit"},
    {"coupled", "viscosity: 1.0e-3", "viscosity: 1.0e-3\n  diffusion: implicit",
     "it.yaml:8: fluid.diffusion = implicit: needs a solid that does not break: material ceramic has a fracture "
     "energy, and a stage breakage"},
    {"coupled", "direction: z, value: 0", "direction: z, value: 0, frequency: -1",
     "it.yaml:16: fluid.driving.frequency = -1: must be at least 0"},
    {"coupled", "type: pressure_gradient, direction: z, value: 0",
     "type: bulk_velocity, direction: z, value: 0, frequency: 1",
     "it.yaml:16: fluid.driving.frequency = 1: only with type pressure_gradient, here it is bulk_velocity"},
    {"coupled", "series_every: 10", "fluid_probes: {}", "it.yaml:46: output.fluid_probes: needs at, lines or both"},
    {"coupled", "series_every: 10", "fluid_probes: {at: [[0.01, 0.021, 0]]}",
     "it.yaml:46: output.fluid_probes.at[0] = [0.01, 0.021, 0]: must be within the domain, 0 to 0.02 m in y"},
    {"coupled", "series_every: 10", "fluid_probes: {lines: [{from: [0, 0, -0.001], to: [0, 0, 0], points: 2}]}",
     "it.yaml:46: output.fluid_probes.lines[0].from = [0, 0, -0.001]: must be within the domain, 0 to 0.02 m in z"},
    {"coupled", "series_every: 10", "fluid_probes: {lines: [{from: [0, 0, 0], to: [0, 0, 0.01], points: 1}]}",
     "it.yaml:46: output.fluid_probes.lines[0].points = 1: must be between 2 and 10000"},
    {"solid", "stages:", "output: {fluid_probes: {at: [[0, 0, 0]]}}\nstages:",
     "it.yaml:12: output.fluid_probes: only in a scene with a fluid"},
    {"fluid", "p: neumann", "p: dirichlet",
     "it.yaml:8: fluid.sides.y_low.p = dirichlet: must be neumann where the normal velocity v is dirichlet"},
    {"fluid", "x_high: {type: pressure, pressure: 0}", "x_high: {type: slip}",
     "it.yaml:5: fluid.sides: the velocities given at the sides do not balance, and no side is an outflow or of "
     "given pressure"},
    {"fluid", "file: profile.txt", "file: profil.txt",
     "it.yaml:6: fluid.sides.x_low.file = profil.txt: there is no such file (looked for @/profil.txt)"},
    {"fluid", "file: profile.txt", "file: ../scenes",
     "it.yaml:6: fluid.sides.x_low.file = ../scenes: is not a file (looked for @/../scenes)"},
    /* combinations: solid */
    {"coupled", "glass, shape: sphere", "glas, shape: sphere",
     "it.yaml:29: solid.bodies[1].material = glas: is not a name in solid.materials; did you mean glass?"},
    {"coupled", "ratio: 2}", "ratio: 2}\n    - {name: glass, youngs_modulus: 1, density: 1}",
     "it.yaml:22: solid.materials[2].name = glass: is the name of solid.materials[1] too"},
    {"plate", "fracture_energy: 135", "fracture_energy: 135, toughness: 1.0e6",
     "it.yaml:13: solid.materials[0].fracture_energy = 135: not together with toughness"},
    {"coupled", "horizon_ratio: 2", "poisson_ratio: 0.46",
     "it.yaml:21: solid.materials[1].poisson_ratio = 0.46: must be from -0.5 to 0.45"},
    {"coupled", "horizon_ratio: 2", "poisson_ratio: -0.51",
     "it.yaml:21: solid.materials[1].poisson_ratio = -0.51: must be from -0.5 to 0.45"},
    {"coupled", "horizon_ratio: 2", "poisson_ratio: 0.2, micromodulus: conical, fracture_energy: 1",
     "it.yaml:21: solid.materials[1].poisson_ratio = 0.2: does not go with a micromodulus that is not constant, which "
     "needs 0.25, that of bonds alone: the critical stretch is known for a constant one only; without a fracture "
     "energy both go together"},
    {"coupled", "name: ball", "name: block",
     "it.yaml:29: solid.bodies[1].name = block: is the name of solid.bodies[0] too"},
    {"coupled", "material: glass, shape: sphere", "shape: sphere",
     "it.yaml:29: solid.bodies[1].material: missing: solid.materials has 2 to choose from"},
    {"coupled", "centre: [0.03, 0.01, 0.01]", "centre: [0.05, 0.01, 0.01]",
     "it.yaml:29: solid.bodies[1]: lies outside the domain: 0.046 to 0.054 m in x, the domain has 0 to 0.04 m"},
    {"coupled", "centre: [0.03, 0.01, 0.01]", "centre: [0.03, 0.01, 0.025]",
     "it.yaml:29: solid.bodies[1]: lies outside the domain: 0.021 to 0.029 m in z, the domain has 0 to 0.02 m"},
    {"coupled", "low: [0.01, -0.003, 0]", "low: [0.01, 0.01, 0]",
     "it.yaml:26: solid.bodies[0].low = [0.01, 0.01, 0]: must be below high in every direction, y is not"},
    {"coupled", "period: 0.005, radius: 0.002", "period: 0.005, radius: 0.0045",
     "it.yaml:28: solid.bodies[0].cavities.radius = 0.0045: leaves nothing of the body: must be less than 0.00433 "
     "m, sqrt(3)/2 periods"},
    {"coupled", "directions: xyz", "directions: xyx",
     "it.yaml:32: solid.constraints[0].directions = xyx: must be a word of the letters x, y and z, each at most once"},
    {"coupled", "directions: xyz", "directions: xz, velocity: [0, 1, 0]",
     "it.yaml:32: solid.constraints[0].velocity = [0, 1, 0]: has a part in y, which is not in directions (xz)"},
    {"coupled", "high: [0.04, 0, 0.02]", "high: [0.04, -0.02, 0.02]",
     "it.yaml:32: solid.constraints[0].low = [0, -0.01, 0]: must be below high in every direction, y is not"},
    {"coupled", "- {low: [0, -0.01, 0], high: [0.04, 0.001, 0.02]}",
     "- {low: [0, 0.012, 0], high: [0.001, 0.013, 0.02]}",
     "it.yaml:34: solid.unbreakable[0]: no body reaches into this region"},
    {"coupled", "medium: {low: [0.01, 0, 0]", "medium: {low: [-0.01, 0, 0]",
     "it.yaml:40: coupling.medium.low = [-0.01, 0, 0]: must be within the domain, 0 to 0.04 m in x"},
    {"coupled", "medium: {low: [0.01, 0, 0]", "medium: {low: [0.01, 0.01, 0]",
     "it.yaml:40: coupling.medium.low = [0.01, 0.01, 0]: must be below high in every direction, y is not"},
    {"solid", "  spacing: 0.001\n", "",
     "it.yaml:4: solid.spacing: missing (m); without domain.cells, the same in all directions, there is no default"},
    {"solid", "spacing: 0.001", "spacing: 0.0011",
     "it.yaml:5: solid.spacing = 0.0011: the periodic direction z (0.02 m) must hold a whole number of particles, "
     "not 18.1818"},
    {"solid", "spacing: 0.001", "spacing: 0.004",
     "it.yaml:2: domain.size = [0.01, 0.01, 0.02]: a particle's family would meet itself across the periodic "
     "direction z: more than 0.028 m are needed, two horizons and a spacing"},
    {"solid", "file: points.txt", "file: nowhere/points.txt",
     "it.yaml:9: solid.bodies[0].file = nowhere/points.txt: there is no such file (looked for @/nowhere/points.txt)"},
    {"solid", "file: points.txt", "file: points.txt, cavities: {period: 1, radius: 0.1, centre: [0, 0, 0]}",
     "it.yaml:9: solid.bodies[0].cavities: only with shape box, sphere, cylinder, ellipsoid or spheres, here it is points"},
    {"plate", "- {shape: rectangle, low: [0.085, 0]", "- {shape: rectangle, arrangement: {kind: perturbed}, low: [0.085, 0]",
     "it.yaml:27: solid.bodies[0].pieces[0].arrangement: unknown key; known here: shape, low, high, centre, radius, radii, "
     "length, axis, rotation, outline, file, spheres"},
    {"plate", "file: areas.txt", "file: areas.txt, arrangement: {kind: perturbed, perturbation: 0.2}",
     "it.yaml:33: solid.bodies[3].arrangement.kind = perturbed: cannot go with solid.refinement, which divides the cells of "
     "a lattice"},
    {"plate", "file: areas.txt", "file: areas.txt, arrangement: {kind: perturbed}",
     "it.yaml:33: solid.bodies[3].arrangement.perturbation: missing; kind perturbed needs it (spacings)"},
    {"plate", "file: areas.txt", "file: areas.txt, arrangement: {kind: perturbed, perturbation: 0.5}",
     "it.yaml:33: solid.bodies[3].arrangement.perturbation = 0.5: must be greater than 0 and at most 0.4"},
    {"plate", "file: areas.txt", "file: areas.txt, arrangement: {kind: perturbed, perturbation: 0.2, seed: -1}",
     "it.yaml:33: solid.bodies[3].arrangement.seed = -1: must be at least 0"},
    {"plate", "file: areas.txt", "file: areas.txt, arrangement: {perturbation: 0.2}",
     "it.yaml:33: solid.bodies[3].arrangement.perturbation = 0.2: only with kind perturbed, here it is lattice"},
    {"plate", "file: areas.txt", "file: areas.txt, arrangement: {kind: square}",
     "it.yaml:33: solid.bodies[3].arrangement.kind = square: must be one of lattice, hexagonal, perturbed, centroidal, random"},
    {"plate", "shape: rectangle, low: [0.07", "shape: rectangle, arrangement: {kind: centroidal}, low: [0.07",
     "it.yaml:32: solid.bodies[2].arrangement.kind = centroidal: cannot go with solid.refinement, which divides the cells of "
     "a lattice"},
    {"plate", "shape: rectangle, low: [0.07", "shape: rectangle, arrangement: {kind: lattice, seed: 2}, low: [0.07",
     "it.yaml:32: solid.bodies[2].arrangement.seed = 2: only with kind perturbed, centroidal or random, here it is lattice"},
    /* scenes that are solved at once */
    {"nonlocal", "outer_radius: 1.25", "outer_radius: 1.2",
     "it.yaml:7: nonlocal.outer_radius = 1.2: must be at least inner_radius + horizon, 1.25 m: u is given as far as the "
     "horizon reaches"},
    {"nonlocal", "spacing: 0.125", "spacing: 0", "it.yaml:8: nonlocal.spacing = 0: must be greater than 0"},
    {"nonlocal", "  spacing: 0.125\n", "", "it.yaml:2: nonlocal.spacing: missing (m)"},
    {"nonlocal", "exponent: 1", "exponent: -0.5", "it.yaml:4: nonlocal.exponent = -0.5: must be at least 0"},
    {"nonlocal", "exponent: 1", "exponent: 4", "it.yaml:4: nonlocal.exponent = 4: must be less than dimension + 2, here 4"},
    {"nonlocal", "fields_every: 0", "series_every: 1",
     "it.yaml:10: output.series_every = 1: only in a scene that is stepped through stages; this one is solved at once"},
    {"nonlocal", "output: {fields_every: 0}", "stages: [{name: a, steps: 1}]",
     "it.yaml:10: stages: only in a scene that is stepped through stages; this one is solved at once"},
    {"nonlocal", "output: {fields_every: 0}", "domain: {size: [1, 1]}",
     "it.yaml:10: domain: not together with nonlocal"},
    /* combinations: stages */
    {"coupled", "name: settle", "name: flow", "it.yaml:43: stages[1].name = flow: is the name of stages[0] too"},
};
/* clang-format on */

static void test_each_mistake_has_its_line(void **state) {
    (void)state;
    assert_int_equal(sample_check_broken(sizeof table / sizeof *table, table), 0);
}

static void test_all_mistakes_at_once(void **state) {
    (void)state;
    char *sample = sample_text(SCENES "coupled.yaml"), *text = sample;
    const char *const edit[][2] = {{"viscosity", "viscosty"},
                                   {"density: 1000", "density: none"},
                                   {"z_high: {type: periodic}", "z_high: {type: wall}"},
                                   {"youngs_modulus: 7.0e10", "youngs_modulus: -7"},
                                   {"shape: sphere", "shape: ball"},
                                   {"name: settle", "name: fracture"},
                                   {"directions: xyz", "directions: xyzz"},
                                   {"forcing_iterations: 2", "retraction: 7"}};
    const char *const said[] = {
        "--set stages.flow.stepz: unknown key; did you mean steps?",
        "it.yaml:6: fluid.density = none: must be a number, greater than 0 (kg/m3)",
        "it.yaml:7: fluid.viscosty: unknown key; did you mean viscosity?",
        "it.yaml:14: fluid.sides.z_low.type = periodic: periodic sides come in pairs, but z_high is wall",
        ("it.yaml:16: fluid.driving.direction = z: must be a periodic direction: z_low is periodic, "
         "z_high is wall"),
        "it.yaml:21: solid.materials[1].youngs_modulus = -7: must be greater than 0",
        "it.yaml:29: solid.bodies[1].shape = ball: must be one of box, sphere, cylinder, ellipsoid, spheres, points, "
        "image",
        "it.yaml:32: solid.constraints[0].directions = xyzz: is too long: 4 characters, at most 3",
        "it.yaml:39: coupling.retraction = 7: must be between -1 and 1",
        "it.yaml:44: stages[2].name = fracture: is the name of stages[1] too"};
    const int n_edits = (int)(sizeof edit / sizeof *edit), n_said = (int)(sizeof said / sizeof *said);
    for (int i = 0; i < n_edits; i++) {
        char *edited = sample_with(text, edit[i][0], edit[i][1]);
        free(text);
        text = edited;
    }
    const char *const set[] = {"stages.flow.stepz=3"};
    struct scene_problems problems;
    assert_null(sample_read(text, 1, set, &problems));
    for (int i = 0; i < problems.n && i < n_said; i++) {
        char *line = sample_problem(&problems, i);
        assert_string_equal(line, said[i]);
        free(line);
    }
    assert_int_equal(problems.n, n_said);
    scene_problem_free(&problems);
    free(text);
}

/* A body in millimetres: one sentence, and none on the medium's box that the program takes from the body. */
static void test_a_body_in_another_unit(void **state) {
    (void)state;
    struct scene_problems problems;
    const char text[] = "domain: {size: [0.03, 0.02, 0.02], cells: [15, 10, 10]}\n"
                        "fluid:\n"
                        "  density: 1000\n"
                        "  viscosity: 1.0e-3\n"
                        "  sides: {x_low: {type: inflow, bulk_velocity: 0.1}, x_high: {type: outflow},\n"
                        "    y_low: {type: wall}, y_high: {type: wall}, z_low: {type: wall}, z_high: {type: wall}}\n"
                        "solid:\n"
                        "  materials: [{name: m, youngs_modulus: 1.0e7, density: 3000}]\n"
                        "  bodies: [{shape: box, low: [8, 4, 4], high: [20, 12, 12]}]\n"
                        "stages: [{name: a, steps: 20}]\n";
    assert_null(sample_read(text, 0, NULL, &problems));
    char *line = sample_problem(&problems, 0);
    assert_string_equal(line,
                        "it.yaml:9: solid.bodies[0]: lies outside the domain: 8 to 20 m in x, the domain has 0 to "
                        "0.03 m; are all lengths in m?");
    assert_int_equal(problems.n, 1);
    free(line);
    scene_problem_free(&problems);
}

static void test_nothing_to_run_and_no_text(void **state) {
    (void)state;
    const char *const text[][2] = {
        {"", "it.yaml: the scene is empty"},
        {"# a remark\n", "it.yaml: the scene is empty"},
        {"~", "it.yaml:1: a scene must be a mapping (domain: ..., fluid: ..., stages: ...)"},
        {"- 1\n- 2\n", "it.yaml:1: a scene must be a mapping (domain: ..., fluid: ..., stages: ...)"},
        {"domain: {size: [1, 1, 1]}\nstages: [{name: a, steps: 1}]\n",
         "it.yaml: there is nothing to run: give a section fluid, solid or both"}};
    for (size_t i = 0; i < sizeof text / sizeof *text; i++) {
        struct scene_problems problems;
        assert_null(sample_read(text[i][0], 0, NULL, &problems));
        assert_int_equal(problems.n, 1);
        char *said = sample_problem(&problems, 0);
        assert_string_equal(said, text[i][1]);
        free(said);
        scene_problem_free(&problems);
    }
}

/* Whatever is cut off or garbled, there is a scene or a mistake, and neither a crash nor a leak. */
static void garble(const char *path) {
    static const char garbage[] = "\0[]{}:,-*&!'\"#\t\n\xff\x01"
                                  "9";
    char *sample = sample_text(path);
    const size_t length = strlen(sample);
    for (size_t n = 0; n < length; n++) {
        if (check_skips((int)(n / 6), 1)) continue; /* in a debug build six characters of twelve */
        const char was = sample[n];
        struct scene_problems problems = {0};
        struct scene *s = n % 3 ? NULL : scene_read(SCENES "it.yaml", sample, n, 0, NULL, 1, &problems);
        assert_true(n % 3 || (s != NULL) != (problems.n > 0));
        scene_problem_free(&problems);
        scene_free(s);
        sample[n] = garbage[n % (sizeof garbage - 1)];
        s = n % 2 ? NULL : scene_read(SCENES "it.yaml", sample, length, 0, NULL, 1, &problems);
        assert_true(n % 2 || (s != NULL) != (problems.n > 0));
        scene_problem_free(&problems);
        scene_free(s);
        sample[n] = was;
    }
    free(sample);
}

static void test_garbled_scenes_do_not_crash(void **state) {
    (void)state;
    garble(SCENES "coupled.yaml");
    garble(SCENES "plate.yaml");
}

/* Many more entries than can be, and names far longer. */
static void test_too_much_of_a_thing(void **state) {
    (void)state;
    enum { MANY = 20000 };
    static const struct {
        const char *sample, *find, *begin, *entry, *end, *says;
    } heap[] = {
        {"fluid", "[8, 16, 4]", "[", "8, ", "4]", "domain.cells = [8, 8, 8, "},
        {"solid", "  body_force: [0, 0, -9.81]\n", "  cracks: [", "{points: [[0, 0, 0]]}, ", "{}]\n", "solid.cracks"},
        {"coupled", "  bodies:\n", "  bodies:\n", "    - {shape: sphere, centre: [0.03, 0.01, 0.01], radius: 0.001}\n",
         "", "solid.bodies: has "},
        {"fluid", "density: 1", "", "k", ": 1", "it.yaml:3: not valid YAML"},
        {"fluid", "density: 1", "? ", "k", "\n  : 1", "...: unknown key; known here: density, viscosity"},
        {"fluid", "start-up", "", "n", "", "stages[0].name = nnnnnnn"}};
    for (size_t k = 0; k < sizeof heap / sizeof *heap; k++) {
        const size_t entry = strlen(heap[k].entry);
        char *sample = text_new("%s%s.yaml", SCENES, heap[k].sample), *from = sample_text(sample);
        char *more = calloc(1, entry * MANY + 100), *at = more + sprintf(more, "%s", heap[k].begin);
        for (int i = 0; i < MANY; i++, at += entry) memcpy(at, heap[k].entry, entry);
        strcpy(at, heap[k].end);
        char *text = sample_with(from, heap[k].find, more);
        struct scene_problems problems;
        assert_null(sample_read(text, 0, NULL, &problems));
        check_above(problems.n, 0);
        int says = 0;
        for (int i = 0; i < problems.n; i++) {
            says |= strstr(problems.text[i], heap[k].says) != NULL;
            check_below(strlen(problems.text[i]), 1000);
        }
        if (!says) fail_msg("%s: %s", heap[k].says, problems.text[0]);
        scene_problem_free(&problems);
        free(text);
        free(more);
        free(from);
        free(sample);
    }
    char *from = sample_text(SCENES "fluid.yaml"), *setting = calloc(1, MANY + 3);
    memset(setting, 'k', MANY);
    memcpy(setting + MANY, "=1", 2);
    struct scene_problems problems;
    assert_null(sample_read(from, 1, (const char *const[]){setting}, &problems));
    check_below(strlen(problems.text[0]), 1000);
    scene_problem_free(&problems);
    free(setting);
    free(from);
}

static void read_scene(void *with) {
    const struct leaves_scene *r = with;
    scene_new(r->path, r->n, r->set);
}

static int leaves_with(const char *path, int n, const char *const *set, char *said, size_t size) {
    return leaves(read_scene, &(struct leaves_scene){path, n, set}, said, size);
}

static void test_leaves_with_code_2(void **state) {
    (void)state;
    char said[4096];
    const char *const bad[] = {"fluid.viscosity=-1", "stages.flow.stepz=1"}, *const good[] = {"fluid.viscosity=1"};
    assert_int_equal(leaves_with(SCENES "coupled.yaml", 2, bad, said, sizeof said), 2);
    assert_string_equal(said, "frana: --set fluid.viscosity = -1: must be greater than 0\n"
                              "frana: --set stages.flow.stepz: unknown key; did you mean steps?\n");
    assert_int_equal(leaves_with(SCENES "none.yaml", 0, NULL, said, sizeof said), 2);
    assert_string_equal(said, "frana: " SCENES "none.yaml: the scene cannot be read: No such file or directory\n");
    assert_int_equal(leaves_with(SCENES, 0, NULL, said, sizeof said), 2);
    assert_string_equal(said, "frana: " SCENES ": the scene cannot be read: Is a directory\n");
    assert_int_equal(leaves_with("/dev/null", 0, NULL, said, sizeof said), 2);
    assert_string_equal(said, "frana: /dev/null: the scene cannot be read: it is not a file\n");
    assert_int_equal(leaves_with(SCENES "coupled.yaml", 1, good, said, sizeof said), 0);
    assert_string_equal(said, "");
}

int main(int argc, char **argv) {
    /* forks: before MPI has begun */
    const struct CMUnitTest leaving[] = {cmocka_unit_test(test_leaves_with_code_2)};
    int failed = cmocka_run_group_tests(leaving, NULL, NULL);
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_mistake_has_its_line),   cmocka_unit_test(test_all_mistakes_at_once),
        cmocka_unit_test(test_a_body_in_another_unit),      cmocka_unit_test(test_nothing_to_run_and_no_text),
        cmocka_unit_test(test_garbled_scenes_do_not_crash), cmocka_unit_test(test_too_much_of_a_thing)};
    failed += cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
