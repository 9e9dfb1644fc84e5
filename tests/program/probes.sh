#!/usr/bin/env bash
# probes.csv: its format; the same on any number of ranks; continued by a resumed run and across a refinement.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'EOS'
title: A pulse into a plate that is refined on the way
domain: {size: [0.03, 0.012]}
solid:
  spacing: 1.0e-3
  model: plane_stress
  materials:
    - {name: glass, youngs_modulus: 72.0e9, density: 2440}
  bodies:
    - {shape: rectangle, low: [0, 0], high: [0.03, 0.012]}
  initial:
    - {shape: gaussian, along: x, centre: 0, width: 0.004, displacement: [1.0e-6, 2.0e-7]}
  refinement: {energy: 0.3, from: 1.0e-6, low: [0.0132, 0], high: [0.02, 0.012], every: 30}
stages:
  - {name: pass, steps: 60, integrator: verlet, time_step: 5.0e-8, substeps: 1}
output:
  series_every: 0
  fields_every: 60
  checkpoint_every: 31
  probes: {at: [[0.0104, 0.0064], [0.0151, 0.0061], [0.029, 0.001]], every: 2}
EOS
# cell FILE PROBE STEP COLUMN
cell() {
  awk -F, -v p="$2" -v s="$3" -v c="$4" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i }
    NR > 2 && $1 == s && $3 == p { print $k }' "$1"
}

code 0 ranks 1 run scene.yaml --out whole
[ "$(wc -l <whole/probes.csv)" = 95 ] || fail "not 31 times 3 rows in probes.csv"
[ "$(sed -n 3p whole/probes.csv | cut -d, -f1-3)" = 0,0,0 ] || fail "no row at the start"
grep -q "particles refined" whole/run.log || fail "nothing is refined: the rest would test nothing"
holds "$(cell whole/probes.csv 0 0 x) == 0.0105 && $(cell whole/probes.csv 0 0 y) == 0.0065"
holds "$(cell whole/probes.csv 1 30 x) == 0.0155 && $(cell whole/probes.csv 1 30 y) == 0.0065"
holds "$(cell whole/probes.csv 1 60 x) == 0.015 && $(cell whole/probes.csv 1 60 y) == 0.006" # a new particle is nearer
# Verlet: x(t + 2 dt) - x(t) = 2 dt v(t + dt) to third order
v=$(cell whole/probes.csv 0 40 velocity_x)
u=$(cell whole/probes.csv 0 42 displacement_x) w=$(cell whole/probes.csv 0 38 displacement_x)
holds "($v) ^ 2 > 1e-4 && (($u) - ($w)) / (2e-7 * ($v)) > 0.99 && (($u) - ($w)) / (2e-7 * ($v)) < 1.01"

code 0 ranks "$(by_day 2 3)" run scene.yaml --out ranks
same whole/probes.csv ranks/probes.csv
# resumed between two rows: later ones go
echo step_00000031.h5 >ranks/checkpoint/latest
code 0 ranks 1 run scene.yaml --out ranks --resume
grep -q '"resumed_at_step": *31' ranks/run.json || fail "not resumed at step 31"
same whole/probes.csv ranks/probes.csv
code 0 ranks 1 run scene.yaml --out later --set stages.pass.steps=55
code 0 ranks 2 run scene.yaml --out later --resume --set stages.pass.steps=60 # from particles that are already refined
same whole/probes.csv later/probes.csv

# the field of the last step has the same energy density
if command -v h5dump >/dev/null; then
  code 0 h5dump -y -w 1 -d /VTKHDF/PointData/energy_density whole/fields/solid_00000060.hdf
  awk -v w="$(cell whole/probes.csv 0 60 energy_density)" '{ sub(",", "") }
    $1 + 0 > 0 && ($1 / w - 1) ^ 2 < 1e-12 { found = 1 }
    END { exit !found }' out || fail "no particle of the field has the probe's energy density"
fi

# in 3D, on a lattice
cat >block.yaml <<'EOS'
domain: {size: [0.02, 0.01, 0.01]}
solid:
  spacing: 1.0e-3
  materials: [{name: ceramic, youngs_modulus: 1.0e8, density: 3000}]
  bodies: [{shape: box, low: [0, 0, 0], high: [0.02, 0.01, 0.01]}]
  body_force: [0, 0, -10]
stages: [{name: fall, steps: 20, integrator: verlet, time_step: 1.0e-6, substeps: 1}]
output: {probes: {at: [[0.01, 0.005, 0.005]]}}
EOS
code 0 ranks 2 run block.yaml --out block
holds "$(cell block/probes.csv 0 20 x) == 0.0095 && $(cell block/probes.csv 0 20 z) == 0.0045"
holds "(-0.5 * 10 * 4e-10 / $(cell block/probes.csv 0 20 displacement_z) - 1) ^ 2 < 1e-18"

code 2 ranks 2 run scene.yaml --out far --set output.probes.at='[[0.01, 0.006], [0.01, 0.0136]]'
grep -q "output.probes.at\[1\]: the nearest particle is 0.00216 m away, more than a spacing" err || fail "$(cat err)"
sed '/probes:/d' scene.yaml >none.yaml
code 0 ranks 1 run none.yaml --out none --set stages.pass.steps=2
[ ! -e none/probes.csv ] || fail "probes.csv of a scene that asks for none"
echo ok
