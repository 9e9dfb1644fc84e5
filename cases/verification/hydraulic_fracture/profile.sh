#!/usr/bin/env bash
# Prints, in a run folder of viscosity.yaml with fields, one number of the pressure along the crack, and writes
# profile.csv: the pressure at the well and half-way to the tips at the time of each file of fields, beside the
# similarity solution of the viscosity regime (physics/hydraulic_fracture.h). Needs h5dump, and growth.csv of growth.sh.
# usage: profile.sh well|half    mean of the ratio to the reference after growth by a quarter of the notch's half length
#        profile.sh fall         mean of p half-way over p at the well
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "$0")/../../common.sh"
along() { # STEP T L: pressure at the well and at L/2 on both sides, from the layers next to the crack
  local file
  file=$(printf 'fields/solid_%08d.hdf' "$1")
  paste -d ' ' <(h5_values "$file" VTKHDF/Points %.9g 3) <(h5_values "$file" VTKHDF/PointData/crack_pressure %.9g 1) |
    awk -v t="$2" -v l="$3" '
    function near(x,  i, low, high) { # between the columns of particles on both sides
      for (i in sum) {
        if (i * 1e-3 / 2 <= x && (low == "" || i + 0 > low)) low = i + 0
        if (i * 1e-3 / 2 > x && (high == "" || i + 0 < high)) high = i + 0
      }
      return sum[low] / n[low] + (sum[high] / n[high] - sum[low] / n[low]) * (x / 5e-4 - low) / (high - low)
    }
    { x = $1 - 0.12; y = $2 - 0.12 }
    y > -1e-3 && y < 1e-3 { i = (x < 0 ? -1 : 1) * int((x < 0 ? -x : x) / 5e-4 + 0.5); sum[i] += $4; n[i]++ }
    END { printf "%s,%s,%.6g,%.6g\n", t, l, near(0), (near(l / 2) + near(-l / 2)) / 2 }'
}
{
  echo "t,length,pressure,pressure_half"
  echo "#s,m,Pa,Pa"
  awk -F, '
    FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i }
    FNR <= 2 { next }
    file == 1 { t = sprintf("%.6g", $k["t"]); length_at[t] = $k["length"]; time[t] = $k["injected"] / 2.07e-3; next }
    { t = sprintf("%.6g", $k["t"]); if (t in time) print $k["step"], time[t], length_at[t] }' growth.csv series.csv |
    while read -r step t l; do
      [ ! -f "$(printf 'fields/solid_%08d.hdf' "$step")" ] || along "$step" "$t" "$l"
    done
} >profile.csv
awk -F, -v what="$1" '
  FNR <= 2 || $2 < 1.25 * 0.01 { next }
  { p = exp(log(12 * 1.55e-3 * (2e10 / (1 - 1 / 16))^2 / $1) / 3)
    n++; well += $3 / (0.54482 * p); half += $4 / (0.42706 * p); fall += $4 / $3 }
  END { if (!n) exit 1; print (what == "well" ? well : what == "half" ? half : fall) / n }' profile.csv
