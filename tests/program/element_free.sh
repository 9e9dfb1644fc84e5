#!/usr/bin/env bash
# An element-free plate as a user runs it: what frana check prints, files, any number of ranks, a plate in uniform
# tension, and what is refused: with the node or the place, the number and what to change.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cp "$source/cases/verification/element_free/scene.yaml" scene.yaml
crack='solid.cracks[0].points'
code 0 ranks 1 check scene.yaml
grep -q '  nodes      372, ' out || fail "nodes"
grep -q '  unknowns   744, half bandwidth ' out || fail "unknowns"
grep -q '  constraints 28: 3 of given displacements, 10 of jumps and 15 of strains' out || fail "constraints"
grep -q '  cells      720 pieces, 17904 Gauss points' out || fail "cells"
code 0 ranks 1 run scene.yaml --out one --set output.fields_every=1
code 0 ranks 2 run scene.yaml --out two --set output.fields_every=1
cmp one/intensity.csv two/intensity.csv || fail "K depends on the ranks"
[ -s one/fields/solution.hdf ] || fail "no fields"
awk -F, 'NR == 3 { k = $5 / sqrt(atan2(1, 1) * 2) / 2.8246 } END { exit !(k > 0.997 && k < 1.003) }' \
  one/intensity.csv ||
  fail "K: $(cat one/intensity.csv)"
grep -q '"violations": \[' one/run.json || fail "no violations in run.json"

# fields and pictures
for field in cells gauss_points solution; do [ -s "one/fields/$field.hdf" ] || fail "no fields/$field.hdf"; done
awk -F, 'NR > 2 { n[$2]++; if ($2 == 1 && $3 != 0.5) exit 1 } END { exit !(n[0] == 1 && n[1] == 1) }' \
  one/crack_lines.csv || fail "$(cat one/crack_lines.csv)"
if command -v gnuplot >/dev/null; then
  code 0 ranks 1 run scene.yaml --out drawn --set output.fields_every=1 --set solid.spacing=0.25
  code 0 ranks 1 post drawn
  for picture in nodes stress_yy stress_mises shape; do
    [ -s "drawn/post/pictures/$picture.png" ] || fail "no picture $picture"
    grep -q "pictures/$picture.png" drawn/post/report.md || fail "$picture is not in the report"
  done
fi

# a crack that grows: one step, the same on two ranks, whose K and load follow from the first
cp scene.yaml kept.yaml && sed -i 's/, intensity: {radii: \[0.4\]}//' scene.yaml
code 0 ranks 1 check scene.yaml --set solid.element_free.growth='{step: 0.1, steps: 4, toughness: 7}'
grep -q '  growth     at most 4 steps of 0.1 m, 6.4 nodal spacings at the tip' out || fail "$(cat out)"
code 0 ranks 1 run scene.yaml --out grown --set output='{fields_every: 1}' \
  --set solid.element_free='{tip_levels: 2, growth: {step: 0.1, steps: 1, toughness: 7}}'
if thorough; then
  code 0 ranks 2 run scene.yaml --out grown_2 --set output='{fields_every: 0}' \
    --set solid.element_free='{tip_levels: 2, growth: {step: 0.1, steps: 1, toughness: 7}}'
  cmp grown/growth.csv grown_2/growth.csv || fail "growth depends on the ranks"
fi
awk -F, 'NR > 2 { n++; k = $9 * $10 - 7; y = $4 - 1.5; if (k ^ 2 > 1e-12 || y ^ 2 > 1e-14) exit 1
    if (n == 2) e = $9 / 5.537 }
  END { exit !(n == 2 && e > 0.97 && e < 1.03) }' grown/growth.csv || fail "$(cat grown/growth.csv)"
grep -q '"growth_end": "all steps are done"' grown/run.json || fail "$(grep growth grown/run.json)"
if thorough && command -v gnuplot >/dev/null; then
  code 0 ranks 1 post grown
  for plot in pictures/growth plots/growth_k plots/growth_load; do
    [ -s "grown/post/$plot.png" ] || fail "no $plot"
  done
fi

cp kept.yaml scene.yaml

