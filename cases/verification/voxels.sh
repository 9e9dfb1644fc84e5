#!/usr/bin/env bash
# Writes an image of N^3 voxels, one byte each, x first: 1 where awk's CONDITION of i, j, k holds, else 0. In it
# d(x, y, z) is the squared distance, in voxels, of the voxel's centre from that point of the periodic cube of edge 1.
# usage: voxels.sh N CONDITION >IMAGE.raw
set -euo pipefail
LC_ALL=C awk -v N="$1" '
  function p(x) { return (x - N * int(x / N + 99.5) + 99 * N) ^ 2 }
  function d(x, y, z) { return p(i + 0.5 - x * N) + p(j + 0.5 - y * N) + p(k + 0.5 - z * N) }
  BEGIN { for (k = 0; k < N; k++) for (j = 0; j < N; j++) for (i = 0; i < N; i++) printf "%d", ('"$2"') }
' | tr 01 '\000\001'
