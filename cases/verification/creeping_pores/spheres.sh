#!/usr/bin/env bash
# Solves the flow through arrays of spheres on n^3 cells, in the folder of runs: as shapes, or as voxels.
# usage: spheres.sh n [voxels]
set -euo pipefail
cubic=0.43424534362958006 body=0.329610382525 face=0.287941191148 # radii at c = 0.343, 0.3 and 0.4
if [ "${2-}" ]; then
  "$FRANA_STUDY/solve.sh" "simple cubic as $1 voxels" "$1" "d(0.51, 0.47, 0.5) < ($cubic * N) ^ 2"
  "$FRANA_STUDY/solve.sh" "body-centred as $1 voxels" "$1" \
    "d(0.26, 0.22, 0.25) < ($body * N) ^ 2 || d(0.76, 0.72, 0.75) < ($body * N) ^ 2"
  "$FRANA_STUDY/solve.sh" "face-centred as $1 voxels" "$1" "d(0.01, 0.03, 0) < ($face * N) ^ 2 ||
    d(0.51, 0.53, 0) < ($face * N) ^ 2 || d(0.51, 0.03, 0.5) < ($face * N) ^ 2 || d(0.01, 0.53, 0.5) < ($face * N) ^ 2"
  exit
fi
shapes() { "$FRANA" permeability "$FRANA_STUDY/scene.yaml" --set "domain.cells=[$1, $1, $1]" "${@:3}" --out "$2"; }
shapes "$1" "simple cubic, $1 cells"
shapes "$1" "body-centred, $1 cells" --set "solid.bodies=[{shape: sphere, centre: [0.26, 0.22, 0.25], radius: $body},
  {shape: sphere, centre: [0.76, 0.72, 0.75], radius: $body}]"
