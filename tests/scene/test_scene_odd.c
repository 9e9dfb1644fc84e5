/* Numbers in unusual forms, texts that are not YAML, keys of other parts, values of wrong types. Each mistake gives its
 * own line. Files of other systems are read. */
#include "base/par.h"
#include "base/text.h"
#include "tests/scene/scene_sample.h"
#include "tests/check.h"

#define TEN(text) text text text text text text text text text text

/* clang-format off */
/* Words that are refused in one place, up to NULL. */
static const struct {
    const char *find, *replace, *line, *word[32];
} refused[] = {
    {"density: 1\n", "density: %s\n",
     "it.yaml:3: fluid.density = %s: must be a number, greater than 0 (kg/m3)",
     {".inf", "-.inf", "inf", "NaN", "1_000", "1,5", "1.0.0",  "1e", "1e+", "0o17", "1 000", "\331\241", "1:30",
      "--1",  "1d3",   "0b1", "1.e", "e5",    ".",   "${RHO}", "1;", "~",   "null", "[1]",   "yes"}},
    {"steps: 10", "steps: %s",
     "it.yaml:13: stages[0].steps = %s: must be a whole number, at least 0",
     {"010", "10.0", "1e1", "-0x1", "ten"}},
    {"density: 1", "density: %s",
     "it.yaml:3: not valid YAML: while scanning for the next token: found character that cannot start any token",
     {"@1", "`1`", "%1"}}};

