#!/usr/bin/env bash
# Prints, in a run folder of split.yaml, one number of the disc's crack:
#   first    the force when the first bond breaks, over that at which 2 F/(pi D) = E s0
#   off      the largest distance from the loaded diameter of a particle with a damage above 0.35, spacings
#   length   how far such particles reach along it, over the diameter
# Needs h5dump. usage: split.sh first|off|length
# shellcheck disable=SC2016 # awk in single quotes
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../common.sh"
if [ "$1" = first ]; then
  awk -F, "$names"' $k["bonds_broken"] > 0 { printf "%.10g\n", 0.75 * $k["t"] / 1200; exit }' series.csv
  exit
fi
file=$(printf '%s\n' fields/solid_*.hdf | tail -n 1)
paste -d ' ' <(h5_values "$file" VTKHDF/Points %.6g 3) <(h5_values "$file" VTKHDF/PointData/damage %.9g 1) |
  awk -v what="$1" '$4 > 0.35 { x = $1 - 35.5; y = $2 - 35.5; if (x < 0) x = -x; if (x > off) off = x
    if (!n++ || y < low) low = y; if (n == 1 || y > high) high = y }
    END { printf "%.10g\n", what == "off" ? off : (high - low) / 60; exit !n }'