# a plate without a crack, pulled: the energy s^2/(2 E') V is exact, with perturbed and with centroidal nodes too
cat >plain.yaml <<'EOS'
domain: {size: [2, 1]}
solid:
  spacing: 0.1
  model: plane_strain
  method: element_free
  materials: [{name: rubber, youngs_modulus: 10, density: 1, poisson_ratio: 0.45}]
  bodies: [{shape: polygon, outline: [[0, 0], [0, 1], [2, 1], [2, 0]]}]
  constraints:
    - {low: [-0.01, -0.01], high: [0.01, 1.01], directions: x}
    - {low: [-0.01, -0.01], high: [0.01, 0.01], directions: y}
  loads: [{edge: {from: [2, 0], to: [2, 1]}, traction: [1, 0]}]
EOS
for kind in '{kind: lattice}' '{kind: perturbed, perturbation: 0.2}' '{kind: centroidal}'; do
  code 0 ranks 1 run plain.yaml --out "plain_${#kind}" --set "solid.bodies[0].arrangement=$kind"
  awk -F, '$1 == "energy" { d = $3 / (1 - 0.45 ^ 2) * 10 - 1 } END { exit !(NR > 1 && d < 1e-10 && -d < 1e-10) }' \
    "plain_${#kind}/solution.csv" || fail "$kind: not the energy of a uniform stress"
done

# refused WORDS SETTING...: exit code 2 with these words
refused() {
  local words=$1 set=(--set solid.element_free.tip_levels=0) s
  shift
  for s in "$@"; do set+=(--set "$s"); done
  code 2 ranks 1 check scene.yaml "${set[@]}"
  grep -q -- "$words" err || { cat err >&2; fail "not said: $words"; }
  ! grep -Eqi 'lapack|dpbtrf|info *=' err || fail "a library's words: $(cat err)"
}
refused 'solid.bodies.body1: 3e+12 nodes of spacing 1e-06 m take .* GB of memory at least' solid.spacing=1.0e-6
refused 'support = 1.1: the point (.*) sees [0-9]* nodes, .*the nearest node is [0-9]* at (.*Take a larger support' \
  solid.element_free.support=1.1
refused "its end (1.2, 1.5) is 0.2 m outside the body: move it" "$crack=[[0.5, 1.5], [1.2, 1.5]]"
refused "its tip (0.95, 1.5) is 0.05 m from the body's border; .*a nodal spacing away, 0.125 m" \
  "$crack=[[0, 1.5], [0.95, 1.5]]"
refused "0.02 m long; it must be longer than half a nodal spacing" "$crack=[[0.4, 1.5], [0.42, 1.5]]"
refused 'are for straight cracks, two points; here are 3' "$crack=[[0, 1.5], [0.2, 1.5], [0.5, 1.5]]" \
  solid.element_free.basis=tip solid.element_free.support=3
refused 'solid.cracks\[0\]: its point 1, (0.2, 3.5), is not inside the body' "$crack=[[0, 1.5], [0.2, 3.5], [0.5, 1.5]]"
refused 'node [0-9]* at (.*) is in no quadrature point.s support: take more cells' \
  'solid.element_free.cells=[1, 1]' solid.element_free.gauss=1 solid.element_free.gauss_tip=1
refused 'leave the body free to turn; hold it' 'solid.constraints[1].low=[-0.01, -0.01]' \
  'solid.constraints[1].high=[0.01, 0.01]'
refused 'radii\[0\] = 0.6: about the tip (0.5, 1.5) it must be at most 0.5 m' 'output.intensity.radii=[0.6]'
refused 'is not a part of one side' 'solid.loads[0].edge.from=[0, 0.5]'
refused 'poisson_ratio: missing' 'solid.materials=[{name: a, youngs_modulus: 1, density: 1}]'
refused 'poisson_ratio = 0.5: must be greater than -1 and less than 0.5' 'solid.materials[0].poisson_ratio=0.5'
refused 'stages: only in a scene that is stepped' 'stages=[{name: a, steps: 1}]'
refused 'solid.contact: only in a scene that is stepped' 'solid.contact={enabled: false}'
refused 'output.intensity.every = 1: only in a scene that is stepped' output.intensity.every=1
refused 'convex and has straight sides' \
  'solid.bodies=[{shape: polygon, outline: [[0, 0], [1, 0], [0.3, 1], [1, 3], [0, 3]]}]'
