# shellcheck shell=bash
# Solids that break, for several of the program's tests. To be sourced by bash.

# torn_plate FROM TO STAGE: a plate with a notch from x = FROM to TO, m, torn apart; STAGE: more keys of its stage
torn_plate() {
  cat <<YAML
title: A plate torn
domain: {size: [0.02, 0.01]}
solid:
  model: plane_stress
  thickness: 0.002
  spacing: 0.0005
  materials:
    - {name: glass, youngs_modulus: 72e9, density: 2440, fracture_energy: 135}
  bodies:
    - {name: plate, material: glass, shape: rectangle, low: [0, 0], high: [0.02, 0.01]}
  cracks:
    - {points: [[$1, 0.005], [$2, 0.005]]}
  constraints:
    - {low: [0.018, 0], high: [0.02, 0.01], directions: x, displacement: [1.0e-6, 0], time: [[0, 0], [3.0e-6, 1]]}
  loads:
    - {edge: {from: [0, 0], to: [0.018, 0]}, traction: [0, -3.0e7], time: [[0, 0], [1.0e-6, 1]]}
    - {edge: {from: [0, 0.01], to: [0.018, 0.01]}, traction: [0, 3.0e7], depth: horizon, time: [[0, 0], [1.0e-6, 1]]}
  initial:
    - {shape: gaussian, along: y, centre: 0.005, width: 0.001, displacement: [1.0e-8, 0]}
stages:
  - {name: tear, steps: 160, time_step: 5.0e-8, $3}
output: {series_every: 10, fields_every: 80, checkpoint_every: 90}
YAML
}

# notched_bar LEFT RIGHT: a bar whose ends move along x with these velocities, m/s; without loads, stages, output
notched_bar() {
  cat <<YAML
title: A notched bar is pulled apart
domain: {size: [0.04, 0.02, 0.02]}
solid:
  spacing: 1.0e-3
  materials:
    - {name: ceramic, youngs_modulus: 1.0e8, density: 3000, fracture_energy: 0.05}
  bodies:
    - {name: bar, material: ceramic, shape: box, low: [0.01, 0.006, 0.006], high: [0.03, 0.012, 0.012]}
  cracks:
    - {points: [[0.0202, 0.004, 0.004], [0.0202, 0.0085, 0.004], [0.0202, 0.0085, 0.016], [0.0202, 0.004, 0.016]]}
  constraints:
    - {low: [0, 0, 0], high: [0.013, 0.02, 0.02], directions: xyz, velocity: [$1, 0, 0]}
    - {low: [0.027, 0, 0], high: [0.04, 0.02, 0.02], directions: x, velocity: [$2, 0, 0]}
YAML
}

# refined_plate VELOCITY OUTPUT: a notched plate that is refined while its ends move apart, each at VELOCITY m/s;
# OUTPUT: keys of the output
refined_plate() {
  cat <<YAML
domain: {size: [0.03, 0.03]}
solid:
  spacing: 1.0e-3
  model: plane_stress
  thickness: 1.0e-3
  materials:
    - {name: glass, youngs_modulus: 72.0e9, density: 2440, fracture_energy: 0.02}
  bodies:
    - {shape: rectangle, low: [0.005, 0.005], high: [0.02, 0.025]}
  cracks:
    - {points: [[0.004, 0.0153], [0.0105, 0.0153]]}
  constraints:
    - {low: [0, 0], high: [0.03, 0.008], directions: xy, velocity: [0, -$1]}
    - {low: [0, 0.022], high: [0.03, 0.03], directions: xy, velocity: [0, $1]}
  refinement: {energy: 0.5, every: 5}
stages:
  - {name: pull, steps: 240, integrator: verlet, time_step: 3.0e-8, substeps: 1}
output: {$2}
YAML
}
