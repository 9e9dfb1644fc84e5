#!/usr/bin/env bash
# Permeability in creeping flow on two grids: slits, a duct and edges of voxels, spheres as shapes and as voxels. What
# each result is off by is compared with the error that it states.
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
  local d="function p(x) { return (x - $2 * int(x / $2 + 99.5) + 99 * $2) ^ 2 }
    function d(x, y, z) { return p(i + 0.5 - x * $2) + p(j + 0.5 - y * $2) + p(k + 0.5 - z * $2) }"
  [ "$again" ] || LC_ALL=C awk "$d BEGIN { $all printf \"%d\", ($3) }" | tr 01 '\000\001' >"$runs/$1.raw"
  settings=("domain.cells=[$2, $2, $2]" "solid.bodies=[{name: rock, shape: image, file: $(realpath -m "$runs/$1.raw"),
    size: [$2, $2, $2], type: uint8, voxel: $(calc "1 / $2"), solid: [1], low: [0, 0, 0]}]")
}
for n in 1 2 3 4 6 8 12; do
  image "slit of $n voxels" 16 "j < 2 || j >= 2 + $n"
  solve "slit of $n voxels" "($n / 16) ^ 3 / 12" "plane Poiseuille flow" "${settings[@]}"
done
image "duct of 8 x 8 voxels" 16 'j >= 8 || k >= 8'
solve "duct of 8 x 8 voxels" '0.0351442537 / 16' "Fourier series" "${settings[@]}"
image "columns of 2 x 2 voxels" 8 'i != 3 && i != 4 ? 0 : j == 3 || j == 4'
solve "columns of 2 x 2 voxels" '3.3378 / 64' "this program, extrapolated from 64 to 256 cells" "${settings[@]}"
image "stairs of 1 voxel" 8 '(i - j + 8) % 8 >= 4'
solve "stairs of 1 voxel" '0.0971 / 64' "this program, extrapolated from 64 to 256 cells" "${settings[@]}"
a=$(calc '(3 * 0.3 / (8 * pi)) ^ (1 / 3)') f=$(calc '(3 * 0.4 / (16 * pi)) ^ (1 / 3)')
for n in 12 16 $([ "$quick" ] || echo 24 32); do
  solve "simple cubic, $n cells" 0.00793338 "Zick and Homsy 1982" "domain.cells=[$n, $n, $n]"
  solve "body-centred, $n cells" "2 * $a ^ 2 / (9 * 0.3 * 12.657)" "Zick and Homsy 1982" "domain.cells=[$n, $n, $n]" \
    "solid.bodies=[{shape: sphere, centre: [0.26, 0.22, 0.25], radius: $a},
      {shape: sphere, centre: [0.76, 0.72, 0.75], radius: $a}]"
done
# voxels NAME K A CENTRE...: spheres of radius A cut into n^3 voxels; their k, and k of the smooth solid, over K
voxels() {
  local name="$1 as $n voxels" k=$2 a=$3 q condition=0
  for q in "${@:4}"; do condition+=" || d($q) < ($a * $n) ^ 2"; done
  image "$name" "$n" "$condition"
  [ "$again" ] || "$frana" permeability "$here/scene.yaml" --set "${settings[0]}" --set "${settings[1]}" \
    --out "$runs/$name" >"$runs/$name.log"
  for q in k_xx_level_1 k_xx_level_2 k_xx k_xx_error k_xx_smooth; do
    shown "$name: $q over that of spheres" 1 "$(calc "$(number_of "$name" $q) / ($k)")" 1 "Zick and Homsy 1982"; done
}
for n in 12 16 $([ "$quick" ] || echo 24); do
  voxels "simple cubic" 0.00793338 0.43424534362958006 '0.51, 0.47, 0.5'
  voxels "body-centred" "2 * $a ^ 2 / (9 * 0.3 * 12.657)" "$a" '0.26, 0.22, 0.25' '0.76, 0.72, 0.75'
  voxels "face-centred" "2 * $f ^ 2 / (9 * 0.4 * 23.915)" "$f" 0.01,0.03,0 0.51,0.53,0 0.51,0.03,0.5 0.01,0.53,0.5
done
finish
