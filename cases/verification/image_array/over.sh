#!/usr/bin/env bash
# Prints the permeability over that of the sphere which the image shows: k/L^2 = 2 (a/L)^2/(9 c K) with K of Zick and
# Homsy, with one more digit. The solid fraction c is in the image's name.
# usage: over.sh, in the run folder
c=$(sed -n 's/^ *file: .*sphere_\([0-9.]*\)_.*/\1/p' scene.resolved.yaml)
awk -F, -v c="$c" '
  BEGIN {
    K["0.125"] = 4.29159; K["0.343"] = 15.3995
    if (!(c in K)) { print "no reference for c = " c > "/dev/stderr"; exit 1 }
    a = (3 * c / (16 * atan2(1, 1))) ^ (1 / 3)
    reference = 2 * a ^ 2 / (9 * c * K[c])
  }
  !at { for (i = 1; i <= NF; i++) if ($i == "permeability") at = i; next }
  /^#/ { next }
  { last = $at }
  END { if (reference) printf "%.9g\n", last / reference }' series.csv
