#!/usr/bin/env bash
# Prints, in a run folder, the standing wave's frequency over that of the lattice. Samples of one mode obey d(n+1) =
# a d(n) + b d(n-1) with a = 2 r cos(omega dt), b = -r^2. a and b are fitted by least squares.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
read -r width m shear < <(awk '/width:/ { w = $2 } /horizon_ratio:/ { m = $2 }
  /^  initial:/ { in_initial = 1 }
  in_initial && /displacement:/ { sub(/.*\[/, ""); sub(/,.*/, ""); shear = $0 + 0 == 0; in_initial = 0 }
  END { print w, m, shear }' scene.resolved.yaml)
lattice=$(awk -v m="$m" -v k="$(awk "BEGIN { printf \"%.17g\", 2 / $width }")" -f "$here/../lattice.awk" |
  awk -v name="$([ "$shear" = 1 ] && echo omega_t || echo omega_l)" '$1 == name { print $2 }')
awk -F, -v shear="$shear" -v lattice="$lattice" '
  NR == 1 { for (i = 1; i <= NF; i++) if ($i == (shear == 1 ? "displacement_y" : "displacement_x")) at = i }
  NR > 2 { d[++n] = $at * 1e8; t[n] = $2 }
  END {
    for (i = 2; i < n; i++) {
      xx += d[i] * d[i]; xy += d[i] * d[i - 1]; yy += d[i - 1] * d[i - 1]
      xz += d[i] * d[i + 1]; yz += d[i - 1] * d[i + 1]
    }
    det = xx * yy - xy * xy; a = (xz * yy - yz * xy) / det; b = (yz * xx - xz * xy) / det
    c = a / (2 * sqrt(-b))
    printf "%.12g\n", atan2(sqrt(1 - c * c), c) / (t[2] - t[1]) / lattice
  }' probes.csv
