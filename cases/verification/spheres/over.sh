#!/usr/bin/env bash
# Prints a quantity over its reference at this solid fraction c. k/L^2 = 2 (a/L)^2/(9 c K) with K of Zick and Homsy,
# with one more digit, and for c = 0.2 of Sangani and Acrivos' series. The tortuosities are from fundamental solutions summed over the lattice.
# usage: over.sh permeability|tortuosity, in the run folder
radius=$(sed -n 's/^ *radius: *\([^ ,}]*\).*/\1/p' scene.resolved.yaml | head -1)
awk -F, -v a="$radius" -v column="$1" '
  BEGIN {
    n = split("0.027 2.00775 0 0.064 2.81020 0 0.125 4.29159 1.0097 " \
      "0.2 6.77592 0 0.216 7.44195 0 0.343 15.3995 1.0159 0.45 28.086 0", known, " ")
    c = 4 * atan2(0, -1) / 3 * a ^ 3
    for (i = 1; i < n; i += 3)
      if ((c / known[i] - 1) ^ 2 < 1e-8)
        reference = column == "permeability" ? 2 * a ^ 2 / (9 * c * known[i + 1]) : known[i + 2]
    if (!reference) { print "no reference for c = " c > "/dev/stderr"; exit 1 }
  }
  !at { for (i = 1; i <= NF; i++) if ($i == column) at = i; next }
  /^#/ { next }
  { last = $at }
  END { if (reference) printf "%.9g\n", last / reference }' series.csv
