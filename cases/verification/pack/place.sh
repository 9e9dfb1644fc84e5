#!/usr/bin/env bash
# Prints the spheres of scene.yaml: random places in a periodic box of 1 m, radius 1/6 m, none nearer to another, or to
# an image of it, than 1/24 m, none nearer to a side than 1/96 m. usage: place.sh [SEED [SPHERES]]
awk -v seed="${1:-1}" -v most="${2:-10}" '
  function uniform() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 } # minimal standard generator
  BEGIN {
    n = 0; a = 1 / 6; gap = 1 / 24; low = a + 1 / 96
    for (try = 0; n < most && try < 1000000; try++) {
      for (c = 0; c < 3; c++) x[n, c] = low + (1 - 2 * low) * uniform()
      for (i = 0; i < n; i++) {
        sum = 0
        for (c = 0; c < 3; c++) {
          d = x[n, c] - x[i, c]
          d -= d > 0.5 ? 1 : d < -0.5 ? -1 : 0
          sum += d * d
        }
        if (sum < (2 * a + gap) ^ 2) break
      }
      if (i == n) n++
    }
    if (n < most) { print "only " n " spheres fit" > "/dev/stderr"; exit 1 }
    for (i = 0; i < n; i++)
      printf "    - {name: sphere%d, shape: sphere, centre: [%.6f, %.6f, %.6f], radius: 0.16666667}\n", i + 1, x[i, 0],
        x[i, 1], x[i, 2]
  }'
