#!/usr/bin/env bash
# intrinsic.csv: the tensor of permeability of a medium that moves. Slits that open and shut have the k of their widths;
# a body that leaves the box leaves an infinite k; the same on any number of ranks; continued to the bit by a resumed
# run; a scene without the key writes nothing.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# Two plates between two walls, 12 cells apart. The upper one is moved by a cell in ten steps, away from the lower one:
# the slits are 6 and 2 cells wide at first. After 5 steps its faces are in the middle of cells, which are solid then.
cat >scene.yaml <<'E1'
title: A slit that opens, and one that shuts
domain: {size: [0.008, 0.012, 0.008], cells: [8, 12, 8]}
fluid:
  density: 1000
  viscosity: 1.0e-6
  driving: {type: pressure_gradient, value: 1}
  sides:
    x_low: {type: periodic}
    x_high: {type: periodic}
    y_low: {type: wall}
    y_high: {type: wall}
    z_low: {type: periodic}
    z_high: {type: periodic}
solid:
  materials: [{name: soft, youngs_modulus: 1.0e4, density: 1000, fracture_energy: 1, horizon_ratio: 2}]
  bodies:
    - {name: lower, material: soft, shape: box, low: [0, 0, 0], high: [0.008, 0.002, 0.008]}
    - {name: upper, material: soft, shape: box, low: [0, 0.008, 0], high: [0.008, 0.01, 0.008]}
  constraints:
    - {low: [0, 0, 0], high: [0.008, 0.002, 0.008]}
    - {low: [0, 0.008, 0], high: [0.008, 0.01, 0.008], velocity: [0, 0.1, 0]}
coupling: {medium: {low: [0, 0, 0], high: [0.008, 0.012, 0.008]}}
stages:
  - {name: still, steps: 2, solid: rigid, time_step: 1.0e-3}
  - {name: moves, steps: 20, integrator: verlet, time_step: 1.0e-3}
output: {series_every: 5, fields_every: 0, checkpoint_every: 9, permeability_every: 1}
E1
# cell FILE STEP COLUMN
cell() {
  awk -F, -v s="$2" -v c="$3" 'NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i }
    NR > 2 && $k["step"] == s { print $k[c] }' "$1"
}
# slits STEP N1 N2: k along x and z is that of two slits so many cells wide, to the tolerance of the iteration
slits() {
  local k axis
  for axis in xx zz; do
    k=$(cell whole/intrinsic.csv "$1" k_$axis)
    holds "($k / ($2 * ($2 ^ 2 + 2 * ($2 > 0)) + $3 * ($3 ^ 2 + 2 * ($3 > 0))) * 12 * 12 / 1e-6 - 1) ^ 2 < 1e-6"
  done
  [ "$(cell whole/intrinsic.csv "$1" k_yy)" = 0 ] || fail "k along y at step $1"
  [ "$(cell whole/intrinsic.csv "$1" k_xy)" = nan ] || fail "k_xy at step $1"
}
code 0 ranks 1 run scene.yaml --out whole
grep -q "stage moves: intrinsic permeability along x .* mD), y 0: no pores lead through, z" whole/run.log ||
  fail "$(cat whole/run.log)"
[ "$(wc -l <whole/intrinsic.csv)" = 24 ] || fail "not 22 rows"
slits 1 6 2
slits 2 6 2
slits 7 6 1
slits 12 7 1
slits 17 7 0
slits 22 8 0
[ "$(cell whole/intrinsic.csv 1 solved)" = 2 ] || fail "not two solutions"
[ "$(cell whole/intrinsic.csv 2 solved)" = 0 ] || fail "a rigid solid is solved again"

for n in 2 $(by_day "" 3); do
  code 0 ranks $n run scene.yaml --out whole$n
  for step in 1 7 12 22; do
    holds "($(cell whole$n/intrinsic.csv $step k_xx) / $(cell whole/intrinsic.csv $step k_xx) - 1) ^ 2 < 1e-6"
  done
done
ln -s whole whole1

# killed after its checkpoint, and continued
for n in $(by_day "" 1) 2; do
  code 0 ranks $n run scene.yaml --out stopped --set stages.moves.steps=13
  echo step_00000009.h5 >stopped/checkpoint/latest
  code 0 ranks $n run scene.yaml --out stopped --resume
  cmp whole$n/intrinsic.csv stopped/intrinsic.csv || fail "another intrinsic.csv after a checkpoint on $n ranks"
  code 0 ranks $n run scene.yaml --out again --resume=whole$n/checkpoint/stage_still.h5
  awk -F, 'FNR <= 2 { next } FNR == NR { row[$1] = $0; next } row[$1] != $0 { exit 1 }' whole$n/intrinsic.csv \
    again/intrinsic.csv || fail "another intrinsic.csv after a stage on $n ranks"
  rm -r stopped again
done

# a body that leaves the medium's box
sed -e 's/title: .*/title: A body that leaves/' -e '/name: lower/d' -e '/low: \[0, 0, 0\], high: \[0.008, 0.002/d' \
  -e 's/y_low: {type: wall}/y_low: {type: periodic}/' -e 's/y_high: {type: wall}/y_high: {type: periodic}/' \
  -e 's/medium: .*/medium: {low: [0, 0.005, 0], high: [0.008, 0.0105, 0.008]}}/' scene.yaml >leaves.yaml
code 0 ranks "$(by_day 1 2)" run leaves.yaml --out leaves --set stages.moves.steps=30
[ "$(cell leaves/intrinsic.csv 32 k_xx)" = inf ] || fail "$(cat leaves/intrinsic.csv)"
grep -q "intrinsic permeability along x infinite: nothing resists the flow" leaves/run.log || fail "not said"
holds "$(cell leaves/intrinsic.csv 2 k_zz) > 0 && $(cell leaves/intrinsic.csv 2 porosity) < 0.7"

# the apparent k beside it is that of the series
scene >porous.yaml
code 0 ranks 1 run porous.yaml --out porous --set output.permeability_every=20 --set output.series_every=20 \
  --set stages.settle.steps=0 --set stages.fracture.steps=0
[ "$(cell porous/intrinsic.csv 40 apparent)" = "$(cell porous/series.csv 40 permeability)" ] || fail "apparent k"
holds "$(cell porous/intrinsic.csv 40 apparent) > 0.5 * $(cell porous/intrinsic.csv 40 k_xx)"

# nothing for who does not ask, and what it will cost
code 0 ranks 1 run scene.yaml --out none --set output.permeability_every=0
[ ! -e none/intrinsic.csv ] || fail "intrinsic.csv without the key"
cmp none/series.csv whole/series.csv || fail "the series depends on the key"
code 0 ranks 1 check scene.yaml
grep -q "intrinsic  k every 1 steps: 21 times solved through 512 pore cells" out || fail "$(cat out)"
code 0 ranks 1 check scene.yaml --measure
grep -q "s each time from nothing, measured now" out || fail "$(cat out)"
code 2 ranks 1 check scene.yaml --set output.permeability_every=-1
grep -q "output.permeability_every = -1: must be at least 0" err || fail "$(cat err)"

# plot and report
code 0 ranks 1 post whole
grep -q '^"intrinsic permeability along x in mD, after",mD,' whole/post/summary.csv ||
  fail "$(cat whole/post/summary.csv)"
[ -s whole/post/plots/permeability_intrinsic.gp ] || fail "no plot"
code 0 ranks 1 post leaves
grep -q 'infinite: nothing resists the flow' leaves/post/report.md || fail "$(cat leaves/post/report.md)"
