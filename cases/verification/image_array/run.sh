#!/usr/bin/env bash
# Permeability of simple cubic arrays of spheres from images of voxels, which this script writes.
# usage: cases/verification/image_array/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# The place of the centre on the grid, in cells: off its symmetries, at a corner of cells, at the centre of a cell.
declare -A cells_off=([off]="0.25 0.6 0.4" [corner]="0 0 0" [centre]="0.5 0.5 0.5")
radius() { calc "(3 * $1 / (4 * pi)) ^ (1 / 3)"; }
images() { # images N: six images of N^3 voxels, beside the scene and the studies, in $runs/image
  local c place x
  mkdir -p "$runs/image"
  cp "$here"/{*.yaml,over.sh} "$runs/image"
  for c in 0.125 0.343; do
    for place in off corner centre; do
      x=$(awk -v n="$1" '{ for (d = 1; d <= 3; d++) printf "%.17g ", 0.5 + $d / n }' <<<"${cells_off[$place]}")
      # shellcheck disable=SC2086 # three numbers
      "$here/image.sh" "$1" "$(radius $c)" $x >"$runs/image/sphere_${c}_${place}_$1.raw"
    done
  done
}
solid_voxels() { tr -dc '\001' <"$1" | wc -c; }
# compare STUDY N TOLERANCE
compare() {
  local c place k volume
  # d ln k/d ln c, from Zick and Homsy's K at 0.1, 0.125 and 0.2, and at 0.3, 0.343 and 0.4
  local -A slope=([0.125]=-1.144 [0.343]=-2.281)
  for c in 0.125 0.343; do
    for place in off corner centre; do
      k=$(cell "$1" value "$c $place" "$2" permeability)
      near "c = $c at $2^3, $place: k over the reference" 1 "$k" 1 "Zick and Homsy 1982" "$3"
      volume=$(kept "c = $c at $2^3, $place: solid voxels" solid_voxels "$runs/image/sphere_${c}_${place}_$2.raw")
      volume=$(calc "$volume / ($c * $2 ^ 3)")
      shown "c = $c at $2^3, $place: solid voxels' volume over the sphere's" 1 "$volume" 1 "the sphere"
      shown "c = $c at $2^3, $place: k over that of a sphere of the voxels' volume" 1 \
        "$(calc "$k * ($volume) ^ (-1 * (${slope[$c]}))")" 1 "Zick and Homsy 1982"
    done
  done
}
[ "$again" ] || images 32
here=$runs/image study study
compare study 32 0.03
if [ ! "$quick" ]; then
  [ "$again" ] || images 64
  here=$runs/image study study_fine
  compare study_fine 64 0.01
fi
finish
