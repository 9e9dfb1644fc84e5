#!/usr/bin/env bash
# Prints a quantity of the run in the current folder over its reference for an array of spheres or cylinders of solid
# fraction c. k/L^2 is 2 (a/L)^2/(9 c K) of spheres, with the drag K over Stokes' of Zick and Homsy (1982), and mu U/F
# of cylinders, with the force F per length of Sangani and Acrivos (1982), with more digits. From fundamental solutions
# summed over the lattice are the tortuosities along a row, all numbers of BCC, FCC and hexagonal, and K of a simple
# cubic array at c = 0.2.
# usage: over.sh simple|square permeability|tortuosity         c from the scene's first radius, in a period of 1
#        over.sh image permeability                            simple cubic; c is in the image's name
#        over.sh title permeability|tortuosity                 array and c are the scene's title, as BCC 0.1
set -euo pipefail
of() { sed -n "s/$1/\1/p" scene.resolved.yaml | head -1 | tr -d "\"'"; }
array=$1 c=
case $1 in
  image) array=simple c=$(of '^ *file: .*sphere_\([0-9.]*\)_.*') ;;
  title) read -r array c <<<"$(of '^title: *\(.*\)')" ;;
esac
awk -F, -v array="$array" -v c="$c" -v a="$(of '^ *radius: *\([^ ,}]*\).*')" -v column="$2" '
  BEGIN { # array, c, K or mu U/F, tortuosity; of hexagonal F
    pi = atan2(0, -1)
    n = split("simple 0.027 2.00775 0 simple 0.064 2.81020 0 simple 0.125 4.29159 1.0097 simple 0.2 6.77592 0 " \
      "simple 0.216 7.44195 0 simple 0.343 15.3995 1.0159 simple 0.45 28.086 0 " \
      "square 0.1 0.0402711 1.0176 square 0.2 0.0194073 1.01897 square 0.4 0.00458938 1.0195 " \
      "square 0.5 0.00187776 1.02003 BCC 0.1 3.7656 0 BCC 0.2 7.0417 0 BCC 0.3 12.657 0 FCC 0.1 3.7646 0 " \
      "FCC 0.2 7.0532 0 FCC 0.4 23.915 0 hexagonal 0.1 25.1320 1.0479 hexagonal 0.2 51.1476 1.07103 " \
      "hexagonal 0.4 185.771 1.10056", known, " ")
    spheres["simple"] = 1; spheres["BCC"] = 2; spheres["FCC"] = 4
    if (c == "") c = array == "square" ? pi * a ^ 2 : 4 * pi / 3 * a ^ 3
    else if (array in spheres) a = (3 * c / (4 * pi * spheres[array])) ^ (1 / 3)
    for (i = 1; i < n; i += 4)
      if (known[i] == array && (c / known[i + 1] - 1) ^ 2 < 1e-8)
        reference = column == "tortuosity" ? known[i + 3] : array == "square" ? known[i + 2] \
          : array == "hexagonal" ? sqrt(3) / 2 / known[i + 2] : 2 * a ^ 2 / (9 * c * known[i + 2])
    if (!reference) { print "no reference for " array ", c = " c > "/dev/stderr"; exit 1 }
  }
  !at { for (i = 1; i <= NF; i++) if ($i == column) at = i; next }
  /^#/ { next }
  { last = $at }
  END { if (reference) printf "%.9g\n", last / reference }' series.csv
