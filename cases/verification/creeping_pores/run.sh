#!/usr/bin/env bash
# Permeability in creeping flow, solved at once on two grids: slits and a duct of voxels, arrays of spheres. What each
# result is off by is compared with the error that it states.
# usage: cases/verification/creeping_pores/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
value() { awk -F, -v q="$2" '$1 == q { print $2 }' "$runs/$1/permeability.csv"; }
number_of() { kept "$1: $2" value "$1" "$2"; }
# solve NAME K SOURCE SETTING...: k_xx of the scene with these settings, and the reference K
solve() {
  local name=$1 k=$2 source=$3 q set=()
  shift 3
  for q in "$@"; do set+=(--set "$q"); done
  [ "$again" ] || "$frana" permeability "$here/scene.yaml" "${set[@]}" --out "$runs/$name" >"$runs/$name.log"
  for q in k_xx_level_1 k_xx_level_2 k_xx k_xx_error; do
    shown "$name: $q over the reference" 1 "$(calc "$(number_of "$name" $q) / ($k)")" 1 "$source"
  done
  at_most "$name: what k_xx is off by, over its error" 1 \
    "$(calc "($(number_of "$name" k_xx) - ($k)) / $(number_of "$name" k_xx_error)")" 0 "$source" 1
  for q in iterations products; do
    shown "$name: $q on the grid twice as fine" 1 "$(number_of "$name" "${q}_x_level_2")" "" ""
  done
}
# image NAME N CONDITION: N^3 voxels, solid where awk's condition of i, j, k holds; sets the settings of its scene
image() {
  local all="for (k = 0; k < $2; k++) for (j = 0; j < $2; j++) for (i = 0; i < $2; i++)"
  [ "$again" ] || LC_ALL=C awk "BEGIN { $all printf \"%d\", ($3) }" | tr 01 '\000\001' >"$runs/$1.raw"
  settings=("domain.cells=[$2, $2, $2]" "solid.bodies=[{name: rock, shape: image, file: $(realpath -m "$runs/$1.raw"),
    size: [$2, $2, $2], type: uint8, voxel: $(calc "1 / $2"), solid: [1], low: [0, 0, 0]}]")
}
for n in 1 2 3 4 6 8 12; do
  image "slit of $n voxels" 16 "j < 2 || j >= 2 + $n"
  solve "slit of $n voxels" "($n / 16) ^ 3 / 12" "plane Poiseuille flow" "${settings[@]}"
done
image "duct of 8 x 8 voxels" 16 'j >= 8 || k >= 8'
solve "duct of 8 x 8 voxels" '0.0351442537 / 16' "Fourier series" "${settings[@]}"
a=$(calc '(3 * 0.3 / (8 * pi)) ^ (1 / 3)')
for n in 12 16 $([ "$quick" ] || echo 24 32); do
  solve "simple cubic, $n cells" 0.00793338 "Zick and Homsy 1982" "domain.cells=[$n, $n, $n]"
  solve "body-centred, $n cells" "2 * $a ^ 2 / (9 * 0.3 * 12.657)" "Zick and Homsy 1982" "domain.cells=[$n, $n, $n]" \
    "solid.bodies=[{shape: sphere, centre: [0.26, 0.22, 0.25], radius: $a},
      {shape: sphere, centre: [0.76, 0.72, 0.75], radius: $a}]"
done
finish
