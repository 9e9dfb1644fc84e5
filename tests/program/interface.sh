#!/usr/bin/env bash
# A crack along an interface of two materials, in a plate and in space: the same series on other ranks, and resumed in
# the middle on another number of ranks; energy and momentum stay closed.
# usage: interface.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
sed -e '/name: stretch/d; /name: run/s/steps: [0-9]*/steps: 120/' -e 's/\[200, /[80, /g; s/\[60, 20\]/[30, 20]/' \
  -e '/name: above/s/youngs_modulus: 1,/youngs_modulus: 2,/' -e 's/checkpoint_every: .*/checkpoint_every: 60/' \
  "$source/cases/verification/interface/strip.yaml" >strip.yaml
cat >block.yaml <<'E2'
title: Two cubes of different materials fly apart, and tear their interface
domain: {size: [24, 8, 8], periodic: [false, true, true]}
solid:
  spacing: 1
  materials:
    - {name: soft, youngs_modulus: 1, density: 1, fracture_energy: 1.0e-3}
    - {name: stiff, youngs_modulus: 3, density: 2, fracture_energy: 1.0e-3}
  bodies:
    - {name: left, material: soft, shape: box, low: [4, 0, 0], high: [12, 8, 8], velocity: [-2.0e-3, 0, 0]}
    - {name: right, material: stiff, shape: box, low: [12, 0, 0], high: [20, 8, 8], velocity: [1.0e-3, 0, 0]}
  interfaces: [{between: [left, right], fracture_energy: 1.0e-5}]
stages:
  - {name: fly, steps: 120, time_step: 0.2}
output: {series_every: 10, checkpoint_every: 60, fields_every: 0}
E2
for kind in strip block; do
  code 0 ranks 2 run $kind.yaml --out $kind
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 && $1 == 60 { half = $at["crack_area"] }
    END { exit !(half > 0 && $at["crack_area"] >= half && $at["bonds_broken"] > 0) }' $kind/series.csv ||
    fail "$kind: no crack along the interface"
  code 0 ranks 1 run $kind.yaml --out ${kind}_1
  same $kind/series.csv ${kind}_1/series.csv
  code 0 ranks "$(by_day 1 3)" run $kind.yaml --out ${kind}_again --resume=$kind/checkpoint/step_00000060.h5
  sed -n '1,2p' $kind/series.csv >tail.csv && awk -F, 'NR > 2 && $1 > 60' $kind/series.csv >>tail.csv
  same tail.csv ${kind}_again/series.csv
done
# the flight: no momentum, and the energy of the start; the whole interface is torn
awk -F, 'function size(x) { return x < 0 ? -x : x }
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR < 3 { next }
  { sum = $at["e_kinetic_solid"] + $at["e_strain"] + $at["e_fracture"] + $at["e_contact"]
    if (NR == 3) first = sum
    if (size(sum - first) > 0.002 * first || size($at["momentum_x"]) > 1e-12) { print; exit 1 } }
  END { area = $at["crack_area"] / 64
    if (area < 1.013 || area > 1.0132 || $at["fragments"] != 2) { print area; exit 1 } }' \
  block/series.csv || fail "the balance of the flight"
echo ok
