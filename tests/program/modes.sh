#!/usr/bin/env bash
# modes.csv: three cuts are three arms at their angle, in a plate and in space; the same on any number of ranks;
# continued by a resumed run.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'EOS'
title: A disc with three cuts
domain: {size: [0.04, 0.04]}
solid:
  spacing: 1.0e-3
  model: plane_stress
  materials:
    - {name: glass, youngs_modulus: 72.0e9, density: 2440, fracture_energy: 135}
  bodies:
    - {shape: disc, centre: [0.02, 0.02], radius: 0.015}
  cracks: # from 5 to 11 mm, at 10, 130 and 250 degrees
    - points: [[0.02492404, 0.02086824], [0.03083289, 0.02191013]]
    - points: [[0.01678606, 0.02383022], [0.01292934, 0.02842649]]
    - points: [[0.0182899, 0.01530154], [0.01623778, 0.00966338]]
stages:
  - {name: rest, steps: 40, integrator: verlet, time_step: 1.0e-7, substeps: 1}
output:
  series_every: 0
  fields_every: 0
  checkpoint_every: 25
  modes: {centre: [0.02, 0.02], radii: [0.006, 0.01, 0.015], highest: 6, every: 10}
EOS
# cell FILE RING MODE STEP COLUMN
cell() {
  awk -F, -v q="$2" -v m="$3" -v s="$4" -v c="$5" 'NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i }
    NR > 2 && $k["step"] == s && $k["ring"] == q && $k["mode"] == m { print $k[c] }' "$1"
}

code 0 ranks 1 run scene.yaml --out whole
[ "$(wc -l <whole/modes.csv)" = 58 ] || fail "not 4 times 2 rings of 7 modes in modes.csv"
for mode in 1 2 4 5; do
  holds "$(cell whole/modes.csv 0 $mode 40 amplitude) < 0.2 * $(cell whole/modes.csv 0 3 40 amplitude)"
done
holds "$(cell whole/modes.csv 0 0 40 amplitude) > 0.05 && $(cell whole/modes.csv 0 3 40 amplitude) > 0.1"
holds "($(cell whole/modes.csv 0 3 40 angle) - 10) ^ 2 < 4"
holds "$(cell whole/modes.csv 1 3 40 inner) == 0.01 && $(cell whole/modes.csv 1 3 40 particles) > 300"

code 0 ranks "$(by_day 2 3)" run scene.yaml --out ranks
same whole/modes.csv ranks/modes.csv
# resumed between two rows: later ones go
echo step_00000025.h5 >ranks/checkpoint/latest
code 0 ranks 1 run scene.yaml --out ranks --resume
grep -q '"resumed_at_step": *25' ranks/run.json || fail "not resumed at step 25"
same whole/modes.csv ranks/modes.csv

# in space, about y: the angle counts from z towards x
cat >block.yaml <<'EOS'
domain: {size: [0.02, 0.01, 0.02]}
solid:
  spacing: 1.0e-3
  materials: [{name: ceramic, youngs_modulus: 1.0e8, density: 3000, fracture_energy: 1}]
  bodies: [{shape: cylinder, centre: [0.01, 0.005, 0.01], radius: 0.0095, length: 0.006, axis: y}]
  cracks: # a cut along +x
    - points: [[0.013, 0, 0.01], [0.02, 0, 0.01], [0.02, 0.01, 0.01], [0.013, 0.01, 0.01]]
stages: [{name: rest, steps: 1, integrator: verlet, time_step: 1.0e-7, substeps: 1}]
output: {fields_every: 0, modes: {centre: [0.01, 0.005, 0.01], axis: [0, 2, 0], radii: [0.004, 0.009], highest: 2}}
EOS
code 0 ranks 2 run block.yaml --out block
holds "($(cell block/modes.csv 0 1 1 angle) - 90) ^ 2 < 1 && $(cell block/modes.csv 0 1 1 amplitude) > 0.05"

# refused with sentences
refused() { # refused SCENE SETTING SENTENCE
  code 2 ranks 1 run "$1" --out refused --set "$2"
  grep -qF "$3" err || fail "$(cat err)"
}
refused scene.yaml output.modes.radii='[0.016, 0.018]' \
  "output.modes.radii: no particle stands between 0.016 and 0.018 m from the axis"
refused scene.yaml output.modes.radii='[0.01, 0.006]' \
  "output.modes.radii[1] = 0.006: must be larger than the radius before it, 0.01 m"
refused scene.yaml output.modes.axis='[0, 1]' "output.modes.axis = [0, 1]: not in a plate"
refused block.yaml output.modes.axis='[0, 0, 0]' "output.modes.axis = [0, 0, 0]: must not be 0 in every direction"
refused block.yaml output.modes.highest=65 "output.modes.highest = 65: must be between 1 and 64"
sed '/modes:/d' scene.yaml >none.yaml
code 0 ranks 1 run none.yaml --out none
[ ! -e none/modes.csv ] || fail "modes.csv without output.modes"

# the report has the modes of the last sample
code 0 ranks 1 post whole
grep -q '^"damage from 0.006 to 0.01 m, largest mode",1,3$' whole/post/summary.csv ||
  fail "$(cat whole/post/summary.csv)"
