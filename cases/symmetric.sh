#!/usr/bin/env bash
# Checks whether the state at a run's end is its own mirror image about y = AXIS, to the last bit.
# The initial positions X0 are the last field's positions minus its displacements, rounded to SPACING/1000. The
# displacements and velocities that are compared are the checkpoint's doubles, printed with 17 digits.
# usage: cases/symmetric.sh RUN AXIS SPACING      needs h5dump (Debian: hdf5-tools)
# Prints "symmetric N" or "unsymmetric K of N". Exits with 1 if the state is not symmetric.
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
run=$1 axis=$2 spacing=$3
field=$(ls "$run"/fields/solid_*.hdf | tail -n 1) state=$(ls "$run"/checkpoint/stage_*.h5 | tail -n 1)
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