growth=solid.element_free.growth
refused 'needs a toughness, or the material' "$growth={step: 0.3}"
refused 'growth.csv has K at every step' "$growth={step: 0.3, toughness: 1}"
sed -i 's/, intensity: {radii: \[0.4\]}//' scene.yaml
refused 'growth.step = 0.1: must be at least two nodal spacings at the tip, 0.25 m' "$growth={step: 0.1, toughness: 1}"
refused 'growth.radius = 0.4: must be at most the step, 0.3 m' "$growth={step: 0.3, radius: 0.4, toughness: 1}"
refused 'must be at most 0.5 m about the tip' "$growth={step: 0.6, toughness: 1}"
refused 'only with basis linear or sqrt_r' "$growth={step: 0.3, toughness: 1}" solid.element_free.basis=tip
refused 'not with crack: diffraction' "$growth={step: 0.3, toughness: 1}" solid.element_free.crack=diffraction
refused 'its edge at (.*) is nearer than a nodal spacing' \
  'solid.bodies[0].holes=[{shape: disc, centre: [0.5, 0.5], radius: 0.45}]'
refused 'a hole of an element-free plate is convex' \
  'solid.bodies[0].holes=[{shape: polygon, outline: [[0.3, 0.4], [0.7, 0.4], [0.5, 0.5], [0.5, 0.8]]}]'
code 3 ranks 1 run scene.yaml --out few --set solid.spacing=0.25 --set solid.element_free.iterations=2
grep -q 'iterations = 2: the constraints are still violated by .* take more iterations' err || fail "$(cat err)"

# A central crack on a row of nodes, whose ends are a support of 2.5 spacings away from nodes: both ends are alike, and
# the constraints are met. Rounding decided which of these supports meet the crack.
cat >central.yaml <<'SCENE'
title: A central crack
domain: {size: [0.4, 0.2]}
solid:
  spacing: 8.0e-3
  model: plane_stress
  method: element_free
  materials: [{name: glass, youngs_modulus: 7.0e10, density: 2400, poisson_ratio: 0.3}]
  bodies: [{name: plate, shape: rectangle, low: [0, 0], high: [0.4, 0.2]}]
  cracks: [{points: [[0.16, 0.1], [0.24, 0.1]]}]
  constraints:
    - {low: [-0.01, -0.01], high: [0.001, 0.001]}
    - {low: [0.399, -0.01], high: [0.41, 0.001], directions: y}
  loads:
    - {edge: {from: [0, 0.2], to: [0.4, 0.2]}, traction: [0, 1.0e6]}
    - {edge: {from: [0, 0], to: [0.4, 0]}, traction: [0, -1.0e6]}
output: {intensity: {radii: [0.016]}}
SCENE
code 0 ranks 1 check central.yaml
[ "$(grep -c 'extension 0.004 m' out)" = 2 ] || fail "the ends of a central crack: $(grep extension out)"
if thorough; then
  code 0 ranks 1 run central.yaml --out central
  awk -F, 'NR > 2 { k[NR] = $5 } END { exit !(k[3] / k[4] > 0.9999 && k[3] / k[4] < 1.0001) }' central/intensity.csv ||
    fail "K of a central crack: $(cat central/intensity.csv)"
fi

# near a Poisson's ratio of 0.5 plane strain locks, and both commands say so
incompressible=(--set solid.model=plane_strain --set solid.materials.0.poisson_ratio=0.49)
code 0 ranks 1 check scene.yaml "${incompressible[@]}"
grep -q 'warning: .* in plane strain: the nodes lock' out || fail "frana check does not say that nodes lock"
code 0 ranks 1 run scene.yaml --out locked --set solid.spacing=0.25 "${incompressible[@]}"
grep -q 'warning: .* in plane strain: the nodes lock' locked/run.log || fail "the log does not say that nodes lock"
code 0 ranks 1 run scene.yaml --out stress --set solid.spacing=0.25 --set solid.materials.0.poisson_ratio=0.49
! grep -q 'nodes lock' stress/run.log || fail "plane stress does not lock"
