#!/usr/bin/env bash
# An indenter that moves into a block and into a plate whose limits follow the other bonds: the same series and forces
# on other ranks, and resumed in the middle on another number of ranks; mistakes are refused with sentences.
# usage: indenter.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >block.yaml <<'E2'
title: A sphere shoots into a block
domain: {size: [12, 12, 12]}
solid:
  spacing: 1
  partial_volume: ramp_cut
  materials:
    - {name: glass, youngs_modulus: 1, density: 1, horizon_ratio: 2, breakage: {law: brittle, s00: 0.01, alpha: 0.25}}
  bodies: [{shape: box, low: [2, 2, 2], high: [10, 8, 10]}]
  indenters: [{shape: sphere, centre: [6, 10.1, 6.2], radius: 2, velocity: [0.02, -0.1, 0], stiffness: 1}]
stages: [{name: shoot, steps: 80, time_step: 0.3, integrator: verlet, substeps: 1}]
output: {series_every: 10, checkpoint_every: 40, fields_every: 0}
E2
sed -e 's/\[12, 12, 12\]/[12, 12]/; s/spacing: 1$/&\n  model: plane_stress/' \
  -e 's/shape: box/shape: rectangle/; s/\[2, 2, 2\]/[2, 2]/' \
  -e 's/\[10, 8, 10\]/[10, 8]/; s/\[6, 10.1, 6.2\]/[6, 10.1]/; s/-0.1, 0\]/-0.1]/; s/ramp_cut/exact/' \
  -e 's/, integrator: verlet, substeps: 1//' block.yaml >plate.yaml
code 0 ranks 1 check block.yaml
grep -q 'glass: s0 = 0.01 - 0.25 times the smallest stretch' out || fail "check does not say the limit"
for kind in block plate; do
  code 0 ranks 2 run $kind.yaml --out $kind
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 && $1 == 40 { half = $at["bonds_broken"] }
    END { exit !(half > 0 && $at["bonds_broken"] > half && $at["work_load"] > 0) }' $kind/series.csv ||
    fail "$kind: bonds do not break before and after the middle"
  awk -F, 'NR > 2 && ($3 != 2 || $7 >= 0 || $5 < 1) { exit 1 }' <(tail -n 4 $kind/reactions.csv) ||
    fail "$kind: the indenter does not push down"
  code 0 ranks 1 run $kind.yaml --out ${kind}_1
  same $kind/series.csv ${kind}_1/series.csv
  code 0 ranks "$(by_day 1 3)" run $kind.yaml --out ${kind}_again --resume=$kind/checkpoint/step_00000040.h5
  sed -n '1,2p' $kind/series.csv >tail.csv && awk -F, 'NR > 2 && $1 > 40' $kind/series.csv >>tail.csv
  same tail.csv ${kind}_again/series.csv
done
# refused SENTENCE SED: the block, changed by sed, is refused with the sentence
refused() {
  sed "$2" block.yaml >bad.yaml
  code 2 ranks 1 check bad.yaml
  grep -qF -- "$1" err || { cat err >&2; fail "not said: $1"; }
}
refused "solid.indenters[0].stiffness = 0: must be greater than 0" 's/stiffness: 1/stiffness: 0/'
refused "solid.indenters[0].radius = -2: must be greater than 0" 's/radius: 2/radius: -2/'
refused "solid.indenters[0].shape = box: must be sphere" 's/shape: sphere/shape: box/'
refused "solid.materials[0].breakage.s00 = 0.01: stands instead of fracture_energy: give one of the two" \
  's/breakage/fracture_energy: 1, &/'
refused "solid.materials[0].breakage.alpha = -1: must be at least 0" 's/alpha: 0.25/alpha: -1/'
refused "solid.materials[0].breakage.s00 = 0.01: only together with alpha" 's/, alpha: 0.25//'
refused "solid.materials[0].breakage.s00 = 0.01: only with law brittle, here it is bilinear" \
  's/law: brittle/law: bilinear, tensile_strength: 1/'
refused "solid.indenters: cannot go with stages[0].relax: indenters push in time steps only" \
  's/, time_step: .*/, relax: true}]/'
refused "solid.materials[0].breakage.s00 = 0.01: does not go with stages[0].relax" 's/, time_step: .*/, relax: true}]/'
echo ok
