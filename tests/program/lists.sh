#!/usr/bin/env bash
# Bodies of several shapes across periodic sides in a flow: the same on any number of ranks, when resumed, and when
# everything is moved by a part of the period; by a list in the scene, by a list in a file and by pieces.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# body CONTACTS Y Z: three spheres that overlap, moved by Y and Z m; the first is on the corner of the domain
spheres() { awk -v y="$1" -v z="$2" 'function in_period(x) { return x >= 0.08 ? x - 0.08 : x }
  { printf "%g %g %g %g\n", $1, in_period($2 + y), in_period($3 + z), $4 }' <<<'0.001 0.003 0.002 0.0191
0.028 0.013 0.022 0.0203
0.054 0.007 0.077 0.0221'; }
listed() { spheres "$1" "$2" | sed 's/ /, /g; s/.*/[&]/' | paste -sd, ; }
body() { echo "solid.bodies=[{shape: spheres, contacts: $1, spheres: [$(listed "$2" "$3")]}]"; }
cat >scene.yaml <<YAML
title: Spheres across the sides
domain: {size: [0.08, 0.08, 0.08], cells: [16, 16, 16]}
fluid:
  density: 1000
  viscosity: 1.0e-3
  initial: {velocity: [0.1, 0, 0]}
  sides:
$(periodic {x,y,z}_{low,high})
  driving: {type: pressure_gradient, value: 100}
solid:
  materials: [{name: soft, youngs_modulus: 1.0e6, density: 3000, horizon_ratio: 2}]
  bodies: [{shape: sphere, centre: [0, 0, 0], radius: 0.01}]
  constraints: [{low: [0, 0, 0], high: [0.02, 0.08, 0.08]}]
  initial: [{shape: sine, along: x, centre: 0, width: 0.08, displacement: [1.0e-4, 0, 0]}]
stages:
  - {name: flow, steps: 6, time_step: 1.0e-3, solid: rigid}
  - {name: move, steps: 14, time_step: 1.0e-3, integrator: verlet, damping_absolute: 10}
output: {series_every: 2, checkpoint_every: 12}
YAML
last() {
  awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) k = i } END { print $k }' "$1/series.csv"
}
# each body on one other number of ranks
declare -A on=([bonded-lattice]=2 [bonded-shape]=$(by_day 2 3) [broken-lattice]=$(by_day 2 3)
  [broken-shape]=$(by_day 2 4))
for contacts in bonded broken; do
  for surface in lattice shape; do
    name=$contacts-$surface
    with=(--set "$(body $contacts 0 0)" --set "coupling.surface=$surface")
    code 0 ranks 1 run scene.yaml --out $name-1 "${with[@]}"
    n=${on[$name]}
    code 0 ranks "$n" run scene.yaml --out $name-$n "${with[@]}"
    same $name-1/series.csv $name-$n/series.csv
    code 0 ranks 2 run scene.yaml --out $name-again "${with[@]}" \
      --resume="$(ls $name-1/checkpoint/step_*.h5 | head -n 1)"
    awk -F, 'NR == FNR { if (FNR > 2) first = first ? first : $1; next } FNR <= 2 || $1 >= first' \
      $name-again/series.csv $name-1/series.csv >tail.csv
    same tail.csv $name-again/series.csv
    code 0 ranks 1 run scene.yaml --out $name-moved --set "$(body $contacts 0.03 0.045)" \
      --set coupling.surface=$surface
    same $name-1/series.csv $name-moved/series.csv
    awk -v a="$(last $name-1 porosity)" -v b="$(last bonded-lattice-1 porosity)" \
      'BEGIN { exit !(a > 0 && (a - b)^2 < 1e-26) }' || fail "$name has another porosity"
    awk -v e="$(last $name-1 e_strain)" 'BEGIN { exit !(e > 0) }' || fail "$name is not strained"
  done
done
[ "$(last bonded-shape-1 bonds_broken)" = 0 ] || fail "bonds of one solid are broken"
[ "$(last broken-shape-1 bonds_broken)" -gt 0 ] || fail "no bonds are broken between shapes"

spheres 0 0 >list.txt
code 0 ranks 1 run scene.yaml --out file --set coupling.surface=shape \
  --set "solid.bodies=[{shape: spheres, contacts: broken, file: $PWD/list.txt}]"
cmp broken-shape-1/series.csv file/series.csv || fail "a list in a file is another"
tr ' ' ',' <list.txt >commas.txt # which separate
code 0 ranks 1 check scene.yaml --set "solid.bodies=[{shape: spheres, file: $PWD/commas.txt}]"
for line in "0,5 0,5 1 1" "0,5, 0,5, 1, 1"; do # which may be decimal points
  echo "$line" >decimal.txt
  code 2 ranks 1 check scene.yaml --set "solid.bodies=[{shape: spheres, file: $PWD/decimal.txt}]"
  grep -q 'line 1: has a comma between two digits, and blanks' err || fail "$line: $(cat err)"
done
code 0 ranks 1 run scene.yaml --out pieces --set coupling.surface=shape --set "solid.bodies=[{shape: sphere, \
  contacts: broken, centre: [0.001, 0.003, 0.002], radius: 0.0191, pieces: [{shape: sphere, centre: [0.028, 0.013, \
  0.022], radius: 0.0203}, {shape: sphere, centre: [0.054, 0.007, 0.077], radius: 0.0221}]}]"
cmp broken-shape-1/series.csv pieces/series.csv || fail "pieces are another body"
echo ok
