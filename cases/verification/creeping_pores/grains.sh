#!/usr/bin/env bash
# Solves the flow through the grains of `frana init rock` as N^3 voxels, in the folder of runs; the period's edge is 1.
# With cells: on so many cells along an edge alone, without smooth walls.
# usage: grains.sh N [cells]
set -euo pipefail
name="grains as $1 voxels${2:+, $2 cells}" image="grains as $1 voxels.raw"
LC_ALL=C awk -v N="$1" '
  function next_of() { s = 16807 * s % 2147483647; return s / 2147483647 } # as in program/grains.c
  function away(a, b,  d) { d = a > b ? a - b : b - a; d = d < N - d ? d : N - d; return d * d }
  BEGIN {
    s = 79190
    for (g = 0; g < 60; g++) {
      for (c = 0; c < 3; c++) x[g, c] = N * next_of()
      r[g] = (4 + 3 * next_of()) * N / 32
    }
    for (k = 0; k < N; k++) for (j = 0; j < N; j++) {
      n = 0
      for (g = 0; g < 60; g++) {
        left = r[g] * r[g] - away(j + 0.5, x[g, 1]) - away(k + 0.5, x[g, 2])
        if (left > 0) { near[n] = x[g, 0]; most[n++] = left }
      }
      for (i = 0; i < N; i++) {
        is = 0
        for (m = 0; m < n && !is; m++) is = away(i + 0.5, near[m]) < most[m]
        printf "%d", is
      }
    }
  }' | tr 01 '\000\001' >"$image"
edge=${2:-$1}
"$FRANA" permeability "$FRANA_STUDY/scene.yaml" --out "$name" ${2:+--quick} --set "domain.cells=[$edge, $edge, $edge]" \
  --set "solid.bodies=[{name: rock, shape: image, file: '$PWD/$image', size: [$1, $1, $1], type: uint8,
  voxel: $(awk -v n="$1" 'BEGIN { printf "%.12g", 1 / n }'), solid: [1], low: [0, 0, 0]}]"