static const struct sample_broken table[] = {
    /* numbers that are none, or none that can be */
    {"fluid", "domain:", "\303\277\303\276domain:",
     "it.yaml:1: \303\277\303\276domain: unknown key; did you mean domain?"},
    {"fluid", "density: 1\n", "density: -0\n", "it.yaml:3: fluid.density = -0: must be greater than 0"},
    {"fluid", "density: 1\n", "density: +0\n", "it.yaml:3: fluid.density = +0: must be greater than 0"},
    {"fluid", "density: 1\n", "density: -1e-300\n", "it.yaml:3: fluid.density = -1e-300: must be greater than 0"},
    {"fluid", "density: 1\n", "density: 1e-999\n", "it.yaml:3: fluid.density = 1e-999: must be greater than 0"},
    {"fluid", "density: 1\n", "density: 1e400\n", "it.yaml:3: fluid.density = 1e400: is too large: at most 1e+300"},
    {"fluid", "density: 1\n", "density: 5e-324\n",
     "it.yaml:3: fluid.density = 5e-324: is too small: must be 0 or at least 1e-300 in magnitude"},
    {"fluid", "velocity: [0, 0, 0]", "velocity: [0, -1.1e150, 0]",
     "it.yaml:8: fluid.sides.y_low.velocity[1] = -1.1e150: is too large: at most 1e+150"},
    {"fluid", "domain:", "title: \"a\\x7f\"\ndomain:",
     "it.yaml:1: title = \"a \": must be one line without control characters"},
    {"fluid", "domain:", "title: \"a\\e[31m\"\ndomain:",
     "it.yaml:1: title = \"a [31m\": must be one line without control characters"},
    {"fluid", "domain:", "title: \"a\\u0085b\"\ndomain:",
     "it.yaml:1: title = \"a\302\205b\": must be one line without control characters"},
    {"fluid", "domain:", "title: \"a\\u202eb\"\ndomain:",
     "it.yaml:1: title = \"a\342\200\256b\": must be one line without control characters"},
    {"fluid", "density: 1\n", "density: '1'\n",
     "it.yaml:3: fluid.density = \"1\": must be a number, greater than 0 (kg/m3)"},
    {"fluid", "density: 1\n", "density: \n", "it.yaml:3: fluid.density: must be a number, greater than 0 (kg/m3)"},
    {"fluid", "density: 1\n", "density: |\n    1\n",
     "it.yaml:3: fluid.density = \"1 \": must be a number, greater than 0 (kg/m3)"},
    {"fluid", "density: 1\n", "density: {a: 1}\n",
     "it.yaml:3: fluid.density: must be a number, greater than 0 (kg/m3)"},
    {"fluid", "density: 1\n", "density: !!str one\n",
     "it.yaml:3: fluid.density = one: must be a number, greater than 0 (kg/m3)"},
    {"fluid", "density: 1\n", "density: \"\"\n", "it.yaml:3: fluid.density: must be a number, greater than 0 (kg/m3)"},
    {"fluid", "steps: 10", "steps: 9007199254740993", "it.yaml:13: stages[0].steps = 9007199254740993: is too large"},
    /* keys and the text as YAML */
    {"fluid", "steps: 10}", "steps: 10, steps: 20}", "it.yaml:13: stages[0].steps: is given twice, first on line 13"},
    {"fluid", "stages:\n", "fluid: {density: 1}\nstages:\n", "it.yaml:12: fluid: is given twice, first on line 2"},
    {"fluid", "density: 1", "density: 1\n  ? viscosity\n  : 3",
     "it.yaml:6: fluid.viscosity: is given twice, first on line 4"},
    {"fluid", "density: 1", "density: &rho", "it.yaml:3: fluid.density: must be a number, greater than 0 (kg/m3)"},
    {"fluid", "density: 1", "density 1", "it.yaml:4: not valid YAML: mapping values are not allowed in this context"},
    {"fluid", "density: 1", "density: 1: 2",
     "it.yaml:3: not valid YAML: mapping values are not allowed in this context"},
    {"fluid", "density: 1", "density: 'one",
     "it.yaml:14: not valid YAML: while scanning a quoted scalar that begins on line 3: found unexpected end of stream"},
    {"fluid", "density: 1", "density: \"\\q\"",
     "it.yaml:3: not valid YAML: while parsing a quoted scalar: found unknown escape character"},
    {"fluid", "density: 1", " density: 1",
     "it.yaml:4: not valid YAML: while parsing a block mapping: did not find expected key"},
    {"fluid", "  viscosity: 0.1", " viscosity: 0.1",
     "it.yaml:4: not valid YAML: while parsing a block mapping: did not find expected key"},
    {"fluid", "domain:", "%YAML 3.0\n---\ndomain:", "it.yaml:1: not valid YAML: found incompatible YAML document"},
    {"fluid", "domain:", "%FOO\n---\ndomain:",
     "it.yaml:1: not valid YAML: while scanning a directive: found unknown directive name"},
    {"fluid", "steps: 10}", "steps: 10}\n...\nrubbish",
     "it.yaml:15: not valid YAML: did not find expected <document start>"},
    {"fluid", "steps: 10}", "steps: 10}]",
     "it.yaml:13: not valid YAML: while parsing a block collection: did not find expected '-' indicator"},
    {"fluid", "stages:\n",
     TEN(TEN("kkkkkkkkkkk")) ": 1\nstages:\n",
     "it.yaml:12: not valid YAML: a key is longer than 1024 characters, or has no ':'"},
    {"fluid", "domain:", "methods: []\nlevels: []\ndomain:",
     "it.yaml: is a study and not a scene: frana study makes its runs"},
    /* names and texts */
    {"fluid", "name: start-up", "name: start/up",
     "it.yaml:13: stages[0].name = start/up: must not hold a slash or a control character: its checkpoint is named "
     "after it"},
    {"fluid", "name: start-up", "name: ../../up",
     "it.yaml:13: stages[0].name = ../../up: must not hold a slash or a control character: its checkpoint is named "
     "after it"},
    {"fluid", "name: start-up", "name: \"start\\nup\"",
     "it.yaml:13: stages[0].name = \"start up\": must be one line without control characters"},
    {"fluid", "name: start-up", "name: [start, up]", "it.yaml:13: stages[0].name = [start, up]: must be a text"},
    {"fluid", "domain:", "title: " TEN("ttttttttttttttttttttttttt") "tttttt\ndomain:",
     "it.yaml:1: title = ttttttttttttttttttttttttttttttttttttttttttttttttttttttttt...: is too long: 256 characters, "
     "at most 255"},
    {"fluid", "domain:", "title: {a: 1}\ndomain:", "it.yaml:1: title: must be a text"},
    /* wrong kinds of values */
    {"fluid", "domain: {size: [1, 2, 0.5], cells: [8, 16, 4]}", "domain: 5",
     "it.yaml:1: domain = 5: must be a mapping of keys to values"},
    {"fluid", "domain: {size: [1, 2, 0.5], cells: [8, 16, 4]}", "domain: []",
     "it.yaml:1: domain = []: must be a mapping of keys to values"},
    {"fluid", "domain: {size: [1, 2, 0.5], cells: [8, 16, 4]}\n", "", "it.yaml:1: domain: missing"},
    {"fluid", "size: [1, 2, 0.5]", "size: [1, 2, 0.5, 1]",
     "it.yaml:1: domain.size = [1, 2, 0.5, 1]: must be a list of 3 numbers (m)"},
    {"fluid", "size: [1, 2, 0.5]", "size: []", "it.yaml:1: domain.size = []: must be a list of 3 numbers (m)"},
    {"fluid", "size: [1, 2, 0.5]", "size: [1, , 0.5]",
     "it.yaml:1: not valid YAML: while parsing a flow node: did not find expected node content"},
    {"fluid", "size: [1, 2, 0.5]", "size: [1, [2], 0.5]",
     "it.yaml:1: domain.size[1] = [2]: must be a number, greater than 0 (m)"},
    {"fluid", "size: [1, 2, 0.5]", "size: {x: 1, y: 2, z: 3}",
     "it.yaml:1: domain.size: must be a list of 3 numbers (m)"},
    {"fluid", "size: [1, 2, 0.5]", "size: 1 2 0.5",
     "it.yaml:1: domain.size = 1 2 0.5: must be a list of 3 numbers (m)"},
    {"fluid", "cells: [8, 16, 4]", "cells: [8, 16, -4]",
     "it.yaml:1: domain.cells[2] = -4: must be between 1 and 1000000"},
    {"fluid", "stages:", "output: []\nstages:", "it.yaml:12: output = []: must be a mapping of keys to values"},
    {"fluid", "stages:", "output: {series_every: 1.5}\nstages:",
     "it.yaml:12: output.series_every = 1.5: must be a whole number, at least 0 (steps)"},
    {"fluid", "stages:", "output: {stress: 1}\nstages:", "it.yaml:12: output.stress = 1: must be true or false"},
    {"fluid", "stages:", "solid: null\nstages:", "it.yaml:12: solid = null: must be a mapping of keys to values"},
    {"fluid", "stages:", "solid: []\nstages:", "it.yaml:12: solid = []: must be a mapping of keys to values"},
    {"fluid", "  - {name: start-up, steps: 10}", "  - start-up",
     "it.yaml:13: stages[0] = start-up: must be a mapping of keys to values"},
    {"fluid", "  - {name: start-up, steps: 10}", "  - []",
     "it.yaml:13: stages[0] = []: must be a mapping of keys to values"},
    /* sides and driving */
    {"fluid", "x_high: {type: pressure, pressure: 0}", "x_high: {type: pressure, presure: 0}",
     "it.yaml:7: fluid.sides.x_high.presure: unknown key; did you mean pressure?"},
    {"fluid", "x_high: {type: pressure, pressure: 0}", "x_hi: {type: pressure}",
     "it.yaml:7: fluid.sides.x_hi: unknown key; did you mean x_high?"},
    {"fluid", "x_high: {type: pressure, pressure: 0}", "x_high: {type: pressure, velocity: [1, 0, 0]}",
     "it.yaml:7: fluid.sides.x_high.velocity = [1, 0, 0]: only with type wall or general, here it is pressure"},
    {"fluid", "x_high: {type: pressure, pressure: 0}", "x_high: {}", "it.yaml:7: fluid.sides.x_high.type: missing"},
    {"fluid", "x_high: {type: pressure, pressure: 0}", "x_high: {type: [wall, slip]}",
     "it.yaml:7: fluid.sides.x_high.type = [wall, slip]: must be one of periodic, wall, slip, inflow, outflow, "
     "pressure, general"},
    {"fluid", "x_high: {type: pressure, pressure: 0}", "x_high: {type: Pressure}",
     "it.yaml:7: fluid.sides.x_high.type = Pressure: must be one of periodic, wall, slip, inflow, outflow, "
     "pressure, general; did you mean pressure?"},
    {"fluid", "u: dirichlet, v: dirichlet, w: neumann, p: neumann", "u: dirichlet, v: neumann, w: neumann, p: neumann",
     "it.yaml:8: fluid.sides.y_low.p = neumann: must be dirichlet where the normal velocity v is neumann"},
    {"fluid", "u: dirichlet, ", "", "it.yaml:8: fluid.sides.y_low.u: missing; type general needs it"},
    {"fluid", "file: profile.txt", "file: ''", "it.yaml:6: fluid.sides.x_low.file: must be a text, is empty"},
    {"fluid", "file: profile.txt", "file: [profile.txt]",
     "it.yaml:6: fluid.sides.x_low.file = [profile.txt]: must be a text"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  driving: {type: none, value: 1}",
     "it.yaml:5: fluid.driving.value = 1: only with type pressure_gradient or bulk_velocity, here it is none"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  driving: {type: pressure_gradient, direction: z}",
     "it.yaml:5: fluid.driving.value: missing; type pressure_gradient needs it (Pa/m or m/s)"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  driving: {type: bulk_velocity, direction: y, value: 1}",
     "it.yaml:5: fluid.driving.direction = y: must be a periodic direction: y_low is general, y_high is slip"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  driving: {type: pressure_gradient, direction: w, value: 1}",
     "it.yaml:5: fluid.driving.direction = w: must be one of x, y, z"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  driving: {type: pressure_gradient, along: [0, 0, 0], value: 1}",
     "it.yaml:5: fluid.driving.along = [0, 0, 0]: must not be 0 in every direction"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  driving: {type: pressure_gradient, along: [0, 1, 1], value: 1}",
     "it.yaml:5: fluid.driving.along = [0, 1, 1]: must be a periodic direction: y_low is general, y_high is slip"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  driving: {type: bulk_velocity, along: [0, 0, 1], value: 1}",
     "it.yaml:5: fluid.driving.along = [0, 0, 1]: only with type pressure_gradient, here it is bulk_velocity"},
    {"fluid", "viscosity: 0.1",
     "viscosity: 0.1\n  driving: {type: pressure_gradient, direction: z, along: [0, 0, 1], value: 1}",
     "it.yaml:5: fluid.driving.direction = z: not together with along"},
    {"fluid", "steps: 10", "steps: 10, until: {}",
     "it.yaml:13: stages[0].until: the permeability needs a fluid and a solid; quantity: rest needs one of them"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  driving: {}", "it.yaml:5: fluid.driving.type: missing"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  initial: {velocity: [1, 0]}",
     "it.yaml:5: fluid.initial.velocity = [1, 0]: must be a list of 3 numbers (m/s)"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  initial: {poiseuille: yes}",
     "it.yaml:5: fluid.initial.poiseuille = yes: must be true or false"},
    {"fluid", "viscosity: 0.1", "viscosity: 0.1\n  body_force: 9.81",
     "it.yaml:5: fluid.body_force = 9.81: must be a list of 3 numbers (m/s2)"},
    /* parts that are not there */
    {"solid", "stages:", "output: {events: 1}\nstages:", "it.yaml:12: output.events = 1: must be true or false"},
    {"fluid", "stages:", "output: {modes: {centre: [0, 0, 0], radii: [0.1, 0.2]}}\nstages:",
     "it.yaml:12: output.modes: only in a scene with a solid"},
    {"fluid", "stages:", "output: {probes: {at: [[0, 0, 0]]}}\nstages:",
     "it.yaml:12: output.probes: only in a scene with a solid"},
    {"fluid", "steps: 10", "steps: 10, substeps: 2",
     "it.yaml:13: stages[0].substeps = 2: only in a scene with a solid"},
    {"fluid", "steps: 10", "steps: 10, integrator: rk3",
     "it.yaml:13: stages[0].integrator = rk3: only in a scene with a solid"},
    {"fluid", "steps: 10", "steps: 10, breakage: true",
     "it.yaml:13: stages[0].breakage = true: only in a scene with a solid"},
    {"fluid", "steps: 10", "steps: 10, relax: true",
     "it.yaml:13: stages[0].relax = true: only in a scene without fluid"},
    /* solids in a fluid */
    {"coupled",
     "  materials:\n    - {name: ceramic, youngs_modulus: 1.0e8, density: 3000, fracture_energy: 0.05}\n    - {name: "
     "glass, youngs_modulus: 7.0e10, density: 2500, horizon_ratio: 2}", "  materials: []",
     "it.yaml:19: solid.materials: is empty: needs at least one entry"},
    {"coupled", "fracture_energy: 0.05", "fracture_energy: -.inf",
     "it.yaml:20: solid.materials[0].fracture_energy = -.inf: must be a number, greater than 0 (J/m2), or .inf"},
    {"coupled", "fracture_energy: 0.05", "fracture_energy: inf",
     "it.yaml:20: solid.materials[0].fracture_energy = inf: must be a number, greater than 0 (J/m2), or .inf"},
    {"coupled", "fracture_energy: 0.05", "fracture_energy: 0.05, breakage: {law: bilinear}",
     "it.yaml:20: solid.materials[0].breakage.tensile_strength: missing; law bilinear needs it, here or as the "
     "material's tensile_strength (Pa)"},
    {"coupled", "fracture_energy: 0.05",
     "fracture_energy: 0.05, tensile_strength: 1.0e+4, breakage: {law: bilinear, tensile_strength: 1.0e+4}",
     "it.yaml:20: solid.materials[0].tensile_strength = 1.0e+4: not with breakage.tensile_strength: give one of the two"},
    {"coupled", "fracture_energy: 0.05", "fracture_energy: 0.05, tensile_strength: 1.0e+4",
     "it.yaml:20: solid.materials[0].tensile_strength = 1.0e+4: brittle bonds of this strength have the fracture energy "
     "0.0036 J/m2 at the horizon 0.003 m, and 0.05 J/m2 are given: leave one of the two out, or take breakage: {law: "
     "bilinear}"},
    {"coupled", "fracture_energy: 0.05",
     "fracture_energy: 0.05, tensile_strength: 1.0e+5, breakage: {law: bilinear}",
     "it.yaml:20: solid.materials[0].tensile_strength = 1.0e+5: needs a horizon below 0.000416667 m with this fracture "
     "energy, and it is 0.003 m: take a spacing below 0.000138889 m, or a brittle law, whose strength at this horizon is "
     "37267.8 Pa"},
    {"coupled", "fracture_energy: 0.05", "breakage: {law: bilinear, tensile_strength: 1.0e+4}",
     "it.yaml:20: solid.materials[0].breakage.law = bilinear: needs a fracture_energy"},
    {"coupled", "fracture_energy: 0.05", "fracture_energy: 0.05, breakage: {law: brittle, tensile_strength: 1.0e+4}",
     "it.yaml:20: solid.materials[0].breakage.tensile_strength = 1.0e+4: only with law bilinear, here it is brittle"},
    {"coupled", "fracture_energy: 0.05", "fracture_energy: 0.05, breakage: {law: bilinear, tensile_strength: 1.0e+5}",
     "it.yaml:20: solid.materials[0].breakage.tensile_strength = 1.0e+5: needs a horizon below 0.000416667 m with this "
     "fracture energy, and it is 0.003 m: take a spacing below 0.000138889 m, or a brittle law, whose strength at this "
     "horizon is 37267.8 Pa"},
    {"coupled", "shape: sphere", "shape: rectangle",
     "it.yaml:29: solid.bodies[1].shape = rectangle: must be one of box, sphere, cylinder, ellipsoid, spheres, points, image in 3D"},
    {"coupled", "shape: sphere, centre: [0.03, 0.01, 0.01], radius: 0.004",
     "shape: sphere, centre: [0.03, 0.01], radius: 0.004",
     "it.yaml:29: solid.bodies[1].centre = [0.03, 0.01]: must be a list of 3 numbers (m)"},
    {"coupled", "shape: sphere", "shape: sphere, low: [0, 0, 0]",
     "it.yaml:29: solid.bodies[1].low = [0, 0, 0]: only with shape box, rectangle or image, here it is sphere"},
    {"coupled", "axis: z", "axis: w", "it.yaml:30: solid.bodies[2].axis = w: must be one of x, y, z"},
    {"coupled", "length: 0.02, ", "", "it.yaml:30: solid.bodies[2].length: missing; shape cylinder needs it (m)"},
    {"coupled", "length: 0.02", "length: -0.02", "it.yaml:30: solid.bodies[2].length = -0.02: must be greater than 0"},
    {"coupled", "axis: z", "axis: z, holes: []",
     "it.yaml:30: solid.bodies[2].holes: is empty: needs at least one entry"},
    /* several shapes in 3D */
    {"coupled", "axis: z", "axis: z, holes: [{shape: disc, centre: [0, 0, 0], radius: 1}]",
     "it.yaml:30: solid.bodies[2].holes[0].shape = disc: must be one of box, sphere, cylinder, ellipsoid, spheres in 3D"},
    {"coupled", "axis: z", "axis: z, holes: [{shape: cylinder, centre: [0, 0, 0], radius: 1}]",
     "it.yaml:30: solid.bodies[2].holes[0].length: missing; shape cylinder needs it (m)"},
    {"coupled", "axis: z", "axis: z, pieces: [{shape: box, low: [0, 0, 0], high: [0, 1, 1]}]",
     "it.yaml:30: solid.bodies[2].pieces[0].low = [0, 0, 0]: must be below high in every direction, x is not"},
    {"coupled", "axis: z", "axis: z, pieces: [{shape: sphere, centre: [0, 0, 0], radius: 1, radii: [1, 1, 1]}]",
     "it.yaml:30: solid.bodies[2].pieces[0].radii = [1, 1, 1]: only with shape ellipsoid, here it is sphere"},
    {"coupled", "axis: z", "axis: z, contacts: glued",
     "it.yaml:30: solid.bodies[2].contacts = glued: must be one of bonded, broken"},
    /* velocities at the start */
    {"coupled", "axis: z", "axis: z, velocity: [1, 0]",
     "it.yaml:30: solid.bodies[2].velocity = [1, 0]: must be a list of 3 numbers (m/s)"},
    {"coupled", "axis: z", "axis: z, velocity: [0, 0, -1]",
     "it.yaml:30: solid.bodies[2].velocity = [0, 0, -1]: the first stage, flow, is rigid: the body stands still in it"},
    {"solid", "file: points.txt", "file: points.txt, velocity: [1, 0, 0]",
     "it.yaml:9: solid.bodies[0].velocity = [1, 0, 0]: the first stage, settle, relaxes: it ends with the solid at rest"},
    {"plate", "centre: [0.09, 0.03]", "centre: [0.09, 0.03], velocity: [1, 0, 0]",
     "it.yaml:31: solid.bodies[1].velocity = [1, 0, 0]: must be a list of 2 numbers (m/s) in a plate"},
    {"coupled", "forcing_iterations: 2", "probe_length: 11",
     "it.yaml:39: coupling.probe_length = 11: must be greater than 0 and at most 10"},
    {"coupled", "forcing_iterations: 2", "forcing_iterations: 2.5",
     "it.yaml:39: coupling.forcing_iterations = 2.5: must be a whole number, between 1 and 100"},
    {"coupled", "medium: {low: [0.01, 0, 0], high: [0.02, 0.01, 0.02]}", "medium: {low: [0.01, 0, 0]}",
     "it.yaml:40: coupling.medium.high: missing (m)"},
    {"coupled", "medium: {low: [0.01, 0, 0], high: [0.02, 0.01, 0.02]}", "medium: {high: [0.02, 0.01, 0.02]}",
     "it.yaml:40: coupling.medium.low: missing (m)"},
    {"coupled", "medium: {", "medium: {direction: w, ",
     "it.yaml:40: coupling.medium.direction = w: must be one of auto, x, y, z, driving"},
    {"coupled", "medium: {", "medium: {direction: y, ",
     "it.yaml:40: coupling.medium.direction = y: nothing drives the fluid along y: its sides let nothing through"},
    {"coupled", "medium: {", "medium: {direction: z, ",
     "it.yaml:40: coupling.medium.direction = z: nothing drives the fluid along z: no gradient and no body force points "
     "along it"},
    {"coupled", "cfl: 0.5", "cfl: 0.5, until: {change: 0}",
     "it.yaml:42: stages[0].until.change = 0: must be greater than 0 and at most 1"},
    {"coupled", "cfl: 0.5", "cfl: 0.5, until: {window: 1}", "it.yaml:42: stages[0].until.window = 1: must be at least 2"},
    {"coupled", "cfl: 0.5", "cfl: 0.5, until: {quantity: porosity}",
     "it.yaml:42: stages[0].until.quantity = porosity: must be one of permeability, rest"},
    {"coupled", "force: [0, -100, 0]", "force: [0, -100]",
     "it.yaml:36: solid.loads[0].force = [0, -100]: must be a list of 3 numbers (N/m3)"},
    {"coupled", "force: [0, -100, 0]", "force: [0, -100, 0], time: [[1, 0], [0.5, 1]]",
     "it.yaml:36: solid.loads[0].time[1] = [0.5, 1]: must be later than the entry before, at 1 s"},
    {"coupled", "directions: xyz", "directions: ''",
     "it.yaml:32: solid.constraints[0].directions: must be a text, is empty"},
    {"coupled", "directions: xyz", "directions: w",
     "it.yaml:32: solid.constraints[0].directions = w: must be a word of the letters x, y and z, each at most once"},
    {"coupled", "directions: xyz", "velocity: [0, 0, .nan]",
     "it.yaml:32: solid.constraints[0].velocity[2] = .nan: must be a number (m/s)"},
    {"coupled", "contact: {enabled: true, stiffness: 15}", "contact: {exponent: 0}",
     "it.yaml:37: solid.contact.exponent = 0: must be greater than 0"},
    {"coupled", "contact: {enabled: true, stiffness: 15}", "contact: {radius: -1}",
     "it.yaml:37: solid.contact.radius = -1: must be greater than 0"},
    {"coupled", "damping_absolute: 2000", "damping_relative: -1",
     "it.yaml:43: stages[1].damping_relative = -1: must be at least 0"},
    {"coupled", "integrator: verlet", "integrator: euler",
     "it.yaml:44: stages[2].integrator = euler: must be one of rk3, verlet"},
    {"coupled", "series_every: 10", "checkpoint_every: -5",
     "it.yaml:46: output.checkpoint_every = -5: must be at least 0"},
    {"coupled", "series_every: 10", "fields_every: 99999999999999999999",
     "it.yaml:46: output.fields_every = 99999999999999999999: is too large"},
    {"coupled", "series_every: 10", "crack: {direction: [1, 0]}",
     "it.yaml:46: output.crack.direction = [1, 0]: must be a list of 3 numbers"},
    {"coupled", "series_every: 10", "fluid_probes: {at: [[0.01, 0.01]]}",
     "it.yaml:46: output.fluid_probes.at[0] = [0.01, 0.01]: must be a list of 3 numbers (m)"},
    {"coupled", "series_every: 10", "fluid_probes: {at: 5}",
     "it.yaml:46: output.fluid_probes.at = 5: must be a list of lists of numbers"},
    {"coupled", "series_every: 10", "fluid_probes: {lines: []}",
     "it.yaml:46: output.fluid_probes.lines: is empty: needs at least one entry"},
    /* plates */
    {"plate", "thickness: 0.002", "thickness: thin",
     "it.yaml:8: solid.thickness = thin: must be a number, greater than 0 (m)"},
    {"plate", "spacing: 0.001", "spacing: 0", "it.yaml:6: solid.spacing = 0: must be greater than 0"},
    {"plate", "partial_volume: ramp", "partial_volume: none",
     "it.yaml:10: solid.partial_volume = none: must be one of exact, ramp, ramp_cut"},
    {"plate", "shape: disc, centre: [0.09, 0.03]", "shape: disc, centre: [0.09, 0.03, 0]",
     "it.yaml:31: solid.bodies[1].centre = [0.09, 0.03, 0]: must be a list of 2 numbers (m) in a plate"},
    {"plate", "file: areas.txt", "file: areas.txt, low: [0, 0]",
     "it.yaml:33: solid.bodies[3].low = [0, 0]: only with shape box, rectangle or image, here it is points"},
    {"plate", "- {name: notch, points: [[0, 0.02], [0.01, 0.02], [0.02, 0.021]]}", "- [[0, 0.02], [0.01, 0.02]]",
     "it.yaml:35: solid.cracks[0]: must be a mapping of keys to values"},
    {"plate", "displacement: [0, 1.0e-5]", "displacement: [0, 1.0e-5, 0]",
     "it.yaml:38: solid.constraints[1].displacement = [0, 1.0e-5, 0]: must be a list of 2 numbers (m) in a plate"},
    {"plate", "time: [[0, 0], [1.0e-6, 1]]", "time: [[0, 0, 0]]",
     "it.yaml:38: solid.constraints[1].time[0] = [0, 0, 0]: must be a list of 2 numbers (s, 1)"},
    {"plate", "force: [0, 1.0e9]", "force: [0, 1.0e9, 0]",
     "it.yaml:42: solid.loads[0].force = [0, 1.0e9, 0]: must be a list of 2 numbers (N/m3) in a plate"},
    {"plate", "traction: [0, 1.2e7]", "traction: 1.2e7",
     "it.yaml:43: solid.loads[1].traction = 1.2e7: must be a list of 2 numbers (Pa) in a plate"},
    {"plate", "along: y", "along: [y]", "it.yaml:46: solid.initial[0].along = [y]: must be one of x, y"},
    {"plate", "levels: 2", "levels: 0", "it.yaml:48: solid.refinement.levels = 0: must be between 1 and 4"},
    {"plate", "energy: off", "energy: on",
     "it.yaml:49: solid.refinement.energy = on: must be a number, greater than 0 and at most 1, or off"},
    {"plate", "from: 1.0e-6", "from: -1", "it.yaml:51: solid.refinement.from = -1: must be at least 0"},
    {"plate", "every: 5", "every: 2.5",
     "it.yaml:54: solid.refinement.every = 2.5: must be a whole number, at least 1 (steps)"},
    {"plate", "damage: 0.1", "damage: true",
     "it.yaml:50: solid.refinement.damage = true: must be a number, greater than 0 and less than 1, or off"},
    {"plate", "level: 2}", "level: 0}", "it.yaml:57: solid.refinement.start[0].level = 0: must be between 1 and 4"},
    {"plate", "damage: 0.1", "damage: 0.1\n    horizon: fixed",
     "it.yaml:51: solid.refinement.horizon = fixed: must be one of scaled, kept"},
    {"plate", "damage: 0.1", "damage: 0.1\n    interface: smooth",
     "it.yaml:51: solid.refinement.interface = smooth: must be one of plain, corrected"},
    {"plate", "direction: [1, 1]", "direction: [1, 1, 0]",
     "it.yaml:63: output.crack.direction = [1, 1, 0]: must be a list of 2 numbers in a plate"},
    {"plate", "damage: 0.4", "damage: 1.5",
     "it.yaml:63: output.crack.damage = 1.5: must be greater than 0 and less than 1"},
    {"plate", "integrator: verlet", "solid: rigid",
     "it.yaml:60: stages[0].solid = rigid: a rigid solid without a fluid does nothing: must be elastic"},
    /* solids alone */
    {"solid", "periodic: [false, false, true]", "periodic: [false, true]",
     "it.yaml:3: domain.periodic = [false, true]: must be a list of 3 true or false"},
    {"solid", "periodic: [false, false, true]", "periodic: true",
     "it.yaml:3: domain.periodic = true: must be a list of 3 true or false"},
    {"solid", "relax: true", "relax: false, increment: 1",
     "it.yaml:13: stages[0].increment = 1: only with relax: true"},
    {"solid", "relax: true", "relax: true, increment: 0", "it.yaml:13: stages[0].increment = 0: must be greater than 0"},
    {"solid", "relax: true", "relax: true, tolerance: 1",
     "it.yaml:13: stages[0].tolerance = 1: must be greater than 0 and at most 0.1"},
    {"solid", "relax: true", "relax: maybe", "it.yaml:13: stages[0].relax = maybe: must be true or false"},
    {"solid", "spacing: 0.001", "spacing: 0.001\n  thickness: 1", "it.yaml:6: solid.thickness = 1: only in a plate, where domain.size has two numbers"},
    {"solid", "spacing: 0.001", "spacing: 0.001\n  horizons: none", "it.yaml:6: solid.horizons = none: must be one of dual, one_sided"},
    {"solid", "file: points.txt", "file: points.txt, radius: 1", "it.yaml:9: solid.bodies[0].radius = 1: only with shape sphere, cylinder or disc, here it is points"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: ellipsoid, centre: [0.005, 0.005, 0.01]", "it.yaml:10: solid.bodies[1].radii: missing; shape ellipsoid needs it (m)"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: ellipsoid, centre: [0.005, 0.005, 0.01], radii: [0.003, 0, 0.01]", "it.yaml:10: solid.bodies[1].radii[1] = 0: must be greater than 0"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: ellipsoid, centre: [0.005, 0.005, 0.01], radii: [0.003, 0.003]", "it.yaml:10: solid.bodies[1].radii = [0.003, 0.003]: must be a list of 3 numbers (m)"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: ellipsoid, centre: [0.005, 0.005, 0.05], radii: [0.003, 0.003, 0.02]", "it.yaml:10: solid.bodies[1]: lies outside the domain: 0.03 to 0.07 m in z, the domain has 0 to 0.02 m"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: spheres", "it.yaml:10: solid.bodies[1].file: missing; shape spheres needs it"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: spheres, file: nowhere.txt", "it.yaml:10: solid.bodies[1].file = nowhere.txt: there is no such file (looked for @/nowhere.txt)"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: spheres, spheres: []", "it.yaml:10: solid.bodies[1].spheres: is empty: needs at least one entry"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: spheres, spheres: [[0, 0, 0]]", "it.yaml:10: solid.bodies[1].spheres[0] = [0, 0, 0]: must be a list of 4 numbers (m)"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: spheres, spheres: [[0, 0, 0, 1], [0, 0, 0, -1]]", "it.yaml:10: solid.bodies[1].spheres[1] = [0, 0, 0, -1]: the radius, its fourth number, must be greater than 0"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: spheres, spheres: [[0, 0, .nan, 1]]", "it.yaml:10: solid.bodies[1].spheres[0][2] = .nan: must be a number (m)"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: spheres, file: points.txt, spheres: [[0, 0, 0, 1]]", "it.yaml:10: solid.bodies[1].file = points.txt: not together with spheres"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: spheres, spheres: [[0.005, 0.005, 0.05, 0.001]]", "it.yaml:10: solid.bodies[1]: lies outside the domain: 0.049 to 0.051 m in z, the domain has 0 to 0.02 m"},
    {"plate", "name: pad, material: steel, shape: rectangle", "name: pad, contacts: broken, material: steel, shape: rectangle", "it.yaml:32: solid.bodies[2].contacts = broken: only with shape box, sphere, cylinder, ellipsoid or spheres, here it is rectangle"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02], rotation: {angle: 30}", "it.yaml:10: solid.bodies[1].rotation.axis: missing"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02], rotation: {axis: [0, 0, 0], angle: 30}", "it.yaml:10: solid.bodies[1].rotation.axis = [0, 0, 0]: must not be 0 in every direction"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02], rotation: {axis: [0, 0, 1]}", "it.yaml:10: solid.bodies[1].rotation.angle: missing (degrees)"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02], rotation: {axes: [[1, 1, 0], [1, 0, 0]]}", "it.yaml:10: solid.bodies[1].rotation.axes: must be two directions that are perpendicular to each other"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02], rotation: {axes: [[1, 1, 0], [0, 0, 0]]}", "it.yaml:10: solid.bodies[1].rotation.axes: must be two directions, and one of them is 0"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02], rotation: {axes: [[1, 1, 0]]}", "it.yaml:10: solid.bodies[1].rotation.axes: must be a list of 2 lists of numbers"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02], rotation: {axes: [[1, 1, 0], [-1, 1, 0]], angle: 30}", "it.yaml:10: solid.bodies[1].rotation.angle = 30: not together with axes"},
    {"solid", "shape: box, low: [0.002, 0.002, 0], high: [0.008, 0.008, 0.02]", "shape: sphere, centre: [0.005, 0.005, 0.01], radius: 0.004, rotation: {axis: [0, 0, 1], angle: 1}", "it.yaml:10: solid.bodies[1].rotation: only with shape box, cylinder, ellipsoid or rectangle, here it is sphere"},
    {"solid", "  body_force:", "  interfaces: [{between: [body1, bodi2], fracture_energy: 1}]\n  body_force:", "it.yaml:11: solid.interfaces[0].between[1] = bodi2: is not a name in solid.bodies; did you mean body2?"},
    {"solid", "  body_force:", "  interfaces: [{between: [body1, body1], fracture_energy: 1}]\n  body_force:", "it.yaml:11: solid.interfaces[0].between = [body1, body1]: must be two different bodies"},
    {"solid", "  body_force:", "  interfaces: [{between: [body1], fracture_energy: 1}]\n  body_force:", "it.yaml:11: solid.interfaces[0].between = [body1]: must be a list of 2 names"},
    {"solid", "  body_force:", "  interfaces: [{between: [body1, body2]}]\n  body_force:", "it.yaml:11: solid.interfaces[0].fracture_energy: missing (J/m2)"},
    {"solid", "  body_force:", "  interfaces: [{between: [body1, body2], fracture_energy: 0}]\n  body_force:", "it.yaml:11: solid.interfaces[0].fracture_energy = 0: must be greater than 0, or .inf"},
    {"solid", "  body_force:", "  interfaces: [{between: [body1, body2], fracture_energy: 1}, {between: [body2, body1], fracture_energy: .inf}]\n  body_force:", "it.yaml:11: solid.interfaces[1].between = [body2, body1]: is the pair of solid.interfaces[0] too"},
    {"solid", "  body_force:", "  interfaces: [{between: [body1, body2], fracture_energy: 1}]\n  horizons: one_sided\n  body_force:", "it.yaml:11: solid.interfaces: does not go with solid.horizons: one_sided"},
    {"solid", "shape: box, low", "shape: box, radii: [1, 1, 1], low", "it.yaml:10: solid.bodies[1].radii = [1, 1, 1]: only with shape ellipsoid, here it is box"},
    {"solid", "shape: box", "shape: polygon", "it.yaml:10: solid.bodies[1].shape = polygon: must be one of box, sphere, cylinder, ellipsoid, spheres, points, image in 3D"},
    {"solid", "stages:", "output: {crack: {direction: [0, 0, 0]}}\nstages:", "it.yaml:12: output.crack.direction = [0, 0, 0]: must not be 0 in every direction"},
    {"block", "along: z", "along: xy", "it.yaml:15: solid.initial[0].along = xy: must be one of x, y, z"},
    {"block", "width: 0.002", "width: wide", "it.yaml:15: solid.initial[0].width = wide: must be a number, greater than 0 (m)"},
    {"block", "lattice_offset: [0.5, 0, 0]", "lattice_offset: [2, 0, 0]", "it.yaml:5: solid.lattice_offset[0] = 2: must be between -1 and 1"},
    {"block", "micromodulus: conical", "micromodulus: 1", "it.yaml:7: solid.materials[0].micromodulus = 1: must be one of constant, conical, exponential"},
    {"block", "shape: gaussian, ", "", "it.yaml:15: solid.initial[0].shape: missing"},
    /* bytes that are not text */
    {"fluid", "density: 1", "density: \377", "it.yaml:3: not valid YAML: invalid leading UTF-8 octet"},
    {"fluid", "steps: 10}", "steps: 10}\n\001", "it.yaml:14: not valid YAML: control characters are not allowed"},
    {"fluid", "density: 1", "density: 1 # \303", "it.yaml:3: not valid YAML: invalid trailing UTF-8 octet"},
    {"fluid", "name: start-up",
     "name: "
     "\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303"
     "\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244"
     "\303\244\303\244\303\244\303\244\303\244",
     "it.yaml:13: stages[0].name = "
     "\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303"
     "\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244\303\244"
     "\303\244...: is too long: 64 characters, at most 63"},
};
/* clang-format on */

