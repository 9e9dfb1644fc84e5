#!/usr/bin/env bash
# Solves the flow through an image of N^3 voxels (voxels.sh), in the folder of runs.
# usage: solve.sh NAME N CONDITION
set -euo pipefail
"$FRANA_STUDY/../voxels.sh" "$2" "$3" >"$1.raw"
voxel=$(awk -v n="$2" 'BEGIN { printf "%.12g", 1 / n }')
"$FRANA" permeability "$FRANA_STUDY/scene.yaml" --out "$1" --set "domain.cells=[$2, $2, $2]" --set "solid.bodies=[
  {name: rock, shape: image, file: '$PWD/$1.raw', size: [$2, $2, $2], type: uint8, voxel: $voxel, solid: [1],
   low: [0, 0, 0]}]"
