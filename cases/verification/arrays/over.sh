#!/usr/bin/env bash
# Prints a quantity over its reference for the array and solid fraction c that the scene's title names. K is the drag
# of a sphere over Stokes' (k = 2 a^2/(9 c K)), F that of a cylinder over mu U (k = sqrt(3)/2 L^2/F), tau the tortuosity
# along a row; all from fundamental solutions summed over the lattice.
# usage: over.sh permeability|tortuosity, in the run folder
title=$(sed -n 's/^title: *//p' scene.resolved.yaml | tr -d "\"'")
awk -F, -v title="$title" -v column="$1" '
  BEGIN {
    n = split("BCC 0.1 3.7656 0 BCC 0.2 7.0417 0 BCC 0.3 12.657 0 FCC 0.1 3.7646 0 FCC 0.2 7.0532 0 " \
      "FCC 0.4 23.915 0 hexagonal 0.1 25.1320 1.0479 hexagonal 0.2 51.1476 1.07103 " \
      "hexagonal 0.4 185.771 1.10056", known, " ")
    for (i = 1; i < n; i += 4) {
      if (known[i] " " known[i + 1] != title) continue
      c = known[i + 1]
      spheres = known[i] == "BCC" ? 2 : 4
      a = (3 * c / (4 * atan2(0, -1) * spheres)) ^ (1 / 3)
      reference = column == "tortuosity" ? known[i + 3] : known[i] == "hexagonal" ? sqrt(3) / 2 / known[i + 2] \
        : 2 * a ^ 2 / (9 * c * known[i + 2])
    }
    if (!reference) { print "no reference for " title > "/dev/stderr"; exit 1 }
  }
  !at { for (i = 1; i <= NF; i++) if ($i == column) at = i; next }
  /^#/ { next }
  { last = $at }
  END { if (reference) printf "%.9g\n", last / reference }' series.csv
