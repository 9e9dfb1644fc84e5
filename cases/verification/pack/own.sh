#!/usr/bin/env bash
# Prints, in a run folder, the load along x on one sphere of the pack over what the body force gives the fluid in the
# box (0.1 N), and with 0 for a sphere the load on all, by the series. A particle's volume is a cell's.
# usage: own.sh SPHERE
set -euo pipefail
. "$FRANA_STUDY/../../common.sh"
all=$(awk -F, '!at { for (i = 1; i <= NF; i++) if ($i == "load_x") at = i; next } /^#/ { next }
  { last = $at } END { printf "%.9g\n", last / 0.1 }' series.csv)
[ "$1" != 0 ] || { echo "$all"; exit; }
fields=$(printf '%s\n' fields/solid_*.hdf | tail -n 1)
cells=$(sed -n 's/^ *cells: *\[ *\([0-9]*\).*/\1/p' scene.resolved.yaml | head -n 1)
paste -d ' ' <(h5_values "$fields" VTKHDF/PointData/body %d 1) <(h5_values "$fields" VTKHDF/PointData/load %.12g 3) |
  awk -v body=$(($1 - 1)) -v n="$cells" '
    $1 == body { own += $2 / n ^ 3 / 0.1 }
    END { printf "%.9g\n", own }'
