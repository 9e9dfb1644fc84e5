#!/usr/bin/env bash
# Prints, in a run folder of the bar, the largest mean of both grips' forces over the bar's section (48) and the given
# strength (1e-3); `opening`: how far the grips have moved apart by then, m.
set -euo pipefail
awk -F, -v what="$1" '
  FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  FNR < 3 { next }
  $at["index"] == 0 { force = -$at["force_x"]; way = -$at["displacement_x"] }
  $at["index"] == 1 {
    force += $at["force_x"]; way += $at["displacement_x"]
    if (force > most) { most = force; opening = way } }
  END { print what == "opening" ? opening : most / 2 / 48 / 1e-3 }' reactions.csv
