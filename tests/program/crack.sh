#!/usr/bin/env bash
# crack.csv: its format; the same on any number of ranks; continued by a resumed run; and the results of frana post.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'EOF'
title: A small notched plate
domain: {size: [0.05, 0.02]}
solid:
  spacing: 1.0e-3
  model: plane_stress
  materials:
    - {name: glass, youngs_modulus: 72.0e9, density: 2440, fracture_energy: 135}
  bodies:
    - {shape: rectangle, low: [0, 0], high: [0.05, 0.02]}
  cracks:
    - points: [[0, 0.01], [0.02, 0.01]]
  unbreakable:
    - {low: [0, 0], high: [0.05, 0.002]}
    - {low: [0, 0.018], high: [0.05, 0.02]}
  loads:
    - {edge: {from: [0, 0.02], to: [0.05, 0.02]}, traction: [0, 22.0e6]}
    - {edge: {from: [0, 0], to: [0.05, 0]}, traction: [0, -22.0e6]}
stages:
  - {name: pull, steps: 400, integrator: verlet, time_step: 5.0e-8, substeps: 1}
output: {series_every: 20, fields_every: 100, checkpoint_every: 90, crack: {every: 4}}
EOF
code 0 ranks 1 run scene.yaml --out whole
[ "$(wc -l <whole/crack.csv)" = 103 ] || fail "not 101 rows in crack.csv"
grown=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "length") l = i }
  END { print ($l > 0.005) }' whole/crack.csv)
[ "$grown" = 1 ] || fail "the crack has not grown: the rest would test nothing"
code 0 ranks 3 run scene.yaml --out ranks
same whole/crack.csv ranks/crack.csv

# stopped between two rows, while the crack grows: the tips of the last window come from the file
code 0 ranks 2 run scene.yaml --out stopped --set stages.pull.steps=182
echo step_00000180.h5 >stopped/checkpoint/latest
code 0 ranks 1 run scene.yaml --out stopped --resume
same whole/crack.csv stopped/crack.csv

# no crack asked for, no file
sed 's/, crack: {every: 4}//' scene.yaml >none.yaml
code 0 ranks 1 run none.yaml --out none --set stages.pull.steps=4
[ ! -e none/crack.csv ] || fail "crack.csv of a scene that asks for none"

code 0 "$frana" post whole --film=energy --level 0.3 --magnify 4
grep -q '^level of the damage contour,1,0.3$' whole/post/crack-summary.csv || fail "--level is not kept"
[ -s whole/post/film/energy_0004.png ] || fail "no film"
code 2 "$frana" post whole --film=colour
code 2 "$frana" post whole --level 1.5
code 2 "$frana" run scene.yaml --out other --magnify 3
echo ok
