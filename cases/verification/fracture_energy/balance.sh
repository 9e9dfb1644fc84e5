#!/usr/bin/env bash
# Prints, in a run folder, an energy over the crack's way and G0 (1e-4) while the tip moves from x = 90 to 165: the
# decrease of kinetic and strain energy (balance), the energy released by bonds (bonds), bonds minus balance (gap), or
# the tip's speed (speed).
set -euo pipefail
awk -F, -v what="$1" '
  FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; file++ }
  FNR < 3 { next }
  file == 1 {
    held[$1] = $at["e_kinetic_solid"] + $at["e_strain"] - $at["e_constraint"] - $at["work_load"] + $at["e_damped"] }
  file == 2 && $at["tip_x"] > 90 && !first { first = $1; x0 = $at["tip_x"]; e0 = $at["e_fracture"]; t0 = $at["t"] }
  file == 2 && $at["tip_x"] > 165 && !last { last = $1; x1 = $at["tip_x"]; e1 = $at["e_fracture"]; t1 = $at["t"] }
  END {
    if (!last) exit 1
    if (what == "balance") print (held[first] - held[last]) / (x1 - x0) / 1e-4
    if (what == "bonds") print (e1 - e0) / (x1 - x0) / 1e-4
    if (what == "gap") print (e1 - e0 - held[first] + held[last]) / (x1 - x0) / 1e-4
    if (what == "speed") print (x1 - x0) / (t1 - t0)
  }' series.csv crack.csv
