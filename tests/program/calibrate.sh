#!/usr/bin/env bash
# frana calibrate measures the bonds of a material by scenes of its own: numbers near those of the cases, the same in
# other units and on other ranks; a run that is done is not made again, and a stopped one goes on.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'SCENE'
title: A plate
domain: {size: [0.1, 0.06]}
solid:
  spacing: 1.0e-3
  model: plane_stress
  materials:
    - {name: a rock, youngs_modulus: 15.0e9, density: 2200, fracture_energy: 30, horizon_ratio: 2}
    - {name: the same, youngs_modulus: 60.0e9, density: 2700, fracture_energy: 100, horizon_ratio: 2}
    - {name: whole, youngs_modulus: 60.0e9, density: 2700}
  bodies:
    - {material: a rock, shape: rectangle, low: [0, 0], high: [0.1, 0.06]}
stages:
  - {name: pull, steps: 10, integrator: verlet}
SCENE
# cell MATERIAL QUANTITY DIRECTION COLUMN: a number of one/calibration.csv
cell() {
  awk -F, -v m="$1" -v q="$2" -v d="$3" -v c="$4" '$1 == m && $2 == q && $3 == d { print $c }' one/calibration.csv
}
# within VALUE LOW HIGH
within() { awk -v v="$1" -v a="$2" -v b="$3" 'BEGIN { exit !(v >= a && v <= b) }' || fail "$1 is not in $2 to $3"; }

code 0 ranks 1 calibrate scene.yaml --quick --out one
cp one/calibration.csv first.csv
# E s0 and the lattice's modulus, 7.7 % too large at m = 2; a crack takes at least the bonds across its plane, at most
# what the strip holds: the first one in which it runs
within "$(cell 'a rock' bar_strength '' 4)" 0.95 1.15
for direction in '[100]' '[110]'; do
  within "$(cell 'a rock' running_crack "$direction" 4)" 1.02 "$(cell 'a rock' running_crack_held "$direction" 4)"
done
within "$(cell 'a rock' running_crack_turns '[110]' 4)" -6 6
# where the tip jumps, relaxations take more than a tenth
within "$(cell 'a rock' creeping_crack_bonds '[100]' 4)" 1.02 \
  "$(awk -v all="$(cell 'a rock' creeping_crack '[100]' 4)" 'BEGIN { print all / 1.1 }')"
within "$(cell 'a rock' notch_first_bond '[100]' 4)" 0.9 "$(cell 'a rock' notch_largest_load '[100]' 4)"
# in the user's units: J/m2, and E s0 of docs/design/solid-bonds.md, 4 pi/9 = E delta s0^2/G0
awk -F, '$2 == "running_crack" { if (($6 / ($4 * ($1 == "the same" ? 100 : 30)) - 1) ^ 2 > 1e-16) exit 1; n++ }
  $2 == "bar_strength" && $1 == "a rock" { s0 = sqrt(4 * atan2(0, -1) / 9 * 30 / 15e9 / 2e-3)
    if (($6 / ($4 * 15e9 * s0) - 1) ^ 2 > 1e-16) exit 1; n++ }
  END { exit n != 5 }' one/calibration.csv || fail "numbers in the scene's units"
# the same bonds with other moduli: the same numbers without a run
awk -F, '$1 == "a rock" { a[$2, $3] = $4; n++ } $1 == "the same" { if ($4 != a[$2, $3]) exit 1; n-- }
  END { exit n != 0 }' one/calibration.csv || fail "materials with the same bonds differ"
[ ! -e "one/the_same" ] || fail "the same bonds were measured twice"
! grep -q whole one/calibration.csv || fail "a material that never breaks is calibrated"
grep -q 'a rock: for a rock of toughness G enter as fracture_energy 0\.[0-9]* G if its cracks run' out ||
  fail "no sentence on what to enter"
# its scenes are scenes
for file in one/a_rock/bar.yaml one/a_rock/running_crack_45_held_1.5.yaml; do code 0 ranks 1 check "$file"; done
[ "$(find one/a_rock -name '*.yaml' ! -name scene.resolved.yaml | wc -l)" -ge 7 ] || fail "scenes are missing"
# a second call makes no run again
touch -d '2001-01-01' one/a_rock/bar/series.csv
code 0 ranks 1 calibrate scene.yaml --quick --out one --quiet
cmp one/calibration.csv first.csv
[ "$(stat -c %Y one/a_rock/bar/series.csv)" -lt 1000000000 ] || fail "a run that was done was made again"
[ "$(grep -c . out)" = 1 ] || fail "--quiet says more than where the table is"
# another scene's numbers are not mixed in
code 4 ranks 1 calibrate scene.yaml --quick --out one --set 'solid.materials[0].horizon_ratio=3'
grep -q 'holds a run of another scene' err || fail "another scene's folder is not refused"

# stopped by its limit of time: what is measured is kept, and the next call goes on
got=75
for limit in "--max-wall 0.3" "--max-wall 0.3" ""; do
  [ "$got" = 75 ] || break
  got=0
  # shellcheck disable=SC2086 # two words
  ranks 2 calibrate scene.yaml --quick --only bar --out two $limit >out 2>err || got=$?
done
[ "$got" = 0 ] || { cat out err >&2; fail "exit code $got after it was stopped"; }
grep -E 'quantity|bar' first.csv | paste -d, - two/calibration.csv |
  awk -F, 'NR > 1 && ($2 != $9 || ($4 / $11 - 1) ^ 2 > 1e-12) { print; bad = 1 } END { exit bad || NR != 3 }' ||
  fail "two ranks differ from one"

refused() {
  local sentence=$1; shift
  code 2 ranks 1 calibrate scene.yaml --out refused "$@"
  grep -qF -- "$sentence" err || { cat err >&2; fail "not said: $sentence"; }
  [ ! -e refused ] || fail "a folder was made: $sentence"
}
refused "no material of the scene has a fracture_energy" --set 'solid.materials[0].fracture_energy=.inf' \
  --set 'solid.materials[1].fracture_energy=.inf'
refused "--only bars: must be of running, creeping, notch and bar" --only bars
echo ok
