#!/usr/bin/env bash
# A plate that is refined while it cracks: the same series on any number of ranks, stopped and resumed on another
# number.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
plate() {
  cat <<YAML
title: A plate refined as it tears
domain: {size: [0.02, 0.01]}
solid:
  model: plane_stress
  thickness: 0.002
  spacing: 0.0005
  materials:
    - {name: glass, youngs_modulus: 72e9, density: 2440, fracture_energy: 135}
  bodies:
    - name: plate
      material: glass
      shape: rectangle
      low: [0, 0]
      high: [0.02, 0.01]
      holes: [{shape: disc, centre: [0.0149, 0.0063], radius: 0.0012}]
  cracks:
    - {points: [[0, 0.005], [0.008, 0.005]]}
  constraints:
    - {low: [0.019, 0], high: [0.02, 0.01], directions: x, displacement: [1.0e-6, 0], time: [[0, 0], [3.0e-6, 1]]}
  loads:
    - {edge: {from: [0, 0], to: [0.018, 0]}, traction: [0, -3.0e7], time: [[0, 0], [1.0e-6, 1]]}
    - {edge: {from: [0, 0.01], to: [0.018, 0.01]}, traction: [0, 3.0e7], depth: horizon, time: [[0, 0], [1.0e-6, 1]]}
  initial:
    - {shape: gaussian, along: y, centre: 0.005, width: 0.001, displacement: [1.0e-8, 0]}
  refinement:
    levels: 2
    energy: 0.5
    damage: 0.3
    from: 1.0e-6
    every: $2
    held: $3
    low: [0.004, 0.003]
    high: [0.017, 0.0075]
    start: [{low: [0.0141, 0.001], high: [0.0181, 0.0022], level: 1}]
stages:
  - {name: tear, steps: 120, $4, integrator: $1}
output: {series_every: 10, fields_every: 60, checkpoint_every: 70}
YAML
}
value() { awk -F, -v c="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i } END { print $k }' "$1"; }

for integrator in verlet rk3; do
  # given and automatic steps; checks for refinement at the checkpoint's step and at other steps
  [ $integrator = verlet ] && plate verlet 10 keep 'time_step: 8.0e-8' >scene.yaml
  [ $integrator = rk3 ] && plate rk3 7 refine 'safety: 0.4' >scene.yaml
  code 0 ranks 1 run scene.yaml --out one_$integrator
  if thorough || [ $integrator = verlet ]; then # solid/refine/test_refine_run.c has the others by day
    code 0 ranks "$(by_day 2 3)" run scene.yaml --out three_$integrator
    same one_$integrator/series.csv three_$integrator/series.csv
    code 0 ranks "$(by_day 1 2)" run scene.yaml --out two_$integrator \
      --resume=three_$integrator/checkpoint/step_00000070.h5
    awk -F, 'NR <= 2 || $1 > 70' one_$integrator/series.csv >tail.csv
    same tail.csv two_$integrator/series.csv
  fi
  sed -n 3p one_$integrator/series.csv >first.csv
  (sed -n 1p one_$integrator/series.csv && cat first.csv) >head.csv
  awk "BEGIN { exit !($(value one_$integrator/series.csv particles) > 1.5 * $(value head.csv particles)) }" ||
    fail "nothing has been refined"
  awk "BEGIN { exit !($(value one_$integrator/series.csv bonds_broken) > 1.2 * $(value head.csv bonds_broken)) }" ||
    fail "the crack has not grown"
  grep -q "solid substeps, stable up to" one_$integrator/run.log || fail "the substeps have not followed"
done
h5dump -n one_rk3/fields/solid_00000120.hdf 2>/dev/null | grep -q "/PointData/level" ||
  ! command -v h5dump >/dev/null || fail "no field level"
code 0 ranks 1 check scene.yaml
grep -q "solid, bonds of level 2, velocity Verlet" out || fail "frana check does not say what level 2 allows"
echo ok