static void test_refused_words(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof refused / sizeof *refused; k++)
        for (const char *const *word = refused[k].word; *word; word++) {
            char *replace = text_new(refused[k].replace, *word), *line = text_new(refused[k].line, *word);
            const struct sample_broken one = {"fluid", refused[k].find, replace, line};
            assert_int_equal(sample_check_broken(1, &one), 0);
            free(line);
            free(replace);
        }
}

static void test_each_mistake_has_its_line(void **state) {
    (void)state;
    assert_int_equal(sample_check_broken(sizeof table / sizeof *table, table), 0);
}

/* The text with every line's end as another system has it, and with a byte order mark before it or none; malloc'ed. */
static char *as_elsewhere(const char *text, const char *mark, const char *end) {
    char *to = calloc(2, strlen(text) + 4), *at = to + sprintf(to, "%s", mark);
    for (; *text; text++) at += *text == '\n' ? sprintf(at, "%s", end) : sprintf(at, "%c", *text);
    return to;
}

/* Words stand in quotes in JSON, which is YAML too: also those that a number's key takes. */
static void test_words_in_quotes(void **state) {
    (void)state;
    char *text = sample_text(SCENES "coupled.yaml"),
         *quoted = sample_with(text, "time_step: auto", "time_step: \"auto\"");
    struct scene_problems problems;
    struct scene *s = sample_read(quoted, 0, NULL, &problems);
    assert_non_null(s);
    check_equal(s->stage[0].time_step, 0);
    scene_free(s);
    free(quoted);
    free(text);
}

static void test_other_systems_files_are_read(void **state) {
    (void)state;
    static const char *const form[][2] = {{"", "\r\n"}, {"\357\273\277", "\n"}, {"\357\273\277", "\r\n"}, {"", "\r"}};
    for (int k = 0; k < 4; k++) {
        char *sample = sample_text(SCENES "coupled.yaml"), *text = as_elsewhere(sample, form[k][0], form[k][1]);
        struct scene_problems problems;
        struct scene *as_is = sample_read(sample, 0, NULL, &problems), *s = sample_read(text, 0, NULL, &problems);
        if (!s) fail_msg("form %d: %s", k, problems.n ? problems.text[0] : "no scene");
        assert_string_equal(s->resolved, as_is->resolved);
        scene_free(s);
        scene_free(as_is);
        free(text);
        free(sample);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_refused_words),
        cmocka_unit_test(test_each_mistake_has_its_line),
        cmocka_unit_test(test_words_in_quotes),
        cmocka_unit_test(test_other_systems_files_are_read),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
