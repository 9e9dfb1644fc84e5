#!/usr/bin/env bash
# Prints a number of the crack of a run in the current folder.
# usage: cases/crack.sh meet RUN AXIS REACH          where the branches meet
#        cases/crack.sh top RUN WINDOW               top speed
#        cases/crack.sh unsymmetric RUN AXIS SPACING particles without a mirror image; needs h5dump (Debian: hdf5-tools)
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# meet RUN AXIS REACH: x (m) at which the branch's path meets the axis y = AXIS. The path is a straight line, fitted by
# least squares to the positions of the left tip, from the x at which undamaged particles first separate the branches
# and over a length of REACH
meet() {
  local from
  from=$(sed -n 's/^"branching, x",m,//p' "$1/post/crack-summary.csv")
  [ -z "$from" ] || awk -F, -v p="$from" -v axis="$2" -v reach="$3" '
    NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i }
    NR > 2 { x = $k["left_x"]; y = $k["left_y"] - axis }
    NR > 2 && x >= p && x <= p + reach && !seen[x]++ { n++; sx += x; sy += y; sxx += x * x; sxy += x * y }
    END { b = (n * sxy - sx * sy) / (n * sxx - sx * sx);
      if (b > 0) printf "%.6g\n", (sx - sy / b) / n }' "$1/crack.csv"
}
# top RUN WINDOW: largest speed (m/s) of the upper tip, from consecutive windows of WINDOW seconds (000: eq. 41)
top() {
  awk -F, -v window="$2" '
    NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i }
    NR < 3 { next }
    { now = int($k["t"] / window + 1e-6) }
    NR == 3 || now > last {
      if (NR > 3) { v = sqrt(($k["left_x"] - x) ^ 2 + ($k["left_y"] - y) ^ 2) / ($k["t"] - t); if (v > most) most = v }
      last = now; x = $k["left_x"]; y = $k["left_y"]; t = $k["t"] }
    END { printf "%.6g\n", most }' "$1/crack.csv"
}
# unsymmetric RUN AXIS SPACING: how many particles are not, to the bit, the mirror image of another about y = AXIS
unsymmetric() {
  local state
  state=$("$(dirname "${BASH_SOURCE[0]}")/symmetric.sh" "$@") || true
  awk '{ print $1 == "symmetric" ? 0 : $1 == "unsymmetric" ? $2 : "" }' <<<"$state"
}
"$@"
