#!/usr/bin/env bash
# Prints a number of the crack of a run in the current folder.
# usage: cases/crack.sh meet RUN AXIS REACH          where the branches meet
#        cases/crack.sh top RUN WINDOW               top speed
#        cases/crack.sh unsymmetric RUN AXIS SPACING particles without a mirror image; needs h5dump (Debian: hdf5-tools)
#        cases/crack.sh symmetric RUN AXIS SPACING   "symmetric N", or "unsymmetric K of N" and exit code 1
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
# symmetric RUN AXIS SPACING: compares the state at a run's end with its mirror image about y = AXIS, to the last bit.
# Prints "symmetric N" or "unsymmetric K of N" particles, and then returns 1. The initial positions X0 are the last
# field's positions minus its displacements, rounded to SPACING/1000. The displacements and velocities that are compared
# are the checkpoint's doubles, printed with 17 digits.
symmetric() {
  local run=$1 axis=$2 spacing=$3 field state
  field=$(ls "$run"/fields/solid_*.hdf | tail -n 1)
  state=$(ls "$run"/checkpoint/stage_*.h5 | tail -n 1)
  paste -d ' ' \
    <(h5_values "$field" /VTKHDF/Points %.17g 3) \
    <(h5_values "$field" /VTKHDF/PointData/displacement %.17g 3) \
    <(h5_values "$state" /displacement %.17g 2) \
    <(h5_values "$state" /velocity %.17g 2) |
    awk -v axis="$axis" -v s="$spacing" '
      function negative(v) { return v ~ /^-/ ? substr(v, 2) : (v == "0" ? v : "-" v) }
      function site(v) { return sprintf("%.0f", 1000 * v / s) }
      { x = site($1 - $4); y = site($2 - $5 - axis); state[x " " y] = $7 " " $8 " " $9 " " $10
        image[x " " (-y)] = $7 " " negative($8) " " $9 " " negative($10) }
      END {
        for (k in state) { n++; if (image[k] != state[k]) differ++ }
        if (n < 1) { print "no particles"; exit 1 }
        if (differ) print "unsymmetric", differ, "of", n; else print "symmetric", n
        exit differ > 0
      }'
}
# unsymmetric RUN AXIS SPACING: how many particles are not the mirror image of another
unsymmetric() { (symmetric "$@" || true) | awk '{ print $1 == "symmetric" ? 0 : $1 == "unsymmetric" ? $2 : "" }'; }
"$@"
