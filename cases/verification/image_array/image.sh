#!/usr/bin/env bash
# Writes a cube of N^3 voxels in a box of edge 1, one byte each, x first: 1 where a voxel's centre is inside the sphere,
# else 0.
# usage: image.sh N RADIUS X Y Z >IMAGE.raw
set -euo pipefail
LC_ALL=C awk -v n="$1" -v a="$2" -v x="$3" -v y="$4" -v z="$5" 'BEGIN {
    for (k = 0; k < n; k++)
      for (j = 0; j < n; j++)
        for (i = 0; i < n; i++)
          printf "%d", ((i + 0.5) / n - x) ^ 2 + ((j + 0.5) / n - y) ^ 2 + ((k + 0.5) / n - z) ^ 2 < a ^ 2
  }' | tr 01 '\000\001'
