#!/usr/bin/env bash
# Prints p over p_u against the depth beside Terzaghi's series, in the field files of five times of a run of the column.
# usage: profile.sh RUN
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "$0")/../../common.sh"
printf 'depth,T,pressure,pressure_reference\n#1,1,1,1\n'
for n in 4 5 7 13 23; do
  file=$(printf '%s/fields/solid_%08d.hdf' "$1" $((261 * n)))
  paste -d ' ' <(h5_values "$file" /VTKHDF/Points %.9g 3) \
    <(h5_values "$file" /VTKHDF/PointData/crack_pressure %.9g 1) |
    awk -v t="$(calc "261 * $n * 4e-7 - 3.05e-4")" '
      BEGIN { pi = atan2(0, -1); T = t / (1.024e-6 / (1.2 * 1.0220027 * 2e10) / 2e-14) }
      $1 > 4e-3 && $1 < 5e-3 && $2 > 2.4e-3 && $2 < 35e-3 {
        z = ($2 - 2.5e-3) / 0.032; sum = 0
        for (m = 0; m < 100; m++) { M = pi / 2 * (2 * m + 1); sum += 2 / M * sin(M * z) * exp(-M * M * T) }
        printf "%.4g,%.4g,%.6g,%.6g\n", z, T, $4 / 3e6, sum }' | sort -g
  echo # the next line of the picture
done
