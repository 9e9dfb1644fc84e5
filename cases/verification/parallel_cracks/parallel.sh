#!/usr/bin/env bash
# Prints, in a run folder of scene.yaml, one number of two parallel cracks under one pressure, from the last sample.
# usage: parallel.sh first|second    opening in the middle of the first and of the second crack over Sneddon's, 4 p a/E'
#        parallel.sh volume          of both over Sneddon's, the sum of 2 pi p a^2/E'
#        parallel.sh broken          bonds that broke
set -euo pipefail
read -r first second < <(awk '
  { gsub(/[][,]/, " ") }
  $1 == "cracks:" { cracks = 1 }
  cracks && $1 == "-" && $2 ~ /^[0-9]/ && n < 4 { x[++n] = $2 }
  END { print (x[2] - x[1]) / 2, (x[4] - x[3]) / 2 }' scene.resolved.yaml)
awk -F, -v what="$1" -v a="$first" -v b="$second" '
  FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i }
  FNR <= 2 { next }
  file == 1 { u[$k["probe"]] = $k["displacement_y"]; next }
  { if (FNR == 3) broken = $k["bonds_broken"] }
  END {
    E1 = 2e10 / (1 - 1 / 16); p = $k["injection_pressure"]; volume = $k["crack_volume"] / 1e-3
    if (what == "first") print (u[0] - u[1]) / (4 * p * a / E1)
    else if (what == "second") print (u[2] - u[3]) / (4 * p * b / E1)
    else if (what == "volume") print volume / (2 * atan2(0, -1) * p * (a^2 + b^2) / E1)
    else print $k["bonds_broken"] - broken
  }' probes.csv series.csv
