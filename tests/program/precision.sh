#!/usr/bin/env bash
# A block that breaks in mixed precision: resumed in the middle it gives the same rows, and breaks the same bonds as in
# double; frana check says which bodies are swept so; scenes without such a body are refused.
# usage: precision.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >block.yaml <<'E2'
title: A block pulled apart
domain: {size: [0.016, 0.008, 0.006]}
solid:
  spacing: 0.001
  precision: mixed
  materials: [{name: ceramic, youngs_modulus: 1.0e8, density: 3000, fracture_energy: 0.01}]
  bodies: [{name: block, shape: box, low: [0, 0, 0], high: [0.016, 0.008, 0.006]}]
  constraints:
    - {low: [0, 0, 0], high: [0.002, 1, 1]}
    - {low: [0.014, 0, 0], high: [0.016, 1, 1], velocity: [0.06, 0, 0]}
stages: [{name: pull, steps: 100, time_step: 3.0e-6, integrator: verlet, damping_relative: 1.0e12}]
output: {series_every: 5, checkpoint_every: 50, fields_every: 0}
E2
code 0 ranks 1 check block.yaml
grep -q 'precision  the bonds of block are swept in mixed precision' out || fail "check does not say the precision"
code 0 ranks 1 check block.yaml --set solid.precision=double
! grep -q 'swept in' out || fail "check speaks of precision in a scene in double"
code 0 ranks 1 run block.yaml --out whole
# at FOLDER NAME STEP: the column of the series in the row of the step
at() {
  awk -F, -v s="$3" -v n="$2" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    $1 == s { print $at[n] }' "$1/series.csv"
}
[ "$(at whole bonds_broken 100)" -gt "$(at whole bonds_broken 50)" ] || fail "no bond breaks after the middle"
code 0 ranks 1 run block.yaml --out again --resume=whole/checkpoint/step_00000050.h5
awk -F, '$1 > 50' whole/series.csv | cmp - <(awk -F, '$1 > 50' again/series.csv) || fail "other rows after resuming"
for other in "2 mixed" "1 double"; do
  code 0 ranks "${other% *}" run block.yaml --out other --set "solid.precision=${other#* }"
  [ "$(at other bonds_broken 100)" = "$(at whole bonds_broken 100)" ] || fail "$other: other bonds break"
  rm -rf other
done
code 2 ranks 1 check block.yaml --set solid.materials.ceramic.micromodulus=conical
grep -q 'solid.precision = mixed: this scene has no body that can be swept so' err ||
  fail "a list of bonds is not refused"
