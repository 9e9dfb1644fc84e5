#!/usr/bin/env bash
# Prints the opening of the notch's mouth (m) at the end of the run in the current folder: the displacement of the
# particle nearest to the corner above it, minus that of the one below. Needs h5dump (Debian: hdf5-tools).
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "$0")/../common.sh"
field=$(ls fields/solid_*.hdf | tail -n 1)
paste -d ' ' <(h5_values "$field" /VTKHDF/Points %.9g 3) <(h5_values "$field" /VTKHDF/PointData/displacement %.9g 3) |
  awk -v axis=0.02 '
  { x = $1 - $4; y = $2 - $5 - axis; up = y > 0; r = x * x + y * y }
  y * y < 1e-16 { next }
  !(up in least) || r < least[up] { least[up] = r; u[up] = $5 }
  END { printf "%.9g\n", u[1] - u[0] }'
